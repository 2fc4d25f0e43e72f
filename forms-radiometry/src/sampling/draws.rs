//! Draws: the sample numbers of one path.
//!
//! ```text
//! key, index ─┬─▶ path     directions and distances: jointly stratified dimensions,
//!             │            since together they determine the path
//!             ├─▶ light    luminaires, points on them and on the way to them:
//!             │            dimensions stratified in pairs
//!             └─▶ chance   Russian roulette: random
//! ```
//! Occasional draws do not shift the others: paths with the same number of scatterings take their
//! numbers from the same dimensions.

use super::sequence::{Random, Samples, key};

/// The largest number of bands that share a path.
pub(crate) const SHARED: usize = 4;

/// The sample numbers of one path, and the contributions that it lost to occlusion.
#[derive(Clone, Debug)]
pub(crate) struct Draws {
    pub(crate) path: Samples,
    pub(crate) light: Samples,
    pub(crate) chance: Random,
    /// For each band, the largest contribution that a luminaire would have made without occlusion.
    pub(crate) hidden: [f64; SHARED],
    /// Number of segments of the path.
    pub(crate) segments: u64,
}

impl Draws {
    /// Creates the draws for the point with this index of the sequence that a key identifies.
    pub(crate) fn new(of: u64, index: u32) -> Self {
        Self {
            path: Samples::joint(key(of, 0), index),
            light: Samples::new(key(of, 1), index),
            chance: Random::new(key(key(of, 2), u64::from(index))),
            hidden: [0.0; SHARED],
            segments: 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_drawn_of_one_kind_does_not_change_the_others() {
        let (mut one, mut other) = (Draws::new(3, 5), Draws::new(3, 5));
        (0..3).for_each(|_| _ = (one.light.pair(), one.chance.next()));
        (0..20).for_each(|_| assert_eq!(one.path.pair(), other.path.pair()));
        assert_eq!([one.path.are_even(), other.light.are_even()], [false, true]);
    }
}
