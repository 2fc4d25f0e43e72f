//! The figure of a scene: errors against time on logarithmic axes, and below them the cost of each
//! effect.

use super::measured::{Costs, Measured, Rung};
use super::plot::{Axis, STYLE, escaped, line, put, rule, text};
use forms_radiometry::simulation::Plan;

const WIDTH: f64 = 720.0;
/// Frame of the errors: left, top, right and bottom.
const FRAME: [f64; 4] = [76.0, 74.0, 686.0, 372.0];
/// Right edge of the names of effects, left edge of the bars and right edge of the longest bar;
/// then the height of a row, and of a bar in it.
const BARS: [f64; 3] = [190.0, 200.0, 560.0];
const ROW: f64 = 22.0;
const BAR: f64 = 13.0;
/// Maximum number of characters in a line of an operation list.
const LINE: usize = 96;
/// Rounding and true errors extend the axis if they lie within this number of decades below the
/// least reported error.
const NEAR: f64 = 3.0;
/// Smallest error that is drawn, also for errors of zero: the precision of `f64`.
const SMALLEST: f64 = f64::EPSILON / 2.0;
/// Style of dashes and bars, in addition to the style of plots.
const OWN_STYLE: &str = ".floor{stroke:#8a8f96;stroke-dasharray:6 4}.slope{stroke:#8a8f96;fill:none;stroke-width:1}.bar{fill:#2f6f9f}.bar.all{fill:#b5482f}\
    @media(prefers-color-scheme:dark){.bar{fill:#76b7e6}.bar.all{fill:#ee8d70}}";

/// Returns the figure as SVG.
pub(crate) fn svg(measured: &Measured) -> String {
    let mut body = String::new();
    errors(&mut body, measured);
    let height = costs(&mut body, &measured.costs, &measured.planned.plan);
    let title = escaped(&format!("{}: error against time", measured.name));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height:.0}\" width=\"{WIDTH}\" height=\"{height:.0}\" \
         role=\"img\" font-family=\"'DejaVu Sans', Verdana, sans-serif\" font-size=\"12.5\">\n<title>{title}</title>\n\
         <style>{STYLE}{OWN_STYLE}</style>\n<rect class=\"paper\" width=\"{WIDTH}\" height=\"{height:.0}\"/>\n{body}</svg>\n"
    )
}

/// Axes, in decimal logarithms of seconds and of relative errors.
struct Axes {
    across: Axis,
    up: Axis,
}

impl Axes {
    /// Returns axes that contain all runs, and rounding if it is near.
    fn of(rungs: &[Rung]) -> Self {
        let [left, top, right, bottom] = FRAME;
        let times = || rungs.iter().map(|rung| rung.seconds.log10());
        let said = || rungs.iter().map(|rung| logarithm(rung.said));
        let [said_least, greatest] = [said().fold(f64::MAX, f64::min), said().fold(f64::MIN, f64::max)];
        let rounding = rungs.iter().map(|rung| logarithm(rung.rounding));
        let near = rounding.chain(rungs.iter().filter_map(|rung| rung.off).map(logarithm));
        let least = near.filter(|error| *error > said_least - NEAR).fold(said_least, f64::min);
        let whole = |[low, high]: [f64; 2]| [low.floor(), high.ceil().max(low.floor() + 1.0)];
        let across = whole([times().fold(f64::MAX, f64::min), times().fold(f64::MIN, f64::max)]);
        Self {
            across: Axis { range: across, paper: [left, right] },
            up: Axis { range: whole([least, greatest]), paper: [bottom, top] },
        }
    }

    fn place(&self, seconds: f64, error: f64) -> [f64; 2] {
        [self.across.place(seconds.log10()), self.up.place(logarithm(error))]
    }

    fn grid(&self, svg: &mut String) {
        let [left, top, right, bottom] = FRAME;
        let decades = |axis: &Axis| axis.range[0] as i32..=axis.range[1] as i32;
        // the distance between numbers is larger than their height
        let step = ((self.up.range[1] - self.up.range[0]) / 12.0).ceil() as usize;
        for decade in decades(&self.up).step_by(step.max(1)) {
            let y = self.up.place(f64::from(decade));
            rule(svg, "grid", [left, y], [right, y]);
            text(svg, [left - 9.0, y + 4.5], "end", "quiet", &power(decade));
        }
        for decade in decades(&self.across) {
            let x = self.across.place(f64::from(decade));
            rule(svg, "grid", [x, top], [x, bottom]);
            text(svg, [x, bottom + 19.0], "middle", "quiet", &duration(10.0_f64.powi(decade)));
        }
        rule(svg, "frame", [left, bottom], [right, bottom]);
        rule(svg, "frame", [left, top], [left, bottom]);
        text(
            svg,
            [(left + right) / 2.0, bottom + 38.0],
            "middle",
            "ink",
            "time of plan and answers, for decreasing tolerance",
        );
    }
}

fn logarithm(error: f64) -> f64 {
    error.max(SMALLEST).log10()
}

