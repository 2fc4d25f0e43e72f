//! Smooth boundaries: Fresnel's reflectance along rays and over hemispheres, plates with all
//! internal reflections, total reflection, and metals.

use super::Claim;
use super::integral::{fresnel, integral};
use forms_testing::scene_text::elements::{
    basin, cuboid, dielectric, filled_with, glass, medium, metal, probe, ray, shining, sky, square,
};
use forms_testing::scene_text::{material, point_receiver, surface};
use std::f64::consts::PI;

/// Half width of bodies that represent a half-space or an infinite plate.
const WIDE: f64 = 1e4;
/// Diffuse reflectance of glass of index 1.5 from outside: the project's reference
/// `fresnel-diffuse-1.5`.
const DIFFUSE: f64 = 0.091_777_959_342_351_21;

/// Returns a half-space of glass below z = 0 that returns no light from inside.
fn black_glass(n: f64) -> String {
    medium("glass", [&1, &0, &0, &n])
        + &dielectric("glass")
        + &cuboid("block", "glass", [[-WIDE, -WIDE, -100.0], [WIDE, WIDE, 0.0]], false, "")
}

/// Returns a downward direction with this cosine to the vertical.
fn down(cosine: f64) -> [f64; 3] {
    [(1.0 - cosine * cosine).sqrt(), 0.0, -cosine]
}

/// Claims the radiance along a ray that black glass reflects, under radiance 1 from outside.
fn reflected(name: &'static str, n: f64, cosine: f64, reflectance: f64) -> Claim {
    let tables = [black_glass(n), sky(1), ray("ray", [0.0, 0.0, 1.0], down(cosine))];
    Claim::new(name, &tables).radiance("ray", reflectance)
}

/// Claims the radiance that a plate of glass transmits at a cosine. With the transmittance a of one
/// passage through it, the sum of all internal reflections is (1 − R)² a/(1 − R² a²). The light is
/// unpolarised at every boundary.
fn through_plate(name: &'static str, cosine: f64, absorption: f64) -> Claim {
    const N: f64 = 1.5;
    const THICKNESS: f64 = 0.5;
    let bent = (1.0 - (1.0 - cosine * cosine) / (N * N)).sqrt();
    let left = (-absorption * THICKNESS / bent).exp();
    let r = fresnel(N, cosine);
    let transmitted = (1.0 - r).powi(2) * left / (1.0 - (r * left).powi(2));
    let back = r + r * left * transmitted;
    let plate = cuboid("plate", "glass", [[-WIDE, -WIDE, -THICKNESS], [WIDE, WIDE, 0.0]], false, "");
    let tables = [
        medium("glass", [&absorption, &0, &0, &N]),
        dielectric("glass"),
        plate,
        material("black", 0),
        surface("floor", "black", &shining(&square(-1.0, WIDE, true), 1)),
        surface("ceiling", "black", &shining(&square(2.0, WIDE, false), 3)),
        ray("ray", [0.0, 0.0, 1.0], down(cosine)),
    ];
    Claim::new(name, &tables).radiance("ray", transmitted + 3.0 * back)
}

/// Claims the light at receivers in a sea of glass under a sky of radiance 1.
fn under_the_sky() -> Claim {
    const N: f64 = 1.5;
    let sea = basin("glass", [[-WIDE, -WIDE, -1.0], [WIDE, WIDE, 0.0]], 0.0);
    let critical = (1.0 - 1.0 / (N * N)).sqrt();
    // within the escape cone radiance is n² (1 − R): fluence 2π n² ∫ (1 − R) dμ, flow downwards 2π
    // n² ∫ (1 − R) μ dμ
    let cone = |power: i32| {
        let left = |mu: f64| (1.0 - fresnel(1.0 / N, mu)) * mu.powi(power);
        2.0 * PI * N * N * integral([critical, 1.0], left)
    };
    let tables = [
        glass("glass", N),
        sea,
        sky(1),
        probe("diver", [0.0, 0.0, -0.5]),
        point_receiver("bottom", [0.0, 0.0, -1.0], [0.0, 0.0, 1.0]),
        ray("straight", [0.0, 0.0, -0.5], [0.0, 0.0, 1.0]),
        ray("beyond", [0.0, 0.0, -0.5], [0.8, 0.0, 0.6]),
    ];
    Claim::new("the sky fills the cone of total reflection below water", &tables)
        .fluence("diver", cone(0), [0.0, 0.0, -cone(1)])
        .irradiance("bottom", PI * (1.0 - DIFFUSE))
        .radiance("straight", 0.96 * N * N)
        .radiance("beyond", 0.0)
}

