//! Geometric drawings: points in space are projected along parallel rays to the canvas.

use crate::vector::{Vector, add, dot, scaled, unit};
use crate::{Anchor, Canvas, Colour, Pen, Style};

/// Font sizes of symbols and of words, and approximate half height of their letters.
const LABEL: f64 = 17.0;
const WORDS: f64 = 15.0;
const LABEL_MIDDLE: f64 = 6.0;
const ARROW_LENGTH: f64 = 10.0;
const ARROW_HALF_WIDTH: f64 = 3.8;
const DOT: f64 = 3.2;

/// Projection of points in space to the paper.
#[derive(Clone, Copy, Debug)]
pub struct View {
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
    pub fn from_direction(azimuth: f64, elevation: f64, scale: f64, origin: [f64; 2]) -> Self {
        let (sin_a, cos_a) = azimuth.to_radians().sin_cos();
        let (sin_e, cos_e) = elevation.to_radians().sin_cos();
        Self { right: [-sin_a, cos_a, 0.0], up: [-cos_a * sin_e, -sin_a * sin_e, cos_e], scale, origin }
    }

    /// Creates the view of the xy-plane itself, for plane figures.
    pub fn flat(scale: f64, origin: [f64; 2]) -> Self {
        Self { right: [1.0, 0.0, 0.0], up: [0.0, 1.0, 0.0], scale, origin }
    }

    fn project(&self, point: Vector) -> [f64; 2] {
        [
            self.origin[0] + self.scale * dot(self.right, point),
            self.origin[1] - self.scale * dot(self.up, point),
        ]
    }

    /// Returns two orthonormal vectors parallel to the paper.
    pub fn plane(&self) -> [Vector; 2] {
        [self.right, self.up]
    }
}

/// Drawing under construction.
#[derive(Clone, Debug)]
pub struct Drawing {
    view: View,
    canvas: Canvas,
    size: [f64; 2],
    title: &'static str,
    description: &'static str,
}

impl Drawing {
    /// Creates an empty drawing with its name, its size, and a description of what is seen.
    pub fn new(title: &'static str, description: &'static str, size: [u32; 2], view: View) -> Self {
        Self { view, canvas: Canvas::new(), size: size.map(f64::from), title, description }
    }

    fn places(&self, points: &[Vector]) -> Vec<[f64; 2]> {
        points.iter().map(|&point| self.view.project(point)).collect()
    }

    /// Draws a filled polygon with an outline.
    pub fn area(&mut self, points: &[Vector], opacity: f64, pen: Pen) {
        self.canvas.polygon(&self.places(points), opacity, pen);
    }

    /// Draws a line through points.
    pub fn line(&mut self, points: &[Vector], pen: Pen) {
        self.canvas.path(&self.places(points), pen);
    }

    /// Draws a curve, given by a parameter from 0 to 1, in this number of steps.
    pub fn curve(&mut self, steps: u32, pen: Pen, point: impl Fn(f64) -> Vector) {
        let points: Vec<Vector> = (0..=steps).map(|step| point(f64::from(step) / f64::from(steps))).collect();
        self.line(&points, pen);
    }

    /// Draws a dot.
    pub fn dot(&mut self, place: Vector, colour: Colour) {
        self.canvas.circle(self.view.project(place), DOT, Some(colour), None);
    }

    /// Draws a vector from its foot.
    pub fn arrow(&mut self, foot: Vector, vector: Vector, pen: Pen) {
        let ([x0, y0], [x1, y1]) = (self.view.project(foot), self.view.project(add(foot, vector)));
        let length = (x1 - x0).hypot(y1 - y0).max(1e-9);
        let (dx, dy) = ((x1 - x0) / length, (y1 - y0) / length);
        let back = [x1 - ARROW_LENGTH * dx, y1 - ARROW_LENGTH * dy];
        let (wx, wy) = (-ARROW_HALF_WIDTH * dy, ARROW_HALF_WIDTH * dx);
        self.canvas.line([x0, y0], back, pen);
        let head = [[x1, y1], [back[0] + wx, back[1] + wy], [back[0] - wx, back[1] - wy]];
        self.canvas.polygon(&head, 1.0, Pen::solid(pen.colour, 0.0));
    }

    /// Draws the arc from one direction to another about a point, at a distance from the point.
    pub fn angle(&mut self, about: Vector, from: Vector, to: Vector, radius: f64, pen: Pen) {
        self.curve(16, pen, |share| {
            let between = unit(add(scaled(1.0 - share, from), scaled(share, to)));
            add(about, scaled(radius, between))
        });
    }

    /// Draws a symbol, slanted, centred at a place plus a shift in paper units.
    pub fn label(&mut self, place: Vector, shift: [f64; 2], text: &str, colour: Colour) {
        self.written(place, shift, Style::of(LABEL, colour).italic(), text);
    }

    /// Draws a symbol on an area, centred at a place.
    pub fn label_inside(&mut self, place: Vector, text: &str, colour: Colour) {
        let style = Style::of(LABEL, colour).italic().anchored(Anchor::Middle);
        self.canvas.text(self.below_middle(place, [0.0; 2]), style, text);
    }

    /// Draws words, upright, centred at a place plus a shift in paper units.
    pub fn words(&mut self, place: Vector, shift: [f64; 2], text: &str, colour: Colour) {
        self.written(place, shift, Style::of(WORDS, colour), text);
    }

    /// Draws words on an area, centred at a place.
    pub fn words_inside(&mut self, place: Vector, text: &str, colour: Colour) {
        let style = Style::of(WORDS, colour).anchored(Anchor::Middle);
        self.canvas.text(self.below_middle(place, [0.0; 2]), style, text);
    }

    /// Draws centred text that can be read over lines.
    fn written(&mut self, place: Vector, shift: [f64; 2], style: Style, text: &str) {
        let at = self.below_middle(place, shift);
        self.canvas.text_over_lines(at, style.anchored(Anchor::Middle), text);
    }

    /// Returns the point of the baseline of a text whose letters are centred at a place.
    fn below_middle(&self, place: Vector, shift: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.view.project(place);
        [x + shift[0], y + shift[1] + LABEL_MIDDLE]
    }

    /// Returns the drawing as the text of an SVG file.
    pub fn finish(self) -> String {
        self.canvas.finish(self.size, self.title, self.description)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_projected_along_the_view() {
        let flat = View::flat(10.0, [100.0, 50.0]);
        assert_eq!(flat.project([1.0, 2.0, 7.0]), [110.0, 30.0]);
        let front = View::from_direction(0.0, 0.0, 1.0, [0.0; 2]);
        assert_eq!(front.project([5.0, 1.0, 2.0]), [1.0, -2.0]);
    }

    #[test]
    fn an_arrow_is_a_line_and_a_head() {
        let mut drawing = Drawing::new("T", "D", [100, 100], View::flat(1.0, [0.0, 50.0]));
        drawing.arrow([0.0; 3], [40.0, 0.0, 0.0], Pen::solid(Colour::Ink, 1.0));
        let file = drawing.finish();
        assert!(file.contains("x1=\"0\" x2=\"30\" y1=\"50\" y2=\"50\""), "{file}");
        assert!(file.contains("points=\"40,50 30,53.8 30,46.2\""), "{file}");
    }
}
