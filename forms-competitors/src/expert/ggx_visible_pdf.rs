//! The density of visible normals of the GGX distribution: E. Heitz, Sampling the GGX Distribution
//! of Visible Normals, JCGT 7 (2018). With D(h) = α²/(π (h_x² + h_y² + α² h_z²)²) for a unit vector
//! h and G₁(w) = 2 w_z/(w_z + √(w_z² + α²(w_x² + w_y²))) it is G₁(w) max(0, w·h) D(h)/w_z; w_z
//! cancels, and one division remains.

use super::vector::Vector;
use super::{batch, dot};

/// Columns: α, w, h.
#[inline(always)]
fn value<V: Vector>([alpha, wx, wy, wz, hx, hy, hz]: [V; 7]) -> V {
    let aa = alpha * alpha;
    let spread = wx.mul_add(wx, wy * wy);
    let masked = wz + aa.mul_add(spread, wz * wz).sqrt();
    let slope = hx.mul_add(hx, hy.mul_add(hy, aa * hz * hz));
    let facing = dot([wx, wy, wz], [hx, hy, hz]).max(V::splat(0.0));
    V::splat(2.0 * std::f64::consts::FRAC_1_PI) * aa * facing / (masked * slope * slope)
}

batch::batch!(pdf, 7, super::value);
