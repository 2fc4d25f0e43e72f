//! Radiometry on proved kernels.

pub mod camera;
pub mod geometry;
pub mod irradiance;
pub mod kernels;
pub mod picture;
pub mod scene;
mod sight;
mod spectrum;
mod tone;

pub use irradiance::{ReceiverResult, simulate_direct};
pub use picture::{Picture, picture};

/// The scene file of the Cornell box, as measured at the Cornell University Program of Computer Graphics.
pub const CORNELL_BOX: &str = include_str!("../scenes/cornell_box.toml");
