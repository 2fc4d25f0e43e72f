//! Known answers of the scenes of the gallery: sums of answers and their values, with which tests
//! and figures compare the results.

use forms_radiometry::simulation::Quantity::{
    self, FluenceRate, Flux, Irradiance, Radiance, VectorIrradiance,
};
use forms_radiometry::simulation::{Answer, ErrorKind};
use std::f64::consts::PI;

/// A scene of the gallery and its known answers.
pub struct Exhibit {
    /// File of the scene.
    pub file: &'static str,
    /// Tolerance of the test, where the tolerance of the file would take long in a program that is
    /// not optimised.
    pub tolerance: Option<f64>,
    /// Whether reflected light is omitted, because it would take long.
    pub straight: bool,
    /// Whether it takes minutes where the numeric code is not optimised, so that only tests of the
    /// release build simulate it.
    pub long: bool,
    /// Its known answers.
    pub known: &'static [Known],
}

/// Sum of answers whose value is known.
pub struct Known {
    /// The answers, each with its factor.
    pub sum: &'static [(f64, &'static str, Quantity)],
    /// Value of the sum.
    pub value: f64,
    /// Difference between the scene itself and the idealised scene of the value.
    pub idealised: f64,
}

/// Returns a known answer of a scene that is not idealised.
pub const fn known(sum: &'static [(f64, &'static str, Quantity)], value: f64) -> Known {
    Known { sum, value, idealised: 0.0 }
}

/// Scenes of the gallery with known answers.
pub const GALLERY: [Exhibit; 17] = [
    Exhibit {
        file: "black_squares.toml",
        tolerance: None,
        straight: false,
        long: false,
        known: &[Known {
            sum: &[(1.0, "dark square", Irradiance)],
            value: 0.199_824_895_698_387,
            // both reflect two thousandths: ρ² F² of the light comes back
            idealised: 1e-6,
        }],
    },
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
        // both in an infinite groove; the part missing beyond the ends of this one is below ⅔ x
        // L/(π 20³)
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
        known: &[known(&[(1.0, "next to the cloud", Radiance)], 0.5)],
    },
    Exhibit {
        file: "round_the_corner.toml",
        tolerance: None,
        straight: false,
        long: false,
        // all bins together hold the steady light
        known: &[known(&[(1.0, "in time", Irradiance), (-1.0, "steady", Irradiance)], 0.0)],
    },
];

impl Known {
    /// Returns the sum of the found answers, and its error.
    pub fn found(&self, answers: &[Answer]) -> [f64; 2] {
        let [mut value, mut error] = [0.0, self.idealised];
        for &(factor, receiver, quantity) in self.sum {
            let [found, said] = total(answers, receiver, quantity);
            value += factor * found;
            error += factor.abs() * said;
        }
        [value, error]
    }
}

/// Returns a number in all bands and bins together, and its error. A standard error counts four
/// times, so that a right answer fails once in 10⁴.
fn total(answers: &[Answer], receiver: &str, quantity: Quantity) -> [f64; 2] {
    let is_meant = |answer: &&Answer| answer.receiver == receiver && answer.quantity == quantity;
    let meant = answers.iter().filter(is_meant);
    assert!(meant.clone().next().is_some(), "{receiver} has no {quantity:?}");
    let value = meant.clone().map(|answer| answer.value).sum();
    let error =
        |answer: &Answer| if answer.kind == ErrorKind::Sigma { 4.0 * answer.error } else { answer.error };
    [value, meant.map(error).sum()]
}
