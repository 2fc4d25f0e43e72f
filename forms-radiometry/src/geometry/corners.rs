//! Corners: values at the corners of the faces of a mesh, such as normals or texture coordinates.

use super::FaceList;

/// A list of values, and for each face the indices of the values at its corners. A face without
/// indices has no values.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Corners<T> {
    pub(crate) values: Vec<T>,
    pub(crate) indices: FaceList,
}

impl<T> Default for Corners<T> {
    fn default() -> Self {
        Self { values: Vec::new(), indices: FaceList::default() }
    }
}

impl<T: Copy> Corners<T> {
    /// Returns the indices at the corners of a face; none if it has no values.
    pub(crate) fn indices_of(&self, face: usize) -> &[u32] {
        if face < self.indices.len() { self.indices.get(face) } else { &[] }
    }

    /// Returns the values at the corners of a face; `None` if one of them is missing.
    pub(crate) fn of(&self, face: usize) -> Option<Vec<T>> {
        let value = |&index: &u32| self.values.get(index as usize).copied();
        let values: Vec<T> = self.indices_of(face).iter().map(value).collect::<Option<_>>()?;
        (!values.is_empty()).then_some(values)
    }

    /// Adds the indices at the corners of the face with this number. Faces before it that were not
    /// added have no values.
    pub(crate) fn push(&mut self, face: usize, indices: impl IntoIterator<Item = u32>) {
        while self.indices.len() < face {
            self.indices.push([]);
        }
        self.indices.push(indices);
    }
}
