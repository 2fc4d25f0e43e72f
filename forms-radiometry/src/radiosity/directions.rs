//! Directions: points of the unit square become directions above a plane, by a warp of the library.

use super::transport::Transport;
use crate::geometry::Vector;
use crate::sampling::{Frame, Net};
use forms_kernels::cosine_hemisphere_sample;

/// Returns a direction above a plane, with a density proportional to its cosine with the unit
/// normal.
pub(super) fn above(normal: Vector, [u, v]: [f64; 2]) -> Vector {
    Frame::about(normal).place(cosine_hemisphere_sample(u, v))
}

impl Transport {
    /// Returns the faces that rays from a point above a plane hit, or `None` for rays that hit
    /// nothing. The density of the rays is proportional to their cosine.
    pub(crate) fn faces_above(
        &self,
        position: Vector,
        normal: Vector,
        rays: u32,
        key: u64,
    ) -> impl Iterator<Item = Option<usize>> {
        let net = Net::new(key);
        let face = move |ray| self.screens.first(position, above(normal, net.point(ray))).map(|hit| hit.face);
        (0..rays).map(face)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_above_a_plane_have_the_mean_cosine_of_lambert() {
        let net = Net::new(3);
        for normal in [[1.0, 2.0, 2.0], [0.0, 0.0, -3.0], [-2.0, 1.0, -2.0]] {
            let normal = (1.0 / 3.0) * Vector::new(normal[0], normal[1], normal[2]);
            let cosines: Vec<f64> =
                (0..4096).map(|index| above(normal, net.point(index)).dot(normal)).collect();
            assert!(cosines.iter().all(|&cosine| cosine > 0.0));
            let mean = cosines.iter().sum::<f64>() / 4096.0;
            assert!((mean - 2.0 / 3.0).abs() < 1e-3, "{mean}");
        }
    }
}
