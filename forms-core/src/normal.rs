//! Normal forms: scalar expressions as fractions over a tower of generators, which decide equality.
//!
//! ```text
//! structured expressions ── normalise ──▶ Fraction = polynomial / known factors
//!                              │  tower of generators: variables, jets, roots, circle or half-angle
//!                              │  functions, exponentials, logarithms, opaque atoms
//!                              └─ filter: the same conversion modulo a prime, at random points
//! ```
//! A generator is either free or bound by one relation ρⁿ = f with f in earlier generators. An
//! expression is zero if its reduced numerator is the zero polynomial; every relation used is an
//! identity of real functions, so a zero found here is a proof. Denominators are products of known
//! factors and stay factored: a test for zero needs no greatest common divisor.

mod angle;
mod arc;
mod chord;
mod common;
mod cube;
mod derivation;
mod divergence;
mod exponential;
mod factor;
mod factored;
mod filter;
mod fraction;
mod frame;
mod generator;
mod ingredients;
mod nested;
mod normalise;
mod opaque;
mod plan;
mod polygon;
mod quotient_rule;
mod raise;
mod reduction;
mod refinement;
mod root;
mod strata;
mod terms;
mod tower;
mod univariate;
mod work;

pub(crate) use arc::{arcs_occur_in, is_arc};
pub(crate) use chord::chord_bounds;
pub use common::Together;
pub use derivation::Normal;
pub use fraction::Fraction;
pub use frame::Drift;
pub use generator::{Generator, Unit};
pub use normalise::{Normalised, normalise};
pub(crate) use root::prime_powers;
pub use root::{Base, Sign, SignConstraint};
pub use terms::{Term, Terms};
pub use tower::{Obstacle, Tower, Trigonometry};
pub(crate) use univariate::{RationalFunction, Univariate};
pub(crate) use work::WORK_LIMIT;
