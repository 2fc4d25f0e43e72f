//! The model of a scene: what is there, what is asked for, and how exactly.

use super::place::Place;
use crate::camera::Camera;
use crate::geometry::{Disk, Mesh, Polygon, Round, Sphere, Vector};
use std::f64::consts::PI;
use std::sync::Arc;

/// A scene whose parts refer to each other rightly: every index exists, every optical list has one number a
/// band, every direction is a unit vector, and every medium that is entered is left.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The scene's name.
    pub name: String,
    /// The unit of every length in the scene.
    pub unit: LengthUnit,
    /// Wavelength bands; none where the scene has a single, unnamed one.
    pub bands: Vec<Band>,
    /// Media, which materials and the ambient refer to by index.
    pub media: Vec<Medium>,
    /// Materials, which surfaces refer to by index.
    pub materials: Vec<Material>,
    /// Surfaces, in the order of the file.
    pub surfaces: Vec<Surface>,
    /// Point and distant lights, in the order of the file.
    pub lights: Vec<Light>,
    /// What is asked for, in the order of the file.
    pub receivers: Vec<Receiver>,
    /// What surrounds the surfaces.
    pub ambient: Ambient,
    /// How exactly, and with which effects.
    pub solve: Solve,
}

impl Scene {
    /// How many values an optical quantity has: one a band, or a single one.
    pub fn band_count(&self) -> usize {
        self.bands.len().max(1)
    }

    /// Whether light from far away arrives in this band: an ambient medium that absorbs or scatters leaves nothing of it.
    pub(crate) fn is_lit_from_afar(&self, band: usize) -> bool {
        let is_clear = |medium: &Medium| medium.absorption[band] == 0.0 && medium.scattering[band] == 0.0;
        self.ambient.medium.is_none_or(|medium| is_clear(&self.media[medium]))
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

/// A homogeneous medium.
#[derive(Clone, Debug)]
pub struct Medium {
    /// Its name.
    pub name: String,
    /// Absorption coefficient σₐ per unit of length, per band.
    pub absorption: Vec<f64>,
    /// Scattering coefficient σₛ per unit of length, per band.
    pub scattering: Vec<f64>,
    /// Mean cosine g of the Henyey–Greenstein phase function, per band.
    pub asymmetry: Vec<f64>,
    /// Refractive index n, per band.
    pub index: Vec<f64>,
    /// Where the file names it.
    pub place: Place,
}

impl Medium {
    /// Whether it neither absorbs nor scatters: σₐ = σₛ = 0.
    pub fn is_clear(&self) -> bool {
        self.absorption.iter().chain(&self.scattering).all(|&coefficient| coefficient == 0.0)
    }

    /// Whether it is, for light, nothing: σₐ = σₛ = 0 and n = 1.
    pub fn is_vacuum(&self) -> bool {
        self.is_clear() && self.index.iter().all(|&index| index == 1.0)
    }
}

/// What a surface does with light.
#[derive(Clone, Debug)]
pub struct Material {
    /// Its name.
    pub name: String,
    /// The law of reflection, and of transmission.
    pub kind: MaterialKind,
    /// Where the file says its kind.
    pub place: Place,
}

/// Laws of reflection and transmission. Optical lists have one number a band.
#[derive(Clone, Debug, PartialEq)]
pub enum MaterialKind {
    /// Lambert’s: the same radiance in every direction.
    Diffuse {
        /// The fraction of the incident light that is reflected.
        reflectance: Vec<f64>,
    },
    /// The same fraction at every angle, in the direction of the mirror image.
    Mirror {
        /// The fraction of the incident light that is reflected.
        reflectance: Vec<f64>,
    },
    /// Fresnel’s, at a smooth boundary of a medium.
    Dielectric {
        /// The index of the medium behind the front.
        inside: usize,
    },
    /// Fresnel’s, at a smooth metal of complex index η + ik.
    Conductor {
        /// Real part of the index.
        eta: Vec<f64>,
        /// Imaginary part of the index, not negative.
        k: Vec<f64>,
    },
}

/// A surface: a shape of some material, which may emit light.
#[derive(Clone, Debug)]
pub struct Surface {
    /// Its name.
    pub name: String,
    /// The index of its material in the scene.
    pub material: usize,
    /// Its shape.
    pub shape: Shape,
    /// Emitted radiance in W/(m² sr), per band; the same in all directions.
    pub radiance: Vec<f64>,
    /// The exitance in W/m², per band, that the radiance was rounded from, if the file gives that. Where the radiance is another one by now, it
    /// does not count.
    pub exitance: Option<Vec<f64>>,
    /// Whether the back reflects and emits as the front does. A one-sided surface is black from behind; it
    /// hides what is behind it from either side.
    pub two_sided: bool,
    /// Where the file says its shape.
    pub place: Place,
}

impl Surface {
    /// Whether the surface emits light in any band.
    pub fn emits(&self) -> bool {
        self.radiance.iter().any(|&radiance| radiance > 0.0)
    }

    /// The exitance in a band that the radiance was rounded from, if it was.
    pub(crate) fn exitance_of(&self, band: usize) -> Option<f64> {
        let exitance = *self.exitance.as_ref()?.get(band)?;
        (self.radiance.get(band) == Some(&(exitance / PI))).then_some(exitance)
    }
}

/// What a surface looks like.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A planar polygon.
    Polygon(Polygon),
    /// Planar polygons. Surfaces that name one file share it.
    Mesh(Arc<Mesh>),
    /// A sphere.
    Sphere(Sphere),
    /// A disk.
    Disk(Disk),
}

impl Shape {
    /// Whether it is curved, or has a curved border.
    pub(crate) fn is_round(&self) -> bool {
        self.as_round().is_some()
    }

