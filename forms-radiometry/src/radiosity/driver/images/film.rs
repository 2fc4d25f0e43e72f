//! Film: pieces that a pinhole sees become polygons on the film, block by block.
//!
//! ```text
//! vectors to the corners of a piece ─ clipped by the view frustum ─▶ film points
//!                                   ─ clipped by blocks of pixels ─▶ polygons
//! ```
//! A pinhole maps lines to lines, so convex pieces stay convex.

use crate::camera::Camera;
use crate::geometry::clip::split_along;
use crate::geometry::{Vector, split};
use crate::radiosity::SeenPiece;

/// Number of pixels along each side of a block.
const BLOCK: usize = 8;
/// Parts of the film below this area, in pixels, are only rounding.
const NOTHING: f64 = 1e-12;

/// Convex part of the film, in pixels; the third coordinate is 0.
pub(super) type Polygon = Vec<Vector>;

/// Rectangle of pixels, and the pieces that are seen in it.
pub(super) struct Block {
    /// First column and row, and the ones after the last.
    pub(super) from: [usize; 2],
    pub(super) to: [usize; 2],
    /// Numbers of the pieces, and the polygons in which they are seen.
    pub(super) seen: Vec<(usize, Polygon)>,
}

/// Returns the blocks of a film with the pieces that are seen in them.
pub(super) fn blocks(camera: &Camera, pieces: &[SeenPiece]) -> Vec<Block> {
    let [columns, rows] = camera.resolution;
    let count = columns.div_ceil(BLOCK);
    let mut blocks: Vec<Block> = Vec::with_capacity(count * rows.div_ceil(BLOCK));
    for row in (0..rows).step_by(BLOCK) {
        for column in (0..columns).step_by(BLOCK) {
            let to = [(column + BLOCK).min(columns), (row + BLOCK).min(rows)];
            blocks.push(Block { from: [column, row], to, seen: Vec::new() });
        }
    }
    for (index, piece) in pieces.iter().enumerate() {
        let polygon = projected(camera, &piece.outline);
        for (row, strip) in strips(&polygon, Axis::Row, BLOCK, rows) {
            for (column, part) in strips(&strip, Axis::Column, BLOCK, columns) {
                blocks[row * count + column].seen.push((index, part));
            }
        }
    }
    blocks
}

impl Block {
    /// Returns the parts of a polygon in each pixel; pixels are counted row by row over the block.
    pub(super) fn pixels(&self, polygon: &Polygon) -> Vec<(usize, Polygon)> {
        let width = self.to[0] - self.from[0];
        let mut parts = Vec::new();
        for (row, strip) in strips(polygon, Axis::Row, 1, self.to[1]) {
            for (column, part) in strips(&strip, Axis::Column, 1, self.to[0]) {
                parts.push(((row - self.from[1]) * width + (column - self.from[0]), part));
            }
        }
        parts
    }
}

/// Returns the polygon of the film in which a piece is seen.
pub(super) fn projected(camera: &Camera, outline: &[Vector]) -> Polygon {
    let (_, polygon) =
        split_along(outline, camera.sides().map(|side| (move |way: Vector| side.dot(way), 0.0)));
    let [width, height] = camera.resolution.map(|side| side as f64);
    let point = |way: &Vector| {
        let [x, y] = camera.film(*way);
        Vector::new(x.clamp(0.0, width), y.clamp(0.0, height), 0.0)
    };
    polygon.iter().map(point).collect()
}

/// Coordinate of the film.
#[derive(Clone, Copy)]
enum Axis {
    Column,
    Row,
}

impl Axis {
    fn of(self, point: Vector) -> f64 {
        match self {
            Self::Column => point.x,
            Self::Row => point.y,
        }
    }
}

/// Returns the parts of a polygon in strips of this width, along an axis that ends at this pixel,
/// with the number of each strip.
fn strips(polygon: &Polygon, axis: Axis, width: usize, end: usize) -> Vec<(usize, Polygon)> {
    let (low, high) = polygon.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &point| {
        (low.min(axis.of(point)), high.max(axis.of(point)))
    });
    if low >= high {
        return Vec::new();
    }
    let last = (end - 1) / width;
    let strip = |place: f64| ((place / width as f64) as usize).min(last);
    let mut rest = polygon.clone();
    let mut parts = Vec::new();
    for number in strip(low)..=strip(high) {
        let border = ((number + 1) * width) as f64;
        if number == last || high <= border {
            parts.push((number, std::mem::take(&mut rest)));
            break;
        }
        let (mut before, mut after) = (Vec::new(), Vec::new());
        split(&rest, |point| border - axis.of(point), &mut before, &mut after);
        rest = after;
        parts.push((number, before));
        if rest.is_empty() {
            break;
        }
    }
    parts.retain(|(_, part)| area(part) > NOTHING);
    parts
}

