//! Vectors of space, for drawings.

/// Point or vector.
pub type Vector = [f64; 3];

/// Returns a + b.
pub fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Returns c a.
pub fn scaled(c: f64, a: Vector) -> Vector {
    a.map(|component| c * component)
}

/// Returns a₁b₁ + a₂b₂ + a₃b₃.
pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns (a₂b₃ − a₃b₂, a₃b₁ − a₁b₃, a₁b₂ − a₂b₁).
pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Returns a/|a|.
pub fn unit(a: Vector) -> Vector {
    scaled(1.0 / dot(a, a).sqrt(), a)
}

/// Returns the corners, in order, of the parallelogram spanned by a and b.
pub fn parallelogram(corner: Vector, a: Vector, b: Vector) -> [Vector; 4] {
    [corner, add(corner, a), add(add(corner, a), b), add(corner, b)]
}
