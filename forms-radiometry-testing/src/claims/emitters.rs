//! Emitters of each shape, seen directly in scenes that are path traced.

use super::Claim;
use forms_kernels::{
    form_factor_point_disk, form_factor_point_rectangle, form_factor_point_sphere, solid_angle_sphere,
};
use forms_testing::scene_text::elements::{
    disk, distant_light, filled_with, gas, medium, mirror_aside, probe, shining, sphere, two_sided,
};
use forms_testing::scene_text::{material, point_receiver, surface};
use std::f64::consts::PI;

fn black(name: &str, shape: &str) -> String {
    material("black", 0) + &surface(name, "black", &shining(shape, 2))
}

pub(super) fn claims() -> Vec<Claim> {
    let up = |name: &str| point_receiver(name, [0.0; 3], [0.0, 0.0, 1.0]);
    let square = "polygon = [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]]";
    let of_square = |height: f64| {
        form_factor_point_rectangle(
            0.0, 0.0, height, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        )
    };
    vec![
        Claim::new("a square shines on a point", &[mirror_aside(), black("lamp", square), up("here")])
            .irradiance("here", 2.0 * PI * of_square(0.0)),
        Claim::new(
            "both sides of a square shine",
            &[
                mirror_aside(),
                black("lamp", &two_sided(square)),
                up("below"),
                point_receiver("above", [0.0, 0.0, 2.0], [0.0, 0.0, -1.0]),
            ],
        )
        .irradiance("below", 2.0 * PI * of_square(0.0))
        .irradiance("above", 2.0 * PI * of_square(0.0)),
        Claim::new(
            "a disk shines",
            &[mirror_aside(), black("lamp", &disk([0.7, 0.0, 1.0], [0.0, 0.0, -1.0], 0.5)), up("here")],
        )
        .irradiance("here", 2.0 * PI * form_factor_point_disk(0.5, 1.0, 0.7)),
        Claim::new(
            "a sphere shines that the horizon cuts",
            &[
                mirror_aside(),
                black("lamp", &sphere([1.5, 0.0, 0.2], 0.8, false)),
                up("here"),
                probe("probe", [0.0; 3]),
            ],
        )
        .irradiance("here", {
            let distance = 1.5_f64.hypot(0.2);
            2.0 * PI * form_factor_point_sphere(distance, 0.8, 0.2 / distance)
        })
        .fluence("probe", 2.0 * solid_angle_sphere(0.8, 1.5_f64.hypot(0.2)), {
            // the flow of a sphere is π R²/d², directed away from it
            let squared = 1.5 * 1.5 + 0.2 * 0.2;
            [1.5, 0.0, 0.2].map(|x: f64| -2.0 * PI * 0.64 / squared * x / squared.sqrt())
        }),
        Claim::new(
            "a sphere shines inwards",
            &[
                mirror_aside(),
                black("lamp", &sphere([0.0; 3], 2.0, true)),
                up("here"),
                probe("probe", [1.0, 0.0, 0.0]),
            ],
        )
        .irradiance("here", 2.0 * PI)
        .fluence("probe", 8.0 * PI, [0.0; 3]),
        Claim::new(
            "light from afar falls at a slant",
            &[
                gas("gas", 1, 0, 0),
                surface("cloud", "gas", &sphere([9.0, 0.0, 1.0], 1.0, false)),
                distant_light([0.0, 0.6, -0.8], 5),
                up("here"),
            ],
        )
        .irradiance("here", 4.0),
        Claim::new(
            "a lamp in a liquid shines as it does in the open",
            &[
                medium("liquid", [&0, &0, &0, &1.4]),
                filled_with("liquid"),
                mirror_aside(),
                black("lamp", square),
                up("here"),
            ],
        )
        .irradiance("here", 2.0 * PI * of_square(0.0)),
        Claim::new(
            "a lamp is hidden from half of the points by a screen",
            &[
                mirror_aside(),
                black("lamp", "polygon = [[-9, -9, 2], [-9, 9, 2], [9, 9, 2], [9, -9, 2]]"),
                surface("screen", "black", "polygon = [[0, -99, 1], [99, -99, 1], [99, 99, 1], [0, 99, 1]]"),
                up("here"),
            ],
        )
        .irradiance(
            "here",
            2.0 * PI
                * form_factor_point_rectangle(
                    0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -9.0, 2.0, 9.0, 0.0, 0.0, 0.0, 18.0, 0.0,
                ),
        ),
    ]
}
