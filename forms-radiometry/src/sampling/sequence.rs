//! Low-discrepancy point sets and random numbers: a key determines points of the unit square, or a
//! sequence of numbers.
//!
//! ```text
//! key ─▶ random bits ─▶ scrambling of the sequence (Net), or the numbers themselves (Random)
//! key, index ─▶ point with any number of dimensions (Samples)
//! ```
//! The sequence is the (0, 2)-sequence of van der Corput and Sobol: of its first 4ⁿ points, one
//! lies in each cell of any grid of 4ⁿ equal cells whose sides are powers of two. It is randomized
//! by Owen scrambling: each digit is permuted depending on the digits before it. Scrambling
//! preserves this stratification. It makes every point uniform, so that means over the points are
//! unbiased, and places each point in its cell independently of the others. So n points miss a
//! fraction p of the square with probability at most (1 − p)ⁿ, even if that part is a pattern that
//! fits the grid; points with a common random shift could all miss it. Points of many dimensions
//! either are points of [Sobol's sequence](super::sobol), whose dimensions are jointly stratified,
//! or take a point of the (0, 2)-sequence for each pair of dimensions. Each pair then uses its own
//! order of the sequence, so that pairs are independent. Everything follows from the keys: answers
//! do not depend on threads.
//!
//! Sources: T. Kollig, A. Keller, Efficient multidimensional sampling (2002); B. Burley, Practical
//! hash-based Owen scrambling (2020); G. Steele, D. Lea, C. Flood, Fast splittable pseudorandom
//! number generators (2014).

use super::sobol::{DIMENSIONS, reversed};

/// Binary digits of a coordinate: few enough that the middle of each of the smallest intervals is a
/// number in (0, 1).
const DIGITS: u32 = 52;

/// The odd number nearest to 2⁶⁴ divided by the golden ratio.
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// Derives a key from another key and a number.
pub(crate) fn key(parent: u64, number: u64) -> u64 {
    mixed(parent ^ mixed(number.wrapping_add(GOLDEN)))
}

/// Mixes 64 bits bijectively: the finalizer of SplitMix64.
fn mixed(bits: u64) -> u64 {
    let bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// Returns the middle of one of the smallest intervals.
fn number(digits: u64) -> f64 {
    (digits as f64 + 0.5) / (1_u64 << DIGITS) as f64
}

/// Generator of random numbers in (0, 1).
#[derive(Clone, Debug)]
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(key: u64) -> Self {
        Self(key)
    }

    pub(crate) fn next(&mut self) -> f64 {
        number(self.bits() >> (64 - DIGITS))
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(GOLDEN);
        mixed(self.0)
    }
}

/// A sequence of points of the unit square with its own scrambling.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Net {
    seeds: u64,
}

impl Net {
    pub(crate) fn new(of: u64) -> Self {
        Self { seeds: key(of, 0) }
    }

    /// Returns one of the points; no coordinate is 0 or 1.
    pub(crate) fn point(&self, index: u32) -> [f64; 2] {
        pair([index, pascal(index).reverse_bits()], self.seeds, key(!self.seeds, u64::from(index)))
    }
}

/// Returns the second Sobol coordinate: the binary digits of an index times Pascal's triangle
/// modulo two.
fn pascal(mut index: u32) -> u32 {
    let (mut column, mut sum) = (1 << 31, 0);
    while index != 0 {
        if index & 1 == 1 {
            sum ^= column;
        }
        column ^= column >> 1;
        index >>= 1;
    }
    sum
}

/// The number of pairs of dimensions with low-discrepancy points. A path that needs more has had
/// enough random events for plain random numbers to do as well.
pub(super) const EVEN_PAIRS: usize = DIMENSIONS / 2;

/// One point of a sequence with any number of dimensions.
#[derive(Clone, Debug)]
pub(crate) struct Samples {
    key: u64,
    index: u32,
    pair: usize,
    /// Whether all dimensions are jointly stratified, instead of each pair alone.
    are_joint: bool,
    /// Source of the digits beyond those of the sequence, and of coordinates that are not
    /// stratified.
    random: Random,
}

