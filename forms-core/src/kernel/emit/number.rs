//! Numbers in Rust: the shortest decimals that read back as the nearest `f64`; π and its parts by name.

use super::written::{Binding, Written};
use crate::kernel::constant::Constant;

/// Multiples p/q πᵏ the standard library has names for: (p, q, k, name).
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

/// The number as an operand.
pub(super) fn number(constant: &Constant) -> Written {
    let (negative, magnitude) = (constant.is_negative(), magnitude(constant));
    if negative { Written::new(format!("-{magnitude}"), Binding::Sign) } else { Written::atom(magnitude) }
}

/// A value as what a method is called on: a plain literal has to say that it is an `f64`.
pub(super) fn receiver(value: &Written) -> String {
    let Some(constant) = &value.constant else { return value.within(Binding::Atom) };
    let magnitude = magnitude(constant);
    let suffix = if magnitude.starts_with(|c: char| c.is_ascii_digit()) { "_f64" } else { "" };
    if constant.is_negative() { format!("(-{magnitude}{suffix})") } else { format!("{magnitude}{suffix}") }
}

fn magnitude(constant: &Constant) -> String {
    let positive = if constant.is_negative() { constant.negated() } else { constant.clone() };
    let named = NAMED.iter().find(|&&(p, q, pi_exponent, _)| {
        positive.pi_exponent == pi_exponent && positive.factor == num_rational::Ratio::new(p.into(), q.into())
    });
    match (named, positive.to_f64()) {
        (Some((.., name)), _) => format!("::core::f64::consts::{name}"),
        (None, f64::INFINITY) => "f64::INFINITY".to_string(),
        (None, value) => format!("{value:?}"),
    }
}
