//! Samples: arguments in the domain with the values of a kernel at them.

use super::arguments::Arguments;
use super::edges::Edges;
use super::format::{Format, Rounded};
use super::ordinal::Width;
use super::regime::Regime;
use super::truth::{Truth, Value};
use crate::expression::{Pool, Rational, Relation, Symbol};
use crate::kernel::evaluate_f64;
use crate::random::SplitMix;
use crate::theory::Kernel;

/// Number of candidates tried for each requested sample.
const CANDIDATES: usize = 24;

/// Values that need more binary places than this are not used as samples: squares of the least
/// numbers have about 2200.
const MOST_PLACES: u32 = 2500;

/// Number of times that a candidate outside the domain is moved half-way to a sample inside it.
const PULLS: usize = 6;

/// Arguments with the value of each output, to about 32 digits; `None` where an output has no
/// certain value.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// One number for each argument of the kernel.
    pub arguments: Vec<f64>,
    /// Each value as the sum of the nearest `f64` and the `f64` nearest to the remainder.
    pub values: Vec<Option<(f64, f64)>>,
}

/// The samples of one regime.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples {
    /// The regime.
    pub regime: Regime,
    /// The samples in the order in which they were drawn; fewer than requested where the domain
    /// leaves few.
    pub samples: Vec<Sample>,
    /// Number of candidates inside the domain for which no tried precision gave a certain value.
    pub undecided: usize,
}

/// Returns samples of a kernel: `count` for each regime that it has, with arguments of the given
/// width.
///
/// A value that is not a finite number of the width is omitted, and so are points at which the
/// formula is not defined.
pub fn sample(
    pool: &Pool,
    kernel: &Kernel,
    width: Width,
    regimes: &[Regime],
    count: usize,
    seed: u64,
) -> Vec<Samples> {
    let edges = Edges::of(&mut pool.clone(), kernel);
    // a domain whose bounds cross has no arguments
    if edges.ranges.iter().any(|range| matches!(*range, (Some(lower), Some(upper)) if lower > upper)) {
        return Vec::new();
    }
    let truth = Truth::new(pool, &kernel.outputs, &kernel.domain).up_to(MOST_PLACES);
    let drawn = regimes.iter().map(|&regime| {
        let seed = seed ^ (regime as u64 + 1).wrapping_mul(0xd6e8_feb8_6659_fd93);
        let arguments = Arguments { edges: &edges, width, random: SplitMix(seed) };
        Drawing { pool, kernel, truth: &truth, width, arguments, inside: None }.samples(regime, count)
    });
    drawn.filter(|samples| !samples.samples.is_empty()).collect()
}

/// Returns the samples at given arguments, if they lie in the domain and some output has a certain
/// value.
pub(crate) fn sample_at(pool: &Pool, kernel: &Kernel, width: Width, points: &[Vec<f64>]) -> Vec<Sample> {
    let edges = Edges::of(&mut pool.clone(), kernel);
    let truth = Truth::new(pool, &kernel.outputs, &kernel.domain).up_to(MOST_PLACES);
    let arguments = Arguments { edges: &edges, width, random: SplitMix(0) };
    let drawing = Drawing { pool, kernel, truth: &truth, width, arguments, inside: None };
    points.iter().filter_map(|point| drawing.sample(point)).collect()
}

/// The exact value of each argument.
type Point = Vec<(Symbol, Rational)>;

struct Drawing<'a> {
    pool: &'a Pool,
    kernel: &'a Kernel,
    truth: &'a Truth<'a>,
    width: Width,
    arguments: Arguments<'a>,
    /// Arguments known to be in the domain.
    inside: Option<Vec<f64>>,
}

