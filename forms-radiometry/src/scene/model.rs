//! Model of a scene: its geometry and materials, its receivers, and the required accuracy.

use super::cone::Cone;
use super::effect::ForcedEffect;
use super::environment_map::EnvironmentMap;
use super::place::Place;
use super::rough::Rough;
pub use super::shape::Shape;
use super::texture::Texture;
use crate::camera::Camera;
use crate::geometry::Vector;
use std::f64::consts::PI;

/// A scene whose parts are consistent: every index exists, every optical list has one number for
/// each band, every direction is a unit vector, and every medium that is entered is left.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The scene's name.
    pub name: String,
    /// The unit of every length in the scene.
    pub unit: LengthUnit,
    /// Wavelength bands; empty if the scene has a single, unnamed band.
    pub bands: Vec<Band>,
    /// Media, to which materials and the ambient refer by index.
    pub media: Vec<Medium>,
    /// Materials, to which surfaces refer by index.
    pub materials: Vec<Material>,
    /// Surfaces, in the order of the file.
    pub surfaces: Vec<Surface>,
    /// Point and distant lights, in the order of the file.
    pub lights: Vec<Light>,
    /// Receivers, in the order of the file.
    pub receivers: Vec<Receiver>,
    /// Surroundings of the surfaces.
    pub ambient: Ambient,
    /// Settings of the solver: accuracy and forced effects.
    pub solve: Solve,
    /// Descriptions of parts that are read in another way than they are written.
    pub notes: Vec<String>,
}

impl Scene {
    /// Returns the number of values of an optical quantity: one for each band, or a single one.
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
    /// The place of its name in the file.
    pub place: Place,
}

impl Medium {
    /// Whether the medium neither absorbs nor scatters: σₐ = σₛ = 0.
    pub fn is_clear(&self) -> bool {
        self.absorption.iter().chain(&self.scattering).all(|&coefficient| coefficient == 0.0)
    }

    /// Whether the medium has no effect on light: σₐ = σₛ = 0 and n = 1.
    pub fn is_vacuum(&self) -> bool {
        self.is_clear() && self.index.iter().all(|&index| index == 1.0)
    }
}

/// Optical behaviour of a surface.
#[derive(Clone, Debug)]
pub struct Material {
    /// Its name.
    pub name: String,
    /// The law of reflection, and of transmission.
    pub kind: MaterialKind,
    /// The place of its kind in the file.
    pub place: Place,
}

/// Laws of reflection and transmission. Optical lists have one number for each band.
#[derive(Clone, Debug, PartialEq)]
pub enum MaterialKind {
    /// Lambertian reflection: the same radiance in every direction.
    Diffuse {
        /// The fraction of the incident light that is reflected.
        reflectance: Vec<f64>,
    },
    /// Specular reflection by the same fraction at every angle.
    Mirror {
        /// The fraction of the incident light that is reflected.
        reflectance: Vec<f64>,
    },
    /// Fresnel reflection and refraction at the smooth boundary of a medium.
    Dielectric {
        /// The index of the medium behind the front.
        inside: usize,
    },
    /// Fresnel reflection at a smooth metal with the complex index η + ik.
    Conductor {
        /// Real part of the index.
        eta: Vec<f64>,
        /// Imaginary part of the index, not negative.
        k: Vec<f64>,
    },
    /// A diffuse base below a smooth coat. With Fresnel's reflectance F of the coat at the angles θᵢ
    /// and θₒ, specular reflection is F(θᵢ) times a factor, and the diffuse part of the
    /// bidirectional reflectance is (1 − F(θᵢ)) (1 − F(θₒ)) ρ/π.
    Plastic {
        /// ρ, with all reflections inside the coat, and both refractions.
        reflectance: Vec<f64>,
        /// Factor of the specular reflection, from 0 to 1.
        specular: Vec<f64>,
        /// Index of the coat relative to the medium in front of it, above 1.
        index: f64,
    },
    /// Reflection by the microfacets of a rough surface.
    Rough(Rough),
}

