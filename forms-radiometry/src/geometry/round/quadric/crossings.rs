//! Lines and quadrics: where a line meets a cylinder, a cone or a paraboloid.
//!
//! With s = s₀ + t s₁ along the axis and the vector p₀ + t p₁ from it, a line is on the surface where
//! |p|² − r²(s) = A t² + B t + C = 0.

use super::Quadric;
use crate::geometry::{Round, Vector};

/// How far beyond its ends the shape is met by rays, relative to its length: between it and the disk
/// that closes it no ray passes.
pub(super) const JOINT: f64 = 1e-14;
/// An intersection of a line with a quadric.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Crossing {
    /// The distance along the line, in lengths of its direction.
    pub(crate) distance: f64,
    /// Whether the line goes from the outside to the inside.
    pub(crate) enters: bool,
}

/// A line as the quadric sees it: with s = s₀ + t s₁ and the vector p₀ + t p₁ from the axis,
/// |p|² − r²(s) = A t² + B t + C.
struct Line {
    along: [f64; 2],
    a: f64,
    b: f64,
    c: f64,
}

impl Quadric {
    fn line(&self, from: Vector, direction: Vector) -> Line {
        let (axis, length) = self.axis();
        let (s, p) = self.relative((axis, length), from);
        let d = axis.dot(direction);
        let (along, q) = ([s, d / length], direction - d * axis);
        let [q0, q1, q2] = self.squared();
        let outside = p.length() - self.radius_at(s.clamp(0.0, 1.0));
        let c = if (0.0..=1.0).contains(&s) {
            outside * (p.length() + self.radius_at(s))
        } else {
            p.dot(p) - (q0 + s * (q1 + s * q2))
        };
        let a = q.dot(q) - q2 * along[1] * along[1];
        let b = 2.0 * p.dot(q) - along[1] * (q1 + 2.0 * q2 * s);
        Line { along, a, b, c }
    }

    /// Returns where a line meets the shape, in the order of the distances, which can be negative.
    /// The equation is solved about the point of the line that is nearest to the middle of the
    /// shape, where its terms are as small as the shape.
    pub(crate) fn crossings(&self, from: Vector, direction: Vector) -> [Option<Crossing>; 2] {
        let shift = direction.dot(self.center() - from) / direction.dot(direction);
        let line = self.line(from + shift * direction, direction);
        let roots = line.roots();
        let crossing = |root: f64| {
            let s = line.along[0] + root * line.along[1];
            let is_on = root.is_finite() && (-JOINT..=1.0 + JOINT).contains(&s);
            is_on.then_some(Crossing { distance: shift + root, enters: 2.0 * line.a * root + line.b < 0.0 })
        };
        roots.map(crossing)
    }

    /// Returns where a line that goes inwards from a point of the shape leaves it.
    pub(crate) fn beyond(&self, from: Vector, direction: Vector) -> Option<f64> {
        let Line { along, a, b, .. } = self.line(from, direction);
        let root = -b / a;
        let s = along[0] + root * along[1];
        (b <= 0.0 && a > 0.0 && (-JOINT..=1.0 + JOINT).contains(&s)).then_some(root)
    }
}

impl Line {
    /// Returns the roots of A t² + B t + C in ascending order; not finite where there is none.
    fn roots(&self) -> [f64; 2] {
        let &Self { a, b, c, .. } = self;
        let root = b * b - 4.0 * a * c;
        if root.is_nan() || root <= 0.0 {
            return [f64::NAN; 2];
        }
        // the sum has no cancellation, and the other root follows from the product of both
        let q = -0.5 * (b + b.signum() * root.sqrt());
        let [one, other] = [q / a, c / q];
        if one <= other { [one, other] } else { [other, one] }
    }
}
