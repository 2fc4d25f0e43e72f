//! Error bounds: compares the reported error with the true error, for every known answer of the
//! gallery and for every row of the reference that can be expressed as a scene.
//!
//! ```text
//! scenes/*.toml, their known answers ─┐
//! rows of the reference as scenes ────┴─▶ bound over true error, sorted ─▶ table, with the median
//! table ─▶ the terminal, docs/benchmarks.md
//! ```
//! `cargo run --release -p forms-radiometry --example bounds [--write]` prints the table; with
//! `--write` the page is rewritten. Standard errors are not bounds, so sampled answers are
//! excluded. The program fails if a true error exceeds its bound.

use forms_radiometry::simulation::{Answer, ErrorKind, Unwatched, plan, simulate};
use forms_radiometry_testing::gallery::{self, Problem, files, name, said, scene};
use forms_radiometry_testing::known_answers::{GALLERY, Known};
use forms_radiometry_testing::reference_rows as rows;
use forms_testing::page;
use std::process::ExitCode;

/// Tolerance that the reference allows a solver.
const TOLERANCE: f64 = 5e-3;

/// Answer with a bound.
struct Bounded {
    what: String,
    value: f64,
    off: f64,
    bound: f64,
}

impl Bounded {
    /// Returns the bound divided by the true error.
    fn ratio(&self) -> f64 {
        if self.off > 0.0 { self.bound / self.off } else { f64::INFINITY }
    }

    fn row(&self) -> String {
        let Self { what, value, off, bound } = self;
        format!("| {what} | {value:.6e} | {off:.1e} | {bound:.1e} | {:.1} |\n", self.ratio())
    }
}

/// Returns the known answers of the gallery.
fn of_gallery() -> Result<Vec<Bounded>, Problem> {
    let mut found = Vec::new();
    for file in files()? {
        let own = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let known = GALLERY.iter().find(|exhibit| exhibit.file == own).map_or(&[][..], |it| it.known);
        let scene = scene(&std::fs::read_to_string(&file)?, &own)?;
        let plan = plan(&scene).map_err(said)?;
        let answers = simulate(&plan, &Unwatched).answers;
        found.extend(known.iter().filter(|known| has_bound(known, &answers)).map(|known| {
            let [value, bound] = known.found(&answers);
            let what = format!("{}: {}", name(&file), known.sum[0].1);
            Bounded { what, value, off: (value - known.value).abs(), bound }
        }));
    }
    Ok(found)
}

/// Whether no answer of a sum is sampled, and the value is the value of the scene itself.
fn has_bound(known: &Known, answers: &[Answer]) -> bool {
    let summands = known.sum.iter().map(|(_, receiver, _)| receiver);
    let mut own = summands.flat_map(|name| answers.iter().filter(move |answer| answer.receiver == *name));
    known.idealised == 0.0 && own.all(|answer| answer.kind != ErrorKind::Sigma)
}

/// Returns the rows of the reference that are scenes.
fn of_reference() -> Vec<Bounded> {
    let compared = |row: &rows::Row| {
        let rows::Compared { value, off, bound } = row.compared(TOLERANCE)?;
        Some(Bounded { what: row.id.clone(), value, off, bound })
    };
    rows::visible().iter().filter_map(compared).collect()
}

/// Returns the median of some numbers, of which there is at least one.
fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

fn main() -> Result<ExitCode, Problem> {
    let (gallery, reference) = (of_gallery()?, of_reference());
    let of = |found: &[Bounded]| median(found.iter().map(Bounded::ratio).collect());
    let medians = [of(&gallery), of(&reference)];
    let mut all: Vec<Bounded> = gallery.into_iter().chain(reference).collect();
    all.sort_by(|one, other| one.ratio().total_cmp(&other.ratio()));
    let mut table = "| answer | computed | true error | reported error | reported / true error |\n\
                     |---|---|---|---|---|\n"
        .to_owned();
    table.extend(all.iter().map(Bounded::row));
    table += &format!(
        "\nMedian of reported / true error: {:.1}; gallery {:.1}, reference {:.1}.\n",
        of(&all),
        medians[0],
        medians[1]
    );
    print!("{table}");
    if std::env::args().any(|word| word == "--write") {
        let path = gallery::folder().join("../docs/benchmarks.md");
        std::fs::write(&path, page::replaced(&std::fs::read_to_string(&path)?, "bounds", &table))?;
    }
    // a known value is rounded too
    let is_wrong = |found: &Bounded| found.off > found.bound + 4.0 * f64::EPSILON * found.value.abs();
    Ok(if all.iter().any(is_wrong) { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}
