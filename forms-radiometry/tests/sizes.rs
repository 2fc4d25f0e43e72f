//! Scenes of any size: view factors, irradiance and radiance do not depend on the size, and a flux
//! grows with the area.

use forms_radiometry::geometry::{Disk, Polygon, Quadric, Sphere, Vector};
use forms_radiometry::scene::{
    Effect, Force, ForcedEffect, LengthUnit, LightKind, ReceiverKind, Scene, Shape, read, read_with_files,
};
use forms_radiometry::simulation::{Answer, Quantity, Unwatched, plan, simulate};
use forms_radiometry::view_factors;
use std::path::Path;
use std::sync::Arc;

use forms_testing::scene_text::{material, point_receiver, polygon, surface, surface_receiver};

/// Sizes from one end of the range to the other.
const SIZES: [f64; 4] = [1e-150, 1e-70, 1e70, 1e150];

/// Sizes for scenes that contain lengths of very different sizes themselves.
const HARD_SIZES: [f64; 4] = [1e-140, 1e-70, 1e70, 1e140];
/// Powers of two, by which coordinates are multiplied without rounding.
const POWERS: [i32; 4] = [-498, -232, 232, 498];

/// Change of an answer by rounding of coordinates; and its change by way of comparisons, as a part
/// of its error.
const ROUNDING: [f64; 2] = [1e-11, 1e-2];
/// Factor by which the error of an answer may differ: an error is computed from differences.
const OF_ERROR: f64 = 1.5;

/// Returns a scene of the gallery, at a tolerance of a few per cent and without maps.
fn gallery(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let text = std::fs::read_to_string(folder.join(name)).unwrap();
    let scene = read_with_files(&text, name, &|file| std::fs::read(folder.join(file)));
    let mut scene = scene.unwrap_or_else(|errors| panic!("{}", errors[0]));
    scene.solve.tolerance = 5e-2;
    for receiver in &mut scene.receivers {
        if let ReceiverKind::Surface { grid, .. } = &mut receiver.kind {
            *grid = None;
        }
    }
    scene
}

fn of_text(text: &str) -> Scene {
    read(text, "test.toml").unwrap_or_else(|errors| panic!("{}", errors[0]))
}

/// Returns the scene with every length multiplied by `size`; a point light keeps the irradiance
/// that it causes.
fn resized(scene: &Scene, size: f64) -> Scene {
    let mut scene = scene.clone();
    let place = |v: Vector| size * v;
    for surface in &mut scene.surfaces {
        surface.shape = match &surface.shape {
            Shape::Polygon(polygon) => {
                Shape::Polygon(Polygon::new(polygon.vertices().iter().map(|&v| place(v)).collect()).unwrap())
            }
            Shape::Mesh(mesh) => Shape::Mesh(Arc::new(mesh.moved(false, place).unwrap())),
            &Shape::Sphere(Sphere { center, radius, inward }) => {
                Shape::Sphere(Sphere { center: place(center), radius: size * radius, inward })
            }
            &Shape::Disk(Disk { center, normal, radius, hole }) => {
                Shape::Disk(Disk { center: place(center), normal, radius: size * radius, hole: size * hole })
            }
            &Shape::Quadric(quadric) => Shape::Quadric(Quadric {
                ends: quadric.ends.map(place),
                radii: quadric.radii.map(|radius| size * radius),
                ..quadric
            }),
        };
    }
    for receiver in &mut scene.receivers {
        match &mut receiver.kind {
            ReceiverKind::Point { position, .. } | ReceiverKind::Sphere { position } => {
                *position = place(*position);
            }
            ReceiverKind::Ray { origin, .. } => *origin = place(*origin),
            ReceiverKind::Points(points) => points.positions.iter_mut().for_each(|p| *p = place(*p)),
            ReceiverKind::Surface { .. } | ReceiverKind::Faces { .. } | ReceiverKind::Camera(_) => {}
        }
    }
    for light in &mut scene.lights {
        if let LightKind::Point { position, intensity } = &mut light.kind {
            *position = place(*position);
            intensity.iter_mut().for_each(|intensity| *intensity *= size * size);
        }
    }
    scene
}

