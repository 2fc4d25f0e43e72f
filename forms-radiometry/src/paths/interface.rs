//! Interfaces: the surface of a wall, and the media on its sides.

use crate::scene::Filling;

/// Interface that a wall belongs to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interface {
    pub(super) surface: usize,
    /// The index of the face of a mesh that the wall belongs to, where receivers measure these faces.
    pub(super) part: usize,
    /// The media at its front and at its back.
    pub(super) fillings: [Filling; 2],
}

impl Interface {
    /// Returns the medium at one of its sides.
    pub(super) fn filling(&self, is_front: bool) -> Filling {
        self.fillings[usize::from(!is_front)]
    }
}
