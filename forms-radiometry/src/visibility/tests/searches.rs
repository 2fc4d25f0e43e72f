//! Searches skip screens, join them into bodies and stop at the first intersection: their results
//! equal those of testing all screens.

use super::*;
use crate::CORNELL_BOX;
use crate::faces::faces;
use crate::scene::read;

/// A random convex outline: the corners of a triangle or a parallelogram, or one point.
fn outline(numbers: &mut Numbers) -> Vec<Vector> {
    let o = numbers.vector();
    let [u, v] = [0.3 * numbers.direction(), 0.3 * numbers.direction()];
    match (3.0 * numbers.next()) as u32 {
        0 => vec![o],
        1 => vec![o, o + u, o + v],
        _ => vec![o, o + u, o + u + v, o + v],
    }
}

/// A random point of an outline.
fn inside(outline: &[Vector], numbers: &mut Numbers) -> Vector {
    let weights: Vec<f64> = outline.iter().map(|_| numbers.next()).collect();
    let sum: f64 = weights.iter().sum();
    weights.iter().zip(outline).fold(ORIGIN, |point, (weight, &corner)| point + (weight / sum) * corner)
}

/// The furniture without the room's walls, so that it is seen from all sides.
fn furniture() -> Vec<Face> {
    with_round_shapes().into_iter().filter(|face| face.surface >= 6).collect()
}

#[test]
fn what_cannot_come_between_hides_nothing() {
    let faces = furniture();
    let screens = Screens::of(&faces);
    let every: Vec<u32> = (0..screens.screens.len() as u32).collect();
    let (mut numbers, mut found, mut work) = (Numbers::new(13), Vec::new(), Workspace::default());
    let mut counts = [0; 3];
    for _ in 0..3000 {
        let (receivers, luminaire) = (outline(&mut numbers), outline(&mut numbers));
        let Ok(luminaire) = Polygon::new(luminaire) else { continue };
        let (vertices, facing) = (luminaire.vertices(), luminaire.normal());
        let horizon =
            (receivers.len() > 2).then(|| (receivers[1] - receivers[0]).cross(receivers[2] - receivers[0]));
        let horizon = horizon.and_then(Vector::unit);
        let between = screens.between(&receivers, horizon, vertices, facing, &mut found);
        counts[between as usize] += 1;
        let bodies = found.iter().filter(|&&index| index as usize >= screens.screens.len()).count();
        assert!(between != Between::Some || bodies <= screens.bodies.len());
        for _ in 0..4 {
            let position = inside(&receivers, &mut numbers);
            let normal = horizon.unwrap_or_else(|| numbers.direction());
            let mut form_factor = |between: &[u32]| {
                let pieces = screens.visible(position, Some(normal), vertices, facing, between, &mut work);
                form_factor_of_pieces(pieces, normal)
            };
            let [all, some, none] = [form_factor(&every), form_factor(&found), form_factor(&[])];
            assert!((all - some).abs() < 1e-13, "{receivers:?}, {vertices:?}: {all} and {some}");
            match between {
                Between::Nothing => assert!((all - none).abs() < 1e-13),
                Between::Some => {}
                Between::All => assert!(all < 1e-13),
            }
        }
    }
    assert!(counts.iter().all(|&count| count > 30), "{counts:?}");
}

/// A roof over the floor; neither of its sides alone hides all.
fn wedge() -> Vec<Polygon> {
    let [a, b] = [[-2.0, -1.0, 0.2], [3.0, -1.0, 0.2]];
    let [c, d] = [[3.0, 2.0, 0.2], [-2.0, 2.0, 0.2]];
    let [left, right] = [[-2.0, 0.5, 0.8], [3.0, 0.5, 0.8]];
    vec![
        polygon(&[a, b, right, left]),
        polygon(&[c, d, left, right]),
        polygon(&[a, left, d]),
        polygon(&[b, c, right]),
    ]
}

