//! Path tracing compared with Mitsuba 3: slabs that scatter, an image of the Cornell box, a furnace
//! whose pixels are all known, and absorption along a ray; and the decrease of the error as the
//! number of samples grows.
//!
//! ```text
//! scenes/*.toml ─▶ work ─┬─ criterion
//!                        ├─ measure ─▶ seconds to an error, outliers ─────────────────┐
//!                        ├─ told: scene, reference as JSON ─▶ elsewhere/by_mitsuba.py ┼─▶ table
//!                        └─ convergence ─▶ error over seeds against number of samples ┘
//! table ─▶ the terminal, docs/benchmarks.md
//! ```
//! `cargo bench --bench paths` measures this program's part with criterion. With `--table` Mitsuba
//! is run as well (by `python3`) and the tables are printed; `--write` writes them into the page
//! too. `--table WORD…` restricts both to the works whose titles contain one of the words.

mod convergence;
mod measure;
mod outliers;
mod table;
mod told;
mod work;

use convergence::Series;
use criterion::Criterion;
use forms_radiometry_testing::benches::options::Options;
use forms_radiometry_testing::benches::scripts::{self, Script};
use forms_radiometry_testing::benches::simulated;
use measure::Measured;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;
use work::Work;

const SCRIPTS: [Script; 1] = [("by_mitsuba.py", &["numpy", "mitsuba"])];

fn main() -> io::Result<()> {
    let options = Options::read();
    if !options.are_tables() {
        by_criterion();
        return Ok(());
    }
    let works: Vec<Work> = work::all().into_iter().filter(|work| options.is_wanted(work.title)).collect();
    let folder = emptied()?;
    let mut measured = Vec::new();
    for work in &works {
        let reference = work.reference();
        told::write(work, &reference, &folder)?;
        measured.push(Measured::of(work, &reference));
    }
    let others = scripts::run_all("paths", &SCRIPTS, &folder)?;
    let series = convergence::all().into_iter().filter(|series| options.is_wanted(series.title));
    let series: Vec<_> = series.map(Series::measured).collect();
    options.put("paths", &table::markdown(&measured, &others, &series))
}

/// Returns the directory in which the script finds the works, without the works of the last run.
fn emptied() -> io::Result<PathBuf> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("paths");
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    std::fs::create_dir_all(&folder)?;
    Ok(folder)
}

fn by_criterion() {
    let mut criterion = Criterion::default()
        .sample_size(10)
        .measurement_time(Duration::from_secs(1))
        .warm_up_time(Duration::from_millis(200))
        .configure_from_args();
    for work in work::all() {
        let scene = work.first();
        criterion.bench_function(work.title, |bencher| bencher.iter(|| simulated::simulated(&scene)));
    }
    criterion.final_summary();
}
