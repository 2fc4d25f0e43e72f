//! Kept elements: elements that a refinement does not split are not computed again. The weights of two kept
//! elements, and the direct light of one, are pure geometry and stay as they are.
//!
//! ```text
//!                     kept sources   new sources
//! kept elements       copied         computed
//! new elements        computed       computed
//! ```

use super::operator::{Operator, Row};
use super::received::Received;
use std::ops::Range;

/// Elements before and after a refinement. Their order does not change.
pub(super) struct Kept {
    /// The first node of each element before, and at the end the number of all nodes.
    first: Vec<usize>,
    /// For each element its index before, if it was not split.
    before: Vec<Option<usize>>,
    /// For each element before its index now, if it was not split.
    now: Vec<Option<usize>>,
}

impl Kept {
    /// Nothing is kept: there are no elements before.
    pub(super) fn nothing(elements: usize) -> Self {
        Self { first: vec![0], before: vec![None; elements], now: Vec::new() }
    }

    /// `now` has the index of each earlier element, if it was not split; `elements` is the number
    /// of elements now.
    pub(super) fn of(now: Vec<Option<usize>>, elements: usize, first: Vec<usize>) -> Self {
        let mut before = vec![None; elements];
        for (index, now) in now.iter().enumerate().filter_map(|(index, now)| Some((index, (*now)?))) {
            before[now] = Some(index);
        }
        Self { first, before, now }
    }

    /// Whether the weights of a source at the nodes of an element were there before.
    pub(super) fn has(&self, element: usize, source: usize) -> bool {
        self.before[element].is_some() && self.before[source].is_some()
    }

    /// Returns the earlier light at the nodes of an element, without rows, from the direct light and
    /// the jumps before; `None` if the element is new.
    pub(super) fn received(
        &self,
        element: usize,
        [direct, beams, jumps]: [&[Vec<f64>]; 3],
    ) -> Option<Received> {
        let before = self.before[element]?;
        let nodes = self.first[before]..self.first[before + 1];
        Some(Received {
            rows: Vec::new(),
            direct: of_nodes(direct, nodes.clone()),
            beams: of_nodes(beams, nodes),
            jump: jumps.iter().filter_map(|band| band.get(before).copied()).collect(),
        })
    }

    /// Adds to the rows of an element the weights of the sources that they had before, if the
    /// element is kept. `first` has the first node of each element now.
    pub(super) fn add(&self, element: usize, operator: &Operator, first: &[usize], rows: &mut [Row]) {
        let Some(before) = self.before[element] else { return };
        for (row, node) in rows.iter_mut().zip(self.first[before]..) {
            let new = std::mem::take(row);
            let mut new = new.entries(first).peekable();
            for (source, weights) in operator.entries(node) {
                let Some(source) = self.now[source] else { continue };
                while let Some((new, weights)) = new.next_if(|&(new, _)| new < source) {
                    row.push(new, weights);
                }
                row.push(source, weights);
            }
            new.for_each(|(new, weights)| row.push(new, weights));
        }
    }
}

/// Returns for each of these nodes the values in all bands; none if there are none.
fn of_nodes(values: &[Vec<f64>], nodes: Range<usize>) -> Vec<Vec<f64>> {
    if values.iter().all(Vec::is_empty) {
        return Vec::new();
    }
    nodes.map(|node| values.iter().map(|band| band[node]).collect()).collect()
}
