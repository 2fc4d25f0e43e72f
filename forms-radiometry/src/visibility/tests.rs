//! Laws of visibility: in a closed scene, the visible parts of all faces fill the hemisphere of a
//! point, wherever and however large the scene is.

mod groups;
mod searches;

use super::*;
use crate::form_factor::form_factor_of_pieces;
use crate::geometry::{Disk, Sphere};
use forms_kernels::solid_angle_triangle;
use std::f64::consts::PI;

/// Generator of pseudo-random numbers in [0, 1).
struct Numbers(u64);

impl Numbers {
    fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15))
    }

    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn vector(&mut self) -> Vector {
        Vector::new(self.next(), self.next(), self.next())
    }

    fn direction(&mut self) -> Vector {
        let centre = Vector::new(0.5, 0.5, 0.5);
        (self.vector() - centre).unit().expect("no direction is exactly the middle")
    }
}

const ORIGIN: Vector = Vector::new(0.0, 0.0, 0.0);
const UP: Vector = Vector::new(0.0, 0.0, 1.0);

/// A parallelepiped with one corner at `o` and three right-handed edges, with its faces outwards or
/// inwards.
fn parallelepiped(o: Vector, [u, v, w]: [Vector; 3], outward: bool) -> Vec<Polygon> {
    let sides = [[u, v, w], [v, w, u], [w, u, v]];
    let pair = |[a, b, c]: [Vector; 3]| {
        [vec![o, o + b, o + a + b, o + a], vec![o + c, o + a + c, o + a + b + c, o + b + c]]
    };
    let polygon = |mut outline: Vec<Vector>| {
        if !outward {
            outline.reverse();
        }
        Polygon::new(outline).expect("a parallelogram")
    };
    sides.into_iter().flat_map(pair).map(polygon).collect()
}

fn upright(o: [f64; 3], [a, b, c]: [f64; 3], outward: bool) -> Vec<Polygon> {
    let edges = [Vector::new(a, 0.0, 0.0), Vector::new(0.0, b, 0.0), Vector::new(0.0, 0.0, c)];
    parallelepiped(Vector::new(o[0], o[1], o[2]), edges, outward)
}

fn polygon(points: &[[f64; 3]]) -> Polygon {
    Polygon::new(points.iter().map(|&[x, y, z]| Vector::new(x, y, z)).collect()).expect("a polygon")
}

fn room() -> Vec<Polygon> {
    upright([0.0; 3], [1.0; 3], false)
}

/// A room with a box on the floor, a tilted box in the air, a box in a corner, a screen that
/// touches the wall, and two screens that share an edge.
fn furnished() -> Vec<Polygon> {
    let mut all = room();
    all.extend(upright([0.2, 0.3, 0.0], [0.3, 0.2, 0.5], true));
    all.extend(upright([0.75, 0.75, 0.0], [0.25, 0.25, 0.6], true));
    let [u, v] = [Vector::new(0.12, 0.05, 0.08), Vector::new(-0.03, 0.11, 0.06)];
    let w = u.cross(v).unit().expect("they are not parallel");
    all.extend(parallelepiped(Vector::new(0.6, 0.2, 0.6), [u, v, 0.1 * w], true));
    all.push(polygon(&[[0.0, 0.1, 0.7], [0.4, 0.1, 0.7], [0.4, 0.6, 0.75], [0.0, 0.6, 0.75]]));
    all.push(polygon(&[[0.5, 0.6, 0.3], [0.9, 0.6, 0.3], [0.7, 0.6, 0.65]]));
    all.push(polygon(&[[0.5, 0.6, 0.3], [0.7, 0.6, 0.65], [0.4, 0.9, 0.5]]));
    all
}

/// Whether a point of the room is outside all objects in it.
fn is_free(point: Vector) -> bool {
    let within = |low: [f64; 3], high: [f64; 3]| {
        point.x > low[0] && point.x < high[0] && point.y > low[1] && point.y < high[1] && point.z < high[2]
    };
    let within_ball = |middle: [f64; 3], radius: f64| {
        let [x, y, z] = middle;
        (point - Vector::new(x, y, z)).length() < radius
    };
    let leaning = within_ball([0.67, 0.28, 0.68], 0.2) || within_ball([0.35, 0.8, 0.88], 0.11);
    !within([0.2, 0.3, 0.0], [0.5, 0.5, 0.5]) && !within([0.75, 0.75, 0.0], [1.0, 1.0, 0.6]) && !leaning
}

fn faces_of(polygons: &[Polygon]) -> Vec<Face> {
    polygons.iter().enumerate().flat_map(|(index, polygon)| Face::of(index, polygon)).collect()
}

