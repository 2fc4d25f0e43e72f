//! Sums of contributions, for each number, band and time bin.

use serde::{Deserialize, Serialize};

/// Sum with its compensated rounding error: Neumaier (1974).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Sum {
    sum: f64,
    rest: f64,
}

impl Sum {
    pub(crate) fn add(&mut self, value: f64) {
        let sum = self.sum + value;
        self.rest +=
            if self.sum.abs() >= value.abs() { (self.sum - sum) + value } else { (value - sum) + self.sum };
        self.sum = sum;
    }

    pub(crate) fn value(self) -> f64 {
        self.sum + self.rest
    }
}

/// Time bins of light, by optical path length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bins {
    pub(crate) start: f64,
    pub(crate) width: f64,
    pub(crate) count: usize,
}

/// The sums of one replicate: for each number, band and bin.
#[derive(Clone, Debug)]
pub(crate) struct Sums {
    pub(super) sums: Vec<Sum>,
    /// For each band the largest contribution that a sample lost because a light source was
    /// occluded.
    pub(super) missed: Vec<f64>,
    pub(super) bands: usize,
    pub(super) bins: Option<Bins>,
}

impl Sums {
    pub(super) fn new(numbers: usize, bands: usize, bins: Option<Bins>) -> Self {
        let count = bins.map_or(1, |bins| bins.count);
        Self { sums: vec![Sum::default(); numbers * bands * count], missed: vec![0.0; bands], bands, bins }
    }

    /// Returns the bin of light with this optical path length; `None` if it is in no bin.
    pub(super) fn bin(&self, optical_path_length: f64) -> Option<usize> {
        let Some(Bins { start, width, count }) = self.bins else { return Some(0) };
        let place = ((optical_path_length - start) / width).floor();
        (place >= 0.0 && place < count as f64).then_some(place as usize)
    }

    /// Records a contribution that a sample lost to occlusion in a band.
    pub(super) fn miss(&mut self, band: usize, value: f64) {
        self.missed[band] = self.missed[band].max(value);
    }

    pub(super) fn add(&mut self, [number, band, bin]: [usize; 3], value: f64) {
        let bins = self.bins.map_or(1, |bins| bins.count);
        self.sums[(number * self.bands + band) * bins + bin].add(value);
    }
}
