//! Pixels and cells are within their errors, and the errors within the tolerance: scenes with the
//! lamp in view and without it, by elements and by path tracing, each compared with a much more
//! accurate run. Also, pixels of direct light alone that shadows and horizons cut are compared with
//! the pixels of a finer image.

use forms_radiometry::scene::read;
use forms_radiometry::simulation::{ErrorKind, Map, Simulation, Unwatched, plan, simulate};
use forms_testing::SplitMix;

use forms_testing::scene_text::{CUBE, Point, material, polygon, surface, tolerance};

/// Whether numeric code is optimised; otherwise tolerances are looser.
const IS_OPTIMISED: bool = !cfg!(debug_assertions);
/// View of a scene.
struct Look {
    name: &'static str,
    text: String,
    is_by_paths: bool,
    /// Radiance that separates the pixels in which no emitter is seen directly, below it, from all
    /// others, except for a thin boundary.
    dim: f64,
}

/// `dim` where an emitter is seen, where none is seen, and where everything else is black.
const SEEN: f64 = 1.0;
const UNSEEN: f64 = f64::INFINITY;
const BLACK: f64 = 0.0;

fn camera(origin: Point, target: Point, fov: f64) -> String {
    format!(
        "[[receiver]]\nname = \"eye\"\nkind = \"camera\"\norigin = {origin:?}\ntarget = {target:?}\nup = [0, 0, 1]\n\
         fov = {fov}\nresolution = [8, 6]\n"
    )
}

/// Returns a cube with a lamp below its ceiling, a shelf, and a floor of this material.
fn room(floor: &str) -> String {
    let walls = CUBE.iter().map(|(name, corners)| {
        surface(name, if *name == "floor" { floor } else { "wall" }, &polygon(corners))
    });
    let lamp = [[0.35, 0.35, 0.95], [0.35, 0.65, 0.95], [0.65, 0.65, 0.95], [0.65, 0.35, 0.95]];
    let shelf = [[0.7, 0.3, 0.4], [1.0, 0.3, 0.4], [1.0, 0.9, 0.4], [0.7, 0.9, 0.4]];
    material("wall", 0.5)
        + "[[material]]\nname = \"glass\"\nkind = \"mirror\"\nreflectance = 0.8\n"
        + &walls.collect::<String>()
        + &surface("lamp", "wall", &format!("{}\nradiance = 17", polygon(&lamp)))
        + &surface("shelf", "wall", &format!("{}\ntwo_sided = true", polygon(&shelf)))
}

fn camera_of([origin, target]: [Point; 2]) -> String {
    camera(origin, target, 75.0)
}

/// Towards the lamp, and away from it.
const UP: [Point; 2] = [[0.1, 0.08, 0.3], [0.6, 0.6, 0.8]];
const DOWN: [Point; 2] = [[0.1, 0.08, 0.6], [0.7, 0.75, 0.1]];

fn looks() -> Vec<Look> {
    let look = |name, text, is_by_paths, dim| Look { name, text, is_by_paths, dim };
    let [up, down] = [UP, DOWN].map(camera_of);
    let (name, corners) = CUBE[5];
    let open = room("wall").replace(&surface(name, "wall", &polygon(&corners)), "");
    let bulb = "[[light]]\nkind = \"point\"\nposition = [0.3, 0.6, 0.7]\nintensity = 0.3\n";
    let black = room("wall").replace("reflectance = 0.5", "reflectance = 0");
    vec![
        look("a lamp in view", room("wall") + &up, false, SEEN),
        look("a lamp out of view", room("wall") + &down, false, UNSEEN),
        look("a bulb", room("wall").replace("radiance = 17", "radiance = 0") + bulb + &down, false, UNSEEN),
        look("a lamp and light from outside", open + "[ambient]\nradiance = 2\n" + &up, false, SEEN),
        look("a lamp between black walls", black + &up, false, BLACK),
        look("a lamp over a mirror", room("glass") + &up, true, SEEN),
        look("a mirror below a lamp", room("glass") + &down, true, UNSEEN),
    ]
}

fn simulated(look: &Look, asked: f64) -> Simulation {
    let scene =
        read(&(look.text.clone() + &tolerance(asked)), "test.toml").unwrap_or_else(|e| panic!("{}", e[0]));
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    assert_eq!(plan.is_by_paths(), look.is_by_paths, "{}", look.name);
    simulate(&plan, &Unwatched)
}

/// Returns the mean of the pixels that are no brighter than this, or of all pixels where those are
/// dark.
fn scale(map: &Map, dim: f64) -> f64 {
    let mean = |values: &mut dyn Iterator<Item = f64>| {
        let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
        sum / count
    };
    let own = mean(&mut map.values[0].iter().copied().filter(|value| *value <= dim));
    if own > 0.0 { own } else { mean(&mut map.values[0].iter().copied()) }
}

