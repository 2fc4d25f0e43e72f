//! Measured accuracy and run time of one kernel.

use super::timing::Workshop;
use crate::kernel::generated;
use crate::theory_file::{FileError, TheoryFile};
use forms::core::accuracy::{Arithmetic, Line, Score, Variant, sheet};
use forms::core::expression::Pool;
use forms::core::generation::Generated;
use forms::core::rounding::{ErrorBound, Unbounded};
use forms::core::theory::Kernel;

/// Seed of the random arguments: reports of equal kernels are equal.
const SEED: u64 = 1;

/// Number of correct bits that a slower variant has to add to be on the Pareto front.
const STEP: f64 = 0.05;

/// Number of boxes into which the domain is split for a bound of the error.
const BOXES: usize = 256;

/// Report on one kernel in every variant.
pub(super) struct Report {
    /// File of the kernel.
    pub(super) file: String,
    /// Name of the kernel.
    pub(super) kernel: String,
    /// Lines of its documentation.
    pub(super) docs: Vec<String>,
    /// Formula, as written.
    pub(super) formula: String,
    /// Conditions of its domain.
    pub(super) domain: Vec<String>,
    /// Computed form, if it differs from the formula.
    pub(super) form: Option<String>,
    /// Bound of each output's error in `f64` for all arguments, or the reason why there is none.
    pub(super) bounds: Result<Vec<ErrorBound>, Unbounded>,
    /// Variants.
    pub(super) rows: Vec<Row>,
}

/// Result of one variant.
pub(super) struct Row {
    /// Errors of the variant.
    pub(super) line: Line,
    /// Time of one value in nanoseconds, if it was measured.
    pub(super) nanoseconds: Option<f64>,
    /// Whether the variant is on the Pareto front: no other variant is at least as fast and more
    /// accurate.
    pub(super) pareto: bool,
}

impl Row {
    /// Returns the variant.
    pub(super) fn variant(&self) -> Variant {
        self.line.variant
    }

    /// Formats the time in nanoseconds with three digits, or a dash.
    pub(super) fn time(&self) -> String {
        match self.nanoseconds {
            None => "-".to_string(),
            Some(time) if time < 10.0 => format!("{time:.2}"),
            Some(time) if time < 100.0 => format!("{time:.1}"),
            Some(time) => format!("{time:.0}"),
        }
    }

    /// Returns the mean number of correct bits of a result, given the mean number of lost bits.
    pub(super) fn correct_bits(&self, lost: f64) -> f64 {
        let mantissa = match self.variant().arithmetic {
            Arithmetic::Single => 24.0,
            Arithmetic::Double => 53.0,
            Arithmetic::DoubleDouble => 106.0,
        };
        (mantissa - lost).max(0.0)
    }

    /// Returns the mean of the lost bits, with equal weight for all regimes.
    pub(super) fn mean_loss(&self) -> f64 {
        let scores = &self.line.scores;
        scores.iter().map(|score| score.bits.mean).sum::<f64>() / scores.len().max(1) as f64
    }

    /// Returns the score of the hard regime with the largest mean loss.
    pub(super) fn hardest(&self) -> Option<&Score> {
        self.line.hard().max_by(|a, b| a.bits.mean.total_cmp(&b.bits.mean))
    }
}

/// Returns the form that the kernel specifies, or else the form from the rewriting rules.
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

    /// Summarises the kernel: the first sentence of its documentation, or its formula if it has no
    /// documentation.
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

    /// Returns the row of a variant.
    pub(super) fn row(&self, name: &str) -> Option<&Row> {
        self.rows.iter().find(|row| row.variant().name() == name)
    }

    /// Marks the Pareto front: the variants that no other beats in both time and correct bits.
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
