//! Coaxial shapes: view factors between disks, annuli, and the insides of cylinders, cones and
//! paraboloids about one axis.
//!
//! ```text
//! annulus             its disk less its hole
//! inside of a shape   its nearer opening less its farther one: what passes the first and not the second arrives
//! A₁F₁₂               a sum of A F between coaxial disks with the signs of both (Howell C-41)
//! inside to itself    1 − what leaves by its openings
//! ```
//! A shape about the axis is convex inside: a line that passes its nearer opening meets it, or passes
//! the farther one.

use super::ViewFactor;
use crate::geometry::{Disk, Profile, Quadric, Vector};
use crate::scene::{Shape, Surface};
use forms_kernels::view_factor_coaxial_disks;
use std::f64::consts::PI;

/// Rounding error of a view factor, relative to it.
pub(super) const ROUNDING: f64 = 256.0 * f64::EPSILON;
/// Largest sine of the angle, and relative distance, within which two axes coincide.
const COAXIAL: f64 = 1e-14;
/// Rounding of the difference of two places, in units of 2⁻⁵² times the largest coordinate.
const PLACES: f64 = 4.0;

/// A disk about an axis: its height, and its radius.
#[derive(Clone, Copy, Debug)]
struct Opening {
    height: f64,
    radius: f64,
}

/// An axis: a point and a unit vector.
#[derive(Clone, Copy, Debug)]
struct Axis {
    point: Vector,
    along: Vector,
}

/// A shape about an axis.
enum Turned {
    /// The disk and its hole, and whether the front looks up the axis.
    Flat { borders: [Opening; 2], looks_up: bool },
    /// The lower and the upper opening of a shape whose front is the inside.
    Inside { openings: [Opening; 2], widest: f64 },
}

/// Returns the view factor from one surface of several to another, or to itself, if both are shapes
/// about one axis and nothing is between them.
pub(super) fn factor(surfaces: &[Surface], from: usize, to: usize) -> Option<ViewFactor> {
    let axis = Axis::of(&surfaces[from].shape)?;
    let [one, other] = [from, to].map(|index| Turned::about(axis, &surfaces[index].shape));
    let ((one, aside), (other, also_aside)) = (one?, other?);
    let hull: Vec<Opening> = one.hull().into_iter().chain(other.hull()).collect();
    let mut others = (0..surfaces.len()).filter(|&index| index != from && index != to);
    if others.any(|index| !axis.is_beside(&surfaces[index].shape, &hull)) {
        return None;
    }
    let size = area(&surfaces[from].shape)?;
    let terms = if from == to { one.to_itself(size)? } else { one.exchange(&other)? };
    let value = (terms.iter().sum::<f64>() / size).max(0.0);
    let error = (ROUNDING + aside + also_aside) * terms.iter().map(|term| term.abs()).sum::<f64>() / size;
    Some(ViewFactor { value, error })
}

impl Axis {
    fn of(shape: &Shape) -> Option<Self> {
        match shape {
            Shape::Disk(disk) => Some(Self { point: disk.center, along: disk.normal }),
            Shape::Quadric(quadric) => Some(Self { point: quadric.ends[0], along: quadric.axis().0 }),
            Shape::Sphere(_) | Shape::Polygon(_) | Shape::Mesh(_) => None,
        }
    }

    fn height(self, point: Vector) -> f64 {
        self.along.dot(point - self.point)
    }

    /// Returns the distance of a point from the axis, over this length, if the rounding of
    /// coordinates and of the axis explains it.
    fn holds(self, point: Vector, length: f64) -> Option<f64> {
        let away = (point - self.point).cross(self.along).length();
        let distance = length.max((point - self.point).length());
        let rounding = f64::EPSILON * point.largest().max(self.point.largest());
        (away <= COAXIAL * distance + PLACES * rounding).then_some(away / length)
    }

