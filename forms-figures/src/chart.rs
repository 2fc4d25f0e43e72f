//! A chart: axes and grid around an area of the canvas, and the map from values to positions.

use crate::axis::LABEL;
use crate::mesh::{Curve, Mesh, Side};
use crate::{Area, Axis, Canvas, Colour};

/// Room below a chart for numbers and label.
pub(crate) const BELOW: f64 = 29.0 + LABEL;

/// Axes of a chart with their ranges of coordinates.
#[derive(Clone, Debug)]
pub struct Chart<'a> {
    /// Frame.
    pub area: Area,
    x: &'a Axis,
    y: &'a Axis,
    ranges: [[f64; 2]; 2],
    grid: [bool; 2],
}

impl<'a> Chart<'a> {
    /// Creates a chart of these axes. An axis without a range of its own has the range of the data.
    pub fn new(area: Area, x: &'a Axis, y: &'a Axis, data: &[[f64; 2]]) -> Self {
        let of_x = x.coordinates(data.iter().map(|place| place[0]));
        let of_y = y.coordinates(data.iter().map(|place| place[1]));
        Self { area, x, y, ranges: [of_x, of_y], grid: [true; 2] }
    }

    /// Returns the chart without grid lines.
    pub fn without_grid(self) -> Self {
        Self { grid: [false; 2], ..self }
    }

    /// Returns the position of a pair of values.
    pub fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let Area { left, top, right, bottom } = self.area;
        let share = |value: f64, [from, to]: [f64; 2]| {
            // halves: the difference of the largest numbers is infinite
            (value / 2.0 - from / 2.0) / (to / 2.0 - from / 2.0)
        };
        let across = share(self.x.coordinate(x), self.ranges[0]);
        let up = share(self.y.coordinate(y), self.ranges[1]);
        [left + across * (right - left), bottom - up * (bottom - top)]
    }

    /// Returns the room that the numbers and the label of the vertical axis need.
    pub fn room(&self) -> f64 {
        self.y.room(&self.y.ticks(self.ranges[1], self.area.bottom - self.area.top, false))
    }

    /// Draws grid, axes and curves.
    pub(crate) fn draw_with(&self, canvas: &mut Canvas, curves: &[(Vec<[f64; 2]>, Colour, f64)]) {
        let Area { left, top, right, bottom } = self.area;
        let across_ticks = self.x.ticks(self.ranges[0], right - left, true);
        let up_ticks = self.y.ticks(self.ranges[1], bottom - top, false);
        let side = |range, ticks, label, has_grid, room| Side { range, ticks, label, has_grid, room };
        let across = side(self.ranges[0], &across_ticks, self.x.label.as_str(), self.grid[0], BELOW);
        let room = self.y.room(&up_ticks);
        let up = side(self.ranges[1], &up_ticks, self.y.label.as_str(), self.grid[1], room);
        let mut mesh = Mesh::draw(canvas, self.area, &across, &up);
        for (places, colour, width) in curves {
            mesh.curve(&Curve { places, colour: *colour, width: *width });
        }
    }

    /// Draws grid and axes.
    pub fn draw(&self, canvas: &mut Canvas) {
        self.draw_with(canvas, &[]);
    }

    pub(crate) fn coordinates(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.x.coordinate(x), self.y.coordinate(y)]
    }
}
