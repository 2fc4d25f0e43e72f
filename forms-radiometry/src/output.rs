//! Files: what a simulation found becomes the bytes of tables and pictures. Nothing is written to a disk here.
//!
//! ```text
//! Plan, Simulation, Map ─ notebook ─▶ what a cell of a notebook shows of them
//! Simulation ─┬─ csv ─▶ results.csv: every number, every cell of every map
//!             └─ Map ─┬─ exr ─▶ the values as they are, a channel for each band
//!                     ├─ png ─▶ a map as a picture on a scale of colours
//!                     └─ photograph ─▶ an image as the eye would see it
//! ```
//! The pictures show a surface as it is seen from its front, with the first edge of its polygon below: the last row of
//! a map is the first one of a picture.

mod csv;
mod digits;
mod exr;
mod names;
mod notebook;
mod photograph;
mod png;

pub use csv::csv;
pub use digits::{measured, rough};
pub use exr::exr;
pub use names::file_names;
pub use photograph::photograph;
pub use png::{png, viridis};

use crate::simulation::Map;

/// The cells of a map in the order of a picture: row by row from above.
fn from_above<'v, T>(map: &Map, values: &'v [T]) -> Vec<&'v [T]> {
    let mut rows: Vec<&[T]> = values.chunks_exact(map.size[0]).collect();
    if !map.is_image {
        rows.reverse();
    }
    rows
}

/// For each cell the sum of all bands.
fn total(map: &Map) -> Vec<f64> {
    (0..map.size[0] * map.size[1]).map(|cell| map.values.iter().map(|band| band[cell]).sum()).collect()
}
