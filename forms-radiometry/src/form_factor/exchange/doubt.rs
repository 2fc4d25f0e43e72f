//! Doubts: how far the integral of a form factor over a patch can be off, from its values at the
//! points of a rule.
//!
//! ```text
//! 3 × 3 points ──────────────── bends along rows and columns
//! 6 × 6 points of the quarters ─┬─ one aspect: the change of the integral is enough
//!                               ├─ several aspects: fifth differences, and the variation
//!                               └─ unknown: fifth differences
//! ```
//! The change of an integral by refinement is zero for some places of a kink. Fifth differences are
//! zero for others, and both vanish only for a kink between the points and the border.

use super::areas::gauss;
use crate::visibility::Aspects;
use std::sync::OnceLock;

/// Number of points of the rule along each side of a patch, and on all of it.
pub(super) const ORDER: usize = 3;
pub(super) const POINTS: usize = ORDER * ORDER;

/// Number of parts of a patch.
pub(super) const QUARTERS: usize = 4;

/// Part of the fifth difference of the integrand that counts as doubt: several times as much as the
/// integral of a function with a kink is in error on average.
const FIFTH: f64 = 0.8;

/// Part of the variation within a patch that counts as doubt: a kink nearer to the border than all
/// points, which are at 0.056 of its width, changes no difference, and the integral by 0.056²/2 times
/// the change of the slope.
const BORDER: f64 = 0.002;

/// Returns the sum of the differences between the integrals along the rows and columns of the
/// points of a patch and those by their middles, and the sum of their absolute values.
///
/// Weights 5, 8, 5 over 18 give the difference (5 f₁ + 8 f₂ + 5 f₃ − 18 f₂)/18.
pub(super) fn of_few(values: &[f64; POINTS]) -> [f64; 2] {
    let of = |[a, b, c]: [usize; 3]| values[a] - 1.25 * values[b] + values[c];
    let all = (0..ORDER).flat_map(|k| [of([3 * k, 3 * k + 1, 3 * k + 2]), of([k, k + 3, k + 6])]);
    all.fold([0.0; 2], |[sum, absolute], bend| [sum + bend, absolute + bend.abs()])
}

/// Returns the doubt about the integral over four quarters with these aspects, beside its change.
pub(super) fn of_kinks(values: &[[f64; POINTS]], aspects: Aspects) -> f64 {
    match aspects {
        Aspects::One => 0.0,
        Aspects::Several => (FIFTH * fifth_differences(values)).max(BORDER * variation(values)),
        Aspects::Unknown => FIFTH * fifth_differences(values),
    }
}

/// Returns the largest difference between points of four quarters, values times weights, as an
/// integral over all of them.
fn variation(values: &[[f64; POINTS]]) -> f64 {
    let weight = |place: usize| gauss(ORDER)[place][1];
    let all = || values.iter().flat_map(|quarter| quarter.iter().enumerate());
    let of = || all().map(|(index, value)| value / weight(index / ORDER) / weight(index % ORDER));
    QUARTERS as f64 * (of().fold(f64::NEG_INFINITY, f64::max) - of().fold(f64::INFINITY, f64::min))
}

