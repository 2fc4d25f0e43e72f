//! Scenes compared with other programs: irradiance maps and view factors, with the time and the
//! error of each program.
//!
//! ```text
//! files, scenes/cornell_box.toml ─▶ work ─┬─ criterion
//!                                         └─ clock ─▶ time and error ──────────────┬─▶ table
//!    reference values ─▶ elsewhere/*.py ─▶ times and errors of other programs ─────┘
//! table ─▶ the terminal, docs/benchmarks.md
//! ```
//! `cargo bench --bench scenes` measures this program's part with criterion. With `--table` the
//! scripts of `elsewhere` are run as well (by `python3`) and the tables are printed; `--write`
//! writes them into the page too. `--table WORD…` measures only view factors and the works whose
//! titles contain one of the words, and no other program.

mod squares;
mod table;
mod work;

use criterion::Criterion;
use forms_radiometry_testing::benches::options::Options;
use forms_radiometry_testing::benches::scripts::{self, Script};
use std::path::Path;
use std::time::Duration;

const SCRIPTS: [Script; 4] = [
    ("by_numpy.py", &["numpy"]),
    ("by_mitsuba.py", &["numpy", "mitsuba"]),
    ("by_radiance.py", &["numpy", "pyradiance"]),
    ("by_pyviewfactor.py", &["numpy", "pyviewfactor", "numba"]),
];

fn main() -> std::io::Result<()> {
    let options = Options::read();
    if !options.are_tables() {
        by_criterion();
        return Ok(());
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("scenes");
    std::fs::create_dir_all(&folder)?;
    let pairs = squares::all();
    let factors = squares::measured(&pairs, &folder)?;
    let works: Vec<work::Work> =
        work::all().into_iter().filter(|work| options.is_wanted(work.title)).collect();
    let maps: Vec<work::Measured> =
        works.iter().map(|work| work.measured(&folder)).collect::<Result<_, _>>()?;
    let others = if options.are_all() { scripts::run_all("scenes", &SCRIPTS, &folder)? } else { Vec::new() };
    options.put("scenes", &table::markdown(&maps, &factors, &others))
}

fn by_criterion() {
    let mut criterion = Criterion::default()
        .sample_size(10)
        .measurement_time(Duration::from_secs(1))
        .warm_up_time(Duration::from_millis(200))
        .configure_from_args();
    for work in work::all() {
        criterion.bench_function(work.title, |bencher| bencher.iter(|| work.run()));
    }
    let pairs = squares::all();
    criterion.bench_function("one view factor", |bencher| {
        let mut next = pairs.iter().filter(|pair| pair.is_general()).cycle();
        bencher.iter(|| next.next().map(squares::Pair::view_factor));
    });
    criterion.final_summary();
}