/// Returns a power of ten as `1e-3`, and as `1` for the exponent 0.
fn power(decade: i32) -> String {
    if decade == 0 { "1".to_owned() } else { format!("1e{decade}") }
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

fn errors(svg: &mut String, measured: &Measured) {
    let [left, _, right, bottom] = FRAME;
    let rungs = &measured.rungs;
    let axes = Axes::of(rungs);
    text(svg, [left, 28.0], "start", "ink title", &format!("{}: error against time", measured.name));
    axes.grid(svg);
    let Some(last) = rungs.last() else { return };
    let floor = axes.up.place(logarithm(last.rounding));
    let rounding = format!("rounding {:.0e}", last.rounding);
    if floor <= bottom {
        rule(svg, "floor", [left, floor], [right, floor]);
        text(svg, [right - 4.0, floor - 5.0], "end", "quiet", &rounding);
    } else {
        text(svg, [left + 6.0, bottom - 7.0], "start", "quiet", &format!("{rounding}, far below"));
    }
    if last.is_sampled {
        slope(svg, &axes, rungs);
    }
    let said: Vec<_> = rungs.iter().map(|rung| axes.place(rung.seconds, rung.said)).collect();
    let off = || rungs.iter().filter_map(|rung| rung.off.map(|off| axes.place(rung.seconds, off)));
    let (below, within): (Vec<_>, Vec<_>) = off().partition(|place| place[1] > bottom);
    let what = if last.is_sampled { "reported error, mostly sampling" } else { "reported error" };
    legend(svg, left, 0, what);
    line(svg, [0, 0], &said);
    if off().next().is_some() {
        let hollow = if below.is_empty() { "" } else { " (hollow: below)" };
        legend(svg, (left + right) / 2.0, 1, &format!("true error, where known{hollow}"));
        line(svg, [1, 1], &within);
        below.iter().for_each(|&[x, _]| line(svg, [1, 2], &[[x, bottom]]));
    }
}

fn legend(svg: &mut String, x: f64, look: usize, words: &str) {
    let y = 52.0;
    line(svg, [look, look], &[[x, y], [x + 28.0, y]]);
    text(svg, [x + 38.0, y + 4.5], "start", "ink", words);
}

/// Draws the line along which a sampling error falls, inversely to the square root of the time,
/// through the mean of the runs.
fn slope(svg: &mut String, axes: &Axes, rungs: &[Rung]) {
    let mean = |of: fn(&Rung) -> f64| rungs.iter().map(of).sum::<f64>() / rungs.len() as f64;
    let [time, error] = [mean(|rung| rung.seconds.log10()), mean(|rung| logarithm(rung.said))];
    let [low, high] = axes.across.range;
    let [bottom, top] = axes.up.range;
    // times at which the line enters and leaves the frame
    let begin = low.max(time - 2.0 * (top - error));
    let end = high.min(time + 2.0 * (error - bottom));
    let at =
        |time_there: f64| [axes.across.place(time_there), axes.up.place(error - 0.5 * (time_there - time))];
    let [[x0, y0], [x1, y1]] = [at(begin), at(end)];
    put(svg, format_args!("<path class=\"slope\" d=\"M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}\"/>"));
    if y1 + 18.0 < FRAME[3] {
        text(svg, [x1 - 4.0, y1 + 16.0], "end", "quiet", "slope −1/2");
    } else {
        text(svg, [x1 + 2.0, y1 - 22.0], "start", "quiet", "slope −1/2");
    }
}

/// Draws bars of the time as planned and without each effect, and the operations of the kernels;
/// returns the bottom of the figure.
fn costs(svg: &mut String, costs: &Costs, plan: &Plan) -> f64 {
    let mut y = FRAME[3] + 72.0;
    let head = format!("time with each effect turned off, with tolerance {:.1e}", costs.tolerance);
    text(svg, [FRAME[0], y], "start", "ink", &head);
    let rows = std::iter::once(("as planned".to_owned(), costs.seconds, "bar all"));
    let without =
        costs.without.iter().map(|(effect, seconds)| (format!("without {}", effect.name()), *seconds, "bar"));
    let rows: Vec<_> = rows.chain(without).collect();
    let longest = rows.iter().map(|row| row.1).fold(f64::MIN_POSITIVE, f64::max);
    let [names, begin, end] = BARS;
    for (name, seconds, class) in rows {
        y += ROW;
        let wide = (end - begin) * seconds / longest;
        text(svg, [names, y + 0.8 * BAR], "end", "ink", &name);
        put(
            svg,
            format_args!(
                "<rect class=\"{class}\" x=\"{begin}\" y=\"{y:.1}\" width=\"{wide:.1}\" height=\"{BAR}\"/>"
            ),
        );
        text(svg, [begin + wide + 8.0, y + 0.8 * BAR], "start", "quiet", &duration(seconds));
    }
    y += 2.0 * ROW;
    for words in operations(plan) {
        text(svg, [FRAME[0], y], "start", "quiet", &words);
        y += 18.0;
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
