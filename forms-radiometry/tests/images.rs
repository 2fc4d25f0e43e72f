//! Images of diffuse surfaces: the boundaries of visible surfaces are exact, and pixels agree with
//! path tracing.

use forms_radiometry::scene::read;
use forms_radiometry::simulation::{ErrorKind, Layout, Map, Simulation, Unwatched, plan, simulate};
use std::f64::consts::PI;

use forms_testing::scene_text::{CUBE, Point, material, polygon, surface, tolerance};

/// Returns a camera at the origin that looks along z, with a film of 2 by 2 at the distance 1.
fn camera(resolution: [usize; 2]) -> String {
    camera_at([0.0; 3], [0.0, 0.0, 1.0], 90.0, resolution)
}

fn camera_at(origin: Point, target: Point, fov: f64, resolution: [usize; 2]) -> String {
    format!(
        "[[receiver]]\nname = \"eye\"\nkind = \"camera\"\norigin = {origin:?}\ntarget = {target:?}\nup = [0, 1, 0]\n\
         fov = {fov}\nresolution = {resolution:?}\n"
    )
}

/// Returns a rectangle across the line of sight that faces the camera, between two of its corners.
fn rectangle(name: &str, [low, high]: [[f64; 2]; 2], z: f64, radiance: f64) -> String {
    let corners = [[low[0], low[1], z], [low[0], high[1], z], [high[0], high[1], z], [high[0], low[1], z]];
    surface(name, "black", &format!("{}\nradiance = {radiance}", polygon(&corners)))
}

