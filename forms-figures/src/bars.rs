//! Horizontal bars with names at their left and values at their right.

use crate::{Anchor, Canvas, Colour, Style};

/// Height of a row, and of a bar in it; font size of names and values.
const ROW: f64 = 23.0;
const BAR: f64 = 14.0;
const SIZE: f64 = 12.5;

/// Bar.
#[derive(Clone, Debug)]
pub struct Bar {
    /// Name at its left.
    pub name: String,
    /// Length, zero or more.
    pub value: f64,
    /// Text at its right.
    pub text: String,
    /// Colour.
    pub colour: Colour,
}

/// Bars below each other.
#[derive(Clone, Debug)]
pub struct Bars {
    /// Left edge of the bars, and right edge of the longest.
    pub edges: [f64; 2],
    /// Bars.
    pub bars: Vec<Bar>,
}

impl Bars {
    /// Draws the bars from this height downwards; returns the lower end.
    pub fn draw(&self, canvas: &mut Canvas, top: f64) -> f64 {
        let longest = self.bars.iter().map(|bar| bar.value).fold(f64::MIN_POSITIVE, f64::max);
        let [begin, end] = self.edges;
        let mut y = top;
        for Bar { name, value, text, colour } in &self.bars {
            let length = (end - begin) * (value / longest).clamp(0.0, 1.0);
            let base = y + 0.8 * BAR;
            let name_style = Style::of(SIZE, Colour::Ink).anchored(Anchor::End);
            canvas.text([begin - 10.0, base], name_style, name);
            canvas.rectangle([begin, y], [length, BAR], Some(*colour), None);
            canvas.text([begin + length + 8.0, base], Style::of(SIZE, Colour::Quiet), text);
            y += ROW;
        }
        y
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_proportional_to_values() {
        let bar = |value| Bar { name: "n".to_owned(), value, text: "t".to_owned(), colour: Colour::Blue };
        let bars = Bars { edges: [100.0, 300.0], bars: vec![bar(2.0), bar(1.0), bar(0.0)] };
        let mut canvas = Canvas::new();
        assert_eq!(bars.draw(&mut canvas, 10.0), 10.0 + 3.0 * ROW);
        let file = canvas.finish([400.0, 100.0], "", "");
        for length in ["200", "100", "0"] {
            assert!(file.contains(&format!("height=\"14\" width=\"{length}\"")), "{file}");
        }
    }
}
