//! Lists of faces: the vertex indices of all faces in one list.

/// The faces of a mesh, each a list of vertex indices.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct FaceList {
    /// The vertices of all faces, one face after the other.
    corners: Vec<u32>,
    /// The end of each face in the list of corners.
    ends: Vec<u32>,
}

impl FaceList {
    /// Appends a face.
    pub(crate) fn push(&mut self, face: impl IntoIterator<Item = u32>) {
        self.corners.extend(face);
        self.ends.push(self.corners.len() as u32);
    }

    /// Returns the number of faces.
    pub(crate) fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there are no faces.
    pub(crate) fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Returns the vertex indices of a face.
    pub(crate) fn get(&self, face: usize) -> &[u32] {
        let start = if face == 0 { 0 } else { self.ends[face - 1] };
        &self.corners[start as usize..self.ends[face] as usize]
    }

    /// Returns the vertex indices of each face.
    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        (0..self.len()).map(|face| self.get(face))
    }
}
