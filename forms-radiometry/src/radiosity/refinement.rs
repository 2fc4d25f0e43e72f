//! Refinement: a coarse solution is compared with a finer one, and the elements whose change sends out most are split.
//!
//! ```text
//! elements ─▶ rows and direct light at the nodes ─▶ solution ─▶ change of each new element ─▶ the ones that matter are split ─▶ …
//! ```
//! What an element matters is its change times its importance: what a uniform irradiance of it would change in the answers,
//! relative to them, over all reflections. Of a change its mean counts, and its size with a smaller weight, so that changes which
//! cancel now are not forgotten.

use super::element::Element;
use super::importance::Goal;
use super::reference::MOST_NODES as MOST_NODES_OF_ELEMENT;
use super::system::{MOST_NODES, Radiosity};
use crate::geometry::Vector;
use crate::simulation::Watch;
use std::ops::Range;

/// The part of all that matters that the elements have which are split next. It is large because the errors of elements of one size
/// cancel in great part: on a cube whose faces are all split, 864 nodes are as exact as 7000 where one in ten is not.
///
/// Source: W. Dörfler, A convergent adaptive algorithm for Poisson's equation (1996).
const BULK: f64 = 0.95;
/// How many parts an element is split into.
const PARTS: usize = 4;
/// How much of a change that cancels within its element still counts.
const CANCELLING: f64 = 0.1;
/// The least and the largest part that is expected of an element's change when it is split once more, and the part that is
/// expected where nothing is known: with polynomials of second degree smooth light leaves an eighth, a jump all of it.
const EXPECTED: [f64; 2] = [1.0 / 16.0, 1.0];
const UNKNOWN: f64 = 0.5;
/// The largest part that all changes to come are expected to leave: areas with a jump inside halve, and so does what they matter.
const SLOWEST: f64 = 0.7;

/// How much irradiance is taken to vary over an element that is equally bright at all nodes, relative to the largest.
const LEAST_VARIATION: f64 = 1e-3;

/// How an element differs from the one that it was a part of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Change {
    /// By how much, relative to the largest irradiance.
    measured: f64,
    /// By how much its own parts are expected to differ from it.
    expected: f64,
}

impl Change {
    /// Before an element is split, its parts are expected to differ from it by as much as its nodes do from each other.
    fn unknown(variation: f64) -> Self {
        Self { measured: f64::INFINITY, expected: variation }
    }

    /// The sum of the changes that are to come, if each leaves the same part.
    fn remaining(self) -> f64 {
        let part = if self.measured.is_finite() { self.expected / self.measured } else { UNKNOWN };
        if self.expected > 0.0 { self.expected / (1.0 - part.min(SLOWEST)) } else { 0.0 }
    }

    /// The change of a part of an element that had this one.
    fn after(self, measured: f64) -> Self {
        let part = if self.measured.is_finite() { measured / self.measured } else { UNKNOWN };
        let part = if part.is_nan() { 0.0 } else { part.clamp(EXPECTED[0], EXPECTED[1]) };
        Self { measured, expected: part * measured }
    }
}

