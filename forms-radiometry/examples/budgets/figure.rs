//! The figure of a scene: errors against time on logarithmic axes, and below them the cost of each
//! effect.

use super::measured::{Costs, Measured, Rung};
use forms_figures::{Axis, Bar, Bars, Canvas, Colour, Level, Mark, Numbers, Plot, Series, Style};
use forms_radiometry::simulation::Plan;

/// Width of the figure, height of the frame of errors, and left edge of texts.
const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 300.0;
const LEFT: f64 = 20.0;
/// Left edge of the bars and right edge of the longest bar.
const BARS: [f64; 2] = [200.0, 560.0];
/// Height of a line of text, and the maximum number of characters in it.
const ROW: f64 = 18.0;
const LINE: usize = 92;
/// Rounding and true errors extend the axis if they lie within this number of decades below the
/// least reported error.
const NEAR: f64 = 3.0;
/// Smallest error that is drawn, also for errors of zero: the precision of `f64`.
const SMALLEST: f64 = f64::EPSILON / 2.0;

/// Returns the figure as the text of an SVG file.
pub(crate) fn svg(measured: &Measured) -> String {
    let mut canvas = Canvas::new();
    let plot = errors(&measured.name, &measured.rungs);
    let top = plot.draw(&mut canvas, HEIGHT);
    let height = costs(&mut canvas, top, &measured.costs, &measured.planned.plan);
    canvas.finish([WIDTH, height], &plot.title, &plot.description)
}

fn drawn(error: f64) -> f64 {
    error.max(SMALLEST)
}

/// Returns the range of errors: all reported ones, and rounding and true errors if they are near.
fn range_of_errors(rungs: &[Rung]) -> [f64; 2] {
    let said = || rungs.iter().map(|rung| drawn(rung.said));
    let least = said().fold(f64::MAX, f64::min);
    let others = rungs.iter().flat_map(|rung| [Some(rung.rounding), rung.off]).flatten().map(drawn);
    let near = others.filter(|error| error.log10() > least.log10() - NEAR && *error < least);
    Axis::decades(said().chain(near))
}

/// Returns the plot of errors against time.
fn errors(name: &str, rungs: &[Rung]) -> Plot {
    let last = rungs.last();
    let is_sampled = last.is_some_and(|rung| rung.is_sampled);
    let range = range_of_errors(rungs);
    let times = Axis::decades(rungs.iter().map(|rung| rung.seconds));
    let said = if is_sampled { "reported error, mostly sampling" } else { "reported error" };
    let reported = rungs.iter().map(|rung| [rung.seconds, drawn(rung.said)]).collect();
    let mut series = vec![Series::line(said, reported)];
    series.extend(true_errors(rungs, range[0]));
    if is_sampled {
        series.push(slope(rungs, times, range));
    }
    let rounding = last.map(|rung| (drawn(rung.rounding), format!("rounding {:.0e}", rung.rounding)));
    let (levels, note) = match rounding {
        Some((value, name)) if value >= range[0] => {
            (vec![Level { value, name, colour: Colour::Quiet }], None)
        }
        Some((_, name)) => (Vec::new(), Some(format!("{name}, far below"))),
        None => (Vec::new(), None),
    };
    Plot {
        title: format!("{name}: error against time"),
        description:
            "The error of the worst answer falls with the time of plan and answers; below, the time of \
                      each effect as bars."
                .to_owned(),
        note: note.unwrap_or_default(),
        x: Axis::logarithmic("time of plan and answers, for decreasing tolerance")
            .with_numbers(Numbers::Seconds)
            .over(times),
        y: Axis::logarithmic("relative error [1]").over(range),
        series,
        levels,
        ..Plot::default()
    }
}

/// Returns the series of true errors, where they are known: those in the figure, and at its lower
/// edge those below it.
fn true_errors(rungs: &[Rung], lower_edge: f64) -> Vec<Series> {
    let known = rungs.iter().filter_map(|rung| Some([rung.seconds, drawn(rung.off?)]));
    let (within, below): (Vec<_>, Vec<_>) = known.partition(|place| place[1] >= lower_edge);
    let below: Vec<_> = below.into_iter().map(|[seconds, _]| [seconds, lower_edge]).collect();
    let mut series = Vec::new();
    if !within.is_empty() {
        series.push(Series::line("true error, where known", within).marked(Mark::Square));
    }
    if !below.is_empty() {
        series.push(Series::marks("true error, below the figure", below, Mark::Ring));
    }
    series.into_iter().map(|series| series.coloured(Colour::Vermilion)).collect()
}

