//! Furnaces: in a closed room whose walls all emit, L = Lₑ/(1 − ρ) in vacuum, whatever objects are
//! in it that absorb nothing, and n² times that where the index is n.

use super::Claim;
use forms_testing::scene_text::elements::{
    self, camera, cuboid, filled_with, gas, glass, medium, mirror, probe, ray, shining, sphere, two_sided,
};
use forms_testing::scene_text::{material, point_receiver, polygon, surface, surface_receiver};
use std::f64::consts::PI;

/// Reflectance of the walls, which emit Lₑ = 1.
const WALLS: f64 = 0.5;
/// Radiance of the walls, including reflected light.
const RADIANCE: f64 = 2.0;
const UNIT: [[f64; 3]; 2] = [[0.0; 3], [1.0; 3]];

fn room(reflectance: f64) -> String {
    material("white", reflectance) + &cuboid("room", "white", UNIT, true, "\nradiance = 1")
}

fn shell(reflectance: f64) -> String {
    material("white", reflectance) + &surface("shell", "white", &shining(&sphere([0.0; 3], 2.0, true), 1))
}

/// Returns a receiver of each kind in the cube.
fn receivers() -> String {
    [
        point_receiver("point", [0.2, 0.3, 0.0], [0.0, 0.0, 1.0]),
        surface_receiver("room_left"),
        ray("ray", [0.1, 0.2, 0.3], [3.0, 2.0, 1.0]),
        probe("sphere", [0.2, 0.7, 0.9]),
        camera([[0.1, 0.1, 0.1], [1.0, 1.0, 1.0], [0.0, 0.0, 1.0]], 60.0, [3, 2]),
    ]
    .concat()
}

/// Claims the answers of those receivers under a radiance that is the same everywhere.
fn everywhere(name: &'static str, tables: &[String], radiance: f64) -> Claim {
    let tables = [tables, &[receivers()]].concat();
    Claim::new(name, &tables)
        .irradiance("point", PI * radiance)
        .irradiance("room_left", PI * radiance)
        .flux("room_left", PI * radiance)
        .radiance("ray", radiance)
        .fluence("sphere", 4.0 * PI * radiance, [0.0; 3])
        .radiance("camera", radiance)
}

/// Claims a room of black walls that emit, full of fog. Near walls are found by chance, and distant
/// walls by next-event estimation.
fn fog_in_the_dark(name: &'static str, sigma: f64, g: f64) -> Claim {
    everywhere(name, &[room(0.0), gas("fog", 0, sigma, g), filled_with("fog")], 1.0).within(5e-3)
}

/// Claims the irradiance of a point in a furnace with a mirror in it.
pub fn furnace_of(reflectance: f64) -> Claim {
    let ball = mirror("silver", 1) + &surface("ball", "silver", &sphere([0.5; 3], 0.25, false));
    let here = point_receiver("here", [0.2, 0.3, 0.0], [0.0, 0.0, 1.0]);
    Claim::new("a furnace with a mirror in it", &[room(reflectance), ball, here])
        .irradiance("here", PI / (1.0 - reflectance))
}

/// Claims the light in a cube of glass in a furnace. The cosines of light inside to the faces do
/// not change, so only light in one of the six cones of total reflection ever came from outside.
/// The project's reference `n2-escape-cone` is half of one of them, (1 − √(1 − 1/n²))/2.
fn glass_cube() -> Claim {
    const CONE: f64 = 0.127_322_003_750_035_05;
    let radiance = 1.5 * 1.5 * RADIANCE;
    let tables = [
        shell(WALLS),
        glass("glass", 1.5),
        cuboid("cube", "glass", [[-0.5; 3], [0.5; 3]], false, ""),
        probe("inside", [0.1, 0.2, 0.3]),
        ray("from outside", [0.1, 0.2, 0.3], [1.03, 1.9, 3.0]),
        ray("caught", [0.1, 0.2, 0.3], [1.0, -1.0, 1.1]),
    ];
    Claim::new("in a cube of glass no light is where none can get", &tables)
        .fluence("inside", 6.0 * 4.0 * PI * CONE * radiance, [0.0; 3])
        .radiance("from outside", radiance)
        .radiance("caught", 0.0)
        .within(0.2)
}

