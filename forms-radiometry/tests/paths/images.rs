//! Images: each pixel is the mean over its part of the film, and the image's own answer is the mean of its pixels.

use crate::claims::elements::{camera, distant_light, gas, sky, sphere};
use crate::claims::floor_in_haze;
use crate::claims::scene_text::surface;
use forms_radiometry::scene::{ReceiverKind, Scene, read};
use forms_radiometry::simulation::{Budget, Job, Map, Simulation, Unwatched, plan, simulate, simulate_job};

const TOLERANCE: f64 = 3e-3;

fn simulated(mut scene: Scene) -> Simulation {
    scene.solve.tolerance = TOLERANCE;
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    simulate(&scene, &plan, &Unwatched)
}

/// What a pixel of the camera sees of a floor that shines in haze, at points of the pixel: Gauss–Legendre of three by three points.
fn seen(scene: &Scene, [column, row]: [usize; 2]) -> f64 {
    const NODES: [[f64; 2]; 3] =
        [[0.112_701_665_379_258, 5.0 / 18.0], [0.5, 8.0 / 18.0], [0.887_298_334_620_742, 5.0 / 18.0]];
    let ReceiverKind::Camera(camera) = &scene.receivers[0].kind else { panic!("the receiver is a camera") };
    let at = |[x, across]: [f64; 2], [y, along]: [f64; 2]| {
        let direction = camera.direction(column as f64 + x, row as f64 + y);
        let secant = direction.length() / direction.z.abs();
        across * along * (-0.8 * secant).exp()
    };
    NODES.iter().flat_map(|&x| NODES.iter().map(move |&y| at(x, y))).sum()
}

fn image(simulation: &Simulation) -> &Map {
    let map = &simulation.maps[0];
    assert!(map.is_image && map.size == [4, 3]);
    map
}

#[test]
fn each_pixel_is_the_mean_over_its_part_of_the_film() {
    let scene = floor_in_haze().scene();
    let simulation = simulated(scene.clone());
    let Map { values, errors, size: [columns, rows], .. } = image(&simulation);
    let largest = values[0].iter().copied().fold(0.0, f64::max);
    for cell in 0..columns * rows {
        let (value, error) = (values[0][cell], errors[0][cell]);
        let exact = seen(&scene, [cell % columns, cell / columns]);
        assert!((value - exact).abs() <= 4.0 * error, "{cell}: {value} ± {error}, {exact} is right");
        assert!(error <= TOLERANCE * largest, "{cell}: {error}");
    }
}

/// The part of the errors of pixels that does not average out.
const COMMON: f64 = 0.5;

#[test]
fn the_answer_of_an_image_is_the_mean_of_its_pixels() {
    let simulation = simulated(floor_in_haze().scene());
    let Map { values, errors, .. } = image(&simulation);
    let count = values[0].len() as f64;
    let answer = &simulation.answers[0];
    let squares: f64 = errors[0].iter().map(|error| error * error).sum();
    let error = squares.sqrt().hypot(COMMON * errors[0].iter().sum::<f64>()) / count;
    assert!((answer.value - values[0].iter().sum::<f64>() / count).abs() <= 1e-14 * answer.value);
    assert!((answer.error - error).abs() <= 1e-12 * answer.error);
}

/// A ball of droplets in the sun, which few of the paths through it are led to.
fn cloud(scattering: f64, g: f64) -> Scene {
    let tables = [
        gas("droplets", 0, scattering, g),
        surface("cloud", "droplets", &sphere([0.0; 3], 1.0, false)),
        distant_light([-1.0, 0.6, -0.7], 10),
        sky(0.5),
        camera([[0.0, -6.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]], 20.0, [16, 16]),
    ];
    read(&tables.concat(), "cloud.toml").unwrap_or_else(|errors| panic!("{}", errors[0]))
}

/// The samples of a pixel that meet what is rare.
const MANY: u64 = 1 << 13;

/// The image with so many samples of each pixel, whatever they find.
fn sampled(scene: &Scene, samples: u64) -> Simulation {
    let plan = plan(scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let budget = Some(Budget::new(samples).unwrap_or_else(|error| panic!("{error}")));
    let found = simulate_job(scene, &plan, Job { budget, ..Job::default() }, &Unwatched);
    found.unwrap_or_else(|error| panic!("{error}"))
}

/// How far the pixels of two images are apart, in standard errors of both.
fn deviations(one: &Map, other: &Map) -> Vec<f64> {
    let of_one = |map: &Map, cell: usize| (map.values[0][cell], map.errors[0][cell]);
    let deviation = |cell| {
        let ((a, of_a), (b, of_b)) = (of_one(one, cell), of_one(other, cell));
        (a - b) / of_a.hypot(of_b)
    };
    (0..one.values[0].len()).map(deviation).collect()
}

#[test]
fn pixels_do_not_end_where_they_have_missed_what_is_rare() {
    for [scattering, g] in [[3.0, 0.8], [1.5, 0.9]] {
        let mut scene = cloud(scattering, g);
        scene.solve.tolerance = 5e-2;
        let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
        let found = simulate(&scene, &plan, &Unwatched);
        scene.solve.seed += 1;
        let many = sampled(&scene, MANY);
        let off = deviations(&found.maps[0], &many.maps[0]);
        let beyond = off.iter().filter(|off| off.abs() > 3.0).count() as f64 / off.len() as f64;
        assert!(beyond <= 0.05, "{scattering}, {g}: {beyond} of all pixels are beyond three errors");
        let [found, many] = [&found, &many].map(|simulation| &simulation.answers[0]);
        let apart = (found.value - many.value).abs() / found.error.hypot(many.error);
        assert!(apart <= 3.0, "{scattering}, {g}: {found:?}, {many:?}");
    }
}