#[test]
fn a_screen_is_left_out_or_hides_all_by_where_the_shaft_passes() {
    let [floor, lamp] = [
        polygon(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]),
        rectangle((0.0, 1.0), (0.0, 1.0), 1.0),
    ];
    let leaning = |x: f64| polygon(&[[x, 0.0, 0.1], [x + 0.8, 0.0, 0.9], [x + 0.8, 1.0, 0.9], [x, 1.0, 0.1]]);
    let cases = [
        ("nothing", vec![], Between::Nothing),
        ("a ceiling in between", vec![rectangle((0.0, 1.0), (0.0, 1.0), 0.5)], Between::All),
        ("a ceiling with a gap", vec![rectangle((0.0, 1.0), (0.0, 0.999), 0.5)], Between::Some),
        ("a plate", vec![rectangle((0.4, 0.6), (0.4, 0.6), 0.5)], Between::Some),
        ("beside", vec![rectangle((1.0, 2.0), (0.0, 1.0), 0.5)], Between::Nothing),
        ("the walls of the room", room(), Between::Nothing),
        ("leaning within", vec![leaning(0.1)], Between::Some),
        ("leaning away, with its box across", vec![leaning(0.95)], Between::Some),
        ("leaning and beside", vec![leaning(1.0)], Between::Nothing),
        ("a block on the floor beside", upright([1.0, 0.2, 0.0], [0.3, 0.3, 0.9], true), Between::Nothing),
        ("a block that fills the room", upright([0.0, 0.0, 0.3], [1.0, 1.0, 0.4], true), Between::All),
        ("a wedge through the room", wedge(), Between::All),
        ("a block on the floor", upright([0.2, 0.2, 0.0], [0.3, 0.3, 0.9], true), Between::Some),
    ];
    for (name, others, expected) in cases {
        let faces = faces_of(&others.into_iter().chain([floor.clone(), lamp.clone()]).collect::<Vec<_>>());
        let found =
            Screens::of(&faces).between(floor.vertices(), Some(UP), lamp.vertices(), -UP, &mut Vec::new());
        assert_eq!(found, expected, "{name}");
    }
}

#[test]
fn convex_groups_of_screens_are_bodies_even_if_one_plane_is_open() {
    let block = || upright([0.2, 0.3, 0.1], [0.3, 0.2, 0.5], true);
    let without = |normals: &[Vector]| {
        let mut sides = block();
        sides.retain(|side| !normals.contains(&side.normal()));
        sides
    };
    let across = Vector::new(1.0, 0.0, 0.0);
    let cases = [
        ("a block", block(), 1),
        ("a block without a bottom", without(&[-UP]), 1),
        ("a block without bottom and top", without(&[UP, -UP]), 0),
        ("a corner", without(&[-UP, across]), 0),
        ("two blocks that touch", [block(), upright([0.5, 0.3, 0.1], [0.3, 0.2, 0.5], true)].concat(), 2),
        ("a room", room(), 0),
        (
            "two sides of one plate",
            vec![rectangle((0.0, 1.0), (0.0, 1.0), 0.5), rectangle((0.0, 1.0), (0.0, 1.0), 0.5).reversed()],
            0,
        ),
        ("the furnished room", furnished(), 3),
    ];
    for (name, polygons, expected) in cases {
        assert_eq!(Screens::of(&faces_of(&polygons)).bodies.len(), expected, "{name}");
    }
    let cornell_box = read(CORNELL_BOX, "cornell_box.toml").expect("a scene");
    assert_eq!(Screens::of(&faces(&cornell_box, 0)).bodies.len(), 2, "its blocks");
}

