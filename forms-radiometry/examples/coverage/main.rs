//! Honesty of standard errors: simulates every scene with a known answer with many seeds, and
//! counts how often the truth lies within one and within two of the reported standard errors.
//!
//! ```text
//! known answers × seeds ─▶ (answer − truth)/σ ─▶ within 1 σ, within 2 σ: per scene, and for all
//! ```
//! `cargo run --release -p forms-radiometry --example coverage [SEEDS [TOLERANCE…]] [SCENE]` prints
//! a row for each scene. It fails unless, over all scenes together, 63 to 73 % are within one and
//! 93 to 98 % within two standard errors; a normal distribution has 68.3 and 95.4 %.

use forms_radiometry_testing::claims::{self, coverage::Coverage};
use std::process::ExitCode;
use std::time::Instant;

const SEEDS: u64 = 200;
const TOLERANCES: [f64; 2] = [0.1, 0.03];
/// Accepted range of the fraction of answers within one, and within two standard errors.
const HONEST: [[f64; 2]; 2] = [[0.63, 0.73], [0.93, 0.98]];

fn main() -> ExitCode {
    let numbers: Vec<f64> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    let seeds = numbers.first().map_or(SEEDS, |&seeds| seeds as u64);
    let tolerances = if numbers.len() > 1 { &numbers[1..] } else { &TOLERANCES };
    println!(
        "| scene | tolerance | answers | within 1 σ | within 2 σ | largest deviation, σ | exact | ms per run |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let mut pooled = Coverage::default();
    let part = std::env::args().skip(1).find(|word| word.parse::<f64>().is_err()).unwrap_or_default();
    let begin = Instant::now();
    for claim in claims::all_and_long().iter().filter(|claim| claim.name.contains(&part)) {
        for &tolerance in tolerances {
            let start = Instant::now();
            let coverage = Coverage::of(claim, seeds, tolerance);
            row(claim.name, tolerance, &coverage, 1e3 * start.elapsed().as_secs_f64() / seeds as f64);
            pooled += coverage;
        }
    }
    row("all", 0.0, &pooled, 1e3 * begin.elapsed().as_secs_f64());
    let is_honest =
        pooled.parts().iter().zip(HONEST).all(|(part, [least, most])| (least..=most).contains(part));
    if is_honest { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn row(name: &str, tolerance: f64, coverage: &Coverage, milliseconds: f64) {
    let [one, two] = coverage.parts().map(|part| 100.0 * part);
    let Coverage { count, exact, worst, .. } = coverage;
    println!(
        "| {name} | {tolerance} | {count} | {one:.1} % | {two:.1} % | {worst:.1} | {exact} | {milliseconds:.2} |"
    );
}