    /// Whether a shape hides nothing within the convex hull of disks about the axis.
    fn is_beside(self, shape: &Shape, hull: &[Opening]) -> bool {
        let heights = hull.iter().map(|opening| opening.height);
        let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), height| {
            (low.min(height), high.max(height))
        });
        if let Some((turned, _)) = Turned::about(self, shape) {
            return turned.is_beside(hull, [low, high]);
        }
        let in_front = |normal: Vector, point: Vector| {
            let (up, across) = (normal.dot(self.along), normal.cross(self.along).length());
            let reach = |opening: &Opening| up * opening.height + across * opening.radius;
            let farthest = hull.iter().map(reach).fold(f64::NEG_INFINITY, f64::max);
            farthest <= normal.dot(point - self.point)
        };
        match shape {
            Shape::Polygon(polygon) => {
                let (normal, point) = (polygon.normal(), polygon.vertices()[0]);
                in_front(normal, point) || in_front(-normal, point)
            }
            Shape::Mesh(_) => false,
            Shape::Disk(_) | Shape::Sphere(_) | Shape::Quadric(_) => {
                let widest = hull.iter().map(|opening| opening.radius).fold(0.0, f64::max);
                shape.as_round().is_some_and(|round| {
                    let (height, radius) = (self.height(round.center()), round.radius());
                    let away = (round.center() - self.point).cross(self.along).length();
                    away - radius >= widest || height + radius <= low || height - radius >= high
                })
            }
        }
    }
}

impl Turned {
    /// Returns a shape relative to an axis, if it is one about this axis whose front is flat or
    /// inside, and its distance from the axis relative to its size.
    fn about(axis: Axis, shape: &Shape) -> Option<(Self, f64)> {
        match shape {
            Shape::Disk(disk) => Self::flat(axis, disk),
            Shape::Quadric(quadric) if quadric.inward => Self::inside(axis, quadric),
            _ => None,
        }
    }

    fn flat(axis: Axis, disk: &Disk) -> Option<(Self, f64)> {
        let is_parallel = axis.along.cross(disk.normal).length() <= COAXIAL;
        let aside = axis.holds(disk.center, disk.radius).filter(|_| is_parallel)?;
        let height = axis.height(disk.center);
        let borders = [disk.radius, disk.hole].map(|radius| Opening { height, radius });
        Some((Self::Flat { borders, looks_up: axis.along.dot(disk.normal) > 0.0 }, aside))
    }

    fn inside(axis: Axis, quadric: &Quadric) -> Option<(Self, f64)> {
        let (along, length) = quadric.axis();
        let size = length.max(quadric.radii[0]).max(quadric.radii[1]);
        let is_parallel = axis.along.cross(along).length() <= COAXIAL;
        let aside = axis.holds(quadric.ends[0], size).filter(|_| is_parallel)?;
        let opening =
            |end: usize| Opening { height: axis.height(quadric.ends[end]), radius: quadric.radii[end] };
        let [first, last] = [opening(0), opening(1)];
        let openings = if first.height < last.height { [first, last] } else { [last, first] };
        let widest = match quadric.profile {
            Profile::Straight => 0.0,
            Profile::Parabolic => first.radius.max(last.radius),
        };
        Some((Self::Inside { openings, widest }, aside))
    }

    /// Returns disks whose convex hull contains the shape.
    fn hull(&self) -> [Opening; 2] {
        match *self {
            Self::Flat { borders, .. } => borders,
            Self::Inside { openings, widest } => {
                openings.map(|opening| Opening { radius: opening.radius.max(widest), ..opening })
            }
        }
    }

    fn heights(&self) -> [f64; 2] {
        let (Self::Flat { borders: ends, .. } | Self::Inside { openings: ends, .. }) = self;
        ends.map(|end| end.height)
    }

    /// Whether the shape is beyond the ends of a convex hull, or around it. Its radius is a concave
    /// function of the height, and that of the hull is linear between its disks.
    fn is_beside(&self, hull: &[Opening], [low, high]: [f64; 2]) -> bool {
        let [bottom, top] = self.heights();
        if top <= low || bottom >= high {
            return true;
        }
        let Self::Inside { openings: [lower, upper], .. } = self else { return false };
        let inner = hull.iter().map(|opening| opening.height).chain([bottom, top]);
        let mut within = inner.filter(|&height| (bottom.max(low)..=top.min(high)).contains(&height));
        within.all(|height| widest_at(hull, height) <= between(*lower, *upper, height) * (1.0 + COAXIAL))
    }

