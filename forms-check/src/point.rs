//! Points: exact values of variables, values of unknown functions at places, and enclosures of
//! expressions there.

use crate::expression::Operation::{Add, Divide, Function, Jet, Multiply, Number, Pi, Power, Variable};
use crate::expression::{Expr, Pool, rational};
use crate::interval::Interval;
use crate::{Stop, malformed, rejected};
use num_rational::BigRational;
use std::collections::HashMap;

/// Maximum width of the enclosure of a place of an unknown function: 10⁻¹². A place within twice
/// this distance of a listed place is identified with it. Listed places are farther apart than any
/// two places that are identified.
const PLACE: (i64, u32) = (1, 12);

/// Distance within which two listed places count as equal, in units of the width of a place.
const APART: i64 = 10;

/// Listed value of an unknown function or of one of its derivatives.
struct ListedJet {
    function: usize,
    orders: Vec<u32>,
    place: Vec<Interval>,
    value: BigRational,
}

/// Values or ranges of variables, and values of unknown functions and their derivatives at places.
#[derive(Default)]
pub(crate) struct Point {
    variables: HashMap<usize, Interval>,
    jets: Vec<ListedJet>,
    /// If set to n, functions without a listed value are exponentials of 2⁻ⁿ times their arguments.
    exponentials: Option<u32>,
}

/// Returns 10⁻¹² times a number.
fn tolerance(times: i64) -> BigRational {
    rational(times * PLACE.0, 1) / rational(10, 1).pow(PLACE.1 as i32)
}

fn is_near(a: &[Interval], b: &[Interval], limit: &BigRational) -> bool {
    a.iter().zip(b).all(|(a, b)| &a.low - &b.high <= *limit && &b.low - &a.high <= *limit)
}

impl Point {
    /// Creates a point that stands for all values of variables in these intervals.
    pub(crate) fn within(variables: HashMap<usize, Interval>) -> Self {
        Point { variables, ..Point::default() }
    }

    /// Defines every function f(x, y, …) without a listed value as exp((αx + βy + …)/2ⁿ), with
    /// factors specific to the function.
    pub(crate) fn completed(mut self, n: u32) -> Self {
        self.exponentials = Some(n);
        self
    }

    /// Lists the value of a variable, or of an unknown function at a place determined by the
    /// variables listed before.
    pub(crate) fn set(&mut self, pool: &Pool, place: Expr, value: BigRational) -> Result<(), Stop> {
        let is_new = match pool.node(place) {
            (Variable(v), _) => self.variables.insert(*v, Interval::number(value)).is_none(),
            (Jet(function, orders), arguments) => {
                let place: Vec<Interval> =
                    arguments.iter().map(|a| self.value(pool, *a)).collect::<Result<_, _>>()?;
                if !is_narrow(&place) {
                    return rejected("a place of an unknown function is not enclosed narrowly");
                }
                let limit = tolerance(APART);
                let is_same = |jet: &ListedJet| {
                    jet.function == *function && jet.orders == *orders && is_near(&jet.place, &place, &limit)
                };
                let is_new = !self.jets.iter().any(is_same);
                let (function, orders) = (*function, orders.clone());
                self.jets.push(ListedJet { function, orders, place, value });
                is_new
            }
            _ => return Err(malformed("a point gives values of variables and unknown functions")),
        };
        if is_new { Ok(()) } else { rejected("two values at one place") }
    }

    /// Returns the value of an unknown function or derivative at a place: the listed value, if
    /// exactly one listed place is near.
    fn jet(&self, function: usize, orders: &[u32], place: &[Interval]) -> Option<Interval> {
        if let Some(n) = self.exponentials
            && !self.jets.iter().any(|jet| jet.function == function)
        {
            return exponential_jet(function, orders, place, n);
        }
        let limit = tolerance(2);
        let mut near = self.jets.iter().filter(|jet| {
            jet.function == function && jet.orders == orders && is_near(&jet.place, place, &limit)
        });
        let found = near.next().filter(|_| is_narrow(place))?;
        near.next().is_none().then(|| Interval::number(found.value.clone()))
    }

    /// Encloses a value.
    pub(crate) fn value(&self, pool: &Pool, expr: Expr) -> Result<Interval, Stop> {
        self.enclosed(pool, expr, &mut HashMap::new())
    }

    /// Encloses a value, and caches the values of its nodes in `known`.
    pub(crate) fn enclosed(
        &self,
        pool: &Pool,
        expr: Expr,
        known: &mut HashMap<Expr, Interval>,
    ) -> Result<Interval, Stop> {
        for part in pool.parts(&[expr]) {
            if known.contains_key(&part) {
                continue;
            }
            let (operation, operands) = pool.node(part);
            let a: Vec<Interval> = operands.iter().map(|operand| known[operand].clone()).collect();
            let value = match operation {
                Number(value) => Some(Interval::number(value.clone())),
                Pi => Some(Interval::pi()),
                Variable(v) => self.variables.get(v).cloned(),
                Add => Some(a[0].add(&a[1])),
                Multiply => Some(a[0].multiply(&a[1])),
                Divide => a[0].divide(&a[1]),
                Power(p, q) => a[0].power(*p, *q),
                Function(name) => Interval::function(name, &a[0]),
                Jet(f, orders) => self.jet(*f, orders, &a),
            };
            let Some(value) = value.filter(|value| !value.is_long()) else {
                return rejected(format!("{operation:?} has no certain value at the point"));
            };
            known.insert(part, value);
        }
        Ok(known[&expr].clone())
    }
}

fn is_narrow(place: &[Interval]) -> bool {
    place.iter().all(|side| &side.high - &side.low <= tolerance(1))
}

/// Returns ∏ αₖ^nₖ exp(Σ αₖ xₖ) with αₖ = (k + 2)/(k + 3 + f)/2ⁿ.
fn exponential_jet(function: usize, orders: &[u32], place: &[Interval], n: u32) -> Option<Interval> {
    let (mut factor, mut exponent) = (rational(1, 1), Interval::number(rational(0, 1)));
    for (k, (order, x)) in orders.iter().zip(place).enumerate() {
        let rate = rational(k as i64 + 2, k as i64 + 3 + i64::try_from(function).ok()?);
        let rate = rate / rational(2, 1).pow(i32::try_from(n).ok()?);
        factor *= rate.pow(i32::try_from(*order).ok()?);
        exponent = exponent.add(&x.scale(&rate));
    }
    Some(exponent.exponential()?.scale(&factor))
}
