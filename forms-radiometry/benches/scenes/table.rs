//! The tables: works by rows and programs by columns, and the ratios for which goals are set.

use crate::{squares, work};
use forms_radiometry_testing::benches::cells::{heads, ratio, row, shown, time};
use forms_radiometry_testing::benches::scripts::Line;
use forms_testing::page::processor;

/// Returns both tables in Markdown, after the name of the processor.
pub(crate) fn markdown(maps: &[work::Measured], factors: &squares::Measured, others: &[Line]) -> String {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut text = format!("Processor: {}, {threads} threads.\n\n", processor());
    for part in [of_maps(maps, others), of_remarks(maps, others), of_factors(factors, others)] {
        text += &part;
    }
    text
}

const HEADS: [&str; 11] = [
    "work",
    "target error",
    "Forms",
    "Forms error",
    "Forms tolerance",
    "numpy",
    "numpy / Forms",
    "Mitsuba, default sampler",
    "Mitsuba / Forms",
    "Mitsuba, best sampler / Forms",
    "goal",
];

fn of_maps(maps: &[work::Measured], others: &[Line]) -> String {
    let mut text = String::new();
    heads(&mut text, &HEADS);
    for measured in maps {
        let by = |program: &str| {
            let is_meant =
                |line: &&Line| line.work == measured.work.name && line.program.starts_with(program);
            others.iter().filter(is_meant).collect::<Vec<_>>()
        };
        let (numpy, mitsuba) = (by("numpy"), by("Mitsuba"));
        let best = mitsuba.iter().copied().min_by(|a, b| a.seconds.total_cmp(&b.seconds));
        let default = mitsuba.iter().copied().find(|line| line.program.ends_with("(independent)"));
        let cells = [
            measured.work.title.to_string(),
            format!("{:e}", measured.work.target),
            shown(measured.seconds),
            // direct light is the same with every tolerance
            if measured.error == 0.0 { "rounding".to_string() } else { format!("{:.0e}", measured.error) },
            format!("{:e}", measured.tolerance),
            time(numpy.first().copied()),
            ratio(numpy.first().copied(), measured.seconds),
            time(default),
            ratio(default, measured.seconds),
            ratio(best, measured.seconds),
            format!("{}", measured.work.goal),
        ];
        row(&mut text, &cells);
    }
    text + "\n"
}

/// Returns the settings with which other programs reached their errors.
fn of_remarks(maps: &[work::Measured], others: &[Line]) -> String {
    let mut text = "| work | program | time | error | |\n|---|---|---|---|---|\n".to_string();
    for measured in maps {
        for line in others.iter().filter(|line| line.work == measured.work.name) {
            let Line { program, seconds, error, remark, .. } = line;
            let cells = [
                measured.work.title.to_string(),
                program.clone(),
                shown(*seconds),
                format!("{error:.0e}"),
                remark.clone(),
            ];
            row(&mut text, &cells);
        }
    }
    text + "\n"
}

fn of_factors(factors: &squares::Measured, others: &[Line]) -> String {
    let mut text =
        "| view factor of unit squares | Forms | Forms error | pyviewfactor | pyviewfactor error |\n\
         |---|---|---|---|---|\n"
            .to_string();
    for (number, (title, error)) in factors.errors.iter().enumerate() {
        let other =
            others.iter().find(|line| line.program.starts_with("pyviewfactor") && line.work == *title);
        let cells = [
            title.clone(),
            if number == 0 { shown(factors.seconds) } else { String::new() },
            format!("{error:.0e}"),
            other
                .filter(|line| line.seconds.is_finite())
                .map_or_else(String::new, |line| shown(line.seconds)),
            other.map_or_else(|| "–".to_string(), |line| format!("{:.0e}", line.error)),
        ];
        row(&mut text, &cells);
    }
    text
}