impl MaterialKind {
    /// Returns the diffuse reflectance in each band, or of a rough surface a bound on its reflectance;
    /// none if the material does not scatter light.
    pub(crate) fn diffuse_reflectance(&self) -> &[f64] {
        match self {
            Self::Diffuse { reflectance } | Self::Plastic { reflectance, .. } => reflectance,
            Self::Rough(rough) => &rough.albedo,
            Self::Mirror { .. } | Self::Dielectric { .. } | Self::Conductor { .. } => &[],
        }
    }

    /// Returns the reflectance in a band; `None` where it depends on the direction of light.
    pub(crate) fn reflectance_in(&self, band: usize) -> Option<f64> {
        match self {
            Self::Diffuse { reflectance } | Self::Mirror { reflectance } => Some(reflectance[band]),
            Self::Dielectric { .. } | Self::Conductor { .. } | Self::Plastic { .. } | Self::Rough(_) => None,
        }
    }
}

/// A surface: a shape with a material; it can emit light.
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
    /// The exitance in W/m², per band, from which the radiance was computed with rounding, if the
    /// file gives it. It is ignored in bands whose radiance was changed since then.
    pub exitance: Option<Vec<f64>>,
    /// Whether the back reflects and emits like the front. The back of a one-sided surface is
    /// black; such a surface occludes from both sides.
    pub two_sided: bool,
    /// The dependence of its reflectance on the place. The reflectance of the material is then the
    /// largest of any place.
    pub texture: Option<Texture>,
    /// The place of its shape in the file.
    pub place: Place,
}

impl Surface {
    /// Whether the surface emits light in any band.
    pub fn emits(&self) -> bool {
        self.radiance.iter().any(|&radiance| radiance > 0.0)
    }

    /// Returns the exitance in a band.
    pub(crate) fn exitance_in(&self, band: usize) -> f64 {
        self.exitance_of(band).unwrap_or(PI * self.radiance[band])
    }

    /// Returns the exitance in a band from which the radiance was computed, if the radiance is
    /// unchanged.
    pub(crate) fn exitance_of(&self, band: usize) -> Option<f64> {
        let exitance = *self.exitance.as_ref()?.get(band)?;
        (self.radiance.get(band) == Some(&(exitance / PI))).then_some(exitance)
    }
}

/// A light without extent.
#[derive(Clone, Debug)]
pub struct Light {
    /// Its name; can be empty.
    pub name: String,
    /// Position or direction, and emission.
    pub kind: LightKind,
    /// The cone of a spot light, which is a point light otherwise.
    pub cone: Option<Cone>,
    /// The place of its kind in the file.
    pub place: Place,
}

impl Light {
    /// Whether the light emits in some band.
    pub fn emits(&self) -> bool {
        let (LightKind::Point { intensity: emitted, .. } | LightKind::Distant { irradiance: emitted, .. }) =
            &self.kind;
        emitted.iter().any(|&value| value > 0.0)
    }
}

/// Kinds of lights without extent.
#[derive(Clone, Debug, PartialEq)]
pub enum LightKind {
    /// A point that emits the same intensity in every direction.
    Point {
        /// Its position.
        position: Vector,
        /// Intensity in W/sr, per band.
        intensity: Vec<f64>,
    },
    /// Parallel light from far away.
    Distant {
        /// The unit vector along which the light travels.
        direction: Vector,
        /// Irradiance of a plane perpendicular to the light, in W/m², per band.
        irradiance: Vec<f64>,
    },
}

/// A quantity to compute.
#[derive(Clone, Debug)]
pub struct Receiver {
    /// Its name.
    pub name: String,
    /// The quantity, and the place where it is computed.
    pub kind: ReceiverKind,
    /// Time resolution of the answer, if requested.
    pub time: Option<TimeBins>,
    /// The place of its kind in the file.
    pub place: Place,
}

