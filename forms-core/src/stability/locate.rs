//! Error localization: the operations of a form that lose bits although their operands are exact.

use crate::accuracy::{Sample, Width};
use crate::expression::{Expr, Pool, Symbol};
use crate::kernel::{KernelSource, Program, lower};
use forms_math::{Real, Wide};
use rustc_hash::FxHashMap;

/// 512-bit numbers, precise enough to measure the rounding of `f64`.
type Exact = Wide<8>;

/// Minimum loss in bits of an operation to be considered.
const LEAST_LOSS: f64 = 0.4;

/// Returns the operations of a form that lose bits at these samples, in order of decreasing loss,
/// followed by the operations that use their results.
pub(super) fn lossy(
    pool: &Pool,
    arguments: &[Symbol],
    form: &[Expr],
    samples: &[&Sample],
    most: usize,
) -> Vec<Expr> {
    let nodes = pool.reachable(form);
    let source =
        KernelSource { arguments: arguments.to_vec(), outputs: nodes.clone(), ..KernelSource::default() };
    let Ok(program) = lower(pool, &source) else { return Vec::new() };
    // several nodes can become one instruction, such as those of a minimum
    let losses = losses(&program, samples);
    let losses: Vec<f64> = program.outputs().iter().map(|value| losses[value.place()]).collect();
    let mut ranked: Vec<usize> = (0..nodes.len()).filter(|&place| losses[place] >= LEAST_LOSS).collect();
    ranked.sort_by(|&a, &b| losses[b].total_cmp(&losses[a]));
    ranked.truncate(most);
    let mut found: Vec<Expr> = ranked.into_iter().map(|place| nodes[place]).collect();
    // a cancellation often disappears only if the operation that uses its result is rewritten as
    // well
    let users = users(pool, &nodes);
    for _ in 0..2 {
        for place in 0..found.len() {
            for &user in users.get(&found[place]).into_iter().flatten() {
                if !found.contains(&user) {
                    found.push(user);
                }
            }
        }
    }
    found
}

fn users(pool: &Pool, nodes: &[Expr]) -> FxHashMap<Expr, Vec<Expr>> {
    let mut users: FxHashMap<Expr, Vec<Expr>> = FxHashMap::default();
    for &node in nodes {
        pool.node(node).for_each_operand(|operand| users.entry(operand).or_default().push(node));
    }
    users
}

/// Returns the mean number of bits that each instruction loses when its operands are the exact
/// values rounded to nearest.
fn losses(program: &Program, samples: &[&Sample]) -> Vec<f64> {
    let mut losses = vec![0.0; program.instructions().len()];
    let interpreter = program.interpreter::<Exact>();
    for sample in samples {
        let arguments: Vec<Exact> = sample.arguments.iter().map(|&value| Exact::from_f64(value)).collect();
        let exact: Vec<f64> = interpreter.steps(&arguments).into_iter().map(Real::to_f64).collect();
        for (place, loss) in losses.iter_mut().enumerate() {
            let computed = program.step(place, &sample.arguments, &exact);
            if !exact[place].is_nan() {
                *loss += Width::Double.bits_between(computed, exact[place]);
            }
        }
    }
    losses.iter().map(|loss| loss / samples.len().max(1) as f64).collect()
}
