//! Monte Carlo: light is followed backwards from receivers along random paths, through everything that a scene can say: mirrors, metals,
//! boundaries of media, media that absorb and scatter, and diffuse surfaces.
//!
//! ```text
//! scene ─▶ world (walls, media, luminaires) ─┐
//! question ─▶ samples ─▶ first vertex ───────┴─▶ path: vertex ─▶ light straight from luminaires, and the next vertex ─▶ … ─▶ sums
//! sums of independent replicates ─▶ mean, standard error ─▶ more samples, until the error is small enough
//! ```
//! L(x, ω) = Lₑ + T L is expanded into its Neumann series; a path finds one term after the other. At each vertex that spreads light, a direction
//! to a luminaire and one by the law of the vertex are both taken, and what both can find is weighed by the power heuristic; so is what flat
//! mirrors show of luminaires. Every direction and distance comes from a warp of the library, whose density is the proved reciprocal of its pullback.
//!
//! Source: E. Veach, Robust Monte Carlo methods for light transport simulation (1997).

mod boundary;
mod chains;
mod choice;
mod endless;
mod expansion;
mod extinction;
mod follow;
mod forced;
mod imaged;
mod images;
mod kept;
mod kernels;
mod lattice;
mod luminaires;
mod mirror;
mod near;
mod next_event;
mod optics;
mod path;
mod question;
mod refraction;
mod replicates;
mod scattering;
mod time;
mod trap;
mod vertex;
mod warps;
mod world;

pub(crate) use endless::endless;
pub(crate) use extinction::{extinction_alone, scattering_once};
pub(crate) use follow::Follow;
pub(crate) use images::LEFT_OUT;
pub(crate) use kept::{KeptSums, WrittenSums};
pub(crate) use kernels::kernels;
pub(crate) use lattice::{Effects, follower, has_too_many_images};
pub(crate) use path::Limits;
pub(crate) use question::{Question, Seen};
pub(crate) use replicates::{Bins, REPLICATES, Replicates};
pub(crate) use trap::trap;
pub(crate) use world::World;
