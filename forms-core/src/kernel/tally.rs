//! Priority queue whose scores change between queries for the best one.

use rustc_hash::FxHashMap;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::hash::Hash;

/// Keys with scores. Among several keys with the best score, the least key is the best.
pub(super) struct Tally<K: Ord> {
    scores: FxHashMap<K, i32>,
    /// Every positive score that a key has had; outdated scores are skipped.
    queue: BinaryHeap<(i32, Reverse<K>)>,
}

impl<K: Ord> Default for Tally<K> {
    fn default() -> Self {
        Tally { scores: FxHashMap::default(), queue: BinaryHeap::new() }
    }
}

impl<K: Ord + Hash + Copy> Tally<K> {
    /// Changes a score, which starts at `start`.
    pub(super) fn add(&mut self, key: K, start: i32, change: i32) {
        let score = self.scores.entry(key).or_insert(start);
        *score += change;
        if *score > 0 {
            self.queue.push((*score, Reverse(key)));
        }
    }

    /// Removes and returns the key with the best positive score.
    pub(super) fn take_best(&mut self) -> Option<K> {
        while let Some((score, Reverse(key))) = self.queue.pop() {
            if self.scores.get(&key) == Some(&score) {
                return Some(key);
            }
        }
        None
    }

    /// Removes a key and its score.
    pub(super) fn remove(&mut self, key: &K) {
        self.scores.remove(key);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_best_is_by_present_scores() {
        let mut tally = Tally::default();
        for (key, change) in [('a', 3), ('b', 2), ('c', 2), ('a', -2), ('d', 0)] {
            tally.add(key, 0, change);
        }
        let order: Vec<char> = std::iter::from_fn(|| tally.take_best()).collect();
        assert_eq!(order, ['b', 'c', 'a']);
    }
}
