//! The gallery: every scene in the folder `scenes` is simulated, its known answers lie within the errors that are said, and
//! these within the tolerance that was asked for.

use forms_radiometry::scene::{Effect, Force, ForcedEffect, Scene, open};
use forms_radiometry::simulation::Quantity::{
    self, FluenceRate, Flux, Irradiance, Radiance, VectorIrradiance,
};
use forms_radiometry::simulation::{Answer, ErrorKind, Simulation, Unwatched, plan, simulate};
use std::collections::BTreeSet;
use std::f64::consts::PI;
use std::path::{Path, PathBuf};

/// A scene of the gallery and what is known of it.
struct Exhibit {
    file: &'static str,
    /// The tolerance to test with, where that of the file would take long in a program that is not optimised.
    tolerance: Option<f64>,
    /// Whether reflected light is left out, because it would take long.
    straight: bool,
    /// Whether it takes minutes where the numeric code is not optimised, so that only tests of the release build simulate it.
    long: bool,
    known: &'static [Known],
}

/// A sum of answers whose value is known.
struct Known {
    /// Each with its factor.
    sum: &'static [(f64, &'static str, Quantity)],
    value: f64,
    /// By how much the scene itself differs from what the value holds for.
    idealised: f64,
}

const fn known(sum: &'static [(f64, &'static str, Quantity)], value: f64) -> Known {
    Known { sum, value, idealised: 0.0 }
}

const GALLERY: [Exhibit; 16] = [
    Exhibit {
        file: "opposed_squares.toml",
        tolerance: Some(1e-2),
        straight: false,
        long: false,
        known: &[known(&[(0.9, "dark square", Irradiance)], 0.896_047_679_666_9)],
    },
    Exhibit {
        file: "furnace.toml",
        tolerance: None,
        straight: false,
        long: false,
        known: &[
            known(&[(1.0, "floor", Irradiance)], 10.0 * PI),
            // an octant of directions, each by its cosine with [1, 2, 3]/√14
            known(&[(1.0, "in a corner", Irradiance)], 12.594_389_312_720_37),
            known(&[(1.0, "inside", FluenceRate)], 40.0 * PI),
            known(&[(1.0, "inside", VectorIrradiance(0))], 0.0),
            known(&[(1.0, "inside", VectorIrradiance(1))], 0.0),
            known(&[(1.0, "inside", VectorIrradiance(2))], 0.0),
            known(&[(1.0, "beam", Radiance)], 10.0),
        ],
    },
    Exhibit {
        file: "cube.toml",
        tolerance: Some(2e-2),
        straight: false,
        long: false,
        known: &[known(
            &[
                (0.5, "floor", Flux),
                (0.3, "ceiling", Flux),
                (0.4, "left", Flux),
                (0.8, "right", Flux),
                (0.25, "front", Flux),
                (0.25, "back", Flux),
            ],
            1.0,
        )],
    },
    Exhibit {
        file: "v_groove.toml",
        tolerance: None,
        straight: false,
        long: false,
        // both in a groove without ends; what is missing beyond the ends of this one is below ⅔ x L/(π 20³)
        known: &[
            Known { sum: &[(1.0, "near the apex", Irradiance)], value: 0.663_515_491_999, idealised: 1e-7 },
            Known { sum: &[(1.0, "half way up", Irradiance)], value: 0.324_095_475_331, idealised: 2e-5 },
        ],
    },
    Exhibit {
        file: "integrating_sphere.toml",
        tolerance: None,
        straight: false,
        long: true,
        known: &[
            known(&[(1.0, "wall", Irradiance)], 10.0),
            known(&[(1.0, "middle", FluenceRate)], 40.0),
            known(&[(1.0, "middle", VectorIrradiance(2))], -5.2),
        ],
    },
    Exhibit {
        file: "occluded_lamp.toml",
        tolerance: None,
        straight: false,
        long: false,
        known: &[known(&[(1.0, "floor", Irradiance)], 0.149_868_671_773_790_54)],
    },
    Exhibit {
        file: "far_squares.toml",
        tolerance: None,
        straight: false,
        long: false,
        known: &[known(&[(1.0, "receiver", Irradiance)], 3.183_098_840_617_247_8e-9)],
    },
    Exhibit {
        file: "near_squares.toml",
        tolerance: None,
        straight: false,
        long: false,
        known: &[known(&[(1.0, "centre", Irradiance)], 0.999_999_999_996_726_7)],
    },
    Exhibit {
        file: "room.toml",
        tolerance: Some(0.5),
        straight: true,
        long: false,
        known: &[known(&[(1.0, "opening", Irradiance)], 10.0 * PI)],
    },
    Exhibit {
        file: "mirror_room.toml",
        tolerance: Some(0.5),
        straight: false,
        long: false,
        known: &[known(&[(1.0, "into the mirror", Radiance)], 0.9 * 12.0)],
    },
    Exhibit {
        file: "glass_of_water.toml",
        tolerance: Some(0.3),
        straight: false,
        long: false,
        known: &[known(&[(1.0, "through the glass", Radiance)], 0.2)],
    },
    Exhibit {
        file: "prism.toml",
        tolerance: None,
        straight: false,
        long: false,
        known: &[
            known(&[(1.0, "violet", Irradiance)], 89.481_380_266_940_32),
            known(&[(1.0, "blue", Irradiance)], 88.627_171_818_861_67),
            known(&[(1.0, "green", Irradiance)], 87.824_269_240_285_87),
            known(&[(1.0, "red", Irradiance)], 87.068_521_655_209_07),
        ],
    },
    Exhibit {
        file: "street_light.toml",
        tolerance: Some(3e-2),
        straight: false,
        long: false,
        known: &[known(&[(1.0, "past the lamp", Radiance)], 2.362895535714765)],
    },
    Exhibit {
        file: "slab.toml",
        tolerance: Some(1e-2),
        straight: false,
        long: false,
        known: &[known(&[(1.0, "reflected", Irradiance)], PI * 0.352_712_039_836_127)],
    },
    Exhibit {
        file: "cloud.toml",
        tolerance: Some(0.5),
        straight: false,
        long: false,
        known: &[known(&[(1.0, "beside the cloud", Radiance)], 0.5)],
    },
    Exhibit {
        file: "round_the_corner.toml",
        tolerance: None,
        straight: false,
        long: false,
        // all bins together are what arrives of steady light
        known: &[known(&[(1.0, "in time", Irradiance), (-1.0, "steady", Irradiance)], 0.0)],
    },
];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes")
}

