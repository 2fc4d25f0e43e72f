//! Drawings: text, lines, boxes and dots become an SVG file.

mod axis;
mod curve;
mod heat_map;
mod linear;

pub(crate) use axis::Axis;
pub(crate) use curve::curve;
pub(crate) use heat_map::{HeatMap, Range, Scale};
pub(crate) use linear::round_values;

use crate::layout::filled;
use std::fmt::Write;

/// Colour of text and of measured data.
pub(crate) const INK: &str = "#1f2328";
/// Colour of explanations.
pub(crate) const QUIET: &str = "#57606a";
/// Colour of grid lines.
pub(crate) const GRID: &str = "#e3e6e9";

/// Mean width of a character, in font sizes, for names, numbers and short sentences in Helvetica
/// and similar fonts.
const CHARACTER: f64 = 0.5;

/// Part of a text that is at its given position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

impl Anchor {
    fn name(self) -> &'static str {
        match self {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        }
    }
}

/// Text style.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Style {
    pub(crate) anchor: Anchor,
    pub(crate) size: f64,
    pub(crate) colour: &'static str,
    pub(crate) bold: bool,
}

impl Style {
    pub(crate) fn of(size: f64, colour: &'static str) -> Self {
        Style { anchor: Anchor::Start, size, colour, bold: false }
    }

    pub(crate) fn anchored(self, anchor: Anchor) -> Self {
        Style { anchor, ..self }
    }

    pub(crate) fn bold(self) -> Self {
        Style { bold: true, ..self }
    }
}

/// Estimates the width of a text.
pub(crate) fn width(content: &str, size: f64) -> f64 {
    content.chars().count() as f64 * size * CHARACTER
}

/// Breaks a text into lines that are at most this wide.
pub(crate) fn wrapped(content: &str, size: f64, widest: f64) -> Vec<String> {
    filled(content, |line, word| width(line, size) + width(word, size) + size * CHARACTER <= widest)
}

/// Drawing on a white background, readable on dark and on light pages.
pub(crate) struct Drawing {
    body: String,
}

impl Drawing {
    pub(crate) fn new() -> Self {
        Drawing { body: String::new() }
    }

