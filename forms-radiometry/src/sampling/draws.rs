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

/// Number of segments of a path between two checks whether the work was stopped.
const SEGMENTS: u64 = 1 << 16;

/// The sample numbers of one path, and the contributions that it lost to occlusion.
#[derive(Clone)]
pub(crate) struct Draws<'d> {
    pub(crate) path: Samples,
    pub(crate) light: Samples,
    pub(crate) chance: Random,
    /// For each band, the largest contribution that a luminaire would have made without occlusion.
    pub(crate) hidden: [f64; SHARED],
    /// Number of segments of the path.
    pub(crate) segments: u64,
    is_stopped: &'d (dyn Fn() -> bool + Sync),
}

impl<'d> Draws<'d> {
    /// Creates the draws for the point with this index of the sequence that a key identifies. A path
    /// of very many segments is cut where the work was stopped.
    pub(crate) fn new(of: u64, index: u32, is_stopped: &'d (dyn Fn() -> bool + Sync)) -> Self {
        Self {
            path: Samples::joint(key(of, 0), index),
            light: Samples::new(key(of, 1), index),
            chance: Random::new(key(key(of, 2), u64::from(index))),
            hidden: [0.0; SHARED],
            segments: 0,
            is_stopped,
        }
    }

    /// Counts a segment. Returns whether the path is cut before it: then any light may be lost.
    pub(crate) fn is_cut(&mut self) -> bool {
        self.segments += 1;
        let is_cut = self.segments.is_multiple_of(SEGMENTS) && (self.is_stopped)();
        if is_cut {
            self.hidden = [f64::INFINITY; SHARED];
        }
        is_cut
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_drawn_of_one_kind_does_not_change_the_others() {
        let (mut one, mut other) = (Draws::new(3, 5, &|| false), Draws::new(3, 5, &|| false));
        (0..3).for_each(|_| _ = (one.light.pair(), one.chance.next()));
        (0..20).for_each(|_| assert_eq!(one.path.pair(), other.path.pair()));
        assert_eq!([one.path.are_even(), other.light.are_even()], [false, true]);
    }
    #[test]
    fn a_long_path_is_cut_where_the_work_was_stopped_and_may_have_lost_any_light() {
        for is_stopped in [false, true] {
            let mut draws = Draws::new(3, 5, if is_stopped { &|| true } else { &|| false });
            let cuts = (0..3 * SEGMENTS).filter(|_| draws.is_cut()).count();
            assert_eq!(cuts, if is_stopped { 3 } else { 0 });
            assert_eq!(draws.hidden[0], if is_stopped { f64::INFINITY } else { 0.0 });
        }
    }
}
