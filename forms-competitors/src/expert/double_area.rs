//! The integrand of the form factor between two surfaces, over both of their areas: cos θ₁ cos
//! θ₂/(π r²) of two points with unit normals (Howell, Mengüç, Daun and Siegel, Thermal Radiation
//! Heat Transfer, chapter 4). With d = y − x it is −(n·d)(m·d)/(π (d·d)²), which needs no square
//! root.

use super::vector::Vector;
use super::{batch, difference, dot};

/// Columns: x, its normal n, y, its normal m, three coordinates each.
#[inline(always)]
fn value<V: Vector>(arguments: [V; 12]) -> V {
    let [x0, x1, x2, n0, n1, n2, y0, y1, y2, m0, m1, m2] = arguments;
    let d = difference([y0, y1, y2], [x0, x1, x2]);
    let squared = dot(d, d);
    let cosines = dot([n0, n1, n2], d) * dot([m0, m1, m2], d);
    cosines / (V::splat(-std::f64::consts::PI) * squared * squared)
}

batch::batch!(integrand, 12, super::value);
