//! Kernels that have a value nowhere, such as √(−1 − x²), or x where x > 1 and x < 0: an error.
//!
//! A few samples find a value of nearly every other kernel, at little cost; only without one is a
//! contradiction looked for.

use crate::decide::nowhere_defined;
use crate::diagnostic::Diagnostic;
use crate::expression::Pool;
use crate::kernel::Program;
use crate::random::SplitMix;
use crate::theory::Kernel;

/// Number of samples.
const SAMPLES: usize = 64;

/// Returns the error if an output of the kernel is shown to have a value nowhere. `written` computes
/// its outputs.
pub(super) fn objection(pool: &mut Pool, kernel: &Kernel, written: &Program) -> Option<Diagnostic> {
    let unseen = without_sampled_value(written, kernel.arguments.len(), kernel.outputs.len());
    let sides: Vec<_> = kernel.outputs.iter().map(|&output| (output, output)).collect();
    let (output, reason) = unseen.into_iter().find_map(|output| {
        nowhere_defined(pool, &sides[output..=output], &kernel.domain).map(|reason| (output, reason))
    })?;
    let name = &kernel.name;
    let what = if sides.len() == 1 { format!("`{name}`") } else { format!("output {output} of `{name}`") };
    let diagnostic = Diagnostic::new(kernel.span, format!("{what} has a value nowhere: {reason}"));
    Some(diagnostic.with_help("its value would always be NaN; change the formula or its conditions"))
}

/// Returns the outputs that have no finite value at any sample.
fn without_sampled_value(written: &Program, arguments: usize, outputs: usize) -> Vec<usize> {
    let mut random = SplitMix(0);
    let mut unseen: Vec<usize> = (0..outputs).collect();
    for sample in 0..SAMPLES {
        let scale = [1.0, 4.0, 0.01, 1000.0][sample % 4];
        let point: Vec<f64> = (0..arguments).map(|_| scale * sampled(&mut random)).collect();
        let values = written.interpret(&point);
        unseen.retain(|&output| !values[output].is_finite());
        if unseen.is_empty() {
            break;
        }
    }
    unseen
}

/// Returns a number in (−½, 1).
fn sampled(random: &mut SplitMix) -> f64 {
    1.5 * (random.next() >> 11) as f64 / (1u64 << 53) as f64 - 0.5
}
