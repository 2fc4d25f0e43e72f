//! The canvas: text, lines, areas and grids become an SVG file. Positions are in paper units, from
//! the upper left corner.

use crate::theme::{FONTS, StyleSheet, Use};
use crate::{Colour, Style};
use svg::node::element::{Element, SVG};
use svg::node::{Node, Text, Value};

/// Name of the pattern for cells without a value.
const HATCH: &str = "hatch";
/// Width of the rim of a text over lines.
const RIM: f64 = 3.5;

/// Line style.
#[derive(Clone, Copy, Debug)]
pub struct Pen {
    /// Colour.
    pub colour: Colour,
    /// Width, in paper units.
    pub width: f64,
    /// Whether the line is dashed.
    pub dashed: bool,
}

impl Pen {
    /// Creates the style of a continuous line.
    pub fn solid(colour: Colour, width: f64) -> Self {
        Self { colour, width, dashed: false }
    }

    /// Creates the style of a dashed line.
    pub fn dashed(colour: Colour, width: f64) -> Self {
        Self { colour, width, dashed: true }
    }
}

/// Figure under construction.
#[derive(Clone, Debug, Default)]
pub struct Canvas {
    elements: Vec<Element>,
    sheet: StyleSheet,
}

/// Rounds a position to a tenth of a paper unit.
fn short(number: f64) -> String {
    let text = format!("{number:.1}");
    let text = text.strip_suffix(".0").unwrap_or(&text);
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn points(places: &[[f64; 2]]) -> String {
    let places: Vec<String> = places.iter().map(|&[x, y]| format!("{},{}", short(x), short(y))).collect();
    places.join(" ")
}

/// Returns an element with attributes.
fn element<const N: usize>(name: &str, attributes: [(&str, Value); N]) -> Element {
    let mut element = Element::new(name);
    attributes.into_iter().for_each(|(name, value)| element.assign(name, value));
    element
}

fn with_text(mut element: Element, content: &str) -> Element {
    element.append(Text::new(content));
    element
}

impl Canvas {
    /// Creates an empty canvas.
    pub fn new() -> Self {
        Self::default()
    }

    /// Returns the figure as the text of an SVG file of this size. The title is its name, and the
    /// description says what is seen.
    pub fn finish(mut self, [width, height]: [f64; 2], title: &str, description: &str) -> String {
        let (width, height) = (width.ceil(), height.ceil());
        let paper = self.sheet.class(Use::Fill, Colour::Paper);
        let mut file = SVG::new()
            .set("viewBox", format!("0 0 {width} {height}"))
            .set("width", width)
            .set("height", height)
            .set("role", "img")
            .set("font-family", FONTS)
            .add(with_text(Element::new("title"), title));
        if !description.is_empty() {
            file.append(with_text(Element::new("desc"), description));
        }
        file.append(with_text(Element::new("style"), &self.sheet.text()));
        file.append(element(
            "rect",
            [("class", paper.into()), ("width", width.into()), ("height", height.into()), ("rx", 6.into())],
        ));
        self.elements.into_iter().for_each(|element| file.append(element));
        format!("{file}\n")
    }

    /// Adds an element that is filled, stroked, or both.
    fn put(&mut self, mut shape: Element, fill: Option<Colour>, stroke: Option<Pen>) {
        let mut classes = Vec::new();
        if let Some(fill) = fill {
            classes.push(self.sheet.class(Use::Fill, fill));
        } else if shape.get_name() != "line" {
            shape.assign("fill", "none");
        }
        if let Some(pen) = stroke.filter(|pen| pen.width > 0.0) {
            classes.push(self.sheet.class(Use::Stroke, pen.colour));
            if pen.width != 1.0 {
                shape.assign("stroke-width", pen.width);
            }
            if pen.dashed {
                shape.assign("stroke-dasharray", "6 4");
            }
        }
        shape.assign("class", classes.join(" "));
        self.elements.push(shape);
    }

    fn text_element(&mut self, [x, y]: [f64; 2], style: Style, content: &str) -> Element {
        let mut text = element(
            "text",
            [
                ("x", short(x).into()),
                ("y", short(y).into()),
                ("text-anchor", style.anchor.name().into()),
                ("font-size", style.size.into()),
                ("class", self.sheet.class(Use::Fill, style.colour).into()),
            ],
        );
        if style.bold {
            text.assign("font-weight", "bold");
        }
        if style.italic {
            text.assign("font-style", "italic");
        }
        with_text(text, content)
    }

    /// Draws text; the position is on its baseline.
    pub fn text(&mut self, at: [f64; 2], style: Style, content: &str) {
        if !content.is_empty() {
            let text = self.text_element(at, style, content);
            self.elements.push(text);
        }
    }

    /// Draws text with a rim in the colour of the paper, readable over lines.
    pub fn text_over_lines(&mut self, at: [f64; 2], style: Style, content: &str) {
        let mut text = self.text_element(at, style, content);
        let rim = self.sheet.class(Use::Stroke, Colour::Paper);
        let fill = self.sheet.class(Use::Fill, style.colour);
        text.assign("class", format!("{fill} {rim}"));
        text.assign("stroke-width", RIM);
        text.assign("stroke-linejoin", "round");
        text.assign("paint-order", "stroke");
        self.elements.push(text);
    }

    /// Draws text that reads upwards, centred at the position.
    pub fn upright(&mut self, [x, y]: [f64; 2], style: Style, content: &str) {
        let mut text = self.text_element([x, y], style.anchored(crate::Anchor::Middle), content);
        text.assign("transform", format!("rotate(-90 {} {})", short(x), short(y)));
        self.elements.push(text);
    }

    /// Draws a line between two points.
    pub fn line(&mut self, from: [f64; 2], to: [f64; 2], pen: Pen) {
        let [x1, y1, x2, y2] = [from[0], from[1], to[0], to[1]].map(|number| Value::from(short(number)));
        self.put(element("line", [("x1", x1), ("y1", y1), ("x2", x2), ("y2", y2)]), None, Some(pen));
    }

    /// Draws a line through points.
    pub fn path(&mut self, places: &[[f64; 2]], pen: Pen) {
        let line =
            element("polyline", [("points", points(places).into()), ("stroke-linejoin", "round".into())]);
        self.put(line, None, Some(pen));
    }

    /// Draws a polygon with an outline; the area has the colour of the pen with some opacity.
    pub fn polygon(&mut self, places: &[[f64; 2]], opacity: f64, pen: Pen) {
        let mut area =
            element("polygon", [("points", points(places).into()), ("stroke-linejoin", "round".into())]);
        if opacity < 1.0 {
            area.assign("fill-opacity", opacity);
        }
        self.put(area, Some(pen.colour), Some(pen));
    }

    /// Draws a circle.
    pub fn circle(&mut self, [x, y]: [f64; 2], radius: f64, fill: Option<Colour>, outline: Option<Pen>) {
        let [x, y] = [x, y].map(|number| Value::from(short(number)));
        self.put(element("circle", [("cx", x), ("cy", y), ("r", radius.into())]), fill, outline);
    }

    /// Draws a box, given its upper left corner and its size.
    pub fn rectangle(
        &mut self,
        corner: [f64; 2],
        size: [f64; 2],
        fill: Option<Colour>,
        outline: Option<Pen>,
    ) {
        self.put(rectangle(corner, size), fill, outline);
    }

    /// Fills a box with a colour of some opacity.
    pub fn tint(&mut self, corner: [f64; 2], size: [f64; 2], colour: Colour, opacity: f64) {
        let mut tint = rectangle(corner, size);
        tint.assign("fill-opacity", format!("{opacity:.2}"));
        self.put(tint, Some(colour), None);
    }

    /// Fills a box with stripes, which mean that there is no value.
    pub fn hatch(&mut self, corner: [f64; 2], size: [f64; 2]) {
        self.define_hatch();
        let mut hatched = rectangle(corner, size);
        hatched.assign("fill", format!("url(#{HATCH})"));
        self.elements.push(hatched);
    }

    /// Defines the pattern of stripes on its first use.
    fn define_hatch(&mut self) {
        if self.elements.iter().any(|element| element.get_name() == "defs") {
            return;
        }
        let stripe = |width: f64, class: String| {
            element("rect", [("width", width.into()), ("height", 8.into()), ("class", class.into())])
        };
        let mut pattern = element(
            "pattern",
            [
                ("id", HATCH.into()),
                ("width", 8.into()),
                ("height", 8.into()),
                ("patternUnits", "userSpaceOnUse".into()),
                ("patternTransform", "rotate(45)".into()),
            ],
        );
        let [ground, stripes] =
            [Colour::FineGrid, Colour::Faint].map(|colour| self.sheet.class(Use::Fill, colour));
        pattern.append(stripe(8.0, ground));
        pattern.append(stripe(1.6, stripes));
        let mut definitions = Element::new("defs");
        definitions.append(pattern);
        self.elements.push(definitions);
    }

    /// Draws cells of a grid, given the corner of the first cell and the size of a cell. Each entry
    /// is a colour, as red, green and blue, with boxes: column, row, and length along the row.
    pub fn cells(&mut self, corner: [f64; 2], cell: [f64; 2], runs: &[([u8; 3], Vec<[usize; 3]>)]) {
        let ([x, y], [width, height]) = (corner, cell);
        let transform = format!("translate({} {}) scale({width:.5} {height:.5})", short(x), short(y));
        let mut grid =
            element("g", [("transform", transform.into()), ("shape-rendering", "crispEdges".into())]);
        for ([red, green, blue], boxes) in runs.iter().filter(|(_, boxes)| !boxes.is_empty()) {
            let path: String =
                boxes.iter().map(|[x, y, length]| format!("M{x} {y}h{length}v1h-{length}z")).collect();
            let fill = format!("#{red:02x}{green:02x}{blue:02x}");
            grid.append(element("path", [("d", path.into()), ("fill", fill.into())]));
        }
        self.elements.push(grid);
    }
}

fn rectangle([x, y]: [f64; 2], [width, height]: [f64; 2]) -> Element {
    let [x, y, width, height] = [x, y, width, height].map(|number| Value::from(short(number)));
    element("rect", [("x", x), ("y", y), ("width", width), ("height", height)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Anchor;

    #[test]
    fn a_file_has_a_name_a_description_a_role_and_escaped_text() {
        let mut canvas = Canvas::new();
        canvas.text([1.0, 2.25], Style::of(12.0, Colour::Ink).anchored(Anchor::End).bold(), "a < b & c");
        let file = canvas.finish([10.0, 20.0], "T", "what is seen");
        for part in [
            "<title>T</title>",
            "<desc>what is seen</desc>",
            "role=\"img\"",
            "viewBox=\"0 0 10 20\"",
            ">a &lt; b &amp; c</text>",
            "text-anchor=\"end\" x=\"1\" y=\"2.2\"",
        ] {
            assert!(file.contains(part), "{part}: {file}");
        }
        assert!(file.starts_with("<svg") && file.ends_with("</svg>\n"));
    }

    #[test]
    fn positions_are_short() {
        assert_eq!([0.04, -0.04, 1.25, 30.0].map(short), ["0", "0", "1.2", "30"]);
    }

    #[test]
    fn boxes_of_one_colour_are_one_path_and_the_hatch_is_defined_once() {
        let mut canvas = Canvas::new();
        canvas.hatch([0.0; 2], [5.0; 2]);
        canvas.hatch([5.0; 2], [5.0; 2]);
        canvas.cells([1.0, 2.0], [3.0, 4.0], &[([255, 0, 16], vec![[0, 1, 2], [3, 0, 1]]), ([0; 3], vec![])]);
        let file = canvas.finish([10.0; 2], "", "");
        assert!(file.contains("<path d=\"M0 1h2v1h-2zM3 0h1v1h-1z\" fill=\"#ff0010\"/>"), "{file}");
        assert_eq!(file.matches("<pattern").count(), 1);
    }
}
