//! Optimisation: the passes in their order, each of which keeps the value.

use super::numbering::number_values;
use super::program::Program;

impl Program {
    /// The same kernel at least cost.
    pub fn optimise(&self) -> Program {
        number_values(self)
    }
}
