//! Output files: the results of a simulation become the bytes of tables and pictures. Nothing is
//! written to disk here.
//!
//! ```text
//! Plan, Simulation, Map ─ notebook ─▶ their display in a notebook cell
//! Simulation ─┬─ csv ─▶ results.csv: every number, every cell of every map
//!             └─ Map ─┬─ exr ─▶ the values unchanged, one channel for each band
//!                     ├─ png ─▶ the map as a picture on a colour scale
//!                     └─ photograph ─▶ the map tone-mapped for the eye
//! Simulation, Scene ─ vtu ─▶ results on the geometry of receivers, the surfaces of the scene
//! ```
//! The pictures show a surface from its front, with the first edge of its polygon at the bottom:
//! the last row of a map is the first row of the picture.

mod csv;
mod digits;
mod exr;
mod names;
mod notebook;
mod photograph;
mod png;
mod vtu;

pub use csv::csv;
pub use digits::{measured, rough};
pub use exr::exr;
pub use names::file_names;
pub use photograph::photograph;
pub use png::{png, viridis};
pub use vtu::{scene_vtu, vtu};

use crate::answer::{Layout, Map};

/// Returns the cells of a map in picture order: row by row from the top.
fn from_above<'v, T>(map: &Map, values: &'v [T]) -> Vec<&'v [T]> {
    let mut rows: Vec<&[T]> = values.chunks_exact(map.size[0]).collect();
    if map.layout != Layout::Image {
        rows.reverse();
    }
    rows
}

/// Returns the sum over all bands for each cell.
fn total(map: &Map) -> Vec<f64> {
    (0..map.size[0] * map.size[1]).map(|cell| map.values.iter().map(|band| band[cell]).sum()).collect()
}
