//! The table of error budgets: a row for each scene.

use super::measured::Measured;
use forms_radiometry::simulation::{ErrorKind, ErrorParts};
use forms_radiometry_testing::gallery::Problem;

pub(crate) const HEAD: &str = "| scene | worst answer | value | error | rounding | quadrature | \
                               truncated orders | omitted effects | sampling | \
                               time | cheapest way to halve the error |\n\
                               |---|---|---|---|---|---|---|---|---|---|---|\n";

/// Returns the row of a scene.
pub(crate) fn row(measured: &Measured) -> Result<String, Problem> {
    let worst = measured.worst()?;
    let parts: Vec<String> = worst.parts.all().into_iter().map(part).collect();
    let band = worst.band.map_or(String::new(), |band| format!(", band {band}"));
    let bin = worst.bin.map_or(String::new(), |bin| format!(", bin {bin}"));
    let meaning = if worst.kind == ErrorKind::Sigma { " (1 σ)" } else { "" };
    Ok(format!(
        "| {} | {}, {}{band}{bin} | {:.4e} {} | {:.1e}{meaning} | {} | {:.2e} s | {} |\n",
        measured.name,
        worst.receiver,
        worst.quantity.name(),
        worst.value,
        worst.unit(),
        worst.error,
        parts.join(" | "),
        measured.planned.seconds,
        half(measured, &worst.parts),
    ))
}

fn part(part: f64) -> String {
    if part == 0.0 { "0".to_owned() } else { format!("{part:.1e}") }
}

/// Returns the fastest way to halve the error, and its cost.
fn half(measured: &Measured, parts: &ErrorParts) -> String {
    if let Some(halved) = measured.cheapest() {
        return format!("{}: {:.2e} s", halved.what, halved.seconds);
    }
    let tried = measured.halved.iter().min_by(|one, other| one.error.total_cmp(&other.error));
    match tried {
        Some(tried) => {
            let left = tried.error / measured.planned.error();
            format!("none: {} leaves {left:.2} of the error, in {:.2e} s", tried.what, tried.seconds)
        }
        None if parts.rounding > 0.0 => "none: the error is rounding".to_owned(),
        None => "none".to_owned(),
    }
}
