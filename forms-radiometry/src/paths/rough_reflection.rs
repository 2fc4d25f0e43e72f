//! Rough reflection: a ray meets a rough wall, which scatters its light by the lobes of its material.

use super::optics::{MediumOptics, Optics};
use super::rough_lobes::{RoughLobes, group};
use super::specialisation::Specialisation;
use super::tracer::{Path, Tracer};
use super::vertex::{Law, Vertex};
use super::world::World;
use crate::geometry::Vector;
use crate::sampling::Draws;
use crate::scene::MaterialKind;
use crate::visibility::Met;

impl World {
    /// Returns the lobes of a rough wall, with this medium in front of it, for the normal on the side
    /// of a ray and the vector to its origin. `None` if the wall is not rough, or seen from behind.
    pub(super) fn lobes<const N: usize>(
        &self,
        optics: &Optics<N>,
        medium: &MediumOptics<N>,
        met: &Met,
        directions: [Vector; 2],
    ) -> Option<RoughLobes<'_, N>> {
        let material = self.scene.surfaces[self.interfaces[met.wall].surface].material;
        let MaterialKind::Rough(rough) = &self.scene.materials[material].kind else { return None };
        let coat = self.rough_coats[material].as_deref();
        let base = self.textured(optics, met, &group(&rough.base, optics.bands, 0.0));
        RoughLobes::of((rough, coat), base, optics.bands, medium, directions)
    }
}

impl<L: Specialisation, const N: usize> Tracer<'_, L, N> {
    /// Applies the interaction of a rough wall to the path; returns whether the path continues.
    pub(super) fn roughened(
        &self,
        path: &mut Path<N>,
        met: &Met,
        medium: &MediumOptics<N>,
        (is_front, normal): (bool, Vector),
        draws: &mut Draws,
        add: &mut impl FnMut(&[f64; N], f64),
    ) -> bool {
        let lobes = self.world.lobes(&self.optics, medium, met, [normal, -path.direction]);
        let Some(lobes) = lobes.filter(|_| self.reflects_diffusely(path, met)) else { return false };
        let start = self.world.walls.start_on(met, is_front);
        self.scatters(path, &Vertex { start, law: Law::Rough(lobes) }, draws, add);
        true
    }
}
