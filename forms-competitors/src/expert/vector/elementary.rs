//! Elementary functions of vector registers: argument reduction and a polynomial, without branches.
//! The polynomials come from `coefficients.py`.

use super::Vector;

/// Replacement for a zero denominator; its square does not underflow to zero.
pub const LEAST: f64 = 1e-150;

/// (eʳ − 1 − r)/r² for |r| ≤ ln(2)/2. Relative error of eʳ − 1 below 0.0044 · 2⁻⁵³.
const EXPONENTIAL: [f64; 11] = [
    0.5,
    0.1666666666666667,
    0.04166666666666667,
    0.008333333333326141,
    0.0013888888888883752,
    0.00019841269874800683,
    2.4801587325533502e-05,
    2.75572554255029e-06,
    2.7557273661174726e-07,
    2.5105206475334834e-08,
    2.091467944897855e-09,
];

/// (atan(t)/t − 1)/t² as a polynomial in t², for |t| ≤ tan(π/8). Relative error of atan below 0.049
/// · 2⁻⁵³.
const ARC_TANGENT: [f64; 11] = [
    -0.3333333333333333,
    0.1999999999999552,
    -0.14285714284666534,
    0.11111111015255701,
    -0.0909090457809704,
    0.07692183190202043,
    -0.06664511438591643,
    0.05858148836440617,
    -0.050854493383409805,
    0.03923164675132557,
    -0.019176872981101354,
];

/// ln 2 = high + low. The product of the high part and an integer k, |k| ≤ 1022, is exact.
const LN_2_HIGH: f64 = 0.6931471803691238;
const LN_2_LOW: f64 = 1.9082149292705877e-10;

/// tan(π/8)
const STEEP: f64 = std::f64::consts::SQRT_2 - 1.0;

/// Evaluates a polynomial by Horner's rule. Consecutive iterations of the loop over columns
/// overlap, which hides its latency.
#[inline(always)]
fn polynomial<V: Vector, const N: usize>(coefficients: &[f64; N], x: V) -> V {
    let mut value = V::splat(coefficients[N - 1]);
    for &coefficient in coefficients[..N - 1].iter().rev() {
        value = value.mul_add(x, V::splat(coefficient));
    }
    value
}

/// Returns eˣ and eˣ − 1. With x = k ln 2 + r (Cody and Waite) and q = eʳ − 1 they are 2ᵏ(1 + q)
/// and 2ᵏq + (2ᵏ − 1).
#[inline(always)]
pub fn exp_and_exp_m1<V: Vector>(x: V, round: impl Fn(V) -> V, power_of_two: impl Fn(V) -> V) -> (V, V) {
    let x = x.min(V::splat(708.0)).max(V::splat(-708.0));
    let k = round(x * V::splat(std::f64::consts::LOG2_E));
    let r = k.mul_add(V::splat(-LN_2_LOW), k.mul_add(V::splat(-LN_2_HIGH), x));
    let q = (r * r).mul_add(polynomial(&EXPONENTIAL, r), r);
    let scale = power_of_two(k);
    (scale.mul_add(q, scale), scale.mul_add(q, scale - V::splat(1.0)))
}

/// Angle of (larger, smaller) in the first octant, 0 ≤ smaller ≤ larger, as offset + t(1 + t²P(t²))
/// with t = numerator/denominator and |t| ≤ tan(π/8). Steeper points are measured from the
/// diagonal.
struct Octant<V> {
    offset: V,
    numerator: V,
    denominator: V,
}

impl<V: Vector> Octant<V> {
    #[inline(always)]
    fn of(larger: V, smaller: V) -> Self {
        let (limit, diagonal) = (V::splat(STEEP) * larger, V::splat(std::f64::consts::FRAC_PI_4));
        Octant {
            offset: V::if_less(limit, smaller, diagonal, V::splat(0.0)),
            numerator: V::if_less(limit, smaller, smaller - larger, smaller),
            denominator: V::if_less(limit, smaller, smaller + larger, larger),
        }
    }

    #[inline(always)]
    fn angle(&self, t: V) -> V {
        let z = t * t;
        self.offset + (t * z).mul_add(polynomial(&ARC_TANGENT, z), t)
    }
}

/// Returns the angle in [0, π] of the point (x, y) with y ≥ 0, from its angle in the first octant.
#[inline(always)]
fn unfolded<V: Vector>(octant: V, y: V, x: V) -> V {
    let quadrant = V::if_less(x.abs(), y, V::splat(std::f64::consts::FRAC_PI_2) - octant, octant);
    V::if_less(x, V::splat(0.0), V::splat(std::f64::consts::PI) - quadrant, quadrant)
}

/// Returns the angle of the point (x, y).
#[inline(always)]
pub fn atan2<V: Vector>(y: V, x: V) -> V {
    let (width, height) = (x.abs(), y.abs());
    let octant = Octant::of(width.max(height).max(V::splat(LEAST)), width.min(height));
    let angle = octant.angle(octant.numerator / octant.denominator);
    unfolded(angle, height, x).copysign(y)
}

/// Returns γ/s with γ the angle of the point (x, s), s ≥ 0. The quotient t in γ and the quotient by
/// s share one division.
#[inline(always)]
pub fn angle_over_sine<V: Vector>(s: V, x: V) -> V {
    let (width, s) = (x.abs(), s.max(V::splat(LEAST)));
    let octant = Octant::of(width.max(s), width.min(s));
    let reciprocal = V::splat(1.0) / (octant.denominator * s);
    let angle = octant.angle(octant.numerator * (reciprocal * s));
    unfolded(angle, s, x) * (reciprocal * octant.denominator)
}
