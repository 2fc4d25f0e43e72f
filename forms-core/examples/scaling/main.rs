//! Timing of the workloads: the table of `docs/benchmarks.md` and its two figures.
//!
//! ```text
//! workload ─ clock ─▶ seconds ─┬─ table ─▶ docs/benchmarks.md
//!                              └─ Plot  ─▶ docs/figures/*.svg
//! ```
//! `cargo run --release -p forms-core --example scaling [FILE]` writes them. FILE is the output of
//! `benches/compare/product_by_flint.py`; without it the figures have no line for FLINT.

mod table;

use forms_core_testing::workload::{self, Work, built, text};
use forms_figures::{Axis, Mark, Numbers, Plot, Series};
use forms_testing::page::{self, processor};
use forms_testing::processor_clock::seconds;
use std::io;
use std::path::PathBuf;

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

/// Returns the note of the figures: the processor and the measured quantity.
fn note() -> String {
    format!("{}, processor time of one thread, medians", processor())
}

/// Times the points of one line; each has a place on the axis and a workload.
fn timed(name: &str, works: impl IntoIterator<Item = (f64, Work)>) -> Series {
    let points = works.into_iter().map(|(x, mut work)| {
        let time = seconds(&mut work.run);
        println!("{:9.1} µs  {}", time * 1e6, work.name);
        [x, time]
    });
    Series::line(name, points.collect())
}

fn against_dimension() -> Plot {
    let closed_text = (3..=12).map(|n| (n as f64, text::closed(n)));
    let closed_built = (3..=12).map(|n| (f64::from(n), built::closed(n)));
    let powers = (2..=7).map(|m| (f64::from(2 * m), built::power_of_two_form(m)));
    plot_against_dimension(vec![
        timed("ωᵐ of the generic 2-form, n = 2m: (n − 1)!! terms", powers),
        timed("d of the solid angle of Rⁿ is 0, from text", closed_text),
        timed("the same, forms built beforehand", closed_built),
    ])
}

fn plot_against_dimension(series: Vec<Series>) -> Plot {
    Plot {
        title: "Time against the dimension n".into(),
        description:
            "On a logarithmic axis the time of powers of a 2-form grows faster than that of derivatives."
                .into(),
        note: note(),
        x: Axis::linear("dimension n"),
        y: Axis::logarithmic("time").with_numbers(Numbers::Seconds),
        series: marked(series),
        ..Plot::default()
    }
}

/// Gives each line a mark of its own.
fn marked(series: Vec<Series>) -> Vec<Series> {
    series.into_iter().zip(Mark::ALL).map(|(series, mark)| series.marked(mark)).collect()
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
    Ok(plot_against_terms(series))
}

fn plot_against_terms(series: Vec<Series>) -> Plot {
    Plot {
        title: "Time against the number of terms".into(),
        description: "On two logarithmic axes the times are nearly straight lines.".into(),
        note: note(),
        x: Axis::logarithmic("number of terms").with_numbers(Numbers::Thousands),
        y: Axis::logarithmic("time").with_numbers(Numbers::Seconds),
        series: marked(series),
        ..Plot::default()
    }
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
    Ok(Series::line(format!("the same product by {version}"), points.collect::<io::Result<_>>()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plot_has_a_line_with_a_mark_of_its_own_for_each_series() {
        let line = |name: &str| Series::line(name, vec![[3.0, 1e-5], [4.0, 2e-3], [5.0, 0.1]]);
        for plot in [plot_against_dimension, plot_against_terms] {
            let file = plot(vec![line("first"), line("second")]).svg();
            assert_eq!((file.matches("<circle").count(), file.matches(">10 ms<").count()), (4, 1), "{file}");
            assert!(file.contains(">first</text>") && file.contains(">second</text>"), "{file}");
        }
    }
}
