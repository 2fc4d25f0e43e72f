//! Bands: each has the answer of the same scene in that band alone, whether bands share their paths
//! or have their own.

use super::Claim;
use super::integral::fresnel;
use super::slabs::between_plates;
use forms_kernels::airlight;
use forms_radiometry::simulation::Quantity;
use forms_testing::scene_text::elements::{
    cuboid, dielectric, effects, filled_with, glass, medium, mirror, point_light, probe, ray, shining, sky,
    sphere, square,
};
use forms_testing::scene_text::{material, point_receiver, polygon, surface};
use std::f64::consts::PI;

/// Returns this number of bands.
fn bands(count: usize) -> String {
    let ends: Vec<[usize; 2]> = (0..count).map(|band| [400 + 50 * band, 450 + 50 * band]).collect();
    format!("bands = {ends:?}\n")
}

fn list(values: &[f64]) -> String {
    format!("{values:?}")
}

/// Returns the radiance that a plate reflects at the cosine 0.6 of a sky of radiance 1: R + R (1 −
/// R)²/(1 − R²).
fn plate(n: f64) -> f64 {
    let r = fresnel(n, 0.6);
    r + r * (1.0 - r) / (1.0 + r)
}

pub(super) fn claims() -> Vec<Claim> {
    let decays = [0.1, 0.5, 1.0, 2.0, 0.0, 0.7];
    let reflectances = [0.3, 0.6, 0.9];
    let fogs = [0.05, 0.1, 0.2, 0.4, 0.8];
    let indices = [1.3, 1.5, 1.7];
    let cube = [[0.0; 3], [1.0; 3]];
    vec![
        Claim::new(
            "six bands decay each by their own coefficient",
            &[
                bands(6),
                medium("haze", [&list(&decays), &0, &0, &1]),
                filled_with("haze"),
                material("black", 0),
                surface(
                    "lamp",
                    "black",
                    &shining(&square(2.0, 1.0, false), list(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0])),
                ),
                ray("ray", [0.0; 3], [0.0, 0.0, 1.0]),
            ],
        )
        .bands(
            "ray",
            Quantity::Radiance,
            &std::array::from_fn::<f64, 6, _>(|i| (i + 1) as f64 * (-2.0 * decays[i]).exp()),
        ),
        Claim::new(
            "three bands of a furnace share their paths",
            &[
                bands(3),
                material("white", list(&reflectances)),
                cuboid("room", "white", cube, true, "\nradiance = 1"),
                mirror("silver", 1),
                surface("ball", "silver", &sphere([0.5; 3], 0.2, false)),
                point_receiver("here", [0.2, 0.2, 0.0], [0.0, 0.0, 1.0]),
            ],
        )
        .bands("here", Quantity::Irradiance, &reflectances.map(|rho| PI / (1.0 - rho))),
        Claim::new(
            "five bands of fog share the places where light is scattered",
            &[
                bands(5),
                medium("fog", [&0, &list(&fogs), &0, &1]),
                filled_with("fog"),
                material("black", 0),
                surface(
                    "wall",
                    "black",
                    &polygon(&[[8.0, -9.0, -9.0], [8.0, -9.0, 9.0], [8.0, 9.0, 9.0], [8.0, 9.0, -9.0]]),
                ),
                point_light([3.0, 1.0, 0.0], 1),
                ray("ray", [0.0; 3], [1.0, 0.0, 0.0]),
                effects("scattering = 1"),
            ],
        )
        .bands("ray", Quantity::Radiance, &fogs.map(|beta| airlight(beta, 1.0, 3.0, 8.0))),
        Claim::new(
            "bands of a slab between plates that scatter differently have their own paths",
            &[&[bands(3)], &between_plates(&medium("fog", [&0, &list(&[0.1, 1.0, 10.0]), &0, &1]))[..]]
                .concat(),
        )
        .bands(
            "reflected",
            Quantity::Irradiance,
            &[0.084_297_126_167, 0.446_594_006_673, 0.883_254_886_487].map(|part| PI * part),
        ),
        Claim::new(
            "glass with dispersion reflects each band by its own index",
            &[
                bands(3),
                glass("glass", list(&indices)),
                cuboid("plate", "glass", [[-99.0, -99.0, -1e-3], [99.0, 99.0, 0.0]], false, ""),
                material("black", 0),
                surface("floor", "black", &square(-1.0, 1e3, true)),
                sky(1),
                ray("ray", [0.0, 0.0, 1.0], [0.8, 0.0, -0.6]),
            ],
        )
        .bands("ray", Quantity::Radiance, &indices.map(plate)),
        Claim::new(
            "radiance in glass with dispersion is n² times that around it, in each band",
            &[
                bands(3),
                material("white", 0.5),
                cuboid("room", "white", cube, true, "\nradiance = 1"),
                medium("opal", [&0, &list(&[1.0, 0.0, 3.0]), &list(&[0.0, 0.5, -0.3]), &list(&indices)]),
                dielectric("opal"),
                surface("ball", "opal", &sphere([0.5; 3], 0.3, false)),
                probe("probe", [0.6, 0.5, 0.5]),
            ],
        )
        .bands("probe", Quantity::FluenceRate, &indices.map(|n| 8.0 * PI * n * n)),
    ]
}
