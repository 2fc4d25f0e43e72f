//! Regimes: where no form is best everywhere, each is used where it is best, with the seams at
//! exact numbers.
//!
//! The samples are sorted by one argument. Dynamic programming finds the cheapest partition into at
//! most `MOST_PIECES` runs, each with the form that loses least on it; a cut must reduce the loss
//! by a minimum amount. This determines which forms meet in which order. The samples do not
//! determine where they meet: that is a number at which their error bounds cross, whatever the
//! other arguments are. If there is none, no cut is made.

use super::crossing::{Crossing, Pair};
use crate::expression::{Expr, Pool, Rational, Relation, Seam, Symbol};
use crate::kernel::{Program, nearest_f64};
use num_bigint::BigInt;
use num_traits::Zero;

/// Maximum number of pieces.
const MOST_PIECES: usize = 3;

/// Minimum reduction of the mean loss for each cut, in bits.
const LEAST_GAIN: f64 = 0.15;

/// Partition of the samples, sorted by an argument, into runs, each with the index of its form.
pub(super) struct Cut {
    pub(super) argument: usize,
    /// Form of each run, and the number below which it is used; the last run has none.
    pub(super) pieces: Vec<(usize, Option<Rational>)>,
    /// Mean loss.
    pub(super) loss: f64,
}

/// Returns the best partition for each argument, the best argument first. `losses` holds, for each
/// form, the loss at each sample.
pub(super) fn cuts(points: &[&[f64]], weights: &[f64], losses: &[&[f64]]) -> Vec<Cut> {
    let arguments = points.first().map_or(0, |point| point.len());
    let single = losses.iter().map(|loss| mean(loss, weights)).fold(f64::INFINITY, f64::min);
    let mut cuts: Vec<Cut> = Vec::new();
    for argument in 0..arguments {
        cuts.extend(cut(points, weights, losses, argument, single));
        cuts.extend(by_sign(points, weights, losses, argument).filter(|cut| cut.loss + LEAST_GAIN < single));
    }
    cuts.sort_by(|a, b| a.loss.total_cmp(&b.loss));
    cuts
}

/// Maximum number of points at which a crossing must be the same.
const MOST_POINTS: usize = 24;

impl Cut {
    /// Moves each cut to a number where the error bounds of the forms on both sides cross, at
    /// points of every scale; `None` if they do not cross, or if the points have no common
    /// crossing.
    pub(super) fn at_crossings(
        mut self,
        points: &[&[f64]],
        programs: &[&Program],
        range: (f64, f64),
    ) -> Option<Cut> {
        let step = points.len().div_ceil(MOST_POINTS).max(1);
        let points: Vec<&[f64]> = points.iter().copied().step_by(step).collect();
        let mut last = f64::NEG_INFINITY;
        for place in 0..self.pieces.len() - 1 {
            let [below, above] = [place, place + 1].map(|piece| programs[self.pieces[piece].0]);
            let crossing = Pair { below, above, argument: self.argument, range }.crossing(&points)?;
            let bound = crossing.number();
            let size = nearest_f64(&bound);
            if size <= last {
                return None;
            }
            (self.pieces[place].1, last) = (Some(bound), size);
        }
        Some(self)
    }
}

impl Crossing {
    /// Returns a short number in the interval: zero if the interval contains it.
    fn number(&self) -> Rational {
        if self.lower <= 0.0 && self.upper >= 0.0 {
            Rational::zero()
        } else {
            between(self.lower, self.upper)
        }
    }
}

/// Returns the best pair of forms for the two signs of an argument.
fn by_sign(points: &[&[f64]], weights: &[f64], losses: &[&[f64]], argument: usize) -> Option<Cut> {
    let best = |negative: bool| {
        let loss = |form: &usize| -> f64 {
            let samples = points.iter().zip(weights).zip(losses[*form]);
            samples
                .filter(|((point, _), _)| (point[argument] < 0.0) == negative)
                .map(|((_, weight), loss)| weight * loss)
                .sum()
        };
        let form = (0..losses.len()).min_by(|a, b| loss(a).total_cmp(&loss(b)))?;
        Some((form, loss(&form)))
    };
    let ((below, lost_below), (above, lost_above)) = (best(true)?, best(false)?);
    let pieces = vec![(below, Some(Rational::zero())), (above, None)];
    (below != above).then_some(Cut { argument, pieces, loss: lost_below + lost_above })
}

/// Returns the weighted mean of the losses.
pub(super) fn mean(losses: &[f64], weights: &[f64]) -> f64 {
    losses.iter().zip(weights).map(|(loss, weight)| loss * weight).sum()
}

