//! Expected cost of path tracing: a few paths of some estimands tell how many rays meet the
//! tolerance.
//!
//! ```text
//! spread of n paths, what they may have missed ─▶ paths for the tolerance
//! rays = paths × vertices of a path × (1 + light sources sampled at a vertex)
//! ```
//! The plan compares this number with the expected cost of radiosity. It does not depend on the
//! seed, so that the method of a scene does not either.

use super::analytic::Computing;
use super::radiances::passed_on;
use super::request::{Request, some_requests};
use super::scale::{Scales, known, of_request};
use super::{Task, samplers};
use crate::effects::EffectSet;
use crate::job::{MOST_SAMPLES, REPLICATES};
use crate::paths::{Limits, Replicates};
use crate::sampling::key;
use rayon::prelude::*;

/// Number of samples of each replicate.
const SAMPLES: u32 = 8;
/// Numbers of estimands for which paths are traced.
const TRACED: [f64; 2] = [8.0, 64.0];
/// Part of the cost of the other method that a prediction should cost, and the most that it may.
const PART: f64 = 0.02;
const MOST: f64 = 0.1;
/// Maximum number of reflections of a path.
const MOST_REFLECTIONS: u32 = 256;
/// Mean number of reflections of a path among surfaces of the reflectance ρ, times 1 − ρ: Russian
/// roulette begins after ln 10/(1 − ρ), and leaves 1/(1 − ρ) more.
const LENGTH: f64 = 3.3;
/// Key of the random numbers.
const KEY: u64 = 0x9b1a_44c7_0e6d_2f35;

/// Number of rays that path tracing is expected to need for a scene.
pub(crate) struct ExpectedRays {
    pub(crate) rays: f64,
    /// Number of values: numbers, cells and pixels.
    pub(crate) values: usize,
}

/// Returns the number of rays that path tracing is expected to need for a scene. The prediction is
/// compared with the cost of another method, in rays: where that is small, fewer paths have to tell;
/// `None` where they would cost too much of it.
pub(crate) fn expected_rays(task: Task<'_>, other: f64) -> Option<ExpectedRays> {
    let Task { world, effects, .. } = task;
    let limits = Limits::of(effects);
    let reflections = limits.reflections.map_or(MOST_REFLECTIONS, |most| most.min(MOST_REFLECTIONS));
    // paths that reach the maximum would go on as between the brightest surfaces
    let reflectance = passed_on(&world.scene, EffectSet::of_scene(&world.scene));
    let longer = match limits.reflections {
        Some(_) => 1.0,
        None => 1.0 + LENGTH / (f64::from(MOST_REFLECTIONS) * (1.0 - reflectance)),
    };
    let samplers = samplers(task, Limits { reflections: Some(reflections), ..limits });
    let (scene, bands) = (&*world.scene, world.scene.band_count());
    let vertices = f64::from(reflections).min(LENGTH / (1.0 - reflectance)) + 1.0;
    let of_traced = (REPLICATES as u32 * SAMPLES) as f64 * vertices * world.rays_of_a_vertex();
    let traced = (PART * other / of_traced).clamp(TRACED[0], TRACED[1]) as usize;
    let (mut requests, values) = some_requests(task, &Computing::nothing(), traced);
    if requests.len() as f64 * of_traced > MOST * other {
        return None;
    }
    let trace = |(index, request): (usize, &mut Request)| {
        request.replicates = Replicates::new(key(KEY, index as u64), &request.estimand, bands, None);
        request.replicates.extend(SAMPLES, &request.estimand, &samplers, |_| true, &|| false)
    };
    let segments: Vec<u64> = requests.par_iter_mut().enumerate().map(trace).collect();
    let scales = known(&requests, scene.receivers.len(), bands);
    let of_one = |(request, segments): (&Request, u64)| {
        expected_paths(request, &scales, bands, scene.solve.tolerance) * segments as f64
            / request.replicates.count()
    };
    let all: f64 = requests.iter().zip(segments).map(of_one).sum();
    let step = values.div_ceil(requests.len().max(1));
    Some(ExpectedRays { rays: step as f64 * world.rays_of_a_vertex() * longer * all, values })
}

/// Returns the number of paths after which the error of an estimand is expected to meet the
/// tolerance.
fn expected_paths(request: &Request, scales: &Scales, bands: usize, tolerance: f64) -> f64 {
    if request.computed.is_some() {
        return 0.0;
    }
    let scales = of_request(request, Some(scales), bands);
    let [first, most] = [request.first(), MOST_SAMPLES].map(f64::from);
    REPLICATES as f64 * request.needed(&scales, tolerance).clamp(first, most)
}
