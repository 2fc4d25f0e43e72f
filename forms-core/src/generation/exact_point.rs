//! Exact points: values of expressions at points whose coordinates are exact numbers, multiples of
//! π among them.
//!
//! ```text
//! expression ─ coordinates substituted, operands before results ─▶ a number, or the operation that has no value
//! ```
//! The sign of a number is certain if an enclosure shows it or the number is proved to be zero.
//! Points on strata are thus distinguished from points near them: 1 + cos π is 0 here. Only the
//! branch of a conditional that is taken is evaluated.

use crate::assume::vanishes;
use crate::decide::{Budget, Equations, Finding};
use crate::enclosure::{Precision, Undecided, enclose_number};
use crate::expression::{Condition, Expr, Node, Operation, Pool, Rational, Symbol};
use num_rational::Ratio;
use num_traits::{Signed, Zero};
use rustc_hash::FxHashMap;
use std::cmp::Ordering;

/// Precisions of the enclosures, tried in turn. A number that the first does not distinguish from
/// zero is proved to be zero or left to the others.
const PRECISIONS: [Precision; 3] = [Precision(80), Precision(256), Precision(1024)];

/// Budget for a proof that a number is zero.
const EFFORT: Budget = Budget { work: 20_000, candidates: 2, points: 1 };

/// Largest size in bits of an exact value that is shown in full.
const LONGEST_EXACT: u64 = 128;

/// Reason why an expression has no value at a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum NoValue {
    /// This operation of the expression is not defined there.
    Undefined(Expr),
    /// It is not known whether the expression is defined, or which branch is taken.
    Unknown,
}

/// A point: an exact number for each variable.
pub(super) type Point = FxHashMap<Symbol, Expr>;

/// Values of expressions at one point.
pub(super) struct ExactPoint<'a> {
    pool: &'a mut Pool,
    point: &'a Point,
    known: FxHashMap<Expr, Result<Expr, NoValue>>,
}

impl<'a> ExactPoint<'a> {
    pub(super) fn new(pool: &'a mut Pool, point: &'a Point) -> Self {
        ExactPoint { pool, point, known: FxHashMap::default() }
    }

    /// Evaluates an expression at the point; the value is an expression without variables.
    pub(super) fn value(&mut self, expression: Expr) -> Result<Expr, NoValue> {
        if let Some(known) = self.known.get(&expression) {
            return known.clone();
        }
        let found = self.of_node(expression);
        self.known.insert(expression, found.clone());
        found
    }

    /// Whether a condition holds.
    pub(super) fn holds(&mut self, condition: &Condition) -> Result<bool, NoValue> {
        let (left, right) = (self.value(condition.left)?, self.value(condition.right)?);
        let difference = self.pool.subtract(left, right);
        Ok(condition.relation.admits(self.sign(difference)?))
    }

    fn sign(&mut self, number: Expr) -> Result<Ordering, NoValue> {
        sign_of(self.pool, number).ok_or(NoValue::Unknown)
    }

    fn of_node(&mut self, expression: Expr) -> Result<Expr, NoValue> {
        let undefined = Err(NoValue::Undefined(expression));
        match self.pool.node(expression).clone() {
            Node::Number(_) | Node::Pi => Ok(expression),
            Node::Symbol(symbol) => self.point.get(&symbol).copied().ok_or(NoValue::Unknown),
            Node::Add(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                Ok(self.pool.add(a, b))
            }
            Node::Negate(a) => {
                let a = self.value(a)?;
                Ok(self.pool.negate(a))
            }
            Node::Multiply(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                Ok(self.pool.multiply(a, b))
            }
            Node::Divide(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                if self.sign(b)?.is_eq() {
                    return undefined;
                }
                Ok(self.pool.divide(a, b))
            }
            Node::Power(base, exponent) => {
                let base = self.value(base)?;
                let wanted = self.pool.power_domain(base, exponent);
                if let Some(condition) = wanted
                    && !condition.relation.admits(self.sign(condition.left)?)
                {
                    return undefined;
                }
                Ok(power(self.pool, base, exponent))
            }
            Node::Apply(operation, q) => {
                let q = q.iter().map(|&argument| self.value(argument)).collect::<Result<Vec<_>, _>>()?;
                if !self.is_defined(operation, &q)? {
                    return undefined;
                }
                if operation == Operation::Atan2 && self.is_on_the_cut(&q)? {
                    return Ok(self.pool.pi());
                }
                Ok(apply(self.pool, operation, &q))
            }
            Node::Select { left, relation, right, then, otherwise, .. } => {
                let holds = self.holds(&Condition { left, relation, right })?;
                self.value(if holds { then } else { otherwise })
            }
            Node::Jet { .. } => Err(NoValue::Unknown),
        }
    }

