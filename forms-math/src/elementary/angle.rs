//! The angle of a point, and the inverse circular functions as angles.

use super::odd_series;
use crate::float;
use crate::scalar::Scalar;

/// Computes the angle of the point (x, y) in (−π, π] as
/// a + arctan((y cos a − x sin a)/(x cos a + y sin a)): a is the angle computed in `f64`, by which
/// the point is rotated back.
pub(crate) fn angle<T: Scalar>(y: T, x: T) -> T {
    let zero = T::from_f64(0.0);
    if y == zero {
        return match x.partial_cmp(&zero) {
            None => T::nan(),
            Some(core::cmp::Ordering::Less) => T::pi(),
            Some(_) => y,
        };
    }
    let (Some(of_y), Some(of_x)) = (y.exponent(), x.exponent().or((x == zero).then_some(i64::MIN))) else {
        return T::from_f64(float::f64::atan2(y.to_f64(), x.to_f64()));
    };
    let larger = of_y.max(of_x);
    let (x, y) = (x.scaled(-larger), y.scaled(-larger));
    let start = T::from_f64(float::f64::atan2(y.to_f64(), x.to_f64()));
    let (sine, cosine) = start.sine_and_cosine();
    start + odd_series((y * cosine - x * sine) / (x * cosine + y * sine), -1.0)
}

/// Computes arctan x, the angle of (1, x).
pub(crate) fn arc_tangent<T: Scalar>(x: T) -> T {
    angle(x, T::from_f64(1.0))
}

/// Computes arcsin x, the angle of (√(1 − x²), x).
pub(crate) fn arc_sine<T: Scalar>(x: T) -> T {
    angle(x, other_leg(x))
}

/// Computes arccos x, the angle of (x, √(1 − x²)).
pub(crate) fn arc_cosine<T: Scalar>(x: T) -> T {
    angle(other_leg(x), x)
}

/// Computes √((1 − x)(1 + x)); NaN for |x| > 1.
fn other_leg<T: Scalar>(x: T) -> T {
    let one = T::from_f64(1.0);
    ((one - x) * (one + x)).sqrt()
}
