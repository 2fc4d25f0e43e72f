//! Receivers of faces, of back sides and of many points: their results agree with closed forms, with
//! energy balances, and with receivers of single points.

mod vtk;

use forms_radiometry::output::csv;
use forms_radiometry::scene::{Scene, read_with_files};
use forms_radiometry::simulation::{Answer, Layout, Map, Quantity, Simulation, Unwatched, plan, simulate};
use forms_testing::scene_text::elements::{mirror_aside, two_sided};
use forms_testing::scene_text::{
    Point, material, point_receiver, polygon, surface, surface_of_its_own, tolerance,
};

/// A lamp above the floor, which faces down.
const LAMP: [Point; 4] = [[0.2, 0.3, 2.0], [0.2, 0.9, 2.0], [0.8, 0.9, 2.0], [0.8, 0.3, 2.0]];
const FLOOR: [Point; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
/// Places on the floor and above it.
const PLACES: [Point; 4] = [[0.25, 0.5, 0.0], [0.9, 0.1, 0.5], [0.5, 0.5, 1.0], [0.1, 1.9, 1.9]];

/// Faces of a cube whose fronts are inside: its floor, its ceiling, and its sides, one of which is
/// cut into two triangles.
const INWARD: [&[u32]; 7] =
    [&[1, 2, 4, 3], &[5, 7, 8, 6], &[1, 5, 6, 2], &[3, 4, 8, 7], &[1, 3, 7, 5], &[2, 6, 8], &[2, 8, 4]];

/// Returns some of these faces as OBJ, or with their fronts outside.
fn cube(faces: &[&[u32]], is_inward: bool, [low, high]: [f64; 2]) -> String {
    let corners = [0, 1, 2, 3, 4, 5, 6, 7].map(|corner: u32| {
        let place = |bit: u32| if corner >> bit & 1 == 0 { low } else { high };
        format!("v {} {} {}\n", place(0), place(1), place(2))
    });
    let face = |corners: &&[u32]| {
        let mut corners: Vec<String> = corners.iter().map(ToString::to_string).collect();
        if !is_inward {
            corners.reverse();
        }
        format!("f {}\n", corners.join(" "))
    };
    corners.concat() + &faces.iter().map(face).collect::<String>()
}

fn scene_with(text: &str, files: &[(&str, &[u8])]) -> Scene {
    let open = |name: &str| {
        let found = files.iter().find(|(file, _)| *file == name);
        found.map(|(_, bytes)| bytes.to_vec()).ok_or_else(|| std::io::ErrorKind::NotFound.into())
    };
    read_with_files(text, "test.toml", &open).unwrap_or_else(|errors| panic!("{}", errors[0]))
}

fn solved(scene: &Scene) -> Simulation {
    let plan = plan(scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    simulate(&plan, &Unwatched)
}

fn found(text: &str, files: &[(&str, &[u8])]) -> Simulation {
    solved(&scene_with(text, files))
}

fn answer<'s>(found: &'s Simulation, receiver: &str, quantity: Quantity) -> &'s Answer {
    let mut answers = found.answers.iter();
    let is_it = |answer: &&Answer| answer.receiver == receiver && answer.quantity == quantity;
    answers.find(is_it).unwrap_or_else(|| panic!("{receiver} has no {quantity:?}"))
}

fn map<'s>(found: &'s Simulation, receiver: &str, quantity: Quantity) -> &'s Map {
    let mut maps = found.maps.iter();
    let is_it = |map: &&Map| map.receiver == receiver && map.quantity == quantity;
    maps.find(is_it).unwrap_or_else(|| panic!("{receiver} has no map of {quantity:?}"))
}

fn receiver(name: &str, kind: &str, keys: &str) -> String {
    format!("[[receiver]]\nname = \"{name}\"\nkind = \"{kind}\"\n{keys}\n")
}

fn mesh(name: &str, file: &str, [reflectance, exitance]: [f64; 2]) -> String {
    surface_of_its_own(name, &format!("mesh = \"{file}\""), &reflectance.to_string(), &exitance.to_string())
}

/// Checks that values agree within the errors of both, times a factor for standard errors.
fn check_close(name: &str, one: (f64, f64), other: (f64, f64), factor: f64) {
    let allowed = factor * (one.1 + other.1) + 1e-12 * one.0.abs().max(1e-3);
    assert!((one.0 - other.0).abs() <= allowed, "{name}: {one:?} and {other:?}");
}

