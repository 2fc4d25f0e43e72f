//! Frames: extends an axis to an orthonormal frame whose third vector is the axis.

use crate::geometry::Vector;

/// A right-handed orthonormal frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    along: Vector,
    across: Vector,
    axis: Vector,
}

impl Frame {
    /// Returns the frame about a unit vector. Source: T. Duff et al., Building an orthonormal
    /// basis, revisited (2017).
    pub(crate) fn about(axis: Vector) -> Self {
        let sign = 1_f64.copysign(axis.z);
        let a = -1.0 / (sign + axis.z);
        let b = axis.x * axis.y * a;
        let along = Vector::new(1.0 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x);
        let across = Vector::new(b, sign + axis.y * axis.y * a, -axis.y);
        Self { along, across, axis }
    }

    /// Returns the coordinates of a vector in the frame.
    pub(crate) fn coordinates(self, vector: Vector) -> [f64; 3] {
        [self.along, self.across, self.axis].map(|axis| axis.dot(vector))
    }

    /// Returns the vector with these coordinates in the frame.
    pub(crate) fn place(self, [x, y, z]: [f64; 3]) -> Vector {
        x * self.along + y * self.across + z * self.axis
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frame_is_orthonormal_and_right_handed() {
        for axis in [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.6, 0.0, -0.8], [1.0, 0.0, 0.0], [-0.48, 0.6, 0.64]]
        {
            let axis = Vector::new(axis[0], axis[1], axis[2]);
            let Frame { along, across, .. } = Frame::about(axis);
            assert!((along.cross(across) - axis).length() < 1e-15, "{axis:?}");
            assert!(
                (along.length() - 1.0).abs() < 1e-15 && (across.length() - 1.0).abs() < 1e-15,
                "{axis:?}"
            );
        }
    }
}
