//! The form factor of a rectangle at a point with a normal, by J. H. Lambert's formula
//! (Photometria, 1760): with the corners r₀ … r₃ seen from the point, F = |Σᵢ γᵢ n·(rᵢ × rᵢ₊₁)/|rᵢ
//! × rᵢ₊₁||/(2π|n|), where γᵢ is the angle that the edge subtends.
//!
//! In the clipped version only the part above the horizon counts. Directions suffice: an edge from
//! a above the horizon to b below it ends in the direction |n·a| b + |n·b| a, without a division.
//! One more edge, along the horizon, closes the polygon.

use super::vector::Vector;
use super::{batch, cross, difference, dot};

/// Returns the contribution of an edge to 2π|n|F: n·(a × b)/|a × b| times the angle from a to b.
#[inline(always)]
fn edge<V: Vector>(normal: [V; 3], a: [V; 3], b: [V; 3]) -> V {
    let across = cross(a, b);
    dot(normal, across) * dot(across, across).sqrt().angle_over_sine(dot(a, b))
}

/// Returns the normal, and the corners o, o + u, o + u + v, o + v as seen from p.
#[inline(always)]
fn corners<V: Vector>(arguments: [V; 15]) -> ([V; 3], [[V; 3]; 4]) {
    let [px, py, pz, nx, ny, nz, ox, oy, oz, ux, uy, uz, vx, vy, vz] = arguments;
    let o = difference([ox, oy, oz], [px, py, pz]);
    let (ou, ov) = ([o[0] + ux, o[1] + uy, o[2] + uz], [o[0] + vx, o[1] + vy, o[2] + vz]);
    ([nx, ny, nz], [o, ou, [ou[0] + vx, ou[1] + vy, ou[2] + vz], ov])
}

#[inline(always)]
fn form_factor<V: Vector>(normal: [V; 3], sum: V) -> V {
    sum.abs() / (V::splat(2.0 * std::f64::consts::PI) * dot(normal, normal).sqrt())
}

/// Returns the form factor of a rectangle that the horizon does not cut. Columns: p, n, o, u, v,
/// three coordinates each.
#[inline(always)]
fn above<V: Vector>(arguments: [V; 15]) -> V {
    let (normal, [a, b, c, d]) = corners(arguments);
    let sum = (edge(normal, a, b) + edge(normal, b, c)) + (edge(normal, c, d) + edge(normal, d, a));
    form_factor(normal, sum)
}

/// Returns `then` where left < right, else `otherwise`.
#[inline(always)]
fn either<V: Vector>(left: V, right: V, then: [V; 3], otherwise: [V; 3]) -> [V; 3] {
    [
        V::if_less(left, right, then[0], otherwise[0]),
        V::if_less(left, right, then[1], otherwise[1]),
        V::if_less(left, right, then[2], otherwise[2]),
    ]
}

/// Part above the horizon of the edges processed so far.
struct Clipped<V> {
    normal: [V; 3],
    sum: V,
    /// Direction in which the outline rises above the horizon.
    enters: [V; 3],
    /// Direction in which it falls below the horizon.
    leaves: [V; 3],
}

impl<V: Vector> Clipped<V> {
    /// Adds the edge from a to b.
    #[inline(always)]
    fn with(self, a: [V; 3], b: [V; 3]) -> Self {
        let zero = V::splat(0.0);
        let (above_a, above_b) = (dot(self.normal, a), dot(self.normal, b));
        let (far, near) = (above_a.abs(), above_b.abs());
        let crossing =
            [far.mul_add(b[0], near * a[0]), far.mul_add(b[1], near * a[1]), far.mul_add(b[2], near * a[2])];
        let (from, to) = (either(zero, above_a, a, crossing), either(zero, above_b, b, crossing));
        let part = V::if_less(zero, above_a.max(above_b), edge(self.normal, from, to), zero);
        let entering = either(zero, above_b, crossing, self.enters);
        let leaving = either(zero, above_b, self.leaves, crossing);
        Clipped {
            normal: self.normal,
            sum: self.sum + part,
            enters: either(zero, above_a, self.enters, entering),
            leaves: either(zero, above_a, leaving, self.leaves),
        }
    }
}

/// Returns the form factor of any rectangle. Columns as above.
#[inline(always)]
fn clipped<V: Vector>(arguments: [V; 15]) -> V {
    let (normal, [a, b, c, d]) = corners(arguments);
    let none = [V::splat(0.0); 3];
    let outline = Clipped { normal, sum: V::splat(0.0), enters: none, leaves: none };
    let outline = outline.with(a, b).with(b, c).with(c, d).with(d, a);
    form_factor(normal, outline.sum + edge(normal, outline.leaves, outline.enters))
}

batch::batch!(unclipped, 15, super::above);
batch::batch!(rectangle, 15, super::clipped);
