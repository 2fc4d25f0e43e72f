//! Integrates over a hemisphere with points of a warp, whose density is proved to equal its
//! pullback.
//!
//! ```text
//! u, v ─ cosine_hemisphere_sample ─▶ direction ─ f/cosine_hemisphere_pdf ─▶ mean = ∫ f dω
//! ```
//! `cargo run --release --example sampling`. The exact integrals are known and are printed next to
//! the estimates.

use forms_kernels::{cosine_hemisphere_pdf, cosine_hemisphere_sample};
use std::f64::consts::PI;

/// Function of directions.
type Integrand = fn([f64; 3]) -> f64;

/// Number of points along each side of the unit square.
const SIDE: u32 = 512;

/// Computes ∫ f(ω) dω over the hemisphere about +z by the midpoint rule on a grid.
fn integral(f: impl Fn([f64; 3]) -> f64) -> f64 {
    let middle = |i: u32| (f64::from(i) + 0.5) / f64::from(SIDE);
    let points = (0..SIDE).flat_map(|i| (0..SIDE).map(move |j| (middle(i), middle(j))));
    let value = |(u, v)| {
        let [x, y, z] = cosine_hemisphere_sample(u, v);
        f([x, y, z]) / cosine_hemisphere_pdf(x, y, z)
    };
    points.map(value).sum::<f64>() / f64::from(SIDE * SIDE)
}

fn main() {
    let cases: [(&str, f64, Integrand); 3] = [
        ("cos θ", PI, |[_, _, z]| z),
        ("cos³ θ", PI / 2.0, |[_, _, z]| z * z * z),
        ("sin² θ cos² φ", 2.0 * PI / 3.0, |[x, _, _]| x * x),
    ];
    println!("{:16}{:>12}{:>12}{:>10}", "integrand", "found", "known", "error");
    for (name, known, f) in cases {
        let found = integral(f);
        println!("{name:16}{found:12.7}{known:12.7}{:10.0e}", (found / known - 1.0).abs());
    }
}
