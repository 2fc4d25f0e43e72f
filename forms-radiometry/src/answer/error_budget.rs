//! Error budget: the errors that the steps of the work leave add up to the error of an answer.
//!
//! ```text
//! plan                    ─ effects    ─┐
//! equations, expansions   ─ orders     ─┤
//! elements, rules, shapes ─ quadrature ─┼─▶ bound: ε = ρ + q + o + e + s
//! arithmetic              ─ rounding   ─┤       σ: ε = √((ρ + q + o + e)² + s²)
//! rays and paths          ─ sampling   ─┘
//! ```
//! Each part is set where it is known, and nowhere else. Effects that the file turns off, and
//! orders that it excludes, define another problem and are not part of the error.

use super::error_kind::ErrorKind;
use serde::{Deserialize, Serialize};
use std::ops::Add;

/// Parts of an error, each in the unit of the answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ErrorParts {
    /// Error by the arithmetic of `f64`.
    pub rounding: f64,
    /// Error by elements, by rules of integration, and by polyhedra that replace curved shapes.
    pub quadrature: f64,
    /// Possible light of higher reflection orders, which the solver truncated because they were too
    /// small.
    pub orders: f64,
    /// Possible change by effects that the plan omitted because they matter less than the
    /// tolerance.
    pub effects: f64,
    /// Standard error of the mean of paths.
    pub sampling: f64,
}

impl ErrorParts {
    /// Names of the parts, in words.
    pub const NAMES: [&str; 5] =
        ["rounding", "quadrature", "truncated orders", "omitted effects", "sampling"];

    /// Returns the parts in the order of their names.
    pub fn all(&self) -> [f64; 5] {
        [self.rounding, self.quadrature, self.orders, self.effects, self.sampling]
    }

    /// Returns the combined error. Bounds add up. In a standard error, the deterministic parts
    /// count as a standard error of the same size.
    pub fn error(&self, kind: ErrorKind) -> f64 {
        let certain = self.rounding + self.quadrature + self.orders + self.effects;
        match kind {
            ErrorKind::Bound | ErrorKind::Estimate => certain + self.sampling,
            ErrorKind::Sigma => self.sampling.hypot(certain),
        }
    }

    /// Returns the parts multiplied by a factor.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self {
            rounding: factor * self.rounding,
            quadrature: factor * self.quadrature,
            orders: factor * self.orders,
            effects: factor * self.effects,
            sampling: factor * self.sampling,
        }
    }

    /// Returns the parts of a mean. Sampling errors average out, except for the part `common`
    /// that all numbers share; no other error averages out.
    pub(crate) fn of_mean(all: impl Iterator<Item = Self>, common: f64) -> Self {
        let (mut sum, mut squares, mut count) = (Self::default(), 0.0, 0.0);
        for parts in all {
            (squares, count) = (squares + parts.sampling * parts.sampling, count + 1.0);
            sum = sum + parts;
        }
        Self { sampling: squares.sqrt().hypot(common * sum.sampling), ..sum }.scaled(1.0 / count)
    }
}

impl Add for ErrorParts {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            rounding: self.rounding + other.rounding,
            quadrature: self.quadrature + other.quadrature,
            orders: self.orders + other.orders,
            effects: self.effects + other.effects,
            sampling: self.sampling + other.sampling,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PARTS: ErrorParts =
        ErrorParts { rounding: 0.5, quadrature: 1.0, orders: 0.25, effects: 1.25, sampling: 4.0 };

    #[test]
    fn bounds_add_up_and_standard_errors_as_squares() {
        assert_eq!(PARTS.error(ErrorKind::Bound), 7.0);
        assert_eq!(PARTS.error(ErrorKind::Sigma), 5.0);
        assert_eq!(PARTS.scaled(2.0).error(ErrorKind::Bound), 14.0);
    }

    #[test]
    fn what_is_sampled_averages_out_but_for_what_is_common() {
        let mean = |common| ErrorParts::of_mean([PARTS; 4].into_iter(), common);
        assert_eq!(mean(0.0), ErrorParts { sampling: 2.0, ..PARTS });
        assert_eq!(mean(0.375), ErrorParts { sampling: 2.5, ..PARTS });
    }
}