impl Radiosity<'_> {
    /// What is known of the elements before any is split: of an element with one node, that it may be dark as well.
    pub(super) fn unknown_changes(&self) -> Vec<Change> {
        let largest = |irradiance: &Vec<f64>| irradiance.iter().fold(0.0, |m: f64, value| m.max(value.abs()));
        let scales: Vec<f64> = self.irradiance.iter().map(largest).collect();
        let variation = |nodes: &[usize]| {
            let of_band = |(irradiance, &scale): (&Vec<f64>, &f64)| {
                let values = &irradiance[nodes[0]..nodes[1]];
                let [low, high] =
                    values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &value| {
                        [low.min(value), high.max(value)]
                    });
                let differs = if values.len() > 1 { high - low } else { high.abs() };
                if scale > 0.0 { (differs / scale).max(LEAST_VARIATION) } else { 0.0 }
            };
            self.irradiance.iter().zip(&scales).map(of_band).fold(0.0, f64::max)
        };
        self.first.windows(2).map(|nodes| Change::unknown(variation(nodes))).collect()
    }

    /// Splits the elements that matter most, and solves again. Returns how much what is to come still matters, relative to
    /// what this changed; nothing if there is nothing to split, or no room for more.
    pub(crate) fn refine(&mut self, goals: &[Goal], watch: &dyn Watch) -> Option<f64> {
        let matter = self.matter(goals);
        let chosen = self.chosen(&matter);
        if !chosen.contains(&true) {
            return None;
        }
        let (mut elements, mut changes, mut parents) = (Vec::new(), Vec::new(), Vec::new());
        for (index, element) in self.elements.iter().enumerate() {
            if chosen[index] {
                elements.extend(element.quarters());
                changes.extend([self.changes[index]; PARTS]);
                parents.extend([Some(index); PARTS]);
            } else {
                elements.push(element.clone());
                changes.push(self.changes[index]);
                parents.push(None);
            }
        }
        let before = std::mem::replace(&mut self.elements, elements);
        self.changes = changes;
        self.solve(watch);
        let importance = self.importance(goals);
        let (mut settled, mut index) = (0.0, 0);
        while index < parents.len() {
            let Some(parent) = parents[index] else {
                index += 1;
                continue;
            };
            let parts = index..index + PARTS;
            let measured = self.change(parts.clone(), &before[parent]);
            settled += measured * importance[parts.clone()].iter().sum::<f64>();
            self.changes[parts].iter_mut().for_each(|change| *change = change.after(measured));
            index += PARTS;
        }
        let left: f64 =
            self.changes.iter().zip(importance).map(|(change, z)| product(change.remaining(), z)).sum();
        Some(if settled > 0.0 { left / settled } else { 1.0 })
    }

    /// How much the change that is expected of each element matters to the goals.
    fn matter(&self, goals: &[Goal]) -> Vec<f64> {
        let changes = self.changes.iter().zip(self.importance(goals));
        changes.map(|(change, z)| product(change.expected, z)).collect()
    }

    /// The elements that are split next.
    fn chosen(&self, matter: &[f64]) -> Vec<bool> {
        let mut order: Vec<usize> = (0..self.elements.len()).filter(|&index| matter[index] > 0.0).collect();
        order.sort_by(|&a, &b| matter[b].total_cmp(&matter[a]));
        let whole: f64 = matter.iter().sum();
        let mut sum = 0.0;
        let mut chosen = vec![false; self.elements.len()];
        let mut nodes = self.size();
        for index in order {
            nodes += (PARTS - 1) * self.elements[index].count();
            if nodes > MOST_NODES || sum >= BULK * whole {
                break;
            }
            sum += matter[index];
            chosen[index] = true;
        }
        chosen
    }

    /// How much the irradiance on the parts of an element differs from what the whole element would make of it: from the polynomial
    /// that agrees with it at the nodes of the whole; relative to the largest irradiance.
    fn change(&self, parts: Range<usize>, whole: &Element) -> f64 {
        let bases: Vec<_> = whole.nodes().map(|node| self.part_at(parts.clone(), node)).collect();
        let of_band = |irradiance: &Vec<f64>| {
            let nodes = |part: usize| &irradiance[self.first[part]..self.first[part + 1]];
            let value = |(part, basis): &(usize, [f64; MOST_NODES_OF_ELEMENT])| {
                basis.iter().zip(nodes(*part)).map(|(b, e)| b * e).sum()
            };
            let of_whole: Vec<f64> = bases.iter().map(value).collect();
            let (mut flux, mut size) = (0.0, 0.0);
            for part in parts.clone() {
                let element = &self.elements[part];
                for ((node, area), value) in element.nodes().zip(element.areas()).zip(nodes(part)) {
                    let coarse: f64 = whole.basis(node).iter().zip(&of_whole).map(|(b, e)| b * e).sum();
                    flux += area * (value - coarse);
                    size += area * (value - coarse).abs();
                }
            }
            let scale = irradiance.iter().fold(0.0, |m: f64, value| m.max(value.abs()));
            if scale > 0.0 { (flux.abs() + CANCELLING * size) / (scale * whole.area) } else { 0.0 }
        };
        self.irradiance.iter().map(of_band).fold(0.0, f64::max)
    }

    /// The part of an element that a point of it lies in, with the values of its polynomials there.
    fn part_at(&self, parts: Range<usize>, point: Vector) -> (usize, [f64; MOST_NODES_OF_ELEMENT]) {
        let first = parts.start;
        let part = parts.into_iter().find(|&part| self.elements[part].contains(point)).unwrap_or(first);
        (part, self.elements[part].basis(point))
    }
}

/// What a change matters.
fn product(change: f64, importance: f64) -> f64 {
    if importance > 0.0 { change * importance } else { 0.0 }
}
