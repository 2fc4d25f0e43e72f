//! The works: each is a scene file, the estimand, and the definition of its error.

use forms_radiometry::output::csv;
use forms_radiometry::scene::{Effect, Force, ForcedEffect, Receiver, ReceiverKind, Scene, SurfaceSide};
use forms_radiometry::simulation::Simulation;
use forms_radiometry_testing::benches::simulated::{cornell_box, open, relative_error, simulated, values};
use forms_testing::wall_clock::seconds;
use std::fs::File;
use std::io;
use std::path::Path;

/// Surfaces of the Cornell box whose maps are requested, 4096 cells in all.
const SURFACES: [&str; 4] = ["floor", "back", "right", "short_top"];
/// Columns and rows of each of these maps.
const CELLS: [usize; 2] = [32, 32];
/// Tolerances that are tried for reflected light, from the loosest to the tightest. A tolerance
/// bounds the largest error and includes a margin; the target is a root-mean-square error.
const REFLECTED: &[f64] = &[1.0, 0.3, 0.1, 0.03, 0.01];
/// Tolerance of the reference.
const REFERENCE: f64 = 1e-3;

/// Scene with the estimand and its target error.
pub(crate) struct Work {
    /// Name in the scripts.
    pub(crate) name: &'static str,
    /// Name in the table.
    pub(crate) title: &'static str,
    /// Target of the relative error: for maps the root-mean-square error divided by the mean.
    pub(crate) target: f64,
    /// Least factor by which Mitsuba should be slower than this program.
    pub(crate) goal: f64,
    tolerances: &'static [f64],
    scene: Scene,
}

/// Measurements of a work.
pub(crate) struct Measured<'w> {
    pub(crate) work: &'w Work,
    pub(crate) seconds: f64,
    /// Error, in the measure of the target.
    pub(crate) error: f64,
    /// Loosest tolerance that reaches the target.
    pub(crate) tolerance: f64,
}

/// Returns every work.
pub(crate) fn all() -> Vec<Work> {
    let lamp = |name, title, text| Work {
        name,
        title,
        target: 1e-3,
        goal: 100.0,
        tolerances: &[1e-3],
        scene: open(text, name),
    };
    let near_title = "one receiver 0.05 below the lamp";
    let cornell = |name, title, goal, tolerances, force: Option<Force>| Work {
        name,
        title,
        target: 1e-2,
        goal,
        tolerances,
        scene: with_maps(cornell_box(), force),
    };
    vec![
        lamp("lamp", "4096 receivers under a lamp", include_str!("files/lamp.toml")),
        lamp("occluded_lamp", "the same with a plate in between", include_str!("files/occluded_lamp.toml")),
        Work {
            target: 1e-2,
            tolerances: &[1e-2],
            ..lamp("near_lamp", near_title, include_str!("files/near_lamp.toml"))
        },
        cornell("cornell_direct", "Cornell box, direct light", 20.0, &[1e-2], Some(Force::Off)),
        cornell("cornell_1", "Cornell box, one reflection", 10.0, REFLECTED, Some(Force::Orders(1))),
        cornell("cornell_2", "Cornell box, two reflections", 10.0, REFLECTED, Some(Force::Orders(2))),
        cornell("cornell_all", "Cornell box, all reflections", 5.0, REFLECTED, None),
    ]
}

/// Returns the Cornell box with maps of some surfaces.
fn with_maps(mut scene: Scene, interreflection: Option<Force>) -> Scene {
    let place = scene.receivers[0].place.clone();
    let map = |name: &str| {
        let surface = scene.surfaces.iter().position(|surface| surface.name == name);
        let surface = surface.expect("the Cornell box has this surface");
        let kind = ReceiverKind::Surface { surface, side: SurfaceSide::Front, grid: Some(CELLS) };
        Receiver { name: name.to_string(), kind, time: None, place: place.clone() }
    };
    scene.receivers = SURFACES.map(map).to_vec();
    let forced = |force| ForcedEffect { effect: Effect::Interreflection, force, place: place.clone() };
    scene.solve.forced = interreflection.map(forced).into_iter().collect();
    scene
}

impl Work {
    /// Plans and simulates the scene.
    pub(crate) fn run(&self) -> Simulation {
        simulated(&self.with(self.tolerances[0]))
    }

    /// Measures its time with the loosest tolerance that reaches the target error, compared with a
    /// reference, which is written into a directory for the scripts.
    pub(crate) fn measured(&self, folder: &Path) -> io::Result<Measured<'_>> {
        let reference = simulated(&self.with(REFERENCE));
        csv(&reference, File::create(folder.join(format!("{}.csv", self.name)))?)?;
        let exact = values(&reference);
        let error = |tolerance: &f64| relative_error(&values(&simulated(&self.with(*tolerance))), &exact);
        let found = self.tolerances.iter().map(|tolerance| (*tolerance, error(tolerance)));
        let (tolerance, error) = found
            .into_iter()
            .find(|(_, error)| *error <= self.target)
            .expect("the least tolerance is far below");
        let scene = self.with(tolerance);
        let seconds = seconds(|| simulated(&scene));
        println!("{:32} {:10.3} ms, tolerance {tolerance:e}, error {error:.1e}", self.title, 1e3 * seconds);
        Ok(Measured { work: self, seconds, error, tolerance })
    }

    fn with(&self, tolerance: f64) -> Scene {
        let mut scene = self.scene.clone();
        scene.solve.tolerance = tolerance;
        scene
    }
}
