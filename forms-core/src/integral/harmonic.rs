//! Products of powers of one sine and cosine as sums over multiples of the angle.

use crate::expression::Rational;
use num_traits::Zero;
use std::collections::BTreeMap;

/// 1, cos(mu) or sin(mu) with m > 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Harmonic {
    /// 1
    Constant,
    /// cos(mu) or sin(mu)
    Wave {
        /// m
        multiple: u32,
        /// Whether it is the sine.
        is_sine: bool,
    },
}

/// Expands cosᵖu sin^q u by repeated use of 2 cos a cos b = cos(a+b) + cos(a−b) and similar
/// identities.
pub(super) fn products_to_sums(cosines: u32, sines: u32) -> Vec<(Harmonic, Rational)> {
    let one = Rational::from_integer(1.into());
    let mut sum: BTreeMap<Harmonic, Rational> = BTreeMap::from([(Harmonic::Constant, one)]);
    for place in 0..cosines + sines {
        let mut next: BTreeMap<Harmonic, Rational> = BTreeMap::new();
        for (harmonic, share) in &sum {
            for (product, factor) in times_basic(*harmonic, place >= cosines) {
                *next.entry(product).or_insert_with(Rational::zero) += share * factor;
            }
        }
        next.retain(|_, share| !share.is_zero());
        sum = next;
    }
    sum.into_iter().collect()
}

/// h(mu) · cos u or h(mu) · sin u
fn times_basic(harmonic: Harmonic, by_sine: bool) -> Vec<(Harmonic, Rational)> {
    let half = |sign: i64| Rational::new(sign.into(), 2.into());
    let Harmonic::Wave { multiple, is_sine } = harmonic else {
        return vec![(Harmonic::Wave { multiple: 1, is_sine: by_sine }, Rational::from_integer(1.into()))];
    };
    let (up, down) = (i64::from(multiple) + 1, i64::from(multiple) - 1);
    let terms = match (is_sine, by_sine) {
        // cos a cos b, sin a cos b, cos a sin b, sin a sin b
        (false, false) => [(up, false, 1), (down, false, 1)],
        (true, false) => [(up, true, 1), (down, true, 1)],
        (false, true) => [(up, true, 1), (down, true, -1)],
        (true, true) => [(up, false, -1), (down, false, 1)],
    };
    terms.into_iter().filter_map(|(m, is_sine, sign)| Some((wave(m, is_sine)?, half(sign)))).collect()
}

/// cos 0 = 1, sin 0 = 0
fn wave(multiple: i64, is_sine: bool) -> Option<Harmonic> {
    match (multiple, is_sine) {
        (0, true) => None,
        (0, false) => Some(Harmonic::Constant),
        _ => Some(Harmonic::Wave { multiple: multiple as u32, is_sine }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::ToPrimitive;

    #[test]
    fn sums_of_waves_equal_the_products_they_came_from() {
        for (p, q) in [(0, 0), (1, 0), (0, 1), (2, 0), (0, 2), (3, 2), (4, 1), (0, 5), (6, 3)] {
            for u in [0.0, 0.3, 1.0, 2.5, -1.7] {
                let direct = f64::cos(u).powi(p) * f64::sin(u).powi(q);
                let sum: f64 = products_to_sums(p as u32, q as u32)
                    .into_iter()
                    .map(|(harmonic, share)| share.to_f64().unwrap() * value(harmonic, u))
                    .sum();
                assert!((direct - sum).abs() < 1e-14, "cos^{p} sin^{q} at {u}: {direct} and {sum}");
            }
        }
    }

    fn value(harmonic: Harmonic, u: f64) -> f64 {
        match harmonic {
            Harmonic::Constant => 1.0,
            Harmonic::Wave { multiple, is_sine: false } => (f64::from(multiple) * u).cos(),
            Harmonic::Wave { multiple, is_sine: true } => (f64::from(multiple) * u).sin(),
        }
    }
}
