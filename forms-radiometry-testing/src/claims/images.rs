//! Images: the mean of all pixels is the mean radiance over the film.

use super::Claim;
use super::integral::integral;
use forms_testing::scene_text::elements::{
    self, camera, cuboid, distant_light, effects, filled_with, glass, medium, mirror_aside, ray, shining,
    sky, square,
};
use forms_testing::scene_text::{material, surface};
use std::f64::consts::PI;

/// Returns half of the width and half of the height of the film at unit distance, for a vertical
/// field of view of 60 degrees and an aspect ratio of 4 to 3.
fn half_film() -> [f64; 2] {
    let high = 30.0_f64.to_radians().tan();
    [high * 4.0 / 3.0, high]
}

/// Returns the mean over the film of a radiance that depends on the secant of the angle to the line
/// of sight.
fn mean(seen: impl Fn(f64) -> f64) -> f64 {
    let [wide, high] = half_film();
    let row = |b: f64| integral([0.0, wide], |a| seen((1.0 + a * a + b * b).sqrt()));
    integral([0.0, high], row) / (wide * high)
}

fn looking_down() -> String {
    camera([[0.0, 0.0, 2.0], [0.0; 3], [0.0, 1.0, 0.0]], 60.0, [4, 3])
}

/// Claims a floor that emits below a haze that absorbs.
pub fn floor_in_haze() -> Claim {
    let tables = [
        medium("haze", [&0.4, &0, &0, &1]),
        filled_with("haze"),
        material("black", 0),
        surface("floor", "black", &shining(&square(0.0, 99.0, true), 1)),
        looking_down(),
    ];
    Claim::new("a floor seen through haze", &tables).radiance("camera", mean(|secant| (-0.8 * secant).exp()))
}

pub(super) fn claims() -> Vec<Claim> {
    let sea = [
        medium("black water", [&9, &0, &0, &1.33]),
        elements::dielectric("black water"),
        cuboid("sea", "black water", [[-999.0, -999.0, -99.0], [999.0, 999.0, 0.0]], false, ""),
        sky(1),
        looking_down(),
    ];
    let lit_floor = [
        material("grey", 0.5),
        surface("floor", "grey", &square(0.0, 99.0, true)),
        distant_light([0.0, 0.0, -1.0], PI),
        mirror_aside(),
        ray("ray", [0.0, 0.0, 2.0], [0.1, 0.0, -1.0]),
        looking_down(),
        effects("interreflection = \"off\""),
    ];
    vec![
        Claim::new("what an eye sees reflects to it without interreflection", &lit_floor)
            .radiance("ray", 0.5)
            .radiance("camera", 0.5),
        floor_in_haze(),
        Claim::new("the sky in black water", &sea)
            .radiance("camera", mean(|secant| super::integral::fresnel(1.33, 1.0 / secant))),
        Claim::new(
            "a floor under glass that reflects nothing",
            &[
                glass("clear", 1),
                cuboid("plate", "clear", [[-9.0, -9.0, 0.5], [9.0, 9.0, 1.0]], false, ""),
                medium("haze", [&0.4, &0, &0, &1]),
                filled_with("haze"),
                material("black", 0),
                surface("floor", "black", &shining(&square(0.0, 99.0, true), 1)),
                looking_down(),
            ],
        )
        .radiance("camera", mean(|secant| (-0.6 * secant).exp())),
    ]
}
