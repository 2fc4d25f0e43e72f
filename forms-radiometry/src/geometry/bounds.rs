//! Axis-aligned bounding boxes of points.

use super::Vector;

/// An axis-aligned box.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    pub(crate) low: Vector,
    pub(crate) high: Vector,
}

/// Applies a function to both vectors coordinate by coordinate.
fn zipped(a: Vector, b: Vector, of: impl Fn(f64, f64) -> f64) -> Vector {
    Vector::new(of(a.x, b.x), of(a.y, b.y), of(a.z, b.z))
}

impl Bounds {
    /// The empty box.
    pub(crate) const NOTHING: Self = {
        let most = f64::INFINITY;
        Self { low: Vector::new(most, most, most), high: Vector::new(-most, -most, -most) }
    };

    /// Returns the bounding box of points.
    pub(crate) fn of(points: impl Iterator<Item = Vector>) -> Self {
        points.fold(Self::NOTHING, |all, point| all.with(Self { low: point, high: point }))
    }

    /// Returns the bounding box of two boxes.
    pub(crate) fn with(self, other: Self) -> Self {
        Self { low: zipped(self.low, other.low, f64::min), high: zipped(self.high, other.high, f64::max) }
    }

    /// Returns the box extended by this margin on every side.
    pub(crate) fn wider(self, by: f64) -> Self {
        let by = Vector::new(by, by, by);
        Self { low: self.low - by, high: self.high + by }
    }

    /// Returns the longest side.
    pub(crate) fn extent(self) -> f64 {
        (self.high - self.low).largest()
    }

    /// Returns half of the area of the box's sides.
    pub(crate) fn half_surface(self) -> f64 {
        let Vector { x, y, z } = self.high - self.low;
        x * y + y * z + z * x
    }

    /// Returns the largest absolute value of a coordinate in the box.
    pub(crate) fn largest(self) -> f64 {
        self.low.largest().max(self.high.largest())
    }

    /// Whether two boxes have a point in common.
    pub(crate) fn meets(&self, other: &Self) -> bool {
        let Self { low, high } = other;
        self.low.x <= high.x
            && low.x <= self.high.x
            && self.low.y <= high.y
            && low.y <= self.high.y
            && self.low.z <= high.z
            && low.z <= self.high.z
    }

    /// Returns the distance of two boxes.
    pub(crate) fn distance(&self, other: &Self) -> f64 {
        let nothing = Vector::default();
        let [after, before] = [self.low - other.high, other.low - self.high];
        zipped(zipped(after, before, f64::max), nothing, f64::max).length()
    }

    /// Whether a point is in the box.
    pub(crate) fn holds(&self, point: Vector) -> bool {
        self.meets(&Self { low: point, high: point })
    }

    /// Returns the farthest point of the box in a direction.
    pub(crate) fn farthest(&self, direction: Vector) -> Vector {
        let reach = |along: f64, low: f64, high: f64| if along > 0.0 { high } else { low };
        Vector::new(
            reach(direction.x, self.low.x, self.high.x),
            reach(direction.y, self.low.y, self.high.y),
            reach(direction.z, self.low.z, self.high.z),
        )
    }
}
