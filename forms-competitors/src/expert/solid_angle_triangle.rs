//! The solid angle of a triangle, by A. van Oosterom and J. Strackee, The Solid Angle of a Plane
//! Triangle, IEEE Transactions on Biomedical Engineering 30 (1983): with a, b, c seen from p, and
//! with the same letters for their lengths, tan(Ω/2) = a·(b × c)/(abc + (a·b)c + (b·c)a + (c·a)b).
//! The numerator is a·((b − a) × (c − a)), from differences of the corners.

use super::vector::Vector;
use super::{batch, cross, difference, dot};

/// Columns: p, then the corners a, b, c, three coordinates each.
#[inline(always)]
fn value<V: Vector>(arguments: [V; 12]) -> V {
    let [px, py, pz, ax, ay, az, bx, by, bz, cx, cy, cz] = arguments;
    let (p, first) = ([px, py, pz], [ax, ay, az]);
    let normal = cross(difference([bx, by, bz], first), difference([cx, cy, cz], first));
    let (a, b, c) = (difference(first, p), difference([bx, by, bz], p), difference([cx, cy, cz], p));
    let lengths = [dot(a, a).sqrt(), dot(b, b).sqrt(), dot(c, c).sqrt()];
    // (ab + a·b)c + (b·c)a + (c·a)b
    let denominator = lengths[0].mul_add(lengths[1], dot(a, b)) * lengths[2];
    let denominator = dot(b, c).mul_add(lengths[0], dot(c, a).mul_add(lengths[1], denominator));
    V::splat(2.0) * dot(a, normal).atan2(denominator)
}

batch::batch!(triangle, 12, super::value);
