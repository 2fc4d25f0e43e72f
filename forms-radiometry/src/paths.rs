//! Monte Carlo: backward path tracing from the receivers. It covers every feature of a scene file:
//! mirrors, metals, interfaces between media, absorbing and scattering media, and diffuse surfaces.
//!
//! ```text
//! scene ─▶ world (walls, media, luminaires) ─┐
//! query ─▶ samples ─▶ first vertex ──────────┴─▶ path
//! path: vertex ─▶ next-event estimation, and the next vertex ─▶ … ─▶ sums
//! independent replicates ─▶ mean, standard error ─▶ more samples, until the error is small enough
//! ```
//! L(x, ω) = Lₑ + T L is expanded into its Neumann series; a path estimates the terms in order. At
//! each vertex that scatters light, two directions are sampled: one to a luminaire (next-event
//! estimation) and one from the scattering distribution of the vertex. Contributions that both
//! techniques can produce are combined by multiple importance sampling with the power heuristic.
//! The same holds for the images of luminaires in flat mirrors. Every direction and distance comes
//! from a warp of the library, whose density is the proved reciprocal of its pullback.
//!
//! Source: E. Veach, Robust Monte Carlo methods for light transport simulation (1997).

mod boundary;
mod chains;
mod checkpoint;
mod choice;
mod coat;
mod dispatch;
pub(crate) mod driver;
mod environment_light;
mod estimand;
mod expansion;
mod extinction;
mod first_hit;
mod forced_collision;
mod image_light;
mod image_ray;
mod image_sources;
mod interface;
mod kernels;
mod light_forms;
mod light_trap;
mod luminaires;
mod mirror;
mod multiple_importance;
mod near_field;
mod next_event;
mod optics;
mod path_sampler;
mod refraction;
mod replicates;
mod rough_lobes;
mod rough_reflection;
mod round_samples;
mod scattering;
mod shading_normals;
mod specialisation;
mod sums;
mod time;
mod trace;
mod tracer;
mod unbounded_medium;
mod vertex;
mod wall_textures;
pub(crate) mod warps;
mod world;

pub(crate) use checkpoint::{KeptSums, WrittenSums};
pub(crate) use dispatch::{has_too_many_images, path_samplers};
pub(crate) use estimand::Estimand;
pub(crate) use extinction::{extinction_alone, scattering_once};
pub(crate) use first_hit::FirstHit;
pub(crate) use image_sources::LEFT_OUT;
pub(crate) use kernels::kernels;
pub(crate) use light_trap::trap;
pub(crate) use path_sampler::PathSampler;
pub(crate) use replicates::Replicates;
pub(crate) use sums::Bins;
pub(crate) use tracer::Limits;
pub(crate) use unbounded_medium::endless;
pub(crate) use world::{World, walls_of};
