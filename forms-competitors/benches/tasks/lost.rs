//! Bits lost by each function of a task, at typical and hard arguments of the whole domain.

use crate::task::{Author, Task};
use forms_core::accuracy::{Regime, Samples, Score, Statistics, Width, sample};
use forms_core::check::read_theory;
use forms_core::stability::Choices;
use std::sync::LazyLock;

/// Number of samples of each regime, and their seed.
const SAMPLES: usize = 64;
const SEED: u64 = 5;

const FORMULAS: &str = include_str!("../../../tests/stability/applied.forms");
const FORMS: &str = include_str!("../../../tests/stability/applied.stable");

/// Accuracy of a task.
pub(crate) struct Lost {
    /// Bits lost as written, by the expert and generated: the mean over all samples, and the largest.
    pub(crate) bits: [Statistics; 3],
    /// The promise that more precision keeps, in units of 2⁻⁵³.
    pub(crate) within: Option<String>,
}

/// Functions whose accuracy is shown.
pub(crate) const SHOWN: [Author; 3] = [Author::AsWritten, Author::Expert, Author::Generated];

/// Samples of the kernel, and its promise.
type Known = (String, Vec<Samples>, Option<String>);

static KNOWN: LazyLock<Vec<Known>> = LazyLock::new(|| {
    let (mut theory, errors) = read_theory(FORMULAS);
    assert!(errors.is_empty(), "{errors:?}");
    let written = theory.kernels.clone();
    Choices::read(FORMS).expect("a file of forms").apply(&mut theory);
    let kernels = written.iter().zip(&theory.kernels);
    let known = kernels.map(|(kernel, chosen)| {
        let samples = sample(&theory.pool, kernel, Width::Double, &Regime::ALL, SAMPLES, SEED);
        (kernel.name.clone(), samples, chosen.within.as_ref().map(ToString::to_string))
    });
    known.collect()
});

/// Returns the bits lost by the functions of a task.
pub(crate) fn by_each(task: &Task) -> Lost {
    let (_, samples, within) = KNOWN.iter().find(|known| known.0 == task.name).expect("a kernel of the file");
    let bits = SHOWN.map(|author| {
        let function = task.by(author);
        let value = |arguments: &[f64]| {
            let columns: Vec<&[f64]> = arguments.chunks(1).collect();
            let mut out = [0.0];
            function(&columns, &mut out);
            out.to_vec()
        };
        let scores: Vec<Score> =
            samples.iter().map(|regime| Score::of(regime, Width::Double, value)).collect();
        let points: usize = scores.iter().map(|score| score.points).sum();
        let sum: f64 = scores.iter().map(|score| score.bits.mean * score.points as f64).sum();
        Statistics {
            mean: sum / points as f64,
            maximum: scores.iter().map(|score| score.bits.maximum).fold(0.0, f64::max),
            ..Statistics::default()
        }
    });
    Lost { bits, within: within.clone() }
}
