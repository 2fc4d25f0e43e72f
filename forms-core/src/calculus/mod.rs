//! Exterior calculus on coordinate patches, over any ring of coefficients with partial derivatives.
//!
//! ```text
//! coefficients (structured expressions or normal forms)
//!        │
//!        ▼
//!   Form, Field ── wedge  power  exterior  interior  lie  pullback ──▶ Form, Field
//! ```
//! One definition of each operation serves both kinds of coefficients. Conventions (orientation, signs) are
//! those of `docs/conventions.md`; no operation here knows a metric.

mod blade;
mod coefficient;
mod exterior;
mod field;
mod form;
mod interior;
mod lie;
mod power;
mod pullback;
mod wedge;

pub use blade::{Blade, Coordinate, MAXIMUM_COORDINATES};
pub use coefficient::{Coefficients, Structured};
pub use exterior::exterior_derivative;
pub use field::{Field, bracket, derivative_along};
pub use form::Form;
pub use interior::{interior, pairing};
pub use lie::{lie_of_form, lie_of_scalar};
pub use power::power;
pub use pullback::{Pullback, pullback};
pub use wedge::wedge;
