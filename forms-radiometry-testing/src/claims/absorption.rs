//! Absorption along rays: e^(−σ d), through several media in turn, and in a scene that one medium
//! fills.

use super::Claim;
use forms_testing::scene_text::elements::{
    cuboid, filled_with, gas, medium, point_light, probe, ray, shining, sphere, square,
};
use forms_testing::scene_text::{material, point_receiver, surface};
use std::f64::consts::PI;

/// Returns a lamp of radiance 1 that looks down from this height.
fn lamp(height: f64) -> String {
    material("black", 0) + &surface("lamp", "black", &shining(&square(height, 1.0, false), 1))
}

fn up(name: &str) -> String {
    ray(name, [0.0; 3], [0.0, 0.0, 1.0])
}

fn sheet(of: &str, [low, high]: [f64; 2]) -> String {
    cuboid(of, of, [[-3.0, -3.0, low], [3.0, 3.0, high]], false, "")
}

pub(super) fn claims() -> Vec<Claim> {
    let haze = || medium("haze", [&0.7, &0, &0, &1]) + &filled_with("haze");
    let oblique = 3.0_f64.sqrt();
    vec![
        Claim::new("light decays along a ray", &[haze(), lamp(3.0), up("ray")])
            .radiance("ray", (-2.1_f64).exp()),
        // the project's reference `beer-s0.5-t2.0`
        Claim::new(
            "light decays in a box of gas",
            &[gas("gas", 0.5, 0, 0), sheet("gas", [1.0, 3.0]), lamp(4.0), up("ray")],
        )
        .radiance("ray", 0.367_879_441_171_442_33),
        Claim::new(
            "light decays in two gases, one after the other",
            &[
                gas("thin", 0.25, 0, 0),
                gas("thick", 2, 0, 0),
                sheet("thin", [0.5, 1.5]),
                sheet("thick", [2.0, 2.25]),
                lamp(3.0),
                ray("ray", [0.0; 3], [1.0 / 8.0, 1.0 / 8.0, oblique / 4.0]),
            ],
        )
        .radiance("ray", (-0.75 * (1.0 + 1.0 / 6.0_f64).sqrt()).exp()),
        Claim::new(
            "one gas lies in another one",
            &[
                gas("outer", 0.5, 0, 0),
                gas("inner", 3, 0, 0),
                sheet("outer", [0.5, 2.5]),
                cuboid("inner", "inner", [[-1.0, -1.0, 1.0], [1.0, 1.0, 1.5]], false, ""),
                lamp(4.0),
                up("ray"),
            ],
        )
        .radiance("ray", (-0.5 * 1.5 - 3.0 * 0.5_f64).exp()),
        Claim::new(
            "a hollow in fog absorbs nothing",
            &[haze(), gas("nothing", 0, 0, 0), sheet("nothing", [1.0, 2.0]), lamp(3.0), up("ray")],
        )
        .radiance("ray", (-1.4_f64).exp()),
        Claim::new(
            "a point lights a plane through gas and the air before it",
            &[
                gas("gas", 0.5, 0, 0),
                sheet("gas", [0.5, 1.5]),
                point_light([0.0, 0.0, 2.0], 3),
                point_receiver("plane", [0.0; 3], [0.0, 0.0, 1.0]),
            ],
        )
        .irradiance("plane", 0.75 * (-0.5_f64).exp()),
        Claim::new(
            "a ball that shines in fog, from its middle's distance",
            &[
                haze(),
                material("black", 0),
                surface("shell", "black", &shining(&sphere([0.0; 3], 2.0, true), 1)),
                probe("middle", [0.0; 3]),
            ],
        )
        .fluence("middle", 4.0 * PI * (-1.4_f64).exp(), [0.0; 3]),
    ]
}
