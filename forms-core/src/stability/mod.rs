//! Stability: equal forms of a kernel, of which those that lose the fewest bits are kept.
//!
//! ```text
//! formula ─ locate ─▶ operations that lose bits ─ rules ─▶ forms ─ score ─▶ the best few ─┐
//!              ▲                                                                         │
//!              └─────────────────────────────── again ───────────────────────────────────┤
//!                                            regimes, proof ─▶ forms by error and cost ◀─┘
//! ```
//! The rules propose, exact algebra proves: a form is kept only if it is proved equal to the formula on the kernel's
//! domain. Where no form is best everywhere, two are joined at an exact seam. The search is bounded, and the same for
//! the same kernel. A kernel that nobody chose a form for is computed by what rules alone give, without a search.

mod choice;
mod locate;
mod proof;
mod regimes;
mod rules;
mod search;

pub use choice::{Choices, EXTENSION, key, written};
pub use rules::by_rules;
pub use search::{Effort, Form, Found, search};
