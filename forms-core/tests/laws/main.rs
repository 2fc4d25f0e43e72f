//! Laws of the calculus and of the prover, and mutants that each law must reject.

mod algebra;
mod angles;
mod coefficients;
mod divergences;
mod equality;
mod functions;
mod holding;
mod identities;
mod law;
mod mutants;
mod normal_forms;
mod permutations;
mod quotients;
mod reduction;
mod refinement;
mod rejecting;
mod scene;
mod traps;
mod verdicts;
mod waves;
