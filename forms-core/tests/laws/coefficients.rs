//! Random structured coefficients: polynomials, quotients, radicals, sines and cosines, unknown functions.

use super::scene::World;
use forms_core::expression::{Expr, Operation};
use num_rational::Ratio;
use proptest::prelude::*;

/// A number times a product of coordinates, by their numbers.
type Monomial = (i64, Vec<u8>);

/// Recipe of a random coefficient.
#[derive(Clone, Debug)]
pub(crate) enum Recipe {
    Polynomial(Vec<Monomial>),
    /// p/(1 + q²)
    Quotient(Vec<Monomial>, Monomial),
    /// p √(1 + Σ xᵢ²)
    Radical(Vec<Monomial>),
    /// m sin(Σ cᵢ xᵢ) or m cos(Σ cᵢ xᵢ)
    Wave(Monomial, bool, [i64; 2]),
    /// m f or m g for unknown f, g of all coordinates
    Unknown(Monomial, bool),
}

fn monomial() -> impl Strategy<Value = Monomial> {
    (prop_oneof![-3..=-1i64, 1..=3i64], prop::collection::vec(0..4u8, 0..=2))
}

fn polynomial() -> impl Strategy<Value = Vec<Monomial>> {
    prop::collection::vec(monomial(), 1..=3)
}

pub(crate) fn recipe() -> impl Strategy<Value = Recipe> {
    prop_oneof![
        3 => polynomial().prop_map(Recipe::Polynomial),
        1 => (polynomial(), monomial()).prop_map(|(p, q)| Recipe::Quotient(p, q)),
        1 => polynomial().prop_map(Recipe::Radical),
        1 => (monomial(), any::<bool>(), [-2..=2i64, 1..=2i64]).prop_map(|(m, s, c)| Recipe::Wave(m, s, c)),
        1 => (monomial(), any::<bool>()).prop_map(|(m, first)| Recipe::Unknown(m, first)),
    ]
}

/// Components of a map, chosen so that compositions with it stay small.
pub(crate) fn gentle() -> impl Strategy<Value = Recipe> {
    let monomial = (prop_oneof![Just(-1), 1..=2i64], prop::collection::vec(0..4u8, 1..=2));
    prop_oneof![
        2 => prop::collection::vec(monomial, 1..=2).prop_map(Recipe::Polynomial),
        1 => any::<bool>().prop_map(|is_sine| Recipe::Wave((1, vec![]), is_sine, [0, 1])),
    ]
}

/// Components of a linear map.
pub(crate) fn linear() -> impl Strategy<Value = Recipe> {
    let monomial = (prop_oneof![Just(-1), Just(1)], prop::collection::vec(0..4u8, 1));
    prop::collection::vec(monomial, 1..=2).prop_map(Recipe::Polynomial)
}

impl World {
    pub(crate) fn build(&mut self, recipe: &Recipe) -> Expr {
        match recipe {
            Recipe::Polynomial(p) => self.sum(p),
            Recipe::Quotient(p, q) => {
                let (above, q) = (self.sum(p), self.product(q));
                let (one, square) = (self.pool.integer(1), self.pool.power(q, 2.into()));
                let below = self.pool.add(one, square);
                self.pool.divide(above, below)
            }
            Recipe::Radical(p) => {
                let mut radicand = self.pool.integer(1);
                for symbol in self.symbols.clone() {
                    let x = self.pool.symbol(symbol);
                    let square = self.pool.power(x, 2.into());
                    radicand = self.pool.add(radicand, square);
                }
                let (root, p) = (self.pool.power(radicand, Ratio::new(1, 2)), self.sum(p));
                self.pool.multiply(p, root)
            }
            Recipe::Wave(m, is_sine, [c, d]) => {
                let angle = self.sum(&[(*c, vec![0]), (*d, vec![1])]);
                let operation = if *is_sine { Operation::Sin } else { Operation::Cos };
                let (wave, m) = (self.pool.apply(operation, &[angle]), self.product(m));
                self.pool.multiply(m, wave)
            }
            Recipe::Unknown(m, first) => {
                let (value, m) = (self.unknown(*first), self.product(m));
                self.pool.multiply(m, value)
            }
        }
    }

    fn sum(&mut self, monomials: &[Monomial]) -> Expr {
        let mut sum = self.pool.integer(0);
        for monomial in monomials {
            let term = self.product(monomial);
            sum = self.pool.add(sum, term);
        }
        sum
    }

    fn product(&mut self, (number, variables): &Monomial) -> Expr {
        let mut product = self.pool.integer(*number);
        for variable in variables {
            let x = self.variable(*variable);
            product = self.pool.multiply(product, x);
        }
        product
    }
}
