//! Scenes beside other programs: irradiance maps and view factors, with the time that each program takes and its error.
//!
//! ```text
//! files, scenes/cornell_box.toml ─▶ work ─┬─ criterion
//!                                         └─ clock ─▶ time and error ──────────────┬─ table ─▶ the terminal, docs/benchmarks.md
//!    reference values ─▶ elsewhere/*.py ─▶ times and errors of other programs ─────┘
//! ```
//! `cargo bench --bench scenes` has criterion measure this program's part. With `--table` the scripts of `elsewhere` are run as well
//! (by `python3`) and the tables printed; `--write` writes them into the page too. `--table WORD…` measures only view factors and the
//! works whose titles contain one of the words, and no other program.

mod clock;
mod elsewhere;
#[path = "../../../forms-core/benches/page/mod.rs"]
mod page;
#[path = "../../../forms-core/examples/scaling/clock.rs"]
mod processor_clock;
mod squares;
mod table;
mod work;

use criterion::Criterion;
use std::path::Path;
use std::time::Duration;

fn main() -> std::io::Result<()> {
    let (options, words): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|argument| argument.starts_with('-'));
    let has = |name: &str| options.iter().any(|option| option == name);
    if !has("--table") && !has("--write") {
        by_criterion();
        return Ok(());
    }
    let wanted = |title: &str| words.is_empty() || words.iter().any(|word| title.contains(word.as_str()));
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("scenes");
    std::fs::create_dir_all(&folder)?;
    let pairs = squares::all();
    let factors = squares::measured(&pairs, &folder)?;
    let works: Vec<work::Work> = work::all().into_iter().filter(|work| wanted(work.title)).collect();
    let maps: Vec<work::Measured> =
        works.iter().map(|work| work.measured(&folder)).collect::<Result<_, _>>()?;
    let others = if words.is_empty() { elsewhere::run_all(&folder)? } else { Vec::new() };
    let table = table::markdown(&maps, &factors, &others);
    print!("{table}");
    if has("--write") && words.is_empty() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/benchmarks.md");
        let page = page::replaced(&std::fs::read_to_string(&path)?, "scenes", &table);
        std::fs::write(path, page)?;
    }
    Ok(())
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
