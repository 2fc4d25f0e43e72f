//! Scenes: the text of a scene file is read, checked as a whole, and becomes a model, or the list of all that
//! is wrong with it.

mod element;
mod error;
mod model;
mod read;
mod receiver;
mod solve;
mod surface;
mod value;

pub use error::SceneError;
pub use model::{Band, LengthUnit, Material, PointReceiver, Receiver, Scene, Surface};
pub use read::read;
