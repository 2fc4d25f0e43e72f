//! The figure of a simulation's error against time, on logarithmic axes.

use crate::drawing::{Anchor, Axis, Drawing, GRID, INK, QUIET, Style};
use forms_radiometry::simulation::Moment;

const SIZE: [f64; 2] = [720.0, 440.0];
/// Frame: left, top, right and bottom.
const FRAME: [f64; 4] = [84.0, 56.0, 696.0, 376.0];
/// Smallest distances between numbers on the lower and on the left axis.
const APART: [f64; 2] = [36.0, 18.0];
/// Colours of the error and of the tolerance.
const ERROR: &str = "#22618f";
const TOLERANCE: &str = "#a8412a";
/// Shortest time in the figure; shorter ones are drawn as this one.
const SHORTEST: f64 = 1e-6;
/// Smallest error in the figure, the accuracy of an `f64`; smaller ones are drawn as this one.
const SMALLEST: f64 = f64::EPSILON / 2.0;

/// Text that is shown if there is no line.
const UNKNOWN: &str = "no relative error is known";

/// Returns the figure as SVG. Moments without a known error are omitted.
pub(super) fn svg(name: &str, history: &[Moment], tolerance: f64) -> String {
    let known = history.iter().filter(|moment| moment.error.is_finite() && moment.seconds.is_finite());
    let points: Vec<[f64; 2]> =
        known.map(|moment| [moment.seconds.max(SHORTEST), moment.error.max(SMALLEST)]).collect();
    let [left, top, right, bottom] = FRAME;
    let errors = points.iter().map(|point| point[1]).chain([tolerance]);
    let across = Axis { powers: decades(points.iter().map(|point| point[0])), paper: [left, right] };
    let up = Axis { powers: decades(errors), paper: [bottom, top] };
    let mut drawing = Drawing::new();
    let title =
        if name.is_empty() { "Error against time".to_owned() } else { format!("{name}: error against time") };
    drawing.text([left, 32.0], Style::of(16.0, INK).bold(), &title);
    axes(&mut drawing, &across, &up);
    let limit = up.place(tolerance);
    drawing.dashes([left, limit], [right, limit], TOLERANCE, 1.6);
    let places: Vec<[f64; 2]> = points.iter().map(|[x, y]| [across.place(*x), up.place(*y)]).collect();
    drawing.path(&places, ERROR, 1.8);
    places.iter().for_each(|&place| drawing.circle(place, 3.4, ERROR, ERROR));
    if points.is_empty() {
        let style = Style::of(12.5, QUIET).anchored(Anchor::Middle);
        drawing.text_over_lines([(left + right) / 2.0, (top + bottom) / 2.0], style, UNKNOWN);
    }
    let style = Style::of(12.0, TOLERANCE).anchored(Anchor::End);
    drawing.text_over_lines([right - 6.0, limit - 6.0], style, &format!("tolerance {tolerance:e}"));
    drawing.finish(SIZE[0], SIZE[1], &title)
}

/// Returns the smallest range of whole decades that contains all values, at least one decade.
fn decades(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let logarithms: Vec<f64> = values.map(f64::log10).collect();
    let Some(least) = logarithms.iter().copied().reduce(f64::min) else { return [-1.0, 0.0] };
    let most = logarithms.iter().copied().fold(least, f64::max);
    let (from, to) = (least.floor(), most.ceil());
    [from, to.max(from + 1.0)]
}

fn axes(drawing: &mut Drawing, across: &Axis, up: &Axis) {
    let [left, top, right, bottom] = FRAME;
    for (x, number) in across.ticks(APART[0]) {
        drawing.line([x, top], [x, bottom], GRID, 1.0);
        drawing.text([x, bottom + 18.0], Style::of(12.0, INK).anchored(Anchor::Middle), &number);
    }
    for (y, number) in up.ticks(APART[1]) {
        drawing.line([left, y], [right, y], GRID, 1.0);
        drawing.text([left - 8.0, y + 4.0], Style::of(12.0, INK).anchored(Anchor::End), &number);
    }
    drawing.line([left, bottom], [right, bottom], INK, 1.0);
    drawing.line([left, top], [left, bottom], INK, 1.0);
    let middle = Style::of(12.5, INK).anchored(Anchor::Middle);
    drawing.text([(left + right) / 2.0, bottom + 40.0], middle, "time since the start [s]");
    drawing.upright(
        [24.0, (top + bottom) / 2.0],
        12.5,
        "largest relative error of an answer, cell or pixel [1]",
    );
    let note = Style::of(11.0, QUIET).anchored(Anchor::End);
    drawing.text([right, bottom + 57.0], note, "both axes logarithmic");
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figure(history: &[[f64; 2]]) -> String {
        let history: Vec<Moment> =
            history.iter().map(|&[seconds, error]| Moment { seconds, error }).collect();
        svg("Box < 1", &history, 1e-3)
    }

    #[test]
    fn the_figure_has_a_dot_for_each_moment_with_an_error_and_the_tolerance_as_dashes() {
        let figure = figure(&[[0.01, f64::INFINITY], [0.02, 0.5], [0.4, 0.02], [7.0, 4e-4]]);
        assert_eq!(figure.matches("<circle").count(), 3);
        assert_eq!(figure.matches("stroke-dasharray").count(), 1);
        for part in
            ["Box &lt; 1: error against time", "tolerance 1e-3", ">time since the start [s]<", ">0.1<"]
        {
            assert!(figure.contains(part), "{part}: {figure}");
        }
    }

    #[test]
    fn errors_and_times_of_nothing_and_histories_of_nothing_are_drawn_inside() {
        for history in
            [&[][..], &[[0.0, 0.0]], &[[f64::NAN, 1.0], [1.0, f64::NAN]], &[[1.0, 1e-3], [1.0, 1e-3]]]
        {
            let figure = figure(history);
            assert!(!figure.contains("NaN") && !figure.contains("inf"), "{figure}");
            assert_eq!(figure.contains("<circle"), !figure.contains(UNKNOWN), "{figure}");
            for circle in figure.split("<circle ").skip(1) {
                let number = |name: &str| -> f64 {
                    let (_, rest) = circle.split_once(&format!("{name}=\"")).expect("an attribute");
                    rest.split('"').next().and_then(|text| text.parse().ok()).expect("a number")
                };
                let [left, top, right, bottom] = FRAME;
                assert!(
                    (left..=right).contains(&number("cx")) && (top..=bottom).contains(&number("cy")),
                    "{circle}"
                );
            }
        }
    }
}
