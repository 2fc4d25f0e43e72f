//! Cone sides: the planes through an apex and each edge of a polygon.

use super::Vector;

/// Returns the inward normals of the planes through the apex and each edge of a polygon whose
/// vertices are relative to the apex.
pub(crate) fn sides(
    polygon: impl DoubleEndedIterator<Item = Vector> + Clone,
    seen_from_front: bool,
) -> impl Iterator<Item = Vector> {
    let mut last = polygon.clone().next_back();
    polygon.filter_map(move |b| {
        let a = last.replace(b)?;
        Some(if seen_from_front { b.cross(a) } else { a.cross(b) })
    })
}
