//! Grid, axes and curves by plotters, whose backend here is the canvas. Colours pass
//! through plotters as numbers of the theme, and positions as whole tenths of a paper unit.

use crate::axis::{LABEL, NUMBER};
use crate::ticks::Ticks;
use crate::{Anchor, Area, Canvas, Colour, Pen, Style};
use plotters::coord::Shift;
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use plotters::prelude::{
    ChartBuilder, ChartContext, DrawingArea, DrawingBackend, FontTransform, IntoDrawingArea, IntoFont,
    LineSeries, RGBColor, ShapeStyle,
};
use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind};
use std::convert::Infallible;

/// Steps of plotters in a paper unit.
const FINE: f64 = 10.0;
/// Length of a tick, in steps.
const TICK: i32 = 40;

const EXPECTED: &str = "drawing on a canvas does not fail";

/// Curve or points in coordinates of the chart.
pub(crate) struct Curve<'a> {
    pub(crate) places: &'a [[f64; 2]],
    pub(crate) colour: Colour,
    pub(crate) width: f64,
}

/// Axis as plotters needs it: range of coordinates, numbers, and label.
pub(crate) struct Side<'a> {
    pub(crate) range: [f64; 2],
    pub(crate) ticks: &'a Ticks,
    pub(crate) label: &'a str,
    pub(crate) has_grid: bool,
    /// Width of the strip outside of the frame that holds numbers and label.
    pub(crate) room: f64,
}

/// Linear axis of plotters with given numbers and fine lines.
#[derive(Clone)]
struct Keyed {
    range: [f64; 2],
    labelled: Vec<f64>,
    fine: Vec<f64>,
}

impl Keyed {
    fn of(side: &Side<'_>) -> Self {
        let labelled = side.ticks.labelled.iter().map(|(value, _)| *value).collect();
        Self { range: side.range, labelled, fine: side.ticks.fine.clone() }
    }
}

impl Ranged for Keyed {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (first, last): (i32, i32)) -> i32 {
        let [from, to] = self.range;
        // halves: the difference of the largest numbers is infinite
        let share = (value / 2.0 - from / 2.0) / (to / 2.0 - from / 2.0);
        // values far outside of the range stay representable
        first + (share.clamp(-9.0, 9.0) * f64::from(last - first)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() { self.fine.clone() } else { self.labelled.clone() }
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.range[0]..self.range[1]
    }
}

type Coordinates = Cartesian2d<Keyed, Keyed>;

/// Chart of plotters on the canvas.
pub(crate) struct Mesh<'a> {
    chart: ChartContext<'a, Paper<'a>, Coordinates>,
}

impl<'a> Mesh<'a> {
    /// Draws grid and axes around and in an area.
    pub(crate) fn draw(canvas: &'a mut Canvas, area: Area, across: &Side<'_>, up: &Side<'_>) -> Self {
        let root = Paper::of(canvas, area, up.room, across.room).into_drawing_area();
        let mut chart = built(&root, across, up);
        let number = |side: &Side<'_>, value: f64| {
            let found = side
                .ticks
                .labelled
                .iter()
                .min_by(|one, other| (one.0 - value).abs().total_cmp(&(other.0 - value).abs()));
            found.map(|(_, text)| text.clone()).unwrap_or_default()
        };
        let (of_x, of_y) = (|value: &f64| number(across, *value), |value: &f64| number(up, *value));
        let text = |size: f64, colour| ("sans-serif", FINE * size).into_font().color(&passed(colour));
        let mut mesh = chart.configure_mesh();
        mesh.bold_line_style(stroke(Colour::Grid, 1.0))
            .light_line_style(stroke(Colour::FineGrid, 1.0))
            .axis_style(stroke(Colour::Ink, 1.2))
            .label_style(text(NUMBER, Colour::Quiet))
            .axis_desc_style(text(LABEL, Colour::Ink))
            .x_label_formatter(&of_x)
            .y_label_formatter(&of_y)
            .set_all_tick_mark_size(TICK)
            .x_desc(across.label)
            .y_desc(up.label);
        if !across.has_grid {
            mesh.disable_x_mesh();
        }
        if !up.has_grid {
            mesh.disable_y_mesh();
        }
        mesh.draw().expect(EXPECTED);
        drop(mesh);
        Self { chart }
    }

    /// Draws a curve.
    pub(crate) fn curve(&mut self, curve: &Curve<'_>) {
        let style = stroke(curve.colour, curve.width);
        let places = curve.places.iter().map(|&[x, y]| (x, y));
        self.chart.draw_series(LineSeries::new(places, style)).expect(EXPECTED);
    }
}