impl Samples {
    /// Creates the point with this index of the sequence that a key identifies. In each pair of
    /// dimensions the first 2ⁿ points are stratified, for every n.
    pub(crate) fn new(key: u64, index: u32) -> Self {
        let random = Random::new(self::key(!key, u64::from(index)));
        Self { key, index, pair: 0, are_joint: false, random }
    }

    /// Creates the same point of a sequence whose dimensions are jointly stratified.
    pub(crate) fn joint(key: u64, index: u32) -> Self {
        Self { are_joint: true, ..Self::new(key, index) }
    }

    /// Whether the next coordinates are stratified.
    pub(crate) fn are_even(&self) -> bool {
        self.pair < EVEN_PAIRS
    }

    /// Returns the next two coordinates, in (0, 1).
    pub(crate) fn pair(&mut self) -> [f64; 2] {
        match self.next() {
            Some((reversed, seeds)) => pair(reversed, seeds, self.random.bits()),
            None => [self.random.next(), self.random.next()],
        }
    }

    /// Returns the next coordinate.
    pub(crate) fn one(&mut self) -> f64 {
        match self.next() {
            Some(([first, _], seeds)) => scrambled(first, seeds, self.random.bits()),
            None => self.random.next(),
        }
    }

    /// Returns the reversed digits of the next two coordinates, and random bits of the pair; `None`
    /// if the coordinates are plain random numbers.
    fn next(&mut self) -> Option<([u32; 2], u64)> {
        if !self.are_even() {
            return None;
        }
        let seeds = key(self.key, self.pair as u64);
        let digits = if self.are_joint {
            reversed(self.pair, self.index)
        } else {
            let place = hashed(self.index.reverse_bits(), mixed(seeds) as u32).reverse_bits();
            [place, pascal(place).reverse_bits()]
        };
        self.pair += 1;
        Some((digits, seeds))
    }
}

/// Scrambles two coordinates, given by their reversed digits, with the halves of a seed.
fn pair([first, second]: [u32; 2], seeds: u64, rest: u64) -> [f64; 2] {
    [scrambled(first, seeds, rest), scrambled(second, seeds >> 32, rest << 32)]
}

/// Scrambles a coordinate, given by its reversed digits, with the lower half of a seed. Digits
/// beyond those of the sequence are random.
fn scrambled(reversed: u32, seed: u64, rest: u64) -> f64 {
    let digits = hashed(reversed, seed as u32).reverse_bits();
    number(u64::from(digits) << (DIGITS - 32) | rest >> (64 - (DIGITS - 32)))
}

