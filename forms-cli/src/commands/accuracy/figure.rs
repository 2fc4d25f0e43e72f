//! The figure of a kernel: correct digits over time above, and below a strip with the bits that each regime costs.

use super::report::{Report, Row};
use forms::core::accuracy::{Arithmetic, Regime, Score};
use std::fmt::Write;

const WIDTH: f64 = 920.0;
const LEFT: f64 = 70.0;
const RIGHT: f64 = 30.0;
/// The plot.
const TOP: f64 = 64.0;
const HEIGHT: f64 = 250.0;
/// The strip.
const STRIP_NAMES: f64 = 250.0;
const ROW: f64 = 24.0;
/// Markers nearer to each other than this are moved apart.
const CROWDED: f64 = 20.0;

const INK: &str = "#222222";
const FAINT: &str = "#8a8a8a";
const GRID: &str = "#e4e4e4";

/// The digits that each arithmetic has.
const LEVELS: [(Arithmetic, &str, f64); 3] = [
    (Arithmetic::Single, "f32", 7.22),
    (Arithmetic::Double, "f64", 15.95),
    (Arithmetic::DoubleDouble, "dd", 31.9),
];

/// The figure as SVG.
pub(super) fn svg(report: &Report, machine: &str) -> String {
    let timed = report.rows.iter().any(|row| row.nanoseconds.is_some());
    let strip_top = if timed { TOP + HEIGHT + 92.0 } else { TOP + 46.0 };
    let height = strip_top + ROW * report.rows.len() as f64 + 56.0;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height:.0}\" width=\"{WIDTH}\" height=\"{height:.0}\" \
         font-family=\"Helvetica, Arial, sans-serif\" font-size=\"13\" fill=\"{INK}\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
    );
    text(&mut svg, LEFT, 26.0, "start", 18.0, INK, &report.kernel);
    let explanation = if timed {
        "right digits of a result over the time of one value; the stem goes down to the hardest regime"
    } else {
        "bits lost in each regime; times were not measured"
    };
    text(&mut svg, LEFT, 46.0, "start", 12.5, FAINT, explanation);
    if timed {
        plot(&mut svg, report);
    }
    strip(&mut svg, report, strip_top);
    text(&mut svg, LEFT, height - 14.0, "start", 11.5, FAINT, machine);
    svg.push_str("</svg>\n");
    svg
}

fn text(svg: &mut String, x: f64, y: f64, anchor: &str, size: f64, colour: &str, content: &str) {
    let content = content.replace('&', "&amp;").replace('<', "&lt;");
    let _ = writeln!(
        svg,
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" font-size=\"{size}\" fill=\"{colour}\">{content}</text>"
    );
}

fn line(svg: &mut String, from: [f64; 2], to: [f64; 2], colour: &str, width: f64) {
    let _ = writeln!(
        svg,
        "<line x1=\"{:.1}\" y1=\"{:.1}\" x2=\"{:.1}\" y2=\"{:.1}\" stroke=\"{colour}\" stroke-width=\"{width}\"/>",
        from[0], from[1], to[0], to[1]
    );
}

fn colour(arithmetic: Arithmetic) -> &'static str {
    match arithmetic {
        Arithmetic::Single => "#b5482f",
        Arithmetic::Double => "#2f6f9f",
        Arithmetic::DoubleDouble => "#4d7f3a",
    }
}

/// The axes of the plot.
struct Axes {
    /// Powers of ten of nanoseconds.
    from: f64,
    to: f64,
}

impl Axes {
    fn x(&self, nanoseconds: f64) -> f64 {
        LEFT + (nanoseconds.log10() - self.from) / (self.to - self.from) * (WIDTH - LEFT - RIGHT)
    }

    fn y(digits: f64) -> f64 {
        TOP + HEIGHT * (1.0 - digits.clamp(0.0, 33.0) / 33.0)
    }
}

fn digits(row: &Row, lost: f64) -> f64 {
    row.correct_bits(lost) * std::f64::consts::LOG10_2
}

fn plot(svg: &mut String, report: &Report) {
    let times: Vec<f64> = report.rows.iter().filter_map(|row| row.nanoseconds).collect();
    let least = times.iter().copied().fold(f64::INFINITY, f64::min);
    let most = times.iter().copied().fold(0.0, f64::max);
    let axes = Axes { from: (least.log10() - 0.04).floor().max(-2.0), to: (most.log10() + 0.15).ceil() };
    frame(svg, &axes);
    let mut taken: Vec<[f64; 2]> = Vec::new();
    for (place, row) in report.rows.iter().enumerate() {
        let Some(time) = row.nanoseconds else { continue };
        let typical = row.line.typical().map_or(0.0, |score| score.bits.mean);
        let hardest = row.hardest().map_or(typical, |score| score.bits.mean);
        let (x, y, low) = (axes.x(time), Axes::y(digits(row, typical)), Axes::y(digits(row, hardest)));
        // a marker that would lie on another is moved, and a thread leads back to its place
        let mut at = [x, y];
        while taken.iter().any(|other| (other[0] - at[0]).hypot(other[1] - at[1]) < CROWDED) {
            at[1] -= CROWDED;
        }
        taken.push(at);
        let colour = colour(row.variant().arithmetic);
        line(svg, [x, y], [x, low], colour, 1.4);
        line(svg, [x - 5.0, low], [x + 5.0, low], colour, 1.8);
        if at[1] < y {
            line(svg, at, [x, y], colour, 0.7);
            let _ = writeln!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2\" fill=\"{colour}\"/>");
        }
        marker(svg, at, row, place + 1, 9.0);
    }
}