/// The visible form factor of one face, by its pieces, and by its contour where that is available.
fn seen(screens: &Screens, face: &Face, position: Vector, normal: Vector) -> f64 {
    let (mut found, mut work) = (Vec::new(), Workspace::default());
    let Face { vertices, normal: m, .. } = face;
    screens.between(&[position], Some(normal), vertices, *m, &mut found);
    let pieces = screens.visible(position, Some(normal), vertices, *m, &found, &mut work);
    let by_pieces = form_factor_of_pieces(pieces, normal);
    let here = [position];
    let looking = Looking {
        points: &here,
        outline: &here,
        horizon: Some(normal),
        luminaire: (vertices, *m),
        screens: &found,
    };
    let mut by_border = [0.0];
    screens.add_form_factors(looking, (normal, 1.0), (&mut work, &mut Borders::default()), &mut by_border);
    assert!((by_border[0] - by_pieces).abs() < 1e-13, "{by_border:?} and {by_pieces}");
    by_pieces
}

/// The sum over all faces.
fn closure(screens: &Screens, faces: &[Face], position: Vector, normal: Vector) -> f64 {
    faces.iter().map(|face| seen(screens, face, position, normal)).sum()
}

/// A map of points.
type Image<'i> = &'i dyn Fn(Vector) -> Vector;

/// The same faces, each corner moved.
fn moved(faces: &[Face], image: impl Fn(Vector) -> Vector) -> Vec<Face> {
    let moved =
        |face: &Face| Face { vertices: face.vertices.iter().map(|&v| image(v)).collect(), ..face.clone() };
    faces.iter().map(moved).collect()
}

/// A random free point in the furnished room.
fn free_point(numbers: &mut Numbers) -> Vector {
    std::iter::repeat_with(|| numbers.vector()).find(|&point| is_free(point)).expect("numbers never end")
}

/// The furnished room with a ball under the ceiling and a disk in front of a wall.
fn with_round_shapes() -> Vec<Face> {
    let mut faces = faces_of(&furnished());
    let ball = Sphere { center: Vector::new(0.35, 0.8, 0.88), radius: 0.1, inward: false };
    let triangles = ball.triangles(0).into_iter();
    faces.extend(triangles.flat_map(|triangle| Face::of_outline(90, &triangle)));
    let disk = Disk {
        center: Vector::new(0.5, 0.05, 0.5),
        normal: Vector::new(0.0, 0.6, 0.8),
        radius: 0.05,
        hole: 0.0,
    };
    faces.extend(Face::sides(91, &disk.polygon(0), disk.normal));
    faces
}

#[test]
fn what_a_point_in_a_closed_room_sees_fills_its_hemisphere() {
    let mut turned = with_round_shapes();
    let (u, v) = (Vector::new(0.48, 0.6, -0.64), Vector::new(0.8, 0.0, 0.6));
    let turn = |x: Vector| x.x * u + x.y * v + x.z * u.cross(v);
    turned = moved(&turned, turn);
    turned.iter_mut().for_each(|face| face.normal = turn(face.normal));
    let no_turn = |x: Vector| x;
    let cases: [(&str, Vec<Face>, Image, usize); 4] = [
        ("empty", faces_of(&room()), &no_turn, 1000),
        ("furnished", faces_of(&furnished()), &no_turn, 1000),
        ("with round shapes", with_round_shapes(), &no_turn, 200),
        ("turned", turned, &turn, 200),
    ];
    for (name, faces, turn, count) in cases {
        let screens = Screens::of(&faces);
        let mut numbers = Numbers::new(1);
        for _ in 0..count {
            let position = free_point(&mut numbers);
            let (position, normal) = (turn(position), numbers.direction());
            let sum = closure(&screens, &faces, position, normal);
            assert!((sum - 1.0).abs() < 1e-12, "{name}: {position:?} {normal:?}: {:e}", sum - 1.0);
        }
    }
}

#[test]
fn what_points_on_surfaces_see_fills_their_hemisphere() {
    let faces = with_round_shapes();
    let screens = Screens::of(&faces);
    let mut numbers = Numbers::new(3);
    for face in faces.iter().filter(|face| face.surface >= 6) {
        let [a, b, c] = [0, 1, 2].map(|corner| face.vertices[corner]);
        let (s, t) = (0.1 + 0.4 * numbers.next(), 0.1 + 0.4 * numbers.next());
        let position = a + s * (b - a) + t * (c - a);
        // skipped: the backs of closed bodies, and points on the floor or on a wall, which are not
        // inside the closed room
        let is_inside = [position.x, position.y, position.z].iter().all(|&c| c > 1e-6 && c < 1.0 - 1e-6);
        let sees_out = face.is_back && (face.surface < 24 || face.surface == 90);
        if is_inside && !sees_out {
            let sum = closure(&screens, &faces, position, face.normal);
            assert!((sum - 1.0).abs() < 1e-12, "{face:?} {position:?}: {:e}", sum - 1.0);
        }
    }
}

