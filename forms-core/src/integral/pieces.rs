//! Integrands with absolute values: the range is split into pieces on which each absolute value has
//! one sign.
//!
//! ```text
//! |q| ─ zeros of q, exact ─▶ a ≤ r₁ ≤ … ≤ b ─ the sign between two zeros is that at their middle ─▶ ±q on each piece
//! ```
//! All zeros of q are known: it is a product of linear and quadratic polynomials and of c + k
//! sin(κx + δ) and c + k cos(κx + δ). So q has one sign between neighbouring zeros. An absolute
//! value that does not depend on the variable is a constant for the integral.

use super::known_sign::Strictness;
use super::range::Integral;
use super::signs::Region;
use super::{Failure, normal_form};
use crate::assume::is_at_most;
use crate::enclosure::{Precision, enclose_number};
use crate::expression::{Condition, Expr, Node, Operation, Pool, Relation, Symbol, SymbolKind};
use crate::normal::{Tower, Trigonometry};
use crate::polynomial::Polynomial;
use num_rational::Ratio;
use num_traits::ToPrimitive;
use rustc_hash::FxHashMap;
use std::cmp::Ordering;

/// Limit on the number of zeros of one function.
const MOST_ZEROS: i64 = 64;

/// Precision in bits of the comparison of places.
const PRECISION: Precision = Precision(128);

/// A magnitude as it is written, and its argument.
type Magnitude = (Expr, Expr);

impl Region {
    /// Returns the integral over the innermost range if magnitudes with open signs occur; `None` if
    /// none occur.
    pub(super) fn by_pieces(&self, pool: &mut Pool, integrand: Expr) -> Result<Option<Integral>, String> {
        let Some((&(variable, from, to), outer)) = self.ranges.split_last() else { return Ok(None) };
        let (moving, still): (Vec<Magnitude>, Vec<Magnitude>) = magnitudes(pool, integrand)
            .into_iter()
            .filter(|magnitude| magnitudes(pool, magnitude.1).is_empty())
            .partition(|magnitude| pool.symbols_in(&[magnitude.1]).contains(&variable));
        if !still.is_empty() {
            return self.with_constants(pool, integrand, &still).map(Some);
        }
        if moving.is_empty() {
            return Ok(None);
        }
        match self.order(pool, from, to) {
            Some(Ordering::Less | Ordering::Equal) => {}
            Some(Ordering::Greater) => {
                let mut ranges = outer.to_vec();
                ranges.push((variable, to, from));
                let back = Region { ranges, conditions: self.conditions.clone() };
                let found = back.by_pieces(pool, integrand)?;
                return Ok(found.map(|found| Integral { value: pool.negate(found.value), ..found }));
            }
            None => return Err(not_ordered(pool, from, to)),
        }
        let mut places = vec![from, to];
        for (_, inner) in &moving {
            let zeros = self.zeros(pool, *inner).map_err(|failure| failure.0)?;
            for zero in zeros {
                self.insert(pool, &mut places, zero)?;
            }
        }
        let mut total = Integral { value: pool.integer(0), conditions: vec![], antiderivative: None };
        for ends in places.windows(2) {
            let part = self.piece(pool, integrand, &moving, (ends[0], ends[1]))?;
            total.value = pool.add(total.value, part.value);
            total.conditions.extend(part.conditions);
        }
        Ok(Some(total))
    }

    /// Returns the integral with the magnitudes that do not depend on the variable replaced by
    /// nonnegative constants.
    fn with_constants(
        &self,
        pool: &mut Pool,
        integrand: Expr,
        still: &[Magnitude],
    ) -> Result<Integral, String> {
        let (mut images, mut back) = (FxHashMap::default(), FxHashMap::default());
        let mut conditions = self.conditions.clone();
        for (written, _) in still {
            let symbol = pool.declare_symbol("c", SymbolKind::Local);
            let (left, right) = (pool.symbol(symbol), pool.integer(0));
            conditions.push(Condition { left, relation: Relation::GreaterEqual, right });
            images.insert(*written, left);
            back.insert(symbol, *written);
        }
        let replaced = pool.replace(integrand, &images);
        let found = Region { ranges: self.ranges.clone(), conditions }.integral(pool, replaced)?;
        let conditions = found.conditions.iter().map(|condition| condition.substitute(pool, &back)).collect();
        let value = pool.substitute(found.value, &back);
        Ok(Integral { value, conditions, antiderivative: None })
    }

