//! Plot of measured times or memory over a logarithmic axis, as SVG text. It is readable on light
//! and on dark backgrounds, and without colour: each line has its own marks.

use std::fmt::Write;

const SIZE: [f64; 2] = [720.0, 456.0];
/// Edges of the frame: left, top, right and bottom.
const FRAME: [f64; 4] = [76.0, 52.0, 700.0, 376.0];
/// Position of the first line of the legend, and the distance between its lines.
const LEGEND: [f64; 2] = [94.0, 72.0];
const LEGEND_STEP: f64 = 21.0;
const LEGEND_WIDTH: f64 = 592.0;
/// Maximum number of lines in a legend with one column.
const ONE_COLUMN: usize = 4;
/// Half the width of a mark.
const MARK: f64 = 4.0;

pub(crate) const STYLE: &str = "\
    .paper{fill:#fff}.ink{fill:#222}.quiet{fill:#666}.grid{stroke:#e2e2e2}.frame{stroke:#999}.title{font-weight:bold;font-size:15px}\
    .s0{color:#b5482f}.s1{color:#2f6f9f}.s2{color:#4d7f3a}.s3{color:#7a559c}.line{stroke:currentColor;fill:none;stroke-width:1.8}\
    .mark{stroke:currentColor;fill:currentColor;stroke-width:1.4}.hollow{fill:#fff}\
    @media(prefers-color-scheme:dark){.paper,.hollow{fill:#16181c}.ink{fill:#e8e8e8}.quiet{fill:#a4a8ae}\
    .grid{stroke:#30343a}.frame{stroke:#6c7178}.s0{color:#ee8d70}.s1{color:#76b7e6}.s2{color:#96cb7f}.s3{color:#c6a2ea}}";

/// Scale of the horizontal axis.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scale {
    Linear,
    Logarithmic,
}

/// Measured quantity.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Measure {
    Seconds,
    Bytes,
}

/// One line: places and the values measured there.
pub(crate) struct Series {
    pub(crate) name: String,
    pub(crate) points: Vec<[f64; 2]>,
}

/// Contents of a plot.
pub(crate) struct Plot {
    pub(crate) title: String,
    pub(crate) caption: String,
    /// Label of the horizontal axis.
    pub(crate) across: String,
    pub(crate) scale: Scale,
    pub(crate) measure: Measure,
    pub(crate) series: Vec<Series>,
    /// Whether lines come in pairs; the two lines of a pair have one colour.
    pub(crate) is_paired: bool,
}

impl Measure {
    /// Formats a power of ten with its unit.
    fn label(self, decade: i32) -> String {
        let (least, units) = match self {
            Self::Seconds => (-9, ["ns", "µs", "ms", "s"]),
            Self::Bytes => (0, ["B", "kB", "MB", "GB"]),
        };
        let thousand = (decade - least).div_euclid(3).clamp(0, 3);
        format!("{} {}", 10_i32.pow((decade - least - 3 * thousand) as u32), units[thousand as usize])
    }
}

/// Range of an axis, and the interval of the drawing to which it is mapped.
pub(crate) struct Axis {
    pub(crate) range: [f64; 2],
    pub(crate) paper: [f64; 2],
}

impl Axis {
    pub(crate) fn place(&self, value: f64) -> f64 {
        let share = (value - self.range[0]) / (self.range[1] - self.range[0]);
        self.paper[0] + share * (self.paper[1] - self.paper[0])
    }
}