#[test]
fn rays_meet_first_what_is_nearest_and_nothing_slips_between_faces() {
    let faces = with_round_shapes();
    let screens = Screens::of(&faces);
    let mut numbers = Numbers::new(17);
    for _ in 0..3000 {
        let (origin, direction) = (free_point(&mut numbers), 0.3 * numbers.direction());
        let hit = screens.first(origin, direction).expect("the room is closed");
        let face = &faces[hit.face];
        assert!(face.normal.dot(direction) < 0.0, "a face is met from the side to which it looks: {face:?}");
        assert!(screens.hides_direction(origin, direction));
        let at = |distance: f64| origin + (hit.distance * distance) * direction;
        let height = face.normal.dot(at(1.0) - face.vertices[0]);
        assert!(height.abs() < 1e-14, "{face:?}: {height:e}");
        assert!(!screens.hides(origin, at(0.999)) && !screens.hides(at(0.999), origin));
        assert!(screens.hides(origin, at(1.001)) && screens.hides(at(1.001), origin));
        assert!(!screens.hides(origin, at(1.0)), "a point's own surface hides nothing");
    }
}

#[test]
fn of_faces_back_to_back_a_ray_meets_the_one_that_looks_to_it() {
    let square = polygon(&[[0.0, 0.0, 0.5], [1.0, 0.0, 0.5], [1.0, 1.0, 0.5], [0.0, 1.0, 0.5]]);
    let both = [square.clone(), square.reversed()];
    for order in [[0, 1], [1, 0]] {
        let faces: Vec<Face> =
            order.iter().enumerate().flat_map(|(index, &which)| Face::of(index, &both[which])).collect();
        let screens = Screens::of(&faces);
        let mut numbers = Numbers::new(23);
        for _ in 0..200 {
            let (from, to) =
                (inside(square.vertices(), &mut numbers), inside(square.vertices(), &mut numbers));
            let height = if numbers.next() < 0.5 { 0.7 } else { -0.3 };
            let origin = from + Vector::new(0.0, 0.0, height);
            let hit = screens.first(origin, to - origin).expect("the square is met");
            assert!(!faces[hit.face].is_back, "{order:?}: {hit:?} from {origin:?}");
            assert!((hit.distance - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn what_is_hidden_from_a_point_is_not_visible() {
    let faces = furniture();
    let screens = Screens::of(&faces);
    let (mut numbers, mut found, mut work) = (Numbers::new(19), Vec::new(), Workspace::default());
    let lamp = polygon(&[[0.0, 0.0, 0.97], [0.0, 1.0, 0.97], [1.0, 1.0, 0.97], [1.0, 0.0, 0.97]]);
    let mut hidden = 0;
    for _ in 0..300 {
        let (position, target) = (free_point(&mut numbers), inside(lamp.vertices(), &mut numbers));
        screens.between(&[position], None, lamp.vertices(), lamp.normal(), &mut found);
        let mut pieces = screens.visible(position, None, lamp.vertices(), lamp.normal(), &found, &mut work);
        let direction = target - position;
        // rounding leaves specks, and edges so short that no point is clearly on one side of them
        let holds = |piece: &[Vector]| {
            let mut edges = piece.iter().zip(piece.iter().cycle().skip(1));
            let is_speck = piece.iter().all(|&v| (v - piece[0]).length() < 1e-12);
            !is_speck && edges.all(|(a, b)| b.cross(*a).dot(direction) >= -1e-14)
        };
        let is_visible = pieces.any(holds);
        assert_eq!(
            is_visible,
            direction.z > 0.0 && !screens.hides(position, target),
            "{position:?} {target:?}"
        );
        hidden += u32::from(!is_visible);
    }
    assert!(hidden > 50, "{hidden}");
}

#[test]
fn a_scene_without_screens_hides_nothing() {
    let screens = Screens::of(&[]);
    let lamp = rectangle((-1.0, 1.0), (-1.0, 1.0), 2.0);
    let between = screens.between(&[ORIGIN], Some(UP), lamp.vertices(), lamp.normal(), &mut Vec::new());
    assert_eq!((between, screens.first(ORIGIN, UP)), (Between::Nothing, None));
    assert!(!screens.hides(ORIGIN, UP) && !screens.hides_direction(ORIGIN, UP));
}
