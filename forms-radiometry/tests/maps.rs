//! Maps: their cells agree with receivers at the centres of the cells, and are within their errors.

use forms_radiometry::scene::{Scene, read};
use forms_radiometry::simulation::{Answer, Unwatched, plan, simulate};

use forms_testing::scene_text::{cube, point_receiver, surface_of_its_own as surface, surface_receiver};

/// Whether numeric code is optimised; otherwise fewer cases are run.
const IS_OPTIMISED: bool = !cfg!(debug_assertions);

fn scene(text: &str) -> Scene {
    read(text, "test.toml").unwrap_or_else(|errors| panic!("{}", errors[0]))
}

fn answers(text: &str) -> Vec<Answer> {
    let scene = scene(text);
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    simulate(&plan, &Unwatched).answers
}

/// A cell of a map, on the plane z = 0.
struct Cell {
    middle: [f64; 2],
    /// The irradiance in both bands.
    values: [f64; 2],
}

/// Returns a lamp above a triangle with more objects, in two bands; and the cells of a map of 19 by
/// 13 of the triangle's front.
fn triangle(more: &str) -> (String, Vec<Cell>) {
    const SIZE: [usize; 2] = [19, 13];
    let text = "bands = [[400, 500], [500, 600]]\n".to_string()
        + &surface("lamp", "polygon = [[-1,-1,2], [-1,1,2], [1,1,2], [1,-1,2]]", "0", "[1, 3]")
        + &surface("floor", "polygon = [[-2,-2,0], [3,-2,0], [0,2,0]]", "0", "0")
        + more;
    let scene = scene(&format!("{text}{}grid = {SIZE:?}\n", surface_receiver("floor")));
    let found = simulate(&plan(&scene).expect("the scene is right"), &Unwatched);
    let of_bands = &found.maps[0].values;
    let place = |index: usize, count: usize, length: f64| length * (index as f64 + 0.5) / count as f64 - 2.0;
    let of_cell = |cell: usize| Cell {
        middle: [place(cell % SIZE[0], SIZE[0], 5.0), place(cell / SIZE[0], SIZE[1], 4.0)],
        values: [of_bands[0][cell], of_bands[1][cell]],
    };
    (text, (0..SIZE[0] * SIZE[1]).map(of_cell).collect())
}

#[test]
fn a_cell_of_a_map_has_what_a_receiver_at_its_middle_has() {
    let plate = surface("plate", "polygon = [[0,0,1], [1.5,0,1], [1.5,1.5,1], [0,1.5,1]]", "0", "0");
    for (name, more) in [("free", ""), ("behind a plate", plate.as_str())] {
        let (text, cells) = triangle(more);
        // below the sides that meet at (0, 2)
        let is_inside = |[x, y]: [f64; 2]| 4.0 * x + 3.0 * y < 6.0 && y < 2.0 * x + 2.0;
        let (inside, outside): (Vec<Cell>, Vec<Cell>) =
            cells.into_iter().partition(|cell| is_inside(cell.middle));
        assert!(outside.iter().all(|cell| cell.values.iter().all(|value| value.is_nan())), "{name}");
        let receiver = |(index, cell): (usize, &Cell)| {
            let [x, y] = cell.middle;
            point_receiver(&index.to_string(), [x, y, 0.0], [0.0, 0.0, 1.0])
        };
        let receivers: String = inside.iter().enumerate().map(receiver).collect();
        let found = answers(&(text + &receivers));
        for (answer, value) in found.iter().zip(inside.iter().flat_map(|cell| cell.values)) {
            let off = (answer.value - value).abs();
            assert!(off <= 1e-13, "{name}, {}: {} and {value}", answer.receiver, answer.value);
        }
        assert_eq!(found.len(), 2 * inside.len());
    }
}

#[test]
fn cells_of_maps_with_reflected_light_are_within_their_errors_though_most_are_interpolated() {
    const SIDE: usize = 24;
    let room = cube([0.6, 0.2, 0.7, 0.5, 0.3, 0.6], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
        + &surface(
            "lamp",
            "polygon = [[0.4,0.4,0.95], [0.4,0.6,0.95], [0.6,0.6,0.95], [0.6,0.4,0.95]]",
            "0",
            "9",
        )
        + &surface(
            "screen",
            "polygon = [[0.2,0.5,0], [0.6,0.5,0], [0.6,0.5,0.4], [0.2,0.5,0.4]]\ntwo_sided = true",
            "0.5",
            "0",
        );
    let map = |orders: &str, tolerance: f64| {
        let text = format!("{room}{}grid = [{SIDE}, {SIDE}]\n", surface_receiver("floor"));
        let scene = scene(&format!("{text}[solve]\ntolerance = {tolerance}\n{orders}"));
        let found = simulate(&plan(&scene).expect("the scene is right"), &Unwatched);
        (found.maps[0].values[0].clone(), found.maps[0].errors[0].clone(), found.maps[0].scales[0])
    };
    for orders in ["", "effects = { interreflection = 1 }\n"] {
        let (exact, of_exact, _) = map(orders, if IS_OPTIMISED { 2e-3 } else { 2e-2 });
        for tolerance in if IS_OPTIMISED { &[0.5, 0.1, 0.02][..] } else { &[0.5][..] } {
            let (values, errors, scale) = map(orders, *tolerance);
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            assert!((scale - mean).abs() <= 1e-12 * mean, "{orders}{tolerance}: {scale}, not {mean}");
            for (cell, (value, error)) in values.iter().zip(&errors).enumerate() {
                let off = (value - exact[cell]).abs();
                assert!(
                    off <= error + of_exact[cell],
                    "{orders}{tolerance}: cell {cell} is off by {off:e} of {error:e}"
                );
                assert!(
                    *error <= tolerance * value.max(mean),
                    "{orders}{tolerance}: {error:e} of {value}, {mean}"
                );
            }
        }
    }
}