/// The scene of a file of the gallery, as it is.
fn scene(file: &str) -> Scene {
    open(&folder().join(file)).unwrap_or_else(|errors| panic!("{}", errors[0]))
}

impl Exhibit {
    /// The scene, simulated, and the tolerance that was asked for.
    fn simulated(&self) -> (Simulation, f64) {
        let mut scene = scene(self.file);
        scene.solve.tolerance = self.tolerance.unwrap_or(scene.solve.tolerance);
        if self.straight {
            let place = scene.surfaces[0].place.clone();
            let (effect, force) = (Effect::Interreflection, Force::Off);
            scene.solve.forced.push(ForcedEffect { effect, force, place });
        }
        let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
        (simulate(&scene, &plan, &Unwatched), scene.solve.tolerance)
    }

    /// Asserts that what is known lies within what is said, and that within what was asked for.
    fn assert_true(&self) {
        let (found, tolerance) = self.simulated();
        for known in self.known {
            known.assert_within(self.file, &found.answers);
        }
        for answer in &found.answers {
            let scale = scale(answer, &found.answers);
            let (name, error) = (&answer.receiver, answer.error);
            assert!(error <= tolerance * scale, "{}: {name}: {error:e} is not what was asked for", self.file);
        }
        for map in &found.maps {
            let largest = map.values[0].iter().copied().fold(0.0, f64::max);
            let are_enough =
                map.errors[0].iter().all(|&error| error.is_nan() || error <= tolerance * largest);
            assert!(largest > 0.0 && are_enough, "{}: the map is not what was asked for", self.file);
        }
    }
}

impl Known {
    fn assert_within(&self, file: &str, answers: &[Answer]) {
        let [mut value, mut error] = [0.0, self.idealised];
        for &(factor, receiver, quantity) in self.sum {
            let [found, said] = total(answers, receiver, quantity);
            value += factor * found;
            error += factor.abs() * said;
        }
        let off = (value - self.value).abs();
        // the known value is rounded too
        let rounding = 4.0 * f64::EPSILON * self.value.abs();
        let name = self.sum[0].1;
        assert!(off <= error + rounding, "{file}: {name}: {value} is off by {off:e}, said {error:e}");
    }
}

/// A number in all bands and bins together, and its error: of standard errors four, so that a right answer fails once in 10⁴.
fn total(answers: &[Answer], receiver: &str, quantity: Quantity) -> [f64; 2] {
    let is_meant = |answer: &&Answer| answer.receiver == receiver && answer.quantity == quantity;
    let meant = answers.iter().filter(is_meant);
    assert!(meant.clone().next().is_some(), "{receiver} has no {quantity:?}");
    let value = meant.clone().map(|answer| answer.value).sum();
    let error =
        |answer: &Answer| if answer.kind == ErrorKind::Sigma { 4.0 * answer.error } else { answer.error };
    [value, meant.map(error).sum()]
}

/// What the tolerance of an answer is relative to: of a component of a flow, the fluence rate; of a bin of time, the largest.
fn scale(answer: &Answer, answers: &[Answer]) -> f64 {
    if answer.bin.is_some() {
        let of_receiver = answers.iter().filter(|other| other.receiver == answer.receiver);
        return of_receiver.map(|other| other.value).fold(0.0, f64::max);
    }
    match answer.quantity {
        VectorIrradiance(_) => find(answers, &answer.receiver, FluenceRate).value,
        // of a band in which nothing was found, an error is of what could have been
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
    GALLERY.iter().filter(is_meant).for_each(Exhibit::assert_true);
}

#[test]
fn squares_near_each_other_have_the_mean_irradiance_of_their_view_factor() {
    let scene = scene("near_squares.toml");
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let found = simulate(&scene, &plan, &Unwatched);
    known(&[(1.0, "receiver", Irradiance)], 0.999_998_000_010_029_5)
        .assert_within("near_squares.toml", &found.answers);
}
