//! Stability: equal forms of a kernel, and the selection of the most accurate ones.
//!
//! ```text
//! formula ─ locate ─▶ operations that lose bits ─ rules ─▶ forms ─ score ─▶ the best few ─┐
//!              ▲                                                                         │
//!              └────────────────────────────── repeat ───────────────────────────────────┤
//!                                            regimes, proof ─▶ forms by error and cost ◀─┘
//! ```
//! The rewriting rules propose, exact algebra proves: a form is kept only if it is proved to have
//! the value of the formula wherever the formula is defined, on the kernel's domain. Where the form
//! is not proved to have a value, the formula is used instead. Where no form is best everywhere,
//! two are joined at a number where their error bounds cross at every scale. The result is compared
//! with the formula at points that the search has not seen, and is rejected if it loses more there.
//! The search is bounded and deterministic. A kernel for which no form was chosen is computed by
//! the result of the rules alone, without a search.

mod bounds;
mod budget;
mod choice;
mod crossing;
mod form;
mod locate;
mod proof;
mod regimes;
mod rules;
mod search;
mod validation;

pub use budget::Budget;
#[cfg(feature = "internals")]
pub use choice::key;
#[cfg(not(feature = "internals"))]
pub(crate) use choice::key;
pub use choice::{Choices, EXTENSION, written};
#[cfg(feature = "internals")]
pub use form::Form;
#[cfg(not(feature = "internals"))]
pub(crate) use form::Form;
pub use form::Found;
pub(crate) use rules::by_rules;
pub use search::search;
