//! Marks of data points. Each series has a mark of its own, so that it is known without colour.

use crate::{Canvas, Colour, Pen};

/// Mark of a data point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Filled circle.
    Dot,
    /// Filled square.
    Square,
    /// Open circle.
    Ring,
    /// Open square.
    Frame,
    /// Filled square on its corner.
    Diamond,
    /// Vertical stroke.
    Stroke,
}

impl Mark {
    /// Marks in the order in which series take them.
    pub const ALL: [Self; 6] =
        [Self::Dot, Self::Square, Self::Ring, Self::Diamond, Self::Frame, Self::Stroke];
}

impl Canvas {
    /// Draws a mark; `half` is half its width.
    pub fn mark(&mut self, [x, y]: [f64; 2], mark: Mark, half: f64, colour: Colour) {
        let pen = Pen::solid(colour, 1.8);
        let corner = [x - 0.9 * half, y - 0.9 * half];
        let side = [1.8 * half; 2];
        match mark {
            Mark::Dot => self.circle([x, y], half, Some(colour), None),
            Mark::Ring => self.circle([x, y], half, Some(Colour::Paper), Some(pen)),
            Mark::Square => self.rectangle(corner, side, Some(colour), None),
            Mark::Frame => self.rectangle(corner, side, Some(Colour::Paper), Some(pen)),
            Mark::Diamond => {
                let tip = 1.25 * half;
                let tips = [[x, y - tip], [x + tip, y], [x, y + tip], [x - tip, y]];
                self.polygon(&tips, 1.0, Pen::solid(colour, 0.0));
            }
            Mark::Stroke => self.line([x, y - 1.8 * half], [x, y + 1.8 * half], Pen::solid(colour, 2.4)),
        }
    }
}
