//! Draws: the numbers that decide what one path does.
//!
//! ```text
//! key, index ─┬─▶ path     directions and distances: dimensions that lie evenly together, since all of them make the path
//!             ├─▶ light    luminaires, and points of them and of the way to them: each pair of dimensions lies evenly for itself
//!             └─▶ chance   whether the path ends: random
//! ```
//! What is asked for now and then does not shift the others: paths that were scattered as often have their numbers from the same dimensions.

use super::sequence::{Random, Samples, key};

/// How many bands share a path at most.
pub(crate) const SHARED: usize = 4;

/// The numbers of one path, and what they missed.
#[derive(Clone, Debug)]
pub(crate) struct Draws {
    pub(crate) path: Samples,
    pub(crate) light: Samples,
    pub(crate) chance: Random,
    /// For each band the largest value that a luminaire would have brought had nothing hidden it.
    pub(crate) hidden: [f64; SHARED],
}

impl Draws {
    /// Those of the point with this index of the sequence that a key names.
    pub(crate) fn new(of: u64, index: u32) -> Self {
        Self {
            path: Samples::joint(key(of, 0), index),
            light: Samples::new(key(of, 1), index),
            chance: Random::new(key(key(of, 2), u64::from(index))),
            hidden: [0.0; SHARED],
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
