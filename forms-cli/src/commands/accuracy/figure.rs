//! The figure of a kernel.
//!
//! ```text
//! Report ─┬─ panel ─▶ digits over time on typical arguments │ the same in the hardest regime
//!         └─ strip ─▶ the variants, their times, the bits lost in each regime
//! ```

mod panel;
mod strip;

use super::report::Report;
use super::timing::RUNS;
use crate::layout::filled;
use forms::core::accuracy::{Arithmetic, Variant};
use forms_figures::{Area, Canvas, Colour, Pen, Style, width};
use panel::{Panel, Times};
use strip::{HEAD, ROW, Strip};

const WIDTH: f64 = 960.0;
/// Left edge of the texts, and edges of the panels.
const EDGE: f64 = 28.0;
const LEFT: f64 = 82.0;
const RIGHT: f64 = 940.0;
/// Gap between the panels.
const GAP: f64 = 48.0;
/// Height of the panels, and the space above and below them.
const PANEL: f64 = 310.0;
const ABOVE_PANEL: f64 = 34.0;
const BELOW_PANEL: f64 = 50.0;

const DESCRIPTION: &str = "Two panels: correct decimal digits over the time of one value, for typical arguments and for \
                           the hardest ones. Below: the bits lost by each variant in each regime of arguments.";

/// Line of the Pareto front.
fn front() -> Pen {
    Pen::solid(Colour::Faint, 2.4)
}

/// Breaks a text into lines that are at most this wide.
fn wrapped(content: &str, size: f64, widest: f64) -> Vec<String> {
    filled(content, |line, word| width(line, size) + width(&format!(" {word}"), size) <= widest)
}

/// Returns the figure as SVG.
pub(super) fn svg(report: &Report, machine: &str) -> String {
    let mut canvas = Canvas::new();
    let mut y = head(&mut canvas, report);
    if let Some(times) = Times::of(report) {
        panels(&mut canvas, report, times, y + ABOVE_PANEL);
        y += ABOVE_PANEL + PANEL + BELOW_PANEL;
    }
    Strip { left: EDGE, right: RIGHT, top: y }.draw(&mut canvas, report);
    y += HEAD + ROW * report.rows.len() as f64 + 24.0;
    key(&mut canvas, y);
    y += 22.0;
    let [least, most] = RUNS;
    let times = format!("Times are medians of {least} to {most} runs on typical arguments: {machine}.");
    for line in wrapped(&times, 11.5, RIGHT - EDGE) {
        canvas.text([EDGE, y], Style::of(11.5, Colour::Quiet), &line);
        y += 16.0;
    }
    let title = format!("{}: accuracy and time of every variant", report.kernel);
    canvas.finish([WIDTH, y], &title, DESCRIPTION)
}

/// Draws the name and the summary of the kernel; returns the y coordinate of the end.
fn head(canvas: &mut Canvas, report: &Report) -> f64 {
    canvas.text([EDGE, 30.0], Style::of(19.0, Colour::Ink).bold(), &report.kernel);
    let mut y = 34.0;
    let (summary, formula) = (report.summary(), format!("{} = {}", report.kernel, report.formula));
    let with_formula = format!("{summary} {formula}");
    // The formula is added if both fit in one line.
    let has_room = summary != formula && width(&with_formula, 13.0) <= RIGHT - EDGE;
    for line in wrapped(if has_room { &with_formula } else { &summary }, 13.0, RIGHT - EDGE) {
        y += 17.0;
        canvas.text([EDGE, y], Style::of(13.0, Colour::Quiet), &line);
    }
    y
}

fn panels(canvas: &mut Canvas, report: &Report, times: Times, top: f64) {
    let width = (RIGHT - LEFT - GAP) / 2.0;
    let area = |left: f64| Area { left, top, right: left + width, bottom: top + PANEL };
    Panel {
        area: area(LEFT),
        times,
        title: "typical arguments",
        digits: "correct decimal digits, mean",
        score: |row| row.line.typical(),
    }
    .draw(canvas, report);
    Panel {
        area: area(LEFT + width + GAP),
        times,
        title: "each variant in the regime that is hardest for it",
        digits: "",
        score: |row| row.hardest().or(row.line.typical()),
    }
    .draw(canvas, report);
}

fn colour(arithmetic: Arithmetic) -> Colour {
    match arithmetic {
        Arithmetic::Single => Colour::Vermilion,
        Arithmetic::Double => Colour::Blue,
        Arithmetic::DoubleDouble => Colour::Green,
    }
}

