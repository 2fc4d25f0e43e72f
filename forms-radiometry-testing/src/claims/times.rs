//! Time: light arrives at the time of its optical path length, ∫ n ds/c after the pulse, and the
//! sum of all bins is the answer without time.

use super::Claim;
use forms_radiometry::simulation::Quantity;
use forms_testing::scene_text::elements::{
    cuboid, dielectric, effects, filled_with, gas, glass, medium, mirror, point_light, probe, ray, shining,
    sphere, square, time,
};
use forms_testing::scene_text::{material, point_receiver, polygon, surface};
use std::f64::consts::PI;

/// Time in which light travels a metre, in seconds.
const METRE: f64 = 1.0 / 299_792_458.0;

/// Returns bins: one has this value, and all others are zero.
fn alone<const BINS: usize>(bin: usize, value: f64) -> [f64; BINS] {
    std::array::from_fn(|other| if other == bin { value } else { 0.0 })
}

fn lamp(height: f64) -> String {
    material("black", 0) + &surface("lamp", "black", &shining(&square(height, 1.0, false), 2))
}

/// Claims the light at the centre of a sphere of radius 1 that emits radiance 1 and reflects ρ,
/// with at most one reflection. Reflected light travels a chord s whose square is uniformly
/// distributed between 0 and 4.
fn echo() -> Claim {
    const RHO: f64 = 0.6;
    let once = |from: f64, to: f64| 4.0 * PI * RHO * (to * to - from * from) / 4.0;
    let tables = [
        material("white", RHO),
        surface("shell", "white", &shining(&sphere([0.0; 3], 1.0, true), 1)),
        probe("middle", [0.0; 3]),
        time(0.5 * METRE, METRE, 4),
        effects("interreflection = 1"),
    ];
    let bins = [4.0 * PI + once(0.0, 0.5), once(0.5, 1.5), once(1.5, 2.0), 0.0];
    Claim::new("an echo in a sphere comes after chords", &tables).bins("middle", Quantity::FluenceRate, &bins)
}

/// Claims the light through a plate of glass between a ray and a lamp: light that is reflected
/// twice inside arrives 2 n d later.
fn plate() -> Claim {
    let tables = [
        glass("glass", 1.5),
        cuboid("plate", "glass", [[-1.0, -1.0, 0.5], [1.0, 1.0, 1.5]], false, ""),
        material("black", 0),
        surface("lamp", "black", &shining(&square(2.25, 1.0, false), 1)),
        ray("ray", [0.0; 3], [0.0, 0.0, 1.0]),
        time(0.0, METRE, 9),
    ];
    let order = |k: i32| 0.96_f64.powi(2) * 0.04_f64.powi(2 * k);
    let bins = [0.0, 0.0, order(0), 0.0, 0.0, order(1), 0.0, 0.0, order(2)];
    Claim::new("echoes in a plate of glass come 2 n d after each other", &tables).bins(
        "ray",
        Quantity::Radiance,
        &bins,
    )
}

pub(super) fn claims() -> Vec<Claim> {
    let up = || ray("ray", [0.0; 3], [0.0, 0.0, 1.0]);
    let slanted = polygon(&[[-1.0, -1.0, 1.0], [-1.0, 1.0, 1.0], [1.0, 1.0, 3.0], [1.0, -1.0, 3.0]]);
    let wall = polygon(&[[1.5, -1.0, 1.0], [1.5, -1.0, 3.0], [1.5, 1.0, 3.0], [1.5, 1.0, 1.0]]);
    vec![
        Claim::new(
            "light in a liquid takes n d/c",
            &[
                medium("liquid", [&0, &0, &0, &1.5]),
                filled_with("liquid"),
                lamp(3.0),
                up(),
                time(0.0, METRE, 8),
            ],
        )
        .bins("ray", Quantity::Radiance, &alone::<8>(4, 2.0)),
        Claim::new(
            "light by way of a mirror takes the time of both ways",
            &[
                mirror("silver", 0.9),
                surface("mirror", "silver", &slanted),
                material("black", 0),
                surface("lamp", "black", &shining(&wall, 2)),
                up(),
                time(METRE, METRE, 5),
            ],
        )
        .bins("ray", Quantity::Radiance, &alone::<5>(2, 1.8)),
        Claim::new(
            "the pulse of a point arrives at once",
            &[
                gas("gas", 0.5, 0, 0),
                cuboid("box", "gas", [[-1.0, -1.0, 1.0], [1.0, 1.0, 2.0]], false, ""),
                point_light([0.0, 0.0, 2.5], 5),
                point_receiver("here", [0.0; 3], [0.0, 0.0, 1.0]),
                time(0.0, METRE, 4),
            ],
        )
        .bins("here", Quantity::Irradiance, &alone::<4>(2, 0.8 * (-0.5_f64).exp())),
        echo(),
        plate(),
        Claim::new(
            "all bins of a furnace hold its answer",
            &[
                material("white", 0.5),
                cuboid("room", "white", [[0.0; 3], [1.0; 3]], true, "\nradiance = 1"),
                medium("opal", [&0, &2, &0, &1.5]) + &dielectric("opal"),
                surface("ball", "opal", &sphere([0.5; 3], 0.2, false)),
                probe("probe", [0.2; 3]),
                time(0.0, 1e3, 1),
            ],
        )
        .bins("probe", Quantity::FluenceRate, &[8.0 * PI]),
    ]
}
