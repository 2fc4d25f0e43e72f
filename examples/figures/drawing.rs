//! A drawing: points in space are projected along parallel rays and become SVG text.

use crate::vector::{Vector, add, dot, scaled};
use std::fmt::Write;

/// Approximate height of a label's lower-case letters.
const LABEL_MIDDLE: f64 = 5.0;
const ARROW_LENGTH: f64 = 10.0;
const ARROW_HALF_WIDTH: f64 = 3.6;
/// Style for a dark page: light and dark are exchanged, and hues stay the same.
const IN_THE_DARK: &str = "@media(prefers-color-scheme:dark){:root{filter:invert(.91) hue-rotate(180deg)}}";

/// Colours; no distinction depends on colour alone.
pub(crate) mod style {
    pub(crate) const INK: &str = "#222222";
    pub(crate) const FAINT: &str = "#9a9a9a";
    pub(crate) const FIRST: &str = "#b5482f";
    pub(crate) const SECOND: &str = "#2f6f9f";
    pub(crate) const THIRD: &str = "#4d7f3a";
    pub(crate) const FOURTH: &str = "#8a6d1d";
}

/// Projection of points in space to the paper.
#[derive(Clone, Copy)]
pub(crate) struct View {
    right: Vector,
    up: Vector,
    /// Paper units per unit of space.
    scale: f64,
    /// Image of the origin.
    origin: [f64; 2],
}

impl View {
    /// Creates the view from a direction, given by its angles about and above the xy-plane in
    /// degrees.
    pub(crate) fn from_direction(azimuth: f64, elevation: f64, scale: f64, origin: [f64; 2]) -> Self {
        let (sin_a, cos_a) = azimuth.to_radians().sin_cos();
        let (sin_e, cos_e) = elevation.to_radians().sin_cos();
        View { right: [-sin_a, cos_a, 0.0], up: [-cos_a * sin_e, -sin_a * sin_e, cos_e], scale, origin }
    }

    /// Creates the view of the xy-plane itself, for plane figures.
    pub(crate) fn flat(scale: f64, origin: [f64; 2]) -> Self {
        View { right: [1.0, 0.0, 0.0], up: [0.0, 1.0, 0.0], scale, origin }
    }

    fn project(&self, point: Vector) -> [f64; 2] {
        [
            self.origin[0] + self.scale * dot(self.right, point),
            self.origin[1] - self.scale * dot(self.up, point),
        ]
    }

    /// Returns two orthonormal vectors parallel to the paper.
    pub(crate) fn plane(&self) -> [Vector; 2] {
        [self.right, self.up]
    }
}

/// Line style.
#[derive(Clone, Copy)]
pub(crate) struct Pen {
    pub(crate) colour: &'static str,
    pub(crate) width: f64,
    pub(crate) dashed: bool,
}

impl Pen {
    pub(crate) fn solid(colour: &'static str, width: f64) -> Self {
        Pen { colour, width, dashed: false }
    }

    pub(crate) fn dashed(colour: &'static str, width: f64) -> Self {
        Pen { colour, width, dashed: true }
    }

    fn attributes(&self) -> String {
        let dashes = if self.dashed { " stroke-dasharray=\"4 4\"" } else { "" };
        let Pen { colour, width, .. } = self;
        format!("stroke=\"{colour}\" stroke-width=\"{width}\"{dashes} stroke-linejoin=\"round\"")
    }
}

/// SVG file under construction.
pub(crate) struct Drawing {
    view: View,
    body: String,
    size: [u32; 2],
    title: &'static str,
}

impl Drawing {
    pub(crate) fn new(title: &'static str, size: [u32; 2], view: View) -> Self {
        Drawing { view, body: String::new(), size, title }
    }

    fn put(&mut self, element: std::fmt::Arguments<'_>) {
        writeln!(self.body, "  {element}").expect("a String takes all text");
    }

    fn points(&self, points: &[Vector]) -> String {
        let places: Vec<String> = points
            .iter()
            .map(|&point| {
                let [x, y] = self.view.project(point);
                format!("{x:.1},{y:.1}")
            })
            .collect();
        places.join(" ")
    }

