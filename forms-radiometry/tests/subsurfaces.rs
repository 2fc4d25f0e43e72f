//! Surfaces on others: a scene with windows on walls equals the scene in which the walls are
//! modelled as pieces around the windows.

use forms_radiometry::scene::{Scene, read};
use forms_radiometry::simulation::{Answer, ErrorKind, Quantity, Simulation, Unwatched, plan, simulate};
use forms_radiometry::{ViewFactors, view_factors};
use forms_testing::SplitMix;
use std::f64::consts::PI;

use forms_testing::scene_text::{
    CUBE, Point, material, point_receiver, polygon, surface, surface_of_its_own, surface_receiver, tolerance,
};

fn scene(text: &str) -> Scene {
    read(text, "test.toml").unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]))
}

fn results(text: &str) -> Simulation {
    let scene = scene(text);
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    simulate(&plan, &Unwatched)
}

/// Frame of a room: its origin, and the directions of its sides of length 1.
struct Frame {
    origin: Point,
    axes: [Point; 3],
}

impl Frame {
    /// Returns a rotated frame from three random angles.
    fn random(numbers: &mut SplitMix) -> Self {
        let [(s, c), (t, d), (u, e)] = [0; 3].map(|_| (6.0 * numbers.unit()).sin_cos());
        let axes = [
            [c * d, s * d, -t],
            [c * t * u - s * e, s * t * u + c * e, d * u],
            [c * t * e + s * u, s * t * e - c * u, d * e],
        ];
        Self { origin: [0; 3].map(|_| 10.0 * numbers.unit()), axes }
    }

    fn place(&self, point: Point) -> Point {
        [0, 1, 2].map(|k| self.origin[k] + (0..3).map(|axis| point[axis] * self.axes[axis][k]).sum::<f64>())
    }
}

/// Rectangle, given by its ends along both sides of a wall.
type Rectangle = [[f64; 2]; 2];

/// Returns the vertices of a rectangle on the face y = 0 of the unit cube, facing inwards.
fn on_front([[left, right], [low, high]]: Rectangle) -> [Point; 4] {
    [[left, 0.0, low], [left, 0.0, high], [right, 0.0, high], [right, 0.0, low]]
}

/// Returns two windows side by side, apart from each other and from the edges, or along them.
fn windows(numbers: &mut SplitMix) -> [Rectangle; 2] {
    let middle = 0.35 + 0.3 * numbers.unit();
    let mut range = |low: f64, high: f64| {
        let [a, b] = [0.05 + 0.4 * numbers.unit(), 0.55 + 0.4 * numbers.unit()];
        [low + a * (high - low), low + b * (high - low)]
    };
    let mut pair = [[range(0.0, middle), range(0.0, 1.0)], [range(middle, 1.0), range(0.0, 1.0)]];
    match numbers.below(4) {
        0 => pair[0][1][0] = 0.0,
        1 => pair[1][0] = [middle, 1.0],
        2 => pair[0][0][1] = pair[1][0][0],
        _ => {}
    }
    pair
}

/// Returns the remainder of the wall around windows side by side, as rectangles.
fn around([a, b]: [Rectangle; 2]) -> Vec<Rectangle> {
    let above_and_below = |[across, [low, high]]: Rectangle| [[across, [0.0, low]], [across, [high, 1.0]]];
    let strips =
        [[[0.0, a[0][0]], [0.0, 1.0]], [[a[0][1], b[0][0]], [0.0, 1.0]], [[b[0][1], 1.0], [0.0, 1.0]]];
    let all = [&strips[..], &above_and_below(a), &above_and_below(b)].concat();
    all.into_iter().filter(|side| side.iter().all(|[from, to]| to > from)).collect()
}

/// Returns the unit cube in a frame, whose face y = 0 is replaced by a wall of these surfaces.
fn room(frame: &Frame, wall: &[(String, Rectangle, bool)]) -> String {
    let placed =
        |corners: &[Point]| polygon(&corners.iter().map(|&corner| frame.place(corner)).collect::<Vec<_>>());
    let others = CUBE.iter().filter(|(name, _)| *name != "front");
    let others: String = others.map(|(name, corners)| surface(name, "grey", &placed(corners))).collect();
    let of_wall = |(name, rectangle, lies_on): &(String, Rectangle, bool)| {
        let on = if *lies_on { "\non = \"front\"" } else { "" };
        surface(name, "grey", &(placed(&on_front(*rectangle)) + on))
    };
    material("grey", 0.5) + &others + &wall.iter().map(of_wall).collect::<String>()
}

/// Asserts that every row of view factors sums to 1, within its error and within `allowed`.
fn assert_closed(found: &ViewFactors, allowed: f64, name: &str) {
    for row in 0..found.names.len() {
        let (off, error) = ((found.sum(row) - 1.0).abs(), found.sum_error(row));
        assert!(
            off <= error && error < allowed,
            "{name}, {}: off by {off:e}, said {error:e}",
            found.names[row]
        );
    }
}

