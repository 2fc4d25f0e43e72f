//! Round shapes: centre, radius and side of a sphere or a disk.

use super::Vector;

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre.
    pub center: Vector,
    /// Its radius, above zero.
    pub radius: f64,
    /// Whether its front is the inside.
    pub inward: bool,
}

/// A flat disk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disk {
    /// Its centre.
    pub center: Vector,
    /// The unit normal, which points to the front.
    pub normal: Vector,
    /// Its radius, above zero.
    pub radius: f64,
}
