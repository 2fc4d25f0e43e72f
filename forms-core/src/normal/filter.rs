//! First tier: expressions evaluated modulo p = 2⁶¹ − 1 at random points of the tower.
//!
//! Evaluation is a homomorphism where no denominator vanishes, so a non-zero image shows that the
//! normal form is not zero, in a few operations per node. A zero image shows nothing; the exact
//! conversion decides.

use super::fraction::Fraction;
use super::generator::Generator;
use super::normalise::Normalised;
use super::tower::Tower;
use crate::expression::{Expr, Node, Pool, Rational};
use crate::polynomial::modular;
use crate::random::SplitMix;

/// Number of points that are tried to find one at which every radicand is a square.
const TRIES: u64 = 32;

impl Normalised {
    /// Returns which of the expressions certainly have a non-zero normal form. All are `false` if
    /// no usable point was found: in that case the filter does not help, but it is never wrong.
    pub fn certainly_not_zero(&self, tower: &Tower, pool: &Pool) -> Vec<bool> {
        let mut found = vec![false; self.roots().len()];
        let mut random = SplitMix(0x9e37_79b9_7f4a_7c15);
        let image = (0..TRIES).find_map(|_| self.images_at_a_point(tower, pool, &mut random));
        for (known, value) in found.iter_mut().zip(image.unwrap_or_default()) {
            *known = value != 0;
        }
        found
    }

    fn images_at_a_point(&self, tower: &Tower, pool: &Pool, random: &mut SplitMix) -> Option<Vec<u64>> {
        let point = point(tower, random)?;
        let mut images = Images(vec![0; self.order().last()?.0 as usize + 1]);
        for &expression in self.order() {
            let image = match tower.elements.get(&expression) {
                Some(atom) => image_of_fraction(tower, atom, &point)?,
                None => image_of_node(pool.node(expression), &images)?,
            };
            images.0[expression.0 as usize] = image;
        }
        Some(self.roots().iter().map(|&root| images.of(root)).collect())
    }
}

/// Images of expressions, by their numbers.
struct Images(Vec<u64>);

impl Images {
    fn of(&self, expression: Expr) -> u64 {
        self.0[expression.0 as usize]
    }
}

/// Returns values of the generators that satisfy every relation; `None` if a radicand is not a
/// square there, or if a chord occurs.
fn point(tower: &Tower, random: &mut SplitMix) -> Option<Vec<u64>> {
    let mut values = vec![0; tower.generators.list().len()];
    for number in 0..values.len() {
        let variable = number as u32;
        values[number] = match (tower.generator(variable), tower.relation_of(variable)) {
            (Generator::Root { .. }, Some(relation)) => {
                root(relation.value.evaluate_modular(&values), relation.order)?
            }
            (Generator::Chord { .. }, _) => return None,
            (Generator::Sine(_), _) => values[number],
            (Generator::Cosine(unit), _) => {
                let t = modular::reduce(random.next());
                let (cosine, sine) = on_the_circle(t)?;
                let partner = Generator::Sine(unit.clone());
                if let Some(place) = tower.generators.list().iter().position(|g| *g == partner) {
                    values[place] = sine;
                }
                cosine
            }
            _ => modular::reduce(random.next()),
        };
    }
    Some(values)
}

/// (1 − t²)/(1 + t²), 2t/(1 + t²)
fn on_the_circle(t: u64) -> Option<(u64, u64)> {
    let square = modular::mul(t, t);
    let inverse = modular::inverse(modular::add(1, square))?;
    Some((modular::mul(modular::sub(1, square), inverse), modular::mul(modular::add(t, t), inverse)))
}

/// Returns a root of order 2ᵏ, as repeated square roots.
fn root(value: u64, order: u32) -> Option<u64> {
    if !order.is_power_of_two() {
        return None;
    }
    let mut root = value;
    for _ in 0..order.trailing_zeros() {
        let half = modular::sqrt(root)?;
        root = if modular::sqrt(half).is_some() { half } else { modular::neg(half) };
    }
    Some(root)
}

fn image_of_fraction(tower: &Tower, fraction: &Fraction, point: &[u64]) -> Option<u64> {
    let mut denominator = modular::from_integer(&fraction.divisor);
    let mut numerator = fraction.numerator.evaluate_modular(point);
    for power in &fraction.factors {
        let value = tower.factor_polynomial(power.factor).evaluate_modular(point);
        let raised = modular::pow(value, u64::from(power.exponent.unsigned_abs()));
        let side = if power.exponent < 0 { &mut numerator } else { &mut denominator };
        *side = modular::mul(*side, raised);
    }
    if denominator == 1 {
        Some(numerator)
    } else {
        Some(modular::mul(numerator, modular::inverse(denominator)?))
    }
}

fn image_of_node(node: &Node, images: &Images) -> Option<u64> {
    match node {
        Node::Number(value) => image_of_number(value),
        Node::Add(a, b) => Some(modular::add(images.of(*a), images.of(*b))),
        Node::Negate(a) => Some(modular::neg(images.of(*a))),
        Node::Multiply(a, b) => Some(modular::mul(images.of(*a), images.of(*b))),
        Node::Divide(a, b) => Some(modular::mul(images.of(*a), modular::inverse(images.of(*b))?)),
        Node::Power(a, exponent) if exponent.is_integer() => {
            let power = modular::pow(images.of(*a), exponent.numer().unsigned_abs());
            if *exponent.numer() < 0 { modular::inverse(power) } else { Some(power) }
        }
        _ => None,
    }
}

fn image_of_number(value: &Rational) -> Option<u64> {
    let numerator = modular::from_integer(value.numer());
    if value.is_integer() {
        return Some(numerator);
    }
    Some(modular::mul(numerator, modular::inverse(modular::from_integer(value.denom()))?))
}
