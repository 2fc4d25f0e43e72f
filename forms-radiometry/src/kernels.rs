//! Radiometric kernels: the two formulas through which all light of this crate passes.
//!
//! Both are pure functions of scalars, in the units of the caller.

/// What one edge of a polygon contributes to the form factor from a receiver, by Lambert's formula:
///
/// ```text
/// f(a, b) = γ/(2π) · n·(a × b)/|a × b|,   γ = atan2(|a × b|, a·b)
/// ```
///
/// `a` and `b` are the edge's end points relative to the receiver, `n` is the receiver's unit normal, and γ
/// is the angle that the edge subtends. An edge in line with the receiver (a × b = 0) contributes nothing.
/// The sum over the edges of a polygon above the horizon is its form factor, positive when the edges run
/// counter-clockwise about `n`; see [`crate::geometry::form_factor`] for the order in which a lamp's edges
/// are taken.
#[expect(
    clippy::too_many_arguments,
    reason = "a kernel takes its scalars one by one, as generated code does"
)]
pub fn edge_form_factor(
    ax: f64,
    ay: f64,
    az: f64,
    bx: f64,
    by: f64,
    bz: f64,
    nx: f64,
    ny: f64,
    nz: f64,
) -> f64 {
    let (cx, cy, cz) = (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx);
    let sine = (cx * cx + cy * cy + cz * cz).sqrt();
    if sine == 0.0 {
        return 0.0;
    }
    let angle = sine.atan2(ax * bx + ay * by + az * bz);
    angle * (nx * cx + ny * cy + nz * cz) / (std::f64::consts::TAU * sine)
}

/// Irradiance E = π F L from a lamp of form factor F and uniform radiance L, in W/m² for L in W/(m² sr).
pub fn irradiance(form_factor: f64, radiance: f64) -> f64 {
    std::f64::consts::PI * form_factor * radiance
}