#[test]
fn without_a_horizon_all_directions_are_seen() {
    let faces = with_round_shapes();
    let screens = Screens::of(&faces);
    let (mut numbers, mut found, mut work) = (Numbers::new(5), Vec::new(), Workspace::default());
    for _ in 0..100 {
        let position = free_point(&mut numbers);
        let mut whole = 0.0;
        for Face { vertices, normal, .. } in &faces {
            screens.between(&[position], None, vertices, *normal, &mut found);
            for piece in screens.visible(position, None, vertices, *normal, &found, &mut work) {
                let triangles = piece[1..].windows(2).map(|pair| [piece[0], pair[0], pair[1]]);
                whole += triangles.map(solid_angle).sum::<f64>();
            }
        }
        assert!((whole / (4.0 * PI) - 1.0).abs() < 1e-12, "{position:?}: {whole}");
    }
}

/// The solid angle of a triangle relative to the apex.
fn solid_angle([a, b, c]: [Vector; 3]) -> f64 {
    solid_angle_triangle(0.0, 0.0, 0.0, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z).abs()
}

#[test]
fn what_is_visible_does_not_depend_on_the_unit_of_length() {
    let faces = with_round_shapes();
    let screens = Screens::of(&faces);
    for exponent in [-200, -1, 40, 200] {
        let unit = 2.0_f64.powi(exponent);
        let scaled = moved(&faces, |v| unit * v);
        let scaled_screens = Screens::of(&scaled);
        let mut numbers = Numbers::new(7);
        for _ in 0..3 {
            let (position, normal) = (free_point(&mut numbers), numbers.direction());
            for (face, scaled) in faces.iter().zip(&scaled) {
                let expected = seen(&screens, face, position, normal);
                let found = seen(&scaled_screens, scaled, unit * position, normal);
                assert!((found - expected).abs() <= 1e-15, "2^{exponent}, {face:?}: {found} and {expected}");
            }
        }
    }
}

#[test]
fn what_is_visible_does_not_depend_on_the_place_beyond_the_rounding_of_coordinates() {
    let faces = with_round_shapes();
    let screens = Screens::of(&faces);
    for distance in [1e3, 1e6, 1e8] {
        let shift = Vector::new(distance, -0.7 * distance, 0.3 * distance);
        let shifted = moved(&faces, |v| v + shift);
        let shifted_screens = Screens::of(&shifted);
        let mut numbers = Numbers::new(11);
        for _ in 0..10 {
            let (position, normal) = (free_point(&mut numbers), numbers.direction());
            let mut sum = 0.0;
            for (face, shifted) in faces.iter().zip(&shifted) {
                let expected = seen(&screens, face, position, normal);
                let found = seen(&shifted_screens, shifted, position + shift, normal);
                // rounding of a coordinate, relative to lengths of at least a tenth
                let tolerance = 100.0 * f64::EPSILON * distance;
                assert!(
                    (found - expected).abs() <= tolerance,
                    "{distance}, {face:?}: {found} and {expected}"
                );
                sum += found;
            }
            assert!((sum - 1.0).abs() <= 1000.0 * f64::EPSILON * distance, "{distance}: {sum}");
        }
    }
}

/// Visible fraction of the form factor of the lamp [−1, 1]² at height 2 behind screens, seen from
/// the origin.
fn visible_fraction(others: &[Polygon]) -> f64 {
    let lamp = rectangle((-1.0, 1.0), (-1.0, 1.0), 2.0);
    let all: Vec<Polygon> = others.iter().cloned().chain([lamp]).collect();
    let faces = faces_of(&all);
    let lamp = &faces[faces.len() - 2];
    let visible = seen(&Screens::of(&faces), lamp, ORIGIN, UP);
    visible / seen(&Screens::of(&faces[faces.len() - 2..]), lamp, ORIGIN, UP)
}

/// A rectangle that faces down.
fn rectangle(x: (f64, f64), y: (f64, f64), height: f64) -> Polygon {
    let corners = [(x.0, y.0), (x.0, y.1), (x.1, y.1), (x.1, y.0)];
    polygon(&corners.map(|(x, y)| [x, y, height]))
}

/// The rectangle in front of the lamp's half at positive x.
fn half() -> Polygon {
    rectangle((0.0, 9.0), (-9.0, 9.0), 1.0)
}

