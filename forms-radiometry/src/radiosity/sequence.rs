//! Point sets of low discrepancy and random numbers: a key becomes points of the unit square, or numbers one after another.
//!
//! ```text
//! key ─▶ random bits ─▶ shift of the sequence (Net), or the numbers themselves (Random)
//! ```
//! The sequence is the (0, 2)-sequence of van der Corput and Sobol: of the first 4ⁿ points one lies in each cell of any of the grids
//! of 4ⁿ equal cells whose sides are powers of two. A random digital shift keeps that, and makes every point uniform, so that means
//! over the points have no bias. Keys alone decide everything: answers do not depend on threads.
//!
//! Sources: T. Kollig, A. Keller, Efficient multidimensional sampling (2002); G. Steele, D. Lea, C. Flood, Fast splittable
//! pseudorandom number generators (2014).

/// Digits of a coordinate: so many that the middle of each of the least intervals is a number in (0, 1).
const DIGITS: u32 = 52;

/// A key made of another one and a number.
pub(super) fn key(parent: u64, number: u64) -> u64 {
    mixed(parent ^ mixed(number.wrapping_add(0x9e37_79b9_7f4a_7c15)))
}

/// A bijection of 64 bits that leaves no trace of order: that of SplitMix64.
fn mixed(bits: u64) -> u64 {
    let bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// The middle of one of the least intervals.
fn number(digits: u64) -> f64 {
    (digits as f64 + 0.5) / (1_u64 << DIGITS) as f64
}

/// Random numbers from 0 to 1, without the ends.
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(key: u64) -> Self {
        Self(key)
    }

    pub(super) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        number(mixed(self.0) >> (64 - DIGITS))
    }
}

/// A sequence of points of the unit square with a shift of its own.
#[derive(Clone, Copy, Debug)]
pub(super) struct Net {
    shift: [u64; 2],
}

impl Net {
    pub(super) fn new(of: u64) -> Self {
        Self { shift: [0, 1].map(|axis| key(of, axis) >> (64 - DIGITS)) }
    }

    /// One of the points; no coordinate is 0 or 1.
    pub(super) fn point(&self, index: u32) -> [f64; 2] {
        let shifted = |radical: u32, shift| number((u64::from(radical) << (DIGITS - 32)) ^ shift);
        [shifted(index.reverse_bits(), self.shift[0]), shifted(sobol(index), self.shift[1])]
    }
}

/// The second coordinate of Sobol: the binary digits of an index times Pascal's triangle modulo two.
fn sobol(mut index: u32) -> u32 {
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
    fn random_numbers_are_uniform() {
        let mut random = Random::new(1);
        let mut counts = [0_i32; 16];
        (0..1 << 14).for_each(|_| counts[(16.0 * random.next()) as usize] += 1);
        let squares: i32 = counts.iter().map(|count| (count - (1 << 10)).pow(2)).sum();
        // chi square with 15 degrees of freedom: beyond 45 once in 10⁴
        assert!(f64::from(squares) / 1024.0 < 45.0, "{counts:?}");
    }
}
