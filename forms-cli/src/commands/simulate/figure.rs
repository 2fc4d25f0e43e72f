//! The figure of a simulation's error against time, on logarithmic axes.

use forms_figures::{Axis, Colour, Level, Plot, Series};
use forms_radiometry::simulation::Moment;

/// Shortest time in the figure; shorter ones are drawn as this one.
const SHORTEST: f64 = 1e-6;
/// Smallest error in the figure, the accuracy of an `f64`; smaller ones are drawn as this one.
const SMALLEST: f64 = f64::EPSILON / 2.0;

/// Text that is shown if there is no line.
const UNKNOWN: &str = "no relative error is known";

/// Returns the figure as SVG. Moments without a known error are omitted.
pub(super) fn svg(name: &str, history: &[Moment], tolerance: f64) -> String {
    plot(name, history, tolerance).svg()
}

fn plot(name: &str, history: &[Moment], tolerance: f64) -> Plot {
    let known = history.iter().filter(|moment| moment.error.is_finite() && moment.seconds.is_finite());
    let points: Vec<[f64; 2]> =
        known.map(|moment| [moment.seconds.max(SHORTEST), moment.error.max(SMALLEST)]).collect();
    let times = Axis::decades(points.iter().map(|point| point[0]));
    let errors = Axis::decades(points.iter().map(|point| point[1]).chain([tolerance]));
    let title =
        if name.is_empty() { "Error against time".to_owned() } else { format!("{name}: error against time") };
    Plot {
        title,
        description: format!(
            "The largest relative error at each stage of the work, and the tolerance {tolerance:e}."
        ),
        note: "both axes logarithmic".to_owned(),
        x: Axis::logarithmic("time since the start [s]").over(times),
        y: Axis::logarithmic("largest relative error of an answer, cell or pixel [1]").over(errors),
        series: vec![Series::line("", points)],
        levels: vec![Level {
            value: tolerance,
            name: format!("tolerance {tolerance:e}"),
            colour: Colour::Vermilion,
        }],
        missing: UNKNOWN.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moments(history: &[[f64; 2]]) -> Vec<Moment> {
        history.iter().map(|&[seconds, error]| Moment { seconds, error }).collect()
    }

    fn figure(history: &[[f64; 2]]) -> String {
        svg("Box < 1", &moments(history), 1e-3)
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
            let plot = &plot("", &moments(history), 1e-3);
            let is_inside = |value: f64, axis: &Axis| {
                let [from, to] = axis.range.expect("decades");
                (from * (1.0 - 1e-9)..=to * (1.0 + 1e-9)).contains(&value)
            };
            for &[x, y] in &plot.series[0].points {
                assert!(is_inside(x, &plot.x) && is_inside(y, &plot.y), "{history:?}");
            }
        }
    }
}