fn answers(scene: &Scene) -> Vec<Answer> {
    let plan = plan(scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    simulate(&plan, &Unwatched).answers
}

/// Asserts that the answers equal those of the scene before its lengths were multiplied by `size`.
fn assert_same(name: &str, size: f64, found: &[Answer], expected: &[Answer]) {
    assert_eq!(found.len(), expected.len());
    let largest =
        expected.iter().filter(|a| a.quantity != Quantity::Flux).fold(0.0, |m: f64, a| m.max(a.value));
    for (found, expected) in found.iter().zip(expected) {
        let unit = if found.quantity == Quantity::Flux { size * size } else { 1.0 };
        let (value, error) = (found.value / unit, found.error / unit);
        let off = (value - expected.value).abs();
        let what = format!("{name} × {size:e}: {} {:?}", found.receiver, found.quantity);
        let allowed = ROUNDING[0] * expected.value.abs().max(largest) + ROUNDING[1] * expected.error;
        assert!(off <= allowed, "{what}: {value} and {}", expected.value);
        assert!(error <= OF_ERROR * expected.error + allowed, "{what}: ± {error:e} and {:e}", expected.error);
    }
}

/// Returns a room with every kind of light and of receiver.
fn room() -> Scene {
    let floor = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [3.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
    let table = [[1.0, 0.5, 0.75], [2.0, 0.5, 0.75], [2.0, 1.5, 0.75], [1.0, 1.5, 0.75]];
    let text = [
        material("grey", 0.5),
        surface("floor", "grey", &polygon(&floor)),
        surface("table", "grey", &format!("{}\ntwo_sided = true", polygon(&table))),
        "[[light]]\nkind = \"point\"\nposition = [0.5, 0.5, 2]\nintensity = 3\n".into(),
        "[[light]]\nkind = \"distant\"\ndirection = [0.3, 0.1, -1]\nirradiance = 2\n".into(),
        point_receiver("under the table", [1.5, 1.0, 0.0], [0.0, 0.0, 1.0]),
        "[[receiver]]\nname = \"sphere\"\nkind = \"sphere\"\nposition = [1.5, 1.1, 0.4]\n".into(),
        "[[receiver]]\nname = \"ray\"\nkind = \"ray\"\norigin = [0.1, 0.2, 1]\ndirection = [1, 1, -0.4]\n"
            .into(),
        surface_receiver("floor"),
        "[ambient]\nradiance = 0.2\n[solve]\ntolerance = 5e-2\n".into(),
    ];
    of_text(&text.concat())
}

fn without_reflection(mut scene: Scene) -> Scene {
    let place = scene.receivers[0].place.clone();
    scene.solve.forced = vec![ForcedEffect { effect: Effect::Interreflection, force: Force::Off, place }];
    scene
}

#[test]
fn irradiance_and_radiance_do_not_depend_on_the_size_of_a_scene_and_flux_is_in_proportion_to_areas() {
    let names = ["cube.toml", "furnace.toml", "occluded_lamp.toml", "opposed_squares.toml", "v_groove.toml"];
    let scenes = names.map(|name| (name, gallery(name)));
    for (name, scene) in scenes.into_iter().chain([("room", without_reflection(room()))]) {
        let expected = answers(&scene);
        for size in SIZES {
            assert_same(name, size, &answers(&resized(&scene, size)), &expected);
        }
    }
}

#[test]
fn a_power_of_two_in_the_size_of_a_scene_changes_no_bit_of_an_answer() {
    for (name, scene) in [("lamp", gallery("occluded_lamp.toml")), ("room", without_reflection(room()))] {
        let expected = answers(&scene);
        for power in POWERS {
            let size = f64::from(power).exp2();
            for (found, expected) in answers(&resized(&scene, size)).iter().zip(&expected) {
                let unit = if found.quantity == Quantity::Flux { size * size } else { 1.0 };
                assert_eq!(found.value / unit, expected.value, "{name} × 2^{power}: {}", found.receiver);
            }
        }
    }
}

#[test]
fn round_shapes_may_have_any_size() {
    let shell = "sphere = { center = [0, 0, 0], radius = 2, inward = true }\nexitance = 1";
    let text = [
        material("grey", 0.5),
        surface("shell", "grey", shell),
        surface("disk", "grey", "disk = { center = [0, 0, -1], normal = [0, 0, 1], radius = 0.5 }"),
        surface_receiver("disk"),
        "[solve]\ntolerance = 0.5\neffects = { interreflection = \"off\" }\n".into(),
    ];
    let scene = of_text(&text.concat());
    let expected = answers(&scene);
    for size in SIZES {
        assert_same("sphere", size, &answers(&resized(&scene, size)), &expected);
    }
}

/// Returns pairs of a square and its view from far away, from nearby, and from a sliver.
fn hard_pairs() -> Vec<(&'static str, Scene)> {
    let square = |height: f64, at: f64, wide: f64| {
        let (low, high) = (at, at + 1.0);
        [[low, at, height], [low, at + wide, height], [high, at + wide, height], [high, at, height]]
    };
    let up = |corners: [[f64; 3]; 4]| {
        let [a, b, c, d] = corners;
        [a, d, c, b]
    };
    let scene = |from: [[f64; 3]; 4], to: [[f64; 3]; 4]| {
        let text = [
            material("black", 0),
            surface("from", "black", &polygon(&from)),
            surface("to", "black", &format!("{}\nexitance = 1", polygon(&to))),
            surface_receiver("from"),
            "[solve]\ntolerance = 1e-6\n".into(),
        ];
        of_text(&text.concat())
    };
    vec![
        ("opposed", scene(up(square(0.0, 0.0, 1.0)), square(1.0, 0.0, 1.0))),
        ("far apart", scene(up(square(0.0, 0.0, 1.0)), square(1e4, 0.0, 1.0))),
        ("near", scene(up(square(0.0, 0.0, 1.0)), square(1e-6, 0.0, 1.0))),
        ("sliver", scene(up(square(0.0, 0.0, 1e-7)), square(1.0, 0.0, 1.0))),
        ("slivers", scene(up(square(0.0, 0.0, 1e-7)), square(1.0, 0.0, 1e-7))),
        ("far from the origin", scene(up(square(0.0, 1e8, 1.0)), square(1.0, 1e8, 1.0))),
    ]
}

#[test]
fn view_factors_do_not_depend_on_the_size_of_a_scene() {
    let names = ["cube.toml", "far_squares.toml", "near_squares.toml", "occluded_lamp.toml"];
    let scenes = names.map(|name| (name, gallery(name)));
    for (name, scene) in scenes.into_iter().chain(hard_pairs()) {
        let expected = view_factors(&scene);
        for size in HARD_SIZES {
            let found = view_factors(&resized(&scene, size));
            // where coordinates are large compared with lengths, rounding of coordinates is an
            // error of the lengths
            let rounding = if name == "far from the origin" { 1e-6 } else { 1e-9 };
            for (found, expected) in found.rows.iter().flatten().zip(expected.rows.iter().flatten()) {
                let off = (found.value - expected.value).abs();
                let what = format!("{name} × {size:e}: {found:?} and {expected:?}");
                assert!(off <= expected.error + rounding * expected.value, "{what}");
                assert!(found.error <= 2.0 * expected.error + rounding * expected.value, "{what}");
            }
            for (found, expected) in found.areas.iter().zip(&expected.areas) {
                assert!((found / size / size - expected).abs() <= rounding * expected, "{name} × {size:e}");
            }
        }
    }
}

#[test]
fn hard_pairs_exchange_the_same_light_in_any_size() {
    for (name, scene) in hard_pairs() {
        // in this square, rounding of coordinates is an error of the lengths
        if name == "far from the origin" {
            continue;
        }
        let expected = answers(&scene);
        for size in HARD_SIZES {
            let found = answers(&resized(&scene, size));
            for (found, expected) in found.iter().zip(&expected) {
                let unit = if found.quantity == Quantity::Flux { size * size } else { 1.0 };
                let off = (found.value / unit - expected.value).abs();
                assert!(
                    off <= expected.error + 1e-9 * expected.value,
                    "{name} × {size:e}: {found:?} and {expected:?}"
                );
            }
        }
    }
}

#[test]
fn a_flux_beyond_the_range_of_numbers_has_an_error_that_says_so() {
    let opposed = |exitance: f64, size: f64| {
        let (_, mut scene) = hard_pairs().swap_remove(0);
        scene.surfaces[1].radiance = vec![exitance];
        let found = answers(&resized(&scene, size));
        found.into_iter().find(|answer| answer.quantity == Quantity::Flux).unwrap()
    };
    let large = opposed(1e10, 1e150);
    assert_eq!((large.value, large.error), (f64::INFINITY, f64::INFINITY));
    let small = opposed(1e-10, 1e-150);
    assert!(small.value < 1e-309 && small.error >= f64::MIN_POSITIVE, "{small:?}");
}

/// Returns the scene with all lights multiplied by `strength`.
fn brightened(scene: &Scene, strength: f64) -> Scene {
    let mut scene = scene.clone();
    scene.ambient.radiance.iter_mut().for_each(|radiance| *radiance *= strength);
    for light in &mut scene.lights {
        let (LightKind::Point { intensity: values, .. } | LightKind::Distant { irradiance: values, .. }) =
            &mut light.kind;
        values.iter_mut().for_each(|value| *value *= strength);
    }
    scene
}

#[test]
fn answers_are_in_proportion_to_lights_of_any_strength() {
    let scene = without_reflection(room());
    let expected = answers(&scene);
    for strength in POWERS.map(|power| f64::from(2 * power).exp2()) {
        for (found, expected) in answers(&brightened(&scene, strength)).iter().zip(&expected) {
            let off = (found.value / strength - expected.value).abs();
            assert!(off <= 1e-12 * expected.value.abs(), "{strength:e}: {found:?} and {expected:?}");
        }
    }
}

#[test]
fn reflected_light_is_in_proportion_to_lights_of_any_strength() {
    let scene = room();
    let expected = answers(&scene);
    for strength in POWERS.map(|power| f64::from(2 * power).exp2()) {
        for (found, expected) in answers(&brightened(&scene, strength)).iter().zip(&expected) {
            let off = [found.value - strength * expected.value, found.error - strength * expected.error];
            let size = strength * expected.value.abs();
            // a product of a small number may round
            let allowed = [1e-11 * size, 1e-2 * strength * expected.error + f64::EPSILON * size];
            assert!(
                off[0].abs() <= allowed[0] && off[1].abs() <= allowed[1],
                "{strength:e}: {found:?} and {expected:?}"
            );
        }
    }
}

#[test]
fn a_point_that_sees_no_surface_has_no_error_by_surfaces() {
    let light = "[[light]]\nkind = \"point\"\nposition = [0.5, 0.5, 1]\nintensity = 1\n";
    for (receiver, expected) in [([0.5, 0.5, 0.0], 1.0), ([0.5, 0.5, 0.2], 1.0 / 0.64)] {
        let text = [
            material("white", 0.5),
            surface("floor", "white", "polygon = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]"),
            light.to_string(),
            point_receiver("here", receiver, [0.0, 0.0, 1.0]),
        ];
        let found = answers(&of_text(&text.concat()));
        let [answer] = &found[..] else { panic!("{found:?}") };
        assert!((answer.value - expected).abs() <= answer.error && answer.error <= 1e-4, "{answer:?}");
    }
}

#[test]
fn a_point_light_that_is_too_bright_for_a_number_makes_answers_that_say_so() {
    let scene = without_reflection(room());
    let mut small = resized(&scene, 1e-150);
    small.lights.clone_from(&brightened(&scene, 1e20).lights);
    if let LightKind::Point { position, .. } = &mut small.lights[0].kind {
        *position = 1e-150 * *position;
    }
    let found = answers(&small);
    assert!(found.iter().any(|answer| answer.value.is_infinite()), "{found:?}");
    for answer in found {
        assert!(answer.value.is_finite() || answer.error == f64::INFINITY, "{answer:?}");
    }
}

#[test]
fn lengths_that_differ_by_too_much_are_refused_with_the_smallest_surface() {
    let text = [
        material("black", 0),
        surface("large", "black", "polygon = [[0, 0, 0], [1e100, 0, 0], [0, 1e100, 0]]"),
        surface("small", "black", "polygon = [[0, 0, 0], [1e-60, 0, 0], [0, 1e-60, 0]]"),
    ];
    let errors = read(&text.concat(), "test.toml").expect_err("lengths that are too far apart");
    assert!(
        errors[0].message.starts_with("the smallest extent of `small`, 1e-60, is too small"),
        "{}",
        errors[0]
    );
}

#[test]
fn a_scene_in_metres_is_the_same_scene_in_centimetres_and_millimetres() {
    let room = without_reflection(room());
    let expected = answers(&room);
    for (unit, lengths) in [(LengthUnit::Centimetre, 1e2), (LengthUnit::Millimetre, 1e3)] {
        let mut scene = resized(&room, lengths);
        scene.unit = unit;
        if let LightKind::Point { intensity, .. } = &mut scene.lights[0].kind {
            *intensity = vec![3.0];
        }
        assert_same("unit", 1.0, &answers(&scene), &expected);
    }
}