/// Permutes numbers so that each binary digit is flipped or not depending on the digits below it
/// and a seed: the hash of Laine and Karras.
fn hashed(digits: u32, seed: u32) -> u32 {
    let mut x = digits.wrapping_add(seed);
    for factor in [0x6c50_b47c_u32, 0xb82f_1e52, 0xc7af_e638, 0x8d22_f6e6] {
        x ^= x.wrapping_mul(factor);
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_elementary_cell_has_one_point() {
        for shift in 0..4 {
            let net = Net::new(key(7, shift));
            for bits in [4, 6, 8] {
                for rows in 0..=bits {
                    let (columns, rows) = (1_usize << (bits - rows), 1_usize << rows);
                    let mut counts = vec![0; columns * rows];
                    for index in 0..1 << bits {
                        let [u, v] = net.point(index);
                        counts[(v * rows as f64) as usize * columns + (u * columns as f64) as usize] += 1;
                    }
                    assert!(counts.iter().all(|&count| count == 1), "{columns} by {rows}: {counts:?}");
                }
            }
        }
    }

    #[test]
    fn a_pattern_that_fits_the_grid_is_met_as_often_as_by_random_points() {
        // a part of 1/50 in each of 16 periods, which 64 points miss with a probability of at most
        // (1 − 1/50)⁶⁴ = 0.27
        let is_met = |seed: u64, axis: usize| {
            let net = Net::new(key(seed, 1));
            (0..64).any(|index| (16.0 * net.point(index)[axis]).fract() < 0.02)
        };
        for axis in [0, 1] {
            let met = (0..1000).filter(|&seed| is_met(seed, axis)).count();
            assert!(met > 680, "{axis}: {met}");
        }
    }

    #[test]
    fn each_pair_of_dimensions_lies_evenly() {
        for (pair, bits) in [(0, 4), (1, 6), (2, 8), (7, 8), (EVEN_PAIRS - 1, 8)] {
            for rows in 0..=bits {
                let (columns, rows) = (1_usize << (bits - rows), 1_usize << rows);
                let mut counts = vec![0; columns * rows];
                for index in 0..1 << bits {
                    let mut samples = Samples::new(key(9, 4), index);
                    (0..pair).for_each(|_| _ = samples.pair());
                    let [u, v] = samples.pair();
                    counts[(v * rows as f64) as usize * columns + (u * columns as f64) as usize] += 1;
                }
                assert!(counts.iter().all(|&count| count == 1), "{pair}, {columns} by {rows}: {counts:?}");
            }
        }
    }

    #[test]
    fn pairs_of_dimensions_know_nothing_of_each_other() {
        const POINTS: u32 = 1 << 12;
        let point = |index: u32| {
            let mut samples = Samples::new(key(2, 3), index);
            let pairs: Vec<[f64; 2]> = (0..EVEN_PAIRS + 2).map(|_| samples.pair()).collect();
            pairs.as_flattened().iter().map(|x| x - 0.5).collect::<Vec<f64>>()
        };
        let points: Vec<Vec<f64>> = (0..POINTS).map(point).collect();
        let dimensions = points[0].len();
        for a in 0..dimensions {
            for b in a + 1..dimensions {
                let correlation = points.iter().map(|x| 12.0 * x[a] * x[b]).sum::<f64>() / f64::from(POINTS);
                // for independent points it exceeds 5/√n once in 10⁶
                assert!(correlation.abs() < 5.0 / f64::from(POINTS).sqrt(), "{a}, {b}: {correlation}");
            }
        }
    }

    #[test]
    fn means_of_scrambled_points_have_no_bias_and_little_spread() {
        let mean = |seed: u64| {
            let value = |index| {
                let mut samples = Samples::new(key(seed, 0), index);
                let [[u, v], [s, t]] = [samples.pair(), samples.pair()];
                (u * v).sqrt() + s * s * t
            };
            (0..1024).map(value).sum::<f64>() / 1024.0
        };
        let means: Vec<f64> = (0..64).map(mean).collect();
        let exact = 4.0 / 9.0 + 1.0 / 6.0;
        let error = means.iter().sum::<f64>() / 64.0 - exact;
        let deviation = (means.iter().map(|mean| (mean - exact).powi(2)).sum::<f64>() / 64.0).sqrt();
        // random points would deviate by 1e-2
        assert!(deviation < 1e-3 && error.abs() < 4.0 * deviation / 8.0, "{error}, {deviation}");
    }

    #[test]
    fn dimensions_that_lie_evenly_together_leave_less_spread_of_what_depends_on_several() {
        const POINTS: u32 = 256;
        const SEEDS: u64 = 256;
        let product = |mut samples: Samples| (0..4).map(|_| 0.5 + samples.one()).product::<f64>();
        let spread = |of: fn(u64, u32) -> Samples| {
            let mean = |seed| {
                (0..POINTS).map(|index| product(of(key(seed, 1), index))).sum::<f64>() / f64::from(POINTS)
            };
            ((0..SEEDS).map(|seed| (mean(seed) - 1.0).powi(2)).sum::<f64>() / SEEDS as f64).sqrt()
        };
        let (joint, apart) = (spread(Samples::joint), spread(Samples::new));
        assert!(joint < 0.5 * apart, "{joint}, {apart}");
    }

    #[test]
    fn random_numbers_are_uniform() {
        let mut random = Random::new(1);
        let mut counts = [0_i32; 16];
        (0..1 << 14).for_each(|_| counts[(16.0 * random.next()) as usize] += 1);
        let squares: i32 = counts.iter().map(|count| (count - (1 << 10)).pow(2)).sum();
        // chi-squared with 15 degrees of freedom: exceeds 45 once in 10⁴
        assert!(f64::from(squares) / 1024.0 < 45.0, "{counts:?}");
    }
}
