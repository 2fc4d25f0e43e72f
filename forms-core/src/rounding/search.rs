//! Branch and bound over the domain: the box with the worst bound is split, until the boxes are
//! used up or the bound no longer falls.

use super::arithmetic::Arithmetic;
use super::domain::{Box, domain};
use super::interval::Interval;
use super::sensitivity::{Analysis, BoxError};
use super::{ErrorBound, Unbounded};
use crate::kernel::Program;

/// Box of the domain with its error bounds. The box with the largest error is split next.
struct Part {
    arguments: Box,
    error: BoxError,
}

pub(super) fn error_bound(
    program: &Program,
    arithmetic: Arithmetic,
    boxes: usize,
) -> Result<Vec<ErrorBound>, Unbounded> {
    // a fused product is rounded at most once less than a separate one
    let program = &program.with_separate_roundings();
    let analysis = Analysis::new(program, arithmetic);
    let whole = domain(program)?;
    let mut parts = part(&analysis, whole).into_iter().collect::<Vec<Part>>();
    for step in 0..boxes {
        // the relative and the absolute bound are worst in different places: the steps alternate
        // between them
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

/// Returns the largest error of an output over all boxes.
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

/// Returns the index of the box whose relative or absolute error is largest.
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

/// Returns the two halves of a box, split along the argument that has the most influence and can be
/// split.
fn halves(arguments: &Box, influence: &[f64]) -> Option<[Box; 2]> {
    let can_split = |range: &Interval| range.lower < range.upper && middle(*range) < range.upper;
    // if several arguments have infinite influence, the one that spans the most binades is split
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

/// Returns the point where a range is split: 0 if it is inside, the middle of the floating-point
/// ordinals if the range spans binades, otherwise the midpoint.
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

/// Returns the number of binades that a range spans, with 0 replaced by the smallest positive
/// number; infinite if the range contains 0 in its interior.
fn spread(range: Interval) -> f64 {
    let [a, b] = [range.lower, range.upper].map(|end| end.abs().max(f64::from_bits(1)).log2());
    if range.lower < 0.0 && range.upper > 0.0 { f64::INFINITY } else { (a - b).abs() }
}
