//! A refutation checked: an exact point that meets every condition, at which the sides are enclosed apart.

use crate::certificate::Line;
use crate::expression::Operation::{Add, Divide, Function, Jet, Multiply, Number, Pi, Power, Variable};
use crate::expression::{Expr, Pool, rational};
use crate::interval::Interval;
use crate::theory::{Relation, Statement, Theory};
use crate::{Stop, malformed, rejected};
use num_rational::BigRational;
use std::collections::HashMap;

/// Values of variables, or where they lie, and of unknown functions with their derivatives at places.
#[derive(Default)]
pub(crate) struct Point {
    variables: HashMap<usize, Interval>,
    jets: Vec<(usize, Vec<u32>, Vec<Interval>, BigRational)>,
}

/// Checks a point against a statement.
pub(crate) fn check(theory: &mut Theory, statement: &Statement, lines: &[Line]) -> Result<(), Stop> {
    let (mut point, mut component, mut values) = (Point::default(), "", Vec::new());
    for (keyword, rest) in lines {
        match keyword.as_str() {
            "at" => {
                let (name, value) =
                    rest.split_once(" = ").ok_or_else(|| malformed("a point without a value"))?;
                let (place, value) = (theory.expression(name)?, number(theory, value)?);
                point.set(&theory.pool, place, value)?;
            }
            "component" => component = rest,
            "left" | "right" => values.push((number(theory, rest)?, rest)),
            other => return Err(malformed(format!("`{other}` in a refutation"))),
        }
    }
    let Some(sides) = statement.components.get(component) else { return rejected("no such component") };
    let [(left, left_text), (right, right_text)] = values.as_slice() else {
        return Err(malformed("a refutation needs a left and a right value"));
    };
    let mut known = HashMap::new();
    for (expr, relation) in &statement.conditions {
        let sign = point.at(&theory.pool, *expr, &mut known)?.sign();
        let holds = match relation {
            Relation::Positive => sign == Some(1),
            Relation::NotNegative => matches!(sign, Some(0 | 1)),
            Relation::NotZero => matches!(sign, Some(1 | -1)),
        };
        if !holds {
            return rejected("a condition is not certain at the point");
        }
    }
    let at = sides.map(|side| point.at(&theory.pool, side, &mut known));
    let [a, b] = [at[0].clone()?, at[1].clone()?];
    if a.low <= b.high && b.low <= a.high {
        return rejected("the sides are not told apart at the point");
    }
    if is_rounded(&a, left, left_text) && is_rounded(&b, right, right_text) {
        Ok(())
    } else {
        rejected("other values")
    }
}

fn number(theory: &mut Theory, text: &str) -> Result<BigRational, Stop> {
    let expr = theory.expression(text)?;
    theory.pool.as_number(expr).cloned().ok_or_else(|| malformed(format!("`{text}` is no number")))
}

/// Whether a decimal is the value to its last place; a fraction has to be the value.
fn is_rounded(value: &Interval, number: &BigRational, text: &str) -> bool {
    let places = text.split_once('.').map_or(0, |(_, digits)| digits.len());
    // enclosures are not wider than 10⁻³⁶
    let width = rational(1, 1) / rational(10, 1).pow(36);
    let unit = if places == 0 { rational(0, 1) } else { rational(1, 10).pow(places.min(4096) as i32) };
    let half = unit / rational(2, 1) + width;
    value.low >= number - &half && value.high <= number + half
}

impl Point {
    fn set(&mut self, pool: &Pool, place: Expr, value: BigRational) -> Result<(), Stop> {
        let is_new = match pool.node(place) {
            (Variable(v), _) => self.variables.insert(*v, Interval::number(value)).is_none(),
            (Jet(f, orders), arguments) => {
                let mut known = HashMap::new();
                let at =
                    arguments.iter().map(|a| self.at(pool, *a, &mut known)).collect::<Result<Vec<_>, _>>()?;
                let is_new = self.find(*f, orders, &at, &rational(3, 1)).next().is_none();
                self.jets.push((*f, orders.clone(), at, value));
                is_new
            }
            _ => return Err(malformed("a point gives values of variables and unknown functions")),
        };
        if is_new { Ok(()) } else { rejected("two values at one place") }
    }

    /// The jets within 10⁻¹² times some factor of a place.
    fn find<'a>(
        &'a self,
        function: usize,
        orders: &'a [u32],
        at: &'a [Interval],
        factor: &BigRational,
    ) -> impl Iterator<Item = &'a BigRational> {
        let limit = factor / rational(10, 1).pow(12);
        let is_near = move |places: &[Interval]| {
            places.iter().zip(at).all(|(a, b)| &a.low - &b.high <= limit && &b.low - &a.high <= limit)
        };
        let jets = self.jets.iter().filter(move |(f, o, ..)| *f == function && o == orders);
        jets.filter(move |jet| is_near(&jet.2)).map(|jet| &jet.3)
    }

    /// All numbers that variables may be.
    pub(crate) fn within(variables: HashMap<usize, Interval>) -> Self {
        Point { variables, jets: Vec::new() }
    }

    /// An enclosure of a value.
    pub(crate) fn value(&self, pool: &Pool, expr: Expr) -> Result<Interval, Stop> {
        self.at(pool, expr, &mut HashMap::new())
    }

    fn at(&self, pool: &Pool, expr: Expr, known: &mut HashMap<Expr, Interval>) -> Result<Interval, Stop> {
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
                Jet(f, orders) => {
                    self.find(*f, orders, &a, &rational(1, 1)).next().cloned().map(Interval::number)
                }
            };
            let Some(value) = value else {
                return rejected(format!("no certain value of {operation:?} at the point"));
            };
            known.insert(part, value);
        }
        Ok(known[&expr].clone())
    }
}
