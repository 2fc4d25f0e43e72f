//! Shapes of rows: lights and the surfaces that they illuminate, as texts of scenes.

use super::Posed;
use forms_radiometry::simulation::Quantity::{FluenceRate, Irradiance};
use forms_testing::scene_text::elements::{disk, probe, sphere};
use forms_testing::scene_text::{Point, material, point_receiver, polygon, surface, surface_receiver};

/// Shape that emits light, or that is illuminated. Disks face down unless they are of the kind that
/// faces up.
pub(super) enum Light {
    Polygon(Vec<Point>),
    Disk(Point, f64),
    DiskUp(Point, f64),
    Sphere(Point, f64),
}

impl Light {
    fn shape(&self) -> String {
        match self {
            Self::Polygon(corners) => polygon(corners),
            Self::Disk(center, radius) => disk(*center, [0.0, 0.0, -1.0], *radius),
            Self::DiskUp(center, radius) => disk(*center, [0.0, 0.0, 1.0], *radius),
            Self::Sphere(center, radius) => sphere(*center, *radius, false),
        }
    }

    fn table(&self, emitted: &str) -> String {
        material("black", 0) + &surface("light", "black", &format!("{}\n{emitted}", self.shape()))
    }

    /// Returns the scene of its solid angle at a point: the fluence rate of a radiance of 1.
    pub(super) fn seen(&self, from: Point) -> Posed {
        let text = self.table("radiance = 1") + &probe("here", from);
        Posed { text, quantity: FluenceRate, factor: 1.0 }
    }

    /// Returns the scene of its form factor at a point: the irradiance of an exitance of 1.
    pub(super) fn received(&self, at: Point, normal: Point) -> Posed {
        let text = self.table("exitance = 1") + &point_receiver("here", at, normal);
        Posed { text, quantity: Irradiance, factor: 1.0 }
    }

    /// Returns the scene of the mean irradiance of another surface by an exitance of 1, times a
    /// factor.
    pub(super) fn onto(&self, other: &Self, factor: f64) -> Posed {
        let text = self.table("exitance = 1")
            + &surface("here", "black", &other.shape())
            + &surface_receiver("here");
        Posed { text, quantity: Irradiance, factor }
    }
}

/// Returns a horizontal rectangle with a corner on the axis z.
pub(super) fn rectangle([a, b]: [f64; 2], height: f64, is_up: bool) -> Vec<Point> {
    let mut corners = vec![[0.0, 0.0, height], [a, 0.0, height], [a, b, height], [0.0, b, height]];
    if !is_up {
        corners.reverse();
    }
    corners
}

/// Returns a rectangle above the axis y that faces along x.
pub(super) fn upright(length: f64, height: f64) -> Vec<Point> {
    vec![[0.0; 3], [0.0, length, 0.0], [0.0, length, height], [0.0, 0.0, height]]
}

/// Returns the sum of points, if all its coordinates are exact in `f64`.
pub(super) fn sum(a: Point, b: Point) -> Option<Point> {
    let sum = [0, 1, 2].map(|axis| a[axis] + b[axis]);
    let is_exact = |axis: usize| {
        let (a, b, sum) = (a[axis], b[axis], sum[axis]);
        let rounded = sum - a;
        (a - (sum - rounded)) + (b - rounded) == 0.0
    };
    (0..3).all(is_exact).then_some(sum)
}

pub(super) fn middle(corners: &[Point]) -> Point {
    [0, 1, 2].map(|axis| corners.iter().map(|corner| corner[axis]).sum::<f64>() / corners.len() as f64)
}

/// Returns the polygon oriented so that a point sees its front, if the point sees more than an
/// edge.
pub(super) fn facing(mut corners: Vec<Point>, point: Point) -> Option<Vec<Point>> {
    let relative: Vec<Point> =
        corners.iter().map(|corner| [0, 1, 2].map(|axis| corner[axis] - point[axis])).collect();
    let largest = relative.iter().flatten().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let [a, b, c] = [0, 1, 2].map(|index| relative[index].map(|x| x / largest));
    let cross = |b: Point, c: Point| {
        [0, 1, 2].map(|i| b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3])
    };
    let from_a = |other: Point| [0, 1, 2].map(|axis| other[axis] - a[axis]);
    // a · (b × c) is positive where the point is behind
    let volume: f64 = a.iter().zip(cross(from_a(b), from_a(c))).map(|(a, normal)| a * normal).sum();
    if volume > 0.0 {
        corners.reverse();
    }
    (volume != 0.0).then_some(corners)
}
