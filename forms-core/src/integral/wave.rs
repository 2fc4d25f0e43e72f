//! Signs of sines and cosines over the range, from the ranges of their angles.

use super::known_sign::{KnownSign, Strictness};
use super::signs::Region;
use crate::assume::range_of;
use crate::expression::{Expr, Node, Operation, Pool};

impl Region {
    /// Returns the sign of a product that contains a sine or cosine, if the signs of all factors
    /// are known.
    pub(super) fn sign_of_waves(&self, pool: &mut Pool, q: Expr) -> Option<KnownSign> {
        match *pool.node(q) {
            Node::Apply(operation @ (Operation::Sin | Operation::Cos), ref arguments) => {
                let angle = arguments[0];
                let range = range_of(pool, angle, &self.conditions);
                let (positive, strict) = match operation {
                    Operation::Sin => range.sign_of_sine()?,
                    _ => range.sign_of_cosine()?,
                };
                Some((positive, if strict { Strictness::Strict } else { Strictness::Weak }))
            }
            Node::Negate(a) => self.sign_of_waves(pool, a).map(|(positive, strict)| (!positive, strict)),
            Node::Multiply(a, b) | Node::Divide(a, b) => {
                let (first, second) = match self.sign_of_waves(pool, a) {
                    Some(sign) => (sign, self.sign(pool, b)?),
                    None => (self.sign_of_waves(pool, b)?, self.sign(pool, a)?),
                };
                Some((first.0 == second.0, first.1.min(second.1)))
            }
            Node::Power(a, exponent) if exponent.is_integer() && exponent.numer() % 2 != 0 => {
                self.sign_of_waves(pool, a)
            }
            _ => None,
        }
    }
}
