//! The gallery: every scene in the folder `scenes` is simulated. Its known answers lie within the
//! reported errors, and these within the requested tolerance.

use forms_radiometry::scene::{Effect, Force, ForcedEffect, Scene, open};
use forms_radiometry::simulation::Quantity::{self, FluenceRate, Irradiance, Radiance, VectorIrradiance};
use forms_radiometry::simulation::{Answer, Simulation, Unwatched, plan, simulate};
use forms_radiometry_testing::known_answers::{Exhibit, GALLERY, Known, known};
use std::collections::BTreeSet;
use std::f64::consts::PI;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes")
}

/// Returns the unchanged scene of a file of the gallery.
fn scene(file: &str) -> Scene {
    open(&folder().join(file)).unwrap_or_else(|errors| panic!("{}", errors[0]))
}

/// Results of a scene, the requested tolerance, and the error budget spent on omitted effects.
struct Simulated {
    found: Simulation,
    tolerance: f64,
    dropped: f64,
}

fn simulated(exhibit: &Exhibit) -> Simulated {
    let mut scene = scene(exhibit.file);
    scene.solve.tolerance = exhibit.tolerance.unwrap_or(scene.solve.tolerance);
    if exhibit.straight {
        let place = scene.surfaces[0].place.clone();
        let (effect, force) = (Effect::Interreflection, Force::Off);
        scene.solve.forced.push(ForcedEffect { effect, force, place });
    }
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let found = simulate(&plan, &Unwatched);
    Simulated { found, tolerance: scene.solve.tolerance, dropped: plan.dropped() }
}

/// Asserts that known answers lie within the reported errors, and these within the requested
/// tolerance.
fn assert_true(exhibit: &Exhibit) {
    let Simulated { found, tolerance, dropped } = simulated(exhibit);
    for known in exhibit.known {
        assert_within(known, exhibit.file, &found.answers);
    }
    for answer in &found.answers {
        let parts = answer.parts;
        assert_eq!(parts.error(answer.kind), answer.error, "{}: {answer:?}", exhibit.file);
        assert!(parts.all().iter().all(|&part| part >= 0.0), "{}: {answer:?}", exhibit.file);
        // the plan reports the error budget of omitted effects
        assert_eq!(parts.effects > 0.0, dropped > 0.0, "{}: {answer:?}", exhibit.file);
        let scale = scale(answer, &found.answers);
        let (name, error) = (&answer.receiver, answer.error);
        assert!(error <= tolerance * scale, "{}: {name}: {error:e} is not what was asked for", exhibit.file);
    }
    for map in &found.maps {
        let scale = map.scales[0];
        let is_enough = |(value, error): (&f64, &f64)| {
            error.is_nan() || *error <= tolerance * (1.0 + 4.0 * f64::EPSILON) * scale.max(*value)
        };
        let are_enough = map.values[0].iter().zip(&map.errors[0]).all(is_enough);
        assert!(scale > 0.0 && are_enough, "{}: the map is not what was asked for", exhibit.file);
    }
}

fn assert_within(known: &Known, file: &str, answers: &[Answer]) {
    let [value, error] = known.found(answers);
    let off = (value - known.value).abs();
    // the known value is rounded too
    let rounding = 4.0 * f64::EPSILON * known.value.abs();
    let name = known.sum[0].1;
    assert!(off <= error + rounding, "{file}: {name}: {value} is off by {off:e}, said {error:e}");
}

/// Returns the scale of an answer's tolerance: for a component of a flow, the fluence rate; for a
/// time bin, the largest bin.
fn scale(answer: &Answer, answers: &[Answer]) -> f64 {
    if answer.bin.is_some() {
        let of_receiver = answers.iter().filter(|other| other.receiver == answer.receiver);
        return of_receiver.map(|other| other.value).fold(0.0, f64::max);
    }
    match answer.quantity {
        VectorIrradiance(_) => find(answers, &answer.receiver, FluenceRate).value,
        // if nothing was found in a band, its error is the light that could have been missed
        _ if answer.value == 0.0 => {
            let is_beside =
                |other: &&Answer| other.receiver == answer.receiver && other.quantity == answer.quantity;
            answers.iter().filter(is_beside).map(|other| other.value).fold(0.0, f64::max)
        }
        _ => answer.value.abs(),
    }
}

fn find<'a>(answers: &'a [Answer], receiver: &str, quantity: Quantity) -> &'a Answer {
    let is_meant = |answer: &&Answer| answer.receiver == receiver && answer.quantity == quantity;
    answers.iter().find(is_meant).unwrap_or_else(|| panic!("{receiver} has no {quantity:?}"))
}

#[test]
fn every_scene_of_the_folder_is_tested_and_has_a_picture_on_the_page() {
    let files = std::fs::read_dir(folder()).expect("the folder").map(|file| file.expect("a file").path());
    let is_scene = |path: &PathBuf| path.extension().is_some_and(|end| end == "toml" || end == "xml");
    let found: BTreeSet<String> =
        files.filter(is_scene).map(|path| path.file_name().unwrap().to_string_lossy().into()).collect();
    let exhibited: BTreeSet<String> = GALLERY.iter().map(|exhibit| exhibit.file.to_string()).collect();
    assert_eq!(found, exhibited);
    let page = std::fs::read_to_string(folder().join("README.md")).expect("the page of the gallery");
    for file in &found {
        assert!(page.contains(&format!("({file})")), "{file} is not on the page");
        let picture = |end| format!("pictures/{}", Path::new(file).with_extension(end).display());
        let is_shown = |name: String| folder().join(&name).is_file() && page.contains(&name);
        assert!(is_shown(picture("png")) || is_shown(picture("svg")), "{file} has no picture");
    }
}

#[test]
fn what_is_known_lies_within_the_errors_that_are_said() {
    let is_meant = |exhibit: &&Exhibit| !(exhibit.long && cfg!(debug_assertions));
    GALLERY.iter().filter(is_meant).for_each(assert_true);
}

/// Returns the known answers of the scenes of the book, in the order of their names.
fn scenes_of_the_book() -> [(&'static str, Known); 2] {
    let of_cloud = PI * (1.0 - 0.883_254_886_486_837_4);
    [
        ("lamp_in_glass.toml", known(&[(1.0, "outside", Radiance)], 0.96 / 2.25)),
        ("thick_cloud.toml", known(&[(1.0, "transmitted", Irradiance)], of_cloud)),
    ]
}

#[test]
fn scenes_of_the_book_have_the_answers_that_it_derives() {
    let folder = folder().join("../docs/book/scenes");
    let files = std::fs::read_dir(&folder).expect("the scenes of the book").map(|file| file.expect("a file"));
    let found: BTreeSet<String> = files.map(|file| file.file_name().to_string_lossy().into()).collect();
    assert_eq!(found, scenes_of_the_book().iter().map(|(file, _)| (*file).to_owned()).collect());
    for (file, known) in scenes_of_the_book() {
        let scene = open(&folder.join(file)).unwrap_or_else(|errors| panic!("{}", errors[0]));
        let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
        assert_within(&known, file, &simulate(&plan, &Unwatched).answers);
    }
}

#[test]
fn squares_near_each_other_have_the_mean_irradiance_of_their_view_factor() {
    let scene = scene("near_squares.toml");
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let found = simulate(&plan, &Unwatched);
    let known = known(&[(1.0, "receiver", Irradiance)], 0.999_998_000_010_029_5);
    assert_within(&known, "near_squares.toml", &found.answers);
}