/// Adds the part of each pixel that the image of a convex outline covers. The outline is given by
/// the vectors from the pinhole to its corners.
pub(crate) fn add_parts(camera: &Camera, outline: &[Vector], parts: &mut [f64]) {
    let [columns, rows] = camera.resolution;
    for (row, strip) in strips(&projected(camera, outline), Axis::Row, 1, rows) {
        for (column, part) in strips(&strip, Axis::Column, 1, columns) {
            parts[row * columns + column] += area(&part);
        }
    }
}

/// Returns the area of a convex polygon of the film.
pub(super) fn area(polygon: &[Vector]) -> f64 {
    triangles(polygon).map(area_of_triangle).sum()
}

/// Returns the triangles of the fan of a convex polygon.
pub(super) fn triangles(polygon: &[Vector]) -> impl Iterator<Item = [Vector; 3]> {
    let pairs = polygon.get(1..).unwrap_or_default().windows(2);
    pairs.map(|pair| [polygon[0], pair[0], pair[1]])
}

/// Returns the area of a triangle of the film.
pub(super) fn area_of_triangle([a, b, c]: [Vector; 3]) -> f64 {
    0.5 * (b - a).cross(c - a).z.abs()
}

/// Returns the centroid of a convex polygon.
pub(super) fn middle(polygon: &[Vector]) -> Vector {
    let mut sum = Vector::default();
    let mut whole = 0.0;
    for triangle @ [a, b, c] in triangles(polygon) {
        let area = area_of_triangle(triangle);
        sum = sum + (area / 3.0) * (a + b + c);
        whole += area;
    }
    (1.0 / whole) * sum
}

/// Returns the parts of a polygon on both sides of the middle of each coordinate.
pub(super) fn quarters(polygon: &Polygon) -> Vec<Polygon> {
    let halves = |polygon: &Polygon, axis: Axis| {
        let (low, high) = polygon.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &point| {
            (low.min(axis.of(point)), high.max(axis.of(point)))
        });
        let (mut before, mut after) = (Vec::new(), Vec::new());
        split(polygon, |point| 0.5 * (low + high) - axis.of(point), &mut before, &mut after);
        [before, after]
    };
    let strips = halves(polygon, Axis::Row).into_iter();
    strips
        .filter(|strip| strip.len() > 2)
        .flat_map(|strip| halves(&strip, Axis::Column))
        .filter(|part| part.len() > 2)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(corners: &[[f64; 2]]) -> Polygon {
        corners.iter().map(|&[x, y]| Vector::new(x, y, 0.0)).collect()
    }

    #[test]
    fn parts_have_the_area_of_the_whole_and_lie_in_their_pixels() {
        let whole = polygon(&[[0.3, 0.2], [20.5, 3.7], [17.0, 15.9], [2.0, 12.0]]);
        let mut sum = 0.0;
        for (row, strip) in strips(&whole, Axis::Row, BLOCK, 16) {
            for (column, part) in strips(&strip, Axis::Column, BLOCK, 21) {
                let from = [column * BLOCK, row * BLOCK];
                let to = [(from[0] + BLOCK).min(21), (from[1] + BLOCK).min(16)];
                let block = Block { from, to, seen: Vec::new() };
                for (pixel, part) in block.pixels(&part) {
                    let corner = [from[0] + pixel % (to[0] - from[0]), from[1] + pixel / (to[0] - from[0])];
                    for point in &part {
                        let beside = [point.x - corner[0] as f64, point.y - corner[1] as f64];
                        assert!(beside.iter().all(|x| (-1e-9..1.0 + 1e-9).contains(x)), "{point:?}");
                    }
                    sum += area(&part);
                    let quarters: f64 = quarters(&part).iter().map(|quarter| area(quarter)).sum();
                    assert!((quarters - area(&part)).abs() < 1e-14);
                }
            }
        }
        assert!((sum - area(&whole)).abs() < 1e-12, "{sum}");
    }
}
