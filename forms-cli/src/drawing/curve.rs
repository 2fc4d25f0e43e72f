//! A curve: the values of a function of one argument, with gaps where it is undefined.

use super::heat_map::Range;
use super::{Anchor, Drawing, GRID, INK, QUIET, Style, round_values};

const SIZE: [f64; 2] = [560.0, 430.0];
/// Frame: left, top, right and bottom.
const FRAME: [f64; 4] = [72.0, 48.0, 540.0, 372.0];
const COLOUR: &str = "#22618f";

/// Draws the curve through these values, at equal steps of the argument, as an SVG file.
pub(crate) fn curve(title: &str, note: &str, across: &Range, values: &[f64]) -> String {
    let [left, top, right, bottom] = FRAME;
    let mut drawing = Drawing::new();
    drawing.text([left, 22.0], Style::of(15.0, INK).bold(), title);
    drawing.text([left, 39.0], Style::of(12.5, QUIET), note);
    let place = |value: f64| left + (value - across.from) / (across.to - across.from) * (right - left);
    for (value, text) in round_values(across.from, across.to, 6) {
        let x = place(value);
        drawing.line([x, top], [x, bottom], GRID, 1.0);
        drawing.text([x, bottom + 18.0], Style::of(13.0, INK).anchored(Anchor::Middle), &text);
    }
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let least = finite().reduce(f64::min).unwrap_or(0.0);
    let greatest = finite().reduce(f64::max).unwrap_or(0.0);
    // A constant is drawn in the middle.
    let margin = if greatest > least { (greatest - least) * 0.04 } else { least.abs().max(1.0) / 2.0 };
    let [low, high] =
        [least - margin, greatest + margin].map(|end| end.clamp(-f64::MAX / 4.0, f64::MAX / 4.0));
    let height = |value: f64| bottom - (value - low) / (high - low) * (bottom - top);
    for (value, text) in round_values(low, high, 6) {
        let y = height(value);
        drawing.line([left, y], [right, y], GRID, 1.0);
        drawing.text([left - 8.0, y + 4.0], Style::of(13.0, INK).anchored(Anchor::End), &text);
    }
    let step = (right - left) / (values.len().max(2) - 1) as f64;
    let points = values.iter().enumerate().map(|(index, value)| [left + step * index as f64, height(*value)]);
    let points: Vec<[f64; 2]> = points.collect();
    for piece in points.split(|point| !point[1].is_finite()).filter(|piece| !piece.is_empty()) {
        drawing.path(piece, COLOUR, 1.8);
    }
    drawing.path(&[[left, top], [right, top], [right, bottom], [left, bottom], [left, top]], INK, 1.0);
    let middle = Style::of(13.0, INK).anchored(Anchor::Middle);
    drawing.text([(left + right) / 2.0, bottom + 40.0], middle, across.name);
    drawing.finish(SIZE[0], SIZE[1], title)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_has_a_gap_where_it_has_no_value_and_numbers_only() {
        let across = Range { name: "x", from: 0.0, to: 1.0 };
        let drawn = |values: &[f64]| curve("f(x)", "", &across, values);
        let frame_and_two_pieces = 3;
        assert_eq!(drawn(&[0.0, 1.0, f64::NAN, 2.0, 3.0]).matches("<polyline").count(), frame_and_two_pieces);
        for values in [[f64::NAN; 2], [3.0; 2], [f64::INFINITY, 1.0], [-f64::MAX, f64::MAX], [0.0; 2]] {
            let drawn = drawn(&values);
            assert!(!drawn.contains("NaN") && !drawn.contains("inf"), "{values:?}: {drawn}");
        }
    }
}
