//! Costs of rays and paths, and the least numbers of them: what the choice of the method and the
//! gathering by rays share.

/// Number of rays from each node of the rough solution, and from each point where the emitting part
/// of the hemisphere is sampled.
pub(super) const RAYS: u32 = 32;
/// Cost of one exact view of a face, in rays.
pub(super) const VIEW: f64 = 16.0;
/// Cost of a path, in rays.
pub(super) const PATH: f64 = 16.0;
/// Number of independent batches.
pub(super) const BATCHES: usize = 16;
/// Initial numbers of rays and of paths of a batch.
pub(super) const FIRST: [u32; 2] = [64, 16];
/// Minimum number of paths of an estimand.
pub(super) const FEWEST_PATHS: f64 = (BATCHES as u32 * FIRST[1]) as f64;
/// The two-sided 99.99 % quantile of Student's distribution with 15 degrees of freedom.
pub(super) const STUDENT: f64 = 5.239;
