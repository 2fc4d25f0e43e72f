//! Guarantees of an enclosure: known digits, containment laws, the edges of domains, the shared
//! graph.

mod digits;
mod domain;
mod graph;
mod laws;
mod word;

use super::{Enclosure, Precision};
use crate::expression::Rational;

fn exact(n: i64, d: i64) -> Rational {
    Rational::new(n.into(), d.into())
}

/// 2⁻ᵖ
fn unit(precision: u32) -> Rational {
    Rational::new(1.into(), num_bigint::BigInt::from(1) << precision)
}

fn at(n: i64, d: i64, precision: Precision) -> Enclosure {
    Enclosure::exact(&exact(n, d), precision)
}

/// n/d at 128 bits.
fn number(n: i64, d: i64) -> Enclosure {
    at(n, d, Precision(128))
}

/// [a, b] at 128 bits.
fn interval(a: (i64, i64), b: (i64, i64)) -> Enclosure {
    Enclosure::between(&exact(a.0, a.1), &exact(b.0, b.1), Precision(128))
}
