//! Helpers of the tests, examples and benches of `forms-radiometry`: scenes with known answers, and
//! runs that are compared, timed or counted.
//!
//! ```text
//! claims · known_answers · reference_rows ─▶ scenes, each with the values of its answers
//! gallery ─▶ timed_run, effects_code ─▶ times, instructions          benches ─▶ tables of a page
//! ```
//! The unit tests of `forms-radiometry` cannot use this crate, because they are part of another
//! build of `forms-radiometry`; they use `forms-testing`.

pub mod benches;
pub mod claims;
pub mod effects_code;
pub mod gallery;
pub mod known_answers;
pub mod reference_rows;
pub mod timed_run;
