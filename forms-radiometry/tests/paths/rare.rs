//! Rare light: pixels and cells where few samples have met something bright report how far they are
//! off.
//!
//! They are compared with the same scene under another seed, with enough samples to meet rare
//! light. A fixed number of samples keeps their mean unbiased, whatever they find. `FORMS_RARE` is
//! the number of scenes, and of seeds.

use forms_radiometry::scene::{Scene, read};
use forms_radiometry::simulation::{
    Budget, ErrorKind, Job, Map, Simulation, Unwatched, plan, simulate, simulate_job,
};
use forms_testing::SplitMix;
use forms_testing::scene_text::elements::{
    camera, disk, distant_light, gas, mirror_aside, point_light, sky, sphere, square, two_sided,
};
use forms_testing::scene_text::{material, point_receiver, polygon, surface};

/// Number of samples of each pixel and cell that is enough to meet rare light.
const MANY: u64 = 1 << 13;
const TOLERANCE: f64 = 5e-2;
/// Largest parts of all pixels and cells that may be off by more than three errors, and by more
/// than ten.
const BEYOND: [(f64, f64); 2] = [(3.0, 0.05), (10.0, 0.002)];

fn read_or_panic(tables: &[String]) -> Scene {
    let text = tables.concat();
    let mut scene = read(&text, "rare.toml").unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]));
    scene.solve.tolerance = TOLERANCE;
    scene
}

/// Returns a ball of droplets in the sun. Few paths find the sun through it.
fn cloud(scattering: f64, g: f64) -> Scene {
    read_or_panic(&[
        gas("droplets", 0, scattering, g),
        surface("cloud", "droplets", &sphere([0.0; 3], 1.0, false)),
        distant_light([-1.0, 0.6, -0.7], 10),
        sky(0.5),
        camera([[0.0, -6.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]], 20.0, [16, 16]),
    ])
}

/// Returns a ball of droplets and a board above a floor that reflects, in the sun or next to a
/// point light; an image, and a map of the floor.
fn of(seed: u64) -> Scene {
    let mut random = SplitMix(seed);
    let mut between = |low: f64, high: f64| low + (high - low) * random.unit();
    let droplets = gas("droplets", 0, between(0.3, 4.0), between(-0.5, 0.9));
    let ball = sphere([between(-1.0, 1.0), between(-1.0, 1.0), between(0.6, 1.5)], between(0.2, 0.5), false);
    let [x, y, z] = [between(-1.5, 1.0), between(-1.5, 1.0), between(0.3, 1.0)];
    let board = polygon(&[[x, y, z], [x + 0.6, y, z + 0.2], [x + 0.6, y + 0.5, z + 0.2], [x, y + 0.5, z]]);
    let light = if between(0.0, 1.0) < 0.5 {
        distant_light([between(-1.0, 1.0), between(-1.0, 1.0), -1.0], 10)
    } else {
        point_light([between(-2.0, 2.0), between(-2.0, 2.0), between(1.0, 2.0)], 5)
    };
    read_or_panic(&[
        droplets,
        material("grey", between(0.3, 0.8)),
        surface("ball", "droplets", &ball),
        surface("board", "grey", &two_sided(&board)),
        surface("floor", "grey", &square(0.0, 2.0, true)),
        light,
        "[[receiver]]\nname = \"map\"\nkind = \"surface\"\nsurface = \"floor\"\ngrid = [6, 5]\n".to_owned(),
        camera([[0.0, -5.0, 2.0], [0.0, 0.0, 0.5], [0.0, 0.0, 1.0]], 40.0, [10, 8]),
    ])
}

/// Returns the results, and those with `MANY` samples of each pixel and cell.
fn both(mut scene: Scene) -> [Simulation; 2] {
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let found = simulate(&plan, &Unwatched);
    scene.solve.seed += 1;
    let budget = Some(Budget::new(MANY).unwrap_or_else(|error| panic!("{error}")));
    let many = simulate_job(&plan, Job { budget, ..Job::default() }, &Unwatched);
    [found, many.unwrap_or_else(|error| panic!("{error}"))]
}

/// Returns the differences between the pixels or cells of two maps, in units of their combined
/// errors.
fn deviations(one: &Map, other: &Map) -> Vec<f64> {
    let of_one = |map: &Map, cell: usize| (map.values[0][cell], map.errors[0][cell]);
    let deviation = |cell| {
        let ((a, of_a), (b, of_b)) = (of_one(one, cell), of_one(other, cell));
        if a == b { 0.0 } else { (a - b).abs() / of_a.hypot(of_b) }
    };
    (0..one.values[0].len()).map(deviation).filter(|deviation| !deviation.is_nan()).collect()
}

