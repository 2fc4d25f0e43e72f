//! The operation table: every real function of the language, one row each.
//!
//! A row holds the function's name, its arguments, its partial derivatives, its evaluation in any
//! precision, its spelling in each target and its cost relative to an addition. Code that needs
//! one of these reads it from the table.

use super::node::{Expr, Pool};
use forms_math::Real;
use num_rational::Ratio;

/// Partial derivatives with respect to each argument, as expressions of the arguments.
type Partials = fn(&mut Pool, &[Expr]) -> Vec<Expr>;

/// Name of a function in each target; `None` where the target lacks the function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spelling {
    /// Method of `f64` in the standard library of Rust.
    pub rust: Option<&'static str>,
    /// Function for `double` in the `math.h` of C; the function for `float` has the suffix `f`.
    pub c: Option<&'static str>,
    /// The builtin function of WGSL.
    pub wgsl: Option<&'static str>,
    /// Function for `double` in CUDA; the function for `float` has the suffix `f`.
    pub cuda: Option<&'static str>,
}

/// Returns the spelling of a function that every target has under this name.
const fn everywhere(name: &'static str) -> Spelling {
    Spelling { rust: Some(name), c: Some(name), wgsl: Some(name), cuda: Some(name) }
}

/// Returns the spelling of a function that only C and CUDA have, and Rust as the given method, if
/// any.
const fn of_math_h(name: &'static str, rust: Option<&'static str>) -> Spelling {
    Spelling { rust, c: Some(name), wgsl: None, cuda: Some(name) }
}

/// Spelling of a function that no target has.
const NOWHERE: Spelling = Spelling { rust: None, c: None, wgsl: None, cuda: None };

/// One row of the table.
pub struct Row {
    /// The operation the row describes.
    pub operation: Operation,
    /// The name in the language.
    pub name: &'static str,
    /// Number of arguments.
    pub arity: usize,
    /// Its partial derivatives.
    pub partials: Partials,
    /// The method of [`Real`] that computes it.
    pub real: &'static str,
    /// Its name in each target.
    pub spelling: Spelling,
    /// LaTeX.
    pub latex: &'static str,
    /// Cost in units of one addition.
    pub cost: u32,
}