fn frame(svg: &mut String, axes: &Axes) {
    let bottom = TOP + HEIGHT;
    for (arithmetic, name, level) in LEVELS {
        let y = Axes::y(level);
        line(svg, [LEFT, y], [WIDTH - RIGHT, y], colour(arithmetic), 0.6);
        text(svg, WIDTH - RIGHT, y - 4.0, "end", 11.0, colour(arithmetic), &format!("all digits of {name}"));
    }
    for value in [0.0, 10.0, 20.0, 30.0] {
        let y = Axes::y(value);
        line(svg, [LEFT, y], [WIDTH - RIGHT, y], GRID, 1.0);
        text(svg, LEFT - 8.0, y + 4.0, "end", 12.0, INK, &format!("{value}"));
    }
    let mut power = axes.from;
    while power <= axes.to + 1e-9 {
        for step in [1.0, 2.0, 5.0] {
            let time = step * 10f64.powf(power);
            let x = axes.x(time);
            if x > WIDTH - RIGHT + 0.5 {
                continue;
            }
            line(svg, [x, TOP], [x, bottom], GRID, if step == 1.0 { 1.0 } else { 0.5 });
            text(svg, x, bottom + 17.0, "middle", 12.0, INK, &format!("{}", short(time)));
        }
        power += 1.0;
    }
    line(svg, [LEFT, bottom], [WIDTH - RIGHT, bottom], INK, 1.0);
    text(svg, (LEFT + WIDTH - RIGHT) / 2.0, bottom + 36.0, "middle", 12.5, INK, "nanoseconds a value");
    let middle = TOP + HEIGHT / 2.0;
    let _ = writeln!(
        svg,
        "<text transform=\"translate(22 {middle:.0}) rotate(-90)\" text-anchor=\"middle\" font-size=\"12.5\">right decimal digits</text>"
    );
}

fn short(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}

/// A circle for single values, a square for batches; filled for the stable form.
fn marker(svg: &mut String, [x, y]: [f64; 2], row: &Row, number: usize, size: f64) {
    let colour = colour(row.variant().arithmetic);
    let (fill, ink) = if row.variant().stable { (colour, "#ffffff") } else { ("#ffffff", colour) };
    let shape = if row.variant().batch {
        format!(
            "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{w:.1}\" height=\"{w:.1}\"",
            x - size,
            y - size,
            w = 2.0 * size
        )
    } else {
        format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{size}\"")
    };
    let _ = writeln!(svg, "{shape} fill=\"{fill}\" stroke=\"{colour}\" stroke-width=\"1.6\"/>");
    text(svg, x, y + 4.0, "middle", 11.0, ink, &number.to_string());
}

fn strip(svg: &mut String, report: &Report, top: f64) {
    let regimes: Vec<Regime> = Regime::ALL
        .into_iter()
        .filter(|regime| report.rows.iter().any(|row| score(row, *regime).is_some()))
        .collect();
    let left = LEFT + STRIP_NAMES;
    let cell = (WIDTH - RIGHT - left) / regimes.len().max(1) as f64;
    text(svg, LEFT - 10.0, top - 26.0, "start", 12.5, INK, "mean bits lost, by regime");
    for (column, regime) in regimes.iter().enumerate() {
        let x = left + cell * (column as f64 + 0.5);
        text(svg, x, top - 8.0, "middle", 11.5, INK, regime.name());
    }
    text(svg, left - 14.0, top - 8.0, "end", 11.5, INK, "ns");
    for (place, row) in report.rows.iter().enumerate() {
        let y = top + ROW * place as f64;
        let base = y + ROW / 2.0 + 4.0;
        marker(svg, [LEFT, y + ROW / 2.0], row, place + 1, 8.0);
        let pareto = if row.pareto { " *" } else { "" };
        text(svg, LEFT + 18.0, base, "start", 12.5, INK, &format!("{}{pareto}", row.variant().name()));
        let time = row.nanoseconds.map_or("-".to_string(), |time| format!("{time:.2}"));
        text(svg, left - 14.0, base, "end", 12.5, INK, &time);
        for (column, regime) in regimes.iter().enumerate() {
            let Some(score) = score(row, *regime) else { continue };
            cell_of(svg, [left + cell * column as f64, y], cell, score, row);
        }
    }
    let end = top + ROW * report.rows.len() as f64 + 16.0;
    let key = "circle: one value at a time, square: batch; filled: stable form, open: as written; * on the Pareto front";
    text(svg, LEFT - 10.0, end, "start", 11.5, FAINT, key);
}

fn score(row: &Row, regime: Regime) -> Option<&Score> {
    row.line.scores.iter().find(|score| score.regime == regime)
}

/// The darker, the larger the part of the digits that is lost.
fn cell_of(svg: &mut String, [x, y]: [f64; 2], width: f64, score: &Score, row: &Row) {
    let all = row.correct_bits(0.0);
    let lost = score.bits.mean;
    let share = ((lost - 0.5).max(0.0) / all).min(1.0).sqrt();
    let mix = |from: f64, to: f64| (from + (to - from) * share).round() as u8;
    let fill = format!("#{:02x}{:02x}{:02x}", mix(236.0, 150.0), mix(244.0, 38.0), mix(236.0, 30.0));
    let ink = if share > 0.55 { "#ffffff" } else { INK };
    let _ = writeln!(
        svg,
        "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\" fill=\"{fill}\"/>",
        x + 1.0,
        y + 1.0,
        width - 2.0,
        ROW - 2.0
    );
    text(svg, x + width / 2.0, y + ROW / 2.0 + 4.0, "middle", 12.0, ink, &format!("{lost:.1}"));
}
