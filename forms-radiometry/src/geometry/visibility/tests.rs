//! Laws of visibility: what a point in a closed scene sees of all faces fills its hemisphere, wherever and however large the scene is.

use super::*;
use crate::geometry::form_factor_of_pieces;

/// Numbers in [0, 1) that look random.
struct Numbers(u64);

impl Numbers {
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

/// A parallelepiped from a corner along three edges that are right-handed, with its faces to the outside or to the inside.
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

/// A room with a box that stands on the floor, one that leans in the air, one in a corner, a screen that touches the wall, and two that share an
/// edge.
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

/// The boxes in the furnished room, which no receiver is in.
fn is_free(point: Vector) -> bool {
    let within = |low: [f64; 3], high: [f64; 3]| {
        point.x > low[0] && point.x < high[0] && point.y > low[1] && point.y < high[1] && point.z < high[2]
    };
    let leaning = (point - Vector::new(0.67, 0.28, 0.68)).length() < 0.2;
    !within([0.2, 0.3, 0.0], [0.5, 0.5, 0.5]) && !within([0.75, 0.75, 0.0], [1.0, 1.0, 0.6]) && !leaning
}

fn faces_of(polygons: &[Polygon]) -> Vec<Face> {
    polygons.iter().enumerate().flat_map(|(index, polygon)| Face::of(index, polygon)).collect()
}

/// The visible form factor of one face, and what is between it and the receiver.
fn seen(screens: &Screens, face: &Face, position: Vector, normal: Vector) -> f64 {
    let (mut found, mut work) = (Vec::new(), Workspace::default());
    let Face { vertices, normal: m, .. } = face;
    let between = screens.between(&[position], Some(normal), vertices, *m, &mut found);
    let pieces = screens.visible(position, Some(normal), vertices, *m, &found, &mut work);
    let sum = form_factor_of_pieces(pieces, normal);
    assert!(between != Between::All || sum.abs() < 1e-14, "all is hidden, and still {sum} is seen");
    sum
}

/// The sum over all faces.
fn closure(screens: &Screens, faces: &[Face], position: Vector, normal: Vector) -> f64 {
    faces.iter().map(|face| seen(screens, face, position, normal)).sum()
}

#[test]
fn what_a_point_in_a_closed_room_sees_fills_its_hemisphere() {
    let faces = faces_of(&furnished());
    let screens = Screens::of(&faces);
    let mut numbers = Numbers(0x9e37_79b9_7f4a_7c15);
    let mut points = 0;
    while points < 1000 {
        let (position, normal) = (numbers.vector(), numbers.direction());
        if is_free(position) {
            points += 1;
            let sum = closure(&screens, &faces, position, normal);
            assert!((sum - 1.0).abs() < 1e-12, "{position:?} {normal:?}: {:e}", sum - 1.0);
        }
    }
}
