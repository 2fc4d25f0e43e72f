//! Slabs of a medium that scatters, as boxes so wide that their ends are not visible: reflectance
//! and transmittance for isotropic light from above, and for a beam.

use super::Claim;
use super::integral::{exponential_integral, integral};
use forms_kernels::{
    chandrasekhar_h, henyey_greenstein, single_scatter_reflected, single_scatter_transmitted,
    slab_transmittance,
};
use forms_testing::scene_text::elements::{
    cuboid, distant_light, effects, filled_with, gas, ray, shining, square,
};
use forms_testing::scene_text::{material, point_receiver, surface};
use std::f64::consts::PI;

/// Half width of a slab whose thickness is 1: the part missing beyond it is 1e-8 of the light.
const WIDE: f64 = 1e4;

fn slab(thickness: f64, absorption: f64, scattering: f64, g: f64) -> String {
    let body = [[-WIDE, -WIDE, -thickness], [WIDE, WIDE, 0.0]];
    gas("fog", absorption, scattering, g) + &cuboid("slab", "fog", body, false, "")
}

/// Returns isotropic light of radiance 1 from above, and receivers of the reflected and of the
/// transmitted light.
fn lit_from_above() -> String {
    material("black", 0)
        + &surface("lamp", "black", &shining(&square(1.0, WIDE, false), 1))
        + &point_receiver("reflected", [0.0, 0.0, 0.5], [0.0, 0.0, -1.0])
        + &point_receiver("transmitted", [0.0, 0.0, -1.5], [0.0, 0.0, 1.0])
}

/// Claims that a slab of albedo ω and optical thickness τ reflects R.
fn reflects(name: &'static str, [omega, tau]: [f64; 2], reflectance: f64) -> Claim {
    let tables = [slab(1.0, (1.0 - omega) * tau, omega * tau, 0.0), lit_from_above()];
    let claim = Claim::new(name, &tables).irradiance("reflected", PI * reflectance);
    if omega == 1.0 { claim.irradiance("transmitted", PI * (1.0 - reflectance)) } else { claim }
}