impl Plot {
    /// Returns the whole file.
    pub(crate) fn svg(&self) -> String {
        let [width, height] = SIZE;
        let (title, caption) = (escaped(&self.title), escaped(&self.caption));
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
             height=\"{height}\" role=\"img\" font-family=\"'DejaVu Sans', Verdana, sans-serif\" \
             font-size=\"12.5\">\n<title>{title}</title>\n<style>{STYLE}</style>\n\
             <rect class=\"paper\" width=\"{width}\" height=\"{height}\"/>\n"
        );
        let (across, up) = (self.across_axis(), self.up_axis());
        self.grid(&mut svg, &across, &up);
        for (number, series) in self.series.iter().enumerate() {
            let places: Vec<[f64; 2]> = series
                .points
                .iter()
                .map(|&[x, y]| [across.place(self.spread(x)), up.place(y.log10())])
                .collect();
            line(&mut svg, self.look(number), &places);
        }
        self.legend(&mut svg);
        text(&mut svg, [FRAME[0], 30.0], "start", "ink title", &self.title);
        text(&mut svg, [FRAME[2], SIZE[1] - 14.0], "end", "quiet", &caption);
        svg + "</svg>\n"
    }

    /// Returns the colour and the mark of a line.
    fn look(&self, number: usize) -> [usize; 2] {
        if self.is_paired { [number / 2, 2 * (number % 2)] } else { [number, number] }
    }

    /// Returns the number of rows of the legend.
    fn legend_rows(&self) -> usize {
        let count = self.series.len();
        if count > ONE_COLUMN { count.div_ceil(2) } else { count }
    }

    /// Draws the names of the lines on a background of their own, which no grid line crosses.
    fn legend(&self, svg: &mut String) {
        let [left, top] = LEGEND;
        let rows = self.legend_rows();
        let (height, edge) = (LEGEND_STEP * rows as f64, top - LEGEND_STEP / 2.0);
        put(
            svg,
            format_args!(
                "<rect class=\"paper\" x=\"{}\" y=\"{edge}\" width=\"{LEGEND_WIDTH}\" height=\"{height}\"/>",
                left - 8.0
            ),
        );
        for (number, series) in self.series.iter().enumerate() {
            let x = left + LEGEND_WIDTH / 2.0 * (number / rows) as f64;
            let y = top + LEGEND_STEP * (number % rows) as f64;
            line(svg, self.look(number), &[[x, y], [x + 28.0, y]]);
            text(svg, [x + 40.0, y + 4.5], "start", "ink", &series.name);
        }
    }

    fn spread(&self, x: f64) -> f64 {
        if self.scale == Scale::Logarithmic { x.log10() } else { x }
    }

    fn across_axis(&self) -> Axis {
        let places =
            || self.series.iter().flat_map(|series| &series.points).map(|point| self.spread(point[0]));
        let [least, greatest] = [places().fold(f64::MAX, f64::min), places().fold(f64::MIN, f64::max)];
        let margin = 0.03 * (greatest - least);
        Axis { range: [least - margin, greatest + margin], paper: [FRAME[0], FRAME[2]] }
    }

    /// Returns a vertical axis of whole decades, with room for the legend above the lines.
    fn up_axis(&self) -> Axis {
        let times = || self.series.iter().flat_map(|series| &series.points).map(|point| point[1].log10());
        let least = times().fold(f64::MAX, f64::min).floor();
        let greatest = times().fold(f64::MIN, f64::max).ceil();
        let legend = (LEGEND[1] - FRAME[1] + LEGEND_STEP * self.legend_rows() as f64) / (FRAME[3] - FRAME[1]);
        let top = least + (greatest - least) / (1.0 - legend);
        Axis { range: [least, top], paper: [FRAME[3], FRAME[1]] }
    }

    fn grid(&self, svg: &mut String, across: &Axis, up: &Axis) {
        let [left, top, right, bottom] = FRAME;
        for decade in up.range[0] as i32..=up.range[1] as i32 {
            let y = up.place(f64::from(decade));
            rule(svg, "grid", [left, y], [right, y]);
            let label = self.measure.label(decade);
            text(svg, [left - 9.0, y + 4.5], "end", "quiet", &label);
        }
        for (value, label) in self.ticks(across) {
            let x = across.place(value);
            rule(svg, "grid", [x, top], [x, bottom]);
            text(svg, [x, bottom + 19.0], "middle", "quiet", &label);
        }
        rule(svg, "frame", [left, bottom], [right, bottom]);
        rule(svg, "frame", [left, top], [left, bottom]);
        text(svg, [(left + right) / 2.0, bottom + 38.0], "middle", "ink", &self.across);
    }

    /// Returns a tick for every integer, or for every decade.
    fn ticks(&self, across: &Axis) -> Vec<(f64, String)> {
        let [first, last] = [across.range[0].ceil() as i32, across.range[1].floor() as i32];
        let label = |tick: i32| match self.scale {
            Scale::Linear => tick.to_string(),
            Scale::Logarithmic => thousands(10_u64.pow(tick as u32)),
        };
        (first..=last).map(|tick| (f64::from(tick), label(tick))).collect()
    }
}

/// Draws a line with a mark at each place.
pub(crate) fn line(svg: &mut String, [colour, mark]: [usize; 2], places: &[[f64; 2]]) {
    let points: Vec<String> = places.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
    put(
        svg,
        format_args!("<g class=\"s{colour}\"><polyline class=\"line\" points=\"{}\"/>", points.join(" ")),
    );
    for &[x, y] in places {
        let (left, top, wide) = (x - MARK, y - MARK, 2.0 * MARK);
        match mark {
            0 => put(svg, format_args!("<circle class=\"mark\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{MARK}\"/>")),
            1 => put(
                svg,
                format_args!(
                    "<rect class=\"mark\" x=\"{left:.1}\" y=\"{top:.1}\" width=\"{wide}\" height=\"{wide}\"/>"
                ),
            ),
            _ => put(
                svg,
                format_args!("<circle class=\"mark hollow\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{MARK}\"/>"),
            ),
        }
    }
    put(svg, format_args!("</g>"));
}

pub(crate) fn rule(svg: &mut String, class: &str, [x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) {
    put(svg, format_args!("<path class=\"{class}\" d=\"M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}\"/>"));
}

pub(crate) fn text(svg: &mut String, [x, y]: [f64; 2], anchor: &str, class: &str, words: &str) {
    let words = escaped(words);
    put(
        svg,
        format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" class=\"{class}\">{words}</text>"
        ),
    );
}

pub(crate) fn put(svg: &mut String, element: std::fmt::Arguments<'_>) {
    writeln!(svg, "{element}").expect("a String takes all text");
}

pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

/// Formats a number with groups of thousands: `10 000`.
fn thousands(number: u64) -> String {
    let digits = number.to_string();
    let mut grouped = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            grouped.push('\u{2009}');
        }
        grouped.push(digit);
    }
    grouped
}