    /// Whether atan2 y x is π there: statements exclude its branch cut, kernels have a value on it.
    fn is_on_the_cut(&mut self, q: &[Expr]) -> Result<bool, NoValue> {
        Ok(self.sign(q[0])?.is_eq() && self.sign(q[1])?.is_lt())
    }

    fn is_defined(&mut self, operation: Operation, q: &[Expr]) -> Result<bool, NoValue> {
        if operation == Operation::Atan2 {
            return Ok(!self.sign(q[0])?.is_eq() || !self.sign(q[1])?.is_eq());
        }
        match self.pool.operation_domain(operation, q) {
            None => Ok(true),
            Some(condition) => Ok(condition.relation.admits(self.sign(condition.left)?)),
        }
    }
}

/// Returns a power of a number, exact if it is a square root of a square.
fn power(pool: &mut Pool, base: Expr, exponent: Ratio<i64>) -> Expr {
    let root = (*exponent.denom() == 2).then(|| pool.as_number(base).and_then(exact_root)).flatten();
    match root {
        Some(root) => {
            let root = pool.number(root);
            pool.power(root, Ratio::from_integer(*exponent.numer()))
        }
        None => pool.power(base, exponent),
    }
}

/// Returns √q if it is rational.
fn exact_root(value: &Rational) -> Option<Rational> {
    if value.is_negative() {
        return None;
    }
    let root = Rational::new(value.numer().sqrt(), value.denom().sqrt());
    (&root * &root == *value).then_some(root)
}

/// Returns the length of a right triangle's hypotenuse, or a cube root, if it is rational.
fn exact_radical(pool: &Pool, operation: Operation, q: &[Expr]) -> Option<Rational> {
    let numbers = q.iter().map(|&part| pool.as_number(part)).collect::<Option<Vec<_>>>()?;
    match (operation, numbers.as_slice()) {
        (Operation::Hypot, [x, y]) => exact_root(&(*x * *x + *y * *y)),
        (Operation::Cbrt, [x]) => {
            let root = Rational::new(x.numer().cbrt(), x.denom().cbrt());
            (&root * &root * &root == **x).then_some(root)
        }
        _ => None,
    }
}

/// Applies a function to numbers, with exact results at 0 and in other simple cases.
fn apply(pool: &mut Pool, operation: Operation, q: &[Expr]) -> Expr {
    use Operation::{Abs, Asin, Atan, Cos, Cosh, Erf, Erfc, Exp, Expm1, Log1p, Sin, Sinh, Tan, Tanh};
    if pool.is_zero(q[0]) {
        match operation {
            Sin | Tan | Asin | Atan | Sinh | Tanh | Expm1 | Log1p | Erf | Abs => return q[0],
            Cos | Cosh | Exp | Erfc => return pool.integer(1),
            _ => {}
        }
    }
    if let Some(root) = exact_radical(pool, operation, q) {
        return pool.number(root);
    }
    if operation == Abs
        && let Some(value) = pool.as_number(q[0]).map(Signed::abs)
    {
        return pool.number(value);
    }
    pool.apply(operation, q)
}

