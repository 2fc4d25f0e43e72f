//! Ear clipping: triangulates a simple polygon.

use super::Vector;

/// Returns twice the area of the triangle abc as seen against the normal n: n·((b − a) × (c − a)),
/// positive for a left turn.
pub(super) fn turn(a: Vector, b: Vector, c: Vector, normal: Vector) -> f64 {
    normal.dot((b - a).cross(c - a))
}

/// A triangle whose height is a smaller fraction of its longest side than this counts as three
/// collinear points with rounding.
const LINE: f64 = 1e-14;

/// Triangulates a simple polygon. Returns the numbers of the corners of each triangle,
/// counter-clockwise like the polygon.
///
/// An ear is a convex corner whose triangle contains no other vertex; every simple polygon has one
/// (Meisters 1975). If rounding hides it, the widest corner is cut, so that the loop always ends.
pub(super) fn triangulate(vertices: &[Vector], normal: Vector) -> Vec<[usize; 3]> {
    let mut rest: Vec<usize> = (0..vertices.len()).collect();
    let mut outline = vertices.to_vec();
    let mut triangles = Vec::with_capacity(rest.len());
    while rest.len() >= 3 {
        let ears = (0..rest.len()).find(|&i| is_ear(&outline, i, normal));
        let ear = ears.unwrap_or_else(|| widest(&outline, normal));
        let [a, b, c] = corner(&outline, ear);
        let squared = [b - a, c - b, a - c].map(|side| side.dot(side)).into_iter().fold(0.0, f64::max);
        if turn(a, b, c, normal) > LINE * squared {
            triangles.push(corner(&rest, ear));
        }
        rest.remove(ear);
        outline.remove(ear);
    }
    triangles
}

fn corner<T: Copy>(outline: &[T], i: usize) -> [T; 3] {
    let count = outline.len();
    [outline[(i + count - 1) % count], outline[i], outline[(i + 1) % count]]
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
        for (off, scale) in
            [0.0, 1e-12, 1e-15, 1e-20, 1e-151].into_iter().flat_map(|off| [(off, 1.0), (off, 0.01)])
        {
            let corners =
                [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 2.0, 2.0], [off, 1.0, 1.0], [0.0, 0.0, 2.0]];
            let vertices = corners.map(|corner| {
                let [x, y, z] = corner.map(|place| scale * place);
                Vector::new(x, y, z)
            });
            let normal = Vector::new(1.0, 2e-16, -2e-16);
            let triangles = triangulate(&vertices, normal);
            let half_turn = |[a, b, c]: [Vector; 3]| 0.5 * turn(a, b, c, normal);
            let areas: Vec<f64> = triangles.iter().map(|t| half_turn(t.map(|i| vertices[i]))).collect();
            let sum: f64 = areas.iter().sum();
            assert!((sum - 3.0 * scale * scale).abs() < 1e-11 * scale * scale, "{off}: {areas:?}");
            assert!(areas.iter().all(|area| *area > 0.9 * scale * scale), "{off}: {areas:?}");
        }
    }
}
