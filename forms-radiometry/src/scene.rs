//! Scenes: the text of a scene file is parsed, checked as a whole, and becomes a model or the list
//! of all its errors. [`not_simulated`] lists the requests of a model that the solver does not
//! support.

mod bands;
mod brightest_source;
mod cone;
mod division;
mod effect;
mod element;
mod environment_map;
mod error;
mod file;
mod known;
mod light;
mod material;
mod medium;
mod mesh_file;
mod mesh_keys;
mod microfacets;
mod midrange;
mod mitsuba;
mod model;
mod overlaps;
mod overrides;
mod place;
mod read;
mod receiver;
mod receiving;
mod regions;
mod rough;
mod round;
mod shape;
mod simulated;
mod solve;
mod sources;
mod subsurfaces;
mod surface;
mod texture;
mod value;
mod view3d;
mod words;
mod working_units;
mod xml;

pub(crate) use brightest_source::brightest_source;
pub use cone::Cone;
pub use division::Division;
pub use effect::{Effect, Force, ForcedEffect};
pub use environment_map::EnvironmentMap;
pub use error::SceneError;
pub use file::read_file;
pub(crate) use microfacets::RoughTransmittance;
pub use microfacets::{Distribution, Microfacets};
pub(crate) use midrange::middle;
pub use model::{
    Ambient, Band, LengthUnit, Light, LightKind, Material, MaterialKind, Medium, Points, Receiver,
    ReceiverKind, Scene, Shape, Solve, Surface, SurfaceSide, TimeBins,
};
pub use overrides::{EffectList, Overrides};
pub use place::Place;
pub use read::{open, read, read_with_files};
pub(crate) use regions::{FilledInterface, Filling, Piece, filled, sheets_without_edges};
pub use rough::{Facet, Rough};
pub use simulated::not_simulated;
pub use sources::Sources;
pub use texture::Texture;
pub(crate) use texture::{Pattern, TextureCoordinates};
pub(crate) use working_units::{WorkingScene, WorkingUnits};
