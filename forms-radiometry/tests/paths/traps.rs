//! Light traps: a scene whose light can never leave and is never absorbed is refused, with the
//! surface and its place. A scene that only looks like one is not.

use forms_radiometry::scene::read;
use forms_radiometry::simulation::plan;
use forms_testing::scene_text::elements::{
    basin, cuboid, filled_with, gas, glass, medium, mirror, point_light, probe, shining, sky, sphere, square,
};
use forms_testing::scene_text::{material, polygon, surface};

fn lamp() -> String {
    material("black", 0) + &surface("lamp", "black", &shining(&sphere([0.5; 3], 0.1, false), 1))
}

fn facing(reflectance: f64) -> String {
    let polygons = [
        polygon(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]),
        polygon(&[[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]]),
    ];
    mirror("silver", reflectance)
        + &surface("lower mirror", "silver", &polygons[0])
        + &surface("upper mirror", "silver", &polygons[1])
}

/// Returns a small flat lamp: a point light would be refused next to mirrors.
fn spark() -> String {
    material("grey", 1) + &surface("spark", "grey", &shining(&square(0.5, 0.01, true), 1))
}

const UNIT: [[f64; 3]; 2] = [[0.0; 3], [1.0; 3]];

fn planned(tables: &[String]) -> Result<(), String> {
    let text = tables.concat() + &probe("probe", [0.3, 0.3, 0.6]);
    let scene = read(&text, "trap.toml").unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]));
    plan(&scene).map(drop).map_err(|errors| errors.iter().map(|error| format!("{error}\n")).collect())
}

#[test]
fn light_that_can_never_leave_is_refused_with_its_place() {
    let shell = |more: &str| surface("shell", "silver", &(sphere([0.5; 3], 2.0, true) + more));
    let white = || material("white", 1) + &cuboid("room", "white", UNIT, true, "\nradiance = 1");
    let cases: [(&str, Vec<String>, &[&str]); 6] = [
        (
            "two facing mirrors with a lamp between them",
            vec![facing(1.0), spark()],
            &["lower mirror", "upper mirror"],
        ),
        (
            "a closed box of reflectance 1, with fog in it",
            vec![white(), medium("fog", [&0, &1, &0, &1]), filled_with("fog")],
            &["room_"],
        ),
        (
            "a closed box of reflectance 1 around the second of two point lights, with fog in it",
            vec![
                material("white", 1) + &cuboid("room", "white", UNIT, true, ""),
                point_light([3.0; 3], 1),
                point_light([0.5; 3], 1),
                medium("fog", [&0, &1, &0, &1]),
                filled_with("fog"),
            ],
            &["room_"],
        ),
        (
            "a lamp of no body in a cube of clear glass",
            vec![
                glass("glass", 1.5),
                cuboid("cube", "glass", UNIT, false, ""),
                mirror("silver", 1),
                surface("lamp", "silver", &(square(0.5, 0.1, true) + "\nradiance = 1\ntwo_sided = true")),
            ],
            &["cube_", "lamp"],
        ),
        (
            "a closed mirror sphere that shines",
            vec![mirror("silver", 1), shell("\nradiance = 1")],
            &["shell"],
        ),
        (
            "a closed mirror sphere around a lamp that absorbs nothing",
            vec![
                mirror("silver", 1),
                shell(""),
                material("white", 1),
                surface("lamp", "white", &shining(&sphere([0.5; 3], 0.1, false), 1)),
            ],
            &["shell", "lamp"],
        ),
    ];
    for (what, tables, surfaces) in cases {
        let Err(message) = planned(&tables) else { panic!("{what} is refused") };
        assert!(surfaces.iter().any(|name| message.contains(&format!("`{name}"))), "{what}: {message}");
        assert!(
            message.contains("trap.toml:") && message.contains("reflectance below 1"),
            "{what}: {message}"
        );
    }
}

