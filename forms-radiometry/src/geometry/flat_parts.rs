//! Flat parts: neighbouring faces of a mesh that lie in one plane become one polygon.
//!
//! ```text
//! faces ─ joined across common edges within one plane ─▶ regions
//! region ─┬─ one simple outline ─▶ a polygon, without vertices inside its edges
//!         └─ holes, or an outline that touches itself ─▶ its faces
//! ```
//! The cost of visibility, of elements and of integrals is that of polygons: a wall of 2000
//! triangles costs what a rectangle costs. Vertices do not move. A vertex may be off the plane of
//! its region, or off an edge, by no more than rounding, so that areas and angles agree to nine
//! digits.

use super::polygon::{area, edges};
use super::{FaceList, Polygon, Vector};
use rustc_hash::{FxHashMap, FxHashSet};

/// Largest distance of a vertex from the plane of a region, relative to the extent of both faces.
const FLAT: f64 = 1e-9;
/// Largest sine of the angle at a vertex that counts as inside an edge.
const STRAIGHT: f64 = 1e-12;
/// Largest number of vertices of an outline: checking it takes time with the square of this number.
const MOST_VERTICES: usize = 1 << 11;
/// Largest difference of the area of a region from that of its faces, relative to it.
const SAME_AREA: f64 = 1e-9;

/// Returns the faces, with those of flat regions replaced by outlines of the regions.
pub(super) fn flat_parts(vertices: &[Vector], faces: &FaceList) -> FaceList {
    let mesh = Joined::of(vertices, faces);
    let mut parts = FaceList::default();
    for region in mesh.regions() {
        match mesh.outline(&region) {
            Some(outline) => parts.push(outline),
            None => region.iter().for_each(|&face| parts.push(faces.get(face).iter().copied())),
        }
    }
    parts
}

/// Faces whose vertices at one position have one number.
struct Joined<'m> {
    vertices: &'m [Vector],
    /// The vertices of each face.
    faces: Vec<Vec<u32>>,
    normals: Vec<Vector>,
    /// The face on the left of each directed edge; `None` if there are several.
    on_left: FxHashMap<[u32; 2], Option<usize>>,
}

impl<'m> Joined<'m> {
    fn of(vertices: &'m [Vector], faces: &FaceList) -> Self {
        let mut numbers: FxHashMap<[u64; 3], u32> = FxHashMap::default();
        let mut number = |&index: &u32| {
            let Vector { x, y, z } = vertices[index as usize];
            // -0 and 0 are one position
            *numbers.entry([x, y, z].map(|x| (x + 0.0).to_bits())).or_insert(index)
        };
        let faces: Vec<Vec<u32>> = faces.iter().map(|face| face.iter().map(&mut number).collect()).collect();
        let mut on_left = FxHashMap::default();
        for (face, outline) in faces.iter().enumerate() {
            for edge in edges(outline) {
                on_left.entry(edge).and_modify(|left| *left = None).or_insert(Some(face));
            }
        }
        let normals = faces.iter().map(|outline| normal(vertices, outline)).collect();
        Self { vertices, faces, normals, on_left }
    }

    /// Returns the regions: every face is in one of them.
    fn regions(&self) -> Vec<Vec<usize>> {
        let mut is_known = vec![false; self.faces.len()];
        let mut regions = Vec::new();
        for seed in 0..self.faces.len() {
            if std::mem::replace(&mut is_known[seed], true) {
                continue;
            }
            let mut region = vec![seed];
            let mut place = 0;
            while let Some(&face) = region.get(place) {
                for [a, b] in edges(&self.faces[face]) {
                    let Some(Some(other)) = self.on_left.get(&[b, a]).copied() else { continue };
                    let is_single = matches!(self.on_left.get(&[a, b]), Some(Some(_)));
                    if is_single && !is_known[other] && self.are_flat(seed, other) {
                        is_known[other] = true;
                        region.push(other);
                    }
                }
                place += 1;
            }
            regions.push(region);
        }
        regions
    }

    /// Whether a face lies in the plane of another one and faces the same way.
    fn are_flat(&self, seed: usize, face: usize) -> bool {
        let (normal, about) = (self.normals[seed], self.at(self.faces[seed][0]));
        let offsets = || self.faces[face].iter().map(|&index| self.at(index) - about);
        let extent = offsets().map(Vector::length).fold(0.0, f64::max);
        let is_near = |offset: Vector| normal.dot(offset).abs() <= FLAT * extent;
        let turn = normal.cross(self.normals[face]).length();
        normal.dot(self.normals[face]) > 0.0 && turn <= FLAT && offsets().all(is_near)
    }

    fn at(&self, index: u32) -> Vector {
        self.vertices[index as usize]
    }

    /// Returns the outline of a region of several faces, if it is a single polygon without holes.
    fn outline(&self, region: &[usize]) -> Option<Vec<u32>> {
        if region.len() < 2 {
            return None;
        }
        let inside: FxHashSet<[u32; 2]> = region.iter().flat_map(|&face| edges(&self.faces[face])).collect();
        let mut next: FxHashMap<u32, u32> = FxHashMap::default();
        let mut count = 0;
        for &[a, b] in inside.iter().filter(|[a, b]| !inside.contains(&[*b, *a])) {
            next.insert(a, b);
            count += 1;
        }
        if next.len() < count || count > MOST_VERTICES {
            return None;
        }
        // the smallest vertex, so that the outline does not depend on the order of a hash table
        let start = *next.keys().min()?;
        let following = |&index: &u32| next.get(&index).copied().filter(|&index| index != start);
        let outline: Vec<u32> = std::iter::successors(Some(start), following).take(count).collect();
        let outline = if outline.len() == count { self.without_straight(&outline) } else { return None };
        let corners: Vec<Vector> = outline.iter().map(|&index| self.at(index)).collect();
        let polygon = Polygon::new(corners).ok()?;
        let of_face = |&face: &usize| {
            let corners: Vec<Vector> = self.faces[face].iter().map(|&index| self.at(index)).collect();
            area(&corners, polygon.normal())
        };
        let sum: f64 = region.iter().map(of_face).sum();
        ((polygon.area() - sum).abs() <= SAME_AREA * sum).then_some(outline)
    }

