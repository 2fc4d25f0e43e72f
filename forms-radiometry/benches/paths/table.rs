//! The tables: works by rows and programs by columns, the settings with which each program reached
//! its error, and errors against numbers of samples.

use crate::convergence;
use crate::measure::Measured;
use forms_radiometry_testing::benches::cells::{heads, ratio, row, shown, time};
use forms_radiometry_testing::benches::scripts::Line;
use forms_testing::page::processor;

/// Returns all tables in Markdown, after the name of the processor.
pub(crate) fn markdown(
    measured: &[Measured<'_>],
    others: &[Line],
    series: &[convergence::Measured],
) -> String {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut text = format!("Processor: {}, {threads} threads.\n\n", processor());
    for part in [of_goals(measured, others), of_remarks(measured, others), of_series(series)] {
        text += &part;
    }
    text
}

const HEADS: [&str; 9] = [
    "work",
    "target error",
    "Forms",
    "Forms error",
    "Mitsuba, default",
    "Mitsuba / Forms",
    "Mitsuba, best",
    "Mitsuba, best / Forms",
    "goal",
];

fn of_goals(measured: &[Measured<'_>], others: &[Line]) -> String {
    let mut text = String::new();
    heads(&mut text, &HEADS);
    for Measured { work, seconds, error, .. } in measured {
        let mitsuba = || others.iter().filter(|line| line.work == work.name);
        let default = mitsuba().find(|line| line.program.ends_with("(independent)"));
        let best = mitsuba().min_by(|a, b| a.seconds.total_cmp(&b.seconds));
        let cells = [
            work.title.to_string(),
            format!("{:e}", work.target),
            shown(*seconds),
            // a work that needs no samples can have an error of exactly zero
            if *error == 0.0 { "rounding".to_string() } else { format!("{error:.0e}") },
            time(default),
            ratio(default, *seconds),
            time(best),
            ratio(best, *seconds),
            work.goal.map_or_else(|| "–".to_string(), |goal| goal.to_string()),
        ];
        row(&mut text, &cells);
    }
    text + "\n"
}

/// Returns the settings with which all programs reached their errors.
fn of_remarks(measured: &[Measured<'_>], others: &[Line]) -> String {
    let mut text = String::new();
    heads(&mut text, &["work", "program", "time", "error", ""]);
    for Measured { work, seconds, error, how } in measured {
        let mut line = |program: &str, seconds: f64, error: f64, remark: &str| {
            let [work, program, remark] = [work.title, program, remark].map(str::to_string);
            row(&mut text, &[work, program, shown(seconds), format!("{error:.0e}"), remark]);
        };
        line("Forms", *seconds, *error, how);
        for other in others.iter().filter(|other| other.work == work.name) {
            line(&other.program, other.seconds, other.error, &other.remark);
        }
    }
    text + "\n"
}

/// Returns the errors of all series, with one number of samples per row.
fn of_series(series: &[convergence::Measured]) -> String {
    if series.is_empty() {
        return String::new();
    }
    let mut powers: Vec<u32> =
        series.iter().flat_map(|series| &series.errors).map(|(power, ..)| *power).collect();
    powers.sort_unstable();
    powers.dedup();
    let mut text = String::new();
    heads(
        &mut text,
        &[&["samples"], &series.iter().map(|series| series.title).collect::<Vec<_>>()[..]].concat(),
    );
    for power in powers {
        let cell = |series: &convergence::Measured| {
            let found = series.errors.iter().find(|(other, ..)| *other == power);
            found.map_or_else(String::new, |(_, seeds, error)| format!("{error:.1e} ({seeds})"))
        };
        let cells: Vec<String> = [format!("2^{power}")].into_iter().chain(series.iter().map(cell)).collect();
        row(&mut text, &cells);
    }
    text
}
