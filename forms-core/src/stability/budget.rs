//! How much work a search may take.

/// Search budget for one kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Number of samples in each regime.
    pub samples: usize,
    /// Number of forms that are expanded.
    pub expansions: usize,
    /// Number of operations of a form to which the rules are applied.
    pub places: usize,
    /// Number of forms that are proved.
    pub proofs: usize,
    /// Number of proofs that can fail before the search is content with the forms that are proved.
    pub failures: usize,
}

impl Default for Budget {
    fn default() -> Self {
        Budget { samples: 48, expansions: 48, places: 8, proofs: 24, failures: 10 }
    }
}
