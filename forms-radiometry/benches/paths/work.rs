//! The works: each is a scene with one receiver, the target error, and the reference for its
//! answer.

use forms_radiometry::camera::Camera;
use forms_radiometry::geometry::Vector;
use forms_radiometry::scene::{Material, MaterialKind, Receiver, ReceiverKind, Scene};
use forms_radiometry_testing::benches::simulated::{cornell_box, open, simulated, values};
use std::f64::consts::PI;

/// Reflectance of the furnace.
pub(crate) const RHO: f64 = 0.99;
/// Columns and rows of the image of the Cornell box.
const CORNELL: [usize; 2] = [64, 64];
/// Columns and rows of the image of the furnace.
const FURNACE: [usize; 2] = [100, 100];
/// Number of seeds from which the error of a single value is estimated.
const MANY: u64 = 32;

/// Scene with the estimand and its target error.
pub(crate) struct Work {
    /// Name in the script.
    pub(crate) name: &'static str,
    /// Name in the table.
    pub(crate) title: &'static str,
    /// Target of the relative error: the root mean square over seeds and pixels, divided by the
    /// mean.
    pub(crate) target: f64,
    /// Least factor by which Mitsuba should be slower than this program, if that is a goal.
    pub(crate) goal: Option<f64>,
    /// Loosest tolerance that is tried.
    pub(crate) tolerance: f64,
    /// Number of seeds it is run with.
    pub(crate) seeds: u64,
    pub(crate) scene: Scene,
    known: Known,
}

/// Reference for the answers.
enum Known {
    /// The known value of all answers.
    Value(f64),
    /// The mean of this program's results with that many seeds and that tolerance.
    Found { seeds: u64, tolerance: f64 },
}

/// Returns every work.
pub(crate) fn all() -> Vec<Work> {
    let scattered = |name, title, tau, receiver, part: f64| Work {
        name,
        title,
        target: 1e-3,
        goal: Some(3.0),
        tolerance: 1e-1,
        seeds: MANY,
        scene: only(slab(0.0, tau), receiver),
        known: Known::Value(PI * part),
    };
    let absorbed = |name, title, tau: f64| Work {
        name,
        title,
        target: 1e-2,
        goal: None,
        tolerance: 1e-2,
        seeds: 1,
        scene: upwards(slab(tau, 0.0)),
        known: Known::Value((-tau).exp()),
    };
    let furnace = |name, title, scene| Work {
        name,
        title,
        target: 3e-2,
        goal: None,
        tolerance: 1e-1,
        seeds: 1,
        scene: with_camera(scene),
        known: Known::Value(1.0 / (1.0 - RHO)),
    };
    vec![
        scattered("slab_1_t", "slab, τ = 1, transmitted", 1.0, "transmitted", 1.0 - REFLECTED_BY_1),
        scattered("slab_1_r", "slab, τ = 1, reflected", 1.0, "reflected", REFLECTED_BY_1),
        scattered("slab_10_t", "slab, τ = 10, transmitted", 10.0, "transmitted", 1.0 - REFLECTED_BY_10),
        scattered("slab_10_r", "slab, τ = 10, reflected", 10.0, "reflected", REFLECTED_BY_10),
        Work {
            name: "cornell",
            title: "Cornell box, image of 64 × 64 pixels",
            target: 1e-2,
            goal: Some(5.0),
            tolerance: 1.0,
            seeds: 3,
            scene: seen_by_camera(cornell_box()),
            known: Known::Found { seeds: 1, tolerance: 1e-3 },
        },
        furnace("furnace", "furnace, ρ = 0.99, image of 100 × 100 pixels", white(RHO)),
        furnace("mirror", "the same, with a mirror for a floor", with_mirror(white(RHO))),
        absorbed("absorption_1", "absorption along a ray, τ = 1", 1.0),
        absorbed("absorption_10", "absorption along a ray, τ = 10", 10.0),
    ]
}

/// Reflectance of slabs of these optical thicknesses for isotropic light, without absorption; the
/// remaining light is transmitted. Source: the integral equation of radiative transfer in a slab,
/// solved to 12 digits (van de Hulst 1980 has tables of it).
pub(crate) const REFLECTED_BY_1: f64 = 0.446_594_006_673;
pub(crate) const REFLECTED_BY_10: f64 = 0.883_254_886_487;

