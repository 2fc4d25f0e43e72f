//! Zeros of functions of one variable over a range: products of linear and quadratic polynomials
//! and of c + k sin(κx + δ) and c + k cos(κx + δ) have exact ones.
//!
//! ```text
//! q ─ factors ─┬─ polynomial of degree 1 or 2 ─▶ −β/α, (−β ± √(β² − 4αγ))/2α
//!              └─ one sine or cosine ──────────▶ (± arc + 2πk − δ)/κ within the range
//! ```

use super::known_sign::Strictness;
use super::signs::Region;
use super::{Failure, normal_form};
use crate::enclosure::{Precision, enclose_number};
use crate::expression::{Expr, Node, Operation, Pool, Symbol, SymbolKind};
use crate::normal::{Tower, Trigonometry};
use crate::polynomial::Polynomial;
use num_traits::ToPrimitive;
use rustc_hash::FxHashMap;
use std::cmp::Ordering;

/// Limit on the number of zeros of one function.
const MOST_ZEROS: i64 = 64;

/// Precision in bits of the number of periods in a range.
const PRECISION: Precision = Precision(128);

impl Region {
    /// Returns all zeros of a function of the innermost variable over its range.
    pub(super) fn zeros(&self, pool: &mut Pool, function: Expr) -> Result<Vec<Expr>, Failure> {
        let Some(&(variable, ..)) = self.ranges.last() else { return Ok(vec![]) };
        if !pool.symbols_in(&[function]).contains(&variable) || self.sign(pool, function).is_some() {
            return Ok(vec![]);
        }
        match *pool.node(function) {
            Node::Multiply(a, b) | Node::Divide(a, b) => {
                let mut zeros = self.zeros(pool, a)?;
                zeros.extend(self.zeros(pool, b)?);
                Ok(zeros)
            }
            Node::Negate(a) | Node::Power(a, _) => self.zeros(pool, a),
            _ => match self.zeros_of_polynomial(pool, function, variable)? {
                Some(zeros) => Ok(zeros),
                None => self.zeros_of_wave(pool, function, variable),
            },
        }
    }

    /// Returns the zeros of the factors of a rational function; `None` if the function is not
    /// rational.
    fn zeros_of_polynomial(
        &self,
        pool: &mut Pool,
        function: Expr,
        variable: Symbol,
    ) -> Result<Option<Vec<Expr>>, Failure> {
        let mut tower = Tower::new(Trigonometry::Circle);
        let normal = normal_form(pool, &mut tower, function, &self.conditions)?;
        let x = tower.variable_number(variable);
        if tower.generators_in(&normal, variable) != [x] {
            return Ok(None);
        }
        let below = tower.factors_of(&normal).into_iter().map(|(polynomial, _)| polynomial.clone());
        let above = normal.numerator().square_free().1.into_iter().map(|(polynomial, _)| polynomial);
        let factors: Vec<Polynomial> = below.chain(above).filter(|factor| factor.contains(x)).collect();
        let mut zeros = Vec::new();
        for factor in factors {
            let polynomial = tower.rational_function(&factor.into(), x)?.numerator;
            let degree = polynomial.degree();
            let coefficients: Vec<Expr> =
                (0..=degree).map(|k| tower.raise(pool, &polynomial.coefficient(k))).collect();
            zeros.extend(self.zeros_of_coefficients(pool, function, &coefficients)?);
        }
        Ok(Some(zeros))
    }

    /// −β/α for αx + β, (−β ± √(β² − 4αγ))/2α for αx² + βx + γ
    fn zeros_of_coefficients(
        &self,
        pool: &mut Pool,
        function: Expr,
        coefficients: &[Expr],
    ) -> Result<Vec<Expr>, Failure> {
        if let Some(&leading) = coefficients.last() {
            self.nonzero(pool, leading)?;
        }
        match *coefficients {
            [b, a] => {
                let quotient = pool.divide(b, a);
                Ok(vec![pool.negate(quotient)])
            }
            [c, b, a] => self.zeros_of_quadratic(pool, [a, b, c]),
            _ => Err(self.signs_of(pool, function)),
        }
    }

    fn zeros_of_quadratic(&self, pool: &mut Pool, [a, b, c]: [Expr; 3]) -> Result<Vec<Expr>, Failure> {
        let (square, product) = (pool.power(b, 2.into()), pool.multiply(a, c));
        let four = pool.integer(4);
        let product = pool.multiply(four, product);
        let discriminant = pool.subtract(square, product);
        let zero = pool.integer(0);
        match self.order(pool, discriminant, zero) {
            Some(Ordering::Less) => return Ok(vec![]),
            Some(_) => {}
            None => return Err(self.signs_of(pool, discriminant)),
        }
        let root = pool.sqrt(discriminant);
        let twice = pool.add(a, a);
        let mut zeros = Vec::new();
        for sign in [1, -1] {
            let sign = pool.integer(sign);
            let signed = pool.multiply(sign, root);
            let above = pool.subtract(signed, b);
            zeros.push(pool.divide(above, twice));
        }
        Ok(zeros)
    }

