//! What was measured of one kernel.

use super::timing::Workshop;
use crate::kernel::generated;
use crate::theory_file::{FileError, TheoryFile};
use forms::core::accuracy::{Arithmetic, Line, Score, Variant, sheet};
use forms::core::expression::Pool;
use forms::core::generation::Generated;
use forms::core::rounding::{ErrorBound, Unbounded};
use forms::core::theory::Kernel;

/// The seed of the arguments: sheets of equal kernels are equal.
const SEED: u64 = 1;

/// Correct bits that a dearer variant has to add to be worth its time.
const STEP: f64 = 0.05;

/// Boxes that the domain is split into for a bound of the error.
const BOXES: usize = 256;

/// A kernel in every variant.
pub(super) struct Report {
    /// The file it stands in.
    pub(super) file: String,
    /// Its name.
    pub(super) kernel: String,
    /// The lines of its documentation.
    pub(super) docs: Vec<String>,
    /// Its formula, as it was written.
    pub(super) formula: String,
    /// Where it is defined.
    pub(super) domain: Vec<String>,
    /// The form it is computed by, where that is not the formula.
    pub(super) form: Option<String>,
    /// A bound of each output's error in `f64` that no argument exceeds, or why there is none.
    pub(super) bounds: Result<Vec<ErrorBound>, Unbounded>,
    /// The variants.
    pub(super) rows: Vec<Row>,
}

/// One variant.
pub(super) struct Row {
    /// Its errors.
    pub(super) line: Line,
    /// The time of one value in nanoseconds, where it was measured.
    pub(super) nanoseconds: Option<f64>,
    /// Whether no other variant is at least as fast and more accurate.
    pub(super) pareto: bool,
}

impl Row {
    /// The variant.
    pub(super) fn variant(&self) -> Variant {
        self.line.variant
    }

    /// The time in nanoseconds to three figures, or a dash.
    pub(super) fn time(&self) -> String {
        match self.nanoseconds {
            None => "-".to_string(),
            Some(time) if time < 10.0 => format!("{time:.2}"),
            Some(time) if time < 100.0 => format!("{time:.1}"),
            Some(time) => format!("{time:.0}"),
        }
    }

    /// The bits of a result that are right on the mean over these scores.
    pub(super) fn correct_bits(&self, lost: f64) -> f64 {
        let mantissa = match self.variant().arithmetic {
            Arithmetic::Single => 24.0,
            Arithmetic::Double => 53.0,
            Arithmetic::DoubleDouble => 106.0,
        };
        (mantissa - lost).max(0.0)
    }

    /// The mean of the bits lost over all regimes alike.
    pub(super) fn mean_loss(&self) -> f64 {
        let scores = &self.line.scores;
        scores.iter().map(|score| score.bits.mean).sum::<f64>() / scores.len().max(1) as f64
    }

    /// The hard regime in which most is lost on the mean.
    pub(super) fn hardest(&self) -> Option<&Score> {
        self.line.hard().max_by(|a, b| a.bits.mean.total_cmp(&b.bits.mean))
    }
}

/// The form that a kernel says it is computed by, or that rules gave.
fn form(pool: &Pool, kernel: &Kernel, programs: &Generated) -> Option<String> {
    let forms =
        if kernel.computed.is_empty() { programs.rewritten.clone() } else { pool.texts(&kernel.computed) };
    (!forms.is_empty()).then(|| forms.join(", "))
}

impl Report {
    pub(super) fn of(
        file: &TheoryFile,
        kernel: &Kernel,
        samples: usize,
        workshop: Option<&Workshop>,
    ) -> Result<Report, Vec<FileError>> {
        let programs = generated(file, kernel)?;
        let pool = &file.theory.pool;
        let lines = sheet(pool, kernel, &programs, samples, SEED);
        let times = workshop.and_then(|workshop| workshop.times(pool, kernel, &programs));
        let rows = lines.into_iter().map(|line| {
            let time = times.as_ref().and_then(|times| times.get(&line.variant.name()).copied());
            Row { line, nanoseconds: time, pareto: false }
        });
        let mut report = Report {
            file: file.source.name.clone(),
            kernel: kernel.name.clone(),
            docs: kernel.docs.clone(),
            formula: kernel.formula.join(", "),
            domain: kernel.domain.iter().map(|condition| condition.text(pool)).collect(),
            form: form(pool, kernel, &programs),
            bounds: programs.optimised.error_bound(BOXES),
            rows: rows.collect(),
        };
        report.mark();
        Ok(report)
    }

    /// What the kernel computes: the first sentence of its documentation, or its formula where it has none.
    pub(super) fn summary(&self) -> String {
        let paragraph: Vec<&str> =
            self.docs.iter().map(|line| line.trim()).take_while(|line| !line.is_empty()).collect();
        let text = paragraph.join(" ");
        match text.split_once(". ") {
            _ if text.is_empty() => format!("{} = {}", self.kernel, self.formula),
            Some((sentence, _)) => format!("{sentence}."),
            None => text,
        }
    }

    /// The row of a variant.
    pub(super) fn row(&self, name: &str) -> Option<&Row> {
        self.rows.iter().find(|row| row.variant().name() == name)
    }

    /// Marks the variants that no other beats in both time and correct bits.
    fn mark(&mut self) {
        let values: Vec<Option<(f64, f64)>> =
            self.rows.iter().map(|row| Some((row.nanoseconds?, row.correct_bits(row.mean_loss())))).collect();
        for (place, row) in self.rows.iter_mut().enumerate() {
            let Some((time, bits)) = values[place] else { continue };
            let beaten = values.iter().enumerate().any(|(other, value)| {
                let Some((t, b)) = *value else { return false };
                other != place && t <= time && b >= bits - STEP && (t < time || b > bits + STEP)
            });
            row.pareto = !beaten;
        }
    }
}
