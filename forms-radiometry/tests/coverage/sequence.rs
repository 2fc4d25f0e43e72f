//! Low-discrepancy points of a cube: multiples of the roots of primes, shifted at random.

use forms_testing::SplitMix;

/// The roots of these have irrational parts that are independent of each other.
const PRIMES: [u32; 20] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71];

/// Sequence of points, coordinate by coordinate; the coordinates after the last prime are random.
pub(crate) struct Sampler {
    shifts: [f64; PRIMES.len()],
    random: SplitMix,
    index: f64,
    dimension: usize,
}

impl Sampler {
    pub(crate) fn new(seed: u64) -> Self {
        let mut random = SplitMix(seed);
        let shifts = std::array::from_fn(|_| random.unit());
        Self { shifts, random, index: 0.0, dimension: 0 }
    }

    /// Advances to the next point.
    pub(crate) fn advance(&mut self) {
        self.index += 1.0;
        self.dimension = 0;
    }

    /// Returns the next coordinate of the point.
    pub(crate) fn next(&mut self) -> f64 {
        let dimension = self.dimension;
        self.dimension += 1;
        match PRIMES.get(dimension) {
            Some(&prime) => (self.index * f64::from(prime).sqrt() + self.shifts[dimension]).fract(),
            None => self.random.unit(),
        }
    }
}
