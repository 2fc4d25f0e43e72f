//! Partial derivatives of the functions of the operation table.

use super::node::Expr;
use super::operation::{Operation, for_each_operation};
use super::pool::Pool;
use num_rational::Ratio;

/// Generates the selection of the function that gives the partial derivatives.
macro_rules! partials {
    ($(
        $(#[$docs:meta])*
        $operation:ident = $name:ident($($arguments:ident),*) by $real:ident, $spelling:expr, $latex:literal, $cost:literal;
    )*) => {
        impl Operation {
            /// Returns the partial derivatives with respect to each argument, as expressions of the
            /// arguments.
            pub fn partials(self, pool: &mut Pool, arguments: &[Expr]) -> Vec<Expr> {
                match self {
                    $(Operation::$operation => $name(pool, arguments),)*
                }
            }
        }
    };
}

for_each_operation!(partials);

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

/// erfc′ = −erf′
fn erfc(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let derivative = erf(pool, q)[0];
    vec![pool.negate(derivative)]
}

/// ∂hypot(x, y)/∂x = x/hypot(x, y), defined for (x, y) ≠ (0, 0)
fn hypot(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let length = pool.apply(Operation::Hypot, q);
    q.iter().map(|&side| pool.divide(side, length)).collect()
}

/// cbrt′ = 1/(3 cbrt²), defined for q ≠ 0
fn cbrt(pool: &mut Pool, q: &[Expr]) -> Vec<Expr> {
    let root = pool.apply(Operation::Cbrt, q);
    let (one, three, square) = (pool.integer(1), pool.integer(3), pool.power(root, 2.into()));
    let divisor = pool.multiply(three, square);
    vec![pool.divide(one, divisor)]
}
