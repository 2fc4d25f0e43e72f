//! True values of expressions at exact points, certain to the requested digits.
//!
//! The expressions are enclosed at rising precision until every number of an enclosure is rounded
//! to the same value. An enclosure of a number on the boundary of two roundings never decides: such
//! a number, for example exactly zero, is known if the arithmetic of short rationals gives it, or
//! if it is proved.

use super::format::{Format, Rounded};
use crate::decide::{Budget, Equations, Finding};
use crate::enclosure::{Enclosure, Precision, Undecided, enclose_of_kernel};
use crate::expression::{Condition, Expr, Node, Pool, Rational, Substitution, Symbol};
use num_bigint::BigInt;
use num_traits::Zero;

/// The binary places that are tried, one after the other. The last one holds the square of the
/// least `f64` to 53 bits.
const PRECISIONS: [u32; 9] = [112, 208, 296, 592, 1200, 2500, 5000, 10_000, 20_000];

/// Precision at which a proof is tried that a value that is not yet certain is exactly the number
/// its enclosure suggests.
const PROVED_FROM: u32 = 2500;

/// Highest precision at which conditions are decided.
const DECIDED_TO: u32 = 592;

/// Highest precision for integrals: they are known to some sixty digits, and more places do not
/// improve them.
const INTEGRALS_TO: u32 = 592;

/// Budget for such a proof.
const EFFORT: Budget = Budget { work: 20_000, candidates: 2, points: 1 };

/// Known value of an expression at a point.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// The value, rounded.
    Known(Rounded),
    /// The point is outside the domain.
    Undefined,
    /// An intermediate result is beyond 2^16384, which is not computed.
    TooLarge,
    /// Nothing is certain at the highest precision that is tried.
    Undecided,
}

/// Expressions to evaluate where conditions hold.
pub struct Truth<'a> {
    pool: &'a Pool,
    outputs: usize,
    /// The outputs, then both sides of each condition.
    expressions: Vec<Expr>,
    conditions: &'a [Condition],
    /// The highest precision that is tried.
    highest: u32,
}

impl<'a> Truth<'a> {
    /// Creates the evaluation of these expressions of one pool where these conditions hold.
    pub fn new(pool: &'a Pool, outputs: &[Expr], conditions: &'a [Condition]) -> Self {
        let sides = conditions.iter().flat_map(|condition| [condition.left, condition.right]);
        let expressions = outputs.iter().copied().chain(sides).collect();
        let has_integral = |part: Expr| matches!(pool.node(part), Node::Jet { .. });
        let has_integrals = pool.reachable(outputs).into_iter().any(has_integral);
        let highest = if has_integrals { INTEGRALS_TO } else { u32::MAX };
        Truth { pool, outputs: outputs.len(), expressions, conditions, highest }
    }

    /// Limits the precision: a value is undecided if it needs more than `places` binary places.
    #[must_use]
    pub fn up_to(self, places: u32) -> Self {
        Truth { highest: places.min(self.highest), ..self }
    }

    /// Returns the values at a point, correctly rounded.
    pub fn at(&self, point: &[(Symbol, Rational)], format: Format) -> Vec<Value> {
        let mut values = vec![None; self.outputs];
        let mut inside = self.conditions.is_empty();
        for precision in PRECISIONS.into_iter().take_while(|&places| places <= self.highest).map(Precision) {
            let enclosures = self.enclosures(point, precision);
            if !inside {
                match self.is_inside(&enclosures) {
                    Some(true) => inside = true,
                    Some(false) => return vec![Value::Undefined; self.outputs],
                    None => {}
                }
            }
            for (place, value) in values.iter_mut().enumerate().filter(|(_, value)| value.is_none()) {
                *value = match &enclosures[place] {
                    Err(Undecided::Undefined) => Some(Value::Undefined),
                    Err(Undecided::TooLarge) => Some(Value::TooLarge),
                    Err(Undecided::Unknown) => None,
                    Ok(enclosure) => {
                        let rounded = format.round(enclosure);
                        let proved = || self.proved(place, point, enclosure, format);
                        rounded.or_else(proved).map(Value::Known)
                    }
                };
            }
            if inside && values.iter().all(Option::is_some) {
                break;
            }
        }
        let known =
            |value: Option<Value>| if inside { value.unwrap_or(Value::Undecided) } else { Value::Undecided };
        values.into_iter().map(known).collect()
    }

    /// Whether the point meets every condition; `None` if that is not certain.
    pub fn admits(&self, point: &[(Symbol, Rational)]) -> Option<bool> {
        if self.conditions.is_empty() {
            return Some(true);
        }
        let sides = Truth { outputs: 0, expressions: self.expressions[self.outputs..].to_vec(), ..*self };
        PRECISIONS
            .iter()
            .take_while(|&&places| places <= DECIDED_TO)
            .find_map(|&places| sides.is_inside(&sides.enclosures(point, Precision(places))))
    }

    /// Returns enclosures of all expressions at a point.
    fn enclosures(
        &self,
        point: &[(Symbol, Rational)],
        precision: Precision,
    ) -> Vec<Result<Enclosure, Undecided>> {
        let value = |symbol: Symbol| {
            let known = point.iter().find(|(known, _)| *known == symbol)?;
            Some(Enclosure::exact(&known.1, precision))
        };
        enclose_of_kernel(self.pool, &self.expressions, &value, precision)
    }