    /// The shape that is curved, or has a curved border, if it does.
    pub(crate) fn as_round(&self) -> Option<&dyn Round> {
        match self {
            Self::Sphere(sphere) => Some(sphere),
            Self::Disk(disk) => Some(disk),
            Self::Polygon(_) | Self::Mesh(_) => None,
        }
    }

    /// The polygon, if it is one.
    pub fn as_polygon(&self) -> Option<&Polygon> {
        match self {
            Self::Polygon(polygon) => Some(polygon),
            Self::Mesh(_) | Self::Sphere(_) | Self::Disk(_) => None,
        }
    }
}

/// A light without extent.
#[derive(Clone, Debug)]
pub struct Light {
    /// Its name; may be empty.
    pub name: String,
    /// Where it is and what it emits.
    pub kind: LightKind,
    /// Where the file says its kind.
    pub place: Place,
}

impl Light {
    /// Whether it emits in some band.
    pub fn emits(&self) -> bool {
        let (LightKind::Point { intensity: emitted, .. } | LightKind::Distant { irradiance: emitted, .. }) =
            &self.kind;
        emitted.iter().any(|&value| value > 0.0)
    }
}

/// Kinds of lights without extent.
#[derive(Clone, Debug, PartialEq)]
pub enum LightKind {
    /// A point that sends the same intensity in every direction.
    Point {
        /// Where it is.
        position: Vector,
        /// Intensity in W/sr, per band.
        intensity: Vec<f64>,
    },
    /// Parallel light from far away.
    Distant {
        /// The unit vector along which the light travels.
        direction: Vector,
        /// Irradiance of a plane that faces it, in W/m², per band.
        irradiance: Vec<f64>,
    },
}

/// Something asked for.
#[derive(Clone, Debug)]
pub struct Receiver {
    /// Its name.
    pub name: String,
    /// What is asked for, and where.
    pub kind: ReceiverKind,
    /// How the answer is resolved in time, if it is.
    pub time: Option<TimeBins>,
    /// Where the file says its kind.
    pub place: Place,
}

/// Kinds of questions.
#[derive(Clone, Debug, PartialEq)]
pub enum ReceiverKind {
    /// The irradiance at a point.
    Point {
        /// Where the receiving element is.
        position: Vector,
        /// Its unit normal, which points to the side that receives.
        normal: Vector,
    },
    /// Mean irradiance and flux of a surface.
    Surface {
        /// The index of the surface.
        surface: usize,
        /// How many columns and rows a map of its irradiance has, if one is asked for.
        grid: Option<[usize; 2]>,
    },
    /// The radiance that arrives at a point from where it looks.
    Ray {
        /// Where it starts.
        origin: Vector,
        /// The unit vector along which it looks.
        direction: Vector,
    },
    /// A radiance image.
    Camera(Camera),
    /// Scalar irradiance (fluence rate) and vector irradiance at a point.
    Sphere {
        /// Where the point is.
        position: Vector,
    },
}

/// Bins of time after the lights’ pulse.
#[derive(Clone, Debug)]
pub struct TimeBins {
    /// When the first bin begins, in seconds after the pulse.
    pub start: f64,
    /// The width of one bin, in seconds.
    pub width: f64,
    /// How many bins there are.
    pub bins: usize,
    /// Where the file asks for them.
    pub place: Place,
}

/// What surrounds the surfaces.
#[derive(Clone, Debug, Default)]
pub struct Ambient {
    /// The index of the medium that fills the scene wherever no other is entered; vacuum if there is none.
    pub medium: Option<usize>,
    /// Radiance from outside in W/(m² sr), per band, the same from all directions.
    pub radiance: Vec<f64>,
    /// Where the file speaks of it.
    pub place: Place,
}

/// What is asked of a solver.
#[derive(Clone, Debug)]
pub struct Solve {
    /// The error to stay within, relative to the receiver’s answer; of a cell or a pixel, to the mean of its
    /// map or image without what shows an emitter directly, or to its own value if that is larger.
    pub tolerance: f64,
    /// The seed of random numbers, where a solver needs any.
    pub seed: u64,
    /// The effects that are forced, in the order of [`Effect::ALL`]; about others the solver decides.
    pub forced: Vec<ForcedEffect>,
}

impl Default for Solve {
    fn default() -> Self {
        Self { tolerance: 1e-3, seed: 1, forced: Vec::new() }
    }
}

/// An effect that the scene file turns on or off.
#[derive(Clone, Debug)]
pub struct ForcedEffect {
    /// Which one.
    pub effect: Effect,
    /// How.
    pub force: Force,
    /// Where the file says so.
    pub place: Place,
}

/// How an effect is forced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Force {
    /// Simulated in full.
    On,
    /// Left out.
    Off,
    /// Simulated up to this order, at least 1.
    Orders(u32),
}

