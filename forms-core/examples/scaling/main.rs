//! Timing of the workloads: the table of `docs/benchmarks.md` and its two figures.
//!
//! ```text
//! workload ─ clock ─▶ seconds ─┬─ table ─▶ docs/benchmarks.md
//!                              └─ plot  ─▶ docs/figures/*.svg
//! ```
//! `cargo run --release -p forms-core --example scaling [FILE]` writes them. FILE is the output of
//! `benches/compare/product_by_flint.py`; without it the figures have no line for FLINT.

#[path = "../../benches/page/mod.rs"]
mod page;
#[path = "../../benches/workload/mod.rs"]
mod workload;

mod clock;
#[expect(dead_code, reason = "memory is measured of scenes")]
mod plot;
mod table;

use clock::seconds;
use page::processor;
use plot::{Measure, Plot, Scale, Series};
use std::io;
use std::path::PathBuf;
use workload::{Work, built, text};

/// Exponents of the products, as in the script for FLINT.
const EXPONENTS: [u32; 10] = [1, 2, 3, 4, 6, 8, 10, 12, 15, 18];

fn documents() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs")
}

fn main() -> io::Result<()> {
    let flint = std::env::args().nth(1).map(std::fs::read_to_string).transpose()?;
    let figures = documents().join("figures");
    std::fs::create_dir_all(&figures)?;
    std::fs::write(figures.join("scaling_dimension.svg"), against_dimension().svg())?;
    std::fs::write(figures.join("scaling_terms.svg"), against_terms(flint.as_deref())?.svg())?;
    let path = documents().join("benchmarks.md");
    let written = page::replaced(&std::fs::read_to_string(&path)?, "core", &table::rows(workload::all()));
    std::fs::write(path, written)
}

/// Returns the caption of the figures: the processor and the measured quantity.
fn caption() -> String {
    format!("{}, processor time of one thread, medians", processor())
}

/// Times the points of one line; each has a place on the axis and a workload.
fn timed(name: &str, works: impl IntoIterator<Item = (f64, Work)>) -> Series {
    let points = works.into_iter().map(|(x, mut work)| {
        let time = seconds(&mut work.run);
        println!("{:9.1} µs  {}", time * 1e6, work.name);
        [x, time]
    });
    Series { name: name.to_string(), points: points.collect() }
}

fn against_dimension() -> Plot {
    let closed_text = (3..=12).map(|n| (n as f64, text::closed(n)));
    let closed_built = (3..=12).map(|n| (f64::from(n), built::closed(n)));
    let powers = (2..=7).map(|m| (f64::from(2 * m), built::power_of_two_form(m)));
    Plot {
        title: "Time against the dimension n".into(),
        caption: caption(),
        across: "n".into(),
        scale: Scale::Linear,
        measure: Measure::Seconds,
        is_paired: false,
        series: vec![
            timed("ωᵐ of the generic 2-form, n = 2m: (n − 1)!! terms", powers),
            timed("d of the solid angle of Rⁿ is 0, from text", closed_text),
            timed("the same, forms built beforehand", closed_built),
        ],
    }
}

fn against_terms(flint: Option<&str>) -> io::Result<Plot> {
    let products = EXPONENTS.map(|n| (built::product_terms(n) as f64, built::product(n)));
    let derivatives = [1, 2, 4, 8, 16, 32, 64].map(|each| (6.0 * each as f64, built::derivative_twice(each)));
    let mut series = vec![
        timed("d(dω) = 0, n = 6: terms of ω, a 1-form over 1 + |x|²", derivatives),
        timed("f(f + 1), f = (1 + x + y + z + t)ᵏ: terms of the product", products),
    ];
    if let Some(text) = flint {
        series.push(of_flint(text)?);
    }
    Ok(Plot {
        title: "Time against the number of terms".into(),
        caption: caption(),
        across: "terms".into(),
        scale: Scale::Logarithmic,
        measure: Measure::Seconds,
        is_paired: false,
        series,
    })
}

/// Parses the line `# version`, followed by lines `terms,seconds`.
fn of_flint(text: &str) -> io::Result<Series> {
    let unreadable =
        || io::Error::new(io::ErrorKind::InvalidData, "FLINT’s figures are lines `terms,seconds`");
    let (first, rest) = text.split_once('\n').ok_or_else(unreadable)?;
    let point = |line: &str| {
        let (terms, seconds) = line.split_once(',')?;
        Some([terms.parse().ok()?, seconds.parse().ok()?])
    };
    let points = rest.lines().map(|line| point(line).ok_or_else(unreadable));
    let version = first.trim_start_matches(['#', ' ']);
    Ok(Series { name: format!("the same product by {version}"), points: points.collect::<io::Result<_>>()? })
}
