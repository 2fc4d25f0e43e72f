//! Progress of whole runs: the fraction that is done never decreases, times add up, and the
//! remaining time is reported where it is known.

use forms_radiometry::scene::{self, Scene};
use forms_radiometry::simulation::{Simulation, Watch, plan, simulate};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::Instant;

/// Reports that a caller received.
struct Told {
    start: Instant,
    /// Seconds, fractions that are done, and remaining times.
    all: Mutex<Vec<(f64, f64, Option<f64>)>>,
    left: Mutex<Option<f64>>,
}

impl Watch for Told {
    fn progress(&self, _stage: &str, fraction: f64) {
        let left = *self.left.lock().expect("no panic");
        self.all.lock().expect("no panic").push((self.start.elapsed().as_secs_f64(), fraction, left));
    }

    fn time_left(&self, seconds: Option<f64>) {
        *self.left.lock().expect("no panic") = seconds;
    }

    fn is_stopped(&self) -> bool {
        false
    }
}

/// Simulates a scene. Returns the results, the reports, and the elapsed seconds.
fn watched(scene: &Scene) -> (Simulation, Told, f64) {
    let plan = plan(scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let told = Told { start: Instant::now(), all: Mutex::default(), left: Mutex::default() };
    let found = simulate(&plan, &told);
    let seconds = told.start.elapsed().as_secs_f64();
    (found, told, seconds)
}

fn gallery() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes")
}

fn open(name: &str, tolerance: f64) -> Scene {
    let mut scene = scene::open(&gallery().join(name)).unwrap_or_else(|errors| panic!("{}", errors[0]));
    scene.solve.tolerance = tolerance;
    scene
}

/// Refinement, path tracing of points between diffuse surfaces, in a medium and of an image, and
/// maps.
const SCENES: [(&str, f64); 6] = [
    ("cube.toml", 1e-2),
    ("opposed_squares.toml", 1e-3),
    ("integrating_sphere.toml", 0.1),
    ("slab.toml", 1e-2),
    ("street_light.toml", 0.1),
    ("prism.toml", 0.2),
];

#[test]
fn the_part_that_is_done_never_decreases() {
    for (name, tolerance) in SCENES {
        let (_, told, _) = watched(&open(name, tolerance));
        let told = told.all.into_inner().expect("no panic");
        assert!(!told.is_empty(), "{name}");
        assert!(told.iter().all(|(_, done, _)| (0.0..=1.0).contains(done)), "{name}: {told:?}");
        assert!(told.is_sorted_by_key(|(_, done, _)| *done), "{name}: {told:?}");
    }
}

#[test]
fn the_times_of_answers_and_of_what_they_share_are_that_of_the_work() {
    for (name, tolerance) in SCENES {
        let (found, _, seconds) = watched(&open(name, tolerance));
        let of_answers: f64 = found.answers.iter().map(|answer| answer.seconds).sum();
        assert!(found.answers.iter().all(|answer| answer.seconds > 0.0), "{name}");
        assert!(of_answers <= found.seconds * (1.0 + 1e-9), "{name}: {of_answers} of {}", found.seconds);
        let sum = of_answers + found.shared_seconds();
        // the rest is the conversion from working units, and pauses of a busy machine
        assert!(sum <= seconds && seconds - sum < 0.1 + 0.1 * seconds, "{name}: {sum} of {seconds}");
    }
}

/// Accuracy of the reported remaining times, over all scenes of the gallery that take longer than
/// `LONG`.
#[test]
#[ignore = "measures times, in a minute"]
fn the_time_that_is_left_is_within_a_factor_of_two() {
    const LONG: f64 = 0.3;
    let mut files: Vec<_> =
        std::fs::read_dir(gallery()).expect("a folder").map(|file| file.expect("a file")).collect();
    files.sort_by_key(std::fs::DirEntry::file_name);
    let (mut all, mut wrong) = (0, 0);
    for file in files.iter().filter(|file| file.path().extension().is_some_and(|ending| ending == "toml")) {
        let scene = scene::open(&file.path()).unwrap_or_else(|errors| panic!("{}", errors[0]));
        let (_, told, seconds) = watched(&scene);
        if seconds < LONG {
            continue;
        }
        let told = told.all.into_inner().expect("no panic");
        let late: Vec<_> = told.iter().filter(|(now, ..)| *now > 0.1 * seconds).collect();
        let shown: Vec<[f64; 3]> =
            late.iter().filter_map(|(now, _, left)| left.map(|left| [*now, left, seconds - now])).collect();
        let is_wrong = |[_, left, truth]: &&[f64; 3]| {
            // the progress bar shows whole seconds
            (left - truth).abs() > 1.0 && !(0.5 * truth..=2.0 * truth).contains(left)
        };
        let is_strictly_wrong = |[_, left, truth]: &&[f64; 3]| !(0.5 * truth..=2.0 * truth).contains(left);
        let first = shown.first().map_or(f64::NAN, |[now, ..]| now / seconds);
        let off = shown.iter().filter(is_wrong).count();
        println!(
            "{:?}: {seconds:.2} s, told {} times, {} with a time, the first after {first:.2} of the time; {off} off, {} strictly",
            file.file_name(),
            told.len(),
            shown.len(),
            shown.iter().filter(is_strictly_wrong).count(),
        );
        all += shown.len();
        wrong += off;
    }
    assert!(wrong * 50 <= all, "{wrong} of {all} times are off");
}