fn cut(points: &[&[f64]], weights: &[f64], losses: &[&[f64]], argument: usize, single: f64) -> Option<Cut> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| points[a][argument].total_cmp(&points[b][argument]));
    let value = |place: usize| points[order[place]][argument];
    // prefix sums of the losses, for each form
    let sums: Vec<Vec<f64>> = losses
        .iter()
        .map(|loss| {
            let mut sum = 0.0;
            std::iter::once(0.0)
                .chain(order.iter().map(|&place| {
                    sum += loss[place] * weights[place];
                    sum
                }))
                .collect()
        })
        .collect();
    let count = order.len();
    // best[k][j]: the smallest loss of the first j samples in k + 1 runs, with the last run's form
    // and start
    let mut best: Vec<Vec<(f64, usize, usize)>> = Vec::new();
    for pieces in 0..MOST_PIECES {
        let mut row = vec![(f64::INFINITY, 0, 0); count + 1];
        for (form, sum) in sums.iter().enumerate() {
            let (mut start, mut least) = (0, if pieces == 0 { 0.0 } else { f64::INFINITY });
            for end in 1..=count {
                let place = end - 1;
                // a run can start only where the argument changes
                if pieces > 0 && place > 0 && value(place - 1) < value(place) {
                    let before = best[pieces - 1][place].0 - sum[place];
                    if before < least {
                        (least, start) = (before, place);
                    }
                }
                let loss = least + sum[end];
                if loss < row[end].0 {
                    row[end] = (loss, form, start);
                }
            }
        }
        best.push(row);
    }
    let gain = |pieces: usize| single - best[pieces][count].0 - LEAST_GAIN * pieces as f64;
    let pieces = (1..MOST_PIECES).max_by(|&a, &b| gain(a).total_cmp(&gain(b))).filter(|&p| gain(p) > 0.0)?;
    let mut found = Vec::new();
    let (mut end, mut bound) = (count, None);
    for left in (0..=pieces).rev() {
        let (_, form, start) = best[left][end];
        found.push((form, bound.take()));
        if start > 0 {
            bound = Some(between(value(start - 1), value(start)));
        }
        end = start;
    }
    found.reverse();
    Some(Cut { argument, pieces: found, loss: best[pieces][count].0 })
}

/// Returns a short number above a and not above b: zero, a power of ten, or a number with few
/// digits.
fn between(a: f64, b: f64) -> Rational {
    if a < 0.0 && b >= 0.0 {
        return Rational::zero();
    }
    let exact = |value: f64| Rational::from_float(value).unwrap_or_default();
    let (lower, upper) = (exact(a), exact(b));
    let (small, large) = if b <= 0.0 { (-b, -a) } else { (a, b) };
    let middle = if small > 0.0 { (small.log10() + large.log10()) / 2.0 } else { large.log10() - 1.0 };
    let power = |exponent: i32| {
        let ten = Rational::from_integer(BigInt::from(10).pow(exponent.unsigned_abs()));
        if exponent < 0 { ten.recip() } else { ten }
    };
    let exponent = middle.round() as i32;
    let digits = Rational::from_float(10f64.powf(middle - f64::from(exponent))).unwrap_or_default();
    for places in 0..17 {
        let rounded = (&digits * power(places)).round() / power(places) * power(exponent);
        let candidate = if b <= 0.0 { -rounded } else { rounded };
        if lower < candidate && candidate <= upper {
            return candidate;
        }
    }
    upper
}

/// Returns the outputs of the pieces, selected by the argument.
pub(super) fn joined(pool: &mut Pool, argument: Symbol, forms: &[&[Expr]], cut: &Cut) -> Vec<Expr> {
    let variable = pool.symbol(argument);
    let (last, others) = cut.pieces.split_last().expect("a cut has pieces");
    let mut outputs: Vec<Expr> = forms[last.0].to_vec();
    for (form, bound) in others.iter().rev() {
        let bound = pool.number(bound.clone().unwrap_or_default());
        for (output, &piece) in outputs.iter_mut().zip(forms[*form]) {
            *output = pool.select((variable, Relation::Less, bound), piece, *output, Seam::Agrees);
        }
    }
    outputs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_form_is_used_where_it_loses_least() {
        let numbers: Vec<[f64; 1]> = (0..20).map(|n| [f64::from(n) - 10.0]).collect();
        let points: Vec<&[f64]> = numbers.iter().map(|point| &point[..]).collect();
        let left: Vec<f64> = numbers.iter().map(|x| if x[0] < 3.0 { 0.0 } else { 20.0 }).collect();
        let right: Vec<f64> = numbers.iter().map(|x| if x[0] < 3.0 { 30.0 } else { 1.0 }).collect();
        let weights = vec![0.05; 20];
        let cut = cuts(&points, &weights, &[&left, &right]).remove(0);
        let [(0, Some(seam)), (1, None)] = &cut.pieces[..] else { panic!("two pieces") };
        assert_eq!(*seam, Rational::new(12.into(), 5.into()));
        assert!((cut.loss - 7.0 * 0.05).abs() < 1e-12);
        assert!(cuts(&points, &weights, &[&left, &left]).is_empty());
    }

    #[test]
    fn a_seam_is_a_short_number() {
        assert_eq!(between(-1.0, 2.0), Rational::zero());
        assert_eq!(between(1e-9, 0.3), Rational::new(1.into(), 50_000.into()));
        assert_eq!(between(-3.7, -0.1), Rational::new((-1).into(), 1.into()));
        assert_eq!(between(2.15, 2.25), Rational::new(11.into(), 5.into()));
    }
}
