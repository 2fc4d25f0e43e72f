//! The op table: every real function of the language, one row each.
//!
//! A row gives the function's name, its arity, its partial derivatives, its meaning in `f64`, how Rust spells
//! it and what it costs beside an addition. Whoever needs one of these asks the table.

use super::node::{Expr, Pool};
use num_rational::Ratio;

/// A real function of one or two arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Operation {
    /// sine
    Sin,
    /// cosine
    Cos,
    /// tangent
    Tan,
    /// arc sine, in [−π/2, π/2]
    Asin,
    /// arc cosine, in [0, π]
    Acos,
    /// arc tangent, in (−π/2, π/2)
    Atan,
    /// atan2(y, x): the angle of the point (x, y), in (−π, π]
    Atan2,
    /// exponential
    Exp,
    /// natural logarithm
    Log,
    /// hyperbolic sine
    Sinh,
    /// hyperbolic cosine
    Cosh,
    /// hyperbolic tangent
    Tanh,
    /// absolute value
    Abs,
}

/// What a function means in `f64`.
#[derive(Clone, Copy)]
pub enum Meaning {
    /// Of one argument.
    One(fn(f64) -> f64),
    /// Of two.
    Two(fn(f64, f64) -> f64),
}

/// The partial derivatives with respect to each argument, as expressions of the arguments.
type Partials = fn(&mut Pool, &[Expr]) -> Vec<Expr>;

/// One row of the table.
pub struct Row {
    /// The operation the row describes.
    pub operation: Operation,
    /// The name in the language.
    pub name: &'static str,
    /// Its partial derivatives.
    pub partials: Partials,
    /// Its value in `f64`.
    pub meaning: Meaning,
    /// The method of `f64` with the same meaning.
    pub rust: &'static str,
    /// LaTeX, with a trailing space where one is needed.
    pub latex: &'static str,
    /// Cost in units of one addition.
    pub cost: u32,
}

/// The table itself, in the order of [`Operation`].
pub const TABLE: &[Row] = &[
    row(Operation::Sin, "sin", sin, Meaning::One(f64::sin), "\\sin", 20),
    row(Operation::Cos, "cos", cos, Meaning::One(f64::cos), "\\cos", 20),
    row(Operation::Tan, "tan", tan, Meaning::One(f64::tan), "\\tan", 25),
    row(Operation::Asin, "asin", asin, Meaning::One(f64::asin), "\\arcsin", 20),
    row(Operation::Acos, "acos", acos, Meaning::One(f64::acos), "\\arccos", 20),
    row(Operation::Atan, "atan", atan, Meaning::One(f64::atan), "\\arctan", 25),
    row(Operation::Atan2, "atan2", atan2, Meaning::Two(f64::atan2), "\\operatorname{atan2}", 30),
    row(Operation::Exp, "exp", exp, Meaning::One(f64::exp), "\\exp", 15),
    row(Operation::Log, "log", log, Meaning::One(f64::ln), "\\ln", 15),
    row(Operation::Sinh, "sinh", sinh, Meaning::One(f64::sinh), "\\sinh", 25),
    row(Operation::Cosh, "cosh", cosh, Meaning::One(f64::cosh), "\\cosh", 25),
    row(Operation::Tanh, "tanh", tanh, Meaning::One(f64::tanh), "\\tanh", 25),
    row(Operation::Abs, "abs", abs, Meaning::One(f64::abs), "\\operatorname{abs}", 1),
];

const fn row(
    operation: Operation,
    name: &'static str,
    partials: Partials,
    meaning: Meaning,
    latex: &'static str,
    cost: u32,
) -> Row {
    let rust = if matches!(operation, Operation::Log) { "ln" } else { name };
    Row { operation, name, partials, meaning, rust, latex, cost }
}

impl Operation {
    /// The operation's row.
    pub fn row(self) -> &'static Row {
        &TABLE[self as usize]
    }

    /// How many arguments it takes.
    pub fn arity(self) -> usize {
        match self.row().meaning {
            Meaning::One(_) => 1,
            Meaning::Two(_) => 2,
        }
    }

    /// The operation of that name.
    pub fn named(name: &str) -> Option<Operation> {
        TABLE.iter().find(|row| row.name == name).map(|row| row.operation)
    }
}

/// sin′ = cos
fn sin(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    vec![pool.apply(Operation::Cos, q)]
}

/// cos′ = −sin
fn cos(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let sine = pool.apply(Operation::Sin, q);
    vec![pool.negate(sine)]
}

/// tan′ = 1 + tan²
fn tan(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let tangent = pool.apply(Operation::Tan, q);
    let square = pool.power(tangent, 2.into());
    let one = pool.integer(1);
    vec![pool.add(one, square)]
}

/// asin′ = 1/√(1 − q²)
fn asin(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let square = pool.power(q[0], 2.into());
    let one = pool.integer(1);
    let rest = pool.subtract(one, square);
    vec![pool.power(rest, Ratio::new(-1, 2))]
}

/// acos′ = −asin′
fn acos(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let derivative = asin(pool, q)[0];
    vec![pool.negate(derivative)]
}

/// atan′ = 1/(1 + q²)
fn atan(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let square = pool.power(q[0], 2.into());
    let one = pool.integer(1);
    let sum = pool.add(one, square);
    vec![pool.divide(one, sum)]
}

/// ∂atan2(y, x)/∂y = x/(x² + y²), ∂atan2(y, x)/∂x = −y/(x² + y²)
fn atan2(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let (y2, x2) = (pool.power(q[0], 2.into()), pool.power(q[1], 2.into()));
    let r2 = pool.add(x2, y2);
    let (by_y, by_x) = (pool.divide(q[1], r2), pool.divide(q[0], r2));
    vec![by_y, pool.negate(by_x)]
}

/// exp′ = exp
fn exp(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    vec![pool.apply(Operation::Exp, q)]
}

/// log′ = 1/q
fn log(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let one = pool.integer(1);
    vec![pool.divide(one, q[0])]
}

/// sinh′ = cosh
fn sinh(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    vec![pool.apply(Operation::Cosh, q)]
}

/// cosh′ = sinh
fn cosh(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    vec![pool.apply(Operation::Sinh, q)]
}

/// tanh′ = 1 − tanh²
fn tanh(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let tangent = pool.apply(Operation::Tanh, q);
    let square = pool.power(tangent, 2.into());
    let one = pool.integer(1);
    vec![pool.subtract(one, square)]
}

/// |q|′ = q/|q|, defined for q ≠ 0
fn abs(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let magnitude = pool.apply(Operation::Abs, q);
    vec![pool.divide(q[0], magnitude)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_in_the_order_of_the_operations() {
        for (place, row) in TABLE.iter().enumerate() {
            assert_eq!(row.operation as usize, place, "{}", row.name);
            assert_eq!(Operation::named(row.name), Some(row.operation));
        }
    }
}
