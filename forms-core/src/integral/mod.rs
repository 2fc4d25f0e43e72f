//! Definite integrals.
use crate::expression::{Condition, Expr, Pool, Symbol};

/// Integral.
pub fn definite_integral(
    pool: &mut Pool,
    integrand: Expr,
    variable: Symbol,
    (from, to): (Expr, Expr),
    assumptions: &[Condition],
) -> Result<Expr, String> {
    let _ = (pool, integrand, variable, from, to, assumptions);
    Err("x".into())
}
