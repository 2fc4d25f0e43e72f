//! Ear clipping: a simple polygon goes in, triangles that cover it come out.

use super::Vector;

/// Twice the area of the triangle abc as seen against the normal n: n·((b − a) × (c − a)), positive for a
/// left turn.
pub(super) fn turn(a: Vector, b: Vector, c: Vector, normal: Vector) -> f64 {
    normal.dot((b - a).cross(c - a))
}

/// A triangle whose height is a smaller part of its longest side than this is no more than the rounding of three points in a line.
const LINE: f64 = 1e-14;

/// Triangles that cover a simple polygon, counter-clockwise as it is.
///
/// An ear is a convex corner whose triangle contains no other vertex; every simple polygon has one (Meisters
/// 1975). Should rounding hide it, the widest corner is cut, so that the loop always ends.
pub(super) fn triangulate(vertices: &[Vector], normal: Vector) -> Vec<Vec<Vector>> {
    let mut rest = vertices.to_vec();
    let mut triangles = Vec::with_capacity(rest.len());
    while rest.len() >= 3 {
        let ear =
            (0..rest.len()).find(|&i| is_ear(&rest, i, normal)).unwrap_or_else(|| widest(&rest, normal));
        let [a, b, c] = corner(&rest, ear);
        let squared = [b - a, c - b, a - c].map(|side| side.dot(side)).into_iter().fold(0.0, f64::max);
        if turn(a, b, c, normal) > LINE * squared {
            triangles.push(vec![a, b, c]);
        }
        rest.remove(ear);
    }
    triangles
}

fn corner(vertices: &[Vector], i: usize) -> [Vector; 3] {
    let count = vertices.len();
    [vertices[(i + count - 1) % count], vertices[i], vertices[(i + 1) % count]]
}

fn is_ear(vertices: &[Vector], i: usize, normal: Vector) -> bool {
    let [a, b, c] = corner(vertices, i);
    let inside = |p: Vector| {
        p != a
            && p != b
            && p != c
            && turn(a, b, p, normal) >= 0.0
            && turn(b, c, p, normal) >= 0.0
            && turn(c, a, p, normal) >= 0.0
    };
    turn(a, b, c, normal) > 0.0 && !vertices.iter().any(|&p| inside(p))
}

fn widest(vertices: &[Vector], normal: Vector) -> usize {
    let width = |&i: &usize| {
        let [a, b, c] = corner(vertices, i);
        turn(a, b, c, normal)
    };
    (0..vertices.len()).max_by(|i, j| width(i).total_cmp(&width(j))).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_that_rounding_takes_off_a_line_make_no_triangle() {
        for off in [0.0, 1e-10, 1e-15, 1e-20, 1e-151] {
            let corners =
                [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 2.0, 2.0], [off, 1.0, 1.0], [0.0, 0.0, 2.0]];
            let vertices = corners.map(|[x, y, z]| Vector::new(x, y, z));
            let triangles = triangulate(&vertices, Vector::new(1.0, 2e-16, -2e-16));
            assert_eq!(triangles.len(), 2, "{off}");
        }
    }
}