#[test]
fn a_wall_with_windows_has_the_area_and_the_view_factors_of_its_pieces() {
    let mut numbers = SplitMix(11);
    let whole: Rectangle = [[0.0, 1.0]; 2];
    for case in 0..12 {
        let frame = Frame::random(&mut numbers);
        let pair = windows(&mut numbers);
        let named = |name: &str, rectangle: Rectangle, lies_on: bool| (name.to_owned(), rectangle, lies_on);
        let mut with_on =
            [named("front", whole, false), named("a", pair[0], true), named("b", pair[1], true)];
        with_on.rotate_left(case % 3);
        let by_hand: Vec<(String, Rectangle, bool)> = around(pair)
            .into_iter()
            .enumerate()
            .map(|(piece, rectangle)| named(&format!("front {piece}"), rectangle, false))
            .chain([named("a", pair[0], false), named("b", pair[1], false)])
            .collect();
        let asked = tolerance(1e-6);
        let [found, expected] =
            [&with_on[..], &by_hand].map(|wall| view_factors(&scene(&(room(&frame, wall) + &asked))));
        assert_closed(&found, 1e-4, &format!("room {case}"));
        let row = |factors: &ViewFactors, name: &str| factors.names.iter().position(|other| other == name);
        let wall = row(&found, "front").expect("the wall");
        let pieces: Vec<usize> =
            (0..expected.names.len()).filter(|&row| expected.names[row].starts_with("front ")).collect();
        let sum: f64 =
            ["front", "a", "b"].map(|name| found.areas[row(&found, name).expect("a row")]).iter().sum();
        assert!((sum - 1.0).abs() < 1e-13, "room {case}: the areas of wall and windows sum to {sum}");
        for (name, own) in found.names.iter().zip(0..) {
            let Some(other) = row(&expected, name) else { continue };
            for (to, factor) in found.names.iter().zip(&found.rows[own]) {
                let parts = row(&expected, to).map_or(pieces.clone(), |only| vec![only]);
                let parts = parts.iter().map(|&part| expected.rows[other][part]);
                let [value, error] =
                    parts.fold([0.0, factor.error], |[v, e], part| [v + part.value, e + part.error]);
                let off = (factor.value - value).abs();
                assert!(off <= error + 1e-14, "room {case}, {name} to {to}: off by {off:e}, said {error:e}");
            }
        }
        let of_pieces: f64 = pieces.iter().map(|&piece| expected.areas[piece]).sum();
        assert!((found.areas[wall] - of_pieces).abs() < 1e-13, "room {case}");
    }
}

#[test]
fn a_room_with_a_round_lamp_on_its_ceiling_is_closed() {
    let cube: String = CUBE.iter().map(|(name, corners)| surface(name, "grey", &polygon(corners))).collect();
    let lamp = surface(
        "lamp",
        "grey",
        "disk = { center = [0.4,0.5,1], normal = [0,0,-1], radius = 0.2 }\non = \"ceiling\"",
    );
    let found = view_factors(&scene(&(material("grey", 0.5) + &cube + &lamp + &tolerance(1e-4))));
    assert_closed(&found, 1e-3, "round lamp");
    assert!((found.areas[1] + found.areas[6] - 1.0).abs() < 1e-14, "the areas of lamp and ceiling");
    assert!((found.areas[6] - 0.04 * PI).abs() < 1e-14, "{}", found.areas[6]);
    assert_eq!((found.rows[1][6].value, found.rows[6][1].value), (0.0, 0.0), "they lie in one plane");
}

/// Returns the unit cube with a window, and a lamp of this shape, on its faces; all emit and reflect
/// so that the radiance is 3 everywhere. The scene is path traced where the material of the face
/// `back` is a mirror.
fn furnace(lamp: &str, is_mirror: bool, receivers: &str) -> String {
    let reflecting = |name: &str, kind: &str, reflectance: f64| {
        format!("[[material]]\nname = \"{name}\"\nkind = \"{kind}\"\nreflectance = {reflectance:?}\n")
    };
    let emitting =
        |shape: &str, reflectance: f64| format!("{shape}\nradiance = {:?}", 3.0 * (1.0 - reflectance));
    let faces: String = CUBE
        .iter()
        .map(|(name, corners)| {
            let material = if *name == "back" && is_mirror { "mirror" } else { "grey" };
            surface(name, material, &emitting(&polygon(corners), 0.5))
        })
        .collect();
    let window = polygon(&on_front([[0.3, 0.8], [0.0, 0.6]])) + "\non = \"front\"";
    let pane = polygon(&on_front([[0.4, 0.6], [0.2, 0.4]])) + "\non = \"window\"";
    let lamp = format!("{lamp}\non = \"ceiling\"");
    reflecting("grey", "diffuse", 0.5)
        + &reflecting("mirror", "mirror", 0.5)
        + &reflecting("dark", "diffuse", 0.2)
        + &surface("lamp", "dark", &emitting(&lamp, 0.2))
        + &surface("pane", "dark", &emitting(&pane, 0.2))
        + &faces
        + &surface("window", "dark", &emitting(&window, 0.2))
        + receivers
}

