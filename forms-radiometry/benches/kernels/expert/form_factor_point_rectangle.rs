//! The form factor of a rectangle at a point with a normal, by J. H. Lambert's formula (Photometria, 1760): with the
//! corners r₀ … r₃ seen from the point, F = |Σᵢ γᵢ n·(rᵢ × rᵢ₊₁)/|rᵢ × rᵢ₊₁||/(2π|n|), γᵢ the angle the edge subtends.
//!
//! Clipped, only what stands above the horizon counts. Directions are enough, so an edge from a above it to b below ends
//! in the direction |n·a| b + |n·b| a, without a division; one more edge, along the horizon, closes the polygon.

use super::vector::Vector;
use super::{batch, cross, difference, dot};

/// What an edge adds to 2π|n|F: n·(a × b)/|a × b| times the angle from a to b.
#[inline(always)]
fn edge<V: Vector>(normal: [V; 3], a: [V; 3], b: [V; 3]) -> V {
    let across = cross(a, b);
    dot(normal, across) * dot(across, across).sqrt().angle_over_sine(dot(a, b))
}

/// The corners o, o + u, o + u + v, o + v as seen from p, and the normal.
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

/// A rectangle that the horizon does not cut. Columns: p, n, o, u, v, three coordinates each.
#[inline(always)]
fn above<V: Vector>(arguments: [V; 15]) -> V {
    let (normal, [a, b, c, d]) = corners(arguments);
    let sum = (edge(normal, a, b) + edge(normal, b, c)) + (edge(normal, c, d) + edge(normal, d, a));
    form_factor(normal, sum)
}

/// `then` where left < right, else `otherwise`.
#[inline(always)]
fn either<V: Vector>(left: V, right: V, then: [V; 3], otherwise: [V; 3]) -> [V; 3] {
    let component = |i: usize| V::if_less(left, right, then[i], otherwise[i]);
    [component(0), component(1), component(2)]
}

/// Any rectangle. Columns as above.
#[inline(always)]
fn clipped<V: Vector>(arguments: [V; 15]) -> V {
    let (normal, corners) = corners(arguments);
    let zero = V::splat(0.0);
    let heights = corners.map(|corner| dot(normal, corner));
    let (mut sum, mut enters, mut leaves) = (zero, [zero; 3], [zero; 3]);
    for i in 0..4 {
        let (a, b) = (corners[i], corners[(i + 1) % 4]);
        let (above_a, above_b) = (heights[i], heights[(i + 1) % 4]);
        let (far, near) = (above_a.abs(), above_b.abs());
        let crossing = [0, 1, 2].map(|k| far.mul_add(b[k], near * a[k]));
        let (from, to) = (either(zero, above_a, a, crossing), either(zero, above_b, b, crossing));
        sum = sum + V::if_less(zero, above_a.max(above_b), edge(normal, from, to), zero);
        let entering = either(zero, above_b, crossing, enters);
        enters = either(zero, above_a, enters, entering);
        let leaving = either(zero, above_b, leaves, crossing);
        leaves = either(zero, above_a, leaving, leaves);
    }
    form_factor(normal, sum + edge(normal, leaves, enters))
}

batch::batch!(unclipped, 15, super::above);
batch::batch!(rectangle, 15, super::clipped);
