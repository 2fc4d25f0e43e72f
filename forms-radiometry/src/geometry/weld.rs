//! Welding: vertices that coincide within a tolerance get the same number.

use super::Vector;
use rustc_hash::FxHashMap;

/// Numbered vertices; vertices within the resolution of the scene have the same number.
pub(crate) struct Welded {
    /// The vertices, each at the position of its first occurrence.
    pub(crate) vertices: Vec<Vector>,
    resolution: f64,
    /// The last vertex in each cell of a grid.
    cells: FxHashMap<[i64; 3], u32>,
    /// For each vertex, the one before it in its cell, or itself if it is the first.
    before: Vec<u32>,
}

impl Welded {
    /// Creates an empty list of vertices.
    pub(crate) fn new(resolution: f64) -> Self {
        Self { vertices: Vec::new(), resolution, cells: FxHashMap::default(), before: Vec::new() }
    }

    /// Returns the number of a vertex. A known vertex within the resolution lies in one of the grid
    /// cells that the box with this half width around the point intersects.
    pub(crate) fn number(&mut self, point: Vector) -> u32 {
        let cell = |x: f64| (x / (4.0 * self.resolution)).floor() as i64;
        let around = |x: f64| cell(x - self.resolution)..=cell(x + self.resolution);
        for x in around(point.x) {
            for y in around(point.y) {
                for z in around(point.z) {
                    let is_same = |other: &u32| self.distance(*other, point) <= self.resolution;
                    if let Some(number) = self.within([x, y, z]).find(is_same) {
                        return number;
                    }
                }
            }
        }
        let number = self.vertices.len() as u32;
        self.vertices.push(point);
        let last = self.cells.insert([point.x, point.y, point.z].map(cell), number);
        self.before.push(last.unwrap_or(number));
        number
    }

    /// Returns the vertices in a cell.
    fn within(&self, cell: [i64; 3]) -> impl Iterator<Item = u32> {
        let before = |&number: &u32| Some(self.before[number as usize]).filter(|&before| before != number);
        std::iter::successors(self.cells.get(&cell).copied(), before)
    }

    fn distance(&self, number: u32, point: Vector) -> f64 {
        (self.vertices[number as usize] - point).length()
    }
}