/// Generates the enumeration, the table and the evaluation of each function from one list. A line
/// reads: documentation, operation, name in the language (and of the function below that gives the
/// partial derivatives), arguments, method of [`Real`], spelling in the targets, LaTeX, cost.
macro_rules! operations {
    ($(
        $(#[$docs:meta])*
        $operation:ident = $name:ident($first:ident $(, $rest:ident)*) by $real:ident, $spelling:expr, $latex:literal, $cost:literal;
    )*) => {
        /// A real function of one or two arguments.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Operation {
            $($(#[$docs])* $operation,)*
        }

        /// The table itself, in the order of [`Operation`].
        pub const TABLE: &[Row] = &[$(Row {
            operation: Operation::$operation,
            name: stringify!($name),
            arity: [stringify!($first) $(, stringify!($rest))*].len(),
            partials: $name,
            real: stringify!($real),
            spelling: $spelling,
            latex: $latex,
            cost: $cost,
        },)*];

        impl Operation {
            /// Evaluates the function in any precision; NaN if the number of arguments is wrong.
            pub fn apply<T: Real>(self, arguments: &[T]) -> T {
                match (self, arguments) {
                    $((Operation::$operation, &[$first $(, $rest)*]) => T::$real($first $(, $rest)*),)*
                    _ => T::nan(),
                }
            }
        }
    };
}

operations! {
    /// sine
    Sin = sin(q) by sin, everywhere("sin"), "\\sin", 20;
    /// cosine
    Cos = cos(q) by cos, everywhere("cos"), "\\cos", 20;
    /// tangent
    Tan = tan(q) by tan, everywhere("tan"), "\\tan", 25;
    /// arc sine, in [−π/2, π/2]
    Asin = asin(q) by asin, everywhere("asin"), "\\arcsin", 20;
    /// arc cosine, in [0, π]
    Acos = acos(q) by acos, everywhere("acos"), "\\arccos", 20;
    /// arc tangent, in (−π/2, π/2)
    Atan = atan(q) by atan, everywhere("atan"), "\\arctan", 25;
    /// atan2(y, x): the angle of the point (x, y), in (−π, π]
    Atan2 = atan2(y, x) by atan2, everywhere("atan2"), "\\operatorname{atan2}", 30;
    /// exponential
    Exp = exp(q) by exp, everywhere("exp"), "\\exp", 15;
    /// eᵠ − 1, accurate to the last places near 0
    Expm1 = expm1(q) by exp_m1, of_math_h("expm1", Some("exp_m1")), "\\operatorname{expm1}", 20;
    /// natural logarithm
    Log = log(q) by ln, Spelling { rust: Some("ln"), ..everywhere("log") }, "\\ln", 15;
    /// log(1 + q), accurate to the last places near 0
    Log1p = log1p(q) by ln_1p, of_math_h("log1p", Some("ln_1p")), "\\operatorname{log1p}", 20;
    /// hyperbolic sine
    Sinh = sinh(q) by sinh, everywhere("sinh"), "\\sinh", 25;
    /// hyperbolic cosine
    Cosh = cosh(q) by cosh, everywhere("cosh"), "\\cosh", 25;
    /// hyperbolic tangent
    Tanh = tanh(q) by tanh, everywhere("tanh"), "\\tanh", 25;
    /// absolute value
    Abs = abs(q) by abs, Spelling { c: Some("fabs"), cuda: Some("fabs"), ..everywhere("abs") }, "\\operatorname{abs}", 1;
    /// the error function 2/√π ∫₀ᵠ e^(−t²) dt
    Erf = erf(q) by erf, of_math_h("erf", None), "\\operatorname{erf}", 30;
    /// the exponential integral E₁(q) = ∫₁^∞ e^(−qt)/t dt, for q > 0
    Expint1 = expint1(q) by expint1, NOWHERE, "\\operatorname{E}_{1}", 60;
    /// the exponential integral E₂(q) = ∫₁^∞ e^(−qt)/t² dt, for q ≥ 0
    Expint2 = expint2(q) by expint2, NOWHERE, "\\operatorname{E}_{2}", 60;
    /// the exponential integral E₃(q) = ∫₁^∞ e^(−qt)/t³ dt, for q ≥ 0
    Expint3 = expint3(q) by expint3, NOWHERE, "\\operatorname{E}_{3}", 60;
    /// the dilogarithm Li₂(q) = −∫₀ᵠ log(1 − t)/t dt, for q ≤ 1
    Dilog = dilog(q) by dilog, NOWHERE, "\\operatorname{Li}_{2}", 60;
    /// Clausen's function Cl₂(q) = −∫₀ᵠ log|2 sin(t/2)| dt
    Clausen = clausen(q) by clausen, NOWHERE, "\\operatorname{Cl}_{2}", 60;
}

impl Operation {
    /// Returns the operation's row in the table.
    pub fn row(self) -> &'static Row {
        &TABLE[self as usize]
    }

    /// Returns the number of arguments.
    pub fn arity(self) -> usize {
        self.row().arity
    }

    /// Returns the operation with this name.
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

/// expm1′ = exp
fn expm1(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    exp(pool, q)
}

/// log1p′ = 1/(1 + q)
fn log1p(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let one = pool.integer(1);
    let sum = pool.add(one, q[0]);
    vec![pool.divide(one, sum)]
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

/// erf′ = 2/√π · exp(−q²)
fn erf(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let (two, pi, square) = (pool.integer(2), pool.pi(), pool.power(q[0], 2.into()));
    let root = pool.sqrt(pi);
    let factor = pool.divide(two, root);
    let exponent = pool.negate(square);
    let bell = pool.apply(Operation::Exp, &[exponent]);
    vec![pool.multiply(factor, bell)]
}

/// E₁′ = −exp(−q)/q
fn expint1(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let exponent = pool.negate(q[0]);
    let decay = pool.apply(Operation::Exp, &[exponent]);
    let quotient = pool.divide(decay, q[0]);
    vec![pool.negate(quotient)]
}

/// E₂′ = −E₁
fn expint2(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let lower = pool.apply(Operation::Expint1, q);
    vec![pool.negate(lower)]
}

/// E₃′ = −E₂
fn expint3(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let lower = pool.apply(Operation::Expint2, q);
    vec![pool.negate(lower)]
}

/// Li₂′ = −log(1 − q)/q
fn dilog(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let one = pool.integer(1);
    let rest = pool.subtract(one, q[0]);
    let logarithm = pool.apply(Operation::Log, &[rest]);
    let quotient = pool.divide(logarithm, q[0]);
    vec![pool.negate(quotient)]
}

/// Cl₂′ = −log|2 sin(q/2)|
fn clausen(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let two = pool.integer(2);
    let half = pool.divide(q[0], two);
    let sine = pool.apply(Operation::Sin, &[half]);
    let chord = pool.multiply(two, sine);
    let magnitude = pool.apply(Operation::Abs, &[chord]);
    let logarithm = pool.apply(Operation::Log, &[magnitude]);
    vec![pool.negate(logarithm)]
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
