//! Bounding rectangle of an outline in its plane, along its first edge, and the cells that divide it.

use super::Vector;

/// Bounding rectangle of an outline in its plane. Its first axis is the first edge of the outline.
pub(crate) struct BoundingRectangle {
    corner: Vector,
    axes: [Vector; 2],
    /// The least and the largest coordinate along each axis, from the corner.
    ranges: [[f64; 2]; 2],
}

impl BoundingRectangle {
    /// Returns the rectangle around an outline with this unit normal.
    pub(crate) fn of(outline: &[Vector], normal: Vector) -> Option<Self> {
        let corner = *outline.first()?;
        let along = (*outline.get(1)? - corner).unit()?;
        let axes = [along, normal.cross(along)];
        let range = |axis: Vector| {
            let places = outline.iter().map(|&v| axis.dot(v - corner));
            places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], place| {
                [low.min(place), high.max(place)]
            })
        };
        Some(Self { corner, axes, ranges: axes.map(range) })
    }

    /// Returns the points on the lowest edge at these numbers of columns, of `count`.
    pub(crate) fn on_lowest_edge(&self, columns: impl Iterator<Item = f64>, count: usize) -> Vec<Vector> {
        columns.map(|column| self.corner + self.place(0, column, count) * self.axes[0]).collect()
    }

    /// Returns the offsets from that edge at these numbers of rows, of `count`.
    pub(crate) fn offsets(&self, rows: impl Iterator<Item = f64>, count: usize) -> Vec<Vector> {
        rows.map(|row| self.place(1, row, count) * self.axes[1]).collect()
    }

    fn place(&self, axis: usize, number: f64, count: usize) -> f64 {
        let [low, high] = self.ranges[axis];
        low + (high - low) * number / count as f64
    }
}