/// Draws the marker of a variant: a circle for single values, a square for batches; open as
/// written, small and filled for the stable form, so that both are visible where they coincide.
fn marker(canvas: &mut Canvas, at: [f64; 2], variant: Variant) {
    let colour = colour(variant.arithmetic);
    let square = |half: f64| ([at[0] - half, at[1] - half], [2.0 * half; 2]);
    let outline = Some(Pen::solid(colour, 1.8));
    match (variant.batch, variant.stable) {
        (false, false) => canvas.circle(at, 6.0, None, outline),
        (false, true) => canvas.circle(at, 3.4, Some(colour), outline),
        (true, false) => canvas.rectangle(square(5.5).0, square(5.5).1, None, outline),
        (true, true) => canvas.rectangle(square(3.0).0, square(3.0).1, Some(colour), outline),
    }
}

/// Draws the key of the markers and lines.
fn key(canvas: &mut Canvas, y: f64) {
    let variant = |stable: bool, batch: bool| Variant { arithmetic: Arithmetic::Double, stable, batch };
    let marks = [
        (variant(false, false), "as written"),
        (variant(true, false), "stable form"),
        (variant(false, true), "as written, batch"),
        (variant(true, true), "stable form, batch"),
    ];
    let mut x = EDGE + 8.0;
    for (variant, name) in marks {
        marker(canvas, [x, y - 4.0], variant);
        canvas.text([x + 12.0, y], Style::of(11.5, Colour::Ink), name);
        x += 30.0 + width(name, 11.5);
    }
    canvas.line([x - 4.0, y - 4.0], [x + 20.0, y - 4.0], front());
    let front = "Pareto front; up and to the left is better";
    canvas.text([x + 26.0, y], Style::of(11.5, Colour::Ink), front);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::commands::accuracy::report::Row;
    use forms::core::accuracy::{Line, Regime, Score, Statistics};

    fn report() -> Report {
        let score = |regime, mean| Score {
            regime,
            points: 8,
            bits: Statistics { mean, percentile: mean, maximum: mean },
            ulps: Statistics::default(),
            worst: Vec::new(),
        };
        let rows = Variant::ALL.into_iter().enumerate().map(|(place, variant)| Row {
            line: Line { variant, scores: vec![score(Regime::Typical, 0.5), score(Regime::Large, 9.0)] },
            nanoseconds: Some(1.0 + 0.3 * place as f64),
            pareto: place == 0,
        });
        Report {
            file: "f.forms".into(),
            kernel: "form_factor_of_something".into(),
            docs: vec!["What is seen of x < 1 & more. Not shown.".into()],
            formula: "x".into(),
            domain: Vec::new(),
            form: None,
            bounds: Ok(Vec::new()),
            rows: rows.collect(),
        }
    }

    /// Returns the value of an attribute of an element.
    fn attribute<'a>(element: &'a str, name: &str) -> &'a str {
        let rest = element.split_once(&format!(" {name}=\"")).expect("the attribute").1;
        rest.split_once('"').expect("its end").0
    }

    #[test]
    fn every_text_is_inside_and_large_enough_to_be_read() {
        let svg = svg(&report(), "a machine");
        let height: f64 = attribute(&svg, "height").parse().expect("a number");
        let texts: Vec<&str> = svg.split("<text").skip(1).collect();
        assert!(texts.len() > 60, "{svg}");
        for text in texts.iter().filter(|text| !text.contains("rotate")) {
            let number = |name| attribute(text, name).parse::<f64>().expect("a number");
            let content = text.split_once('>').expect("a tag").1.split_once('<').expect("its end").0;
            let wide = width(content, number("font-size"));
            let left = number("x")
                - match attribute(text, "text-anchor") {
                    "start" => 0.0,
                    "middle" => wide / 2.0,
                    _ => wide,
                };
            assert!(number("font-size") >= 11.0, "{text}");
            assert!(left >= 0.0 && left + wide <= WIDTH && number("y") <= height - 4.0, "{text}");
        }
    }

    #[test]
    fn each_variant_is_named_in_both_panels_and_in_the_strip() {
        let svg = svg(&report(), "a machine");
        for variant in Variant::ALL {
            assert_eq!(svg.matches(&format!(">{}</text>", variant.name())).count(), 3, "{}", variant.name());
        }
        for part in [
            "form_factor_of_something",
            "What is seen of x &lt; 1 &amp; more.",
            "typical",
            "large",
            "a machine",
        ] {
            assert!(svg.contains(part), "{part}");
        }
        assert!(!svg.contains("Not shown"));
    }
}
