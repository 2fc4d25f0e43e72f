//! erf and erfc by polynomials: erf x = x p(x²) up to ½, and erfc |x| = e^(−x²) q/(|x| + 2) beyond, with a
//! polynomial q of (|x| − 2)/(|x| + 2).

mod coefficients;

use super::DoubleDouble;
use coefficients::{ERF, ERFC};

/// Up to here erf is a polynomial.
const INNER: f64 = 0.5;
/// From here on erfc x is below every positive number.
const ERFC_IS_ZERO: f64 = 28.0;
/// From here on 1 − erf x is below the last bit of 1.
const ERF_IS_ONE: f64 = 9.0;
/// Below this, x² does not count.
const SMALL: f64 = f64::from_bits((1023 - 110) << 52);

/// Evaluates c₀ + c₁ x + …
fn polynomial(coefficients: &[[f64; 2]], x: DoubleDouble) -> DoubleDouble {
    let number = |&[high, low]: &[f64; 2]| DoubleDouble { high, low };
    coefficients.iter().rev().fold(DoubleDouble::ZERO, |sum, words| sum.times(x).plus(number(words)))
}

/// Computes erf x for |x| ≤ ½.
fn inner(x: DoubleDouble) -> DoubleDouble {
    let square = if x.high.abs() < SMALL { DoubleDouble::ZERO } else { x.times(x) };
    x.times(polynomial(&ERF, square))
}

/// Computes erfc x for ½ ≤ x < 28.
fn outer(x: DoubleDouble) -> DoubleDouble {
    let shifted = x.plus_f64(2.0);
    let quotient = polynomial(&ERFC, x.plus_f64(-2.0).over(shifted)).over(shifted);
    decay(x).times(quotient)
}

/// Computes e^(−x²) = e^(−h²) e^(−(x − h)(x + h)), where h has so few digits that its square is exact:
/// the error of x² would be multiplied by x².
fn decay(x: DoubleDouble) -> DoubleDouble {
    let leading = f64::from_bits(x.high.to_bits() & (u64::MAX << 27));
    let rest = x.plus_f64(-leading).times(x.plus_f64(leading));
    DoubleDouble::new(-leading * leading, 0.0).exponential().times(rest.negated().exponential())
}

impl DoubleDouble {
    /// Computes erf x, within 32 units.
    pub(super) fn error_function(self) -> Self {
        let (size, is_negative) = if self.high < 0.0 { (self.negated(), true) } else { (self, false) };
        if self.high.is_nan() || size.high <= INNER {
            return inner(self);
        }
        let value = if size.high > ERF_IS_ONE { Self::ONE } else { Self::ONE.plus(outer(size).negated()) };
        if is_negative { value.negated() } else { value }
    }

    /// Computes erfc x, within a relative error of 512 units where the value is above 2⁻⁹⁰⁰.
    pub(super) fn complementary_error_function(self) -> Self {
        if self.high.is_nan() || self.high.abs() <= INNER {
            return Self::ONE.plus(inner(self).negated());
        }
        let size = if self.high < 0.0 { self.negated() } else { self };
        let tail = if size.high >= ERFC_IS_ZERO { Self::ZERO } else { outer(size) };
        if self.high < 0.0 { Self::new(2.0, 0.0).plus(tail.negated()) } else { tail }
    }
}