impl Drawing<'_> {
    fn samples(&mut self, regime: Regime, count: usize) -> Samples {
        let mut found = Samples { regime, samples: Vec::new(), undecided: 0 };
        for _ in 0..count * CANDIDATES {
            if found.samples.len() == count || found.undecided > count {
                break;
            }
            let Some(candidate) = self.arguments.next(regime) else { break };
            let Some((arguments, point)) = self.within(candidate) else { continue };
            let values: Vec<Value> = self.truth.at(&point, Format::DoubleDouble);
            found.undecided += usize::from(values.contains(&Value::Undecided));
            let values: Vec<_> = values.into_iter().map(|value| self.representable(value)).collect();
            if values.iter().any(Option::is_some) {
                self.inside.get_or_insert_with(|| arguments.clone());
                found.samples.push(Sample { arguments, values });
            }
        }
        found
    }

    /// Returns the sample at these arguments, if they are in the domain and some output has a
    /// certain value.
    fn sample(&self, arguments: &[f64]) -> Option<Sample> {
        let numbers: Option<Vec<Rational>> =
            arguments.iter().map(|&value| Rational::from_float(value)).collect();
        let point: Point = self.kernel.arguments.iter().copied().zip(numbers?).collect();
        if !self.seems_inside(arguments) || self.truth.admits(&point) != Some(true) {
            return None;
        }
        let values = self.truth.at(&point, Format::DoubleDouble).into_iter();
        let values: Vec<_> = values.map(|value| self.representable(value)).collect();
        let is_known = values.iter().any(Option::is_some);
        is_known.then(|| Sample { arguments: arguments.to_vec(), values })
    }

    /// Returns the arguments, moved into the domain if possible, together with the exact point.
    fn within(&self, mut arguments: Vec<f64>) -> Option<(Vec<f64>, Point)> {
        for _ in 0..=PULLS {
            if self.seems_inside(&arguments) {
                let numbers: Option<Vec<Rational>> =
                    arguments.iter().map(|&value| Rational::from_float(value)).collect();
                let point: Point = self.kernel.arguments.iter().copied().zip(numbers?).collect();
                if self.truth.admits(&point) == Some(true) {
                    return Some((arguments, point));
                }
            }
            let inside = self.inside.as_ref()?;
            for (value, inside) in arguments.iter_mut().zip(inside) {
                *value = self.width.round(*value / 2.0 + inside / 2.0);
            }
        }
        None
    }

    /// Whether the conditions hold in floating point: a quick check that saves exact arithmetic.
    fn seems_inside(&self, arguments: &[f64]) -> bool {
        if !arguments.iter().all(|value| value.is_finite()) {
            return false;
        }
        let sides: Vec<_> = self.kernel.domain.iter().flat_map(|c| [c.left, c.right]).collect();
        let values: Vec<(Symbol, f64)> =
            self.kernel.arguments.iter().copied().zip(arguments.iter().copied()).collect();
        let Some(sides) = evaluate_f64(self.pool, &sides, &values) else { return false };
        self.kernel.domain.iter().zip(sides.chunks_exact(2)).all(|(condition, side)| {
            let strict = condition.relation == Relation::NotEqual;
            strict || side[0] == side[1] || holds(condition.relation, side[0], side[1])
        })
    }

    /// Returns the value, if it is a finite number of the width.
    fn representable(&self, value: Value) -> Option<(f64, f64)> {
        match value {
            Value::Known(Rounded::DoubleDouble(high, low)) => {
                self.width.round(high).is_finite().then_some((high, low))
            }
            _ => None,
        }
    }
}

fn holds(relation: Relation, left: f64, right: f64) -> bool {
    left.partial_cmp(&right).is_none_or(|order| relation.admits(order))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::Score;
    use crate::check::read_theory;

    fn samples(source: &str, width: Width) -> Vec<Samples> {
        let (theory, errors) = read_theory(source);
        assert!(errors.is_empty(), "{errors:?}");
        sample(&theory.pool, &theory.kernels[0], width, &Regime::ALL, 16, 1)
    }

    #[test]
    fn every_sample_is_in_the_domain_and_of_the_width() {
        let source = "kernel k(a, b, c) = sqrt(a - b)*log(c) where 0 < b < a, a + b < c, c <= 1000;";
        let found = samples(source, Width::Single);
        assert!(found.len() >= 6, "{found:?}");
        for sample in found.iter().flat_map(|regime| &regime.samples) {
            let [a, b, c] = sample.arguments[..] else { panic!("three arguments") };
            assert!(0.0 < b && b < a && c <= 1000.0 && a + b <= c, "{sample:?}");
            assert!(sample.arguments.iter().all(|&x| Width::Single.round(x) == x), "{sample:?}");
        }
    }

    #[test]
    fn a_domain_without_points_has_no_samples() {
        for domain in ["1 >= w, 2 < w", "w > 1, w < 1", "w > 3, w <= 1e-400", "w > 1e400", "w**2 < -1"] {
            let source = format!("kernel k(w) = 1/(w - 1) where {domain};");
            for width in [Width::Single, Width::Double] {
                assert_eq!(samples(&source, width), [], "{domain}");
            }
        }
    }

    #[test]
    fn the_same_seed_gives_the_same_samples() {
        let source = "kernel k(x, y) = atan2(x - y, x + y) where x > 0;";
        assert_eq!(samples(source, Width::Double), samples(source, Width::Double));
    }

    #[test]
    fn hard_regimes_find_what_typical_arguments_do_not_show() {
        for (source, regime) in [
            ("kernel k(x) = (1 - cos(x))/x**2 where -3 < x < 3;", Regime::Small),
            ("kernel k(a, b) = (a**2 - b**2)/(a + b) where a > 0, b > 0;", Regime::Coincident),
            ("kernel k(x) = sqrt(x + 1) - sqrt(x) where x >= 0;", Regime::Large),
            ("kernel k(x) = 1/(x**2 - 2) where x > 0;", Regime::Singular),
            ("kernel k(x) = acos(1 - x**2) where 0 < x < 1;", Regime::LowerEdge),
        ] {
            let (theory, _) = read_theory(source);
            let kernel = &theory.kernels[0];
            let regimes = [Regime::Typical, regime];
            let found = sample(&theory.pool, kernel, Width::Double, &regimes, 48, 1);
            let lost: Vec<f64> = found
                .iter()
                .map(|samples| {
                    let value = |arguments: &[f64]| {
                        let values: Vec<_> =
                            kernel.arguments.iter().copied().zip(arguments.iter().copied()).collect();
                        evaluate_f64(&theory.pool, &kernel.outputs, &values).expect("values")
                    };
                    Score::of(samples, Width::Double, value).bits.mean
                })
                .collect();
            let [typical, hard] = lost[..] else { panic!("{source}: {lost:?}") };
            assert!(hard > typical + 4.0, "{source}: {lost:?}");
        }
    }
}
