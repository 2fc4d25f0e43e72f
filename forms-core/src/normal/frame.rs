//! Frames: real variables written relative to others.
//!
//! ```text
//! s = s′ + Σ_f v_sf f      (every f = f′)      an automorphism of the polynomials over ℤ
//! ∂s′/∂f = −v_sf,  ∂s′/∂s = 1
//! ```
//! An expression that depends on corners and an observer through their differences alone does not
//! contain the observer in the frame that moves with the observer, so its polynomials have
//! correspondingly fewer variables. Nothing else changes: elements, their derivatives and the
//! expressions raised from them represent the same functions.

use super::drift::Drift;
use super::generator::Generator;
use super::tower::Tower;
use crate::expression::Symbol;
use crate::polynomial::Polynomial;

impl Tower {
    /// Returns the same tower with some variables written relative to others. A variable that moves
    /// is not one that others move with.
    #[must_use]
    pub fn in_frame(mut self, drifts: Vec<Drift>) -> Self {
        debug_assert!(drifts.iter().all(|a| drifts.iter().all(|b| a.moved != b.with)));
        self.frame = drifts;
        self
    }

    /// s = s′ + Σ v f
    pub(super) fn variable_in_frame(&mut self, symbol: Symbol) -> Polynomial {
        let drifts: Vec<Drift> = self.frame.iter().copied().filter(|drift| drift.moved == symbol).collect();
        let mut sum = Polynomial::variable(self.variable_of(Generator::Variable(symbol)));
        for drift in drifts {
            let with = Polynomial::variable(self.variable_of(Generator::Variable(drift.with)));
            sum = sum.add(&with.scale(&drift.speed.into()));
        }
        sum
    }

    /// Returns the variables s′ that a partial derivative with respect to a variable acts on, with
    /// ∂s′/∂f.
    pub(super) fn motion(&mut self, by: Symbol) -> Vec<(u32, i64)> {
        let drifts: Vec<Drift> = self.frame.iter().copied().filter(|drift| drift.with == by).collect();
        let mut motion = vec![(self.variable_of(Generator::Variable(by)), 1)];
        for drift in drifts {
            motion.push((self.variable_of(Generator::Variable(drift.moved)), -drift.speed));
        }
        motion
    }

    /// s′ = s − Σ v f
    pub(super) fn drifts_of(&self, symbol: Symbol) -> impl Iterator<Item = Drift> {
        self.frame.iter().copied().filter(move |drift| drift.moved == symbol)
    }
}

/// Σ ∂P/∂s′ ∂s′/∂f
pub(super) fn derivative_along(polynomial: &Polynomial, motion: &[(u32, i64)]) -> Polynomial {
    let mut sum = Polynomial::zero();
    for &(variable, speed) in motion {
        let partial = polynomial.derivative(variable);
        let partial = if speed == 1 { partial } else { partial.scale(&speed.into()) };
        sum = sum.add(&partial);
    }
    sum
}
