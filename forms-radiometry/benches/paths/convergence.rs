//! The error over seeds against the number of samples: it falls with each doubling, up to the
//! largest number that is run.

use crate::work::{REFLECTED_BY_1, REFLECTED_BY_10, asked_for, only, slab, white};
use forms_radiometry::geometry::Vector;
use forms_radiometry::scene::{Effect, Force, ForcedEffect, LightKind, ReceiverKind, Scene};
use forms_radiometry::simulation::{Budget, Job, Unwatched, plan, simulate_job};
use forms_radiometry_testing::benches::simulated::{open, values};
use std::f64::consts::PI;

/// Number of samples of the first row, as a power of two.
const FIRST: u32 = 8;

/// Scene with one answer that is known.
pub(crate) struct Series {
    pub(crate) title: &'static str,
    scene: Scene,
    known: f64,
    /// Pairs of a number of seeds and the largest number of samples, as a power of two, run with
    /// that many seeds.
    reaches: &'static [(u64, u32)],
}

/// Errors of a series.
pub(crate) struct Measured {
    pub(crate) title: &'static str,
    /// For each number of samples, as a power of two: the number of seeds and their relative
    /// root-mean-square error.
    pub(crate) errors: Vec<(u32, u64, f64)>,
}

/// Returns every series.
pub(crate) fn all() -> Vec<Series> {
    let transmitted = |title, tau, reflected: f64, reaches| {
        let (scene, known) = (only(slab(0.0, tau), "transmitted"), PI * (1.0 - reflected));
        Series { title, scene, known, reaches }
    };
    let (cloud, of_cloud) = cloud();
    vec![
        transmitted("slab, τ = 1", 1.0, REFLECTED_BY_1, &[(32, 18), (4, 20)]),
        transmitted("slab, τ = 10", 10.0, REFLECTED_BY_10, &[(32, 14), (4, 18)]),
        Series {
            title: "furnace, ρ = 0.9, filled with mist",
            scene: misty(white(0.9)),
            known: 10.0,
            reaches: &[(32, 14), (4, 18)],
        },
        Series {
            title: "ball of fog in sunlight, once scattered",
            scene: cloud,
            known: of_cloud,
            reaches: &[(32, 16), (4, 22), (1, 28)],
        },
    ]
}

/// Returns the gallery's cloud with the sun behind the eye and single isotropic scattering, and the
/// radiance seen through its centre. Light travels the same distance into the cloud as out of it: L
/// = E σ/(4π) ∫ e^(−2σt) dt = E/(8π) (1 − e^(−4σR)), with t from 0 to 2R.
fn cloud() -> (Scene, f64) {
    const SIGMA: f64 = 3.0;
    const IRRADIANCE: f64 = 10.0;
    let mut scene = open(include_str!("../../../scenes/cloud.toml"), "cloud.toml");
    let (origin, direction) = (Vector::new(0.0, -6.0, 0.0), Vector::new(0.0, 1.0, 0.0));
    (scene.media[0].scattering, scene.media[0].asymmetry) = (vec![SIGMA], vec![0.0]);
    scene.lights[0].kind = LightKind::Distant { direction, irradiance: vec![IRRADIANCE] };
    scene.ambient.radiance = vec![0.0];
    let place = scene.ambient.place.clone();
    scene.solve.forced = vec![ForcedEffect { effect: Effect::Scattering, force: Force::Orders(1), place }];
    let known = IRRADIANCE / (8.0 * PI) * -(-4.0 * SIGMA).exp_m1();
    (asked_for(scene, ReceiverKind::Ray { origin, direction }), known)
}

/// Returns a furnace filled with the medium of the slab, and a ray through it.
fn misty(mut scene: Scene) -> Scene {
    let slab = slab(0.0, 1.0);
    (scene.media, scene.ambient.medium) = (slab.media, slab.ambient.medium);
    only(scene, "beam")
}

impl Series {
    /// Returns the errors for each fourfold increase of the number of samples.
    pub(crate) fn measured(self) -> Measured {
        let last = self.reaches.iter().map(|&(_, last)| last).max().unwrap_or(FIRST);
        let mut errors = Vec::new();
        for power in (FIRST..=last).step_by(2) {
            let reaching = self.reaches.iter().filter(|&&(_, last)| power <= last);
            let seeds = reaching.map(|&(seeds, _)| seeds).max().unwrap_or(1);
            let squares: f64 = (1..=seeds).map(|seed| self.error(seed, power).powi(2)).sum();
            let error = (squares / seeds as f64).sqrt();
            println!("{:40} 2^{power} samples, {seeds} seeds, error {error:.1e}", self.title);
            errors.push((power, seeds, error));
        }
        Measured { title: self.title, errors }
    }

    fn error(&self, seed: u64, power: u32) -> f64 {
        let mut scene = self.scene.clone();
        scene.solve.seed = seed;
        let budget = Budget::new(1 << power).unwrap_or_else(|error| panic!("{error}"));
        let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
        let job = Job { budget: Some(budget), ..Job::default() };
        let simulation = simulate_job(&plan, job, &Unwatched).expect("there is no state to misfit");
        values(&simulation)[0] / self.known - 1.0
    }
}
