//! Reader of units: products, quotients and rational powers of unit names, and 1.

use super::table;
use super::unit::Unit;
use crate::diagnostic::Diagnostic;
use crate::syntax::ast::{Binary, Expr, ExprKind};
use num_rational::BigRational;
use num_traits::{One, Zero};

/// Reads a unit such as `W/m**2/sr`. Chains of operators are processed in a loop.
pub(super) fn unit(written: &Expr) -> Result<Unit, Diagnostic> {
    let mut spine = Vec::new();
    let mut leftmost = written;
    while let ExprKind::Binary(operator, place, left, right) = &*leftmost.kind {
        spine.push((*operator, *place, right));
        leftmost = left;
    }
    let mut value = atom(leftmost)?;
    while let Some((operator, place, right)) = spine.pop() {
        value = match operator {
            Binary::Multiply => value.product(&unit(right)?),
            Binary::Divide => value.quotient(&unit(right)?),
            Binary::Power => {
                let malformed =
                    || Diagnostic::new(right.span, "the exponent of a unit is a number, as in `m**2`");
                value.power(&number(right).ok_or_else(malformed)?)
            }
            Binary::Wedge => {
                return Err(Diagnostic::new(place, "`^` is the wedge product")
                    .with_help("use `**` for powers: `m**2`"));
            }
            Binary::Add | Binary::Subtract => return Err(malformed(written)),
        };
    }
    Ok(value)
}

/// Types of numbers in other languages.
const TYPES: [&str; 8] = ["f64", "f32", "float", "double", "real", "Real", "half", "int"];

fn atom(written: &Expr) -> Result<Unit, Diagnostic> {
    match &*written.kind {
        ExprKind::Number(number) if number.is_one() => Ok(Unit::one()),
        ExprKind::Name(name) => Unit::named(name).ok_or_else(|| unknown(name, written)),
        _ => Err(malformed(written)),
    }
}

fn malformed(written: &Expr) -> Diagnostic {
    Diagnostic::new(written.span, "expected a unit").with_help(
        "a unit is made of unit names with `*`, `/` and `**`, as `W/m**2/sr`; that of a number is `1`",
    )
}

fn unknown(name: &str, written: &Expr) -> Diagnostic {
    let diagnostic = Diagnostic::new(written.span, format!("`{name}` is not a unit"));
    if TYPES.contains(&name) {
        return diagnostic
            .with_help("a kernel is the same for all types of numbers; after `:` stands a unit, as `m`");
    }
    match table::suggestion(name) {
        Some("rad") if name.to_ascii_lowercase().starts_with("deg") => {
            diagnostic.with_help("angles are in radians: `rad`")
        }
        Some(meant) => diagnostic.with_help(format!("did you mean `{meant}`?")),
        None => diagnostic.with_help("use SI units such as `m`, `nm`, `s`, `kg`, `W`, `sr`"),
    }
}

/// Reads an integer or a fraction, with an optional minus sign.
fn number(written: &Expr) -> Option<BigRational> {
    match &*written.kind {
        ExprKind::Number(value) => Some(value.clone()),
        ExprKind::Negate(inner) => Some(-number(inner)?),
        ExprKind::Binary(Binary::Divide, _, left, right) => {
            let below = number(right)?;
            if below.is_zero() { None } else { Some(number(left)? / below) }
        }
        _ => None,
    }
}
