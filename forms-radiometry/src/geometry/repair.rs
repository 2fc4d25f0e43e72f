//! Repair: the corners of a face in a mesh file become simple planar polygons, or none.
//!
//! ```text
//! corners ─ equal neighbours are one corner ─┬─ fewer than three, or on one line ─▶ dropped
//!                                            ├─ planar ─▶ one polygon
//!                                            └─ not planar ─▶ triangles
//! ```
//! Programs that write meshes leave such faces behind, and programs that read them agree on their
//! meaning. A face whose edges cross has no such meaning and is an error.

use super::polygon::{PLANARITY, crossing_edges, near_one};
use super::triangulation::triangulate;
use super::{Polygon, PolygonError, Vector};

/// The polygons of a face in a file. Corners are counted from zero.
#[derive(Debug, PartialEq)]
pub(crate) enum Repaired {
    /// The polygon with all corners.
    Whole,
    /// The polygon with these corners; each of the others repeats the one before.
    Shorter(Vec<usize>),
    /// Triangles, since the corners are not in one plane.
    Triangles(Vec<[usize; 3]>),
    /// Nothing: the face has no area.
    Nothing,
}

/// Returns the polygons of a face with these corners, or the reason why it has none.
pub(crate) fn repaired(corners: &[Vector]) -> Result<Repaired, PolygonError> {
    match Polygon::new(corners.to_vec()) {
        Ok(_) => Ok(Repaired::Whole),
        Err(PolygonError::RepeatedVertex(_)) => without_repetitions(corners),
        Err(PolygonError::TooFewVertices(_)) => Ok(Repaired::Nothing),
        Err(PolygonError::NoArea) if are_on_a_line(corners) => Ok(Repaired::Nothing),
        Err(PolygonError::NotPlanar { .. }) => triangles(corners).map(Repaired::Triangles),
        Err(error) => Err(error),
    }
}

fn without_repetitions(corners: &[Vector]) -> Result<Repaired, PolygonError> {
    let count = corners.len();
    let is_new = |&i: &usize| corners[i] != corners[(i + count - 1) % count];
    let kept: Vec<usize> = (0..count).filter(is_new).collect();
    let outline: Vec<Vector> = kept.iter().map(|&i| corners[i]).collect();
    Ok(match repaired(&outline)? {
        Repaired::Whole => Repaired::Shorter(kept),
        Repaired::Triangles(triangles) => {
            Repaired::Triangles(triangles.into_iter().map(|corners| corners.map(|i| kept[i])).collect())
        }
        nothing => nothing,
    })
}

/// Whether the corners are within rounding of the line through the first and the farthest of them.
fn are_on_a_line(corners: &[Vector]) -> bool {
    let near = near_one(corners);
    let to = |v: &Vector| *v - near[0];
    let farthest = near.iter().map(to).max_by(|a, b| a.length().total_cmp(&b.length()));
    let Some(along) = farthest.and_then(Vector::unit) else { return true };
    let extent = farthest.map_or(0.0, Vector::length);
    near.iter().all(|v| to(v).cross(along).length() <= PLANARITY * extent)
}

/// Triangulates corners that are not in one plane, as seen along Newell's normal. A face whose
/// outline looks convex is divided from its first corner, as other programs divide it.
fn triangles(corners: &[Vector]) -> Result<Vec<[usize; 3]>, PolygonError> {
    let near = near_one(corners);
    let from_first = |i: usize| near[i] - near[0];
    let normal = (1..near.len() - 1)
        .fold(Vector::default(), |sum, i| sum + from_first(i).cross(from_first(i + 1)))
        .unit()
        .ok_or(PolygonError::NoArea)?;
    if let Some((i, j)) = crossing_edges(&near, normal) {
        return Err(PolygonError::Crossing(i + 1, j + 1));
    }
    // the first ear is then that of the second corner
    let count = near.len();
    let turned: Vec<Vector> = (1..=count).map(|i| near[i % count]).collect();
    let back = |triangle: [usize; 3]| triangle.map(|i| (i + 1) % count);
    let has_area = |triangle: &[usize; 3]| Polygon::new(triangle.map(|i| corners[i]).to_vec()).is_ok();
    Ok(triangulate(&turned, normal).into_iter().map(back).filter(has_area).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(points: &[[f64; 3]]) -> Vec<Vector> {
        points.iter().map(|&[x, y, z]| Vector::new(x, y, z)).collect()
    }

    #[test]
    fn a_face_stands_for_polygons_or_nothing() {
        const A: [f64; 3] = [0.0, 0.0, 0.0];
        const B: [f64; 3] = [1.0, 0.0, 0.0];
        const C: [f64; 3] = [1.0, 1.0, 0.0];
        const D: [f64; 3] = [0.0, 1.0, 0.0];
        const HIGH: [f64; 3] = [0.0, 1.0, 0.5];
        const MIDDLE: [f64; 3] = [0.5, 0.0, 0.0];
        let cases: &[(&str, &[[f64; 3]], Repaired)] = &[
            ("a square", &[A, B, C, D], Repaired::Whole),
            ("a corner within an edge", &[A, MIDDLE, B, C], Repaired::Whole),
            ("a corner twice", &[A, B, B, C], Repaired::Shorter(vec![0, 1, 3])),
            ("the first corner at the end", &[A, B, C, A], Repaired::Shorter(vec![1, 2, 3])),
            ("two corners", &[A, B], Repaired::Nothing),
            ("two different corners", &[A, B, B, A], Repaired::Nothing),
            ("one point", &[A, A, A], Repaired::Nothing),
            ("a line", &[A, MIDDLE, B], Repaired::Nothing),
            ("a line there and back", &[A, MIDDLE, B, MIDDLE], Repaired::Nothing),
            ("a bent square", &[A, B, C, HIGH], Repaired::Triangles(vec![[0, 1, 2], [0, 2, 3]])),
            ("and a corner twice", &[A, A, B, C, HIGH], Repaired::Triangles(vec![[0, 2, 3], [0, 3, 4]])),
        ];
        for (name, corners, expected) in cases {
            assert_eq!(repaired(&points(corners)).as_ref(), Ok(expected), "{name}");
        }
        let bow_tie = points(&[A, C, B, D]);
        assert_eq!(repaired(&bow_tie), Err(PolygonError::NoArea));
        let uneven = points(&[A, [2.0, 2.0, 0.0], [2.0, 0.0, 0.0], HIGH]);
        assert_eq!(repaired(&uneven), Err(PolygonError::Crossing(1, 3)));
    }

    #[test]
    fn triangles_are_polygons_at_the_smallest_lengths_too() {
        const BENT: [[f64; 3]; 5] =
            [[0.0, 0.0, 0.0], [1.5, 0.0, 0.0], [1.5, 0.3, 0.0], [0.9, 0.3, 0.2], [0.0, 0.3, 0.0]];
        for (scale, expected) in [(1.0, 3), (1e-152, 2)] {
            let corners = points(&BENT.map(|corner| corner.map(|x| scale * x)));
            let Ok(Repaired::Triangles(triangles)) = repaired(&corners) else { panic!("triangles") };
            let polygon = |triangle: &[usize; 3]| Polygon::new(triangle.map(|i| corners[i]).to_vec());
            assert!(triangles.iter().all(|triangle| polygon(triangle).is_ok()));
            assert_eq!(triangles.len(), expected, "{scale}");
        }
    }
}
