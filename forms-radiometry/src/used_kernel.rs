//! Kernels that a simulation runs, as plans list them.

/// A kernel that a simulation runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UsedKernel {
    /// Its name in the library.
    pub name: &'static str,
    /// The effects of the kernel that the code of its specialisation does not contain.
    pub without: Vec<&'static str>,
    /// Number of operations for a value.
    pub operations: usize,
    /// Number of operations for a value with all effects of the kernel.
    pub operations_of_all: usize,
    /// Description of the quantity that it computes.
    pub what: &'static str,
}

impl UsedKernel {
    /// Returns a kernel without effects.
    pub(crate) fn whole(name: &'static str, operations: usize, what: &'static str) -> Self {
        Self { name, without: Vec::new(), operations, operations_of_all: operations, what }
    }
}
