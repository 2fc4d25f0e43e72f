//! Ear clipping: triangulates a simple polygon.

use super::Vector;
use super::plane::ROUNDING;

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
/// (Meisters 1975). A vertex that may lie on the side of a triangle counts as inside it: were it cut
/// off, the rest would not be simple. If rounding hides every ear, the widest corner is cut, so that
/// the loop always ends.
pub(super) fn triangulate(vertices: &[Vector], normal: Vector) -> Vec<[usize; 3]> {
    let rounding = ROUNDING * vertices.iter().map(|v| v.largest()).fold(0.0, f64::max);
    let mut rest: Vec<usize> = (0..vertices.len()).collect();
    let mut outline = vertices.to_vec();
    let mut triangles = Vec::with_capacity(rest.len());
    while rest.len() >= 3 {
        let ear_within = |rounding| (0..rest.len()).find(|&i| is_ear(&outline, i, normal, rounding));
        let ear = ear_within(rounding).or_else(|| ear_within(0.0));
        let ear = ear.unwrap_or_else(|| widest(&outline, normal));
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

/// Whether a corner is an ear. Vertices within the rounding of its triangle are inside.
fn is_ear(vertices: &[Vector], i: usize, normal: Vector, rounding: f64) -> bool {
    let [a, b, c] = corner(vertices, i);
    let sides = [[a, b], [b, c], [c, a]].map(|[from, to]| (from, to, -rounding * (to - from).length()));
    let inside = |p: Vector| {
        let is_left = |&(from, to, least): &(Vector, Vector, f64)| turn(from, to, p, normal) >= least;
        p != a && p != b && p != c && sides.iter().all(is_left)
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
