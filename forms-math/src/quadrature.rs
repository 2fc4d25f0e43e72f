//! ∫ₐᵇ f(t) dt by the double-exponential rule, with an estimate of its error. Intervals with slow
//! convergence are halved.
//!
//! With t = a + (b − a) w(s), w = 1/(1 + e^(−π sinh s)), the integrand falls doubly exponentially
//! in s, also at a weak singularity of f at an end, and the trapezoidal sum over s = kh converges
//! exponentially in 1/h.
//!
//! Source: H. Takahasi, M. Mori, Double exponential formulas for numerical integration, Publ. RIMS
//! 9 (1974); the estimate of the error: D. H. Bailey, K. Jeyabalan, X. S. Li, A comparison of three
//! high-precision quadrature schemes, Experimental Mathematics 14 (2005).

use alloc::vec;
use alloc::vec::Vec;

use crate::Real;
use crate::float;
use crate::scalar::Scalar;
use crate::table::table;

/// Returns the largest number of intervals of an integral; it is smaller for higher precisions,
/// whose intervals need more nodes.
const fn most_intervals(precision: u32) -> u32 {
    let intervals = 256 * f64::MANTISSA_DIGITS / precision;
    if intervals < 16 { 16 } else { intervals }
}

/// Node in the unit interval, measured from its nearer end, with its weight.
#[derive(Clone, Copy)]
struct Node<S> {
    place: S,
    weight: S,
}

struct Nodes;

/// Returns the nodes s = 0, h, 2h, … for level 0 (h = ½), and the odd multiples of
/// h = 2^(−1 − level) for the other levels.
fn nodes<S: Scalar>(level: u32) -> &'static [Node<S>] {
    table::<Nodes, Node<S>>(level as usize, || {
        let one = S::Wider::from_f64(1.0);
        let (first, stride) = if level == 0 { (0.0, 1.0) } else { (1.0, 2.0) };
        let last = one.scaled(-2 * i64::from(S::PRECISION));
        let mut nodes = Vec::new();
        let mut multiple = first;
        loop {
            let s = S::Wider::from_f64(multiple).scaled(-1 - i64::from(level));
            let decay = (-(S::Wider::pi() * s.sinh())).exp();
            let place = decay / (one + decay);
            let weight = S::Wider::pi() * s.cosh() * place / (one + decay);
            if place < last {
                return nodes;
            }
            nodes.push(Node { place: S::rounded(place), weight: S::rounded(weight) });
            multiple += stride;
        }
    })
}

/// Properties of the number type that the rule integrates.
pub(crate) struct Kind<T, S> {
    /// Converts a node or a weight to the number type.
    pub(crate) of: fn(S) -> T,
    /// Converts to a nearby scalar, to judge convergence.
    pub(crate) number: fn(T) -> S,
    /// Number of significant bits of the integrand's values.
    pub(crate) bits: u32,
}

impl<T, S: Scalar> Kind<T, S> {
    /// Returns the relative tolerance: levels are added until the estimate is within two ulp of the
    /// scale.
    fn tolerance(&self) -> S {
        S::from_f64(4.0).scaled(-i64::from(self.bits))
    }
    /// Returns the tolerance of an interval: it is halved if the estimate exceeds the error that
    /// the rounding of the integrand alone can cause.
    fn tolerance_of_interval(&self) -> S {
        self.tolerance().scaled(6)
    }
}

/// Integral with an estimate of the error of the rule.
struct Estimate<T, S> {
    value: T,
    magnitude: S,
    error: S,
}

/// Computes the integral and an estimate of the error of the rule, without the rounding error of
/// the integrand.
pub(crate) fn double_exponential<T: Real, S: Scalar>(
    from: T,
    to: T,
    integrand: impl Fn(T) -> T,
    kind: &Kind<T, S>,
) -> (T, S) {
    let zero = S::from_f64(0.0);
    let (mut total, mut error, mut magnitude) = ((kind.of)(zero), zero, zero);
    let mut open = vec![(from, to)];
    let mut intervals = 0;
    while let Some((start, end)) = open.pop() {
        intervals += 1;
        let estimate = over_interval(start, end, &integrand, kind, magnitude);
        let scale = if magnitude > estimate.magnitude { magnitude } else { estimate.magnitude };
        if estimate.error > scale * kind.tolerance_of_interval()
            && intervals + (open.len() as u32) < most_intervals(S::PRECISION)
        {
            let middle = (start + end) * (kind.of)(S::from_f64(0.5));
            open.push((middle, end));
            open.push((start, middle));
            continue;
        }
        total = total + estimate.value;
        error = error + estimate.error;
        magnitude = magnitude + estimate.magnitude;
    }
    (total, error)
}

