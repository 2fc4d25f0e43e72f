//! Tessellation gaps: bounds the occlusion of an outline by a sphere or disk where the flat pieces
//! of its tessellation occlude nothing.
//!
//! ```text
//! point, outline ─▶ planes through the point and each edge
//!                ─ how far the shape reaches over each, p ─▶ (p/d) (2 √(2Rp)/d) of solid angle
//! ```
//! The part of a sphere that reaches at most p beyond a plane is a cap whose rim has at most the
//! radius √(2Rp). A point in that plane sees the cap edge-on.

use super::{Round, Vector};
use std::f64::consts::PI;

/// Tolerance of the distances, relative to the lengths that they are sums of: a shape within this
/// distance of a plane counts as beyond it.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Bounds the solid angle, over π, of the part of a convex outline that a sphere or disk hides from
/// a point while the pieces of its tessellation hide nothing. The outline faces the point. A shape
/// behind the outline, below the horizon of this normal, or through which the point sees the outline
/// hides nothing.
pub(crate) fn bulge(
    shape: &dyn Round,
    (point, horizon): (Vector, Option<Vector>),
    (outline, normal): (&[Vector], Vector),
) -> f64 {
    let (to_center, radius) = (shape.center() - point, shape.radius());
    let rounding = ROUNDING * (point.largest() + shape.center().largest() + radius);
    // how far the shape reaches beyond the plane through the point with this normal
    let over = |normal: Vector| normal.dot(to_center) + shape.reach(normal) * radius + rounding;
    if over(normal) < normal.dot(outline[0] - point)
        || horizon.is_some_and(|normal| over(normal) < 0.0)
        || shape.shows_through(point, outline)
    {
        return 0.0;
    }
    let middle = Vector::mean(outline) - point;
    let next = outline[1..].iter().chain(&outline[..1]);
    let caps = outline.iter().zip(next).filter_map(|(&a, &b)| {
        let across = (a - point).cross(b - point).unit()?;
        let inward = if across.dot(middle) < 0.0 { -across } else { across };
        let depth = over(inward);
        let half = || shape.cap(depth, shape.reach(inward));
        Some(if depth <= 0.0 { 0.0 } else { cap(depth, half(), [to_center.length(), radius]) })
    });
    caps.fold(4.0, f64::min)
}

/// Returns a bound on the solid angle, over π, of the part of a shape that reaches at most `depth`
/// beyond a plane through a point, in a part of the radius `half`. The shape has this radius, and
/// its centre is `far` away from the point.
fn cap(depth: f64, half: f64, [far, radius]: [f64; 2]) -> f64 {
    // the visible part of a ball ends where lines from the point are tangent to it
    let nearest = (far - radius).max(((far - radius) * (far + radius)).max(0.0).sqrt() - half);
    if nearest > 0.0 { 2.0 * (depth / nearest) * (half / nearest) / PI } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Disk, Sphere};

    const HERE: Vector = Vector::new(0.0, 0.0, 0.0);
    const UP: Vector = Vector::new(0.0, 0.0, 1.0);

    /// The square of side 2 at the height 2 that faces down.
    fn lamp() -> [Vector; 4] {
        [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]].map(|[x, y]| Vector::new(x, y, 2.0))
    }

    fn of(shape: &dyn Round) -> f64 {
        bulge(shape, (HERE, Some(UP)), (&lamp(), -UP))
    }

    fn ball(center: [f64; 3]) -> Sphere {
        let [x, y, z] = center;
        Sphere { center: Vector::new(x, y, z), radius: 0.5, inward: false }
    }

    #[test]
    fn a_sphere_bulges_into_the_way_only_from_where_it_reaches_it() {
        // at the height 1 the shaft is 1 wide, and its side leans by atan ½
        let touches = 0.5 + 0.25 * 5.0_f64.sqrt();
        assert_eq!(of(&ball([touches + 1e-12, 0.0, 1.0])), 0.0);
        let depths = [1e-6, 1e-4, 1e-2].map(|into| of(&ball([touches - into, 0.0, 1.0])));
        assert!(depths.is_sorted() && depths[0] > 0.0 && depths[2] < 0.01, "{depths:?}");
        // the bound grows with the depth to the power of three halves
        assert!(((depths[1] / depths[0]).log10() - 3.0).abs() < 0.05, "{depths:?}");
    }

    #[test]
    fn what_is_behind_the_lamp_or_below_the_horizon_hides_nothing() {
        assert_eq!(of(&ball([0.0, 0.0, 2.51])), 0.0);
        assert_eq!(of(&ball([0.0, 0.0, -0.51])), 0.0);
        assert!(of(&ball([0.0, 0.0, 1.0])) > 0.1);
    }

    #[test]
    fn a_disk_reaches_no_farther_than_it_is_wide() {
        let disk = |normal| Disk { center: Vector::new(0.8, 0.0, 1.0), normal, radius: 0.5, hole: 0.0 };
        // an upright disk stays outside the shaft
        assert_eq!(of(&disk(Vector::new(1.0, 0.0, 0.0))), 0.0);
        assert!(of(&disk(UP)) > 0.0);
    }
}
