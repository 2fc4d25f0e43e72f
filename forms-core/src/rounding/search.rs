//! The domain is split where its bound is worst, until the boxes are used up or the bound no longer falls.

use super::arithmetic::Arithmetic;
use super::domain::{Box, domain};
use super::interval::Interval;
use super::sensitivity::{Analysis, BoxError};
use super::{ErrorBound, Unbounded};
use crate::kernel::Program;

/// A box of the domain and its error; what is split next stands where its error is largest.
struct Part {
    arguments: Box,
    error: BoxError,
}

pub(super) fn error_bound(
    program: &Program,
    arithmetic: Arithmetic,
    boxes: usize,
) -> Result<Vec<ErrorBound>, Unbounded> {
    // a fused product is rounded once less than a separate one, at most
    let program = &program.with_separate_roundings();
    let analysis = Analysis::new(program, arithmetic);
    let whole = domain(program)?;
    let mut parts = part(&analysis, whole).into_iter().collect::<Vec<Part>>();
    for step in 0..boxes {
        // the relative bound and the absolute one are worst in different places: each is given every other step
        let Some(worst) = worst(&parts, step % 2 == 0) else { break };
        let Part { arguments, error } = parts.swap_remove(worst);
        match halves(&arguments, &error.influence) {
            Some(halves) => parts.extend(halves.into_iter().filter_map(|half| part(&analysis, half))),
            None => {
                parts.push(Part { arguments, error });
                break;
            }
        }
    }
    let bounds: Vec<ErrorBound> = (0..program.outputs().len()).map(|output| bound(&parts, output)).collect();
    let is_finite = bounds.iter().all(|bound| bound.absolute.is_finite());
    if is_finite { Ok(bounds) } else { Err(Unbounded::Undecided) }
}

fn part(analysis: &Analysis, arguments: Box) -> Option<Part> {
    let error = analysis.error(&arguments)?;
    Some(Part { arguments, error })
}

/// The largest error of an output over all parts.
fn bound(parts: &[Part], output: usize) -> ErrorBound {
    let largest = |of: fn(&super::sensitivity::OutputError) -> f64| {
        parts.iter().map(|part| of(&part.error.outputs[output])).fold(0.0, f64::max)
    };
    let relative = largest(|error| error.relative);
    ErrorBound {
        absolute: largest(|error| error.absolute),
        relative: relative.is_finite().then_some(relative),
    }
}

/// The part whose relative or absolute error is largest.
fn worst(parts: &[Part], is_relative: bool) -> Option<usize> {
    let size = |part: &Part| {
        let of =
            part.error.outputs.iter().map(|error| if is_relative { error.relative } else { error.absolute });
        of.fold(0.0, f64::max)
    };
    let sizes = parts.iter().map(size).enumerate();
    sizes
        .fold(None, |best: Option<(usize, f64)>, (place, size)| match best {
            Some((_, largest)) if largest >= size => best,
            _ => Some((place, size)),
        })
        .map(|(place, _)| place)
}

/// The two halves of a box along the argument that matters most and can be split.
fn halves(arguments: &Box, influence: &[f64]) -> Option<[Box; 2]> {
    let can_split = |range: &Interval| range.lower < range.upper && middle(*range) < range.upper;
    // of arguments that all matter without bound, the one that is widest on the scale of its binades
    let weight = |place: usize| (influence[place], spread(arguments[place]));
    let widest = (0..arguments.len())
        .filter(|&place| can_split(&arguments[place]))
        .max_by(|&a, &b| weight(a).partial_cmp(&weight(b)).unwrap_or(std::cmp::Ordering::Equal))?;
    let split = middle(arguments[widest]);
    let with = |range: Interval| {
        let mut half = arguments.clone();
        half[widest] = range;
        half
    };
    let range = arguments[widest];
    Some([with(Interval { upper: split, ..range }), with(Interval { lower: split, ..range })])
}

/// Where a range is split: about 0, else by the ordinal of its numbers where it spans binades, else in the middle.
fn middle(range: Interval) -> f64 {
    let Interval { lower, upper } = range;
    if lower < 0.0 && upper > 0.0 {
        return 0.0;
    }
    if spread(range) > 2.0 {
        let (a, b) = (lower.abs().to_bits(), upper.abs().to_bits());
        let between = f64::from_bits(a.min(b) + a.abs_diff(b) / 2);
        return if upper <= 0.0 { -between } else { between };
    }
    lower + (upper - lower) / 2.0
}

/// The ratio of its ends in binades; 0 in both directions counts as the least number.
fn spread(range: Interval) -> f64 {
    let [a, b] = [range.lower, range.upper].map(|end| end.abs().max(f64::from_bits(1)).log2());
    if range.lower < 0.0 && range.upper > 0.0 { f64::INFINITY } else { (a - b).abs() }
}