    /// Returns the disks, with signs, of what the shape receives from below it or from above it;
    /// empty if it looks away.
    fn lids(&self, from_below: bool) -> Vec<(f64, Opening)> {
        let lids = match *self {
            Self::Flat { looks_up, .. } if looks_up == from_below => return Vec::new(),
            Self::Flat { borders, .. } => borders,
            Self::Inside { openings: [lower, upper], .. } if from_below => [lower, upper],
            Self::Inside { openings: [lower, upper], .. } => [upper, lower],
        };
        // nothing passes the tip of a cone or the vertex of a paraboloid
        if lids[0].radius == 0.0 {
            return Vec::new();
        }
        let signed = [1.0, -1.0].into_iter().zip(lids);
        signed.filter(|(_, lid)| lid.radius > 0.0).collect()
    }

    /// Returns the terms of A F from one shape to another that is below it or above it.
    fn exchange(&self, other: &Self) -> Option<Vec<f64>> {
        let ([low, high], [bottom, top]) = (self.heights(), other.heights());
        let is_below = if high <= bottom {
            true
        } else if top <= low {
            false
        } else {
            return None;
        };
        let (own, others) = (self.lids(!is_below), other.lids(is_below));
        let all = || own.iter().flat_map(|own| others.iter().map(move |other| (own, other)));
        let passes = |lid: &(f64, Opening), lids: &[(f64, Opening)]| match lids {
            [(_, near), (_, far)] if near.height != far.height => {
                between(lid.1, *far, near.height) <= near.radius * (1.0 + COAXIAL)
            }
            _ => true,
        };
        let are_sums =
            own.iter().all(|lid| passes(lid, &others)) && others.iter().all(|lid| passes(lid, &own));
        are_sums.then(|| all().map(|((sign, a), (other, b))| sign * other * of_disks(*a, *b)).collect())
    }

    /// Returns the terms of A F from the inside of a shape of this area to itself.
    fn to_itself(&self, area: f64) -> Option<Vec<f64>> {
        let Self::Inside { openings: [lower, upper], .. } = *self else { return Some(vec![0.0]) };
        let through = 2.0 * of_disks(lower, upper);
        let [lower, upper] = [lower, upper].map(|opening| PI * opening.radius * opening.radius);
        Some(vec![area, -lower, -upper, through])
    }
}

/// Returns A F between two coaxial disks that face each other.
fn of_disks(a: Opening, b: Opening) -> f64 {
    let distance = (a.height - b.height).abs();
    let least = a.radius.min(b.radius);
    if least == 0.0 || distance == 0.0 {
        return PI * least * least;
    }
    PI * a.radius * a.radius * view_factor_coaxial_disks(a.radius, b.radius, distance)
}

/// Returns the radius, at this height, of the cone through the borders of two disks.
fn between(a: Opening, b: Opening, height: f64) -> f64 {
    if a.height == b.height {
        return a.radius.max(b.radius);
    }
    let share = (height - a.height) / (b.height - a.height);
    (1.0 - share) * a.radius + share * b.radius
}

/// Returns the radius of the convex hull of disks at this height.
fn widest_at(hull: &[Opening], height: f64) -> f64 {
    let pairs = hull.iter().flat_map(|a| hull.iter().map(move |b| (*a, *b)));
    let around = pairs.filter(|(a, b)| a.height <= height && height <= b.height);
    around.map(|(a, b)| between(a, b, height)).fold(0.0, f64::max)
}

/// Returns the area of a front; `None` of a mesh.
pub(super) fn area(shape: &Shape) -> Option<f64> {
    match shape {
        Shape::Polygon(polygon) => Some(polygon.area()),
        Shape::Disk(disk) => Some(disk.area()),
        Shape::Sphere(sphere) => Some(sphere.area()),
        Shape::Quadric(quadric) => Some(quadric.area()),
        Shape::Mesh(_) => None,
    }
}
