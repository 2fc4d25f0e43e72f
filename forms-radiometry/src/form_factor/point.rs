//! The form factor from a point to a polygon: the polygon is clipped at the horizon, then its edges
//! are summed.

use crate::geometry::clip::split;
use crate::geometry::{Polygon, Vector, scale};
use forms_kernels::edge_form_factor;

/// Returns the unoccluded form factor from a receiver to the front of a polygon; E = π F L for a
/// polygon that emits the uniform radiance L.
///
/// ```text
/// F = (1/π) ∫ cos θ dω = (1/2π) Σ γᵢ n·(bᵢ × aᵢ)/|aᵢ × bᵢ|     (Lambert 1760)
/// ```
///
/// over the directions ω in which the polygon is seen above the horizon n·ω = 0. The polygon is
/// counter-clockwise about its own normal, hence clockwise as a receiver in front of it looks up:
/// its edges are taken backwards, from b to a. This is the only place where the sign is chosen: F >
/// 0 for a polygon that faces the receiver, and F = 0 for a receiver behind it or in its plane.
/// `normal` need not be a unit vector.
pub fn form_factor(position: Vector, normal: Vector, polygon: &Polygon) -> f64 {
    let Some(normal) = normal.unit() else { return f64::NAN };
    if polygon.normal().dot(position - polygon.vertices()[0]) <= 0.0 {
        return 0.0;
    }
    let (mut above, mut below) = (Vec::new(), Vec::new());
    let mut sum = 0.0;
    for piece in polygon.convex_pieces() {
        let mut relative: Vec<Vector> = piece.iter().map(|&v| v - position).collect();
        let factor = scale::factor(scale::lengths(&relative));
        relative.iter_mut().for_each(|v| *v = factor * *v);
        split(&relative, |x| normal.dot(x), &mut above, &mut below);
        sum += edge_sum(&above, normal);
    }
    sum
}

/// Returns the form factor of the convex pieces that a receiver with a unit normal sees. They are
/// relative to the receiver and above its horizon.
#[cfg(test)]
pub(crate) fn form_factor_of_pieces<'p>(pieces: impl Iterator<Item = &'p [Vector]>, normal: Vector) -> f64 {
    pieces.fold(0.0, |sum, piece| sum + edge_sum(piece, normal))
}

/// Sums Lambert's formula over the edges of a polygon that lies above the horizon and faces the
/// receiver; its vertices are relative to the receiver.
pub(crate) fn edge_sum(polygon: &[Vector], n: Vector) -> f64 {
    let next = polygon.iter().skip(1).chain(polygon.first());
    let edge = |(a, b): (&Vector, &Vector)| edge_form_factor(b.x, b.y, b.z, a.x, a.y, a.z, n.x, n.y, n.z);
    polygon.iter().zip(next).map(edge).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// The rectangle [x₀, x₁] × [y₀, y₁] at this height, facing down.
    fn rectangle(x: (f64, f64), y: (f64, f64), height: f64) -> Polygon {
        let corners = [(x.0, y.0), (x.0, y.1), (x.1, y.1), (x.1, y.0)];
        Polygon::new(corners.map(|(x, y)| Vector::new(x, y, height)).to_vec()).unwrap()
    }

    const ORIGIN: Vector = Vector::new(0.0, 0.0, 0.0);
    const UP: Vector = Vector::new(0.0, 0.0, 1.0);

    /// Returns the form factor of a parallel rectangle a × b with a corner above the receiver, in
    /// units of its height: F = 1/(2π) [A/√(1+A²) atan(B/√(1+A²)) + B/√(1+B²) atan(A/√(1+B²))].
    fn corner(a: f64, b: f64) -> f64 {
        let term = |a: f64, b: f64| a / a.hypot(1.0) * (b / a.hypot(1.0)).atan();
        (term(a, b) + term(b, a)) / (2.0 * PI)
    }

    #[test]
    fn a_parallel_rectangle_has_the_closed_form_of_its_four_corners() {
        for (a, b, h) in
            [(1.0, 1.0, 1.0), (0.3, 2.0, 0.7), (10.0, 0.1, 1.0), (0.01, 0.02, 5.0), (3.0, 4.0, 0.05)]
        {
            let expected = 4.0 * corner(a / h, b / h);
            let found = form_factor(ORIGIN, UP, &rectangle((-a, a), (-b, b), h));
            assert!((found - expected).abs() <= 1e-14 * expected, "{a} × {b} at {h}: {found} and {expected}");
        }
    }

    #[test]
    fn a_huge_parallel_lamp_fills_the_hemisphere() {
        for size in [1e2, 1e4, 1e6, 1e8] {
            let found = form_factor(ORIGIN, UP, &rectangle((-size, size), (-size, size), 1.0));
            assert!((1.0 - found).abs() < 2.0 / size + 1e-15, "{size}: {found}");
        }
    }

    #[test]
    fn the_part_of_a_lamp_below_the_horizon_gives_nothing() {
        let across = Vector::new(1.0, 0.0, 0.0);
        let whole = form_factor(ORIGIN, across, &rectangle((-2.0, 3.0), (-1.0, 1.0), 1.0));
        let upper_part = form_factor(ORIGIN, across, &rectangle((0.0, 3.0), (-1.0, 1.0), 1.0));
        assert!(whole > 0.1 && (whole - upper_part).abs() < 1e-15);
        assert_eq!(form_factor(ORIGIN, across, &rectangle((-3.0, 0.0), (-1.0, 1.0), 1.0)), 0.0);
    }

    #[test]
    fn behind_a_lamp_and_in_its_plane_there_is_no_light() {
        let lamp = rectangle((-1.0, 1.0), (-1.0, 1.0), 1.0);
        for z in [1.0, 1.5, 1e6] {
            assert_eq!(form_factor(Vector::new(0.0, 0.0, z), -UP, &lamp), 0.0, "z = {z}");
        }
    }

    #[test]
    fn the_form_factor_adds_over_the_parts_of_a_lamp() {
        let normal = Vector::new(0.3, -0.2, 1.0);
        let whole = form_factor(ORIGIN, normal, &rectangle((-1.0, 2.0), (-1.0, 1.5), 0.8));
        let parts = form_factor(ORIGIN, normal, &rectangle((-1.0, 0.4), (-1.0, 1.5), 0.8))
            + form_factor(ORIGIN, normal, &rectangle((0.4, 2.0), (-1.0, 1.5), 0.8));
        assert!((whole - parts).abs() < 1e-15);
    }

    #[test]
    fn a_lamp_that_is_not_convex_is_the_sum_of_its_convex_parts() {
        let points = [(0.0, 0.0), (0.0, 2.0), (1.0, 2.0), (1.0, 1.0), (2.0, 1.0), (2.0, 0.0)];
        let l_shape = Polygon::new(points.map(|(x, y)| Vector::new(x, y, 1.0)).to_vec()).unwrap();
        let parts = form_factor(ORIGIN, UP, &rectangle((0.0, 1.0), (0.0, 2.0), 1.0))
            + form_factor(ORIGIN, UP, &rectangle((1.0, 2.0), (0.0, 1.0), 1.0));
        assert!((form_factor(ORIGIN, UP, &l_shape) - parts).abs() < 1e-15);
    }
}
