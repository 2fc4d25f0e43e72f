//! Certificates of the prover are accepted; those with a mistake are not.

mod coverage;
mod forgeries;
mod integrals;
mod metrics;
mod mutations;
mod support;
mod written_by_hand;
