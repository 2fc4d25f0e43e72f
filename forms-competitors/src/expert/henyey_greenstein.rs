//! The phase function of L. G. Henyey and J. L. Greenstein, Diffuse Radiation in the Galaxy (1941),
//! with the mean cosine g: (1 − g²)/(4π (1 + g² − 2g cos θ)^(3/2)), and its inversion. With s = 2u
//! − 1 and q = 1 + gs the inversion is usually written (1 + g² − ((1 − g²)/q)²)/(2g). Divided by g
//! as polynomials it is (s(1 + g²) + g(s² + 3 + g²(s² − 1))/2)/q², which has no singularity at g =
//! 0 and one division.

use super::batch;
use super::vector::Vector;

/// Columns: g, cos θ.
#[inline(always)]
fn density<V: Vector>([g, cosine]: [V; 2]) -> V {
    let one = V::splat(1.0);
    let squared = g.mul_add(g, one) - (g + g) * cosine;
    let weight = V::splat(0.25 * std::f64::consts::FRAC_1_PI) * (-g).mul_add(g, one);
    weight / (squared * squared.sqrt())
}

/// Columns: g, u.
#[inline(always)]
fn cosine<V: Vector>([g, u]: [V; 2]) -> V {
    let one = V::splat(1.0);
    let s = u.mul_add(V::splat(2.0), -one);
    let q = g.mul_add(s, one);
    let (gg, ss) = (g * g, s * s);
    let odd = gg.mul_add(ss - one, ss + V::splat(3.0));
    let numerator = (V::splat(0.5) * g).mul_add(odd, s.mul_add(gg, s));
    numerator / (q * q)
}

batch::batch!(pdf, 2, super::density);
batch::batch!(sample, 2, super::cosine);