    /// Returns the drawing as an SVG file.
    pub(crate) fn finish(self, width: f64, height: f64, title: &str) -> String {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height:.0}\" width=\"{width}\" \
             height=\"{height:.0}\" role=\"img\" font-family=\"Helvetica, Arial, Liberation Sans, sans-serif\">\n\
             <title>{}</title>\n<rect width=\"100%\" height=\"100%\" rx=\"6\" fill=\"#ffffff\"/>\n{}</svg>\n",
            escaped(title),
            self.body
        )
    }

    pub(crate) fn text(&mut self, [x, y]: [f64; 2], style: Style, content: &str) {
        let Style { anchor, size, colour, bold } = style;
        let weight = if bold { " font-weight=\"bold\"" } else { "" };
        let _ = writeln!(
            self.body,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{}\" font-size=\"{size}\" fill=\"{colour}\"{weight}>{}</text>",
            anchor.name(),
            escaped(content)
        );
    }

    /// Draws text with a white rim, readable over lines.
    pub(crate) fn text_over_lines(&mut self, [x, y]: [f64; 2], style: Style, content: &str) {
        let Style { anchor, size, colour, .. } = style;
        let _ = writeln!(
            self.body,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{}\" font-size=\"{size}\" fill=\"{colour}\" stroke=\"#ffffff\" \
             stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\">{}</text>",
            anchor.name(),
            escaped(content)
        );
    }

    /// Draws vertical text, centred at the position.
    pub(crate) fn upright(&mut self, [x, y]: [f64; 2], size: f64, content: &str) {
        let _ = writeln!(
            self.body,
            "<text transform=\"translate({x:.1} {y:.1}) rotate(-90)\" text-anchor=\"middle\" font-size=\"{size}\" \
             fill=\"{INK}\">{}</text>",
            escaped(content)
        );
    }

    pub(crate) fn line(&mut self, from: [f64; 2], to: [f64; 2], colour: &str, width: f64) {
        let _ = writeln!(
            self.body,
            "<line x1=\"{:.1}\" y1=\"{:.1}\" x2=\"{:.1}\" y2=\"{:.1}\" stroke=\"{colour}\" stroke-width=\"{width}\"/>",
            from[0], from[1], to[0], to[1]
        );
    }

    /// Draws a dashed line.
    pub(crate) fn dashes(&mut self, from: [f64; 2], to: [f64; 2], colour: &str, width: f64) {
        let _ = writeln!(
            self.body,
            "<line x1=\"{:.1}\" y1=\"{:.1}\" x2=\"{:.1}\" y2=\"{:.1}\" stroke=\"{colour}\" stroke-width=\"{width}\" \
             stroke-dasharray=\"6 4\"/>",
            from[0], from[1], to[0], to[1]
        );
    }

    pub(crate) fn path(&mut self, points: &[[f64; 2]], colour: &str, width: f64) {
        let points: Vec<String> = points.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
        let _ = writeln!(
            self.body,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"/>",
            points.join(" ")
        );
    }

    pub(crate) fn square(&mut self, [x, y]: [f64; 2], half: f64, fill: &str, stroke: &str) {
        let (left, top, side) = (x - half, y - half, 2.0 * half);
        let _ = writeln!(
            self.body,
            "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{side:.1}\" height=\"{side:.1}\" fill=\"{fill}\" \
             stroke=\"{stroke}\" stroke-width=\"1.8\"/>"
        );
    }

    pub(crate) fn circle(&mut self, [x, y]: [f64; 2], radius: f64, fill: &str, stroke: &str) {
        let _ = writeln!(
            self.body,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{fill}\" stroke=\"{stroke}\" stroke-width=\"1.8\"/>"
        );
    }

    /// Draws boxes of a grid with one colour or pattern. Each box has a position and a length along
    /// its row, in cells.
    pub(crate) fn runs(&mut self, runs: &[[usize; 3]], fill: &str) {
        let path: String =
            runs.iter().map(|[x, y, length]| format!("M{x} {y}h{length}v1h-{length}z")).collect();
        let _ = writeln!(self.body, "<path d=\"{path}\" fill=\"{fill}\"/>");
    }

    /// Draws inside a grid of cells of this size; the given point is the corner of the first cell.
    pub(crate) fn grid(
        &mut self,
        [x, y]: [f64; 2],
        [width, height]: [f64; 2],
        inside: impl FnOnce(&mut Self),
    ) {
        let _ = writeln!(
            self.body,
            "<g transform=\"translate({x:.2} {y:.2}) scale({width:.5} {height:.5})\" shape-rendering=\"crispEdges\">"
        );
        inside(self);
        self.body.push_str("</g>\n");
    }

    /// Defines a fill pattern of this name: stripes on a grey background.
    pub(crate) fn hatch(&mut self, name: &str) {
        let _ = writeln!(
            self.body,
            "<defs><pattern id=\"{name}\" width=\"8\" height=\"8\" patternUnits=\"userSpaceOnUse\" \
             patternTransform=\"rotate(45)\"><rect width=\"8\" height=\"8\" fill=\"#f1f2f4\"/>\
             <rect width=\"2\" height=\"8\" fill=\"#b3b9c0\"/></pattern></defs>"
        );
    }

    /// Draws a filled box, optionally with an outline of another colour.
    pub(crate) fn cell(
        &mut self,
        [x, y]: [f64; 2],
        [width, height]: [f64; 2],
        fill: &str,
        outline: Option<&str>,
    ) {
        let outline =
            outline.map_or(String::new(), |colour| format!(" stroke=\"{colour}\" stroke-width=\"1.6\""));
        let _ = writeln!(
            self.body,
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"{fill}\"{outline}/>"
        );
    }
}

fn escaped(content: &str) -> String {
    content.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
