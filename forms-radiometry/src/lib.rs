//! Radiometry of scenes. A scene file is parsed into a [`Scene`](scene::Scene); a plan selects the
//! light-transport effects that the scene needs; the simulation returns the quantity at each
//! receiver with its error ([`simulation`]).
//!
//! Nearly everything that a scene file can describe is simulated: diffuse, reflecting and
//! refracting surfaces, media, bands and time. [`scene::not_simulated`] lists the exceptions. A
//! scene that requests one is rejected, with the place of each request.
//!
//! ```
//! use forms_radiometry::{scene, simulation};
//!
//! // in a closed room whose walls all shine, every radiance is Lₑ/(1 − ρ)
//! let room = r#"
//!     [[material]]
//!     name = "grey"
//!     kind = "diffuse"
//!     reflectance = 0.5
//!     [[surface]]
//!     name = "shell"
//!     material = "grey"
//!     sphere = { center = [0, 0, 0], radius = 2, inward = true }
//!     radiance = 3
//!     [[receiver]]
//!     name = "sight"
//!     kind = "ray"
//!     origin = [0, 0, 0]
//!     direction = [1, 2, 3]
//!     [solve]
//!     tolerance = 0.5
//! "#;
//! let scene = scene::read(room, "room.toml").unwrap();
//! let plan = simulation::plan(&scene).unwrap();
//! let found = simulation::simulate(&plan, &simulation::Unwatched);
//! assert!((found.answers[0].value - 6.0).abs() <= found.answers[0].error);
//! ```

mod answer;
pub mod camera;
mod checkpoint;
mod effects;
mod extinction;
mod faces;
pub mod form_factor;
pub mod geometry;
mod job;
pub mod output;
mod parallelism;
mod paths;
mod plan;
mod progress;
mod radiosity;
mod sampling;
pub mod scene;
pub mod simulation;
mod spectrum;
mod tone;
mod used_kernel;
mod view_factors;
mod visibility;
mod watch;

pub use view_factors::{Enclosed, NotEnclosed, Row, Rows, ViewFactor, ViewFactors, view_factors};

/// The scene file of the Cornell box, as measured at the Cornell University Program of Computer
/// Graphics.
pub const CORNELL_BOX: &str = include_str!("../scenes/cornell_box.toml");