    /// Returns the integral between two neighbouring zeros, with the sign of every magnitude there.
    fn piece(
        &self,
        pool: &mut Pool,
        integrand: Expr,
        moving: &[Magnitude],
        (from, to): (Expr, Expr),
    ) -> Result<Integral, String> {
        let Some((&(variable, ..), outer)) = self.ranges.split_last() else {
            return Err("there is no range".into());
        };
        let (half, sum) = (pool.ratio(1, 2), pool.add(from, to));
        let middle = pool.multiply(half, sum);
        let x = pool.symbol(variable);
        let mut conditions = self.conditions.clone();
        conditions.push(Condition { left: x, relation: Relation::GreaterEqual, right: from });
        conditions.push(Condition { left: x, relation: Relation::LessEqual, right: to });
        let zero = pool.integer(0);
        let mut images = FxHashMap::default();
        for &(written, inner) in moving {
            let at_middle = pool.substitute(inner, &[(variable, middle)].into_iter().collect());
            let sign = self.order(pool, at_middle, zero).ok_or_else(|| {
                format!("the sign of `{}` is not known on the whole range", pool.text(inner))
            })?;
            let image = if sign == Ordering::Less { pool.negate(inner) } else { inner };
            images.insert(written, image);
            let relation = if sign == Ordering::Less { Relation::LessEqual } else { Relation::GreaterEqual };
            conditions.push(Condition { left: inner, relation, right: zero });
        }
        let signed = pool.replace(integrand, &images);
        let mut ranges = outer.to_vec();
        ranges.push((variable, from, to));
        Region { ranges, conditions }.integral(pool, signed)
    }

    /// Inserts a place between the ends in order, unless it lies outside.
    fn insert(&self, pool: &mut Pool, places: &mut Vec<Expr>, place: Expr) -> Result<(), String> {
        for number in 0..places.len() {
            match self.order(pool, place, places[number]) {
                Some(Ordering::Equal) => return Ok(()),
                Some(Ordering::Less) => {
                    if number > 0 {
                        places.insert(number, place);
                    }
                    return Ok(());
                }
                Some(Ordering::Greater) => {}
                None => return Err(not_ordered(pool, place, places[number])),
            }
        }
        Ok(())
    }

    /// Compares two numbers wherever the conditions hold; less and greater do not exclude equality.
    fn order(&self, pool: &mut Pool, a: Expr, b: Expr) -> Option<Ordering> {
        let difference = pool.subtract(a, b);
        let mut tower = Tower::new(Trigonometry::Circle);
        let known = normal_form(pool, &mut tower, difference, &self.conditions);
        if known.is_ok_and(|normal| normal.is_zero()) {
            return Some(Ordering::Equal);
        }
        if pool.symbols_in(&[difference]).is_empty() {
            let value = enclose_number(pool, difference, PRECISION).ok()?;
            return match (value.is_positive(), value.is_negative()) {
                (true, _) => Some(Ordering::Greater),
                (_, true) => Some(Ordering::Less),
                _ => None,
            };
        }
        if is_at_most(pool, a, b, &self.conditions) {
            return Some(Ordering::Less);
        }
        if is_at_most(pool, b, a, &self.conditions) {
            return Some(Ordering::Greater);
        }
        let sign = self.sign(pool, difference)?;
        Some(if sign.0 { Ordering::Greater } else { Ordering::Less })
    }

    /// Returns all zeros of a function of the innermost variable over its range.
    fn zeros(&self, pool: &mut Pool, function: Expr) -> Result<Vec<Expr>, Failure> {
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

fn not_ordered(pool: &Pool, a: Expr, b: Expr) -> String {
    format!("it is not known which of `{}` and `{}` is larger", pool.text(a), pool.text(b))
}

/// Returns |q| and √(q²) in an expression, inner ones before outer ones.
fn magnitudes(pool: &Pool, expression: Expr) -> Vec<Magnitude> {
    let magnitude = |part: Expr| match pool.node(part) {
        Node::Apply(Operation::Abs, q) => Some((part, q[0])),
        Node::Power(square, exponent) if *exponent == Ratio::new(1, 2) => match pool.node(*square) {
            Node::Power(q, inner) if *inner == Ratio::from_integer(2) => Some((part, *q)),
            _ => None,
        },
        _ => None,
    };
    pool.reachable(&[expression]).into_iter().filter_map(magnitude).collect()
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
