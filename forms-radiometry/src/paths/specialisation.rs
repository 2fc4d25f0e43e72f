//! Specialisations by effects: the path tracer of a scene contains no code for effects that the
//! scene lacks.
//!
//! A specialisation is a type, a member of the lattice, and its effects are constants of that type.
//! Every member is compiled ahead of time, and a scene takes its own from a table when it is
//! loaded.

use super::follow::Follow;
use super::image_sources::Images;
use super::optics::Optics;
use super::tracer::{Limits, Tracer};
use super::world::World;
use crate::sampling::SHARED;
use crate::scene::{Filling, MaterialKind, Scene};
use std::marker::PhantomData;
use std::ops::BitOr;

/// Effects that a specialisation contains.
pub(crate) trait Lattice: Sync + Send {
    const ABSORPTION: bool;
    const SCATTERING: bool;
    const MIRROR: bool;
    const REFRACTION: bool;
    const TIME: bool;
}

/// A member of the lattice.
struct Member<
    const ABSORPTION: bool,
    const SCATTERING: bool,
    const MIRROR: bool,
    const REFRACTION: bool,
    const TIME: bool,
>;

impl<const A: bool, const S: bool, const M: bool, const R: bool, const T: bool> Lattice
    for Member<A, S, M, R, T>
{
    const ABSORPTION: bool = A;
    const SCATTERING: bool = S;
    const MIRROR: bool = M;
    const REFRACTION: bool = R;
    const TIME: bool = T;
}

/// The effects that a scene contains.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Effects {
    pub(crate) absorption: bool,
    pub(crate) scattering: bool,
    pub(crate) mirror: bool,
    pub(crate) refraction: bool,
    pub(crate) dispersion: bool,
    pub(crate) time: bool,
}

impl Effects {
    /// Returns the effects of a scene: those of the materials of its surfaces, and of the media
    /// that fill any part of it.
    pub(crate) fn of(scene: &Scene) -> Self {
        let materials = || scene.surfaces.iter().map(|surface| &scene.materials[surface.material].kind);
        let inside = materials().filter_map(|kind| match kind {
            MaterialKind::Dielectric { inside } => Some(Some(*inside)),
            _ => None,
        });
        let fillings: Vec<Filling> = inside.chain([scene.ambient.medium]).collect();
        let media = || fillings.iter().flatten().map(|&medium| &scene.media[medium]);
        let any = |values: &[f64]| values.iter().any(|&value| value > 0.0);
        let index = |filling: &Filling| filling.map_or(&[1.0][..], |medium| &scene.media[medium].index);
        let differs = |a: &Filling| {
            (0..scene.band_count()).any(|band| {
                let of = |filling: &Filling| *index(filling).get(band).unwrap_or(&1.0);
                of(a) != of(&scene.ambient.medium)
            })
        };
        let refraction = fillings.iter().any(differs);
        let has_spread = |values: &[f64]| values.iter().any(|value| *value != values[0]);
        Self {
            absorption: media().any(|medium| any(&medium.absorption)),
            scattering: media().any(|medium| any(&medium.scattering)),
            mirror: materials()
                .any(|kind| matches!(kind, MaterialKind::Mirror { .. } | MaterialKind::Conductor { .. })),
            refraction,
            // also for one medium everywhere: metals in it reflect by their index relative to the
            // medium, and light takes the time n d/c
            dispersion: media().any(|medium| has_spread(&medium.index)),
            time: scene.receivers.iter().any(|receiver| receiver.time.is_some()),
        }
    }
}

impl BitOr for Effects {
    type Output = Self;

    /// Returns the effects of either.
    fn bitor(self, other: Self) -> Self {
        Self {
            absorption: self.absorption | other.absorption,
            scattering: self.scattering | other.scattering,
            mirror: self.mirror | other.mirror,
            refraction: self.refraction | other.refraction,
            dispersion: self.dispersion | other.dispersion,
            time: self.time | other.time,
        }
    }
}

/// Returns the path tracers of a world, one for each group of bands that share paths.
pub(crate) fn follower<'w>(
    world: &'w World<'w>,
    effects: Effects,
    limits: Limits,
) -> Vec<Box<dyn Follow + 'w>> {
    let member = |[first, count]: [usize; 2]| match count {
        1 => member::<1>(world, effects, limits, first, count),
        _ => member::<SHARED>(world, effects, limits, first, count),
    };
    groups(world.scene, effects).into_iter().map(member).collect()
}

/// Returns the first band and the number of bands of each group that shares its paths: neighbouring
/// bands that scatter alike. With dispersion each band is a group of its own.
fn groups(scene: &Scene, effects: Effects) -> Vec<[usize; 2]> {
    let mut groups: Vec<[usize; 2]> = Vec::new();
    for band in 0..scene.band_count() {
        let shares = |[first, count]: [usize; 2]| {
            count < SHARED && !effects.dispersion && scatter_alike(scene, first, band)
        };
        match groups.last_mut() {
            Some(group) if shares(*group) => group[1] += 1,
            _ => groups.push([band, 1]),
        }
    }
    groups
}

/// Whether paths sampled by the scattering law of one band are equally likely in another band. If
/// they are not, each scattering multiplies the throughput in one of the bands by more than 1, and
/// after many scatterings very few paths carry all of the light.
fn scatter_alike(scene: &Scene, one: usize, other: usize) -> bool {
    let mut scattering =
        scene.media.iter().filter(|medium| medium.scattering.iter().any(|&scattering| scattering > 0.0));
    scattering.all(|medium| {
        let law = |band: usize| [medium.absorption[band] + medium.scattering[band], medium.asymmetry[band]];
        law(one) == law(other)
    })
}

/// Whether the lights have more image sources in flat walls than can be listed.
pub(crate) fn has_too_many_images(world: &World) -> bool {
    let scene = world.scene;
    !scene.lights.is_empty()
        && (0..scene.band_count()).any(|band| Images::of(world, &Optics::<1>::of(scene, band, 1)).is_cut)
}

/// Returns the path tracer that is specialised for these effects.
fn member<'w, const N: usize>(
    world: &'w World<'w>,
    effects: Effects,
    limits: Limits,
    first: usize,
    count: usize,
) -> Box<dyn Follow + 'w> {
    let optics = Optics::<N>::of(world.scene, first, count);
    let images = Images::of(world, &optics);
    macro_rules! choose {
        ([$($chosen:literal),*]) => {
            Box::new(Tracer::<Member<$($chosen),*>, N> { world, optics, images, limits, effects: PhantomData })
        };
        ([$($chosen:literal),*] $is_on:expr $(, $rest:expr)*) => {
            if $is_on { choose!([$($chosen,)* true] $($rest),*) } else { choose!([$($chosen,)* false] $($rest),*) }
        };
    }
    let Effects { absorption, scattering, mirror, refraction, time, .. } = effects;
    choose!([] absorption, scattering, mirror, refraction, time)
}
