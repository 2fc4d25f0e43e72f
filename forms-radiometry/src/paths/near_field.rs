//! Near field: points from which a light source fills a large part of all directions, so that path
//! sampling finds its light.
//!
//! ```text
//! flat     it contains a disk about the foot of the point's perpendicular, whose radius is at
//!          least the point's height: (1 − 1/√2)/2 = 0.146 of all directions, or more, lead to it
//! sphere, quadric of revolution   the point is inside
//! ```
//! From such points the light source is not sampled by next-event estimation: a direction to it
//! costs more than it adds to the light that directions sampled by the law of a vertex find. Any
//! rule would do, as long as it always gives the same result for the same point, since the MIS
//! weights depend on it.

use crate::geometry::{Disk, Quadric, Sphere, Vector};
use crate::visibility::Wall;

/// The points near a light source.
pub(crate) enum Near {
    /// A point of the plane and its unit normal; for each edge, a point of it and the unit normal
    /// in the plane that points inwards.
    Polygon {
        plane: [Vector; 2],
        edges: Vec<[Vector; 2]>,
    },
    Disk(Disk),
    Sphere(Sphere),
    Quadric(Quadric),
}

impl Near {
    pub(crate) fn of(wall: &Wall) -> Self {
        match wall {
            Wall::Polygon { vertices, normal } => {
                let nexts = vertices.iter().cycle().skip(1);
                let edge = |(&from, &to): (&Vector, &Vector)| Some([from, normal.cross(to - from).unit()?]);
                let edges = vertices.iter().zip(nexts).filter_map(edge).collect();
                Self::Polygon { plane: [vertices[0], *normal], edges }
            }
            Wall::Disk(disk) => Self::Disk(*disk),
            Wall::Sphere(sphere) => Self::Sphere(*sphere),
            Wall::Quadric(quadric) => Self::Quadric(*quadric),
        }
    }

    /// Whether a point is near.
    pub(crate) fn holds(&self, point: Vector) -> bool {
        match self {
            Self::Polygon { plane: [origin, normal], edges } => {
                let height = (point - *origin).dot(*normal).abs();
                edges.iter().all(|[from, inwards]| (point - *from).dot(*inwards) >= height)
            }
            Self::Disk(Disk { center, normal, radius, hole }) => {
                let offset = point - *center;
                let height = offset.dot(*normal).abs();
                let (left, squared) = (radius - height, offset.dot(offset) - height * height);
                let is_off_hole = *hole == 0.0 || squared >= (hole + height).powi(2);
                left >= 0.0 && squared <= left * left && is_off_hole
            }
            Self::Quadric(quadric) => quadric.holds(point),
            Self::Sphere(Sphere { center, radius, .. }) => {
                let offset = point - *center;
                offset.dot(offset) < radius * radius
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UP: Vector = Vector::new(0.0, 0.0, 1.0);

    fn rectangle(x: f64, y: f64) -> Near {
        let corners = [[-x, -y], [x, -y], [x, y], [-x, y]];
        Near::of(&Wall::Polygon {
            vertices: corners.map(|[x, y]| Vector::new(x, y, 0.0)).as_slice().into(),
            normal: UP,
        })
    }

    #[test]
    fn points_are_near_where_a_disk_as_wide_as_their_height_fits_in() {
        let disk =
            Near::of(&Wall::Disk(Disk { center: Vector::default(), normal: UP, radius: 1.0, hole: 0.0 }));
        let cases = [
            ([0.0, 0.0, 0.99], true),
            ([0.0, 0.0, -0.99], true),
            ([0.0, 0.0, 1.01], false),
            ([0.6, 0.0, 0.39], true),
            ([0.6, 0.0, 0.41], false),
            ([0.99, 0.0, 0.0], true),
            ([1.01, 0.0, 0.0], false),
            ([1.5, 0.0, 0.1], false),
        ];
        for ([x, y, z], is_near) in cases {
            let point = Vector::new(x, y, z);
            assert_eq!([rectangle(1.0, 1.0).holds(point), disk.holds(point)], [is_near; 2], "{point:?}");
        }
    }

    #[test]
    fn few_points_are_near_a_narrow_strip() {
        let near =
            [0.005, 0.1, 10.0].map(|height| rectangle(50.0, 0.01).holds(Vector::new(3.0, 0.0, height)));
        assert_eq!(near, [true, false, false]);
    }

    #[test]
    fn points_are_near_a_sphere_inside_only() {
        let sphere = Near::of(&Wall::Sphere(Sphere { center: UP, radius: 1.0, inward: false }));
        assert_eq!([0.1, -0.1].map(|z| sphere.holds(Vector::new(0.0, 0.0, z))), [true, false]);
    }
}