/// Returns the larger of the sums of the absolute fifth differences along the rows and along the
/// columns of the points of four quarters, values times weights: rows have points of two quarters.
///
/// The divided difference with the coefficients 1/∏(xⱼ − xᵢ) vanishes for polynomials of degree 4;
/// here its coefficients for f have norm 1, and it is zero for kinks in other places than where the
/// change of the integral is.
fn fifth_differences(values: &[[f64; POINTS]]) -> f64 {
    static COEFFICIENTS: OnceLock<[f64; 2 * ORDER]> = OnceLock::new();
    let coefficients = COEFFICIENTS.get_or_init(|| {
        let nodes: [[f64; 2]; 2 * ORDER] = std::array::from_fn(|index| {
            let [x, weight] = gauss(ORDER)[index % ORDER];
            [0.5 * (x + (index / ORDER) as f64), 0.5 * weight]
        });
        let of = |&[x, _]: &[f64; 2]| {
            let others = nodes.iter().map(|[other, _]| x - other).filter(|apart| *apart != 0.0);
            others.product::<f64>().recip()
        };
        let norm = nodes.iter().map(|node| of(node).powi(2)).sum::<f64>().sqrt();
        nodes.map(|node| of(&node) / norm / node[1])
    });
    let difference = |place: &dyn Fn(usize) -> f64| {
        coefficients.iter().enumerate().map(|(index, factor)| factor * place(index)).sum::<f64>().abs()
    };
    let (mut along, mut across) = (0.0, 0.0);
    for other in 0..2 * ORDER {
        let (half, k) = (other / ORDER, other % ORDER);
        along += difference(&|index| values[index / ORDER + 2 * half][ORDER * (index % ORDER) + k]);
        across += difference(&|index| values[half + 2 * (index / ORDER)][ORDER * k + index % ORDER]);
    }
    along.max(across)
}

#[cfg(test)]
mod tests {
    use super::*;
    use forms_testing::SplitMix;

    /// Returns the values times weights of a function on the quarters of the unit square.
    fn on_quarters(f: impl Fn(f64, f64) -> f64) -> [[f64; POINTS]; QUARTERS] {
        std::array::from_fn(|quarter| {
            std::array::from_fn(|index| {
                let [[s, of_s], [t, of_t]] = [index / ORDER, index % ORDER].map(|place| gauss(ORDER)[place]);
                let [x, y] = [(s, quarter & 1), (t, quarter >> 1)].map(|(at, half)| 0.5 * (at + half as f64));
                0.25 * of_s * of_t * f(x, y)
            })
        })
    }

    /// Returns the integral by the rule on the square.
    fn by_nine_points(f: impl Fn(f64, f64) -> f64) -> f64 {
        let rule = gauss(ORDER);
        rule.iter()
            .flat_map(|[s, of_s]| rule.iter().map(|[t, of_t]| of_s * of_t * f(*s, *t)).collect::<Vec<_>>())
            .sum()
    }

    #[test]
    fn polynomials_of_degree_four_have_no_fifth_differences() {
        for power in 0..5 {
            let found = fifth_differences(&on_quarters(|x, y| x.powi(power) * y.powi(4 - power)));
            assert!(found < 1e-14, "{power}: {found:e}");
        }
        assert!(fifth_differences(&on_quarters(|x, _| x.powi(5))) > 1e-4);
    }

    #[test]
    fn the_variation_is_that_of_the_values() {
        let found = variation(&on_quarters(|x, y| if x + y > 1.0 { 3.0 } else { 1.0 }));
        assert!((found - 2.0).abs() < 1e-12, "{found}");
    }

    #[test]
    fn integrals_with_a_kink_are_seldom_off_by_more_than_the_doubt() {
        let mut random = SplitMix(17);
        let mut beyond = [0; 2];
        for _ in 0..1500 {
            let (turn, place) = (random.between([0.0, 7.0]), random.between([-0.5, 0.5]));
            let f = |x: f64, y: f64| ((x - 0.5) * turn.cos() + (y - 0.5) * turn.sin() - place).max(0.0);
            let values = on_quarters(f);
            let sum: f64 = values.iter().flatten().sum();
            let points = 200;
            let middle = |index: usize| (index as f64 + 0.5) / points as f64;
            let rows = (0..points).flat_map(|i| (0..points).map(move |j| (i, j)));
            let exact = rows.map(|(i, j)| f(middle(i), middle(j))).sum::<f64>() / (points * points) as f64;
            let change = (sum - by_nine_points(f)).abs();
            let doubts = [change, change.max(of_kinks(&values, Aspects::Several))];
            for (beyond, doubt) in beyond.iter_mut().zip(doubts) {
                *beyond += usize::from((sum - exact).abs() > doubt + 5e-6);
            }
        }
        // by the change alone, a tenth are
        assert!(beyond[0] > 100 && beyond[1] < 20, "{beyond:?}");
    }
}
