//! Cameras: map points of the film to viewing rays. A pinhole camera also maps directions back to
//! points of the film; the rays of an orthographic camera are parallel.

use crate::geometry::Vector;

/// The largest width or height of a picture, in pixels.
pub(crate) const MAXIMAL_RESOLUTION: usize = 8192;

/// A pinhole camera, or an orthographic camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// Position of the pinhole, or of the centre of the picture of an orthographic camera.
    pub origin: Vector,
    /// Width and height of the picture in pixels.
    pub resolution: [usize; 2],
    /// Unit vector along the optical axis.
    forward: Vector,
    /// Vector from the centre of the picture to the centre of its right border, at unit distance
    /// along the optical axis.
    right: Vector,
    /// Vector from the centre of the picture to the centre of its upper border, at the same
    /// distance.
    up: Vector,
    is_orthographic: bool,
}

impl Camera {
    /// Creates the camera at `origin` that looks at `target`, with `up` upright in the picture and
    /// a vertical field of view of `fov` degrees. Returns `None` if target and origin coincide, if
    /// `up` is parallel to the optical axis, or if the field of view is not between 0 and 180
    /// degrees.
    pub fn new(origin: Vector, target: Vector, up: Vector, fov: f64, resolution: [usize; 2]) -> Option<Self> {
        Self::looking(origin, target - origin, up, fov, resolution)
    }

    /// Creates the same camera from its viewing direction, a vector of any length.
    pub fn looking(
        origin: Vector,
        direction: Vector,
        up: Vector,
        fov: f64,
        resolution: [usize; 2],
    ) -> Option<Self> {
        let half_height = (0.5 * fov.to_radians()).tan();
        let is_valid = fov > 0.0 && fov < 180.0;
        is_valid.then(|| Self::framed(origin, [direction, up], half_height, resolution)).flatten()
    }

    /// Creates the orthographic camera with this position of the centre of the picture and this
    /// viewing direction, with `up` upright, whose picture shows this width. Returns `None` if the
    /// width is not above zero, or if the orientation is undefined.
    pub fn orthographic(
        origin: Vector,
        direction: Vector,
        up: Vector,
        width: f64,
        resolution: [usize; 2],
    ) -> Option<Self> {
        let half_height = 0.5 * width * resolution[1] as f64 / resolution[0] as f64;
        let is_valid = half_height > 0.0 && half_height.is_finite();
        let camera = is_valid.then(|| Self::framed(origin, [direction, up], half_height, resolution));
        camera.flatten().map(|camera| Self { is_orthographic: true, ..camera })
    }

    fn framed(
        origin: Vector,
        [direction, up]: [Vector; 2],
        half_height: f64,
        resolution: [usize; 2],
    ) -> Option<Self> {
        let forward = direction.unit()?;
        let right = forward.cross(up.unit()?);
        let right = right.unit().filter(|_| right.length() > 1e-9 && !resolution.contains(&0))?;
        let half_width = half_height * resolution[0] as f64 / resolution[1] as f64;
        let up = half_height * right.cross(forward);
        Some(Self { origin, resolution, forward, right: half_width * right, up, is_orthographic: false })
    }

    /// Whether all viewing rays are parallel.
    pub fn is_orthographic(&self) -> bool {
        self.is_orthographic
    }

