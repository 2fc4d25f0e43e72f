//! Observation of proofs: the steps of a proof as they are made, for a certificate.

use crate::assume::Facts;
use crate::expression::{Expr, Pool};
use crate::normal::{Sign, Tower};

/// Receiver of the steps of a proof.
pub(crate) trait Observer {
    /// The differences, which are expressions of this pool, are zero in this case.
    fn zero(&mut self, pool: &Pool, tower: &Tower, differences: &[Expr]);
    /// In this case a side divides by zero everywhere.
    fn undefined(&mut self);
    /// The proof continues by cases; `factors` are the factors on which they rest, first those
    /// whose signs distinguish the cases.
    fn split(&mut self, tower: &Tower, factors: &[usize], facts: &Facts, cases: &[Vec<(usize, Sign)>]);
    /// One of the cases begins.
    fn case(&mut self, signs: &[(usize, Sign)]);
    /// All cases of the last split are complete.
    fn end(&mut self);
}
