//! The model of a scene: what is there, and what is asked for.

use crate::camera::Camera;
use crate::geometry::{Polygon, Vector};

/// A scene whose parts refer to each other rightly: every material index exists, every optical list has one
/// number a band, and every normal is a unit vector.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The scene's name.
    pub name: String,
    /// The unit of every length in the scene.
    pub unit: LengthUnit,
    /// Wavelength bands; none where the scene has a single, unnamed one.
    pub bands: Vec<Band>,
    /// Materials, which surfaces refer to by index.
    pub materials: Vec<Material>,
    /// Surfaces, in the order of the file.
    pub surfaces: Vec<Surface>,
    /// What is asked for, in the order of the file.
    pub receivers: Vec<Receiver>,
}

impl Scene {
    /// How many values an optical quantity has: one a band, or a single one.
    pub fn band_count(&self) -> usize {
        self.bands.len().max(1)
    }
}

/// The unit of lengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LengthUnit {
    /// Metres.
    Metre,
    /// Centimetres.
    Centimetre,
    /// Millimetres.
    Millimetre,
}

/// A band of wavelengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Lower end, in nm.
    pub low: f64,
    /// Upper end, in nm.
    pub high: f64,
}

/// A diffuse material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name.
    pub name: String,
    /// The fraction of the incident light that is reflected, per band.
    pub reflectance: Vec<f64>,
}

/// A surface: a polygon of some material, which may emit light.
#[derive(Clone, Debug)]
pub struct Surface {
    /// Its name.
    pub name: String,
    /// The index of its material in the scene.
    pub material: usize,
    /// Its shape.
    pub polygon: Polygon,
    /// Emitted radiance in W/(m² sr), per band; the same in all directions.
    pub radiance: Vec<f64>,
    /// Whether the back reflects and emits as the front does. A one-sided surface is black from behind; it
    /// hides what is behind it from either side.
    pub two_sided: bool,
}

impl Surface {
    /// Whether the surface emits light in any band.
    pub fn emits(&self) -> bool {
        self.radiance.iter().any(|&radiance| radiance > 0.0)
    }
}

/// Something asked for.
#[derive(Clone, Debug)]
pub enum Receiver {
    /// The irradiance at a point.
    Point(PointReceiver),
    /// A picture.
    Camera(Camera),
}

impl Receiver {
    /// The receiver's name.
    pub fn name(&self) -> &str {
        match self {
            Self::Point(point) => &point.name,
            Self::Camera(camera) => &camera.name,
        }
    }
}

/// A point whose irradiance is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct PointReceiver {
    /// Its name.
    pub name: String,
    /// Where it is.
    pub position: Vector,
    /// The unit normal of the receiving element, which points to the side that receives.
    pub normal: Vector,
}
