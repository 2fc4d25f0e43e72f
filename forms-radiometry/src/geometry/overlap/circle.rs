//! Intersection areas of a circle with convex polygons and with circles, in closed form.

use crate::geometry::round::across;
use crate::geometry::{Disk, Vector, edges};
use std::f64::consts::PI;

/// Returns the area of the part of convex pieces, in the plane of a disk, that lies in the disk.
pub(super) fn area_in_pieces(disk: &Disk, pieces: &[Vec<Vector>]) -> f64 {
    let [u, v] = across(disk.normal);
    let place = |&vertex: &Vector| {
        let way = vertex - disk.center;
        [u.dot(way), v.dot(way)]
    };
    let of_piece = |piece: &Vec<Vector>| {
        let of_edge = |[a, b]: [Vector; 2]| along_edge(place(&a), place(&b), disk.radius);
        edges(piece).map(of_edge).sum::<f64>().abs()
    };
    pieces.iter().map(of_piece).sum()
}

/// Returns the signed area, within the circle, of the triangle between the centre of the circle and
/// an edge: a triangle under the part of the edge inside, and sectors on both sides of it.
///
/// The edge a + t (b − a) enters and leaves where |a|² + 2t a·(b − a) + t² |b − a|² = r².
fn along_edge(a: [f64; 2], b: [f64; 2], radius: f64) -> f64 {
    let way = [b[0] - a[0], b[1] - a[1]];
    let squared = dot(way, way);
    let half = dot(a, way) / squared;
    let root = half * half - (dot(a, a) - radius * radius) / squared;
    let sector = |a: [f64; 2], b: [f64; 2]| 0.5 * radius * radius * cross(a, b).atan2(dot(a, b));
    if root.is_nan() || root <= 0.0 {
        return sector(a, b);
    }
    let [enters, leaves] = [-half - root.sqrt(), -half + root.sqrt()].map(|t| t.clamp(0.0, 1.0));
    let [p, q] = [enters, leaves].map(|t| [a[0] + t * way[0], a[1] + t * way[1]]);
    if enters == leaves {
        return sector(a, b);
    }
    sector(a, p) + 0.5 * cross(p, q) + sector(q, b)
}

/// Returns the area of the lens in which two disks in one plane overlap.
///
/// r²(α − sin α cos α) + s²(β − sin β cos β), with α and β half the angles that the common chord
/// subtends.
pub(super) fn area_in_disk(a: &Disk, b: &Disk) -> f64 {
    let distance = (a.center - b.center).length();
    let (r, s) = (a.radius, b.radius);
    if distance >= r + s {
        return 0.0;
    }
    if distance <= (r - s).abs() {
        return PI * r.min(s) * r.min(s);
    }
    let segment = |r: f64, s: f64| {
        let cosine = ((distance * distance + r * r - s * s) / (2.0 * distance * r)).clamp(-1.0, 1.0);
        let angle = cosine.acos();
        r * r * (angle - angle.sin() * cosine)
    };
    segment(r, s) + segment(s, r)
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
