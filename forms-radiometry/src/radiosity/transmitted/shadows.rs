//! Shadows: the parts of a ray that faces leave in the light of a point light.
//!
//! ```text
//! ray, light, face ─▶ the interval of the ray behind the face ─▶ the rest of the ray, in segments
//! ```
//! A convex face hides the light from the points that are in its cone and beyond its plane. The
//! cone and the far side of the plane are intersections of half-spaces, and each half-space
//! contains a half line of the ray.

use crate::geometry::Vector;
use crate::visibility::Face;

/// Returns the segments of a ray, up to an end, from which a light is visible past faces. A light
/// that is closer to the plane of a face than the resolution sees the face edge-on.
pub(super) fn lit(
    [origin, direction]: [Vector; 2],
    end: f64,
    light: Vector,
    faces: &[Face],
    resolution: f64,
) -> Vec<[f64; 2]> {
    let mut segments = vec![[0.0, end]];
    for face in faces.iter().filter(|face| !face.is_back) {
        let Some([from, to]) = shadow([origin, direction], light, face, resolution) else { continue };
        let left = |[start, end]: [f64; 2]| [[start, end.min(from)], [start.max(to), end]];
        segments = segments.into_iter().flat_map(left).filter(|[start, end]| start < end).collect();
    }
    segments
}

/// Returns the interval of a ray from which a face hides a light.
fn shadow([origin, direction]: [Vector; 2], light: Vector, face: &Face, resolution: f64) -> Option<[f64; 2]> {
    let corners = &face.vertices;
    let height = face.normal.dot(light - corners[0]);
    if height.abs() <= resolution {
        return None;
    }
    let beyond = -height.signum() * face.normal;
    let middle = corners.iter().fold(Vector::default(), |sum, &corner| sum + (corner - light));
    let next = corners[1..].iter().chain(&corners[..1]);
    let sides = corners.iter().zip(next).map(|(&a, &b)| {
        let side = (a - light).cross(b - light);
        (light, if side.dot(middle) < 0.0 { -side } else { side })
    });
    let mut interval = [0.0, f64::INFINITY];
    for (point, inward) in sides.chain([(corners[0], beyond)]) {
        let (start, slope) = (inward.dot(origin - point), inward.dot(direction));
        let crossing = -start / slope;
        match slope {
            _ if slope > 0.0 => interval[0] = f64::max(interval[0], crossing),
            _ if slope < 0.0 => interval[1] = f64::min(interval[1], crossing),
            _ if start <= 0.0 => return None,
            _ => {}
        }
    }
    (interval[0] < interval[1]).then_some(interval)
}
