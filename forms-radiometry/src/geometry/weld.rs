//! Welding: vertices that coincide within a tolerance get the same number.

use super::Vector;
use rustc_hash::FxHashMap;

/// Numbered vertices; vertices within the resolution of the scene have the same number.
pub(crate) struct Welded {
    /// The vertices, each at the position of its first occurrence.
    pub(crate) vertices: Vec<Vector>,
    resolution: f64,
    cells: FxHashMap<[i64; 3], Vec<usize>>,
}

impl Welded {
    /// Creates an empty list of vertices.
    pub(crate) fn new(resolution: f64) -> Self {
        Self { vertices: Vec::new(), resolution, cells: FxHashMap::default() }
    }

    /// Returns the number of a vertex. A known vertex within the resolution lies in one of the grid
    /// cells that the box with this half width around the point intersects.
    pub(crate) fn number(&mut self, point: Vector) -> usize {
        let cell = |x: f64| (x / (4.0 * self.resolution)).floor() as i64;
        let around = |x: f64| cell(x - self.resolution)..=cell(x + self.resolution);
        for x in around(point.x) {
            for y in around(point.y) {
                for z in around(point.z) {
                    let mut near = self.cells.get(&[x, y, z]).into_iter().flatten();
                    let is_same =
                        |other: &&usize| (self.vertices[**other] - point).length() <= self.resolution;
                    if let Some(&number) = near.find(is_same) {
                        return number;
                    }
                }
            }
        }
        let number = self.vertices.len();
        self.vertices.push(point);
        self.cells.entry([point.x, point.y, point.z].map(cell)).or_default().push(number);
        number
    }
}
