//! Figures: numbers in, the text of an SVG file out.
//!
//! ```text
//! Plot, Bars ─ Chart (axes, by plotters) ─┐
//! HeatMap ─ Chart ────────────────────────┼─▶ Canvas (paper, theme, the crate svg) ─▶ text
//! Drawing ─ View (space to paper) ────────┘
//! ```
//! *Invariant*: equal input gives equal bytes. Every file has a title and a description for readers
//! who do not see it, one font stack, and one palette, which has a light and a dark variant: the file
//! follows the page that shows it. No distinction depends on colour alone.
//!
//! ```
//! use forms_figures::{Axis, Numbers, Plot, Series};
//!
//! let plot = Plot {
//!     title: "Error against time".to_owned(),
//!     description: "The error falls as the inverse of the time.".to_owned(),
//!     x: Axis::logarithmic("time [s]").with_numbers(Numbers::Seconds),
//!     y: Axis::logarithmic("relative error [1]"),
//!     series: vec![Series::line("reported error", vec![[1e-3, 1e-1], [1e-2, 1e-2], [1e-1, 1e-3]])],
//!     ..Plot::default()
//! };
//! let svg = plot.svg();
//! assert!(svg.starts_with("<svg") && svg.contains("<title>Error against time</title>"));
//! assert!(svg.contains("prefers-color-scheme:dark") && svg.contains(">10 ms</text>"));
//! assert_eq!(svg, plot.svg());
//! ```

mod area;
mod axis;
mod bars;
mod canvas;
mod chart;
mod drawing;
mod heat_map;
mod mark;
mod mesh;
mod names;
mod plot;
mod text;
mod theme;
mod ticks;
pub mod vector;

pub use area::Area;
pub use axis::{Axis, Numbers, Scale};
pub use bars::{Bar, Bars};
pub use canvas::{Canvas, Pen};
pub use chart::Chart;
pub use drawing::{Drawing, View};
pub use heat_map::{ColourScale, HeatMap};
pub use mark::Mark;
pub use names::{Names, Place};
pub use plot::{Level, Line, Plot, Series};
pub use text::{Anchor, Style, width};
pub use theme::Colour;