/// Returns the line along which a sampling error falls, inversely to the square root of the time,
/// through the mean of the runs.
fn slope(rungs: &[Rung], times: [f64; 2], errors: [f64; 2]) -> Series {
    let mean = |of: fn(&Rung) -> f64| rungs.iter().map(of).sum::<f64>() / rungs.len() as f64;
    let [time, error] = [mean(|rung| rung.seconds.log10()), mean(|rung| drawn(rung.said).log10())];
    let ([first, last], [low, high]) = (times.map(f64::log10), errors.map(f64::log10));
    // times at which the line enters and leaves the frame
    let ends = [first.max(time - 2.0 * (high - error)), last.min(time + 2.0 * (error - low))];
    let at = |end: f64| [10_f64.powf(end), 10_f64.powf(error - 0.5 * (end - time))];
    Series::curve("slope −1/2", ends.map(at).to_vec()).coloured(Colour::Faint).dashed()
}

/// Returns a duration as `3.2 ms`.
fn duration(seconds: f64) -> String {
    let (number, unit) = match seconds {
        short if short < 1e-3 => (short * 1e6, "µs"),
        middle if middle < 1.0 => (middle * 1e3, "ms"),
        long => (long, "s"),
    };
    if number < 10.0 && number.fract() > 0.01 {
        format!("{number:.1} {unit}")
    } else {
        format!("{number:.0} {unit}")
    }
}

/// Draws bars of the time as planned and without each effect, and the operations of the kernels;
/// returns the lower end of the figure.
fn costs(canvas: &mut Canvas, top: f64, costs: &Costs, plan: &Plan) -> f64 {
    let head = format!("Time with each effect turned off, with tolerance {:.1e}", costs.tolerance);
    canvas.text([LEFT, top + 22.0], Style::of(13.5, Colour::Ink).bold(), &head);
    let bar =
        |name: String, seconds: f64, colour| Bar { name, value: seconds, text: duration(seconds), colour };
    let mut bars = vec![bar("as planned".to_owned(), costs.seconds, Colour::Vermilion)];
    for (effect, seconds) in &costs.without {
        bars.push(bar(format!("without {}", effect.name()), *seconds, Colour::Blue));
    }
    let mut y = Bars { edges: BARS, bars }.draw(canvas, top + 36.0) + 18.0;
    for words in operations(plan) {
        canvas.text([LEFT, y], Style::of(12.0, Colour::Quiet), &words);
        y += ROW;
    }
    y
}

/// Returns lines with the operations of each kernel that runs, next to its operations with every
/// effect.
fn operations(plan: &Plan) -> Vec<String> {
    let mut lines = vec!["operations per value:".to_owned()];
    for (number, kernel) in plan.kernels().iter().enumerate() {
        let of_all = if kernel.without.is_empty() {
            String::new()
        } else {
            format!(" of {}", kernel.operations_of_all)
        };
        let comma = if number + 1 == plan.kernels().len() { "" } else { "," };
        let words = format!(" {} {}{of_all}{comma}", kernel.name, kernel.operations);
        match lines.last_mut() {
            Some(line) if line.chars().count() + words.chars().count() <= LINE => line.push_str(&words),
            _ => lines.push(words.trim_start().to_owned()),
        }
    }
    if plan.kernels().is_empty() { Vec::new() } else { lines }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rungs(is_sampled: bool) -> Vec<Rung> {
        let rung = |seconds: f64, said: f64| Rung {
            tolerance: said,
            seconds,
            said,
            rounding: 1e-13,
            is_sampled,
            off: Some(said * said),
        };
        vec![rung(1e-3, 1e-1), rung(1e-2, 3e-2), rung(0.3, 4e-3)]
    }

    #[test]
    fn a_figure_has_the_reported_and_the_true_errors() {
        let file = errors("room", &rungs(false)).svg();
        for part in ["room: error against time", "reported error<", "true error, where known", "far below"] {
            assert!(file.contains(part), "{part}: {file}");
        }
        assert!(!file.contains("slope"), "{file}");
        assert!(errors("room", &rungs(true)).svg().contains("slope −1/2"));
    }

    #[test]
    fn a_sampling_error_falls_by_ten_in_a_hundred_times_the_time() {
        let slope = slope(&rungs(true), [1e-6, 1e6], [1e-9, 1e9]);
        let [[t0, e0], [t1, e1]] = slope.points[..] else { panic!("two ends") };
        assert!(((e1 / e0).log10() / (t1 / t0).log10() + 0.5).abs() < 1e-9);
    }
}