/// Compares a number with zero; `None` if the result is not certain.
pub(super) fn sign_of(pool: &mut Pool, number: Expr) -> Option<Ordering> {
    if let Some(value) = pool.as_number(number) {
        return Some(value.cmp(&Zero::zero()));
    }
    for precision in PRECISIONS {
        match enclose_number(pool, number, precision) {
            Ok(value) if value.is_positive() => return Some(Ordering::Greater),
            Ok(value) if value.is_negative() => return Some(Ordering::Less),
            Ok(value) if value.is_zero() => return Some(Ordering::Equal),
            Err(Undecided::Undefined | Undecided::TooLarge) => return None,
            _ => {}
        }
        if precision == PRECISIONS[0] && is_proved_zero(pool, number) {
            return Some(Ordering::Equal);
        }
    }
    None
}

fn is_proved_zero(pool: &mut Pool, number: Expr) -> bool {
    let zero = pool.integer(0);
    vanishes(pool, number) || {
        let equation = Equations { sides: &[(number, zero)], conditions: &[] };
        matches!(equation.decide(pool, EFFORT), Finding::Equal { .. })
    }
}

/// Number of digits shown of a number that is not shown in full.
const FIGURES: usize = 20;

/// Formats a number: in full if it is short or proved to be an integer, else by its first digits.
pub(super) fn digits(pool: &mut Pool, number: Expr) -> String {
    if let Some(value) = pool.as_number(number)
        && value.numer().bits() + value.denom().bits() <= LONGEST_EXACT
    {
        return value.to_string();
    }
    let Ok(value) = enclose_number(pool, number, PRECISIONS[1]) else { return pool.text(number) };
    let nearest = value.lower().round();
    if value.contains(&nearest) {
        let integer = pool.number(nearest.clone());
        let difference = pool.subtract(number, integer);
        if is_proved_zero(pool, difference) {
            return nearest.to_string();
        }
    }
    let figures = value.digits();
    match figures.char_indices().nth(FIGURES) {
        Some((end, _)) if !figures.contains('e') => format!("{}…", &figures[..end]),
        _ => figures,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;

    fn value(formula: &str, point: [&str; 2]) -> Result<String, String> {
        let texts = format!("kernel k(x, y) = {formula}; kernel p() = ({}, {});", point[0], point[1]);
        let (mut theory, errors) = read_theory(&texts.replace("kernel p()", "kernel p(t)"));
        assert!(errors.is_empty(), "{errors:?}");
        let (kernel, coordinates) = (theory.kernels[0].clone(), theory.kernels[1].outputs.clone());
        let point: Point = kernel.arguments.iter().copied().zip(coordinates).collect();
        let found = ExactPoint::new(&mut theory.pool, &point).value(kernel.outputs[0]);
        match found {
            Ok(value) => Ok(digits(&mut theory.pool, value)),
            Err(NoValue::Undefined(part)) => Err(theory.pool.text(part)),
            Err(NoValue::Unknown) => Err("unknown".into()),
        }
    }

    #[test]
    fn strata_are_told_from_the_points_beside_them() {
        assert_eq!(value("x/(1 + cos(y))", ["1", "pi"]), Err("x/(1 + cos(y))".into()));
        assert_eq!(value("if jump x < 1/3 { 1/(y - 3) } else { x*y }", ["1/3", "3"]), Ok("1".into()));
        assert_eq!(value("log(sqrt(x)*sqrt(y) - 2)", ["2", "2"]), Err("log(sqrt(x)*sqrt(y) - 2)".into()));
        assert_eq!(value("sqrt(3 + 2*sqrt(x)) - sqrt(x) - y", ["2", "1"]), Ok("0".into()));
        assert_eq!(value("atan2(y, x) - pi", ["-1", "0"]), Ok("0".into()));
        assert_eq!(value("atan2(y, x)", ["0", "0"]), Err("atan2(y, x)".into()));
        assert_eq!(value("sqrt(x)*y", ["1/4", "8"]), Ok("4".into()));
    }
}
