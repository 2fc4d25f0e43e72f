//! The promises of errors: random scenes of the kinds that people make, compared with an
//! independent path tracer.
//!
//! ```text
//! random scene ─┬─▶ scene file ─▶ simulation ─▶ numbers with errors ─┐
//!               └─▶ paths ─▶ means with standard errors ─────────────┴─▶ misses by kind of error
//! ```
//! `FORMS_COVERAGE` is the number of scenes, and `FORMS_COVERAGE_FROM` the first of them. Scenes
//! with numbers outside their errors are written to the folder `FORMS_COVERAGE_OUT`.

mod judge;
mod pieces;
mod scenes;
mod sequence;
mod tracer;
mod world;

use forms_radiometry::geometry::Vector;
use forms_radiometry::simulation::{ErrorKind, Quantity};
use judge::{Judged, Number, Tally};
use scenes::FAMILIES;
use std::f64::consts::PI;
use std::path::Path;
use world::{Kind, Light, Receiver, Shape, Surface, World};

fn count() -> usize {
    std::env::var("FORMS_COVERAGE").map_or(30, |count| count.parse().expect("a number"))
}

/// Writes a scene with its meshes to a folder.
fn written(world: &World, tolerance: f64, folder: &Path) {
    let (text, files) = world.text(tolerance);
    std::fs::create_dir_all(folder).expect("a folder");
    for (name, text) in files.iter().map(|(name, text)| (name.as_str(), text)).chain([("scene.toml", &text)])
    {
        std::fs::write(folder.join(name), text).expect("a file");
    }
}

/// Returns the kind of the scene with this number, and the comparisons of its numbers.
fn judged(number: usize) -> (&'static str, Vec<Judged>) {
    let (name, family) = FAMILIES[number % FAMILIES.len()];
    let world = scenes::world(family, number as u64);
    let tolerances = if cfg!(debug_assertions) { [1e-1, 3e-2] } else { [3e-2, 1e-2] };
    let tolerance = tolerances[number / FAMILIES.len() % 2];
    let judged = judge::judge(&world, &judge::numbers(&world, tolerance), number as u64);
    if let Ok(folder) = std::env::var("FORMS_COVERAGE_OUT")
        && judged.iter().any(|judged| judged.is_outside())
    {
        written(&world, tolerance, &Path::new(&folder).join(number.to_string()));
    }
    (name, judged)
}

#[test]
fn numbers_lie_within_their_errors_as_their_kind_says() {
    let from: usize = std::env::var("FORMS_COVERAGE_FROM").map_or(0, |from| from.parse().expect("a number"));
    let mut tally = Tally::default();
    let mut outside = Vec::new();
    for number in from..from + count() {
        let (name, judged) = judged(number);
        for Judged { what, .. } in judged.iter().filter(|judged| judged.is_outside()) {
            // printed at once, for runs of thousands of scenes
            println!("{number} {name}: {what}");
            outside.push(format!("{number} {name}: {what}"));
        }
        judged.iter().for_each(|judged| tally.add(judged));
    }
    println!("{tally}");
    let broken = tally.broken();
    assert!(
        broken.is_empty(),
        "{broken:?} are off more often, or by more, than they promise:\n{tally}{outside:#?}"
    );
}

/// Returns worlds with one receiver, and its exact value.
fn known() -> [(&'static str, World, Quantity, f64); 5] {
    let at = |x: f64, y: f64, z: f64| Vector::new(x, y, z);
    let flat = |corner: Vector, along: Vector, across: Vector, reflectance: f64, radiance: f64| Surface {
        radiance,
        ..Surface::new(format!("flat {}", corner.z), Shape::Rectangle([corner, along, across]), reflectance)
    };
    let ball = |radius: f64, reflectance: f64, radiance: f64| Surface {
        radiance,
        is_two_sided: true,
        ..Surface::new("ball".to_owned(), Shape::Sphere { center: at(0.0, 0.0, 0.0), radius }, reflectance)
    };
    let point =
        |position: Vector, normal: Vector| Receiver { kind: Kind::Point { position, normal }, time: None };
    let sphere = |position: Vector| Receiver { kind: Kind::Sphere { position }, time: None };
    let world = |surfaces: Vec<Surface>, receiver: Receiver| World {
        surfaces,
        receivers: vec![receiver],
        ..World::default()
    };
    let lamp = flat(at(-0.5, -0.5, 1.0), at(0.0, 1.0, 0.0), at(1.0, 0.0, 0.0), 0.0, 1.0);
    let plate = flat(at(-0.5, -0.5, 0.0), at(1.0, 0.0, 0.0), at(0.0, 1.0, 0.0), 0.0, 0.0);
    let sunny = World {
        lights: vec![Light::Sun { direction: at(0.0, 0.0, -1.0), irradiance: 1.0 }],
        ..world(
            vec![flat(at(-50.0, -50.0, 0.0), at(100.0, 0.0, 0.0), at(0.0, 100.0, 0.0), 0.5, 0.0)],
            sphere(at(0.0, 0.0, 1e-3)),
        )
    };
    let smoky = World { absorption: 1.0, ..world(vec![ball(2.0, 0.0, 1.0)], sphere(at(0.0, 0.0, 0.0))) };
    let mean = Receiver { kind: Kind::Surface { surface: 1, grid: None }, time: None };
    [
        (
            "inside of a ball that shines and reflects",
            world(vec![ball(1.0, 0.5, 1.0)], point(at(0.2, 0.1, 0.3), at(1.0, 0.0, 0.0))),
            Quantity::Irradiance,
            2.0 * PI,
        ),
        (
            "before a ball",
            world(vec![ball(1.0, 0.0, 1.0)], point(at(0.0, 0.0, 2.0), at(0.0, 0.0, -1.0))),
            Quantity::Irradiance,
            0.25 * PI,
        ),
        // Howell C-11
        (
            "a square under a square",
            world(vec![lamp, plate], mean),
            Quantity::Irradiance,
            PI * 0.199_824_895_698_387,
        ),
        // the sun, and half of its light from below in all directions: the radiance 1/(2π) times 2π
        ("over a plain in the sun", sunny, Quantity::FluenceRate, 2.0),
        ("inside of a ball full of smoke", smoky, Quantity::FluenceRate, 4.0 * PI * (-2.0_f64).exp()),
    ]
}

#[test]
fn paths_find_what_is_known() {
    for (name, world, quantity, right) in known() {
        let is_outside = |value: f64| {
            let (error, kind) = (5e-3 * right, ErrorKind::Bound);
            let number = Number { receiver: 0, quantity, cell: None, bin: None, value, error, kind };
            judge::judge(&world, &[number], 1)[0].is_outside()
        };
        assert!(!is_outside(right), "{name}");
        assert!(is_outside(1.05 * right), "{name}: paths do not tell 5 % more");
    }
}
