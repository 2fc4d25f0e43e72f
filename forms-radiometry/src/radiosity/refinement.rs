//! Refinement: compares a coarse solution with a finer one, and splits the elements whose changes
//! affect the answers most.
//!
//! ```text
//! elements ─▶ rows and direct light at the nodes ─▶ solution ─▶ change of each new element
//!          ─▶ the elements with the largest effect are split ─▶ …
//! ```
//! The effect of an element is its change times its importance: the change of the answers, relative
//! to them, by a uniform irradiance of the element, over all reflections. The mean of a change
//! counts, and its size with a smaller weight, so that changes which cancel now are not forgotten.

use super::coarsest_elements::MOST_NODES;
use super::convergence::{Change, decay};
use super::element::Element;
use super::importance::Goal;
use super::kept::Kept;
use super::reference::MOST_NODES as MOST_NODES_OF_ELEMENT;
use super::system::Radiosity;
use crate::geometry::Vector;
use std::ops::Range;

/// Fraction of the total effect that the elements to be split next have. It is large because the
/// errors of elements of one size cancel to a great extent: on a cube whose faces are all split,
/// 864 nodes are as accurate as 7000 where one in ten is not split.
///
/// Source: W. Dörfler, A convergent adaptive algorithm for Poisson's equation (1996).
const BULK: f64 = 0.999;
/// Weight of a change that cancels within its element.
const CANCELLING: f64 = 0.05;
/// Assumed difference between an element that is equally bright at all nodes and its parts,
/// relative to the largest irradiance.
const LEAST_CHANGE: f64 = 1e-3;

/// Requirements of a refinement.
pub(crate) struct Asking {
    pub(crate) goals: Vec<Goal>,
    /// Sum of the relative errors of these goals, infinite before any is known, and sum of their
    /// squares.
    pub(crate) errors: [f64; 2],
    /// Relative error that is allowed from elements that are not split.
    pub(crate) sparing: f64,
}

impl Asking {
    /// Returns the relative error of a goal due to all elements together, by their total effect,
    /// but no less than the known errors imply.
    fn typical(&self, matter: f64) -> f64 {
        let [sum, squares] = self.errors;
        if sum.is_finite() { (matter / sum).max(squares / sum) } else { f64::INFINITY }
    }
}

/// Result of a refinement.
#[derive(Clone, Debug)]
pub(crate) struct Refined {
    /// Effect of the changes that are still to come, relative to the effect of this refinement.
    pub(crate) left: f64,
    /// The same for each goal, by the direct contributions of the elements.
    pub(crate) of_goals: Vec<f64>,
    /// Relative error due to elements that were not split although they are expected to change. All
    /// of them count in full: errors that cancel among elements of one size no longer do so once
    /// some of these are split. Zero before errors are known.
    pub(crate) spared: f64,
}

