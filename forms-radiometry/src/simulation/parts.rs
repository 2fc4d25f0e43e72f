//! Parts of an error: what each step of the work leaves adds up to the error of its answer.
//!
//! ```text
//! plan ─ effects ─┐
//! equations, expansions ─ orders ─┤
//! elements, rules, shapes ─ quadrature ─┼─▶ bound: ε = ρ + q + o + e + s          σ: ε = √((ρ + q + o + e)² + s²)
//! arithmetic ─ rounding ─┤
//! rays and paths ─ sampling ─┘
//! ```
//! Each part is set where it is known, and nowhere else. What the file turns off, or asks only some orders of, is another question, and no
//! part of the error.

use super::answer::ErrorKind;
use serde::{Deserialize, Serialize};
use std::ops::Add;

/// What an error is made of, each part in the unit of the answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ErrorParts {
    /// What the arithmetic of `f64` may have lost.
    pub rounding: f64,
    /// What elements, rules of integration, and polyhedra in the place of round shapes leave.
    pub quadrature: f64,
    /// What higher orders of reflections may add, of which the solver took no more as they were too small.
    pub orders: f64,
    /// What effects may change that the plan left out because they matter less than the tolerance.
    pub effects: f64,
    /// How far the mean of rays or paths may be off; of an error that is a standard error, that of them.
    pub sampling: f64,
}

impl ErrorParts {
    /// Their names, in words.
    pub const NAMES: [&str; 5] =
        ["rounding", "quadrature", "truncated orders", "dropped effects", "sampling"];

    /// Them in the order of their names.
    pub fn all(&self) -> [f64; 5] {
        [self.rounding, self.quadrature, self.orders, self.effects, self.sampling]
    }

    /// The error that they make. Bounds add up; of a standard error, what is no chance is taken for one of the same size.
    pub fn error(&self, kind: ErrorKind) -> f64 {
        let certain = self.rounding + self.quadrature + self.orders + self.effects;
        match kind {
            ErrorKind::Bound | ErrorKind::Estimate | ErrorKind::Confidence => certain + self.sampling,
            ErrorKind::Sigma => self.sampling.hypot(certain),
        }
    }

    /// Each multiplied by the same factor.
    pub(super) fn scaled(self, factor: f64) -> Self {
        Self {
            rounding: factor * self.rounding,
            quadrature: factor * self.quadrature,
            orders: factor * self.orders,
            effects: factor * self.effects,
            sampling: factor * self.sampling,
        }
    }

    /// Those of a mean: what is sampled averages out, but for this part of it, which all numbers have in common; nothing else does.
    pub(super) fn of_mean(all: impl Iterator<Item = Self>, common: f64) -> Self {
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
