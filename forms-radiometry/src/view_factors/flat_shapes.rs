//! Flat shapes: view factors between polygons, disks and annuli that nothing hides, as sums over
//! their borders.
//!
//! ```text
//! polygon ─▶ its convex pieces, less its round holes        annulus ─▶ its disk, less its hole
//! A₁F₁₂ is the sum over pairs of parts, with the signs of both
//! ```

use super::least;
use crate::form_factor::{Exchange, exchange_of_disks, exchange_of_outlines, exchange_with_disk};
use crate::geometry::{Disk, Vector};
use crate::scene::Shape;

/// A flat shape.
pub(super) struct FlatShape<'s> {
    /// Its unit normal, and a point of its plane.
    pub(super) normal: Vector,
    pub(super) point: Vector,
    parts: Vec<(Part<'s>, f64)>,
}

/// A part of a flat shape, which counts with a sign.
enum Part<'s> {
    Outline(&'s [Vector]),
    Disk(Disk),
}

impl<'s> FlatShape<'s> {
    /// Returns a shape as a flat one, if it is one.
    pub(super) fn of(shape: &'s Shape) -> Option<Self> {
        match shape {
            Shape::Polygon(polygon) => {
                let pieces = polygon.straight_pieces().iter().map(|piece| (Part::Outline(piece), 1.0));
                let holes = polygon.round_holes().iter().map(|hole| (Part::Disk(*hole), -1.0));
                let (normal, point) = (polygon.normal(), polygon.vertices()[0]);
                Some(Self { normal, point, parts: pieces.chain(holes).collect() })
            }
            Shape::Disk(disk) => {
                let parts =
                    disk.whole_and_hole().into_iter().zip([1.0, -1.0]).filter(|(disk, _)| disk.radius > 0.0);
                let parts = parts.map(|(disk, sign)| (Part::Disk(disk), sign)).collect();
                Some(Self { normal: disk.normal, point: disk.center, parts })
            }
            Shape::Sphere(_) | Shape::Quadric(_) | Shape::Mesh(_) => None,
        }
    }

    /// Returns convex outlines that cover the shape. They extend beyond round borders.
    pub(super) fn outlines(&self) -> impl Iterator<Item = Vec<Vector>> {
        self.parts.iter().filter(|(_, sign)| *sign > 0.0).map(|(part, _)| match part {
            Part::Outline(outline) => outline.to_vec(),
            Part::Disk(disk) => disk.around(),
        })
    }

    /// Returns the exchange area with another flat shape that nothing hides; `None` if one shape
    /// cuts the plane of the other so that there is no rule, or the rule misses the tolerance. Areas
    /// below that of a view factor of 1 to the `size` are computed to the same absolute error.
    pub(super) fn exchange(&self, other: &Self, (size, tolerance): (f64, f64)) -> Option<Exchange> {
        let mut sum = Exchange::default();
        for (one, sign) in &self.parts {
            for (two, of_other) in &other.parts {
                let Exchange { area, error } = match (one, two) {
                    (Part::Outline(a), Part::Outline(b)) => {
                        exchange_of_outlines([a, b], [self.normal, other.normal], [tolerance; 2])
                    }
                    (Part::Disk(disk), Part::Outline(outline)) => {
                        exchange_with_disk(disk, (outline, other.normal), tolerance)?
                    }
                    (Part::Outline(outline), Part::Disk(disk)) => {
                        exchange_with_disk(disk, (outline, self.normal), tolerance)?
                    }
                    (Part::Disk(a), Part::Disk(b)) => exchange_of_disks([a, b], tolerance)?,
                };
                sum += Exchange { area: sign * of_other * area, error };
            }
        }
        let goal = tolerance * sum.area.max(least(1) * size);
        (sum.error <= goal).then_some(Exchange { area: sum.area.max(0.0), ..sum })
    }
}
