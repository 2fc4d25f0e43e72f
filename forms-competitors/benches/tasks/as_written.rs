//! The formulas of `tests/stability/applied.forms` in Rust, operation by operation as they are written there.

pub(crate) fn cone_sine(s: f64, u: f64) -> f64 {
    (1.0 - (1.0 - u * (1.0 - (1.0 - s).sqrt())).powi(2)).sqrt()
}

pub(crate) fn linear_sample(a: f64, b: f64, u: f64) -> f64 {
    (((1.0 - u) * a.powi(2) + u * b.powi(2)).sqrt() - a) / (b - a)
}

pub(crate) fn atmosphere(r: f64, mu: f64, top: f64) -> f64 {
    -r * mu + (r.powi(2) * (mu.powi(2) - 1.0) + top.powi(2)).sqrt()
}

pub(crate) fn rotation_coefficient(t: f64) -> f64 {
    (t - t.sin()) / t.powi(3)
}

pub(crate) fn motion_coefficient(t: f64) -> f64 {
    (2.0 * t - 3.0 * t.sin() + t * t.cos()) / (2.0 * t.powi(5))
}

pub(crate) fn angle_of_vectors(ax: f64, ay: f64, az: f64, bx: f64, by: f64, bz: f64) -> f64 {
    let lengths = (ax.powi(2) + ay.powi(2) + az.powi(2)) * (bx.powi(2) + by.powi(2) + bz.powi(2));
    ((ax * bx + ay * by + az * bz) / lengths.sqrt()).acos()
}

pub(crate) fn softplus(x: f64) -> f64 {
    (1.0 + x.exp()).ln()
}

pub(crate) fn sum_of_logarithms(a: f64, b: f64) -> f64 {
    (a.exp() + b.exp()).ln()
}

pub(crate) fn complement_of_logarithm(x: f64) -> f64 {
    (1.0 - (-x).exp()).ln()
}

pub(crate) fn option_price(s: f64, k: f64, t: f64, sigma: f64) -> f64 {
    let normal = |d: f64| 1.0 + libm::erf(d / 2.0_f64.sqrt());
    let [up, down] =
        [1.0, -1.0].map(|sign| ((s / k).ln() + sign * sigma.powi(2) * t / 2.0) / (sigma * t.sqrt()));
    s * normal(up) / 2.0 - k * normal(down) / 2.0
}

#[allow(clippy::too_many_arguments, reason = "the components of three values")]
pub(crate) fn sphere_hit(ox: f64, oy: f64, oz: f64, dx: f64, dy: f64, dz: f64, radius: f64) -> f64 {
    let along = ox * dx + oy * dy + oz * dz;
    let lengths = dx.powi(2) + dy.powi(2) + dz.powi(2);
    let outside = ox.powi(2) + oy.powi(2) + oz.powi(2) - radius.powi(2);
    -along - (along.powi(2) - lengths * outside).sqrt()
}

pub(crate) fn fisheye(x: f64, y: f64, k: f64) -> f64 {
    let radius = (x.powi(2) + y.powi(2)).sqrt();
    radius.atan() * (1.0 + k * radius.atan().powi(2)) / radius * x
}

pub(crate) fn distance(x1: f64, y1: f64, x2: f64, y2: f64) -> f64 {
    ((x1 - x2).powi(2) + (y1 - y2).powi(2)).sqrt()
}

pub(crate) fn logistic(x: f64) -> f64 {
    x.exp() / (1.0 + x.exp())
}

pub(crate) fn hyperbolic_tangent(x: f64) -> f64 {
    (x.exp() - (-x).exp()) / (x.exp() + (-x).exp())
}

pub(crate) fn cube_roots(x: f64) -> f64 {
    (x + 1.0).cbrt() - x.cbrt()
}

pub(crate) fn versine(t: f64) -> f64 {
    (1.0 - t.cos()) / t.powi(2)
}
