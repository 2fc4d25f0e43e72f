//! Numbers in Rust: the shortest decimals that read back as the nearest `f64`; multiples of π by
//! name.

use super::target::Precision;
use super::written::{Binding, Written};
use crate::kernel::Constant;

/// Multiples p/q πᵏ that the standard library has names for: (p, q, k, name).
const NAMED: [(i64, i64, i32, &str); 9] = [
    (1, 1, 1, "PI"),
    (2, 1, 1, "TAU"),
    (1, 2, 1, "FRAC_PI_2"),
    (1, 3, 1, "FRAC_PI_3"),
    (1, 4, 1, "FRAC_PI_4"),
    (1, 6, 1, "FRAC_PI_6"),
    (1, 8, 1, "FRAC_PI_8"),
    (1, 1, -1, "FRAC_1_PI"),
    (2, 1, -1, "FRAC_2_PI"),
];

/// Writes a number as an operand.
pub(super) fn number(constant: &Constant, precision: Precision) -> Written {
    signed(constant, magnitude(constant, precision))
}

/// Writes a number in the notation of C: the shortest decimals, with the suffix of single precision
/// if needed.
pub(super) fn literal(constant: &Constant, precision: Precision) -> Written {
    let digits = digits(constant, precision);
    signed(constant, if precision == Precision::F32 { format!("{digits}f") } else { digits })
}

/// Writes a value as the receiver of a method call, in which a plain literal needs its type.
pub(super) fn receiver(value: &Written, precision: Precision) -> String {
    let Some(constant) = &value.constant else { return value.within(Binding::Atom) };
    let magnitude = magnitude(constant, precision);
    let is_plain = magnitude.starts_with(|c: char| c.is_ascii_digit());
    let suffix = if is_plain { format!("_{}", precision.name()) } else { String::new() };
    if constant.is_negative() { format!("(-{magnitude}{suffix})") } else { format!("{magnitude}{suffix}") }
}

fn signed(constant: &Constant, magnitude: String) -> Written {
    if constant.is_negative() {
        Written::new(format!("-{magnitude}"), Binding::Sign)
    } else {
        Written::atom(magnitude)
    }
}

fn magnitude(constant: &Constant, precision: Precision) -> String {
    let positive = if constant.is_negative() { constant.negated() } else { constant.clone() };
    let named = NAMED.iter().find(|&&(p, q, pi_exponent, _)| {
        positive.pi_exponent == pi_exponent && positive.factor == num_rational::Ratio::new(p.into(), q.into())
    });
    match named {
        Some((.., name)) => format!("::core::{}::consts::{name}", precision.name()),
        None => digits(constant, precision),
    }
}

/// Returns the shortest decimals of the magnitude of the nearest number.
fn digits(constant: &Constant, precision: Precision) -> String {
    match precision {
        Precision::F32 => format!("{:?}", constant.to_f32().abs()),
        _ => format!("{:?}", constant.to_f64().abs()),
    }
}
