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
use crate::effects::EffectSet;
use crate::sampling::SHARED;
use crate::scene::{Effect, Scene};
use std::marker::PhantomData;

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

/// Returns the path tracers of a world, one for each group of bands that share paths.
pub(crate) fn follower<'w>(
    world: &'w World<'w>,
    effects: EffectSet,
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
fn groups(scene: &Scene, effects: EffectSet) -> Vec<[usize; 2]> {
    let mut groups: Vec<[usize; 2]> = Vec::new();
    for band in 0..scene.band_count() {
        let shares = |[first, count]: [usize; 2]| {
            count < SHARED && !effects.has(Effect::Dispersion) && scatter_alike(scene, first, band)
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
    effects: EffectSet,
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
    choose!([]
        effects.has(Effect::Absorption),
        effects.has(Effect::Scattering),
        effects.has(Effect::Mirror),
        effects.has(Effect::Refraction),
        effects.has(Effect::Time)
    )
}
