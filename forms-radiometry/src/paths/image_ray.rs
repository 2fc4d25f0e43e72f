//! Rays from receivers to images of lights: what mirrors, boundaries and media leave of the light.

use super::boundary::Passage;
use super::mirror::reflected;
use super::optics::{MediumOptics, Optics, times};
use super::refraction::passages;
use super::world::World;
use crate::geometry::Vector;
use crate::scene::{Filling, MaterialKind};
use crate::visibility::{Met, Start};

/// A ray from a receiver to an image.
pub(super) struct Ray<const N: usize> {
    pub(super) start: Start,
    pub(super) direction: Vector,
    pub(super) filling: Filling,
    pub(super) left: f64,
    pub(super) factor: [f64; N],
    pub(super) optical_path_length: f64,
}

impl<const N: usize> Ray<N> {
    /// Passes through a medium up to the wall that the ray hits, or to the light.
    pub(super) fn passes(&mut self, medium: &MediumOptics<N>, met: Option<&Met>) {
        let length = met.map_or(self.left, |met| met.distance);
        self.factor = times(&self.factor, &medium.transmittance(length));
        self.optical_path_length += medium.index * length;
        self.left -= length;
    }

    /// Reflects or refracts the ray as the step requires. The factors of boundaries for parallel
    /// light are already part of the image; the reflectance of a metal for a point light is known
    /// only here.
    pub(super) fn turn(
        &mut self,
        world: &World,
        optics: &Optics<N>,
        met: &Met,
        is_bent: bool,
        beyond: Filling,
    ) -> Option<()> {
        let normal = if met.is_front { met.normal } else { -met.normal };
        let material = world.material(met.wall);
        let medium = optics.medium(self.filling);
        let direction = if let MaterialKind::Dielectric { .. } = material {
            let [reflected, refracted] = passages([&medium, &optics.medium(beyond)], self.direction, normal);
            let (_, passage) = if is_bent { refracted? } else { reflected? };
            match passage {
                Passage::Reflected(direction, _) | Passage::Refracted(direction, _) => direction,
            }
        } else {
            let Passage::Reflected(direction, factor) =
                reflected(material, optics, &medium, self.direction, normal)
            else {
                return None;
            };
            if self.left.is_finite() && matches!(material, MaterialKind::Conductor { .. }) {
                self.factor = times(&self.factor, &factor);
            }
            direction
        };
        self.direction = direction;
        self.start = world.walls.start_on(met, met.is_front != is_bent);
        if is_bent {
            self.filling = beyond;
        }
        Some(())
    }
}
