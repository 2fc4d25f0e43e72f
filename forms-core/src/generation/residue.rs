//! Residues: values of fractions in roots of variables, modulo a prime. Different residues prove
//! that two fractions differ.
//!
//! A variable is assigned the twelfth power of a fixed field element, so that its roots up to the
//! fourth and the sixth are field elements too and multiply as they should. Equal fractions have
//! equal residues; a difference of residues is therefore certain, an agreement is not.

use crate::expression::{Expr, Node, Pool, Rational, Symbol};
use crate::polynomial::modular::{add, from_integer, inverse, mul, neg, pow, reduce};
use num_rational::Ratio;
use rustc_hash::FxHashMap;

/// Power of the field element that a variable is assigned.
const POWER: i64 = 12;

/// Residue assigned to π.
const PI: u64 = 314_159_265_358_979;

/// Residues of expressions met so far; `None` if a residue is undefined or the operation has no
/// residue.
#[derive(Default)]
pub(super) struct Residues(FxHashMap<Expr, Option<u64>>);

impl Residues {
    /// Returns the residue of an expression.
    pub(super) fn of(&mut self, pool: &Pool, expression: Expr) -> Option<u64> {
        if let Some(known) = self.0.get(&expression) {
            return *known;
        }
        self.extend(pool, &pool.reachable(&[expression]));
        self.0[&expression]
    }

    /// Computes the residues of expressions that are listed after their operands.
    pub(super) fn extend(&mut self, pool: &Pool, expressions: &[Expr]) {
        for &part in expressions {
            if !self.0.contains_key(&part) {
                let residue = self.of_node(pool, pool.node(part));
                self.0.insert(part, residue);
            }
        }
    }

    /// Replaces the residue of an expression by a given one.
    pub(super) fn set(&mut self, expression: Expr, residue: Option<u64>) {
        self.0.insert(expression, residue);
    }

    fn of_node(&self, pool: &Pool, node: &Node) -> Option<u64> {
        let of = |part: &Expr| self.0[part];
        match node {
            Node::Number(value) => of_number(value),
            Node::Pi => Some(PI),
            Node::Symbol(symbol) => Some(pow(element(*symbol), POWER as u64)),
            Node::Add(a, b) => Some(add(of(a)?, of(b)?)),
            Node::Negate(a) => Some(neg(of(a)?)),
            Node::Multiply(a, b) => Some(mul(of(a)?, of(b)?)),
            Node::Divide(a, b) => Some(mul(of(a)?, inverse(of(b)?)?)),
            Node::Power(base, exponent) if exponent.is_integer() => of_power(of(base)?, *exponent.numer()),
            Node::Power(base, exponent) => match pool.node(*base) {
                Node::Symbol(symbol) => {
                    let power = exponent * Ratio::from_integer(POWER);
                    power.is_integer().then(|| of_power(element(*symbol), *power.numer()))?
                }
                _ => None,
            },
            _ => None,
        }
    }
}

/// Returns the field element whose power a variable is assigned.
fn element(symbol: Symbol) -> u64 {
    reduce((u64::from(symbol.0) + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 4)
}

fn of_number(value: &Rational) -> Option<u64> {
    Some(mul(from_integer(value.numer()), inverse(from_integer(value.denom()))?))
}

fn of_power(base: u64, exponent: i64) -> Option<u64> {
    let power = pow(base, exponent.unsigned_abs());
    if exponent < 0 { inverse(power) } else { Some(power) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;

    fn residues(values: &str) -> Vec<Option<u64>> {
        let (theory, errors) = read_theory(&format!("kernel f(x, y) = ({values});"));
        assert!(errors.is_empty(), "{errors:?}");
        let mut residues = Residues::default();
        theory.kernels[0].outputs.iter().map(|&output| residues.of(&theory.pool, output)).collect()
    }

    #[test]
    fn equal_fractions_have_one_residue() {
        let found = residues("(x**2 - y**2)/(x - y), x + y, x - y, x*sqrt(y)*sqrt(y)/3, x*y/3");
        assert!(found[0].is_some() && found[0] == found[1]);
        assert!(found[1] != found[2]);
        assert!(found[3].is_some() && found[3] == found[4]);
    }

    #[test]
    fn functions_have_none() {
        assert_eq!(residues("sin(x) + y, x/exp(y)"), [None, None]);
    }
}
