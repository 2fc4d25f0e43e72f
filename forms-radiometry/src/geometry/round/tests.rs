//! Areas are exact, polyhedra are closed, and form factors converge to those of the curved shapes
//! with the stated order.

mod quadrics;

use super::*;
use crate::form_factor::form_factor;
use crate::geometry::Polygon;
use forms_kernels::{form_factor_point_disk, form_factor_point_sphere};

const CENTER: Vector = Vector::new(0.3, -0.2, 0.7);

fn triangle_area([a, b, c]: [Vector; 3]) -> Vector {
    0.5 * (b - a).cross(c - a)
}

#[test]
fn pieces_have_the_area_of_the_round_shape() {
    for fineness in 0..4 {
        for radius in [1.0, 0.37, 1e-60, 1e60] {
            for normal in
                [Vector::new(0.0, 0.0, 1.0), Vector::new(0.48, -0.6, 0.64), Vector::new(-1.0, 0.0, 0.0)]
            {
                let center = radius * CENTER;
                let polygon = Polygon::new(Disk { center, normal, radius, hole: 0.0 }.polygon(fineness))
                    .expect("a regular polygon");
                let (expected, count) = (PI * radius * radius, EDGES << fineness);
                assert_eq!(polygon.vertices().len(), count);
                assert!((polygon.normal() - normal).length() < 1e-14, "{normal:?} at fineness {fineness}");
                assert!((polygon.area() / expected - 1.0).abs() < 1e-14, "{} and {expected}", polygon.area());
            }
            let sphere = Sphere { center: radius * CENTER, radius, inward: false };
            let triangles = sphere.triangles(fineness);
            assert_eq!(triangles.len(), 80 << (2 * fineness));
            let area: f64 = triangles.iter().map(|&triangle| triangle_area(triangle).length()).sum();
            let expected = 4.0 * PI * radius * radius;
            assert!((area / expected - 1.0).abs() < 1e-13, "{area} and {expected} at fineness {fineness}");
        }
    }
}

#[test]
fn polyhedra_are_closed_convex_and_look_to_their_front() {
    for inward in [false, true] {
        for fineness in 0..3 {
            let triangles = Sphere { center: CENTER, radius: 1.0, inward }.triangles(fineness);
            let sum =
                triangles.iter().fold(Vector::default(), |sum, &triangle| sum + triangle_area(triangle));
            assert!(
                sum.length() < 1e-14,
                "the sum of areas times normals of a closed surface is zero: {sum:?}"
            );
            for triangle @ [a, ..] in &triangles {
                let normal = triangle_area(*triangle).unit().expect("triangles are not narrow");
                let normal = if inward { -normal } else { normal };
                assert!(normal.dot(*a - CENTER) > 0.9, "the outside is away from the centre");
                let is_behind = |corner: &Vector| normal.dot(*corner - *a) < 1e-14;
                assert!(triangles.iter().flatten().all(is_behind), "the polyhedron is convex");
            }
            let sizes = triangles.iter().map(|&triangle| triangle_area(triangle).length());
            let (least, most) =
                sizes.fold((f64::INFINITY, 0.0_f64), |(a, b), size| (a.min(size), b.max(size)));
            assert!(most < 1.5 * least, "triangles are nearly equal: {least} to {most}");
        }
    }
}

/// The errors of a form factor at fineness 0, 1, 2, 3, relative to the expected one.
fn errors(expected: f64, at: impl Fn(usize) -> f64) -> [f64; 4] {
    [0, 1, 2, 3].map(|fineness| (at(fineness) / expected - 1.0).abs())
}

#[test]
fn the_form_factor_of_a_disk_comes_nearer_with_the_fourth_power_of_its_edges() {
    let disk = Disk { center: CENTER, normal: Vector::new(0.0, 0.0, 1.0), radius: 1.0, hole: 0.0 };
    // height over the disk and distance from its axis; the largest error at fineness 0, and the
    // least order
    let cases = [
        (1.0, 0.0, 2e-5, 3.9),
        (0.3, 0.0, 2e-5, 3.9),
        (2.0, 0.5, 2e-5, 3.9),
        (0.5, 2.0, 2e-5, 3.9),
        (10.0, 3.0, 1e-6, 3.9),
        (0.3, 1.0, 2e-3, 3.5),
    ];
    for (height, away, most, order) in cases {
        let receiver = CENTER + Vector::new(0.6 * away, 0.8 * away, height);
        let down = Vector::new(0.0, 0.0, -1.0);
        let found = errors(form_factor_point_disk(1.0, height, away), |fineness| {
            form_factor(receiver, down, &Polygon::new(disk.polygon(fineness)).expect("a regular polygon"))
        });
        assert!(found[0] < most, "height {height}, {away} from the axis: {found:?}");
        let orders = [0, 1, 2].map(|step| (found[step] / found[step + 1]).log2());
        let is_fast = |place: usize| orders[place] > order || found[place + 1] < 1e-13;
        assert!((0..3).all(is_fast), "height {height}, {away} from the axis: {found:?}, orders {orders:?}");
    }
}

#[test]
fn the_form_factor_of_a_sphere_comes_nearer_with_the_square_of_its_edges() {
    let sphere = Sphere { center: CENTER, radius: 1.0, inward: false };
    let mut worst = [0.0_f64; 4];
    // distance of the centre, and the cosine of its angle from the receiver's normal: the horizon
    // cuts the last ones
    for (distance, cosine) in [(2.0, 1.0), (5.0, 1.0), (3.0, 0.7), (1.5, 0.9), (2.0, 0.3), (4.0, -0.1)] {
        let away = Vector::new(0.36, 0.48, 0.8);
        let across = Vector::new(0.8, -0.6, 0.0);
        let normal = cosine * -away + (1.0 - cosine * cosine).sqrt() * across;
        let found = errors(form_factor_point_sphere(distance, 1.0, cosine), |fineness| {
            let triangles = sphere.triangles(fineness).into_iter();
            let polygons = triangles.map(|triangle| Polygon::new(triangle.to_vec()).expect("a triangle"));
            polygons.map(|triangle| form_factor(CENTER + distance * away, normal, &triangle)).sum()
        });
        worst = std::array::from_fn(|place| worst[place].max(found[place]));
    }
    assert!(worst[0] < 0.01 && worst.is_sorted_by(|more, less| less < more), "{worst:?}");
    // at the vertices of the icosahedron, the order does not show from one step to the next
    let order = (worst[0] / worst[3]).log2() / 3.0;
    assert!(order > 1.9, "{worst:?}, order {order}");
}
