//! Reference values, and errors in units in the last place.

use super::table::{Entry, Function};
use forms_core::expression::{Operation, Relation};
use forms_math::{Real, Scalar, Wide};
use std::cmp::Ordering;
use std::f64::consts::FRAC_PI_2;

/// Type of the reference: its digits hold the sum of any two numbers near 1 and at an end of the
/// range.
pub(crate) type Exact = Wide<18>;

/// Reference value.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Truth {
    /// The function has no value.
    Undefined,
    /// The limit at an infinite argument.
    Infinite(f64),
    Finite(Exact),
}

/// Number format in which errors are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    F32,
    F64,
}

/// Returns the value of a function: by wide numbers, and at infinite arguments by its limits.
pub(crate) fn truth(entry: &Entry, row: &[f64]) -> Truth {
    let function = entry.function.expect("a function");
    if row.iter().any(|x| x.is_nan()) {
        return Truth::Undefined;
    }
    let value = if row.iter().all(|x| x.is_finite()) {
        let exact: Vec<Exact> = row.iter().map(|&x| Exact::from_f64(x)).collect();
        return finite(function, row, entry.program.interpret_as(&exact)[0]);
    } else {
        limit(function, row)
    };
    match value {
        value if value.is_nan() => Truth::Undefined,
        value if value.is_infinite() => Truth::Infinite(value),
        value => Truth::Finite(Exact::from_f64(value)),
    }
}

/// Poles are infinite, with the sign that the standard library gives them.
fn finite(function: Function, row: &[f64], value: Exact) -> Truth {
    if let (Function::Operation(Operation::Atan2), 0.0) = (function, row[0]) {
        // the sign of zero selects the side of the branch cut
        let angle = if row[1].is_sign_negative() { Exact::pi() } else { Exact::from_f64(0.0) };
        return Truth::Finite(if row[0].is_sign_negative() { -angle } else { angle });
    }
    let is_pole = value.exponent().is_none() && value != Exact::from_f64(0.0);
    if !is_pole {
        return Truth::Finite(value);
    }
    let pole = match function {
        Function::Operation(Operation::Log) if row[0] == 0.0 => f64::NEG_INFINITY,
        Function::Operation(Operation::Log1p) if row[0] == -1.0 => f64::NEG_INFINITY,
        Function::Operation(Operation::Expint1) if row[0] == 0.0 => f64::INFINITY,
        Function::Divide => row[0] / row[1],
        Function::Power(numerator, 1) if numerator < 0 && row[0] == 0.0 => row[0].powi(numerator as i32),
        Function::Power(numerator, _) if numerator < 0 && row[0] == 0.0 => f64::INFINITY,
        // an overflow, beyond the exponents of wide numbers
        _ => value.to_f64(),
    };
    match pole {
        pole if pole.is_nan() => Truth::Undefined,
        pole if pole.is_infinite() => Truth::Infinite(pole),
        pole => Truth::Finite(Exact::from_f64(pole)),
    }
}

/// Returns the limit of a function at an infinite argument, as IEEE 754 and Annex F of C define it.
fn limit(function: Function, row: &[f64]) -> f64 {
    let (x, is_positive) = (row[0], row[0] > 0.0);
    let by_sign = |negative: f64, positive: f64| if is_positive { positive } else { negative };
    match function {
        Function::Operation(operation) => match operation {
            Operation::Sin | Operation::Cos | Operation::Tan | Operation::Asin | Operation::Acos => f64::NAN,
            Operation::Clausen => f64::NAN,
            Operation::Atan => FRAC_PI_2.copysign(x),
            Operation::Atan2 => row[0].atan2(row[1]),
            Operation::Exp => by_sign(0.0, x),
            Operation::Expm1 => by_sign(-1.0, x),
            Operation::Log | Operation::Log1p => by_sign(f64::NAN, x),
            Operation::Sinh | Operation::Cbrt => x,
            Operation::Erfc => by_sign(2.0, 0.0),
            Operation::Hypot => f64::INFINITY,
            Operation::Cosh | Operation::Abs => f64::INFINITY,
            Operation::Tanh | Operation::Erf => 1f64.copysign(x),
            Operation::Expint1 | Operation::Expint2 | Operation::Expint3 => by_sign(f64::NAN, 0.0),
            Operation::Dilog => by_sign(f64::NEG_INFINITY, f64::NAN),
        },
        Function::Sqrt => by_sign(f64::NAN, x),
        Function::Power(numerator, 1) => x.powi(numerator as i32),
        Function::Power(numerator, _) => by_sign(f64::NAN, if numerator > 0 { x } else { 0.0 }),
        Function::Negate => -x,
        Function::Add => x + row[1],
        Function::Subtract => x - row[1],
        Function::Multiply => x * row[1],
        Function::Divide => x / row[1],
        Function::MultiplyAdd => x * row[1] + row[2],
        Function::DifferenceOfProducts => x * row[1] - row[2] * row[3],
        Function::SumOfProducts => x * row[1] + row[2] * row[3],
        Function::Choice(relation) => {
            let order = x.partial_cmp(&row[1]).expect("no argument is NaN");
            if holds(relation, order) { x } else { -row[1] }
        }
    }
}

fn holds(relation: Relation, order: Ordering) -> bool {
    match relation {
        Relation::Less => order.is_lt(),
        Relation::LessEqual => order.is_le(),
        Relation::Greater => order.is_gt(),
        Relation::GreaterEqual => order.is_ge(),
        Relation::NotEqual => order.is_ne(),
    }
}

/// Returns the error of a value in units in the last place of the format at the true value;
/// infinite if one is NaN and the other not, or if they are of different kinds.
pub(crate) fn ulps(value: f64, truth: Truth, format: Format) -> f64 {
    let (largest, digits, least) = match format {
        Format::F32 => (f64::from(f32::MAX), 23, -126),
        Format::F64 => (f64::MAX, 52, -1022),
    };
    let exact = match truth {
        Truth::Undefined => return if value.is_nan() { 0.0 } else { f64::INFINITY },
        Truth::Infinite(truth) => return if value == truth { 0.0 } else { f64::INFINITY },
        Truth::Finite(exact) => exact,
    };
    let nearest = match format {
        Format::F32 => f64::from(exact.to_f64() as f32),
        Format::F64 => exact.to_f64(),
    };
    if value.is_nan() {
        return f64::INFINITY;
    }
    if nearest.is_infinite() || value.is_infinite() {
        let limited = |value: f64| value.clamp(-largest, largest);
        return match (limited(value) == limited(nearest), value == nearest) {
            (_, true) => 0.0,
            (true, false) => 1.0,
            _ => f64::INFINITY,
        };
    }
    let exponent = exact.exponent().map_or(least, |exponent| (exponent - 1).max(least));
    (Exact::from_f64(value) - exact).abs().scaled(digits - exponent).to_f64()
}
