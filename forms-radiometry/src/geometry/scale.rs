//! Scale: multiplies numbers of any size by a power of two, which rounds nothing, so that they are
//! near 1.
//!
//! Form factors contain fourth powers of lengths, which leave the range of `f64` long before the
//! lengths do.

use super::Vector;
use super::vector::largest;

/// The largest coordinate and the smallest length: the squares of both are representable, as areas
/// require.
pub(crate) const LARGEST_LENGTH: f64 = 1e152;
pub(crate) const LEAST_LENGTH: f64 = 1e-152;

/// Numbers between 1/NEAR and NEAR need no scaling: none of the required powers of such numbers
/// overflows or underflows.
const NEAR: f64 = 1e30;
/// The largest exponent of a scale factor, up or down: the factor and its inverse are normal
/// numbers.
const LARGEST_POWER: f64 = 1000.0;

/// Returns the power of two nearest to a number above zero.
pub(crate) fn power_of_two(number: f64) -> f64 {
    number.log2().round().exp2()
}

/// Returns the power of two that brings the largest number about as far above 1 as the smallest
/// below 1. It is 1 where both are already near 1, or there is no number above zero.
pub(crate) fn factor([largest, least]: [f64; 2]) -> f64 {
    let power = -0.5 * (largest.log2() + least.log2());
    let is_near = largest <= NEAR && least >= 1.0 / NEAR;
    if is_near || !power.is_finite() {
        1.0
    } else {
        power.clamp(-LARGEST_POWER, LARGEST_POWER).round().exp2()
    }
}

/// Returns the largest coordinate of vertices and the largest distance from the first vertex along
/// an axis; NaN if a coordinate is NaN.
pub(crate) fn lengths(vertices: &[Vector]) -> [f64; 2] {
    let extent = |from: Vector| largest(vertices.iter().map(|&v| (v - from).largest()));
    [largest(vertices.iter().map(|v| v.largest())), extent(vertices[0])]
}

/// Combines the lengths of several shapes.
pub(crate) fn of_all(lengths: impl Iterator<Item = [f64; 2]>) -> [f64; 2] {
    lengths.fold([0.0, f64::INFINITY], |[largest, least], [l, e]| [l.max(largest), e.min(least)])
}