/// Kinds of receivers.
#[derive(Clone, Debug, PartialEq)]
pub enum ReceiverKind {
    /// The irradiance at a point.
    Point {
        /// Position of the receiving surface element.
        position: Vector,
        /// Its unit normal, which points to the receiving side.
        normal: Vector,
    },
    /// The same at many points, or the scalar and vector irradiance at each of them.
    Points(Points),
    /// Mean irradiance and flux of a side of a surface.
    Surface {
        /// The index of the surface.
        surface: usize,
        /// The side that receives.
        side: SurfaceSide,
        /// Numbers of columns and rows of a map of its irradiance, if one is requested.
        grid: Option<[usize; 2]>,
    },
    /// Mean irradiance and net flux of each face of a side of a surface: a polygon is one face, a
    /// mesh has its own.
    Faces {
        /// The index of the surface.
        surface: usize,
        /// The side that receives.
        side: SurfaceSide,
    },
    /// The radiance that arrives at a point from one direction.
    Ray {
        /// The point, the origin of the viewing ray.
        origin: Vector,
        /// The unit vector along the viewing ray.
        direction: Vector,
    },
    /// A radiance image.
    Camera(Camera),
    /// Scalar irradiance (fluence rate) and vector irradiance at a point.
    Sphere {
        /// The point.
        position: Vector,
    },
}

/// A side of a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SurfaceSide {
    /// The side to which its normal points.
    #[default]
    Front,
    /// The opposite side.
    Back,
}

/// The points of one receiver, in the order of its results.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    /// Their positions.
    pub positions: Vec<Vector>,
    /// The unit normal at each of them, which points to the receiving side; `None` if they receive
    /// light from all sides.
    pub normals: Option<Vec<Vector>>,
    /// Numbers of columns and rows, if the points are the centres of the cells of a plane; rows of
    /// points follow each other.
    pub grid: Option<[usize; 2]>,
}

impl Points {
    /// Returns each position with its normal, if it has one.
    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = (Vector, Option<Vector>)> {
        let normal = |index: usize| self.normals.as_ref().and_then(|normals| normals.get(index)).copied();
        self.positions.iter().enumerate().map(move |(index, &position)| (position, normal(index)))
    }
}

/// Bins of time after the lights’ pulse.
#[derive(Clone, Debug)]
pub struct TimeBins {
    /// Start of the first bin, in seconds after the pulse.
    pub start: f64,
    /// Width of a bin, in seconds.
    pub width: f64,
    /// Number of bins.
    pub bins: usize,
    /// The place of the request in the file.
    pub place: Place,
}

/// Surroundings of the surfaces.
#[derive(Clone, Debug, Default)]
pub struct Ambient {
    /// The index of the medium that fills the scene outside all other media; vacuum if there is
    /// none.
    pub medium: Option<usize>,
    /// Radiance from outside in W/(m² sr), per band, the same from all directions; with a map, the
    /// largest from any direction.
    pub radiance: Vec<f64>,
    /// The dependence of this radiance on the direction, if it is not the same from all.
    pub map: Option<EnvironmentMap>,
    /// The place of the table in the file.
    pub place: Place,
}

/// Settings of the solver.
#[derive(Clone, Debug)]
pub struct Solve {
    /// The error tolerance, relative to the receiver’s answer. For a cell or a pixel, it is
    /// relative to the mean of its map or image, without the pixels that show an emitter directly,
    /// or to its own value if that is larger.
    pub tolerance: f64,
    /// The seed of the random numbers, if a solver needs any.
    pub seed: u64,
    /// The effects that are forced, in the order of [`Effect::ALL`](super::Effect::ALL); the solver decides about the
    /// others.
    pub forced: Vec<ForcedEffect>,
    /// The largest number of events along a path (reflections, refractions and scatterings of any
    /// kind), if the file limits it.
    pub events: Option<u32>,
}

impl Default for Solve {
    fn default() -> Self {
        Self { tolerance: 1e-3, seed: 1, forced: Vec::new(), events: None }
    }
}
