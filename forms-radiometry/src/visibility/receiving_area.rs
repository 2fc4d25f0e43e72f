//! Receiving areas: the parts of surfaces over which receivers integrate light.

use super::Face;

/// Area over which a receiver integrates: a side of a surface, or one face of that side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct ReceivingArea {
    /// The index of the surface.
    pub(crate) surface: usize,
    pub(crate) is_back: bool,
    /// The index of the face in its mesh; `None` for all of the side.
    pub(crate) face: Option<usize>,
}

impl ReceivingArea {
    /// Returns the front of a surface.
    pub(crate) fn front(surface: usize) -> Self {
        Self { surface, is_back: false, face: None }
    }

    /// Whether a face is part of the area.
    pub(crate) fn contains(self, face: &Face) -> bool {
        (face.surface, face.is_back) == (self.surface, self.is_back)
            && self.face.is_none_or(|index| index == face.part)
    }
}
