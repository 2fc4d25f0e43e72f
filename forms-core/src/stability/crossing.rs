//! Crossings: the point along one argument where the error bounds of two forms cross.
//!
//! ```text
//! points of every scale ─ error bounds along the argument ─▶ last place where the first form's is less,
//!     first place where the second form's is ─▶ one interval for all points, or none ─▶ a short number
//! ```
//! The bounds are computed in arithmetic that propagates the error of each operation (`Guarded` of
//! forms-math). They hold for every rounding, and do not depend on the losses that samples happen
//! to show. A crossing that moves with the other arguments, as at a = b, is not a crossing of this
//! argument: a fixed number would be right at one scale only.

use crate::accuracy::Width;
use crate::kernel::Program;
use forms_math::{Guarded, Real};

/// Number of places of the initial scan along the argument.
const PLACES: usize = 160;

/// Number of bisections of the interval between two places.
const HALVINGS: usize = 12;

/// Factor by which a bound must be smaller than another to count as clearly smaller.
const CLEARLY: f64 = 2.0;

/// Relative bound that is good enough, a few roundings: no form is clearly better than one that has
/// it.
const GOOD: f64 = 12.0 * f64::EPSILON;

/// Interval in which one form ceases to be clearly better and the other begins to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    pub(super) lower: f64,
    pub(super) upper: f64,
}

/// Which of two forms has the clearly smaller bound.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Better {
    Below,
    Above,
    Neither,
}

/// Two forms; the first is used below a number, the second above it.
pub(super) struct Pair<'a> {
    pub(super) below: &'a Program,
    pub(super) above: &'a Program,
    pub(super) argument: usize,
    /// Smallest and largest value of the argument.
    pub(super) range: (f64, f64),
}

impl Pair<'_> {
    /// Returns the interval in which the bounds cross at all of these points; `None` where one of
    /// the forms is nowhere clearly better, or where no common interval exists.
    pub(super) fn crossing(&self, points: &[&[f64]]) -> Option<Crossing> {
        let mut common = Crossing { lower: self.range.0, upper: self.range.1 };
        let mut needed = [false, false];
        for point in points {
            let (found, is_better) = self.along(point)?;
            common = Crossing { lower: common.lower.max(found.lower), upper: common.upper.min(found.upper) };
            needed = [needed[0] || is_better[0], needed[1] || is_better[1]];
        }
        (needed == [true, true] && common.lower < common.upper).then_some(common)
    }

    /// Returns the crossing for fixed other arguments (the whole range where neither form is
    /// clearly better), and whether the lower form, and the upper form, is clearly better anywhere.
    fn along(&self, point: &[f64]) -> Option<(Crossing, [bool; 2])> {
        let ends = [self.range.0, self.range.1].map(|end| Width::Double.ordinal(end));
        let place = |number: usize| {
            let [start, end] = ends.map(i128::from);
            Width::Double.at((start + (end - start) * number as i128 / (PLACES - 1) as i128) as i64)
        };
        let places: Vec<f64> = (0..PLACES).map(place).collect();
        let found: Vec<Better> = places.iter().map(|&value| self.better_at(point, value)).collect();
        let last = found.iter().rposition(|&better| better == Better::Below);
        let first = found.iter().position(|&better| better == Better::Above);
        if let (Some(last), Some(first)) = (last, first)
            && first < last
        {
            return None;
        }
        let border = |inside: usize, outside: usize, wanted: Better| {
            let (mut inside, mut outside) =
                (Width::Double.ordinal(places[inside]), Width::Double.ordinal(places[outside]));
            for _ in 0..HALVINGS {
                let middle = inside.midpoint(outside);
                let is_wanted = self.better_at(point, Width::Double.at(middle)) == wanted;
                *(if is_wanted { &mut inside } else { &mut outside }) = middle;
            }
            Width::Double.at(outside)
        };
        let lower = last.map_or(self.range.0, |last| match last + 1 {
            next if next < PLACES => border(last, next, Better::Below),
            _ => self.range.1,
        });
        let upper = first.map_or(self.range.1, |first| match first.checked_sub(1) {
            Some(before) => border(first, before, Better::Above),
            None => self.range.0,
        });
        let is_better = [last.is_some(), first.is_some()];
        Some((Crossing { lower: lower.min(upper), upper: upper.max(lower) }, is_better))
    }

    fn better_at(&self, point: &[f64], value: f64) -> Better {
        let mut arguments: Vec<Guarded<f64>> = point.iter().map(|&value| Guarded::from_f64(value)).collect();
        arguments[self.argument] = Guarded::from_f64(value);
        let [below, above] = [self.below, self.above].map(|program| bound(program, &arguments));
        if below * CLEARLY < above && above > GOOD {
            Better::Below
        } else if above * CLEARLY < below && below > GOOD {
            Better::Above
        } else {
            Better::Neither
        }
    }
}

/// Returns the largest relative error bound of the outputs; infinite where there is none.
fn bound(program: &Program, arguments: &[Guarded<f64>]) -> f64 {
    let values = program.interpret_as(arguments);
    let relative = |value: Guarded<f64>| {
        let share = value.error() / value.value().abs();
        if value.error() == 0.0 && !value.value().is_nan() {
            0.0
        } else if share.is_nan() {
            f64::INFINITY
        } else {
            share
        }
    };
    values.into_iter().map(relative).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;
    use crate::kernel::{KernelSource, lower};

    fn crossing(forms: [&str; 2], range: (f64, f64), points: &[&[f64]]) -> Option<Crossing> {
        let programs = forms.map(|form| {
            let (theory, errors) = read_theory(&format!("kernel k(a, b) = {form};"));
            assert!(errors.is_empty(), "{errors:?}");
            let kernel = &theory.kernels[0];
            let (arguments, outputs) = (kernel.arguments.clone(), kernel.outputs.clone());
            lower(&theory.pool, &KernelSource { arguments, outputs, ..KernelSource::default() })
                .expect("a kernel")
        });
        let [below, above] = &programs;
        Pair { below, above, argument: 0, range }.crossing(points)
    }

    #[test]
    fn conjugate_forms_change_places_where_the_sign_of_a_term_does() {
        let points: &[&[f64]] = &[&[0.0, 1.0], &[0.0, 1e-20], &[0.0, 1e20]];
        let forms = ["b**2/(sqrt(a**2 + b**2) - a)", "sqrt(a**2 + b**2) + a"];
        let each: Vec<_> = points.iter().map(|point| crossing(forms, (-1e300, 1e300), &[point])).collect();
        let found = crossing(forms, (-1e300, 1e300), points).unwrap_or_else(|| panic!("{each:?}"));
        assert!(found.lower <= 0.0 && 0.0 <= found.upper && found.upper < 1e-18, "{found:?}");
    }

    #[test]
    fn a_crossing_that_moves_with_the_other_argument_is_none() {
        // in the rounding of a + b the first form loses bits of b, the second bits of a: they cross
        // at a = b
        let forms = ["(b + a) - a", "(a + b) - b"];
        let points: &[&[f64]] = &[&[1.0, 1e-20], &[1.0, 1.0], &[1.0, 1e20]];
        for point in points {
            let found = crossing(forms, (1e-300, 1e300), &[point]).expect("a crossing");
            assert!(found.lower <= point[1] * 4.0 && found.upper >= point[1] / 4.0, "{found:?}");
        }
        assert_eq!(crossing(forms, (1e-300, 1e300), points), None);
    }
}
