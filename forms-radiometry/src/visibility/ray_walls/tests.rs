//! Rays meet walls where they are, and never leave a closed room.

use super::*;
use crate::geometry::Profile;

const UP: Vector = Vector::new(0.0, 0.0, 1.0);

fn square(half: f64, height: f64, at: Vector) -> Wall {
    let corner = |x: f64, y: f64| at + Vector::new(x * half, y * half, height);
    let vertices = vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    Wall::Polygon { vertices: vertices.into(), normal: UP }
}

#[test]
fn walls_are_met_where_they_are_and_on_the_side_that_is_turned_to_the_ray() {
    let sphere = |inward| Wall::Sphere(Sphere { center: Vector::new(0.0, 0.0, 5.0), radius: 1.0, inward });
    let disk = Wall::Disk(Disk { center: Vector::new(0.0, 0.0, 3.0), normal: -UP, radius: 1.0, hole: 0.0 });
    let cases = [
        ("a polygon from behind", vec![square(1.0, 2.0, Vector::default())], [0.5, 0.5], Some((2.0, false))),
        ("beside a polygon", vec![square(1.0, 2.0, Vector::default())], [1.5, 0.5], None),
        ("a disk from its front", vec![disk.clone()], [0.5, 0.5], Some((3.0, true))),
        ("beside a disk", vec![disk.clone()], [0.8, 0.8], None),
        ("a sphere from outside", vec![sphere(false)], [0.6, 0.0], Some((4.2, true))),
        ("a hollow sphere from outside", vec![sphere(true)], [0.6, 0.0], Some((4.2, false))),
        ("the nearer of two", vec![sphere(false), disk], [0.0, 0.0], Some((3.0, true))),
    ];
    for (name, walls, [x, y], expected) in cases {
        let walls = Walls::of(walls);
        let met = walls.first(walls.start_free(Vector::new(x, y, 0.0)), UP, f64::INFINITY);
        let found = met.map(|met| ((1e12 * met.distance).round() / 1e12, met.is_front));
        assert_eq!(found, expected, "{name}");
    }
}

/// Traces rays that bounce in a closed box, sphere, cylinder or cone, moved far away, and scaled: none leaves,
/// and none hits the wall where it starts.
#[test]
fn no_ray_leaves_a_closed_room_or_meets_the_wall_it_leaves() {
    for scale in [1e-6, 1.0, 1e6] {
        for offset in [0.0, 1e3, 1e8] {
            let center = offset * scale * Vector::new(1.0, -0.7, 0.3);
            let inside = Sphere { center, radius: scale, inward: true };
            let cans =
                [can(center, [scale; 2]), can(center, [scale, 0.4 * scale]), can(center, [scale, 0.0])];
            for walls in [vec![Wall::Sphere(inside)], cube(center, scale)].into_iter().chain(cans) {
                let walls = Walls::of(walls);
                bounce(&walls, center);
            }
        }
    }
}

/// A cone with its base, or the two ends of a cylinder, closed by disks.
fn can(center: Vector, radii: [f64; 2]) -> Vec<Wall> {
    let axis = Vector::new(0.48, -0.6, 0.64);
    let ends = [center - 1.5 * radii[0] * axis, center + 1.5 * radii[0] * axis];
    let side = Quadric { ends, radii, profile: Profile::Straight, inward: true };
    let lid = |end: usize| Disk { center: ends[end], normal: axis, radius: radii[end], hole: 0.0 };
    let lids = (0..2).map(lid).filter(|lid| lid.radius > 0.0).map(Wall::Disk);
    [Wall::Quadric(side)].into_iter().chain(lids).collect()
}

fn cube(center: Vector, scale: f64) -> Vec<Wall> {
    let corner = |bits: usize| {
        let side = |bit: usize| if bits >> bit & 1 == 1 { scale } else { -scale };
        center + Vector::new(side(0), side(1), side(2))
    };
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let wall = |face: [usize; 4]| {
        let vertices = face.map(corner);
        let normal = (vertices[1] - vertices[0]).cross(vertices[3] - vertices[0]).unit();
        Wall::Polygon { vertices: vertices.as_slice().into(), normal: normal.expect("a face has a normal") }
    };
    faces.map(wall).to_vec()
}

fn bounce(walls: &Walls, center: Vector) {
    let mut samples = crate::sampling::Random::new(4);
    let mut direction = Vector::new(0.36, 0.48, 0.8);
    let mut start = walls.start_at(center);
    for step in 0..20_000 {
        let met = walls.first(start, direction, f64::INFINITY);
        let met = met.unwrap_or_else(|| panic!("step {step}: a ray left the room at {center:?}"));
        start = walls.start_on(&met, met.is_front);
        let inside = if (center - met.position).dot(met.normal) > 0.0 { met.normal } else { -met.normal };
        let frame = crate::sampling::Frame::about(inside);
        direction = frame.place(forms_kernels::cosine_hemisphere_sample(samples.next(), samples.next()));
    }
}

/// Random squares, disks and spheres: a wall is hidden if the ray meets another one before it.
#[test]
fn a_wall_is_hidden_where_another_one_is_met_first() {
    let mut samples = crate::sampling::Random::new(11);
    let mut number = |low: f64, high: f64| low + (high - low) * samples.next();
    let mut counts = [0; 3];
    for _ in 0..40 {
        let mut place = || Vector::new(number(-3.0, 3.0), number(-3.0, 3.0), number(1.0, 6.0));
        let squares = (0..6).map(|_| square(0.8, 0.0, place())).collect::<Vec<_>>();
        let disks = (0..6).map(|_| Disk { center: place(), normal: -UP, radius: 0.9, hole: 0.3 });
        let disks = disks.map(Wall::Disk).collect::<Vec<_>>();
        let spheres = (0..6).map(|_| Sphere { center: place(), radius: 0.6, inward: false });
        let walls = Walls::of([squares, disks, spheres.map(Wall::Sphere).collect()].concat());
        for _ in 0..200 {
            let start = walls.start_free(Vector::new(number(-2.0, 2.0), number(-2.0, 2.0), 0.0));
            let direction = Vector::new(number(-0.5, 0.5), number(-0.5, 0.5), 1.0).unit().unwrap();
            let first = walls.first(start, direction, f64::INFINITY);
            for wall in 0..18 {
                let Some((distance, is_front)) = walls.at(wall, start, direction) else {
                    assert_ne!(first.map(|met| met.wall), Some(wall));
                    counts[0] += 1;
                    continue;
                };
                let is_hidden = walls.are_between(start, direction, distance, Some(wall));
                let met = first.expect("something is met");
                assert_eq!(is_hidden, met.wall != wall);
                assert!(is_hidden || (met.distance, met.is_front) == (distance, is_front));
                counts[1 + usize::from(is_hidden)] += 1;
            }
        }
    }
    assert!(counts.iter().all(|&count| count > 1000), "{counts:?}");
}
