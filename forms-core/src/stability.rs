//! Stability: equal forms of a kernel, of which those that lose the fewest bits are kept.
//!
//! ```text
//! formula ─ locate ─▶ operations that lose bits ─ rules ─▶ forms ─ score ─▶ the best few ─┐
//!              ▲                                                                         │
//!              └─────────────────────────────── again ───────────────────────────────────┤
//!                                            regimes, proof ─▶ forms by error and cost ◀─┘
//! ```
//! The rules propose, exact algebra proves: a form is kept only if it is proved to have the value of the formula
//! wherever the formula has one, on the kernel's domain; where it is not shown to have one, the formula takes its
//! place. Where no form is best everywhere, two are joined at a number where the bounds of their errors cross at
//! every scale. What is kept is compared with the formula at points that the search has not seen, and goes if it
//! loses more there. The search is bounded, and the same for the same kernel. A kernel that nobody chose a form for
//! is computed by what rules alone give, without a search.

mod choice;
mod crossing;
mod locate;
mod proof;
mod regimes;
mod rules;
mod search;
mod validation;

pub use choice::{Choices, EXTENSION, key, written};
pub(crate) use rules::by_rules;
pub use search::{Effort, Form, Found, search};
