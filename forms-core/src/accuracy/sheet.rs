//! Accuracy sheets: the errors of each arithmetic and each form of a kernel, on typical arguments
//! and in each hard regime.

use super::ordinal::Width;
use super::regime::Regime;
use super::sample::{Samples, sample};
use super::score::Score;
use crate::expression::Pool;
use crate::generation::Generated;
use crate::kernel::Program;
use crate::theory::Kernel;
use forms_math::{DoubleDouble, Lane32, Lane64, Real};

/// One way to run a kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Variant {
    /// The arithmetic.
    pub arithmetic: Arithmetic,
    /// Whether the stable form is computed, and not the formula as written.
    pub stable: bool,
    /// Whether whole columns are computed in the lanes of vectors.
    pub batch: bool,
}

/// The arithmetic in which a kernel is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Arithmetic {
    /// `f32`
    Single,
    /// `f64`
    Double,
    /// The sum of two `f64`s, about 31 digits.
    DoubleDouble,
}

impl Variant {
    /// All variants. Double-double arithmetic has no lanes, and is worth its time only for the
    /// stable form.
    pub const ALL: [Variant; 9] = {
        const fn of(arithmetic: Arithmetic, stable: bool, batch: bool) -> Variant {
            Variant { arithmetic, stable, batch }
        }
        [
            of(Arithmetic::Single, false, false),
            of(Arithmetic::Single, true, false),
            of(Arithmetic::Double, false, false),
            of(Arithmetic::Double, true, false),
            of(Arithmetic::DoubleDouble, true, false),
            of(Arithmetic::Single, false, true),
            of(Arithmetic::Single, true, true),
            of(Arithmetic::Double, false, true),
            of(Arithmetic::Double, true, true),
        ]
    };

    /// Returns the name of the variant, such as `f64 stable batch`.
    pub fn name(self) -> String {
        let mut name = match self.arithmetic {
            Arithmetic::Single => "f32",
            Arithmetic::Double => "f64",
            Arithmetic::DoubleDouble => "dd",
        }
        .to_string();
        if self.stable && self.arithmetic != Arithmetic::DoubleDouble {
            name.push_str(" stable");
        }
        if self.batch {
            name.push_str(" batch");
        }
        name
    }

    /// Returns the width of the arguments.
    pub fn width(self) -> Width {
        if self.arithmetic == Arithmetic::Single { Width::Single } else { Width::Double }
    }
}

/// The errors of one variant.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The variant.
    pub variant: Variant,
    /// Its errors in each regime, the typical one first.
    pub scores: Vec<Score>,
}

impl Line {
    /// Returns the scores of all regimes except the typical one.
    pub fn hard(&self) -> impl Iterator<Item = &Score> {
        self.scores.iter().filter(|score| score.regime != Regime::Typical)
    }

    /// Returns the score on typical arguments.
    pub fn typical(&self) -> Option<&Score> {
        self.scores.iter().find(|score| score.regime == Regime::Typical)
    }
}

/// Returns the errors of a kernel in every variant, with `count` samples of each regime.
pub fn sheet(pool: &Pool, kernel: &Kernel, generated: &Generated, count: usize, seed: u64) -> Vec<Line> {
    let samples = |width| sample(pool, kernel, width, &Regime::ALL, count, seed);
    let (single, double) = (samples(Width::Single), samples(Width::Double));
    let line = |variant: Variant| {
        let is_wide = variant.arithmetic == Arithmetic::DoubleDouble;
        let (program, within) = match (variant.stable, is_wide) {
            (false, _) => (&generated.written, None),
            (true, true) => (generated.exact(), generated.promise),
            (true, false) if variant.width() == Width::Single => (generated.single(), None),
            (true, false) => (&generated.optimised, generated.within()),
        };
        let samples = if variant.width() == Width::Single { &single } else { &double };
        Line { variant, scores: scores(program, within, variant, samples) }
    };
    Variant::ALL.into_iter().map(line).collect()
}

fn scores(program: &Program, within: Option<f64>, variant: Variant, samples: &[Samples]) -> Vec<Score> {
    let width = variant.width();
    let by = |computed: &dyn Fn(&[f64]) -> Vec<f64>| -> Vec<Score> {
        samples.iter().map(|regime| Score::of(regime, width, computed)).collect()
    };
    let single = program.interpreter::<f32>();
    let double = program.interpreter::<f64>();
    let in_single = |arguments: &[f64]| converted(arguments, |arguments: &[f32]| single.values(arguments));
    let in_double = |arguments: &[f64]| match within {
        // the promised accuracy is kept by as much precision as it needs
        Some(within) => program.interpret_within(arguments, within),
        None => double.values(arguments),
    };
    match (variant.arithmetic, variant.batch) {
        (Arithmetic::Single, false) => by(&in_single),
        (Arithmetic::Double, false) => by(&in_double),
        (Arithmetic::Single, true) => {
            let lanes = program.interpreter::<Lane32<true>>();
            let in_lanes = |arguments: &[f64]| converted(arguments, |a: &[Lane32<true>]| lanes.values(a));
            by(&|arguments| without_nan(in_lanes(arguments), || in_single(arguments)))
        }
        (Arithmetic::Double, true) => {
            let lanes = program.interpreter::<Lane64<true>>();
            let in_lanes = |arguments: &[f64]| converted(arguments, |a: &[Lane64<true>]| lanes.values(a));
            match within {
                Some(within) => by(&|arguments| program.interpret_row_within(arguments, within)),
                None => by(&|arguments| without_nan(in_lanes(arguments), || in_double(arguments))),
            }
        }
        (Arithmetic::DoubleDouble, _) => double_double_scores(program, within.is_some(), samples),
    }
}

/// Returns the scores of plain double-double arithmetic or, for a kernel with a promised accuracy,
/// of its own double-double evaluation.
fn double_double_scores(program: &Program, promised: bool, samples: &[Samples]) -> Vec<Score> {
    let wide = program.interpreter::<DoubleDouble>();
    let computed = |arguments: &[f64]| {
        let arguments: Vec<DoubleDouble> = arguments.iter().map(|&x| DoubleDouble::from_f64(x)).collect();
        let values = if promised {
            program.interpret_double_double(&arguments).into_iter().map(|(value, _)| value).collect()
        } else {
            wide.values(&arguments)
        };
        values.into_iter().map(|value| (value.high(), value.low())).collect()
    };
    samples.iter().map(|regime| Score::of_double_double(regime, computed)).collect()
}

/// Returns the results of another arithmetic at the same arguments.
fn converted<T: Real>(arguments: &[f64], compute: impl Fn(&[T]) -> Vec<T>) -> Vec<f64> {
    let arguments: Vec<T> = arguments.iter().map(|&value| T::from_f64(value)).collect();
    compute(&arguments).into_iter().map(T::to_f64).collect()
}

/// Applies the rule of batches: a row whose lanes gave up is computed again with single numbers.
fn without_nan(lanes: Vec<f64>, single: impl Fn() -> Vec<f64>) -> Vec<f64> {
    if lanes.iter().any(|value| value.is_nan()) { single() } else { lanes }
}
