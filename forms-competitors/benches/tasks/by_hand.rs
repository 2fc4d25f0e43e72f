//! The same values by the stable methods of renderers, robotics libraries and textbooks.

/// w = 1 − √(1 − s) without cancellation, sin² = u w (2 − u w).
#[inline(always)]
pub(crate) fn cone_sine(s: f64, u: f64) -> f64 {
    let height = u * (s / (1.0 + (1.0 - s).sqrt()));
    (height * (2.0 - height)).sqrt()
}

/// The conjugate of the root's difference, as in pbrt, 4th edition.
#[inline(always)]
pub(crate) fn linear_sample(a: f64, b: f64, u: f64) -> f64 {
    u * (a + b) / (a + ((1.0 - u) * a * a + u * b * b).sqrt())
}

/// The root of the quadratic whose sum has no cancellation, the other one by Vieta.
#[inline(always)]
pub(crate) fn atmosphere(r: f64, mu: f64, top: f64) -> f64 {
    let along = r * mu;
    let gap = (top - r) * (top + r);
    let root = (along * along + gap).sqrt();
    if mu < 0.0 { root - along } else { gap / (root + along) }
}

/// Taylor's series below 1/2: its remainder is below 1e-17.
#[inline(always)]
pub(crate) fn rotation_coefficient(t: f64) -> f64 {
    if t.abs() < 0.5 {
        let coefficients =
            [6.0, -120.0, 5040.0, -362_880.0, 39_916_800.0, -6_227_020_800.0, 1_307_674_368_000.0];
        series(t * t, coefficients)
    } else {
        (t - t.sin()) / (t * t * t)
    }
}

/// As above, to 1.
#[inline(always)]
pub(crate) fn motion_coefficient(t: f64) -> f64 {
    if t.abs() < 1.0 {
        let coefficients = [
            120.0,
            -2520.0,
            120_960.0,
            -9_979_200.0,
            1_245_404_160.0,
            -217_945_728_000.0,
            50_812_489_728_000.0,
            -15_205_637_551_104_000.0,
        ];
        series(t * t, coefficients)
    } else {
        let squared = t * t;
        (2.0 * t - 3.0 * t.sin() + t * t.cos()) / (2.0 * t * squared * squared)
    }
}

/// Σ xⁱ/cᵢ by Horner's scheme; the compiler computes the reciprocals.
#[inline(always)]
fn series<const N: usize>(x: f64, reciprocals: [f64; N]) -> f64 {
    reciprocals.iter().rev().fold(0.0, |sum, reciprocal| sum * x + 1.0 / reciprocal)
}

/// atan2(|a × b|, a · b)
#[inline(always)]
pub(crate) fn angle_of_vectors(ax: f64, ay: f64, az: f64, bx: f64, by: f64, bz: f64) -> f64 {
    let [x, y, z] = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
    (x * x + y * y + z * z).sqrt().atan2(ax * bx + ay * by + az * bz)
}

#[inline(always)]
pub(crate) fn softplus(x: f64) -> f64 {
    x.max(0.0) + (-x.abs()).exp().ln_1p()
}

#[inline(always)]
pub(crate) fn sum_of_logarithms(a: f64, b: f64) -> f64 {
    a.max(b) + (-(a - b).abs()).exp().ln_1p()
}

/// M. Mächler, Accurately Computing log(1 − exp(−|a|)), 2012.
#[inline(always)]
pub(crate) fn complement_of_logarithm(x: f64) -> f64 {
    if x < std::f64::consts::LN_2 { (-(-x).exp_m1()).ln() } else { (-(-x).exp()).ln_1p() }
}

/// The normal distribution by erfc, which keeps its tails.
#[inline(always)]
pub(crate) fn option_price(s: f64, k: f64, t: f64, sigma: f64) -> f64 {
    let deviation = sigma * t.sqrt();
    let middle = (s / k).ln() / deviation;
    let normal = |d: f64| 0.5 * libm::erfc(-std::f64::consts::FRAC_1_SQRT_2 * d);
    s * normal(middle + 0.5 * deviation) - k * normal(middle - 0.5 * deviation)
}

/// E. Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, 2019: the
/// discriminant by the distance of the ray from the centre, and the root without cancellation.
#[allow(clippy::too_many_arguments, reason = "the components of three values")]
#[inline(always)]
pub(crate) fn sphere_hit(ox: f64, oy: f64, oz: f64, dx: f64, dy: f64, dz: f64, radius: f64) -> f64 {
    let along = -(ox * dx + oy * dy + oz * dz);
    let squared = dx * dx + dy * dy + dz * dz;
    let foot = along / squared;
    let [x, y, z] = [ox + foot * dx, oy + foot * dy, oz + foot * dz];
    let root = (squared * (radius * radius - (x * x + y * y + z * z))).sqrt();
    if along > 0.0 {
        squared * (ox * ox + oy * oy + oz * oz - radius * radius) / (along + root)
    } else {
        along - root
    }
}

#[inline(always)]
pub(crate) fn fisheye(x: f64, y: f64, k: f64) -> f64 {
    let radius = x.hypot(y);
    let angle = radius.atan();
    angle * (1.0 + k * (angle * angle)) / radius * x
}

#[inline(always)]
pub(crate) fn distance(x1: f64, y1: f64, x2: f64, y2: f64) -> f64 {
    (x1 - x2).hypot(y1 - y2)
}

#[inline(always)]
pub(crate) fn logistic(x: f64) -> f64 {
    1.0 / (1.0 + (-x).exp())
}

#[inline(always)]
pub(crate) fn hyperbolic_tangent(x: f64) -> f64 {
    x.tanh()
}

#[inline(always)]
pub(crate) fn cube_roots(x: f64) -> f64 {
    let (a, b) = ((x + 1.0).cbrt(), x.cbrt());
    1.0 / (a * a + a * b + b * b)
}

#[inline(always)]
pub(crate) fn versine(t: f64) -> f64 {
    let sine = (0.5 * t).sin() / t;
    2.0 * sine * sine
}