    /// Returns an outline without the vertices inside its edges.
    fn without_straight(&self, outline: &[u32]) -> Vec<u32> {
        let count = outline.len();
        let is_corner = |&place: &usize| {
            let [before, own, after] =
                [place + count - 1, place, place + 1].map(|place| self.at(outline[place % count]));
            let [along, on] = [own - before, after - own];
            along.dot(on) <= 0.0 || along.cross(on).length() > STRAIGHT * along.length() * on.length()
        };
        (0..count).filter(is_corner).map(|place| outline[place]).collect()
    }
}

/// Returns Newell's unit normal of an outline.
fn normal(vertices: &[Vector], outline: &[u32]) -> Vector {
    let about = vertices[outline[0] as usize];
    let offset = |index: u32| vertices[index as usize] - about;
    let sum =
        outline.windows(2).fold(Vector::default(), |sum, pair| sum + offset(pair[0]).cross(offset(pair[1])));
    sum.unit().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::super::Mesh;
    use super::*;
    use forms_testing::SplitMix;

    /// Returns the faces of a grid of squares, each cut into triangles, for which `is_there` holds.
    fn grid(columns: u32, rows: u32, is_there: impl Fn(u32, u32) -> bool) -> (Vec<Vector>, Vec<Vec<u32>>) {
        let mut vertices = Vec::new();
        let mut faces = Vec::new();
        for row in 0..rows {
            for column in (0..columns).filter(|&column| is_there(column, row)) {
                let first = vertices.len() as u32;
                let corner = |i: u32, j: u32| Vector::new(f64::from(column + i), f64::from(row + j), 0.0);
                vertices.extend([corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)]);
                faces.push(vec![first, first + 1, first + 2]);
                faces.push(vec![first, first + 2, first + 3]);
            }
        }
        (vertices, faces)
    }

    fn parts((vertices, faces): (Vec<Vector>, Vec<Vec<u32>>)) -> Vec<usize> {
        let mut list = FaceList::default();
        faces.iter().for_each(|face| list.push(face.iter().copied()));
        flat_parts(&vertices, &list).iter().map(<[u32]>::len).collect()
    }

    #[test]
    fn a_flat_region_is_one_polygon_if_it_has_one_outline() {
        let cases: [(&str, Vec<usize>, Vec<usize>); 5] = [
            ("a wall", parts(grid(20, 30, |_, _| true)), vec![4]),
            ("an L", parts(grid(4, 4, |i, j| i < 2 || j < 2)), vec![6]),
            ("two walls", parts(grid(5, 2, |i, _| i != 2)), vec![4, 4]),
            ("a wall with a hole", parts(grid(3, 3, |i, j| [i, j] != [1, 1])), vec![3; 16]),
            ("squares that touch at a corner", parts(grid(2, 2, |i, j| i == j)), vec![4, 4]),
        ];
        cases.into_iter().for_each(|(name, found, expected)| assert_eq!(found, expected, "{name}"));
    }

    #[test]
    fn faces_that_fold_or_lie_upon_each_other_stay_apart() {
        let (mut vertices, faces) = grid(2, 1, |_, _| true);
        vertices.iter_mut().filter(|v| v.x > 1.5).for_each(|v| v.z = 1e-6);
        assert_eq!(parts((vertices, faces)), [4, 4], "folded by a millionth");
        let (vertices, mut faces) = grid(1, 1, |_, _| true);
        faces.extend(faces.clone());
        assert_eq!(parts((vertices, faces)), [3; 4], "twice");
        let (vertices, mut faces) = grid(1, 1, |_, _| true);
        faces[1].reverse();
        assert_eq!(parts((vertices, faces)), [3, 3], "facing opposite ways");
    }

    #[test]
    fn parts_cover_the_area_of_the_faces_in_any_position() {
        let mut random = SplitMix(5);
        for _ in 0..200 {
            let mut unit = || 2.0 * random.unit() - 1.0;
            let (a, b) = (Vector::new(unit(), unit(), unit()), Vector::new(unit(), unit(), unit()));
            let size = 1 + (4.0 * (unit() + 1.0)) as u32;
            let holes = unit();
            let (vertices, faces) = grid(size, size + 1, |i, j| f64::from(i * 7 + j * 5).sin() > holes);
            if faces.is_empty() {
                continue;
            }
            let mesh = Mesh::new(vertices.into_iter().map(|v| v.x * a + v.y * b).collect(), &faces).unwrap();
            let sum = |polygons: Vec<Polygon>| polygons.iter().map(Polygon::area).sum::<f64>();
            let [whole, parts] = [sum(mesh.polygons().collect()), sum(mesh.flat_parts().collect())];
            assert!((whole - parts).abs() <= 1e-9 * whole, "{whole} and {parts}");
        }
    }
}
