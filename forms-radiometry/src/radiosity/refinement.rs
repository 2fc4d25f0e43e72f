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

/// Elements that matter less than this part of the one that matters most are not split. It is small because the errors of
/// elements of one size cancel in great part: on a cube whose faces are all split, 864 nodes are as exact as 5000 where one in ten is not.
const NEGLIGIBLE: f64 = 0.01;
/// How many parts an element is split into.
const PARTS: usize = 4;
/// How much of a change that cancels within its element still counts.
const CANCELLING: f64 = 0.1;
/// The least and the largest part that is expected of an element's change when it is split once more, and the part that is
/// expected where nothing is known: with polynomials of second degree smooth light leaves an eighth, a jump all of it.
const EXPECTED: [f64; 2] = [1.0 / 16.0, 1.0];
const UNKNOWN: f64 = 0.25;

/// How an element differs from the one that it was a part of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Change {
    /// By how much, relative to the largest irradiance.
    measured: f64,
    /// By how much its own parts are expected to differ from it.
    expected: f64,
}

impl Change {
    /// Nothing is known before an element is split.
    pub(super) const UNKNOWN: Self = Self { measured: f64::INFINITY, expected: f64::INFINITY };

    /// The change of a part of an element that had this one.
    fn after(self, measured: f64) -> Self {
        let part = if self.measured.is_finite() { measured / self.measured } else { UNKNOWN };
        let part = if part.is_nan() { 0.0 } else { part.clamp(EXPECTED[0], EXPECTED[1]) };
        Self { measured, expected: part * measured }
    }
}

impl Radiosity<'_> {
    /// Splits the elements that matter most, and solves again. Returns how much still matters, relative to what was split;
    /// nothing if there is nothing to split, or no room for more.
    pub(crate) fn refine(&mut self, goals: &[Goal], watch: &dyn Watch) -> Option<f64> {
        let matter = self.matter(goals);
        let chosen = self.chosen(&matter);
        if !chosen.contains(&true) {
            return None;
        }
        let split: f64 =
            matter.iter().zip(&chosen).filter(|(_, chosen)| **chosen).map(|(matter, _)| matter).sum();
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
        let mut index = 0;
        while index < parents.len() {
            if let Some(parent) = parents[index] {
                let measured = self.change(index..index + PARTS, &before[parent]);
                self.changes[index..index + PARTS]
                    .iter_mut()
                    .for_each(|change| *change = change.after(measured));
                index += PARTS;
            } else {
                index += 1;
            }
        }
        let left: f64 = self.matter(goals).iter().sum();
        Some(if split.is_finite() && split > 0.0 { left / split } else { 1.0 })
    }

    /// How much the change that is expected of each element matters to the goals.
    fn matter(&self, goals: &[Goal]) -> Vec<f64> {
        let product = |(change, z): (&Change, f64)| if z > 0.0 { change.expected * z } else { 0.0 };
        self.changes.iter().zip(self.importance(goals)).map(product).collect()
    }

    /// The elements that are split next.
    fn chosen(&self, matter: &[f64]) -> Vec<bool> {
        let mut order: Vec<usize> = (0..self.elements.len()).filter(|&index| matter[index] > 0.0).collect();
        order.sort_by(|&a, &b| matter[b].total_cmp(&matter[a]));
        let largest = order.first().map_or(0.0, |&index| matter[index]);
        let mut chosen = vec![false; self.elements.len()];
        let mut nodes = self.size();
        for index in order {
            nodes += (PARTS - 1) * self.elements[index].count();
            if nodes > MOST_NODES || (largest.is_finite() && matter[index] < NEGLIGIBLE * largest) {
                break;
            }
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