    /// Returns the camera with all lengths multiplied by this factor.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let film = if self.is_orthographic { factor } else { 1.0 };
        Self { origin: factor * self.origin, right: film * self.right, up: film * self.up, ..self.clone() }
    }

    /// Returns the origin and the direction, not normalized, of the viewing ray of the film point
    /// (x, y).
    pub fn ray(&self, x: f64, y: f64) -> [Vector; 2] {
        let direction = self.direction(x, y);
        match self.is_orthographic {
            true => [self.origin + (direction - self.forward), self.forward],
            false => [self.origin, direction],
        }
    }

    /// Returns the viewing direction of a pinhole, not normalized, of the film point (x, y). x runs from 0 at
    /// the left border to the width at the right border, y from 0 at the upper border to the height
    /// at the lower border.
    pub fn direction(&self, x: f64, y: f64) -> Vector {
        let [width, height] = self.resolution.map(|side| side as f64);
        self.forward + (2.0 * x / width - 1.0) * self.right + (1.0 - 2.0 * y / height) * self.up
    }

    /// Returns the film point onto which a point in front of the pinhole projects; `way` is the
    /// vector from the pinhole to that point. Inverse of [`direction`](Self::direction).
    pub(crate) fn film(&self, way: Vector) -> [f64; 2] {
        let depth = way.dot(self.forward);
        let along = |axis: Vector| way.dot(axis) / (axis.dot(axis) * depth);
        let [width, height] = self.resolution.map(|side| side as f64);
        [0.5 * width * (1.0 + along(self.right)), 0.5 * height * (1.0 - along(self.up))]
    }

    /// Returns the normals of the four planes through the pinhole and the borders of the film. They
    /// point into the view frustum.
    pub(crate) fn sides(&self) -> [Vector; 4] {
        let [right, up] = [self.right, self.up].map(|axis| (1.0 / axis.dot(axis)) * axis);
        [self.forward + right, self.forward - right, self.forward + up, self.forward - up]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_corners_of_the_film_lie_at_the_field_of_view() {
        let (origin, target, up) =
            (Vector::new(1.0, 2.0, 3.0), Vector::new(1.0, 2.0, 8.0), Vector::new(0.0, 1.0, 1.0));
        let camera = Camera::new(origin, target, up, 90.0, [200, 100]).unwrap();
        let cases = [
            ("middle", (100.0, 50.0), Vector::new(0.0, 0.0, 1.0)),
            ("upper left", (0.0, 0.0), Vector::new(2.0, 1.0, 1.0)),
            ("lower right", (200.0, 100.0), Vector::new(-2.0, -1.0, 1.0)),
        ];
        for (name, (x, y), expected) in cases {
            assert!((camera.direction(x, y) - expected).length() < 1e-15, "{name}");
        }
    }

    #[test]
    fn a_point_is_seen_where_the_film_looks_and_between_the_sides() {
        let (origin, target, up) =
            (Vector::new(1.0, 2.0, 3.0), Vector::new(-2.0, 5.0, 8.0), Vector::new(0.0, 1.0, 0.2));
        let camera = Camera::new(origin, target, up, 75.0, [200, 100]).unwrap();
        for (x, y, is_on_film) in [
            (0.1, 0.1, true),
            (30.0, 77.0, true),
            (199.9, 99.9, true),
            (-1.0, 50.0, false),
            (7.0, 101.0, false),
        ] {
            let way = 3.7 * camera.direction(x, y);
            let [u, v] = camera.film(way);
            assert!((u - x).abs().max((v - y).abs()) < 1e-12, "({x}, {y})");
            assert_eq!(camera.sides().iter().all(|side| side.dot(way) > 0.0), is_on_film, "({x}, {y})");
        }
    }

    #[test]
    fn the_rays_of_an_orthographic_camera_are_parallel_and_as_far_apart_as_its_width() {
        let [o, z, y] = [Vector::new(1.0, 2.0, 3.0), Vector::new(0.0, 0.0, 5.0), Vector::new(0.0, 1.0, 0.0)];
        let camera = Camera::orthographic(o, z, y, 8.0, [200, 100]).unwrap().scaled(0.5);
        let [left, right] = [camera.ray(0.0, 0.0), camera.ray(200.0, 100.0)];
        assert_eq!((left[1], right[1]), (Vector::new(0.0, 0.0, 1.0), Vector::new(0.0, 0.0, 1.0)));
        assert!((left[0] - Vector::new(2.5, 2.0, 1.5)).length() < 1e-15, "{left:?}");
        assert!((right[0] - Vector::new(-1.5, 0.0, 1.5)).length() < 1e-15, "{right:?}");
        assert!(Camera::orthographic(o, z, y, 0.0, [4, 4]).is_none());
    }

    #[test]
    fn a_camera_without_direction_or_upright_is_none() {
        let (o, z) = (Vector::default(), Vector::new(0.0, 0.0, 1.0));
        for (name, target, up, fov) in [
            ("target at the origin", o, z, 40.0),
            ("up along the line of sight", z, z, 40.0),
            ("no upright", z, o, 40.0),
            ("no field of view", z, Vector::new(0.0, 1.0, 0.0), 0.0),
        ] {
            assert!(Camera::new(o, target, up, fov, [4, 4]).is_none(), "{name}");
        }
    }
}
