//! Boundaries: computes the edges at which a polygon ends from its outline and the outlines of its
//! holes.
//!
//! ```text
//! outline, holes backwards ─ split at each other's vertices ─ opposite segments cancel ─▶ edges
//! ```
//! Where a hole reaches the outline, or two holes share an edge, the polygon does not end.

use super::edges::vertices_on;
use crate::geometry::{Vector, edges};
use std::collections::HashMap;

/// Returns the directed edges of an outline with holes. Outline and holes are vertex numbers,
/// counter-clockwise.
pub(super) fn boundary(outline: &[usize], holes: &[Vec<usize>], vertices: &[Vector]) -> Vec<[usize; 2]> {
    let outer = || edges(outline);
    if holes.is_empty() {
        return outer().collect();
    }
    let backwards = holes.iter().flat_map(|hole| edges(hole)).map(|[a, b]| [b, a]);
    let mut corners: Vec<usize> = outline.iter().chain(holes.iter().flatten()).copied().collect();
    corners.sort_by(|&i, &j| vertices[i].x.total_cmp(&vertices[j].x));
    corners.dedup();
    let stretches: Vec<[usize; 2]> = outer()
        .chain(backwards)
        .flat_map(|[a, b]| {
            let between = vertices_on((a, b), vertices, &corners);
            let stops: Vec<usize> = [a].into_iter().chain(between).chain([b]).collect();
            stops.windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>()
        })
        .collect();
    let mut counts: HashMap<[usize; 2], i32> = HashMap::new();
    for &[a, b] in &stretches {
        *counts.entry([a, b]).or_default() += 1;
        *counts.entry([b, a]).or_default() -= 1;
    }
    stretches.into_iter().filter(|stretch| counts[stretch] > 0).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wall_ends_at_its_outline_and_at_its_holes_but_not_where_both_meet() {
        let vertices: Vec<Vector> = [
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 3.0],
            [0.0, 3.0],
            [1.0, 0.0],
            [2.0, 0.0],
            [2.0, 2.0],
            [1.0, 2.0],
            [3.0, 0.0],
            [3.0, 2.0],
        ]
        .map(|[x, y]| Vector::new(x, y, 0.0))
        .to_vec();
        let wall = [0, 1, 2, 3];
        let (door, next) = (vec![4, 5, 6, 7], vec![5, 8, 9, 6]);
        let cases = [
            ("no holes", vec![], vec![[0, 1], [1, 2], [2, 3], [3, 0]]),
            (
                "a door",
                vec![door.clone()],
                vec![[0, 4], [5, 1], [1, 2], [2, 3], [3, 0], [6, 5], [7, 6], [4, 7]],
            ),
            (
                "two doors side by side",
                vec![door, next],
                vec![[0, 4], [8, 1], [1, 2], [2, 3], [3, 0], [7, 6], [4, 7], [9, 8], [6, 9]],
            ),
        ];
        for (name, holes, mut expected) in cases {
            let mut found = boundary(&wall, &holes, &vertices);
            found.sort_unstable();
            expected.sort_unstable();
            assert_eq!(found, expected, "{name}");
        }
    }
}
