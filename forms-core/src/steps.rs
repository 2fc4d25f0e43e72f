//! Steps: what a statement may cost, counted where the work is done and not by a clock, so that the same input gives the
//! same answer on every machine.
//!
//! A step is about what one product of two terms costs. [`limited`] grants some to what runs in it; enclosures, images of
//! polynomials and normal forms [`spend`] them. When they are spent, enclosures are undecided, common divisors are no
//! longer looked for and normal forms are too large: each of these is an answer that is always allowed, so what is proved
//! or refuted is right whatever is granted. Outside of a grant nothing is limited.

use std::cell::Cell;

/// The steps of a statement, or of an item that is resolved: about a second.
pub(crate) const STATEMENT: u64 = 100_000_000;

/// No limit.
const UNLIMITED: u64 = u64::MAX;

thread_local! {
    /// The steps that are left of the grant that this thread works in.
    static LEFT: Cell<u64> = const { Cell::new(UNLIMITED) };
}

/// Runs some work with so many steps. A grant within another counts apart from it: on a thread that helps others, work
/// of one statement may run in the middle of another.
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

/// Spends steps; whether there were so many.
pub(crate) fn spend(steps: u64) -> bool {
    let left = LEFT.get();
    if left == UNLIMITED {
        return true;
    }
    LEFT.set(left.saturating_sub(steps));
    left > steps
}

/// Whether so many steps are left.
pub(crate) fn are_left(steps: u64) -> bool {
    LEFT.get() > steps
}

/// Whether all steps are spent.
pub(crate) fn are_spent() -> bool {
    LEFT.get() == 0
}

/// The steps of arithmetic with numbers of so many binary places, memory and rounding included.
pub(crate) fn of_arithmetic(places: u32) -> u64 {
    96 + u64::from(places) * u64::from(places) / (1 << 17)
}

/// The steps of a function of such numbers, which is a root or a series of some terms.
pub(crate) fn of_function(places: u32) -> u64 {
    of_arithmetic(places) * (4 + u64::from(places.min(MOST_TERMS)) / 16)
}

/// Sixteen times the terms that a series is taken to have at most.
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
