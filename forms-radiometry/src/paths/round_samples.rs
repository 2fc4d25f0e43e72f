//! Points of a uniform distribution over the area of round shapes, by points of the unit square.

use super::warps::{uniform_disk_sample, uniform_sphere_sample};
use crate::geometry::{Disk, Sphere, Vector};
use crate::sampling::Frame;

impl Disk {
    /// Returns a point, and the unit normal.
    pub(crate) fn sample(&self, [u, v]: [f64; 2]) -> (Vector, Vector) {
        if self.is_annulus() {
            return (self.point([u, v]), self.normal);
        }
        let [x, y] = uniform_disk_sample(u, v);
        (self.center + self.radius * Frame::about(self.normal).place([x, y, 0.0]), self.normal)
    }
}

impl Sphere {
    /// Returns a point, and the unit normal of the front there.
    pub(crate) fn sample(&self, [u, v]: [f64; 2]) -> (Vector, Vector) {
        let [x, y, z] = uniform_sphere_sample(u, v);
        let outward = Vector::new(x, y, z);
        (self.center + self.radius * outward, if self.inward { -outward } else { outward })
    }
}