    /// Whether every condition holds; a condition with an undefined side fails.
    fn is_inside(&self, enclosures: &[Result<Enclosure, Undecided>]) -> Option<bool> {
        let sides = enclosures[self.outputs..].chunks_exact(2);
        let mut all = Some(true);
        for (condition, pair) in self.conditions.iter().zip(sides) {
            let holds = match (&pair[0], &pair[1]) {
                (Ok(left), Ok(right)) => left.decide(condition.relation, right),
                (Err(Undecided::Undefined), _) | (_, Err(Undecided::Undefined)) => Some(false),
                _ => None,
            };
            match holds {
                Some(false) => return Some(false),
                None => all = None,
                Some(true) => {}
            }
        }
        all
    }

    /// Returns the value in an enclosure, if a proof shows that it is the shortest number in it.
    fn proved(
        &self,
        place: usize,
        point: &[(Symbol, Rational)],
        enclosure: &Enclosure,
        format: Format,
    ) -> Option<Rounded> {
        if enclosure.precision().0 != PROVED_FROM {
            return None;
        }
        let candidate = shortest(enclosure)?;
        let mut pool = self.pool.clone();
        let values: Substitution =
            point.iter().map(|(symbol, value)| (*symbol, pool.number(value.clone()))).collect();
        let value = pool.substitute(self.expressions[place], &values);
        let expected = pool.number(candidate.clone());
        let equation = Equations { sides: &[(value, expected)], conditions: &[] };
        match equation.decide(&mut pool, EFFORT) {
            Finding::Equal { .. } => format.round(&Enclosure::exact(&candidate, enclosure.precision())),
            _ => None,
        }
    }
}

/// Returns zero, or the number with the fewest binary digits, if an enclosure contains one with
/// less than half its places.
fn shortest(enclosure: &Enclosure) -> Option<Rational> {
    if enclosure.contains_zero() {
        return Some(Rational::zero());
    }
    let middle = (enclosure.lower() + enclosure.upper()) / Rational::from_integer(2.into());
    let scale = Rational::from_integer(BigInt::from(1) << (enclosure.precision().0 / 2));
    let candidate = (middle * &scale).round() / scale;
    enclosure.contains(&candidate).then_some(candidate)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;

    fn values(source: &str, arguments: &[&str], format: Format) -> Vec<Value> {
        let (theory, errors) = read_theory(source);
        assert!(errors.is_empty(), "{errors:?}");
        let kernel = &theory.kernels[0];
        let truth = Truth::new(&theory.pool, &kernel.outputs, &kernel.domain);
        let numbers = arguments.iter().map(|text| text.parse().expect("a fraction"));
        let point: Vec<(Symbol, Rational)> = kernel.arguments.iter().copied().zip(numbers).collect();
        truth.at(&point, format)
    }

    fn digits(source: &str, arguments: &[&str]) -> String {
        match values(source, arguments, Format::Digits(20)).remove(0) {
            Value::Known(Rounded::Digits(digits)) => digits,
            other => format!("{other:?}"),
        }
    }

    #[test]
    fn cancellation_costs_precision_and_no_digits() {
        let source = "kernel k(x) = (1 - cos(x))/x**2;";
        assert_eq!(digits(source, &["1/1000000000000000000000000000000"]), "5.0000000000000000000e-1");
        let source = "kernel k(x) = sqrt(x + 1) - sqrt(x);";
        assert_eq!(digits(source, &["100000000000000000000000000000000000000"]), "5.0000000000000000000e-20");
    }

    #[test]
    fn numbers_on_the_boundary_of_two_roundings_are_proved() {
        assert_eq!(digits("kernel k(x) = sqrt(x)*sqrt(x) - x;", &["2"]), "0");
        assert_eq!(digits("kernel k(x) = sqrt(x)*sqrt(x);", &["3"]), "3.0000000000000000000e0");
        assert_eq!(digits("kernel k(x) = sin(x)**2 + cos(x)**2;", &["1/7"]), "1.0000000000000000000e0");
        assert_eq!(digits("kernel k(x) = sqrt(3 + 2*sqrt(x)) - sqrt(x) - 1;", &["2"]), "0");
    }

    #[test]
    fn outside_the_domain_there_is_no_value() {
        for (source, argument) in [
            ("kernel k(x) = x where x > 1;", "1"),
            ("kernel k(x) = 1/x;", "0"),
            ("kernel k(x) = log(x);", "-1"),
            ("kernel k(x) = sqrt(x - 1);", "1/2"),
        ] {
            assert_eq!(values(source, &[argument], Format::Double), [Value::Undefined], "{source}");
        }
    }

    #[test]
    fn the_ends_of_the_range_of_f64_are_reached() {
        let tiny = "kernel k(x) = x**2*exp(x)/x;";
        let least = format!("1/{}", BigInt::from(2).pow(1074));
        let expected = [Value::Known(Rounded::Double(f64::from_bits(1)))];
        assert_eq!(values(tiny, &[&least], Format::Double), expected);
        let overflow = [Value::Known(Rounded::Double(f64::INFINITY))];
        assert_eq!(values("kernel k(x) = exp(x);", &["1000"], Format::Double), overflow);
    }
}
