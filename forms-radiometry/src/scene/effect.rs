//! Effects of light transport, and how a scene file forces them.

use super::place::Place;

/// An effect that the scene file turns on or off.
#[derive(Clone, Debug)]
pub struct ForcedEffect {
    /// The effect.
    pub effect: Effect,
    /// Whether it is on, off or limited.
    pub force: Force,
    /// The place in the file.
    pub place: Place,
}

/// Setting of a forced effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Force {
    /// Simulated in full.
    On,
    /// Omitted.
    Off,
    /// Simulated up to this order, at least 1.
    Orders(u32),
}

/// A light-transport effect that can be forced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// Direct light from emitters.
    Direct,
    /// Occlusion of lights.
    Occlusion,
    /// Diffuse interreflection between surfaces.
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
    /// Travel time of light.
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

    /// Returns the name in scene files.
    pub fn name(self) -> &'static str {
        let named = Self::ALL.iter().find(|(_, effect)| *effect == self);
        named.map_or("", |(name, _)| name)
    }

    /// Whether the effect has orders: a path can contain it several times.
    pub fn has_orders(self) -> bool {
        matches!(self, Self::Interreflection | Self::Scattering)
    }
}
