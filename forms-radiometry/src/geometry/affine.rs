//! Affine maps: translations, rotations, scalings and their compositions.

use super::Vector;

/// Tolerance of angles and lengths where a map must be a rotation with uniform scaling.
const SIMILARITY: f64 = 1e-6;

/// The affine map x ↦ A x + b, by the columns of A and b.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Affine {
    pub(crate) columns: [Vector; 3],
    pub(crate) shift: Vector,
}

impl Affine {
    pub(crate) const IDENTITY: Self = Self {
        columns: [Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 1.0, 0.0), Vector::new(0.0, 0.0, 1.0)],
        shift: Vector::new(0.0, 0.0, 0.0),
    };

    pub(crate) fn point(&self, p: Vector) -> Vector {
        self.vector(p) + self.shift
    }

    pub(crate) fn vector(&self, v: Vector) -> Vector {
        v.x * self.columns[0] + v.y * self.columns[1] + v.z * self.columns[2]
    }

    /// Returns the image of a normal, not normalised: by the inverse transpose of A, times its
    /// determinant.
    pub(crate) fn normal(&self, n: Vector) -> Vector {
        let [a, b, c] = self.columns;
        let image = n.x * b.cross(c) + n.y * c.cross(a) + n.z * a.cross(b);
        if self.mirrors() { -image } else { image }
    }

    /// Returns the composition of this map after another one.
    pub(crate) fn after(&self, first: &Self) -> Self {
        Self { columns: first.columns.map(|column| self.vector(column)), shift: self.point(first.shift) }
    }

    fn determinant(&self) -> f64 {
        self.columns[0].cross(self.columns[1]).dot(self.columns[2])
    }

    /// Whether the map has an inverse.
    pub(crate) fn is_invertible(&self) -> bool {
        self.determinant() != 0.0 && self.determinant().is_finite()
    }

    /// Whether the map reverses orientation.
    pub(crate) fn mirrors(&self) -> bool {
        self.determinant() < 0.0
    }

    /// Returns the scale factor, if the map is a rotation or reflection with uniform scaling. For a
    /// map of the plane z = 0, `axes` is 2.
    pub(crate) fn scale(&self, axes: usize) -> Option<f64> {
        let columns = &self.columns[..axes];
        let scale = columns[0].length();
        let fits = |i: usize, j: usize| {
            let expected = if i == j { 1.0 } else { 0.0 };
            let (u, v) = ((1.0 / scale) * columns[i], (1.0 / scale) * columns[j]);
            (u.dot(v) - expected).abs() <= SIMILARITY
        };
        let is_similar = (0..axes).all(|i| (i..axes).all(|j| fits(i, j)));
        (is_similar && scale.is_finite() && scale > 0.0).then_some(scale)
    }

    /// x ↦ x + b.
    pub(crate) fn translation(shift: Vector) -> Self {
        Self { shift, ..Self::IDENTITY }
    }

    /// x ↦ (a x, b y, c z).
    pub(crate) fn scaling(by: Vector) -> Self {
        let [x, y, z] = Self::IDENTITY.columns;
        Self { columns: [by.x * x, by.y * y, by.z * z], ..Self::IDENTITY }
    }

    /// Rodrigues: x ↦ cos θ x + sin θ (k × x) + (1 − cos θ)(k·x) k, θ in degrees.
    pub(crate) fn rotation(axis: Vector, degrees: f64) -> Self {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let turned = |x: Vector| cos * x + sin * axis.cross(x) + ((1.0 - cos) * axis.dot(x)) * axis;
        Self { columns: Self::IDENTITY.columns.map(turned), ..Self::IDENTITY }
    }

    /// Maps z to the direction of the target, y upright, x = y × z.
    pub(crate) fn look_at(origin: Vector, target: Vector, up: Vector) -> Option<Self> {
        let direction = (target - origin).unit()?;
        let left = up.unit()?.cross(direction);
        let left = left.unit().filter(|_| left.length() > 1e-9)?;
        Some(Self { columns: [left, direction.cross(left), direction], shift: origin })
    }
}
