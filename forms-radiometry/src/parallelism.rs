//! Loop parallelism: a loop runs in one thread or in all threads, depending on its number of
//! operations.
//!
//! ```text
//! rows × operations of a kernel ─▶ Sharing ─┬─ Alone:  in the calling thread, in order
//!                                           └─ Shared: in all threads; results in the same order
//! ```
//! The results do not depend on the choice.

use rayon::prelude::*;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Number of operations below which one thread is faster than several. Vectorized code executes
/// this many in about 0.15 ms; a parallel loop waits 10 to 50 µs for the other threads to wake up.
const WORTHWHILE: f64 = 2e6;

/// Whether a loop runs in parallel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Parallelism {
    Alone,
    Shared,
}

impl Parallelism {
    /// Returns the choice for a loop of this many operations.
    pub(crate) fn of(operations: f64) -> Self {
        if operations < WORTHWHILE { Self::Alone } else { Self::Shared }
    }

    /// Runs some work inside the thread pool if it contains parallel loops. The pool is entered
    /// once instead of once for each loop, each of which would wait for the threads to wake up.
    pub(crate) fn enter<R: Send>(self, work: impl FnOnce() -> R + Send) -> R {
        match self {
            Self::Alone => work(),
            Self::Shared => rayon::scope(|_| work()),
        }
    }

    /// Runs two independent closures and returns both results.
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

    /// Returns the result of the first item, in order, for which `each` returns one.
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

    /// Maps each item and returns the results in order. Each thread keeps its buffers from item to
    /// item.
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

/// Buffers lent to one part of a loop and returned for the next part.
struct Lent<'f, S: Default> {
    lists: S,
    free: &'f Mutex<Vec<S>>,
}

impl<S: Default> Drop for Lent<'_, S> {
    fn drop(&mut self) {
        lock(self.free).push(std::mem::take(&mut self.lists));
    }
}

/// Locks the list of free buffers. A poisoned lock is harmless: each free buffer is intact, even if
/// a thread panicked while it used another one.
fn lock<S>(free: &Mutex<Vec<S>>) -> MutexGuard<'_, Vec<S>> {
    free.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loop_gives_the_same_alone_and_shared() {
        let squares = |parallelism: Parallelism| {
            parallelism.map(0..1000_usize, |sum: &mut usize, item| {
                *sum += 1;
                item * item
            })
        };
        assert_eq!(squares(Parallelism::Alone), squares(Parallelism::Shared));
        let first_even = |parallelism: Parallelism| {
            parallelism.find_map(1..1000_usize, |item| item.is_multiple_of(2).then_some(item))
        };
        assert_eq!([first_even(Parallelism::Alone), first_even(Parallelism::Shared)], [Some(2); 2]);
        let both = |parallelism: Parallelism| parallelism.both(|| 1, || "two");
        assert_eq!([both(Parallelism::Alone), both(Parallelism::Shared)], [(1, "two"); 2]);
        assert_eq!(Parallelism::of(0.9 * WORTHWHILE), Parallelism::Alone);
        assert_eq!(Parallelism::of(WORTHWHILE), Parallelism::Shared);
    }
}
