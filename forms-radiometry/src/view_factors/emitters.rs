//! Emitters: the surfaces of a scene as walls that rays start from and arrive at.
//!
//! ```text
//! surface ─▶ triangles and round shapes, on each side that sends light
//! number of four dimensions ─▶ a piece by its area, a point on it, a direction by the cosine law
//! ```
//! Round shapes are exact. Pieces are in the order of a curve through space (Morton order), so
//! that numbers near each other are points near each other, and low-discrepancy numbers give points
//! that are evenly distributed over the surface.

use crate::geometry::bounds::Bounds;
use crate::geometry::{Disk, Quadric, Round, Sphere, Vector};
use crate::paths::{walls_of, warps};
use crate::sampling::{Frame, Samples, chosen, shares};
use crate::scene::{Scene, sheets_without_edges};
use crate::visibility::{Start, Wall, Walls};

/// Bits of each coordinate in the order of pieces.
const BITS: u32 = 10;

/// The walls of a scene, and the pieces of each surface that send light.
pub(super) struct Emitters {
    walls: Walls,
    /// The surface of each wall.
    surfaces: Vec<usize>,
    two_sided: Vec<bool>,
    of_surfaces: Vec<Pieces>,
}

/// The pieces of a surface, with the running sums of their shares in its area.
#[derive(Default)]
struct Pieces {
    pieces: Vec<Piece>,
    sums: Vec<f64>,
    area: f64,
}

/// A piece of one side of a surface.
#[derive(Clone, Copy)]
struct Piece {
    wall: usize,
    is_front: bool,
    shape: Shape,
}

#[derive(Clone, Copy)]
enum Shape {
    Triangle([Vector; 3], Vector),
    Disk(Disk),
    Sphere(Sphere),
    Quadric(Quadric),
}

impl Emitters {
    pub(super) fn of(scene: &Scene) -> Self {
        let (mut walls, mut surfaces) = (Vec::new(), Vec::new());
        for sheet in sheets_without_edges(scene) {
            let of_sheet = walls_of(sheet.shape);
            surfaces.extend(of_sheet.iter().map(|_| sheet.surface));
            walls.extend(of_sheet);
        }
        let two_sided: Vec<bool> = scene.surfaces.iter().map(|surface| surface.two_sided).collect();
        let mut pieces = vec![Vec::new(); scene.surfaces.len()];
        for (index, (wall, &surface)) in walls.iter().zip(&surfaces).enumerate() {
            let sides: &[bool] = if two_sided[surface] { &[true, false] } else { &[true] };
            for &is_front in sides {
                let of_wall = shapes(wall).into_iter();
                pieces[surface].extend(of_wall.map(|shape| Piece { wall: index, is_front, shape }));
            }
        }
        let of_surfaces = pieces.into_iter().map(Pieces::of).collect();
        Self { walls: Walls::of(walls), surfaces, two_sided, of_surfaces }
    }

    /// Returns the area from which a surface sends light.
    pub(super) fn area(&self, surface: usize) -> f64 {
        self.of_surfaces[surface].area
    }

    /// Returns the surface at which a ray of a surface arrives, on a side that receives light.
    pub(super) fn sent(&self, surface: usize, mut samples: Samples) -> Option<usize> {
        let Pieces { pieces, sums, .. } = &self.of_surfaces[surface];
        let [[number, u], direction] = [samples.pair(), samples.pair()];
        let place = chosen(sums, number)?;
        let before = if place == 0 { 0.0 } else { sums[place - 1] };
        let within = ((number - before) / (sums[place] - before)).clamp(0.0, 1.0);
        let Piece { wall, is_front, shape } = pieces[place];
        let (position, normal) = shape.point([within, u]);
        let normal = if is_front { normal } else { -normal };
        let start: Start = self.walls.start_beside(wall, position, is_front);
        let direction =
            Frame::about(normal).place(warps::cosine_hemisphere_sample(direction[0], direction[1]));
        let met = self.walls.first(start, direction, f64::INFINITY)?;
        let arrived = self.surfaces[met.wall];
        (met.is_front || self.two_sided[arrived]).then_some(arrived)
    }
}

impl Pieces {
    fn of(mut pieces: Vec<Piece>) -> Self {
        let bounds = Bounds::of(pieces.iter().map(|piece| piece.shape.middle()));
        let scale = 1.0 / bounds.extent().max(f64::MIN_POSITIVE);
        pieces.sort_by_cached_key(|piece| morton(scale * (piece.shape.middle() - bounds.low)));
        let areas: Vec<f64> = pieces.iter().map(|piece| piece.shape.area()).collect();
        let [_, sums] = shares(&areas);
        Self { pieces, sums, area: areas.iter().sum() }
    }
}

/// Returns the place of a point on a curve through the unit cube.
fn morton(point: Vector) -> u32 {
    let cells = point.coordinates().map(|x| (x * f64::from(1 << BITS)) as u32);
    let bit = |bit: u32, axis: usize| (cells[axis] >> bit & 1) << (3 * bit + axis as u32);
    (0..BITS).flat_map(|place| (0..3).map(move |axis| (place, axis))).fold(0, |sum, (b, a)| sum | bit(b, a))
}

/// Returns shapes that cover a wall.
fn shapes(wall: &Wall) -> Vec<Shape> {
    match wall {
        Wall::Polygon { vertices, normal } => {
            let fan = (1..vertices.len() - 1).map(|i| [vertices[0], vertices[i], vertices[i + 1]]);
            fan.map(|corners| Shape::Triangle(corners, *normal)).collect()
        }
        Wall::Disk(disk) => vec![Shape::Disk(*disk)],
        Wall::Sphere(sphere) => vec![Shape::Sphere(*sphere)],
        Wall::Quadric(quadric) => vec![Shape::Quadric(*quadric)],
    }
}

impl Shape {
    fn area(&self) -> f64 {
        match self {
            Self::Triangle([a, b, c], normal) => 0.5 * normal.dot((*b - *a).cross(*c - *a)).max(0.0),
            Self::Disk(disk) => disk.area(),
            Self::Sphere(sphere) => sphere.area(),
            Self::Quadric(quadric) => quadric.area(),
        }
    }

    fn middle(&self) -> Vector {
        match self {
            Self::Triangle(corners, _) => Vector::mean(corners),
            Self::Disk(disk) => disk.center,
            Self::Sphere(sphere) => sphere.center,
            Self::Quadric(quadric) => quadric.center(),
        }
    }

    /// Returns a point of a uniform distribution over the shape, and the normal of its front there.
    fn point(&self, [u, v]: [f64; 2]) -> (Vector, Vector) {
        match self {
            Self::Triangle([a, b, c], normal) => {
                let root = u.sqrt();
                (*a + root * ((1.0 - v) * (*b - *a) + v * (*c - *a)), *normal)
            }
            Self::Disk(disk) => disk.sample([u, v]),
            Self::Sphere(sphere) => sphere.sample([u, v]),
            Self::Quadric(quadric) => quadric.point([u, v]),
        }
    }
}