#[test]
fn pixels_are_within_their_errors_and_these_within_the_tolerance_of_what_is_no_emitter() {
    for look in looks() {
        let (asked, finer) = match (look.is_by_paths, IS_OPTIMISED) {
            (true, true) => (1e-1, 4.0),
            (true, false) => (3e-1, 4.0),
            (false, true) => (2e-2, 8.0),
            (false, false) => (3e-1, 10.0),
        };
        let [coarse, fine] = [asked, asked / finer].map(|asked| simulated(&look, asked));
        let (map, exact) = (&coarse.maps[0], &fine.maps[0]);
        let (mean, told) = (scale(map, look.dim), map.scales[0]);
        // the scale of the path tracer is a lower estimate, and the boundary of an emitter is found
        // by some rays
        let is_near = (0.8 * mean..=1.05 * mean).contains(&told);
        assert!(is_near, "{}: the scale is {told}, and the mean {mean}", look.name);
        let (mut outside, mut farthest) = (0, 0.0_f64);
        for pixel in 0..map.values[0].len() {
            let [(value, error), (right, rest)] =
                [map, exact].map(|map| (map.values[0][pixel], map.errors[0][pixel]));
            let off = (value - right).abs();
            assert!(error <= asked * value.max(told), "{}, {pixel}: {value} ± {error}", look.name);
            outside += usize::from(off > error + rest);
            farthest = farthest.max(off / (error + rest));
        }
        let part = outside as f64 / map.values[0].len() as f64;
        // a third of all standard errors are exceeded
        let [most, farthest_of_all] = if map.kind == ErrorKind::Sigma { [0.4, 5.0] } else { [0.02, 3.0] };
        assert!(part <= most && farthest <= farthest_of_all, "{}: {part}, {farthest}", look.name);
        let accuracy = coarse.accuracy();
        assert!(
            accuracy.missed_cells(asked).is_empty() && accuracy.largest_error() <= asked,
            "{}",
            look.name
        );
        assert_eq!(coarse.history.last().map(|moment| moment.error), Some(accuracy.largest_error()));
    }
}

/// Number of pixels of the finer image along each side of a pixel.
const FINER: usize = 6;

/// Returns a ground below a plate, in the light of a sun, a point light or a lamp that shines along
/// the ground, and a camera of this resolution.
fn cut_by_shadows(seed: u64, resolution: [usize; 2]) -> String {
    let mut random = SplitMix(seed);
    let mut between = |low: f64, high: f64| low + (high - low) * random.unit();
    let [x, y, turn] = [between(-1.0, 1.0), between(-1.0, 1.0), between(0.0, 3.0)];
    let corner = |u: f64, v: f64| {
        [x + u * f64::cos(turn) - v * f64::sin(turn), y + u * f64::sin(turn) + v * f64::cos(turn), 1.0]
    };
    let plate = polygon(&[corner(-0.7, -0.2), corner(0.7, -0.2), corner(0.7, 0.2), corner(-0.7, 0.2)]);
    let ground = polygon(&[[-3.0, -3.0, 0.0], [3.0, -3.0, 0.0], [3.0, 3.0, 0.0], [-3.0, 3.0, 0.0]]);
    let [a, b, c] = [(); 3].map(|()| between(-0.8, 0.8));
    let light = match seed % 3 {
        0 => format!("[[light]]\nkind = \"distant\"\ndirection = [{a}, {b}, -1]\nirradiance = 5\n"),
        1 => format!("[[light]]\nkind = \"point\"\nposition = [{a}, {b}, 2.5]\nintensity = 9\n"),
        _ => {
            // the lamp's plane cuts the ground
            let lamp = [[a, b, 1.2], [a + 0.3, b, 1.2], [a + 0.3, b + 0.2, 1.2 + c], [a, b + 0.2, 1.2 + c]];
            surface("lamp", "black", &format!("{}\nradiance = 20", polygon(&lamp)))
        }
    };
    let look = camera([between(-2.0, 2.0), between(-2.0, 2.0), 3.5], [0.0, 0.1, 0.0], 50.0)
        .replace("[8, 6]", &format!("{resolution:?}"));
    let asked = tolerance(1e-2) + "effects = { interreflection = \"off\" }\n";
    material("black", 0)
        + &material("ground", 0.5)
        + &surface("ground", "ground", &ground)
        + &surface("plate", "black", &format!("{plate}\ntwo_sided = true"))
        + &light
        + &look
        + &asked
}

#[test]
fn pixels_that_shadows_and_horizons_cut_are_the_means_of_finer_ones() {
    const SIZE: [usize; 2] = [8, 6];
    for seed in 0..18 {
        let image = |resolution| {
            let scene =
                read(&cut_by_shadows(seed, resolution), "test.toml").unwrap_or_else(|e| panic!("{}", e[0]));
            let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
            simulate(&plan, &Unwatched).maps.swap_remove(0)
        };
        let [coarse, fine] = [SIZE, SIZE.map(|size| FINER * size)].map(image);
        for pixel in 0..SIZE[0] * SIZE[1] {
            let [column, row] = [pixel % SIZE[0], pixel / SIZE[0]];
            let parts = (0..FINER * FINER)
                .map(|part| (FINER * row + part / FINER) * FINER * SIZE[0] + FINER * column + part % FINER);
            let mean =
                |values: &[f64]| parts.clone().map(|part| values[part]).sum::<f64>() / (FINER * FINER) as f64;
            let [right, rest] = [mean(&fine.values[0]), mean(&fine.errors[0])];
            let (value, error) = (coarse.values[0][pixel], coarse.errors[0][pixel]);
            let off = (value - right).abs();
            assert!(
                off <= error + rest + 1e-12,
                "{seed}, {pixel}: {value} ± {error}, {right} ± {rest} is right"
            );
        }
    }
}