/// Returns the slab of the gallery with these coefficients; its thickness is 1.
pub(crate) fn slab(absorption: f64, scattering: f64) -> Scene {
    let mut scene = open(include_str!("../../../scenes/slab.toml"), "slab.toml");
    (scene.media[0].absorption, scene.media[0].scattering) = (vec![absorption], vec![scattering]);
    scene
}

/// Returns a scene with one of its receivers.
pub(crate) fn only(mut scene: Scene, receiver: &str) -> Scene {
    scene.receivers.retain(|other| other.name == receiver);
    assert_eq!(scene.receivers.len(), 1, "the scene has one receiver `{receiver}`");
    scene
}

/// Returns a scene with this receiver alone.
pub(crate) fn asked_for(mut scene: Scene, kind: ReceiverKind) -> Scene {
    let Receiver { place, .. } = scene.receivers.swap_remove(0);
    scene.receivers = vec![Receiver { name: "here".to_string(), kind, time: None, place }];
    scene
}

/// Returns the slab with a receiver for the radiance that arrives vertically from above at the
/// centre of its lower plate.
fn upwards(slab: Scene) -> Scene {
    let (origin, direction) = (Vector::default(), Vector::new(0.0, 0.0, 1.0));
    asked_for(slab, ReceiverKind::Ray { origin, direction })
}

/// Returns the scene with its camera alone, and an image of few pixels.
fn seen_by_camera(mut scene: Scene) -> Scene {
    scene.receivers.retain_mut(|receiver| match &mut receiver.kind {
        ReceiverKind::Camera(camera) => {
            camera.resolution = CORNELL;
            true
        }
        _ => false,
    });
    scene
}

/// Returns the gallery's furnace with walls of another reflectance.
pub(crate) fn white(reflectance: f64) -> Scene {
    let mut scene = open(include_str!("../../../scenes/furnace.toml"), "furnace.toml");
    scene.materials[0].kind = MaterialKind::Diffuse { reflectance: vec![reflectance] };
    scene
}

/// Returns a furnace whose floor is a mirror that absorbs nothing, which makes the solver use path
/// tracing.
fn with_mirror(mut furnace: Scene) -> Scene {
    let kind = MaterialKind::Mirror { reflectance: vec![1.0] };
    let place = furnace.materials[0].place.clone();
    furnace.materials.push(Material { name: "mirror".to_string(), kind, place });
    (furnace.surfaces[0].material, furnace.surfaces[0].radiance) = (1, vec![0.0]);
    furnace
}

/// Returns a furnace with a camera in it.
fn with_camera(furnace: Scene) -> Scene {
    let [origin, target] = [Vector::new(0.1, 0.2, 0.3), Vector::new(0.9, 0.7, 0.5)];
    let camera = Camera::new(origin, target, Vector::new(0.0, 0.0, 1.0), 60.0, FURNACE);
    asked_for(furnace, ReceiverKind::Camera(camera.expect("it has a direction")))
}

impl Work {
    /// Returns the scene with the loosest tolerance.
    pub(crate) fn first(&self) -> Scene {
        self.with(1, self.tolerance)
    }

    /// Returns the scene with a seed and a tolerance.
    pub(crate) fn with(&self, seed: u64, tolerance: f64) -> Scene {
        let mut scene = self.scene.clone();
        (scene.solve.seed, scene.solve.tolerance) = (seed, tolerance);
        scene
    }

    /// Returns the number of values.
    pub(crate) fn count(&self) -> usize {
        match &self.scene.receivers[0].kind {
            ReceiverKind::Camera(camera) => camera.resolution.iter().product(),
            _ => 1,
        }
    }

    /// Returns the value of all answers, if it is known.
    pub(crate) fn known(&self) -> Option<f64> {
        match self.known {
            Known::Value(value) => Some(value),
            Known::Found { .. } => None,
        }
    }

    /// Returns the reference values.
    pub(crate) fn reference(&self) -> Vec<f64> {
        let Known::Found { seeds, tolerance } = self.known else {
            return vec![self.known().unwrap_or(f64::NAN); self.count()];
        };
        let mut sums = vec![0.0; self.count()];
        for seed in 0..seeds {
            // seeds different from the measured ones
            let found = values(&simulated(&self.with((1 << 32) + seed, tolerance)));
            sums.iter_mut().zip(found).for_each(|(sum, value)| *sum += value / seeds as f64);
        }
        sums
    }
}