/// What light may do in a scene, and can be forced to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// Light from emitters as it comes.
    Direct,
    /// What hides a light.
    Occlusion,
    /// Diffuse reflection from surface to surface.
    Interreflection,
    /// Specular reflection.
    Mirror,
    /// Absorption by media.
    Absorption,
    /// Scattering by media.
    Scattering,
    /// Refraction between media, with the factor n² of radiance.
    Refraction,
    /// Optical numbers that differ from band to band.
    Bands,
    /// Refractive indices that differ from band to band.
    Dispersion,
    /// The time that light takes.
    Time,
}

impl Effect {
    /// All effects, with their names in scene files.
    pub const ALL: [(&'static str, Self); 10] = [
        ("direct", Self::Direct),
        ("occlusion", Self::Occlusion),
        ("interreflection", Self::Interreflection),
        ("mirror", Self::Mirror),
        ("absorption", Self::Absorption),
        ("scattering", Self::Scattering),
        ("refraction", Self::Refraction),
        ("bands", Self::Bands),
        ("dispersion", Self::Dispersion),
        ("time", Self::Time),
    ];

    /// Its name in scene files.
    pub fn name(self) -> &'static str {
        let named = Self::ALL.iter().find(|(_, effect)| *effect == self);
        named.map_or("", |(name, _)| name)
    }

    /// Whether there are orders of it: light takes part in it several times.
    pub fn has_orders(self) -> bool {
        matches!(self, Self::Interreflection | Self::Scattering)
    }
}
