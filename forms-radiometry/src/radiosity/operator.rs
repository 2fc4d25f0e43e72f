//! Transport operator: rows of form factors from nodes to elements become G, which maps an
//! irradiance to the irradiance after one more reflection.
//!
//! ```text
//! (G E)ᵢ = Σₑ ρₑ Σₖ Wᵢₑₖ Eₑₖ
//! ```
//! The rows are pure geometry: all bands share them, and several bands are summed in one pass over
//! the weights, which memory delivers more slowly than they are multiplied: 15 bands take two times
//! as long as one.

use rayon::prelude::*;

/// Maximum number of bands that are summed in one pass.
const TOGETHER: usize = 8;
/// Number of parts of the rows that are transposed at the same time.
const PARTS: usize = 8;

/// Reflectances of the elements, and irradiance of the nodes, in one band.
pub(super) type Band<'a> = [&'a [f64]; 2];

/// Weights of one node for the elements that it sees.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Row {
    /// The elements.
    pub(super) elements: Vec<u32>,
    /// The weights of their nodes, one element after the other.
    pub(super) weights: Vec<f64>,
}

impl Row {
    /// Adds an element that comes after the others.
    pub(super) fn push(&mut self, element: usize, weights: &[f64]) {
        self.elements.push(element as u32);
        self.weights.extend_from_slice(weights);
    }

    /// Returns the elements with the weights of their nodes; `first` has the first node of each
    /// element.
    pub(super) fn entries<'r>(&'r self, first: &'r [usize]) -> impl Iterator<Item = (usize, &'r [f64])> {
        let mut weights = self.weights.as_slice();
        self.elements.iter().map(move |&element| {
            let element = element as usize;
            let (own, rest) = weights.split_at(first[element + 1] - first[element]);
            weights = rest;
            (element, own)
        })
    }
}

/// The rows of all nodes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Operator {
    rows: Vec<Row>,
    /// The first node of each element, and at the end the number of all nodes.
    first: Vec<usize>,
}

impl Operator {
    pub(super) fn new(rows: Vec<Row>, first: Vec<usize>) -> Self {
        Self { rows, first }
    }

    /// Returns the elements that a node sees with the weights of their nodes.
    pub(super) fn entries(&self, node: usize) -> impl Iterator<Item = (usize, &[f64])> {
        self.rows[node].entries(&self.first)
    }

    /// Returns the number of nodes.
    pub(super) fn size(&self) -> usize {
        self.first.last().copied().unwrap_or(0)
    }

    /// Returns G E of each band.
    pub(super) fn apply(&self, bands: &[Band]) -> Vec<Vec<f64>> {
        let together = |bands: &[Band]| match bands.len() {
            1 => self.apply_together::<1>(bands),
            2..=4 => self.apply_together::<4>(bands),
            _ => self.apply_together::<TOGETHER>(bands),
        };
        bands.chunks(TOGETHER).flat_map(together).collect()
    }

    /// Returns G E of at most `COUNT` bands: each weight is read once for all of them.
    fn apply_together<const COUNT: usize>(&self, bands: &[Band]) -> Vec<Vec<f64>> {
        let mut exitance = vec![[0.0; COUNT]; self.size()];
        for (lane, [reflectances, irradiance]) in bands.iter().enumerate() {
            for (nodes, reflectance) in self.first.windows(2).zip(*reflectances) {
                for node in nodes[0]..nodes[1] {
                    exitance[node][lane] = reflectance * irradiance[node];
                }
            }
        }
        let of_row = |row: &Row| {
            let mut sums = [0.0; COUNT];
            for (element, weights) in row.entries(&self.first) {
                let mut arriving = [0.0; COUNT];
                for (weight, exitance) in weights.iter().zip(&exitance[self.first[element]..]) {
                    arriving.iter_mut().zip(exitance).for_each(|(sum, value)| *sum += weight * value);
                }
                sums.iter_mut().zip(arriving).for_each(|(sum, arriving)| *sum += arriving);
            }
            sums
        };
        let sums: Vec<[f64; COUNT]> = self.rows.par_iter().with_min_len(16).map(of_row).collect();
        (0..bands.len()).map(|lane| sums.iter().map(|sums| sums[lane]).collect()).collect()
    }

    /// Returns for each band and each node the sum over the elements that the node sees of what
    /// `add` adds for an element and the weights of its nodes.
    pub(super) fn sums(&self, bands: usize, add: impl Fn(usize, &[f64], &mut [f64]) + Sync) -> Vec<Vec<f64>> {
        let of_row = |row: &Row| {
            let mut sums = vec![0.0; bands];
            row.entries(&self.first).for_each(|(element, weights)| add(element, weights, &mut sums));
            sums
        };
        let sums: Vec<Vec<f64>> = self.rows.par_iter().with_min_len(16).map(of_row).collect();
        (0..bands).map(|band| sums.iter().map(|sums| sums[band]).collect()).collect()
    }

    /// Returns Gᵀ z for these reflectances.
    pub(super) fn apply_transposed(&self, reflectances: &[f64], importance: &[f64]) -> Vec<f64> {
        // the parts do not depend on the number of threads, nor do the roundings of their sum
        let part = self.rows.len().div_ceil(PARTS).max(1);
        let of_part = |(rows, importance): (&[Row], &[f64])| {
            let mut sums = vec![0.0; self.size()];
            for (row, &z) in rows.iter().zip(importance) {
                for (element, weights) in row.entries(&self.first) {
                    let factor = reflectances[element] * z;
                    let nodes = &mut sums[self.first[element]..];
                    nodes.iter_mut().zip(weights).for_each(|(sum, weight)| *sum += factor * weight);
                }
            }
            sums
        };
        let parts: Vec<Vec<f64>> =
            self.rows.par_chunks(part).zip(importance.par_chunks(part)).map(of_part).collect();
        let mut sums = vec![0.0; self.size()];
        for part in parts {
            sums.iter_mut().zip(part).for_each(|(sum, value)| *sum += value);
        }
        sums
    }

    /// Returns the norm of the operator in each band: the largest part of a uniform irradiance that
    /// a reflection leaves at a node.
    pub(super) fn norms(&self, reflectances: &[Vec<f64>]) -> Vec<f64> {
        let unit = vec![1.0; self.size()];
        let bands: Vec<Band> = reflectances.iter().map(|r| [&r[..], &unit[..]]).collect();
        self.apply(&bands).iter().map(|light| largest(light)).collect()
    }
}

/// Returns the largest size of these values; 0 if there are none.
pub(super) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m: f64, value| m.max(value.abs()))
}
