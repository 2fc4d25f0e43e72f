//! Vectors of three-dimensional Euclidean space; a point is its vector from the origin.

use std::ops::{Add, Mul, Neg, Sub};

/// A vector, or a point as its vector from the origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vector {
    /// First coordinate.
    pub x: f64,
    /// Second coordinate.
    pub y: f64,
    /// Third coordinate.
    pub z: f64,
}

/// Mask of the exponent bits of a number. Applied to a number, it leaves the greatest power of two
/// that is not larger.
const EXPONENT: u64 = 0x7ff0_0000_0000_0000;

impl Vector {
    /// Creates the vector (x, y, z).
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    /// u·v.
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// u × v. Antisymmetric to the last bit: `u.cross(v) == -v.cross(u)`.
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// Reflects a direction at a plane with this unit normal: d − 2 (d·n) n.
    pub(crate) fn mirrored(self, normal: Self) -> Self {
        self - (2.0 * normal.dot(self)) * normal
    }

    /// Returns the mean of points.
    pub(crate) fn mean(points: &[Self]) -> Self {
        let sum = points.iter().fold(Self::default(), |sum, &point| sum + point);
        (1.0 / points.len() as f64) * sum
    }

    /// Returns the coordinates in order.
    pub(crate) fn coordinates(self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }

    /// Returns the largest absolute value of a coordinate; NaN if a coordinate is NaN.
    pub(crate) fn largest(self) -> f64 {
        largest([self.x, self.y, self.z].into_iter().map(f64::abs))
    }

    /// |v|, without intermediate overflow or underflow.
    pub fn length(self) -> f64 {
        let scale = self.largest();
        if scale == 0.0 || !scale.is_finite() {
            return scale;
        }
        let v = Self::new(self.x / scale, self.y / scale, self.z / scale);
        scale * v.dot(v).sqrt()
    }

    /// v/|v|, or `None` if v is zero or a coordinate is not finite.
    pub fn unit(self) -> Option<Self> {
        let scale = self.largest();
        if scale == 0.0 || !scale.is_finite() {
            return None;
        }
        // scaling by a power of two rounds nothing: each coordinate is rounded once
        let scale = f64::from_bits(scale.to_bits() & EXPONENT).max(f64::MIN_POSITIVE);
        let v = Self::new(self.x / scale, self.y / scale, self.z / scale);
        let length = v.dot(v).sqrt();
        Some(Self::new(v.x / length, v.y / length, v.z / length))
    }
}

/// Returns the largest of some lengths; 0 if there are none, NaN if one is NaN.
pub(crate) fn largest(lengths: impl Iterator<Item = f64>) -> f64 {
    lengths.fold(0.0, |m, length| if length > m || length.is_nan() { length } else { m })
}

impl Add for Vector {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl Sub for Vector {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl Neg for Vector {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl Mul<Vector> for f64 {
    type Output = Vector;
    fn mul(self, v: Vector) -> Vector {
        Vector::new(self * v.x, self * v.y, self * v.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vector_with_a_nan_has_no_direction_and_a_nan_as_length() {
        for place in 0..3 {
            let mut coordinates = [1.0, 2.0, 3.0];
            coordinates[place] = f64::NAN;
            let [x, y, z] = coordinates;
            assert!(Vector::new(x, y, z).length().is_nan());
            assert_eq!(Vector::new(x, y, z).unit(), None);
        }
    }
}
