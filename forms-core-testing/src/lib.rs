//! Workloads of the calculus and the prover, for the bench and the example that time them.

pub mod workload;
