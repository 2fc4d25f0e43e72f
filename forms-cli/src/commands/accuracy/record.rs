//! The report as JSON: one object per kernel.

use super::report::{Report, Row};
use crate::json::write_record;
use forms::core::accuracy::{Score, Statistics};
use forms::core::rounding::ErrorBound;
use std::io::{self, Write};

#[derive(serde::Serialize)]
struct KernelRecord<'a> {
    file: &'a str,
    name: &'a str,
    domain: &'a [String],
    stable_form: Option<&'a str>,
    bounds: Option<Vec<BoundRecord>>,
    unbounded: Option<String>,
    variants: Vec<VariantRecord>,
}

/// Bound of the error of an output in `f64`, valid on the whole domain: absolute, and relative to
/// the value in units of 2⁻⁵³ if the value is bounded away from 0.
#[derive(serde::Serialize)]
struct BoundRecord {
    absolute: f64,
    units: Option<f64>,
}

#[derive(serde::Serialize)]
struct VariantRecord {
    variant: String,
    nanoseconds: Option<f64>,
    pareto: bool,
    regimes: Vec<RegimeRecord>,
}

#[derive(serde::Serialize)]
struct RegimeRecord {
    regime: &'static str,
    points: usize,
    bits: StatisticsRecord,
    ulps: StatisticsRecord,
    worst: Vec<f64>,
}

/// Statistics of an error; an infinite error, of a NaN result, is null.
#[derive(serde::Serialize)]
struct StatisticsRecord {
    mean: Option<f64>,
    percentile_99: Option<f64>,
    maximum: Option<f64>,
}

/// Writes the record of one kernel.
pub(super) fn write(report: &Report, output: &mut dyn Write) -> io::Result<()> {
    let record = KernelRecord {
        file: &report.file,
        name: &report.kernel,
        domain: &report.domain,
        stable_form: report.form.as_deref(),
        bounds: report.bounds.as_ref().ok().map(|bounds| bounds.iter().map(bound).collect()),
        unbounded: report.bounds.as_ref().err().map(ToString::to_string),
        variants: report.rows.iter().map(variant).collect(),
    };
    write_record(output, &record)
}

fn bound(bound: &ErrorBound) -> BoundRecord {
    BoundRecord { absolute: bound.absolute, units: bound.units() }
}

fn variant(row: &Row) -> VariantRecord {
    VariantRecord {
        variant: row.variant().name(),
        nanoseconds: row.nanoseconds,
        pareto: row.pareto,
        regimes: row.line.scores.iter().map(regime).collect(),
    }
}

fn regime(score: &Score) -> RegimeRecord {
    RegimeRecord {
        regime: score.regime.name(),
        points: score.points,
        bits: statistics(&score.bits),
        ulps: statistics(&score.ulps),
        worst: score.worst.clone(),
    }
}

fn statistics(known: &Statistics) -> StatisticsRecord {
    let finite = |value: f64| Some(value).filter(|value| value.is_finite());
    StatisticsRecord {
        mean: finite(known.mean),
        percentile_99: finite(known.percentile),
        maximum: finite(known.maximum),
    }
}