    /// Draws a filled polygon with an outline.
    pub(crate) fn area(&mut self, points: &[Vector], opacity: f64, pen: Pen) {
        let (points, colour, pen) = (self.points(points), pen.colour, pen.attributes());
        self.put(format_args!(
            "<polygon points=\"{points}\" fill=\"{colour}\" fill-opacity=\"{opacity}\" {pen}/>"
        ));
    }

    /// Draws a polyline.
    pub(crate) fn line(&mut self, points: &[Vector], pen: Pen) {
        let (points, pen) = (self.points(points), pen.attributes());
        self.put(format_args!("<polyline points=\"{points}\" fill=\"none\" {pen}/>"));
    }

    /// Draws a dot.
    pub(crate) fn dot(&mut self, place: Vector, colour: &str) {
        let [x, y] = self.view.project(place);
        self.put(format_args!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"{colour}\"/>"));
    }

    /// Draws a vector from its foot.
    pub(crate) fn arrow(&mut self, foot: Vector, vector: Vector, pen: Pen) {
        let ([x0, y0], [x1, y1]) = (self.view.project(foot), self.view.project(add(foot, vector)));
        let length = (x1 - x0).hypot(y1 - y0).max(1e-9);
        let (dx, dy) = ((x1 - x0) / length, (y1 - y0) / length);
        let (bx, by) = (x1 - ARROW_LENGTH * dx, y1 - ARROW_LENGTH * dy);
        let (wx, wy) = (-ARROW_HALF_WIDTH * dy, ARROW_HALF_WIDTH * dx);
        let (colour, attributes) = (pen.colour, pen.attributes());
        self.put(format_args!(
            "<line x1=\"{x0:.1}\" y1=\"{y0:.1}\" x2=\"{bx:.1}\" y2=\"{by:.1}\" {attributes}/>"
        ));
        let head = format!("{x1:.1},{y1:.1} {:.1},{:.1} {:.1},{:.1}", bx + wx, by + wy, bx - wx, by - wy);
        self.put(format_args!("<polygon points=\"{head}\" fill=\"{colour}\"/>"));
    }

    /// Draws the arc from one direction to another about a point, at a distance from the point.
    pub(crate) fn angle(&mut self, about: Vector, from: Vector, to: Vector, radius: f64, pen: Pen) {
        let arc: Vec<Vector> = (0..=16)
            .map(|step| {
                let share = f64::from(step) / 16.0;
                let between = crate::vector::unit(add(scaled(1.0 - share, from), scaled(share, to)));
                add(about, scaled(radius, between))
            })
            .collect();
        self.line(&arc, pen);
    }

    /// Draws a label centred at a place plus a shift in paper units. `_` makes the next letter a
    /// subscript.
    pub(crate) fn label(&mut self, place: Vector, shift: [f64; 2], text: &str, colour: &str) {
        let [x, y] = self.view.project(place);
        let (x, y) = (x + shift[0], y + shift[1] + LABEL_MIDDLE);
        let text = lowered(text);
        self.put(format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\" fill=\"{colour}\">{text}</text>"
        ));
    }

    /// Returns the whole SVG file.
    pub(crate) fn finish(self) -> String {
        let Drawing { body, size: [width, height], title, .. } = self;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
             height=\"{height}\" role=\"img\" font-family=\"STIX Two Text, Georgia, 'DejaVu Serif', serif\" \
             font-style=\"italic\" font-size=\"17\">\n  <title>{title}</title>\n  <style>{IN_THE_DARK}</style>\n  \
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{body}</svg>\n"
        )
    }
}

/// Typesets `S_u` with its index as a subscript.
fn lowered(text: &str) -> String {
    match text.split_once('_') {
        Some((head, rest)) => {
            let mut letters = rest.chars();
            let index: String = letters.by_ref().take(1).collect();
            let tail = letters.as_str();
            let raised = if tail.is_empty() {
                String::new()
            } else {
                format!("<tspan dy=\"-4\">{}</tspan>", lowered(tail))
            };
            format!("{head}<tspan dy=\"4\" font-size=\"12\">{index}</tspan>{raised}")
        }
        None => text.to_string(),
    }
}
