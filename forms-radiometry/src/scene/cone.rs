//! Cones of spot lights: the intensity of a point light depends on the angle to an axis.

use crate::geometry::Vector;

/// Dependence of an intensity on the angle to an axis: all of it up to a first angle, linear in the
/// angle from there to a second one, and nothing beyond that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// The unit vector in which the light is aimed.
    pub axis: Vector,
    /// The angle in radians up to which the intensity is the largest.
    pub beam: f64,
    /// The angle in radians from which on the intensity is zero; at least that of the beam.
    pub cutoff: f64,
}

impl Cone {
    /// The fraction of the largest intensity in a direction, a unit vector.
    pub(crate) fn factor(&self, direction: Vector) -> f64 {
        let angle = self.axis.cross(direction).length().atan2(self.axis.dot(direction));
        if angle <= self.beam {
            1.0
        } else if angle < self.cutoff {
            (self.cutoff - angle) / (self.cutoff - self.beam)
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_intensity_falls_linearly_between_both_angles() {
        let cone = Cone { axis: Vector::new(0.0, 0.0, -1.0), beam: 0.2, cutoff: 0.6 };
        for (angle, expected) in [(0.0_f64, 1.0), (0.2, 1.0), (0.3, 0.75), (0.6, 0.0), (2.0, 0.0)] {
            let found = cone.factor(Vector::new(angle.sin(), 0.0, -angle.cos()));
            assert!((found - expected).abs() < 1e-12, "{angle}: {found}");
        }
        let sharp = Cone { cutoff: 0.2, ..cone };
        assert_eq!(sharp.factor(cone.axis), 1.0);
    }
}
