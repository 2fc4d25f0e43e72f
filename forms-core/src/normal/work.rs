//! Work limits of normal forms: products of terms, and exponents, are checked before the work is
//! done.

use super::obstacle::{Obstacle, SizeLimit};

/// Largest number of products of terms, weighted by the words of their coefficients, that one
/// statement can cost before its normal form is given up: a few seconds of work.
pub(crate) const WORK_LIMIT: u64 = 100_000_000;

/// Largest exponent of a generator or a known factor.
const LARGEST_EXPONENT: u32 = 1 << 20;

/// Work of a tower: products of terms, done and allowed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Work {
    done: u64,
    pub(super) limit: u64,
}

impl Work {
    /// Starts with a limit on the products of terms.
    pub(super) fn with_limit(limit: u64) -> Self {
        Work { done: 0, limit }
    }

    /// Counts products of terms before they are computed.
    pub(super) fn count(&mut self, work: u64) -> Result<(), Obstacle> {
        self.done = self.done.saturating_add(work);
        if self.done > self.limit { Err(self.spent()) } else { Ok(()) }
    }

    /// Returns the obstacle of work beyond the limit.
    pub(super) fn spent(&self) -> Obstacle {
        Obstacle::TooLarge(SizeLimit::Products(self.limit))
    }
}

/// Refuses exponents beyond the limit.
pub(super) fn check_exponent(exponent: u32) -> Result<(), Obstacle> {
    if exponent > LARGEST_EXPONENT {
        return Err(Obstacle::TooLarge(SizeLimit::Exponent(LARGEST_EXPONENT)));
    }
    Ok(())
}