/// Adds levels until the estimate is within the tolerance of the larger of the integral and
/// `scale`, or until the last level.
fn over_interval<T: Real, S: Scalar>(
    from: T,
    to: T,
    integrand: &impl Fn(T) -> T,
    kind: &Kind<T, S>,
    scale: S,
) -> Estimate<T, S> {
    let zero = S::from_f64(0.0);
    let length = to - from;
    let span = (kind.number)(length).abs();
    let (mut sum, mut magnitude) = ((kind.of)(zero), zero);
    let last = 5 + (S::PRECISION / 53).ilog2();
    let mut sums = [zero; 3];
    let mut estimate = Estimate { value: sum, magnitude, error: zero };
    for level in 0..=last {
        for (index, node) in nodes::<S>(level).iter().enumerate() {
            let centre = level == 0 && index == 0;
            let (more, size) = at_node(from, to, length, integrand, kind, *node, centre);
            sum = sum + more;
            magnitude = magnitude + size;
        }
        let step = -1 - i64::from(level);
        let value = sum * length * (kind.of)(S::from_f64(1.0).scaled(step));
        sums = [(kind.number)(value), sums[0], sums[1]];
        estimate = Estimate { value, magnitude: (magnitude * span).scaled(step), error: sums[0] };
        if level < 2 {
            continue;
        }
        let scale = if scale > estimate.magnitude { scale } else { estimate.magnitude };
        estimate.error = rule_error(sums, scale);
        // NaN also ends the loop.
        if estimate.error > scale * kind.tolerance() {
            continue;
        }
        break;
    }
    estimate
}

/// Returns w f at the node plus its mirror image, and the sum of their magnitudes. A node that
/// rounds to an end counts as zero.
fn at_node<T: Real, S: Scalar>(
    from: T,
    to: T,
    length: T,
    integrand: &impl Fn(T) -> T,
    kind: &Kind<T, S>,
    node: Node<S>,
    centre: bool,
) -> (T, S) {
    let weight = (kind.of)(node.weight);
    let offset = length * (kind.of)(node.place);
    let at = |place: T, end: T| {
        if (kind.number)(place) == (kind.number)(end) {
            return (kind.of)(S::from_f64(0.0));
        }
        integrand(place) * weight
    };
    let first = at(from + offset, from);
    if centre {
        return (first, (kind.number)(first).abs());
    }
    let second = at(to - offset, to);
    (first + second, (kind.number)(first).abs() + (kind.number)(second).abs())
}

/// Estimates the error of the newest of three sums: each level squares the difference, relative to
/// the scale. A difference smaller than the square of the previous one is accidental.
fn rule_error<S: Scalar>(sums: [S; 3], scale: S) -> S {
    let zero = S::from_f64(0.0);
    let newest = (sums[0] - sums[1]).abs();
    let older = (sums[0] - sums[2]).abs();
    if newest == zero || scale == zero {
        return newest;
    }
    let digits = |difference: S| (difference / scale).ln().to_f64();
    let (newest_digits, older_digits) = (digits(newest), digits(older));
    if newest_digits >= -3.0 || older_digits >= 0.0 {
        return newest;
    }
    let newest_digits = newest_digits.max(2.0 * older_digits);
    let predicted = (newest_digits * newest_digits / older_digits).max(2.0 * newest_digits);
    scale.scaled(float::f64::ceil(predicted / core::f64::consts::LN_2) as i64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn convergence_squares_the_differences() {
        let error: f64 = rule_error([1.0, 1.0 + 1e-6, 1.0 + 1e-3], 1.0);
        assert!((0.5e-12..2e-12).contains(&error), "{error}");
    }

    #[test]
    fn sums_that_agree_by_chance_are_no_convergence() {
        let error: f64 = rule_error([1.0, 1.0 + 1e-13, 1.0 + 1e-3], 1.0);
        assert!(error > 0.5e-12, "{error}");
    }

    #[test]
    fn a_smooth_integrand_that_two_levels_agree_on_by_chance_is_integrated() {
        // The H function of Chandrasekhar, by the formula of Stibbs and Weir.
        let (albedo, cosine) = (0.11979952456552519_f64, 0.41128390788583297_f64);
        let integrand = |p: f64| {
            let turned = p.sin().atan2(cosine * p.cos());
            (-albedo * turned * cosine * p.cos() / p.sin()).ln_1p()
        };
        let kind = Kind::<f64, f64> { of: |number| number, number: |number| number, bits: 53 };
        let (integral, error) = double_exponential(0.0, core::f64::consts::FRAC_PI_2, integrand, &kind);
        assert!((integral + 0.099_655_980_272_441_05).abs() < 2e-16, "{integral}");
        assert!(error < 1e-15, "{error}");
    }
}
