//! Effects that the file turns off, or limits to orders: the reduced scene has its own known
//! answer.

use super::Claim;
use super::integral::fresnel;
use forms_radiometry::simulation::Quantity;
use forms_testing::scene_text::elements::{
    cuboid, dielectric, effects, filled_with, medium, metal, mirror, mirror_aside, probe, ray, shining, sky,
    sphere, square, two_sided,
};
use forms_testing::scene_text::{material, point_receiver, polygon, surface};
use std::f64::consts::PI;

fn lamp(height: f64) -> String {
    material("black", 0) + &surface("lamp", "black", &shining(&square(height, 9.0, false), 1))
}

fn up() -> String {
    ray("ray", [0.0; 3], [0.0, 0.0, 1.0])
}

/// Claims the light that walls of reflectance 0.5 and radiance 1 reflect up to `most` times, in a
/// room with a mirror: Σ ρᵏ.
fn reflections(name: &'static str, most: u32) -> Claim {
    let panel = polygon(&[[0.5, 0.2, 0.2], [0.5, 0.8, 0.2], [0.5, 0.8, 0.8], [0.5, 0.2, 0.8]]);
    let tables = [
        material("white", 0.5),
        cuboid("room", "white", [[0.0; 3], [1.0; 3]], true, "\nradiance = 1"),
        mirror("silver", 1),
        surface("panel", "silver", &two_sided(&panel)),
        point_receiver("here", [0.2, 0.2, 0.0], [0.0, 0.0, 1.0]),
        effects(&format!("interreflection = {most}")),
    ];
    let sum: f64 = (0..=most).map(|order| 0.5_f64.powi(order as i32)).sum();
    Claim::new(name, &tables).irradiance("here", PI * sum)
}

pub(super) fn claims() -> Vec<Claim> {
    let fog = || medium("fog", [&0.3, &0.4, &0, &1]) + &filled_with("fog");
    let plate = |n: &str| {
        medium("glass", [&0.5, &0, &0, &n])
            + &dielectric("glass")
            + &cuboid("plate", "glass", [[-1.0, -1.0, 1.0], [1.0, 1.0, 2.0]], false, "")
    };
    let between = |rho: f64| {
        [
            mirror("silver", rho),
            surface("mirror", "silver", &square(2.0, 1.0, false)),
            metal("gold", 0.2, 3.0),
            surface(
                "metal",
                "gold",
                &polygon(&[[2.0, -9.0, -9.0], [2.0, -9.0, 9.0], [2.0, 9.0, 9.0], [2.0, 9.0, -9.0]]),
            ),
            sky(1),
            medium("air", [&0.1, &0, &0, &1]) + &dielectric("air"),
            surface("ball", "air", &sphere([0.0, 0.0, 1.0], 0.5, false)),
            up(),
            ray("aside", [0.0; 3], [1.0, 0.0, 0.0]),
            ray("down", [0.0; 3], [0.0, 0.0, -1.0]),
        ]
    };
    let reflected = fresnel(1.5, 1.0);
    // one plate of two boundaries: (1 − R)²/(1 − R²)
    let plain = (1.0 - reflected) / (1.0 + reflected);
    vec![
        reflections("light is reflected once at most", 1),
        reflections("light is reflected three times at most", 3),
        Claim::new(
            "no light is absorbed",
            &[mirror_aside(), fog(), lamp(2.0), up(), effects("absorption = \"off\", scattering = \"off\"")],
        )
        .radiance("ray", 1.0),
        Claim::new("no light is scattered", &[fog(), lamp(2.0), up(), effects("scattering = \"off\"")])
            .radiance("ray", (-0.6_f64).exp()),
        Claim::new("no light is bent", &[plate("1.5"), lamp(4.0), up(), effects("refraction = \"off\"")])
            .radiance("ray", (-0.5_f64).exp()),
        Claim::new(
            "no light is absorbed by glass",
            &[plate("1.5"), lamp(4.0), up(), effects("absorption = \"off\"")],
        )
        .radiance("ray", plain),
        Claim::new(
            "mirrors and metals are black",
            &[&between(0.9)[..], &[effects("mirror = \"off\"")]].concat(),
        )
        .radiance("ray", 0.0)
        .radiance("aside", 0.0)
        .radiance("down", 1.0),
        Claim::new(
            "all bands have the middle of the indices",
            &[
                "bands = [[400, 500], [500, 600]]\n".to_string(),
                plate("[1.2, 1.8]"),
                lamp(4.0),
                up(),
                effects("dispersion = \"off\", absorption = \"off\""),
            ],
        )
        .bands("ray", Quantity::Radiance, &[plain; 2]),
        Claim::new(
            "light straight from lamps does not count",
            &[
                material("white", 0.25),
                surface("shell", "white", &shining(&sphere([0.0; 3], 1.0, true), 1)),
                mirror_aside(),
                probe("probe", [0.0, 0.0, 0.5]),
                ray("ray", [0.0, 0.0, 0.5], [1.0, 0.0, 0.0]),
                effects("direct = \"off\""),
            ],
        )
        .fluence("probe", 4.0 * PI / 3.0, [0.0; 3])
        .radiance("ray", 1.0 / 3.0),
    ]
}
