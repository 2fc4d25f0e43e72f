//! Radiometry of scenes: the text of a scene file becomes a [`Scene`](scene::Scene), its lamps and what
//! stands before them become form factors, and these become the irradiance of receivers or a picture.
//!
//! What is computed is direct light from Lambertian polygons, with occlusion, exactly: the only error is
//! rounding. Scenes may say more than that ([`scene`]); what is not simulated yet is refused with its place.
//!
//! ```
//! let scene = forms_radiometry::scene::read(forms_radiometry::CORNELL_BOX, "cornell_box.toml").unwrap();
//! let results = forms_radiometry::simulate_direct(&scene).unwrap();
//! let total: f64 = results[2].irradiance.iter().sum();
//! assert_eq!(results[2].receiver, "short_top_centre");
//! assert!((total - 11.468_003).abs() < 1e-6, "W/m²");
//! ```

pub mod camera;
mod faces;
pub mod geometry;
pub mod irradiance;
pub mod kernels;
mod library;
pub mod output;
pub mod picture;
pub mod scene;
mod sight;
pub mod simulation;
mod spectrum;
mod tone;
mod view_factors;

pub use irradiance::{ReceiverResult, simulate_direct};
pub use library::{RADIANCE, TheoryFile, library, theory};
pub use picture::{Picture, picture};
pub use view_factors::{ViewFactor, ViewFactors, view_factors};

/// The scene file of the Cornell box, as measured at the Cornell University Program of Computer Graphics.
pub const CORNELL_BOX: &str = include_str!("../scenes/cornell_box.toml");
