//! Certificates of the prover are accepted; certificates with an error are not.

mod coverage;
mod forgeries;
mod grammar;
mod integrals;
mod metrics;
mod mutations;
mod population;
mod reading;
mod support;
mod written_by_hand;