    /// κx + δ = ± acos ρ + 2πk for cos, asin ρ + 2πk and π − asin ρ + 2πk for sin, with ρ = −c/k.
    fn zeros_of_wave(&self, pool: &mut Pool, function: Expr, variable: Symbol) -> Result<Vec<Expr>, Failure> {
        let fails = |pool: &mut Pool| self.signs_of(pool, function);
        let Some((operation, angle)) = only_wave(pool, function, variable) else { return Err(fails(pool)) };
        let place = pool.declare_symbol("y", SymbolKind::Local);
        let wave = pool.apply(operation, &[angle]);
        let images: FxHashMap<Expr, Expr> = [(wave, pool.symbol(place))].into_iter().collect();
        let linear = pool.replace(function, &images);
        if pool.symbols_in(&[linear]).contains(&variable) {
            return Err(fails(pool));
        }
        let Some([offset, slope]) = self.linear(pool, linear, place)? else { return Err(fails(pool)) };
        let quotient = pool.divide(offset, slope);
        let level = pool.negate(quotient);
        let (one, minus_one) = (pool.integer(1), pool.integer(-1));
        let is_between = self.order(pool, level, one).is_some_and(|order| order != Ordering::Greater)
            && self.order(pool, level, minus_one).is_some_and(|order| order != Ordering::Less);
        if !is_between {
            return Err(fails(pool));
        }
        let arc = pool.apply(Operation::Asin, &[level]);
        let arc = self.value_at(pool, arc, variable, one);
        let (pi, half) = (pool.pi(), pool.ratio(1, 2));
        let quarter = pool.multiply(half, pi);
        let first = match operation {
            Operation::Sin => [arc, pool.subtract(pi, arc)],
            _ => {
                let turn = pool.subtract(quarter, arc);
                [turn, pool.negate(turn)]
            }
        };
        let Some([phase, frequency]) = self.linear(pool, angle, variable)? else { return Err(fails(pool)) };
        self.repeated(pool, first, phase, frequency).ok_or_else(|| fails(pool))
    }

    /// Returns (α + 2πk − δ)/κ over the range, for the angles α.
    fn repeated(
        &self,
        pool: &mut Pool,
        angles: [Expr; 2],
        phase: Expr,
        frequency: Expr,
    ) -> Option<Vec<Expr>> {
        let &(_, from, to) = self.ranges.last()?;
        let two = pool.integer(2);
        let pi = pool.pi();
        let turn = pool.multiply(two, pi);
        let mut zeros = Vec::new();
        for angle in angles {
            let mut turns = Vec::new();
            for end in [from, to] {
                let scaled = pool.multiply(frequency, end);
                let moved = pool.add(scaled, phase);
                let rest = pool.subtract(moved, angle);
                let count = pool.divide(rest, turn);
                let value = enclose_number(pool, count, PRECISION).ok()?;
                turns.extend([value.lower().floor().to_i64()?, value.upper().ceil().to_i64()?]);
            }
            let (least, most) = (*turns.iter().min()?, *turns.iter().max()?);
            if most - least > MOST_ZEROS {
                return None;
            }
            for count in least..=most {
                let count = pool.integer(count);
                let turned = pool.multiply(count, turn);
                let whole = pool.add(angle, turned);
                let rest = pool.subtract(whole, phase);
                zeros.push(pool.divide(rest, frequency));
            }
        }
        Some(zeros)
    }

    /// Returns β and α of αx + β, if the function is linear and α is not zero.
    fn linear(&self, pool: &mut Pool, function: Expr, x: Symbol) -> Result<Option<[Expr; 2]>, Failure> {
        let mut tower = Tower::new(Trigonometry::Circle);
        let normal = normal_form(pool, &mut tower, function, &self.conditions)?;
        let number = tower.variable_number(x);
        if tower.generators_in(&normal, x) != [number] {
            return Ok(None);
        }
        let rational = tower.rational_function(&normal, number)?;
        if rational.numerator.degree() != 1 || !rational.denominator.is_empty() {
            return Ok(None);
        }
        let coefficients = [0, 1].map(|k| tower.raise(pool, &rational.numerator.coefficient(k)));
        self.nonzero(pool, coefficients[1])?;
        Ok(Some(coefficients))
    }

    fn nonzero(&self, pool: &mut Pool, number: Expr) -> Result<(), Failure> {
        let zero = pool.integer(0);
        let is_number = pool.symbols_in(&[number]).is_empty() && self.order(pool, number, zero).is_some();
        let strict = is_number || self.sign(pool, number).is_some_and(|sign| sign.1 == Strictness::Strict);
        if strict { Ok(()) } else { Err(self.signs_of(pool, number)) }
    }

    fn signs_of(&self, pool: &Pool, function: Expr) -> Failure {
        format!("it is not known where `{}` changes sign", pool.text(function)).into()
    }
}

/// Returns the sine or cosine that depends on the variable, if there is only one.
fn only_wave(pool: &Pool, function: Expr, variable: Symbol) -> Option<(Operation, Expr)> {
    let wave = |part: Expr| match pool.node(part) {
        Node::Apply(operation @ (Operation::Sin | Operation::Cos), q)
            if pool.symbols_in(q).contains(&variable) =>
        {
            Some((*operation, q[0]))
        }
        _ => None,
    };
    let mut waves = pool.reachable(&[function]).into_iter().filter_map(wave);
    let first = waves.next()?;
    waves.next().is_none().then_some(first)
}
