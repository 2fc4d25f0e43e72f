//! Scale: numbers of any size become numbers near 1, by a power of two, which rounds nothing.
//!
//! Form factors are made of fourth powers of lengths, which leave the range of `f64` long before the lengths do.

use super::Vector;

/// The largest coordinate, and the least length: the squares of both are numbers, as areas have to be.
pub(crate) const LARGEST_LENGTH: f64 = 1e152;
pub(crate) const LEAST_LENGTH: f64 = 1e-152;

/// Numbers between 1/NEAR and NEAR are near enough to 1: no power of them that is needed overflows or underflows.
const NEAR: f64 = 1e30;
/// The largest power of two that is used, up or down: it and its inverse are normal numbers.
const LARGEST_POWER: f64 = 1000.0;

/// The power of two next to a number above zero.
pub(super) fn power_of_two(number: f64) -> f64 {
    number.log2().round().exp2()
}

/// The power of two that brings the largest and the least of some numbers about as far above 1 as below it; 1 where both are near, or
/// there is no number above zero.
pub(crate) fn factor([largest, least]: [f64; 2]) -> f64 {
    let power = -0.5 * (largest.log2() + least.log2());
    let is_near = largest <= NEAR && least >= 1.0 / NEAR;
    if is_near || !power.is_finite() {
        1.0
    } else {
        power.clamp(-LARGEST_POWER, LARGEST_POWER).round().exp2()
    }
}

/// The largest coordinate of vertices, not a number if one is none; and how far they reach from the first along an axis.
pub(crate) fn lengths(vertices: &[Vector]) -> [f64; 2] {
    let largest = |of: &dyn Fn(&Vector) -> f64| {
        vertices.iter().map(of).fold(0.0, |m: f64, length| if length <= m { m } else { length })
    };
    [largest(&|v| v.largest()), largest(&|&v| (v - vertices[0]).largest())]
}

/// The lengths of several things together.
pub(crate) fn of_all(lengths: impl Iterator<Item = [f64; 2]>) -> [f64; 2] {
    lengths.fold([0.0, f64::INFINITY], |[largest, least], [l, e]| [l.max(largest), e.min(least)])
}
