//! Gauss–Kronrod rule: fifteen function values give an integral, and seven of them an estimate of
//! its error.
//!
//! Source: R. Piessens et al., QUADPACK (1983), the pair of 7 and 15 points; the numbers here have
//! 31 digits, in two words.

use forms::math::Real;

/// Number of function values of the rule.
pub(super) const POINTS: usize = 15;

/// A node in [0, 1) of the interval [−1, 1], its weight, and its weight in the rule of seven
/// points, or 0 if it is not part of that rule.
type Node = [[f64; 2]; 3];

/// The non-negative nodes; the others are their mirror images.
const NODES: [Node; 8] = [
    [[0.0, 0.0], [0.20948214108472782, 9.321252782204223e-18], [0.4179591836734694, -1.5497807119257288e-17]],
    [[0.20778495500789848, -1.322698778629045e-17], [0.20443294007529889, 6.740401802865974e-18], [0.0, 0.0]],
    [
        [0.4058451513773972, -1.72492754475471e-17],
        [0.19035057806478542, -9.616513280901216e-18],
        [0.3818300505051189, 2.1862747923824822e-17],
    ],
    [[0.5860872354676911, -1.7466970805984817e-17], [0.1690047266392679, -7.56643290985809e-18], [0.0, 0.0]],
    [
        [0.7415311855993945, -2.0220134774069897e-17],
        [0.14065325971552592, -2.484164787968961e-19],
        [0.27970539148927664, 2.3267180221717138e-17],
    ],
    [[0.8648644233597691, -2.3887783447584197e-17], [0.10479001032225019, -3.90658597958814e-18], [0.0, 0.0]],
    [
        [0.9491079123427585, 3.82579658786657e-17],
        [0.06309209262997856, -4.536585404360517e-18],
        [0.1294849661688697, -9.625448970284404e-18],
    ],
    [[0.9914553711208126, 2.7322067495382985e-17], [0.022935322010529224, 5.957180517223158e-19], [0.0, 0.0]],
];

/// Returns the node with this index, in order from −1 to 1, and its two weights.
fn node<T: Real>(place: usize) -> [T; 3] {
    let from_middle = place.abs_diff(POINTS / 2);
    let [at, weight, of_seven] = NODES[from_middle].map(|words| T::constant(&words));
    [if place < POINTS / 2 { -at } else { at }, weight, of_seven]
}

/// Returns the nodes of the rule in an interval.
pub(super) fn places<T: Real>(middle: T, half: T) -> [T; POINTS] {
    std::array::from_fn(|place| half.mul_add(node::<T>(place)[0], middle))
}

/// Integral over an interval, integral of the absolute values, and estimate of the rule's error.
#[derive(Clone, Copy)]
pub(super) struct Integral<T> {
    pub(super) value: T,
    pub(super) magnitude: f64,
    pub(super) error: f64,
}

/// Integrates a function with these values at the nodes of an interval of this half length.
///
/// The error of the finer rule is far below the difference δ of the two rules. It is estimated as D
/// (200 δ/D)^(3/2) where that is less than D, the integral of the distances from the mean.
pub(super) fn integral<T: Real>(values: &[T], half: T) -> Integral<T> {
    let zero = T::from_f64(0.0);
    let (mut fine, mut coarse, mut magnitude) = (zero, zero, 0.0);
    for (place, &value) in values.iter().enumerate() {
        let [_, weight, of_seven] = node::<T>(place);
        fine = weight.mul_add(value, fine);
        coarse = of_seven.mul_add(value, coarse);
        magnitude += weight.to_f64() * value.to_f64().abs();
    }
    let mean = 0.5 * fine.to_f64();
    let deviation = |(place, value): (usize, &T)| node::<f64>(place)[1] * (value.to_f64() - mean).abs();
    let spread: f64 = values.iter().enumerate().map(deviation).sum();
    let difference = (fine - coarse).to_f64().abs();
    let error =
        if spread > 0.0 { spread * (200.0 * difference / spread).powf(1.5).min(1.0) } else { difference };
    let length = half.to_f64();
    Integral { value: half * fine, magnitude: length * magnitude, error: length * error }
}

#[cfg(test)]
mod tests {
    use super::*;
    use forms::math::DoubleDouble;

    #[test]
    fn polynomials_of_degree_22_are_integrated_exactly() {
        for degree in 0..=22 {
            let two = DoubleDouble::from_f64(2.0);
            let power = |x: DoubleDouble| (0..degree).fold(DoubleDouble::from_f64(1.0), |power, _| power * x);
            let values = places(two, DoubleDouble::from_f64(1.0)).map(power);
            let found = integral(&values, DoubleDouble::from_f64(1.0)).value;
            // (3^(n + 1) - 1)/(n + 1)
            let top = (0..=degree)
                .fold(DoubleDouble::from_f64(1.0), |power, _| power * DoubleDouble::from_f64(3.0));
            let exact = (top - DoubleDouble::from_f64(1.0)) / DoubleDouble::from_f64(f64::from(degree + 1));
            let error = ((found - exact) / exact).to_f64().abs();
            assert!(error < 1e-29, "degree {degree}: {error:e}");
        }
    }

    #[test]
    fn the_estimate_is_above_the_error_of_a_root() {
        let found = integral(&places(0.5, 0.5).map(f64::sqrt), 0.5);
        let error = (found.value - 2.0 / 3.0).abs();
        assert!(1e-6 < error && error <= found.error && found.error < 0.1, "{error:e}, {:e}", found.error);
    }
}
