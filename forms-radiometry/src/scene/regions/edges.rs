//! Edges: sorts the faces that share a line segment by their angle around it, and pairs the sides
//! that face each other there.

use super::interfaces::{Interface, Piece, Side};
use super::rims::rims;
use crate::geometry::Vector;
use std::collections::HashMap;
use std::f64::consts::TAU;

/// A line segment at which faces end, or the tangent of a circle.
pub(super) struct Edge {
    pub(super) ends: [Vector; 2],
    /// The centre of the circle to which it is the tangent, if the faces end in a circle.
    pub(super) center: Option<Vector>,
    /// The faces in the order of their angle around the segment.
    around: Vec<Wing>,
}

/// A face that ends at an edge.
#[derive(Clone, Copy)]
pub(super) struct Wing {
    interface: usize,
    /// Whether the face runs along the edge from its first end to its second.
    forward: bool,
    /// A vector across the edge into the face.
    into: Vector,
    angle: f64,
}

impl Wing {
    pub(super) fn new(interface: usize, forward: bool, into: Vector) -> Self {
        Self { interface, forward, into, angle: 0.0 }
    }

    /// Returns the side towards larger angles, and the side towards smaller angles. A face that
    /// runs forward has its inside on the left, seen from its front: its normal points to larger
    /// angles.
    fn sides(self) -> [Side; 2] {
        let sides = [Side::Front(self.interface), Side::Back(self.interface)];
        if self.forward { sides } else { [sides[1], sides[0]] }
    }
}

impl Edge {
    /// Creates an edge between two ends from the faces that end there.
    pub(super) fn new(ends: [Vector; 2], mut around: Vec<Wing>) -> Self {
        let axis = (ends[1] - ends[0]).unit().unwrap_or_default();
        let zero = around.first().map_or(Vector::default(), |wing| wing.into);
        let quarter = axis.cross(zero);
        for wing in &mut around {
            let angle = wing.into.dot(quarter).atan2(wing.into.dot(zero));
            // an angle that rounding makes slightly negative stays first
            wing.angle = if angle < -1e-9 { angle + TAU } else { angle };
        }
        around.sort_by(|a, b| a.angle.total_cmp(&b.angle));
        Self { ends, center: None, around }
    }

    /// Returns the pairs of sides that bound the same region here: neighbours in the order of
    /// angles.
    pub(super) fn facing(&self) -> impl Iterator<Item = (Side, Side)> {
        let count = self.around.len();
        (0..count).map(move |i| (self.around[i].sides()[0], self.around[(i + 1) % count].sides()[1]))
    }

    /// Returns two faces that extend in the same direction from this edge, and so coincide.
    pub(super) fn overlapping(&self) -> Option<(usize, usize)> {
        let mut neighbours = self.around.windows(2);
        let pair = neighbours.find(|pair| pair[1].angle - pair[0].angle < 1e-9)?;
        Some((pair[0].interface, pair[1].interface))
    }

    /// Whether only one face ends here.
    pub(super) fn is_free(&self) -> bool {
        self.around.len() == 1
    }

    /// Returns one of the faces.
    pub(super) fn first(&self) -> usize {
        self.around[0].interface
    }

    pub(super) fn interfaces(&self) -> impl Iterator<Item = usize> {
        self.around.iter().map(|wing| wing.interface)
    }
}

/// Two vertex numbers; for an undirected edge, the smaller one first.
pub(super) type Ends = (usize, usize);

/// Returns the edges of all faces, and the rims of round shapes. An edge that belongs to a single face is split at the ends of
/// other such edges on it.
pub(super) fn edges(interfaces: &[Interface], vertices: &[Vector]) -> Vec<Edge> {
    let mut by_ends: HashMap<Ends, Vec<(usize, bool)>> = HashMap::new();
    for (index, interface) in interfaces.iter().enumerate() {
        let Piece::Face(_, edges) = &interface.shape else { continue };
        for &[a, b] in edges {
            if a != b {
                by_ends.entry((a.min(b), a.max(b))).or_default().push((index, a < b));
            }
        }
    }
    split_free(&mut by_ends, vertices);
    let mut edges: Vec<(Ends, Edge)> = by_ends
        .into_iter()
        .map(|(ends, faces)| (ends, edge(interfaces, [vertices[ends.0], vertices[ends.1]], &faces)))
        .collect();
    edges.sort_by_key(|(ends, _)| *ends);
    edges.into_iter().map(|(_, edge)| edge).chain(rims(interfaces)).collect()
}

/// Splits edges of a single face at the ends of others.
fn split_free(by_ends: &mut HashMap<Ends, Vec<(usize, bool)>>, vertices: &[Vector]) {
    let free: Vec<Ends> =
        by_ends.iter().filter(|(_, faces)| faces.len() == 1).map(|(&ends, _)| ends).collect();
    let mut candidates: Vec<usize> = free.iter().flat_map(|&(a, b)| [a, b]).collect();
    candidates.sort_by(|&i, &j| vertices[i].x.total_cmp(&vertices[j].x));
    candidates.dedup();
    for ends in free {
        let on_it = vertices_on(ends, vertices, &candidates);
        if on_it.is_empty() {
            continue;
        }
        let Some(faces) = by_ends.remove(&ends) else { continue };
        let stops: Vec<usize> = [ends.0].into_iter().chain(on_it).chain([ends.1]).collect();
        for pair in stops.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let faces = faces.iter().map(|&(face, forward)| (face, forward == (a < b)));
            by_ends.entry((a.min(b), a.max(b))).or_default().extend(faces);
        }
    }
}

/// Returns the candidates inside an edge, in their order along it. The candidates are sorted by x.
pub(super) fn vertices_on((a, b): Ends, vertices: &[Vector], candidates: &[usize]) -> Vec<usize> {
    let (from, along) = (vertices[a], vertices[b] - vertices[a]);
    let length = along.length();
    let tolerance = 1e-9 * length;
    let (low, high) =
        (vertices[a].x.min(vertices[b].x) - tolerance, vertices[a].x.max(vertices[b].x) + tolerance);
    let first = candidates.partition_point(|&i| vertices[i].x < low);
    let near = candidates[first..].iter().take_while(|&&i| vertices[i].x <= high);
    let position = |i: usize| (1.0 / length / length) * along.dot(vertices[i] - from);
    let mut on_it: Vec<usize> = near
        .copied()
        .filter(|&i| {
            let t = position(i);
            i != a && i != b && t > 0.0 && t < 1.0 && (vertices[i] - from - t * along).length() <= tolerance
        })
        .collect();
    on_it.sort_by(|&i, &j| position(i).total_cmp(&position(j)));
    on_it.dedup();
    on_it
}

fn edge(interfaces: &[Interface], ends: [Vector; 2], faces: &[(usize, bool)]) -> Edge {
    let axis = (ends[1] - ends[0]).unit().unwrap_or_default();
    let into = |interface: usize, forward: bool| match &interfaces[interface].shape {
        Piece::Face(polygon, _) if forward => polygon.normal().cross(axis),
        Piece::Face(polygon, _) => axis.cross(polygon.normal()),
        Piece::Sphere(_) | Piece::Disk(_) | Piece::Quadric(_) => Vector::default(),
    };
    let wing =
        |&(interface, forward): &(usize, bool)| Wing::new(interface, forward, into(interface, forward));
    Edge::new(ends, faces.iter().map(wing).collect())
}
