//! Dispatch: the path tracers of a scene, each specialised for the effects that the scene has.

use super::image_sources::Images;
use super::optics::Optics;
use super::path_sampler::PathSampler;
use super::specialisation::Member;
use super::tracer::{Limits, Tracer};
use super::world::World;
use crate::effects::EffectSet;
use crate::sampling::SHARED;
use crate::scene::{Effect, Scene};
use std::marker::PhantomData;

/// Returns the path tracers of a world, one for each group of bands that share paths.
pub(crate) fn path_samplers<'w>(
    world: &'w World,
    effects: EffectSet,
    limits: Limits,
) -> Vec<Box<dyn PathSampler + 'w>> {
    let member = |[first, count]: [usize; 2]| match count {
        1 => member::<1>(world, effects, limits, first, count),
        _ => member::<SHARED>(world, effects, limits, first, count),
    };
    groups(&world.scene, effects).into_iter().map(member).collect()
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
    let scene = &*world.scene;
    !scene.lights.is_empty()
        && (0..scene.band_count()).any(|band| Images::of(world, &Optics::<1>::of(scene, band, 1)).is_cut)
}

/// Returns the path tracer that is specialised for these effects.
fn member<'w, const N: usize>(
    world: &'w World,
    effects: EffectSet,
    limits: Limits,
    first: usize,
    count: usize,
) -> Box<dyn PathSampler + 'w> {
    let optics = Optics::<N>::of(&world.scene, first, count);
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