/// Asserts the parts of all pixels and cells that are off by more than some numbers of errors.
fn assert_honest(off: &[f64]) {
    for (errors, most) in BEYOND {
        let beyond = off.iter().filter(|&&off| off > errors).count() as f64 / off.len() as f64;
        assert!(beyond <= most, "{beyond} of {} are off by more than {errors} errors", off.len());
    }
}

#[test]
fn pixels_of_clouds_are_not_too_dark() {
    for [scattering, g] in [[3.0, 0.8], [1.5, 0.9]] {
        let [found, many] = both(cloud(scattering, g));
        assert_honest(&deviations(&found.maps[0], &many.maps[0]));
        let [found, many] = [&found, &many].map(|simulation| &simulation.answers[0]);
        let apart = (found.value - many.value).abs() / found.error.hypot(many.error);
        assert!(apart <= 3.0, "{scattering}, {g}: {found:?}, {many:?}");
    }
}

#[test]
fn pixels_and_cells_say_how_far_they_are_off_where_light_is_rare() {
    let count = std::env::var("FORMS_RARE").map_or(4, |count| count.parse().expect("a number"));
    let off = (0..count).flat_map(|seed| {
        let [found, many] = both(of(seed));
        assert!(found.maps.iter().all(|map| map.kind == ErrorKind::Sigma), "{seed}: no paths");
        let maps = found.maps.iter().zip(&many.maps);
        maps.flat_map(|(one, other)| deviations(one, other)).collect::<Vec<f64>>()
    });
    assert_honest(&off.collect::<Vec<f64>>());
}

/// Returns the irradiance at the height H above the centre of a disk that reflects the light of a
/// point light of intensity 1 at the height h, 2ρ H² ∫ (H² + h² (1/c² − 1))⁻² dc, with c the cosine
/// at the light, from that of the edge to 1.
fn above_a_lit_disk([near, far]: [f64; 2], reflectance: f64, radius: f64) -> f64 {
    const STEPS: u32 = 100_000;
    let edge = near / near.hypot(radius);
    let step = (1.0 - edge) / f64::from(STEPS);
    let at = |index: u32| {
        let cosine = edge + step * (f64::from(index) + 0.5);
        (far * far + near * near * ((cosine * cosine).recip() - 1.0)).powi(-2)
    };
    2.0 * reflectance * far * far * step * (0..STEPS).map(at).sum::<f64>()
}

/// Few paths meet the spot below a light that is near a surface.
#[test]
fn light_that_a_bright_spot_reflects_is_not_missed() {
    let seeds: u64 = std::env::var("FORMS_RARE").map_or(8, |count| count.parse().expect("a number"));
    let mut all = Vec::new();
    for (near, radius) in [(0.003, 1.0), (0.01, 2.0), (0.05, 1.0), (0.2, 1.0)] {
        let right = above_a_lit_disk([near, 1.0], 0.5, radius);
        let scene = |seed: u64| {
            let mut scene = read_or_panic(&[
                material("grey", 0.5),
                surface("disk", "grey", &disk([0.0; 3], [0.0, 0.0, 1.0], radius)),
                mirror_aside(),
                point_light([0.0, 0.0, near], 1),
                point_receiver("point", [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]),
                "[solve]\neffects = { direct = \"off\" }\n".to_owned(),
            ]);
            scene.solve.seed = seed;
            scene
        };
        let off = |seed: u64| {
            let plan = plan(&scene(seed)).unwrap_or_else(|errors| panic!("{}", errors[0]));
            let found = simulate(&plan, &Unwatched).answers.swap_remove(0);
            assert_eq!(found.kind, ErrorKind::Sigma);
            (found.value - right).abs() / found.error
        };
        let of_light: Vec<f64> = (0..seeds).map(off).collect();
        assert!(of_light.iter().all(|&off| off < 5.0), "{near}: right is {right}, off by {of_light:?}");
        all.extend(of_light);
    }
    let beyond = all.iter().filter(|&&off| off > 3.0).count();
    assert!(20 * beyond <= all.len(), "{beyond} of {} are off by more than 3 errors", all.len());
}