/// Returns an infinite medium between a plate of radiance 1 and a black one, and receivers on both:
/// every path ends at a plate.
pub(super) fn between_plates(medium: &str) -> [String; 3] {
    let plates = surface("lamp", "black", &shining(&square(1.0, WIDE, false), 1))
        + &surface("floor", "black", &square(0.0, WIDE, true));
    let receivers = point_receiver("reflected", [0.0, 0.0, 1.0], [0.0, 0.0, -1.0])
        + &point_receiver("transmitted", [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    [material("black", 0) + &plates, medium.to_owned() + &filled_with("fog"), receivers]
}

/// Claims that a slab between plates, which absorbs nothing, reflects R.
fn passes(name: &'static str, tau: f64, reflectance: f64) -> Claim {
    Claim::new(name, &between_plates(&gas("fog", 0, tau, 0)))
        .irradiance("reflected", PI * reflectance)
        .irradiance("transmitted", PI * (1.0 - reflectance))
        .within(5e-3)
}

/// Returns the contributions of light scattered once, and twice, to the reflectance and
/// transmittance of a slab: with S₁ = ω/2 E₂(t), Sₙ₊₁(t) = ω/2 ∫ E₁(|t − t′|) Sₙ(t′) dt′, these are
/// 2 ∫ Sₙ(t) E₂(t) dt and 2 ∫ Sₙ(t) E₂(τ − t) dt.
fn orders(omega: f64, tau: f64) -> [[f64; 2]; 2] {
    let e2 = |t: f64| exponential_integral(2, t);
    let first = |t: f64| 0.5 * omega * e2(t);
    let once =
        [0, 1].map(|side| integral([0.0, tau], |t| 2.0 * first(t) * e2(if side == 0 { t } else { tau - t })));
    // ∫ E₁(|t − t′|) S(t′) dt′ by directions: E₁(x) = ∫ e^(−x/μ)/μ dμ
    let e1 = |x: f64| integral([0.0, 1.0], |mu| (-x / mu).exp() / mu);
    let second = |t: f64| {
        let part = |range: [f64; 2]| integral(range, |s| e1((t - s).abs()) * first(s));
        0.5 * omega * (part([0.0, t]) + part([t, tau]))
    };
    let twice = |t: f64| {
        let source = 2.0 * second(t);
        [source * e2(t), source * e2(tau - t)]
    };
    // Gauss–Legendre of five points in eight parts: the source is smooth but for t log t at the
    // ends
    const NODES: [[f64; 2]; 5] = [
        [-0.906_179_845_938_664, 0.236_926_885_056_189],
        [-0.538_469_310_105_683, 0.478_628_670_499_366],
        [0.0, 0.568_888_888_888_889],
        [0.538_469_310_105_683, 0.478_628_670_499_366],
        [0.906_179_845_938_664, 0.236_926_885_056_189],
    ];
    const PARTS: u32 = 8;
    let half = 0.5 * tau / f64::from(PARTS);
    let mut sums = [0.0; 2];
    for part in 0..PARTS {
        for [node, weight] in NODES {
            let [r, t] = twice(half * (f64::from(2 * part + 1) + node));
            sums = [sums[0] + half * weight * r, sums[1] + half * weight * t];
        }
    }
    [once, sums]
}

/// Claims the light of a slab that is scattered up to `most` times.
fn scattered(name: &'static str, most: u32) -> Claim {
    const OMEGA: f64 = 0.8;
    const TAU: f64 = 1.5;
    let orders = orders(OMEGA, TAU);
    let sum = |side: usize| orders[..most as usize].iter().map(|order| order[side]).sum::<f64>();
    let tables = [
        slab(1.0, (1.0 - OMEGA) * TAU, OMEGA * TAU, 0.0),
        lit_from_above(),
        effects(&format!("scattering = {most}")),
    ];
    Claim::new(name, &tables)
        .irradiance("reflected", PI * sum(0))
        .irradiance("transmitted", PI * (slab_transmittance(TAU) + sum(1)))
}

/// Claims the light of a beam that a slab scatters once, along rays from outside: π I/F₀ of
/// isotropic scattering times 4π times the phase function.
fn beam(name: &'static str, [omega, tau, g]: [f64; 3]) -> Claim {
    const FLUX: f64 = 3.0;
    let [mu0, mu]: [f64; 2] = [0.8, 0.5];
    let [down, across] = [mu0, mu].map(|mu| (1.0 - mu * mu).sqrt());
    let light = [down, 0.0, -mu0];
    let phase = |to: [f64; 3]| {
        4.0 * PI * henyey_greenstein(g, light[0] * to[0] + light[1] * to[1] + light[2] * to[2])
    };
    let (up, on) = ([0.0, across, mu], [0.0, across, -mu]);
    let back = |to: [f64; 3]| to.map(|x| -x);
    let tables = [
        slab(1.0, (1.0 - omega) * tau, omega * tau, g),
        distant_light(light, FLUX),
        ray("reflected", [0.0, 0.0, 1.0], back(up)),
        ray("transmitted", [0.0, 0.0, -2.0], back(on)),
        effects("scattering = 1"),
    ];
    Claim::new(name, &tables)
        .radiance("reflected", FLUX / PI * phase(up) * single_scatter_reflected(omega, tau, mu0, mu))
        .radiance("transmitted", FLUX / PI * phase(on) * single_scatter_transmitted(omega, tau, mu0, mu))
}

/// Claims the reflection of a half-space in a beam: π I/F₀ = ω/4 μ₀/(μ₀ + μ) H(μ) H(μ₀). Light that
/// returns from the depth of 40 is 1e-18.
fn half_space(name: &'static str, omega: f64) -> Claim {
    let [mu0, mu]: [f64; 2] = [1.0, 0.5];
    let across = (1.0 - mu * mu).sqrt();
    let tables = [
        slab(40.0, 1.0 - omega, omega, 0.0),
        distant_light([0.0, 0.0, -mu0], PI),
        ray("reflected", [0.0, 0.0, 1.0], [0.0, across, -mu]),
    ];
    let product = chandrasekhar_h(omega, mu0) * chandrasekhar_h(omega, mu);
    Claim::new(name, &tables).radiance("reflected", 0.25 * omega * mu0 / (mu0 + mu) * product)
}

pub(super) fn claims() -> Vec<Claim> {
    vec![
        // the project's references, `slab-iso-…`: van de Hulst's tables
        reflects("a thin slab without absorption", [1.0, 0.1], 0.084_297_126_167),
        reflects("a slab of albedo 0.9 and thickness 1", [0.9, 1.0], 0.352_712_039_836_127),
        reflects("a slab of albedo 0.99 and thickness 4", [0.99, 4.0], 0.709_734_304_760_716_5),
        reflects("a thick slab without absorption", [1.0, 10.0], 0.883_254_886_486_837_4).within(0.2),
        passes("a slab between plates", 1.0, 0.446_594_006_673),
        passes("a thin slab between plates", 0.1, 0.084_297_126_167),
        // `slab-2E3-1.0`
        Claim::new(
            "a slab that only absorbs transmits 2 E₃(τ)",
            &[slab(1.0, 1.0, 0.0, 0.0), lit_from_above()],
        )
        .irradiance("transmitted", PI * 0.219_383_934_395_520_27),
        scattered("light is scattered once in a slab", 1),
        scattered("light is scattered twice in a slab", 2),
        beam("a beam is scattered once, evenly", [0.9, 1.0, 0.0]),
        beam("a beam is scattered once, forwards", [0.7, 0.5, 0.6]),
        beam("a beam is scattered once in a thin slab, backwards", [1.0, 1e-3, -0.5]),
        half_space("a half-space of albedo 0.5 in a beam", 0.5),
        half_space("a half-space of albedo 0.9 in a beam", 0.9),
    ]
}
