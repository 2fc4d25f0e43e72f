//! Sharing: a loop is run by one thread or shared by all, as its operations tell.
//!
//! ```text
//! rows × operations of a kernel ─▶ Sharing ─┬─ Alone:  in the thread that asks, in order
//!                                           └─ Shared: by all threads; results in the same order
//! ```
//! What is found does not depend on it.

use rayon::prelude::*;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Operations below which one thread is done before others would be worth it. In vectors it does so many in some 0.15 ms; a loop that is
/// shared waits 10 to 50 µs for the others to wake.
const WORTHWHILE: f64 = 2e6;

/// Whether a loop is shared by threads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sharing {
    Alone,
    Shared,
}

impl Sharing {
    /// Of a loop of so many operations.
    pub(crate) fn of(operations: f64) -> Self {
        if operations < WORTHWHILE { Self::Alone } else { Self::Shared }
    }

    /// Does some work inside of the threads, if it has loops that are shared: one way in, instead of one for every loop, each of which
    /// would wait for them to wake.
    pub(crate) fn enter<R: Send>(self, work: impl FnOnce() -> R + Send) -> R {
        match self {
            Self::Alone => work(),
            Self::Shared => rayon::scope(|_| work()),
        }
    }

    /// What is made by two works that do not wait for each other.
    pub(crate) fn both<A: Send, B: Send>(
        self,
        one: impl FnOnce() -> A + Send,
        other: impl FnOnce() -> B + Send,
    ) -> (A, B) {
        match self {
            Self::Alone => (one(), other()),
            Self::Shared => rayon::join(one, other),
        }
    }

    /// What is made of the first item of which something is.
    pub(crate) fn find_map<I, R: Send>(
        self,
        items: I,
        each: impl Fn(<I as IntoIterator>::Item) -> Option<R> + Send + Sync,
    ) -> Option<R>
    where
        I: IntoIterator + IntoParallelIterator<Item = <I as IntoIterator>::Item>,
    {
        match self {
            Self::Alone => items.into_iter().find_map(each),
            Self::Shared => items.into_par_iter().find_map_first(each),
        }
    }

    /// What is made of each item, in their order, with lists that each thread keeps from item to item.
    pub(crate) fn map<I, S: Default + Send, R: Send>(
        self,
        items: I,
        each: impl Fn(&mut S, <I as IntoIterator>::Item) -> R + Send + Sync,
    ) -> Vec<R>
    where
        I: IntoIterator
            + IntoParallelIterator<Item = <I as IntoIterator>::Item, Iter: IndexedParallelIterator>,
    {
        match self {
            Self::Alone => {
                let mut lists = S::default();
                items.into_iter().map(|item| each(&mut lists, item)).collect()
            }
            Self::Shared => {
                let free = Mutex::new(Vec::new());
                let lent = || Lent { lists: lock(&free).pop().unwrap_or_default(), free: &free };
                let each = |lent: &mut Lent<S>, item| each(&mut lent.lists, item);
                items.into_par_iter().map_init(lent, each).collect()
            }
        }
    }
}

/// Lists lent to a part of a loop, given back for the next one.
struct Lent<'f, S: Default> {
    lists: S,
    free: &'f Mutex<Vec<S>>,
}

impl<S: Default> Drop for Lent<'_, S> {
    fn drop(&mut self) {
        lock(self.free).push(std::mem::take(&mut self.lists));
    }
}

/// The lists that are free. Each is whole, whatever happened to one that had another.
fn lock<S>(free: &Mutex<Vec<S>>) -> MutexGuard<'_, Vec<S>> {
    free.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loop_gives_the_same_alone_and_shared() {
        let squares = |sharing: Sharing| {
            sharing.map(0..1000_usize, |sum: &mut usize, item| {
                *sum += 1;
                item * item
            })
        };
        assert_eq!(squares(Sharing::Alone), squares(Sharing::Shared));
        let first_even =
            |sharing: Sharing| sharing.find_map(1..1000_usize, |item| item.is_multiple_of(2).then_some(item));
        assert_eq!([first_even(Sharing::Alone), first_even(Sharing::Shared)], [Some(2); 2]);
        let both = |sharing: Sharing| sharing.both(|| 1, || "two");
        assert_eq!([both(Sharing::Alone), both(Sharing::Shared)], [(1, "two"); 2]);
        assert_eq!(Sharing::of(0.9 * WORTHWHILE), Sharing::Alone);
        assert_eq!(Sharing::of(WORTHWHILE), Sharing::Shared);
    }
}