/// Returns a text without and with a surface that only path tracing can handle.
fn by_both_methods(text: &str) -> [(&'static str, String, f64); 2] {
    [("radiosity", text.to_owned(), 1.0), ("paths", text.to_owned() + &mirror_aside(), 5.0)]
}

#[test]
fn every_face_of_a_glowing_closed_cube_gets_the_exitance_over_one_minus_the_reflectance() {
    let text = mesh("room", "room.obj", [0.5, 3.0])
        + &receiver("faces", "faces", "surface = \"room\"")
        + &tolerance(1e-2);
    for (name, text, factor) in by_both_methods(&text) {
        let found = found(&text, &[("room.obj", cube(&INWARD, true, [0.0, 2.0]).as_bytes())]);
        let irradiance = map(&found, "faces", Quantity::Irradiance);
        assert_eq!((irradiance.size, irradiance.layout), ([7, 1], Layout::List), "{name}");
        let net = map(&found, "faces", Quantity::NetFlux);
        for face in 0..7 {
            let of = |map: &Map| (map.values[0][face], map.errors[0][face]);
            check_close(name, of(irradiance), (6.0, 0.0), factor);
            check_close(name, of(net), (0.0, 0.0), factor);
        }
        let of = |quantity| {
            let answer = answer(&found, "faces", quantity);
            (answer.value, answer.error)
        };
        check_close(name, of(Quantity::Irradiance), (6.0, 0.0), factor);
        check_close(name, of(Quantity::Flux), (6.0 * 24.0, 0.0), factor);
        check_close(name, of(Quantity::NetFlux), (0.0, 0.0), factor);
        assert!(found.accuracy().missed(1e-2).iter().all(|missed| !missed), "{name}");
    }
}

#[test]
fn net_fluxes_of_a_closed_scene_add_up_to_zero() {
    let text = mesh("room", "room.obj", [0.5, 0.0])
        + &mesh("lamp", "lamp.obj", [0.25, 2.0])
        + &receiver("on room", "faces", "surface = \"room\"")
        + &receiver("on lamp", "faces", "surface = \"lamp\"")
        + &tolerance(2e-2);
    for (name, text, factor) in by_both_methods(&text) {
        let (lamp, room) = (
            cube(&INWARD[1..2], true, [0.0, 3.0]),
            cube(&[&INWARD[..1], &INWARD[2..]].concat(), true, [0.0, 3.0]),
        );
        let found = found(&text, &[("room.obj", room.as_bytes()), ("lamp.obj", lamp.as_bytes())]);
        let total = |receiver: &str| {
            let answer = answer(&found, receiver, Quantity::NetFlux);
            (answer.value, answer.error)
        };
        let [room, lamp] = ["on room", "on lamp"].map(total);
        assert!(room.0 > 0.0 && lamp.0 < 0.0, "{name}: the room absorbs, and the lamp emits");
        check_close(name, (room.0, room.1), (-lamp.0, lamp.1), factor);
        for receiver in ["on room", "on lamp"] {
            let map = map(&found, receiver, Quantity::NetFlux);
            let sum = |numbers: &[Vec<f64>]| numbers[0].iter().sum::<f64>();
            check_close(name, total(receiver), (sum(&map.values), sum(&map.errors)), factor);
        }
    }
}

/// Returns a plate in the plane z = 0 between two lamps, at these heights, and its receivers.
fn plate_between([one, other]: [f64; 2], side: &str, is_two_sided: bool, reflectance: f64) -> String {
    let plate = polygon(&FLOOR);
    let plate = if is_two_sided { two_sided(&plate) } else { plate };
    let lamp = |z: f64, exitance: f64, name: &str| {
        let mut corners = LAMP.map(|[x, y, _]| [x, y, z]);
        if z < 0.0 {
            corners.reverse();
        }
        surface_of_its_own(name, &polygon(&corners), "0.5", &exitance.to_string())
    };
    [
        &material("plate", reflectance),
        &surface("plate", "plate", &plate)[..],
        &lamp(one, 1.0, "first"),
        &lamp(other, 5.0, "second"),
        &receiver("mean", "surface", &format!("surface = \"plate\"\nside = \"{side}\"")),
        &receiver("map", "surface", &format!("surface = \"plate\"\nside = \"{side}\"\ngrid = [4, 6]")),
        &receiver("face", "faces", &format!("surface = \"plate\"\nside = \"{side}\"")),
        &tolerance(1e-2),
    ]
    .concat()
}

#[test]
fn the_back_of_a_plate_has_what_its_front_has_in_the_mirrored_scene() {
    for (is_two_sided, reflectance) in [(true, 0.0), (true, 0.6), (false, 0.0)] {
        for by_paths in [false, true] {
            let more = if by_paths { mirror_aside() } else { String::new() };
            let solved = |heights, side| {
                found(&(plate_between(heights, side, is_two_sided, reflectance) + &more), &[])
            };
            let (back, front) = (solved([2.0, -1.0], "back"), solved([-2.0, 1.0], "front"));
            let factor = if by_paths { 5.0 } else { 1.0 };
            for (one, other) in back.answers.iter().zip(&front.answers) {
                assert!(one.value != 0.0, "{}", one.receiver);
                check_close(&one.receiver, (one.value, one.error), (other.value, other.error), factor);
            }
            for (one, other) in back.maps.iter().zip(&front.maps) {
                for cell in 0..one.values[0].len() {
                    let of = |map: &Map| (map.values[0][cell], map.errors[0][cell]);
                    check_close(&format!("{} {cell}", one.receiver), of(one), of(other), factor);
                }
            }
        }
    }
}

#[test]
fn the_back_of_a_one_sided_surface_absorbs_all_light_and_reflects_none() {
    let dark = found(&plate_between([2.0, -1.0], "back", false, 0.9), &[]);
    let black = found(&plate_between([2.0, -1.0], "back", false, 0.0), &[]);
    for quantity in [Quantity::Irradiance, Quantity::NetFlux] {
        let [one, other] = [&dark, &black].map(|found| answer(found, "face", quantity));
        check_close("back", (one.value, one.error), (other.value, other.error), 1.0);
    }
    let [flux, net] = [Quantity::Flux, Quantity::NetFlux].map(|quantity| answer(&dark, "face", quantity));
    check_close("absorbed", (flux.value, 0.0), (net.value, 0.0), 1.0);
}

/// Returns a lamp above a black floor, or above one that reflects.
fn lit_floor(reflectance: f64) -> String {
    surface_of_its_own("lamp", &polygon(&LAMP), "0", "[1, 2]")
        + &surface_of_its_own("floor", &polygon(&FLOOR), &reflectance.to_string(), "0")
}

fn in_bands(text: &str) -> String {
    format!("bands = [[400, 500], [500, 600]]\n{text}")
}

#[test]
fn points_of_a_table_have_exactly_the_light_of_single_points() {
    let tilted = |index: usize| [0.0, 0.1 * index as f64, 1.0];
    let rows: Vec<String> = PLACES
        .iter()
        .enumerate()
        .map(|(index, [x, y, z])| format!("{x},{y},{z},0,{},1\n", 0.1 * index as f64))
        .collect();
    let table = format!("x, y, z, nx, ny, nz\n{}", rows.concat());
    let singles: String = PLACES
        .iter()
        .enumerate()
        .map(|(index, &place)| point_receiver(&index.to_string(), place, tilted(index)))
        .collect();
    let many = found(
        &in_bands(&(lit_floor(0.0) + &receiver("many", "point", "points = \"points.csv\""))),
        &[("points.csv", table.as_bytes())],
    );
    let single = found(&in_bands(&(lit_floor(0.0) + &singles)), &[]);
    let map = map(&many, "many", Quantity::Irradiance);
    for (index, pair) in single.answers.chunks(2).enumerate() {
        for (band, answer) in pair.iter().enumerate() {
            assert_eq!(map.values[band][index], answer.value, "point {index}");
            assert_eq!(map.errors[band][index], answer.error, "point {index}");
        }
    }
    let mean = answer(&many, "many", Quantity::Irradiance);
    let sum: f64 = map.values[0].iter().sum();
    check_close("mean", (mean.value, 0.0), (sum / PLACES.len() as f64, 0.0), 1.0);
}

#[test]
fn points_around_which_light_is_reflected_agree_with_single_points_within_the_errors() {
    let rows: String = PLACES.iter().map(|[x, y, z]| format!("{z},{y},{x}\n")).collect();
    let table = format!("z,y,x\n{rows}");
    let singles: String = PLACES
        .iter()
        .enumerate()
        .map(|(index, place)| receiver(&index.to_string(), "sphere", &format!("position = {place:?}")))
        .collect();
    let text = in_bands(
        &(lit_floor(0.5)
            + &receiver("many", "sphere", "points = \"points.csv\"")
            + &singles
            + &tolerance(2e-2)),
    );
    for (name, text, factor) in by_both_methods(&text) {
        let found = found(&text, &[("points.csv", table.as_bytes())]);
        assert_eq!(found.maps.len(), 4, "{name}");
        for map in &found.maps {
            for index in 0..PLACES.len() {
                let is_it = |answer: &&Answer| {
                    answer.receiver == index.to_string() && answer.quantity == map.quantity
                };
                for (band, single) in found.answers.iter().filter(is_it).enumerate() {
                    let cell = (map.values[band][index], map.errors[band][index]);
                    check_close(name, cell, (single.value, single.error), factor);
                }
            }
        }
        assert!(found.accuracy().missed_cells(2e-2).is_empty(), "{name}");
    }
}

#[test]
fn a_plane_has_the_middles_of_its_cells_and_a_line_its_ends() {
    let plane = "plane = { origin = [0, 0, 0.5], u = [1, 0, 0], v = [0, 2, 0], count = [2, 4] }";
    let line = "line = { from = [0, 0, 0.5], to = [1, 2, 0.5], count = 3 }\nnormal = [0, 0, 1]";
    let points = [[0.75, 1.25, 0.5], [0.0, 0.0, 0.5], [0.5, 1.0, 0.5], [1.0, 2.0, 0.5]];
    let singles: String = points
        .iter()
        .enumerate()
        .map(|(index, &place)| point_receiver(&index.to_string(), place, [0.0, 0.0, 1.0]))
        .collect();
    let text = lit_floor(0.0).replace("[1, 2]", "1")
        + &receiver("plane", "point", plane)
        + &receiver("line", "point", line)
        + &singles;
    let found = found(&text, &[]);
    let of = |index: usize| answer(&found, &index.to_string(), Quantity::Irradiance).value;
    let [plane, line] = ["plane", "line"].map(|receiver| map(&found, receiver, Quantity::Irradiance));
    assert_eq!((plane.size, plane.layout), ([2, 4], Layout::Grid));
    assert_eq!((line.size, line.layout), ([3, 1], Layout::List));
    // column 1, row 2
    assert_eq!(plane.values[0][5], of(0));
    assert_eq!(line.values[0], [of(1), of(2), of(3)]);
    let mut table = Vec::new();
    csv(&found, &mut table).expect("memory");
    let table = String::from_utf8(table).expect("text");
    let value = of(0);
    assert!(table.contains(&format!("plane,irradiance,,,1,2,{value:?},")), "{table}");
}

#[test]
fn many_points_take_no_plan_each() {
    let plane = "plane = { origin = [0, 0, 0.5], u = [1, 0, 0], v = [0, 2, 0], count = [50, 100] }";
    let text = lit_floor(0.0).replace("[1, 2]", "1") + &receiver("plane", "point", plane);
    let found = found(&text, &[]);
    let cells = &found.maps[0].values[0];
    // this takes seconds; work in the square of the number of points would take hours
    assert!(cells.len() == 5000 && cells.iter().all(|value| *value > 0.0));
}

#[test]
fn errors_and_sides_are_of_each_face_alone() {
    // a face in the shadow of another surface gets less light than one in the open
    let text = lit_floor(0.0).replace("[1, 2]", "1")
        + &mesh("part", "part.obj", [0.0, 0.0])
        + &receiver("faces", "faces", "surface = \"part\"");
    let found = found(&text, &[("part.obj", cube(&INWARD, false, [0.4, 0.6]).as_bytes())]);
    let map = map(&found, "faces", Quantity::Irradiance);
    let (top, bottom) = (map.values[0][1], map.values[0][0]);
    assert!(top > 0.05 && bottom == 0.0, "{top} and {bottom}");
    assert!(
        map.errors[0]
            .iter()
            .zip(&map.values[0])
            .all(|(error, value)| *error <= 1e-3 * value.max(map.scales[0]))
    );
}
