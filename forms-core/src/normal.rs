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
mod arithmetic;
mod base;
mod charges;
mod chord;
mod common;
mod cube;
mod denominators;
mod derivation;
mod divergence;
mod drift;
mod exclusions;
mod exponential;
mod factor;
mod factored;
mod filter;
mod fraction;
mod frame;
mod generator;
mod generators;
mod ingredients;
mod known_factors;
mod nested;
mod norm;
mod normalise;
mod obstacle;
mod opaque;
mod plan;
mod polygon;
mod power;
mod quotient_rule;
mod raise;
mod reduction;
mod refinement;
mod root;
mod sign_requests;
mod strata;
mod terms;
mod tower;
mod univariate;
mod work;

pub(crate) use arc::{arcs_occur_in, is_arc};
pub use base::{Base, Sign, SignConstraint};
pub(crate) use chord::chord_bounds;
pub use common::Together;
pub use derivation::Normal;
pub use drift::Drift;
pub use fraction::Fraction;
pub use generator::Trigonometry;
pub use generator::{Generator, Unit};
pub use normalise::{Normalised, normalise};
pub use obstacle::{Obstacle, OutsidePart, SizeLimit};
pub(crate) use root::prime_powers;
pub use terms::{Term, Terms};
pub use tower::Tower;
pub(crate) use univariate::{RationalFunction, Univariate};
pub(crate) use work::WORK_LIMIT;
