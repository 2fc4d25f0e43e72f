//! Tolerances: answers of one scene at different tolerances agree within their reported errors.
//!
//! Two rectangles that reflect, one of which emits, face each other at random distances and angles.
//! Points at a corner, on an edge and inside the dark one, and its mean, converge at different
//! rates: the elements that are split for one reveal little about another. `FORMS_TOLERANCES` is
//! the number of scenes.

use forms_radiometry::scene::{Scene, read};
use forms_radiometry::simulation::{Answer, Unwatched, plan, simulate};
use forms_testing::SplitMix;
use forms_testing::scene_text::{Point, material, point_receiver, polygon, surface, surface_receiver};

/// First scene. In scene 487 the first change is small by chance, and a corner converges more
/// slowly than everything else.
const FIRST: u64 = 480;
const TOLERANCES: [f64; 5] = [1e-2, 3e-3, 1e-3, 5e-4, 1e-4];
/// Least distance between the two rectangles.
const LEAST_DISTANCE: f64 = 0.15;
/// Part of all pairs of answers that may differ by more than their errors, and the largest
/// difference of any pair in units of its errors.
const OUTSIDE: f64 = 0.02;
const FARTHEST: f64 = 3.0;

fn scene(seed: u64) -> Scene {
    let mut random = SplitMix(seed);
    let mut between = |low: f64, high: f64| low + (high - low) * random.unit();
    let [wide, long, tilt] = [between(0.3, 2.0), between(0.3, 2.0), between(-0.5, 0.8)];
    let height = between(LEAST_DISTANCE, 1.5) + if tilt < 0.0 { -tilt * long } else { 0.0 };
    let shift = [between(-0.5, 0.5), between(-0.5, 0.5)];
    let at = |x: f64, y: f64| [x + shift[0], y + shift[1], height + tilt * y];
    let lamp = polygon(&[at(0.0, 0.0), at(0.0, long), at(wide, long), at(wide, 0.0)]);
    let dark: [Point; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let point = |name: &str, x: f64, y: f64| point_receiver(name, [x, y, 0.0], [0.0, 0.0, 1.0]);
    let tables = [
        material("bright", between(0.3, 0.95)),
        material("grey", between(0.3, 0.95)),
        surface("dark", "grey", &polygon(&dark)),
        surface("lamp", "bright", &format!("{lamp}\nexitance = 1")),
        surface_receiver("dark"),
        point("corner", 0.0, 0.0),
        point("edge", between(0.0, 1.0), 1.0),
        point("inside", between(0.0, 1.0), between(0.0, 1.0)),
    ];
    let text = tables.concat();
    read(&text, "tolerances.toml").unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]))
}

fn answers(scene: &Scene, tolerance: f64) -> Vec<Answer> {
    let mut scene = scene.clone();
    scene.solve.tolerance = tolerance;
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    simulate(&plan, &Unwatched).answers
}

#[test]
fn answers_at_two_tolerances_agree_within_their_errors() {
    let count = std::env::var("FORMS_TOLERANCES").map_or(20, |count| count.parse().expect("a number"));
    let (mut pairs, mut outside, mut farthest) = (0, 0, 0.0_f64);
    for seed in FIRST..FIRST + count {
        let scene = scene(seed);
        let found = TOLERANCES.map(|tolerance| answers(&scene, tolerance));
        for (finer, one) in found.iter().enumerate() {
            for (a, b) in found[..finer].iter().flat_map(|other| one.iter().zip(other)) {
                let apart = (a.value - b.value).abs() / (a.error + b.error);
                pairs += 1;
                outside += usize::from(apart > 1.0);
                farthest = farthest.max(apart);
                assert!(apart <= FARTHEST, "{seed}: {a:?}, {b:?}");
            }
        }
    }
    println!("{outside} of {pairs} pairs are apart by more than their errors, one by {farthest:.2} of them");
    assert!(outside as f64 <= OUTSIDE * pairs as f64, "{outside} of {pairs}");
}