/// A screen that meets the lamp's plane at this x, and leans by `slope`.
fn leaning(x: f64, slope: f64) -> Polygon {
    let corners = [(-9.0, -3.0), (9.0, -3.0), (9.0, 3.0), (-9.0, 3.0)];
    polygon(&corners.map(|(y, z)| [x + slope * z, y, 2.0 + z]))
}

/// A wall at right angles to the lamp, up to half its height.
fn wall(x: f64) -> Polygon {
    polygon(&[[x, -9.0, 1.0], [x, 9.0, 1.0], [x, 9.0, -1.0], [x, -9.0, -1.0]])
}

#[test]
fn screens_leave_what_symmetry_says() {
    let block = |bottom: bool| {
        let mut all = upright([0.0, -9.0, 0.5], [9.0, 18.0, 0.5], true);
        all.retain(|side| bottom || side.normal().z > -0.5);
        all
    };
    let at = |x: (f64, f64), y: (f64, f64), height: f64| rectangle(x, y, height);
    let cases = [
        ("all hidden", vec![at((-9.0, 9.0), (-9.0, 9.0), 1.0)], 0.0),
        ("just hidden", vec![at((-0.5, 0.5), (-0.5, 0.5), 1.0)], 0.0),
        ("half hidden", vec![half()], 0.5),
        ("the same half twice", vec![half(), at((0.0, 9.0), (-9.0, 9.0), 0.5)], 0.5),
        ("the same polygon twice", vec![half(), half()], 0.5),
        ("overlapping in one plane", vec![half(), at((-9.0, 4.0), (-9.0, 0.0), 1.0), half()], 0.25),
        ("a quarter left", vec![half(), at((-9.0, 9.0), (0.0, 9.0), 0.5)], 0.25),
        ("two halves", vec![half(), at((-9.0, 0.0), (-9.0, 9.0), 0.5)], 0.0),
        ("two halves that touch", vec![half(), at((-9.0, 0.0), (-9.0, 9.0), 1.0)], 0.0),
        ("a block before one half", block(true), 0.5),
        ("a block without a bottom", block(false), 0.5),
        ("leaning from the lamp's edge over the receiver", vec![leaning(1.0, 1.0)], 0.0),
        ("leaning through the lamp's middle", vec![leaning(0.0, 1.0)], 0.5),
    ];
    for (name, others, expected) in cases {
        let found = visible_fraction(&others);
        assert!((found - expected).abs() < 1e-14, "{name}: {found}");
    }
    let nearly_edge_on = visible_fraction(&[wall(1e-6)]);
    assert!((nearly_edge_on - 0.5).abs() < 1e-5, "{nearly_edge_on}");
}

#[test]
fn what_is_not_in_between_hides_nothing_and_a_sliver_hardly_anything() {
    let sheet = |height: f64| rectangle((-9.0, 9.0), (-9.0, 9.0), height);
    let cases = [
        ("nothing", vec![]),
        ("beside the lamp", vec![rectangle((0.5, 9.0), (-9.0, 9.0), 1.0)]),
        ("beyond the lamp", vec![sheet(3.0)]),
        ("in the lamp's plane", vec![sheet(2.0)]),
        ("behind the receiver", vec![sheet(-1.0)]),
        ("under the receiver's feet", vec![sheet(0.0)]),
        ("edge-on", vec![wall(0.0)]),
        ("leaning away from the lamp's edge", vec![leaning(1.0, -1.0)]),
    ];
    for (name, others) in cases {
        let found = visible_fraction(&others);
        assert!((found - 1.0).abs() < 1e-14, "{name}: {found}");
    }
    for x in [-0.3, 0.0, 0.2] {
        let sliver = polygon(&[[x, -9.0, 1.0], [x + 1e-8, 0.0, 1.0], [x, 9.0, 1.0]]);
        let hidden = 1.0 - visible_fraction(&[sliver]);
        assert!(hidden > 1e-9 && hidden < 2e-8, "{x}: {hidden:e}");
    }
}

#[test]
fn the_back_of_a_face_is_the_mirror_image_of_its_front() {
    let faces = faces_of(&[rectangle((-1.0, 1.0), (-0.5, 2.0), 1.0)]);
    let screens = Screens::of(&faces);
    let from =
        |face: usize, z: f64, normal: Vector| seen(&screens, &faces[face], Vector::new(0.3, 0.2, z), normal);
    assert!(from(0, 0.0, UP) > 0.1);
    assert_eq!(from(1, 0.0, UP), 0.0);
    assert!((from(0, 0.0, UP) - from(1, 2.0, -UP)).abs() < 1e-15);
}
