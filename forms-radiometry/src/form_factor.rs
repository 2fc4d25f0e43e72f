//! Form factors: of a polygon seen from a point, and of two polygons, as a sum over their edges.
//!
//! ```text
//! a point, convex pieces ─▶ point: Lambert's formula, in `f64`, or in double_double where edges cancel
//! two polygons, screens ──▶ exchange: exchange area ∫∫ cos θ₁ cos θ₂/(π r²) dA₁ dA₂, and its error
//! ```
//! *Invariant*: a result comes with a bound of its error, and its bits do not depend on the order of
//! the screens.

pub(crate) mod double_double;
mod exchange;
mod point;

pub(crate) use exchange::{
    Changes, FirstLook, Patch, exchange_of, exchange_of_disks, exchange_of_outlines, exchange_precisely,
    exchange_with, exchange_with_disk, first_look, gauss, patches,
};
pub use exchange::{Exchange, exchange, view_factor, visible_exchange};
pub(crate) use point::edge_sum;
pub use point::form_factor;
#[cfg(test)]
pub(crate) use point::form_factor_of_pieces;
