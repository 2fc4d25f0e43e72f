//! Exterior calculus on coordinate patches, over any ring of coefficients with partial derivatives.
//!
//! ```text
//! coefficients (structured expressions or normal forms)
//!        │
//!        ▼
//!   Form, Field ── wedge  power  exterior  interior  lie  pullback ──▶ Form, Field
//!   Metric ─────── hodge  musical  gradient ────────────────────────────▶ Form, Field
//! ```
//! Each operation has one definition for both kinds of coefficients. The conventions (orientation,
//! signs) are listed in `docs/conventions.md`; only `metric`, `hodge`, `musical` and `gradient`
//! depend on lengths.

mod blade;
mod coefficient;
mod exterior;
mod field;
mod form;
mod gradient;
mod hodge;
mod interior;
mod lie;
mod metric;
mod musical;
mod power;
mod pullback;
mod wedge;

pub use blade::{Blade, Coordinate, MAXIMUM_COORDINATES};
pub use coefficient::{Coefficients, Product, Quotients, Structured};
pub use exterior::{Contribution, contributions, exterior_derivative};
pub use field::{Field, bracket, derivative_along};
pub use form::Form;
pub use gradient::{curl, divergence, gradient};
pub use hodge::{codifferential, hodge, laplacian, volume};
pub use interior::{interior, pairing};
pub use lie::{lie_of_form, lie_of_scalar};
pub use metric::Metric;
pub use musical::{flat, inner_of_fields, inner_of_forms, sharp};
pub use power::power;
pub use pullback::{Pullback, pullback};
pub use wedge::wedge;
