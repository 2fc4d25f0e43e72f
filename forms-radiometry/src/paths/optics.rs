//! Optics: the optical data of a scene in a group of bands that share their paths.

use crate::geometry::Vector;
use crate::scene::{EnvironmentMap, Filling, LightKind, MaterialKind, Scene};

/// Optical data of N bands. The last bands can be unused; they are zero.
pub(super) struct Optics<const N: usize> {
    media: Vec<MediumOptics<N>>,
    /// For each surface: the emitted radiance, and the reflectance of its material if that is a
    /// number, or a bound on it if the material is rough.
    pub(super) radiances: Vec<[f64; N]>,
    pub(super) reflectances: Vec<[f64; N]>,
    /// For each light: intensity or irradiance.
    pub(super) beams: Vec<[f64; N]>,
    /// The radiance from outside: with a map, the largest from any direction.
    pub(super) brightest_outside: [f64; N],
    map: Option<EnvironmentMap>,
    /// The first band, and the number of bands.
    pub(super) bands: [usize; 2],
}

/// A medium in these bands.
#[derive(Clone, Copy, Debug)]
pub(super) struct MediumOptics<const N: usize> {
    pub(super) scattering: [f64; N],
    pub(super) extinction: [f64; N],
    pub(super) asymmetry: [f64; N],
    /// Refractive index, common to all bands that share their paths.
    pub(super) index: f64,
}

impl<const N: usize> MediumOptics<N> {
    const VACUUM: Self = Self { scattering: [0.0; N], extinction: [0.0; N], asymmetry: [0.0; N], index: 1.0 };

    pub(super) fn scatters(&self) -> bool {
        self.scattering.iter().any(|&scattering| scattering > 0.0)
    }

    /// Whether the medium scatters without absorption in some band.
    pub(super) fn is_conservative(&self) -> bool {
        let mut both = self.scattering.iter().zip(&self.extinction);
        both.any(|(&scattering, &extinction)| scattering > 0.0 && scattering == extinction)
    }
}

impl<const N: usize> Optics<N> {
    /// Returns the optical data of `count` bands from `first` on; there are at most N.
    pub(super) fn of(scene: &Scene, first: usize, count: usize) -> Self {
        let group = |values: &[f64]| {
            std::array::from_fn(|band| if band < count { values[first + band] } else { 0.0 })
        };
        let medium = |medium: &crate::scene::Medium| {
            let (absorption, scattering) = (group(&medium.absorption), group(&medium.scattering));
            MediumOptics {
                scattering,
                extinction: std::array::from_fn(|band| absorption[band] + scattering[band]),
                asymmetry: group(&medium.asymmetry),
                index: medium.index[first],
            }
        };
        let reflectance = |surface: &crate::scene::Surface| match &scene.materials[surface.material].kind {
            MaterialKind::Diffuse { reflectance }
            | MaterialKind::Mirror { reflectance }
            | MaterialKind::Plastic { reflectance, .. } => group(reflectance),
            MaterialKind::Rough(rough) => group(&rough.albedo),
            MaterialKind::Dielectric { .. } | MaterialKind::Conductor { .. } => [0.0; N],
        };
        let beam = |light: &crate::scene::Light| match &light.kind {
            LightKind::Point { intensity, .. } => group(intensity),
            LightKind::Distant { irradiance, .. } => group(irradiance),
        };
        Self {
            media: scene.media.iter().map(medium).collect(),
            radiances: scene.surfaces.iter().map(|surface| group(&surface.radiance)).collect(),
            reflectances: scene.surfaces.iter().map(reflectance).collect(),
            beams: scene.lights.iter().map(beam).collect(),
            brightest_outside: group(&scene.ambient.radiance),
            map: scene.ambient.map.clone(),
            bands: [first, count],
        }
    }

    pub(super) fn medium(&self, filling: Filling) -> MediumOptics<N> {
        filling.map_or(MediumOptics::VACUUM, |medium| self.media[medium])
    }

    /// Returns the radiance from outside that arrives against a direction, in which it is seen.
    pub(super) fn outside(&self, direction: Vector) -> [f64; N] {
        let Some(map) = &self.map else { return self.brightest_outside };
        let (lookup, [first, count]) = (map.lookup(direction), self.bands);
        std::array::from_fn(|band| match band < count {
            true => self.brightest_outside[band] * map.value(&lookup, first + band),
            false => 0.0,
        })
    }

    /// Returns the smallest and the largest refractive index of vacuum and all media.
    pub(super) fn indices(&self) -> [f64; 2] {
        let indices = self.media.iter().map(|medium| medium.index);
        indices.fold([1.0, 1.0], |[least, most]: [f64; 2], index| [least.min(index), most.max(index)])
    }

    /// Whether light passes between two media without refraction or reflection.
    pub(super) fn is_clear(&self, one: Filling, other: Filling) -> bool {
        self.medium(one).index == self.medium(other).index
    }
}

/// Returns the product, band by band.
pub(super) fn times<const N: usize>(a: &[f64; N], b: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|band| a[band] * b[band])
}

pub(super) fn scaled<const N: usize>(factor: f64, a: &[f64; N]) -> [f64; N] {
    a.map(|value| factor * value)
}

/// Returns the mean of the first `count` bands.
pub(super) fn mean<const N: usize>(values: &[f64; N], count: usize) -> f64 {
    values[..count].iter().sum::<f64>() / count as f64
}

pub(super) fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}
