//! Approximations: expressions that are not equal to a formula but proved to be close to it, relative
//! to its value.
//!
//! ```text
//! form, formula, conditions ─ common parts ─▶ parts that differ ─ one variable ─▶ |E| ≤ ε|M| on a range ─▶ proved, or not
//! formula ─ expansion at a removable singularity ─▶ a polynomial with this property, and its range
//! ```
//! A part P/Q of the form is within ε of a part N/D of the formula if E = P D − N Q satisfies
//! |E| ≤ ε |N Q|. This is shown with Taylor expansions of E and M = N Q on a subdivided range; where M
//! has a zero, its power is taken out of both, so that removable singularities are no obstacle.
//! Nothing is sampled: a positive answer is a proof.

mod claim;
mod fraction;
mod one_variable;
mod quantity;
mod series;

pub(crate) use claim::is_within;
pub(crate) use series::about_singularities;