#[test]
fn what_lets_light_out_is_not_refused() {
    let nested = || {
        glass("glass", 1.5)
            + &surface("bowl", "glass", &sphere([0.5; 3], 0.4, false))
            + &glass("water", 1.33)
            + &surface("drop", "water", &sphere([0.5; 3], 0.3, false))
    };
    let open =
        || material("white", 1) + &cuboid("room", "white", UNIT, true, "").replacen("room_ceiling", "lid", 1);
    let without_lid = || {
        let tables: Vec<String> = open()
            .split("[[surface]]")
            .filter(|table| !table.contains("\"lid\""))
            .map(String::from)
            .collect();
        tables.join("[[surface]]")
    };
    let far_lamp = || material("black", 0) + &surface("lamp", "black", &shining(&square(3.0, 1.0, false), 1));
    let cases: [(&str, Vec<String>); 8] = [
        ("water in glass under the sky", vec![nested(), sky(1)]),
        ("water in glass below a lamp", vec![nested(), far_lamp()]),
        ("a basin of water with black walls", vec![glass("water", 1.33), basin("water", UNIT, 0.0), sky(1)]),
        (
            "an open white box with a mirror aside, below a lamp",
            vec![without_lid(), far_lamp(), forms_testing::scene_text::elements::mirror_aside()],
        ),
        (
            "a mirror beside a lamp",
            vec![mirror("silver", 1), surface("mirror", "silver", &square(0.0, 1.0, true)), lamp()],
        ),
        ("two facing mirrors that absorb a little", vec![facing(0.999), spark()]),
        (
            "two facing mirrors in haze",
            vec![facing(1.0), spark(), medium("haze", [&1e-3, &0, &0, &1]), filled_with("haze")],
        ),
        (
            "a cloud in a closed box that absorbs a little",
            vec![
                material("white", 0.99),
                cuboid("room", "white", UNIT, true, "\nradiance = 1"),
                gas("cloud", 0, 9, 0),
                surface("cloud", "cloud", &sphere([0.5; 3], 0.1, false)),
            ],
        ),
    ];
    for (what, tables) in cases {
        assert_eq!(planned(&tables), Ok(()), "{what}");
    }
}

#[test]
fn a_medium_in_which_paths_never_end_is_refused_with_its_place() {
    let mist = |absorption: f64| medium("mist", [&absorption, &1, &0, &1]) + &filled_with("mist");
    let room = || material("grey", 0.5) + &cuboid("room", "grey", UNIT, true, "\nradiance = 1");
    let orders = || "[solve]\neffects = { scattering = 3 }\n".to_owned();
    let outside = || probe("outside", [3.0, 0.3, 0.3]);
    let endless: [(&str, Vec<String>); 3] = [
        ("a lamp in open mist", vec![lamp(), mist(0.0)]),
        ("a receiver beside a closed room", vec![room(), mist(0.0), outside()]),
        (
            "a lamp above a floor",
            vec![lamp(), surface("floor", "black", &square(0.0, 9.0, false)), mist(0.0)],
        ),
    ];
    for (what, tables) in endless {
        let Err(message) = planned(&tables) else { panic!("{what} is refused") };
        assert!(
            message.contains("trap.toml:") && message.contains("the medium `mist` is unbounded"),
            "{what}: {message}"
        );
    }
    let ends: [(&str, Vec<String>); 4] = [
        ("a closed room", vec![room(), mist(0.0)]),
        ("open mist that absorbs a little", vec![lamp(), mist(1e-3)]),
        ("some orders of scattering", vec![lamp(), mist(0.0), orders()]),
        (
            "a ball of mist in a vacuum",
            vec![lamp(), gas("mist", 0, 1, 0), surface("ball", "mist", &sphere([0.5; 3], 0.4, false))],
        ),
    ];
    for (what, tables) in ends {
        assert_eq!(planned(&tables), Ok(()), "{what}");
    }
}