/// Builds the coordinates of a chart with room for numbers and labels.
fn built<'a>(
    root: &DrawingArea<Paper<'a>, Shift>,
    across: &Side<'_>,
    up: &Side<'_>,
) -> ChartContext<'a, Paper<'a>, Coordinates> {
    ChartBuilder::on(root)
        .x_label_area_size(steps(across.room))
        .y_label_area_size(steps(up.room))
        .build_cartesian_2d(Keyed::of(across), Keyed::of(up))
        .expect(EXPECTED)
}

fn steps(units: f64) -> u32 {
    (FINE * units).round() as u32
}

/// Returns a colour as it passes through plotters.
fn passed(colour: Colour) -> RGBColor {
    RGBColor(colour.number(), 0, 0)
}

fn stroke(colour: Colour, width: f64) -> ShapeStyle {
    ShapeStyle::from(&passed(colour)).stroke_width(steps(width))
}

fn colour(colour: BackendColor) -> Colour {
    Colour::of_number(colour.rgb.0)
}

fn pen(style: &impl BackendStyle) -> Pen {
    Pen::solid(colour(style.color()), f64::from(style.stroke_width()) / FINE)
}

/// Part of a canvas as a backend of plotters.
struct Paper<'a> {
    canvas: &'a mut Canvas,
    origin: [f64; 2],
    size: (u32, u32),
}

impl<'a> Paper<'a> {
    /// Returns the area with room at its left and below it.
    fn of(canvas: &'a mut Canvas, area: Area, left: f64, below: f64) -> Self {
        let size = (steps(area.right - area.left + left), steps(area.bottom - area.top + below));
        Self { canvas, origin: [area.left - left, area.top], size }
    }

    fn place(&self, (x, y): BackendCoord) -> [f64; 2] {
        [self.origin[0] + f64::from(x) / FINE, self.origin[1] + f64::from(y) / FINE]
    }
}

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

impl DrawingBackend for Paper<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, point: BackendCoord, drawn: BackendColor) -> Drawn {
        let place = self.place(point);
        self.canvas.circle(place, 0.5 / FINE, Some(colour(drawn)), None);
        Ok(())
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn {
        let [from, to] = [self.place(from), self.place(to)];
        self.canvas.line(from, to, pen(style));
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        let places: Vec<[f64; 2]> = path.into_iter().map(|point| self.place(point)).collect();
        match places[..] {
            [from, to] => self.canvas.line(from, to, pen(style)),
            _ => self.canvas.path(&places, pen(style)),
        }
        Ok(())
    }

    fn draw_text<T: BackendTextStyle>(&mut self, text: &str, style: &T, at: BackendCoord) -> Drawn {
        let size = style.size() / FINE;
        let anchor = match style.anchor().h_pos {
            HPos::Left => Anchor::Start,
            HPos::Center => Anchor::Middle,
            HPos::Right => Anchor::End,
        };
        // from the top, the middle or the bottom of the letters to their baseline
        let drop = match style.anchor().v_pos {
            VPos::Top => 0.78 * size,
            VPos::Center => 0.36 * size,
            VPos::Bottom => -0.22 * size,
        };
        let [x, y] = self.place(at);
        let look = Style::of(size, colour(style.color())).anchored(anchor);
        if matches!(style.transform(), FontTransform::None) {
            self.canvas.text([x, y + drop], look, text);
        } else if !text.is_empty() {
            self.canvas.upright([x + drop, y], look, text);
        }
        Ok(())
    }

    fn estimate_text_size<T: BackendTextStyle>(
        &self,
        text: &str,
        style: &T,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        let size = style.size();
        Ok((crate::width(text, size).ceil() as u32, size.ceil() as u32))
    }
}