pub(super) fn claims() -> Vec<Claim> {
    let panel =
        |more: &str| polygon(&[[0.5, 0.2, 0.2], [0.5, 0.8, 0.2], [0.5, 0.8, 0.8], [0.5, 0.2, 0.8]]) + more;
    let perfect = || mirror("silver", 1) + &surface("panel", "silver", &two_sided(&panel("")));
    let emitting =
        mirror("silver", 0.6) + &surface("panel", "silver", &two_sided(&panel("\nradiance = 0.8")));
    let ball = |of: &str, radius: f64| surface(of, of, &sphere([0.5; 3], radius, false));
    let sights = |place: [f64; 3]| ray("ray", place, [1.0, 2.0, 3.0]) + &probe("sphere", place);
    let seen = |claim: Claim, radiance: f64| {
        claim.radiance("ray", radiance).fluence("sphere", 4.0 * PI * radiance, [0.0; 3])
    };
    let index = |n: f64| n * n * RADIANCE;
    let in_ball = |name, tables: &[String], n: f64| {
        seen(Claim::new(name, &[tables, &[sights([0.6, 0.5, 0.4])]].concat()), index(n))
    };
    vec![
        fog_in_the_dark("fog in a room of black walls that shine", 3.0, 0.0),
        fog_in_the_dark("thin fog that scatters forwards in the same room", 0.3, 0.6),
        everywhere("a mirror that absorbs nothing stands in a furnace", &[room(WALLS), perfect()], RADIANCE),
        everywhere("a mirror that absorbs emits what it takes", &[room(WALLS), emitting], RADIANCE),
        everywhere("the walls of a furnace reflect nearly all", &[room(0.9), perfect()], 10.0).within(0.1),
        everywhere(
            "a ball of glass lies in a furnace",
            &[room(WALLS), glass("glass", 1.5), ball("glass", 0.15)],
            RADIANCE,
        ),
        everywhere(
            "fog fills a furnace",
            &[room(WALLS), medium("fog", [&0, &1.5, &0.6, &1]), filled_with("fog")],
            RADIANCE,
        ),
        everywhere(
            "fog that looks back fills a furnace",
            &[room(WALLS), medium("fog", [&0, &2, &-0.7, &1]), filled_with("fog")],
            RADIANCE,
        ),
        everywhere(
            "a cloud floats in a furnace",
            &[room(WALLS), gas("cloud", 0, 5, 0.3), ball("cloud", 0.2)],
            RADIANCE,
        ),
        everywhere(
            "water fills a furnace whose walls emit into it",
            &[room(WALLS), medium("water", [&0, &0, &0, &1.33]), filled_with("water"), perfect()],
            RADIANCE,
        ),
        in_ball(
            "radiance in glass is n² times that around it",
            &[room(WALLS), glass("glass", 1.5), ball("glass", 0.3)],
            1.5,
        ),
        in_ball(
            "radiance in a bubble of low index is n² times that around it",
            &[room(WALLS), glass("thin", 0.8), ball("thin", 0.3)],
            0.8,
        ),
        in_ball(
            "radiance in milky glass is n² times that around it",
            &[
                room(WALLS),
                medium("opal", [&0, &3, &0.2, &1.5]),
                elements::dielectric("opal"),
                ball("opal", 0.3),
            ],
            1.5,
        ),
        in_ball(
            "radiance in water in glass is that of water alone",
            &[room(WALLS), glass("glass", 1.5), ball("glass", 0.4), glass("water", 1.33), ball("water", 0.3)],
            1.33,
        ),
        glass_cube(),
        seen(
            Claim::new(
                "a sphere of a diffuse wall with a mirror sphere in it",
                &[
                    shell(WALLS),
                    mirror("silver", 1),
                    surface("ball", "silver", &sphere([0.0; 3], 0.5, false)),
                    sights([0.0, 1.0, 1.0]),
                ],
            ),
            RADIANCE,
        ),
    ]
}
