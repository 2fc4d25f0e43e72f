//! The figure: a line for each kernel, a mark for each function, nanoseconds per value along a
//! logarithmic axis. It can be read on light and on dark backgrounds, and without colour: each
//! author has a mark of its own.

use crate::catalogue::Author;
use crate::page::processor;
use crate::table::Row;
use std::fmt::Write;

const WIDTH: f64 = 900.0;
/// Left and right ends of the axis.
const ACROSS: [f64; 2] = [330.0, 860.0];
/// Position of the first line, and distance between lines.
const TOP: f64 = 96.0;
const STEP: f64 = 30.0;
/// Half the width of a mark.
const MARK: f64 = 5.0;
/// Authors shown. Their order selects the shape and the class of the mark.
const SHOWN: [Author; 5] =
    [Author::Generated, Author::Expert, Author::GeneratedScalar, Author::Wrenfold, Author::SymPy];

const STYLE: &str = "\
    .paper{fill:#fff}.ink{fill:#222}.quiet{fill:#666}.grid{stroke:#e2e2e2}.row{stroke:#ccc}.title{font-weight:bold;font-size:15px}\
    .s0{color:#b5482f}.s1{color:#222}.s2{color:#b5482f}.s3{color:#2f6f9f}.s4{color:#4d7f3a}\
    .mark{stroke:currentColor;fill:currentColor;stroke-width:1.6}.hollow{fill:#fff}\
    @media(prefers-color-scheme:dark){.paper,.hollow{fill:#16181c}.ink{fill:#e8e8e8}.quiet{fill:#a4a8ae}\
    .grid{stroke:#30343a}.row{stroke:#50555c}.s0,.s2{color:#ee8d70}.s1{color:#e8e8e8}.s3{color:#76b7e6}.s4{color:#96cb7f}}";

/// Returns the whole file.
pub(crate) fn svg(rows: &[Row]) -> String {
    let times = || rows.iter().flat_map(|row| SHOWN.iter().filter_map(|author| row.of(*author)));
    let least = times().fold(f64::MAX, f64::min).log10().floor();
    let greatest = times().fold(1e-9, f64::max).log10().ceil();
    let place =
        |seconds: f64| ACROSS[0] + (seconds.log10() - least) / (greatest - least) * (ACROSS[1] - ACROSS[0]);
    let bottom = TOP + STEP * rows.len() as f64;
    let mut svg = opening(bottom + 50.0);
    for decade in least as i32..=greatest as i32 {
        let seconds = 10_f64.powi(decade);
        let x = place(seconds);
        put(&mut svg, &format!("<path class=\"grid\" d=\"M{x:.1} {:.1}V{bottom:.1}\"/>", TOP - STEP / 2.0));
        text(&mut svg, [x, bottom + 18.0], "middle", "quiet", &format!("{} ns", seconds * 1e9));
    }
    for (number, row) in rows.iter().enumerate() {
        let y = TOP + STEP * number as f64;
        text(&mut svg, [ACROSS[0] - 14.0, y + 4.5], "end", "ink", row.name);
        put(&mut svg, &format!("<path class=\"row\" d=\"M{} {y:.1}H{}\"/>", ACROSS[0], ACROSS[1]));
        for (shape, author) in SHOWN.iter().enumerate().rev() {
            if let Some(seconds) = row.of(*author) {
                mark(&mut svg, shape, [place(seconds), y]);
            }
        }
    }
    let caption = format!("{}, one thread, medians of one run", processor());
    text(&mut svg, [ACROSS[1], bottom + 40.0], "end", "quiet", &caption);
    svg + "</svg>\n"
}

/// Returns the background, the title and the legend.
fn opening(height: f64) -> String {
    let title = "Time per value";
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" height=\"{height}\" \
         role=\"img\" font-family=\"'DejaVu Sans', Verdana, sans-serif\" font-size=\"12.5\">\n<title>{title}</title>\n\
         <style>{STYLE}</style>\n<rect class=\"paper\" width=\"{WIDTH}\" height=\"{height}\"/>\n"
    );
    text(&mut svg, [20.0, 30.0], "start", "ink title", title);
    for (shape, author) in SHOWN.iter().enumerate() {
        let x = 28.0 + 158.0 * shape as f64;
        mark(&mut svg, shape, [x, 56.0]);
        text(&mut svg, [x + 14.0, 60.5], "start", "ink", author.name());
    }
    svg
}

fn mark(svg: &mut String, shape: usize, [x, y]: [f64; 2]) {
    let hollow = if matches!(shape, 2 | 4) { " hollow" } else { "" };
    let class = format!("mark{hollow} s{shape}");
    let element = match shape {
        0 | 2 => format!("<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{MARK}\"/>"),
        1 => format!("<path class=\"{class}\" d=\"M{x:.1} {:.1}v{}\"/>", y - 2.0 * MARK, 4.0 * MARK),
        _ => format!(
            "<rect class=\"{class}\" x=\"{:.1}\" y=\"{:.1}\" width=\"{2}\" height=\"{2}\"/>",
            x - MARK,
            y - MARK,
            2.0 * MARK
        ),
    };
    put(svg, &element);
}

fn text(svg: &mut String, [x, y]: [f64; 2], anchor: &str, class: &str, words: &str) {
    put(
        svg,
        &format!("<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" class=\"{class}\">{words}</text>"),
    );
}

fn put(svg: &mut String, element: &str) {
    writeln!(svg, "{element}").expect("a String takes all text");
}