fn simulated(text: &str) -> Simulation {
    let scene = read(text, "test.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    assert!(!plan.is_by_paths(), "images of diffuse surfaces need no samples");
    simulate(&plan, &Unwatched)
}

fn image(simulation: &Simulation) -> &Map {
    let map = &simulation.maps[0];
    assert!(map.layout == Layout::Image && simulation.answers[0].kind == ErrorKind::Estimate);
    map
}

/// Returns the part of a pixel that a rectangle covers, on a film of n × n pixels from (−1, 1) to
/// (1, −1).
fn covered([low, high]: [[f64; 2]; 2], [column, row]: [usize; 2], n: usize) -> f64 {
    let side = 2.0 / n as f64;
    let overlap = |low: f64, high: f64, from: f64| (high.min(from + side) - low.max(from)).max(0.0) / side;
    let (left, bottom) = (-1.0 + side * column as f64, 1.0 - side * (row + 1) as f64);
    // an eye that looks along z with y upwards has x to its left
    overlap(-high[0], -low[0], left) * overlap(low[1], high[1], bottom)
}

#[test]
fn a_border_parts_pixels_exactly() {
    const N: usize = 9;
    let at = [[-0.31, -0.47], [0.62, 0.23]];
    let text = material("black", 0) + &rectangle("lamp", at, 1.0, 2.0) + &camera([N, N]);
    for outside in [0.0, 0.7] {
        let simulation = simulated(&format!("{text}[ambient]\nradiance = {outside}\n"));
        let Map { values, errors, .. } = image(&simulation);
        for pixel in 0..N * N {
            let part = covered(at, [pixel % N, pixel / N], N);
            let expected = 2.0 * part + outside * (1.0 - part);
            assert!(
                (values[0][pixel] - expected).abs() <= 1e-12,
                "{pixel}: {}, not {expected}",
                values[0][pixel]
            );
            assert!((values[0][pixel] - expected).abs() <= errors[0][pixel], "{pixel}");
        }
    }
}

#[test]
fn what_stands_before_hides_even_where_no_light_is_hidden() {
    const N: usize = 7;
    let [far, near] = [[[-1.2, -1.0], [1.0, 1.4]], [[-0.2, -0.2], [0.2, 0.1]]];
    let on_film = |[low, high]: [[f64; 2]; 2], z: f64| [low.map(|x| x / z), high.map(|x| x / z)];
    let text = material("black", 0)
        + &rectangle("lamp", far, 2.0, 3.0)
        + &rectangle("plate", near, 0.5, 0.0)
        + &camera([N, N]);
    for effects in ["", "[solve]\neffects = { occlusion = \"off\" }\n"] {
        let simulation = simulated(&(text.clone() + effects));
        let Map { values, .. } = image(&simulation);
        for (pixel, value) in values[0].iter().enumerate() {
            let part = |at, z| covered(on_film(at, z), [pixel % N, pixel / N], N);
            let expected = 3.0 * (part(far, 2.0) - part(near, 0.5));
            assert!((value - expected).abs() <= 1e-12, "{pixel}: {value}, not {expected}");
        }
    }
}

/// Returns a closed cube whose walls have these reflectances and radiances, and the objects inside.
fn room(reflectance: f64, radiances: [f64; 6], inside: &str) -> String {
    let walls = CUBE.iter().zip(radiances).map(|((name, corners), radiance)| {
        surface(name, "wall", &format!("{}\nradiance = {radiance}", polygon(corners)))
    });
    material("wall", reflectance) + &walls.collect::<String>() + inside
}

#[test]
fn in_a_furnace_every_pixel_is_the_radiance_of_the_walls() {
    for rho in [0.0, 0.5, 0.99] {
        let eye = camera_at([0.3, 0.4, 0.2], [0.9, 0.8, 0.7], 80.0, [20, 11]);
        let simulation = simulated(&(room(rho, [1.0; 6], "") + &eye));
        let Map { values, errors, size, .. } = image(&simulation);
        assert_eq!(*size, [20, 11]);
        let expected = 1.0 / (1.0 - rho);
        for (value, error) in values[0].iter().zip(&errors[0]) {
            assert!((value - expected).abs() <= *error, "{rho}: {value} ± {error}, {expected} is right");
            assert!(*error <= 1e-3 * expected, "{rho}: {error}");
        }
    }
}

/// Returns a box that stands on the floor of the cube.
fn block() -> String {
    let (low, high, top) = ([0.55, 0.5], [0.8, 0.85], 0.45);
    let at = |x: f64, y: f64, z: f64| [x, y, z];
    let side = |name: &str, corners: [Point; 4]| surface(name, "wall", &polygon(&corners));
    let wall = |name: &str, [a, b]: [[f64; 2]; 2]| {
        side(name, [at(a[0], a[1], 0.0), at(b[0], b[1], 0.0), at(b[0], b[1], top), at(a[0], a[1], top)])
    };
    let corners = [low, [high[0], low[1]], high, [low[0], high[1]]];
    (0..4).map(|i| wall(&format!("side_{i}"), [corners[i], corners[(i + 1) % 4]])).collect::<String>()
        + &side("top", corners.map(|[x, y]| at(x, y, top)))
}

const LIT: [f64; 6] = [0.0, 1.0, 0.0, 0.2, 0.0, 0.0];

#[test]
fn pixels_are_what_paths_find() {
    let eye = camera_at([0.1, 0.08, 0.6], [0.7, 0.75, 0.3], 75.0, [12, 9]);
    let asked = if cfg!(debug_assertions) { 1e-1 } else { 2e-2 };
    let lamp = "[[light]]\nname = \"bulb\"\nkind = \"point\"\nposition = [0.3, 0.6, 0.8]\nintensity = 0.2\n";
    for light in ["", lamp] {
        let text = room(0.6, LIT, &block()) + light + &eye;
        let simulation = simulated(&(text.clone() + &tolerance(asked)));
        // a receiver that is resolved in time makes the whole scene one for path tracing
        let timed = "[[receiver]]\nname = \"clock\"\nkind = \"point\"\nposition = [0.5, 0.5, 0.01]\nnormal = [0, 0, 1]\n\
                     time = { start = 0, width = 1, bins = 1 }\n";
        let scene =
            read(&(text + timed + &tolerance(asked)), "test.toml").unwrap_or_else(|e| panic!("{}", e[0]));
        let plan = plan(&scene).unwrap();
        assert!(plan.is_by_paths());
        let by_paths = simulate(&plan, &Unwatched);
        let (exact, sampled) = (image(&simulation), &by_paths.maps[0]);
        for pixel in 0..exact.values[0].len() {
            let [a, b] = [exact, sampled].map(|map| [map.values[0][pixel], map.errors[0][pixel]]);
            assert!((a[0] - b[0]).abs() <= a[1] + 5.0 * b[1], "{pixel}: {a:?}, by paths {b:?}");
        }
    }
}

#[test]
fn errors_of_pixels_hold_what_finer_elements_change() {
    let eye = camera_at([0.1, 0.08, 0.6], [0.7, 0.75, 0.3], 75.0, [16, 12]);
    let at = |asked: f64| simulated(&(room(0.7, LIT, &block()) + &eye + &tolerance(asked)));
    // where numeric code is not optimised, a looser tolerance has to suffice
    let (asked, finest) =
        if cfg!(debug_assertions) { (&[2e-1][..], 3e-2) } else { (&[1e-1, 1e-2][..], 1e-3) };
    let fine = at(finest);
    for &asked in asked {
        let simulation = at(asked);
        let (coarse, fine) = (image(&simulation), image(&fine));
        for pixel in 0..coarse.values[0].len() {
            let [(a, error), (b, rest)] =
                [coarse, fine].map(|map| (map.values[0][pixel], map.errors[0][pixel]));
            assert!((a - b).abs() <= error + rest, "{asked}, {pixel}: {a} ± {error}, {b} ± {rest}");
            assert!(error <= asked * a.max(coarse.scales[0]), "{asked}, {pixel}: {error}");
        }
        let (answer, count) = (&simulation.answers[0], coarse.values[0].len() as f64);
        assert!((answer.value - coarse.values[0].iter().sum::<f64>() / count).abs() <= 1e-12 * PI);
    }
}

/// What is seen of a grey floor under a sky of radiance L is ρ L, whichever way points on the floor
/// are rounded.
#[test]
fn a_floor_under_a_sky_is_as_bright_as_its_reflectance_says() {
    let floor = polygon(&[[-9.0, -9.0, 0.0], [9.0, -9.0, 0.0], [9.0, 9.0, 0.0], [-9.0, 9.0, 0.0]]);
    let text = material("grey", 0.5)
        + &surface("floor", "grey", &floor)
        + &camera_at([0.1, 0.2, 0.5], [0.0, 1.0, -0.5], 60.0, [9, 9])
        + "[ambient]\nradiance = 0.3\n[solve]\neffects = { interreflection = \"off\" }\n";
    let simulation = simulated(&text);
    let Map { values, errors, .. } = image(&simulation);
    for (value, error) in values[0].iter().zip(&errors[0]) {
        assert!((value - 0.15).abs() <= *error && *error <= 1e-4, "{value} ± {error}");
    }
}
