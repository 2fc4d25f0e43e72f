//! Transport operator: rows of form factors from nodes to elements become G, which maps an
//! irradiance to the irradiance after one more reflection.
//!
//! ```text
//! (G E)ᵢ = Σₑ ρₑ Σₖ Wᵢₑₖ Eₑₖ
//! ```
//! The rows are pure geometry: all bands share them.

use rayon::prelude::*;

/// Weights of one node for the elements that it sees.
#[derive(Clone, Debug, Default)]
pub(super) struct Row {
    /// The elements.
    pub(super) elements: Vec<u32>,
    /// The weights of their nodes, one element after the other.
    pub(super) weights: Vec<f64>,
}

/// The rows of all nodes.
#[derive(Clone, Debug)]
pub(super) struct Operator {
    rows: Vec<Row>,
    /// The first node of each element, and at the end the number of all nodes.
    first: Vec<usize>,
}

impl Operator {
    pub(super) fn new(rows: Vec<Row>, first: Vec<usize>) -> Self {
        Self { rows, first }
    }

    /// Returns the number of nodes.
    pub(super) fn size(&self) -> usize {
        self.first.last().copied().unwrap_or(0)
    }

    /// Returns G E for these reflectances of the elements.
    pub(super) fn apply(&self, reflectances: &[f64], irradiance: &[f64]) -> Vec<f64> {
        self.sums(|element, weights| {
            let nodes = &irradiance[self.first[element]..self.first[element + 1]];
            let arriving: f64 = weights.iter().zip(nodes).map(|(weight, value)| weight * value).sum();
            reflectances[element] * arriving
        })
    }

    /// Returns for each node the sum over the elements that it sees of `of`, applied to the element
    /// and the weights of its nodes.
    pub(super) fn sums(&self, of: impl Fn(usize, &[f64]) -> f64 + Sync) -> Vec<f64> {
        let of_row = |row: &Row| {
            let mut weights = row.weights.as_slice();
            let mut sum = 0.0;
            for &element in &row.elements {
                let element = element as usize;
                let (own, rest) = weights.split_at(self.first[element + 1] - self.first[element]);
                sum += of(element, own);
                weights = rest;
            }
            sum
        };
        self.rows.par_iter().with_min_len(16).map(of_row).collect()
    }

    /// Returns Gᵀ z for these reflectances.
    pub(super) fn apply_transposed(&self, reflectances: &[f64], importance: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.size()];
        for (row, &z) in self.rows.iter().zip(importance) {
            let mut weights = row.weights.as_slice();
            for &element in &row.elements {
                let element = element as usize;
                let nodes = &mut sums[self.first[element]..self.first[element + 1]];
                let (own, rest) = weights.split_at(nodes.len());
                let factor = reflectances[element] * z;
                nodes.iter_mut().zip(own).for_each(|(sum, weight)| *sum += factor * weight);
                weights = rest;
            }
        }
        sums
    }

    /// Estimates the norm of the operator by the part of a uniform irradiance that several
    /// reflections leave: the smallest ‖Gᵐ‖^(1/m) with m ≤ 4, never more than ‖G‖ at the nodes.
    pub(super) fn contraction(&self, reflectances: &[f64]) -> f64 {
        const BOUNCES: i32 = 4;
        let mut light = vec![1.0; self.size()];
        let mut least = f64::INFINITY;
        for bounce in 1..=BOUNCES {
            light = self.apply(reflectances, &light);
            let largest = light.iter().fold(0.0, |m: f64, value| m.max(value.abs()));
            least = least.min(largest.powf(1.0 / f64::from(bounce)));
        }
        if least.is_finite() { least } else { 0.0 }
    }
}
