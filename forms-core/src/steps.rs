//! Step budgets: the cost limit of a statement, counted where the work is done and not by a clock,
//! so that the same input gives the same answer on every machine.
//!
//! A step costs about as much as one product of two terms. [`limited`] grants a number of steps to
//! a closure; enclosures, images of polynomials and normal forms [`spend`] them. When they are
//! spent, enclosures are undecided, common divisors are no longer searched for and normal forms are
//! too large. Each such answer is always valid, so every proof and refutation is right whatever the
//! budget. Outside of a grant nothing is limited.

use std::cell::Cell;

/// Steps for a statement, or for resolving an item: about a second.
pub(crate) const STATEMENT: u64 = 100_000_000;

/// No limit.
const UNLIMITED: u64 = u64::MAX;

thread_local! {
    /// Steps left of this thread's current grant.
    static LEFT: Cell<u64> = const { Cell::new(UNLIMITED) };
}

/// Runs a closure with a budget of `steps`. A nested grant is counted separately: on a thread that
/// helps others, work of one statement can run in the middle of another.
pub(crate) fn limited<T>(steps: u64, work: impl FnOnce() -> T) -> T {
    struct Restored(u64);
    impl Drop for Restored {
        fn drop(&mut self) {
            LEFT.set(self.0);
        }
    }
    let _restored = Restored(LEFT.replace(steps.min(UNLIMITED - 1)));
    work()
}

/// Spends steps; returns whether more than this number were left.
pub(crate) fn spend(steps: u64) -> bool {
    let left = LEFT.get();
    if left == UNLIMITED {
        return true;
    }
    LEFT.set(left.saturating_sub(steps));
    left > steps
}

/// Whether more than this number of steps are left.
pub(crate) fn are_left(steps: u64) -> bool {
    LEFT.get() > steps
}

/// Whether all steps are spent.
pub(crate) fn are_spent() -> bool {
    LEFT.get() == 0
}

/// Returns the steps of one arithmetic operation on numbers of `places` binary places, including
/// memory and rounding.
pub(crate) fn of_arithmetic(places: u32) -> u64 {
    96 + u64::from(places) * u64::from(places) / (1 << 17)
}

/// Returns the steps of a function of such numbers: a root, or a series of some terms.
pub(crate) fn of_function(places: u32) -> u64 {
    of_arithmetic(places) * (4 + u64::from(places.min(MOST_TERMS)) / 16)
}

/// Sixteen times the maximum number of terms assumed for a series.
const MOST_TERMS: u32 = 4096;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grant_ends_where_it_was_given_and_counts_apart_from_others() {
        assert!(spend(1 << 60) && !are_spent());
        limited(10, || {
            assert!(spend(9));
            limited(5, || assert!(!spend(5) && are_spent()));
            assert!(!are_spent() && !spend(1) && are_spent());
        });
        assert!(!are_spent());
    }
}