impl Radiosity<'_> {
    /// Returns the changes of the elements before any is split. The expected change of an element
    /// with one node takes into account that it could as well be dark.
    pub(super) fn unknown_changes(&self) -> Vec<[Change; 2]> {
        let next = |[highest, lower]: [f64; 2]| highest * (highest / highest.max(lower));
        let unknown = |(index, element): (usize, &Element)| {
            let largest = |of: fn([f64; 2]) -> f64, least: f64| {
                self.largest(|band, scale| {
                    let terms = element.reference().highest(self.nodes(index, band));
                    terms.map(|terms| (of(terms) / scale).max(least))
                })
            };
            let (expected, terms) = (largest(next, LEAST_CHANGE), largest(|[highest, _]| highest, 0.0));
            [0, 1]
                .map(|i| Change::unknown(if element.is_divisible()[i] { expected[i] } else { 0.0 }, terms[i]))
        };
        self.elements.iter().enumerate().map(unknown).collect()
    }

    /// Resets the changes of elements that light has reached since. Before, this light fell between
    /// the nodes of these elements, or of elements that they see.
    fn forget_outgrown(&mut self) {
        for (index, unknown) in self.unknown_changes().into_iter().enumerate() {
            for (change, unknown) in self.changes[index].iter_mut().zip(unknown) {
                if change.is_outgrown_by(unknown) {
                    *change = unknown;
                }
            }
        }
    }

    /// Returns the irradiance at the nodes of an element.
    fn nodes(&self, index: usize, band: usize) -> &[f64] {
        &self.irradiance[band][self.first[index]..self.first[index + 1]]
    }

    /// Returns the largest values over all bands that have light; `of_band` gets the largest
    /// irradiance of its band.
    fn largest(&self, of_band: impl Fn(usize, f64) -> [f64; 2]) -> [f64; 2] {
        let lit = self.brightest.iter().copied().enumerate().filter(|&(_, scale)| scale > 0.0);
        let bands = lit.map(|(band, scale)| of_band(band, scale));
        bands.fold([0.0; 2], |[a, b]: [f64; 2], [c, d]| [a.max(c), b.max(d)])
    }

    /// Splits the elements with the largest effect, and solves again. Returns `None` if there is
    /// nothing to split, no room for more nodes, or no time: then the solution is unchanged.
    pub(crate) fn refine(&mut self, asking: &Asking) -> Option<Refined> {
        self.forget_outgrown();
        let matter = self.matter(&asking.goals);
        if self.watch.is_stopped() {
            return None;
        }
        let (chosen, spared) = self.chosen(&matter, asking);
        if !chosen.iter().flatten().any(|&is_chosen| is_chosen) {
            return None;
        }
        let (mut elements, mut changes, mut split) = (Vec::new(), Vec::new(), Vec::new());
        let mut now = vec![None; self.elements.len()];
        for (index, element) in self.elements.iter().enumerate() {
            let from = elements.len();
            if chosen[index] == [false; 2] {
                now[index] = Some(from);
                elements.push(element.clone());
            } else {
                elements.extend(element.divided(chosen[index]));
                split.push((index, from..elements.len()));
            }
            changes.resize(elements.len(), self.changes[index]);
        }
        let before = std::mem::replace(&mut self.elements, elements);
        let changes_before = std::mem::replace(&mut self.changes, changes);
        let (outlines, first) = (self.outlines.clone(), self.first.clone());
        if !self.solve(&Kept::of(now, self.elements.len(), first.clone())) {
            (self.elements, self.changes, self.outlines, self.first) =
                (before, changes_before, outlines, first);
            return None;
        }
        let mut changed = vec![[0.0; 2]; self.elements.len()];
        for (whole, parts) in split {
            let measured = self.measure(parts.clone(), &before[whole], chosen[whole]);
            changed[parts].iter_mut().for_each(|[settled, _]| *settled = measured);
        }
        for ([_, left], changes) in changed.iter_mut().zip(&self.changes) {
            *left = changes.iter().map(|change| change.remaining()).sum();
        }
        let left = |[settled, left]: [f64; 2]| if settled > 0.0 { left / settled } else { 1.0 };
        let (importance, of_goals) = self.importance_and_sums(&asking.goals, &changed);
        let mut sums = [0.0; 2];
        for (changed, z) in changed.iter().zip(importance) {
            sums.iter_mut().zip(changed).for_each(|(sum, &change)| *sum += product(change, z));
        }
        Some(Refined { left: left(sums), of_goals: of_goals.into_iter().map(left).collect(), spared })
    }

    /// Returns the effect of the expected changes of each element on the goals.
    fn matter(&self, goals: &[Goal]) -> Vec<[f64; 2]> {
        let changes = self.changes.iter().zip(self.importance(goals)).enumerate();
        let of_element = |(index, (changes, z)): (usize, (&[Change; 2], f64))| {
            let (jump, is_divisible) = (self.jump(index), self.elements[index].is_divisible());
            [0, 1].map(|i| {
                let jump = if is_divisible[i] { jump } else { 0.0 };
                product(changes[i].expected.max(jump), z)
            })
        };
        changes.map(of_element).collect()
    }

    /// Selects the elements to be split next and their coordinates; returns them with the relative
    /// error due to the others.
    fn chosen(&self, matter: &[[f64; 2]], asking: &Asking) -> (Vec<[bool; 2]>, f64) {
        let pairs = (0..self.elements.len()).flat_map(|index| [(index, 0), (index, 1)]);
        let of = |(index, coordinate): (usize, usize)| matter[index][coordinate];
        let mut order: Vec<(usize, usize)> = pairs.filter(|&pair| of(pair) > 0.0).collect();
        order.sort_by(|&a, &b| of(b).total_cmp(&of(a)));
        let whole: f64 = matter.iter().flatten().sum();
        let typical = asking.typical(whole);
        let enough = BULK.min(1.0 - asking.sparing / typical) * whole;
        let mut sum = 0.0;
        let mut chosen = vec![[false; 2]; self.elements.len()];
        let mut nodes = self.size();
        for (index, coordinate) in order {
            let element = &self.elements[index];
            let before = chosen[index];
            let mut after = before;
            after[coordinate] = true;
            nodes += (element.part_count(after) - element.part_count(before)) * element.count();
            if nodes > MOST_NODES || sum >= enough {
                break;
            }
            sum += matter[index][coordinate];
            chosen[index] = after;
        }
        (chosen, if typical.is_finite() { (whole - sum) / whole * typical } else { 0.0 })
    }

    /// Records the changes of the parts of an element that was divided in some coordinates, and
    /// returns how much they differ from it.
    fn measure(&mut self, parts: Range<usize>, whole: &Element, is_divided: [bool; 2]) -> f64 {
        let of_whole = self.at_nodes(parts.clone(), whole);
        let [flux, size] = self.largest(|band, scale| {
            self.difference(parts.clone(), whole, &of_whole[band], band).map(|value| value / scale)
        });
        let measured = flux + CANCELLING * size;
        let highest = |element: &Element, values: &[f64], scale: f64| {
            element.reference().highest(values).map(|[term, _]| term / scale)
        };
        let terms = self.largest(|band, scale| highest(whole, &of_whole[band], scale));
        let shares = shares(terms, is_divided);
        for part in parts {
            let element = &self.elements[part];
            let own = self.largest(|band, scale| highest(element, self.nodes(part, band), scale));
            let decay = decay(whole, element, [terms, own]);
            for i in [0, 1].into_iter().filter(|&i| is_divided[i]) {
                let [of_flux, of_size] = decay[i];
                let expected = flux * of_flux + CANCELLING * size * of_size;
                let change = &mut self.changes[part][i];
                *change = change.followed_by(shares[i] * measured, shares[i] * expected, own[i]);
            }
        }
        measured
    }

    /// Returns for each band the irradiance on the parts of an element, at the nodes of the whole.
    fn at_nodes(&self, parts: Range<usize>, whole: &Element) -> Vec<Vec<f64>> {
        let bases: Vec<_> = whole.nodes().map(|node| self.part_at(parts.clone(), node)).collect();
        let of_band = |band: usize| {
            let value = |(part, basis): &(usize, [f64; MOST_NODES_OF_ELEMENT])| {
                basis.iter().zip(self.nodes(*part, band)).map(|(b, e)| b * e).sum()
            };
            bases.iter().map(value).collect()
        };
        (0..self.irradiance.len()).map(of_band).collect()
    }

    /// Returns how much the irradiance on the parts of an element differs from the interpolation on
    /// the whole element: from the polynomial that agrees with it at the nodes of the whole, where
    /// it has the values `of_whole`. The two numbers, mean and size, are means over the element.
    fn difference(&self, parts: Range<usize>, whole: &Element, of_whole: &[f64], band: usize) -> [f64; 2] {
        let (mut flux, mut size) = (0.0_f64, 0.0);
        for part in parts {
            let element = &self.elements[part];
            for ((node, area), value) in element.nodes().zip(element.areas()).zip(self.nodes(part, band)) {
                let coarse: f64 = whole.basis(node).iter().zip(of_whole).map(|(b, e)| b * e).sum();
                flux += area * (value - coarse);
                size += area * (value - coarse).abs();
            }
        }
        [flux.abs() / whole.area, size / whole.area]
    }

    /// Returns the part of an element that contains a point, with the values of its polynomials
    /// there.
    fn part_at(&self, parts: Range<usize>, point: Vector) -> (usize, [f64; MOST_NODES_OF_ELEMENT]) {
        let first = parts.start;
        let part = parts.into_iter().find(|&part| self.elements[part].contains(point)).unwrap_or(first);
        (part, self.elements[part].basis(point))
    }
}

/// Returns the share of each coordinate in the change of an element that was divided in these, by
/// the highest terms of its polynomial.
fn shares(terms: [f64; 2], is_divided: [bool; 2]) -> [f64; 2] {
    let sum = terms[0] + terms[1];
    match is_divided {
        [true, true] if sum > 0.0 => terms.map(|term| term / sum),
        [true, true] => [0.5; 2],
        _ => [1.0; 2],
    }
}

/// Returns the effect of a change.
fn product(change: f64, importance: f64) -> f64 {
    if importance > 0.0 { change * importance } else { 0.0 }
}
