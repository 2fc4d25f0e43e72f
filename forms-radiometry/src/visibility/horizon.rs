//! Horizon clipping: clips a luminaire at a point's horizon; the result is the convex piece that
//! the point sees without occluders.

use super::Screens;
use super::cone::Cutting;
use crate::geometry::clip::{Pieces, split};
use crate::geometry::{Plane, Vector};

/// Buffers that are reused from receiver to receiver.
#[derive(Clone, Debug, Default)]
pub(crate) struct Workspace {
    /// The luminaire relative to the receiver.
    pub(super) luminaire: Vec<Vector>,
    above: Vec<Vector>,
    below: Vec<Vector>,
    pub(super) visible: Pieces,
    /// Buffers that are only needed with occluders.
    pub(super) cutting: Option<Box<Cutting>>,
}

/// A receiver, and the plane of a luminaire that it faces.
#[derive(Clone, Copy)]
pub(super) struct View {
    pub(super) position: Vector,
    pub(super) horizon: Option<Vector>,
    pub(super) luminaire_normal: Vector,
    /// The distance of the receiver from the luminaire's plane.
    pub(super) height: f64,
}

impl Screens {
    /// Whether some receiver is in front of the luminaire, and some part of the luminaire is above
    /// the receivers' horizon, if there is one. Points within the resolution of a plane count as
    /// lying in it.
    pub(crate) fn face_each_other(
        &self,
        receivers: &[Vector],
        normal: Option<Vector>,
        luminaire: &[Vector],
        luminaire_normal: Vector,
    ) -> bool {
        let is_in_front = |points: &[Vector], point: Vector, normal: Vector| {
            points.iter().any(|&v| Plane { point, normal }.distance(v) > self.resolution)
        };
        is_in_front(receivers, luminaire[0], luminaire_normal)
            && normal.is_none_or(|normal| is_in_front(luminaire, receivers[0], normal))
    }
}

impl Workspace {
    /// Returns the part of a luminaire that a receiver sees without occluders: a convex piece
    /// relative to `position`, above the horizon if there is one. It is empty where the receiver is
    /// behind the luminaire or within the resolution of its plane.
    pub(crate) fn above_horizon(
        &mut self,
        position: Vector,
        horizon: Option<Vector>,
        luminaire: (&[Vector], Vector),
        resolution: f64,
    ) -> &[Vector] {
        self.begin(position, horizon, luminaire, resolution);
        self.visible.last()
    }

    /// Initializes `visible` with that part.
    pub(super) fn begin(
        &mut self,
        position: Vector,
        horizon: Option<Vector>,
        (luminaire, luminaire_normal): (&[Vector], Vector),
        resolution: f64,
    ) -> View {
        let height = luminaire_normal.dot(position - luminaire[0]);
        self.visible.clear();
        if height > resolution {
            self.luminaire.clear();
            self.luminaire.extend(luminaire.iter().map(|&v| v - position));
            match horizon {
                Some(normal) if self.luminaire.iter().any(|&v| normal.dot(v) < 0.0) => {
                    split(&self.luminaire, |x| normal.dot(x), &mut self.above, &mut self.below);
                    if !self.above.is_empty() {
                        self.visible.push(&self.above);
                    }
                }
                _ => self.visible.push(&self.luminaire),
            }
        }
        View { position, horizon, luminaire_normal, height }
    }
}
