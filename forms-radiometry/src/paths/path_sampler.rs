//! Path samplers: the path tracers of groups of bands, whatever effects they are specialised for.

use super::estimand::Estimand;
use super::sums::Sums;
use crate::sampling::Draws;

/// Path tracer for a group of bands.
pub(crate) trait PathSampler: Sync {
    /// Returns the first band and the number of bands.
    fn bands(&self) -> [usize; 2];

    /// Returns the value of an estimand without samples, with its error in each band, if it can be
    /// expanded.
    fn expanded(&self, estimand: &Estimand) -> Option<Vec<[f64; 2]>>;

    /// Adds one sample of an estimand to the sums.
    fn sample(&self, estimand: &Estimand, draws: &mut Draws, sums: &mut Sums);
}
