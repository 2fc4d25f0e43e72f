//! Images: each pixel is the mean over its part of the film, and the image's own answer is the mean
//! of its pixels.

use crate::claims::floor_in_haze;
use forms_radiometry::scene::{ReceiverKind, Scene};
use forms_radiometry::simulation::{Layout, Map, Simulation, Unwatched, plan, simulate};

const TOLERANCE: f64 = 3e-3;

fn simulated(mut scene: Scene) -> Simulation {
    scene.solve.tolerance = TOLERANCE;
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    simulate(&plan, &Unwatched)
}

/// Returns the radiance that a pixel of the camera sees of a floor that shines in haze, averaged
/// over points of the pixel: Gauss–Legendre with three by three points.
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
    assert!(map.layout == Layout::Image && map.size == [4, 3]);
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

/// Part of the errors of pixels that does not average out.
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