#[test]
fn a_furnace_with_a_window_and_a_lamp_on_its_faces_has_one_radiance_everywhere() {
    let ray = |name: &str, [x, y, z]: Point| {
        let direction = [x - 0.5, y - 0.5, z - 0.5];
        format!(
            "[[receiver]]\nname = \"{name}\"\nkind = \"ray\"\norigin = [0.5,0.5,0.5]\ndirection = {direction:?}\n"
        )
    };
    let receivers = ["front", "window", "pane", "ceiling", "lamp", "floor"].map(surface_receiver).concat()
        + &ray("to the pane", [0.5, 0.0, 0.3])
        + &ray("to the window", [0.35, 0.0, 0.1])
        + &ray("to the wall", [0.1, 0.0, 0.1])
        + &ray("to the lamp", [0.41, 0.5, 1.0])
        + &ray("beside the lamp", [0.7, 0.5, 1.0])
        + &point_receiver("on the pane", [0.5, 0.0, 0.3], [0.0, 1.0, 0.0]);
    let disk = "disk = { center = [0.4,0.5,1], normal = [0,0,-1], radius = 0.2 }";
    let side = (0.04 * PI).sqrt();
    let [left, right, front, back] = [0.4 - side / 2.0, 0.4 + side / 2.0, 0.5 - side / 2.0, 0.5 + side / 2.0];
    let square = polygon(&[[left, front, 1.0], [left, back, 1.0], [right, back, 1.0], [right, front, 1.0]]);
    for (name, lamp, is_mirror, asked) in [
        ("elements", &square[..], false, 1e-3),
        ("a disk", disk, false, 1e-2),
        ("a disk and a mirror", disk, true, 1e-2),
    ] {
        let found = results(&(furnace(lamp, is_mirror, &receivers) + &tolerance(asked)));
        for Answer { receiver, quantity, value, error, kind, .. } in &found.answers {
            let area = match &**receiver {
                "front" => 1.0 - 0.3,
                "window" => 0.3 - 0.04,
                "pane" => 0.04,
                "ceiling" => 1.0 - 0.04 * PI,
                "lamp" => 0.04 * PI,
                _ => 1.0,
            };
            let expected = match quantity {
                Quantity::Flux => 3.0 * PI * area,
                Quantity::Radiance => 3.0,
                _ => 3.0 * PI,
            };
            let off = (value - expected).abs();
            // standard errors are exceeded, at times by a factor of two
            let is_sampled = *kind == ErrorKind::Sigma;
            let allowed = if is_sampled { 4.0 * error + 1e-5 * expected } else { error + 1e-12 };
            assert!(off <= allowed, "{name}, {receiver}: {value} and {expected}, said {error:e}");
            assert!(*error < 0.02 * expected, "{name}, {receiver}: {error:e}");
        }
    }
}

#[test]
fn cells_of_the_map_of_a_wall_are_nothing_where_a_window_lies_on_it() {
    let grid = surface_receiver("front") + "grid = [10, 10]\n";
    let lamp = surface_of_its_own("sun", "polygon = [[0,1,0.4], [1,1,0.4], [1,1,1], [0,1,1]]", "0", "5");
    let wall = surface("front", "sun", &polygon(&on_front([[0.0, 1.0]; 2])));
    for (name, window) in [
        ("a window", polygon(&on_front([[0.3, 0.8], [0.0, 0.6]]))),
        ("a disk", "disk = { center = [0.5,0,0.5], normal = [0,1,0], radius = 0.31 }".to_owned()),
    ] {
        let text = lamp.clone() + &wall + &surface("window", "sun", &(window + "\non = \"front\"")) + &grid;
        let with = results(&text);
        let without = results(&(lamp.clone() + &wall + &grid));
        let [with, without] = [with, without].map(|found| found.maps[0].values[0].clone());
        for (cell, (with, without)) in with.iter().zip(&without).enumerate() {
            // the first edge goes up: columns are along z, rows along x
            let [z, x] = [cell % 10, cell / 10].map(|place| (place as f64 + 0.5) / 10.0);
            let is_off = match name {
                "a window" => x > 0.3 && x < 0.8 && z < 0.6,
                _ => (x - 0.5).hypot(z - 0.5) < 0.31,
            };
            assert_eq!(with.is_nan(), is_off, "{name}: cell {cell}");
            assert!(
                is_off || (with - without).abs() <= 1e-12 * without,
                "{name}: cell {cell}: {with}, {without}"
            );
        }
    }
}