/// Claims the light of a basin of glass with walls that emit radiance 1 into it, below a dark sky.
fn shining_basin() -> Claim {
    const N: f64 = 1.5;
    let mu: f64 = 0.8;
    let outside = (1.0 - N * N * (1.0 - mu * mu)).sqrt();
    let tables = [
        glass("glass", N),
        basin("glass", [[-WIDE, -WIDE, -1.0], [WIDE, WIDE, 0.0]], 1.0),
        point_receiver("below", [0.0, 0.0, -0.5], [0.0, 0.0, 1.0]),
        point_receiver("above", [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]),
        ray("total", [0.0, 0.0, -0.5], [0.8, 0.0, 0.6]),
        ray("inside", [0.0, 0.0, -0.5], [0.6, 0.0, mu]),
        ray("outside", [0.0, 0.0, 0.5], down(outside)),
    ];
    let out = (1.0 - DIFFUSE) / (N * N);
    Claim::new("light leaves glass through the cone of total reflection", &tables)
        .irradiance("below", PI * (1.0 - out))
        .irradiance("above", PI * out)
        .radiance("total", 1.0)
        .radiance("inside", fresnel(1.0 / N, mu))
        .radiance("outside", (1.0 - fresnel(N, outside)) / (N * N))
}

/// Claims the reflection of a metal below a sky of radiance 1, in a medium of index n.
fn gold(name: &'static str, n: f64) -> Claim {
    const ETA: f64 = 0.18;
    const K: f64 = 3.4;
    // Born and Wolf, section 14.2, with (η + ik)/n
    let [eta, k] = [ETA / n, K / n];
    let reflectance = |mu: f64| {
        let sine = 1.0 - mu * mu;
        let real = eta * eta - k * k - sine;
        let modulus = (real * real + 4.0 * eta * eta * k * k).sqrt();
        let a = (0.5 * (modulus + real)).sqrt();
        let s = (modulus - 2.0 * mu * a + mu * mu) / (modulus + 2.0 * mu * a + mu * mu);
        let t = 2.0 * a * mu * sine;
        let u = mu * mu * modulus + sine * sine;
        0.5 * s * (1.0 + (u - t) / (u + t))
    };
    let normal = ((eta - 1.0).powi(2) + k * k) / ((eta + 1.0).powi(2) + k * k);
    let around = if n == 1.0 {
        sky(1)
    } else {
        medium("liquid", [&0, &0, &0, &n]) + &filled_with("liquid") + "radiance = 1\n"
    };
    let tables = [
        metal("gold", ETA, K),
        surface("plate", "gold", &square(0.0, WIDE, true)),
        around,
        ray("normal", [0.0, 0.0, 1.0], down(1.0)),
        ray("oblique", [0.0, 0.0, 1.0], down(0.3)),
        point_receiver("above", [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]),
    ];
    Claim::new(name, &tables)
        .radiance("normal", normal)
        .radiance("oblique", reflectance(0.3))
        .irradiance("above", 2.0 * PI * integral([0.0, 1.0], |mu| mu * reflectance(mu)))
}

pub(super) fn claims() -> Vec<Claim> {
    // the project's references `fresnel-n1.5-…`
    let brewster = 0.554_700_196_225_229_1;
    vec![
        reflected("glass reflects 4 % of what arrives normally", 1.5, 1.0, 0.04),
        reflected(
            "glass at Brewster's angle reflects one polarisation",
            1.5,
            brewster,
            0.073_964_497_041_420_11,
        ),
        reflected("glass reflects nearly all that grazes it", 1.5, 0.01, fresnel(1.5, 0.01)),
        reflected("beyond the critical angle all is reflected", 0.5, 0.8, 1.0),
        Claim::new(
            "glass reflects diffuse light with Walsh's reflectance",
            &[black_glass(1.5), sky(1), point_receiver("above", [0.0, 0.0, 1.0], [0.0, 0.0, -1.0])],
        )
        .irradiance("above", PI * DIFFUSE),
        through_plate("a plate seen straight through", 1.0, 0.0),
        through_plate("a plate seen at Brewster's angle", brewster, 0.0),
        through_plate("a plate of grey glass seen at a slant", 0.3, 0.8),
        under_the_sky(),
        shining_basin(),
        gold("gold reflects by its complex index", 1.0),
        gold("gold in a liquid reflects by its index over that of the liquid", 1.33),
    ]
}
