//! Decisions: the statements of files and the claims of their kernels, decided on all processors
//! and passed on in the order of the files.
//!
//! ```text
//! names ─ a task each: read ─▶ TheoryFile ─ a task for some statements each: decide ─▶ DecidedFile ─ in order ─▶ visit
//! ```
//! Deciding adds to the pool of a theory, so each task has its own copy of the theory. The division
//! into tasks does not depend on the number of processors: the same input gives the same output on
//! every machine.

use crate::STACK_BYTES;
use crate::theory_file::{self, FileError, TheoryFile};
use crate::verdict_line::Decided;
use forms::core::decide::decide_with_effort;
use forms::core::expression::Pool;
use forms::core::generation::{Fault, faults, makes_claims};
use forms::core::syntax::Source;
use forms::core::theory::{Kernel, Statement, Theory};
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::collections::BTreeMap;
use std::io;
use std::sync::mpsc;
use std::time::{Duration, Instant};

/// Number of statements per task: on average at least ten times the work of copying their theory.
const TASK: usize = 16;

/// Number of kernels with claims per task.
const KERNELS_OF_A_TASK: usize = 4;

/// File without errors, with its decided statements.
pub(crate) struct DecidedFile {
    pub(crate) source: Source,
    pub(crate) theory: Theory,
    pub(crate) statements: Vec<Decided>,
    /// Claims of its kernels that were not proved.
    pub(crate) faults: Vec<DecidedFault>,
}

/// Claim of a kernel that is false or undecided.
pub(crate) struct DecidedFault {
    pub(crate) fault: Fault,
    pub(crate) time: Duration,
}

/// Result for a file: its errors if there are any.
pub(crate) type Outcome = Result<DecidedFile, Vec<FileError>>;

/// Reads files and decides their statements with a multiple of the default work limit. The outcomes
/// are visited in order, each as soon as the outcomes before it have been visited.
pub(crate) fn for_each_file(
    names: &[String],
    budget: u32,
    mut visit: impl FnMut(Outcome) -> io::Result<()>,
) -> io::Result<()> {
    // A file with no more statements than one task holds does not need a thread pool.
    if let [name] = names {
        let file = theory_file::read(name);
        if file.as_ref().map_or(0, |file| file.theory.statements.len()) <= TASK
            && file.as_ref().map_or(0, |file| file.theory.kernels.len()) <= KERNELS_OF_A_TASK
        {
            return visit(file.map(|file| decided_file(file, budget)));
        }
        let pool = workers()?;
        return visit(file.map(|file| pool.install(|| decided_file(file, budget))));
    }
    let pool = workers()?;
    pool.in_place_scope(|scope| {
        let (sender, receiver) = mpsc::channel();
        for (place, name) in names.iter().enumerate() {
            let sender = sender.clone();
            scope.spawn(move |_| {
                // The receiver is gone if the reader of the output has gone away.
                let _ = sender.send((place, theory_file::read(name).map(|file| decided_file(file, budget))));
            });
        }
        drop(sender);
        let mut waiting = BTreeMap::new();
        let mut next = 0;
        for (place, outcome) in receiver {
            waiting.insert(place, outcome);
            while let Some(outcome) = waiting.remove(&next) {
                visit(outcome)?;
                next += 1;
            }
        }
        Ok(())
    })
}

/// Creates a thread for each processor, or the number of threads in `RAYON_NUM_THREADS`.
pub(crate) fn workers() -> io::Result<ThreadPool> {
    ThreadPoolBuilder::new().stack_size(STACK_BYTES).build().map_err(io::Error::other)
}

fn decided_file(file: TheoryFile, budget: u32) -> DecidedFile {
    let TheoryFile { source, mut theory, .. } = file;
    let statements = decide_all(&mut theory, budget);
    let faults = faults_of_kernels(&mut theory);
    DecidedFile { source, theory, statements, faults }
}

/// Returns the claims of the kernels of one theory that were not proved, in order.
pub(crate) fn faults_of_kernels(theory: &mut Theory) -> Vec<DecidedFault> {
    let kernels: Vec<Kernel> =
        theory.kernels.iter().filter(|kernel| makes_claims(&theory.pool, kernel)).cloned().collect();
    if kernels.len() <= KERNELS_OF_A_TASK {
        return kernels.iter().flat_map(|kernel| faults_of(&mut theory.pool, kernel)).collect();
    }
    let pool = &theory.pool;
    let tasks = kernels.par_chunks(KERNELS_OF_A_TASK).flat_map_iter(|task| {
        let mut pool = pool.clone();
        task.iter().flat_map(move |kernel| faults_of(&mut pool, kernel))
    });
    tasks.collect()
}

fn faults_of(pool: &mut Pool, kernel: &Kernel) -> Vec<DecidedFault> {
    let start = Instant::now();
    let found = faults(pool, kernel);
    let time = start.elapsed();
    found.into_iter().map(|fault| DecidedFault { fault, time }).collect()
}

/// Decides the statements of one theory, in order.
fn decide_all(theory: &mut Theory, budget: u32) -> Vec<Decided> {
    let statements = theory.statements.clone();
    if statements.len() <= TASK {
        return statements.into_iter().map(|statement| timed(theory, statement, budget)).collect();
    }
    let theory = &*theory;
    let tasks = statements.par_chunks(TASK).flat_map_iter(|task| {
        let mut theory = theory.clone();
        task.iter().map(move |statement| timed(&mut theory, statement.clone(), budget))
    });
    tasks.collect()
}

/// Decides one statement with a multiple of the default work limit, and measures the time.
pub(crate) fn timed(theory: &mut Theory, statement: Statement, budget: u32) -> Decided {
    let start = Instant::now();
    let verdict = decide_with_effort(theory, &statement, budget);
    Decided { statement, verdict, time: start.elapsed() }
}
