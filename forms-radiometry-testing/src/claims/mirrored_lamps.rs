//! Small lamps in mirrors, which hardly any random ray meets: closed forms of their images.

use super::Claim;
use super::integral::integral;
use forms_kernels::{
    form_factor_point_rectangle, form_factor_point_sphere, fresnel_conductor, solid_angle_sphere,
};
use forms_testing::scene_text::elements::{metal, mirror, probe, shining, sphere};
use forms_testing::scene_text::{Point, material, point_receiver, polygon, surface, surface_receiver};
use std::f64::consts::PI;

const FAR: f64 = 1e3;
const RHO: f64 = 0.8;
const RADIUS: f64 = 0.02;
const LAMP: Point = [0.7, 0.4, 1.1];

/// Returns a mirror in the plane x = 0 or y = 0, where the other coordinate is above 0; it faces
/// the side where its own coordinate is above 0.
fn quarter(axis: usize) -> String {
    let corners: [Point; 4] = if axis == 0 {
        [[0.0, 0.0, -FAR], [0.0, FAR, -FAR], [0.0, FAR, FAR], [0.0, 0.0, FAR]]
    } else {
        [[0.0, 0.0, -FAR], [0.0, 0.0, FAR], [FAR, 0.0, FAR], [FAR, 0.0, -FAR]]
    };
    surface(["in_x", "in_y"][axis], "silver", &polygon(&corners))
}

/// Returns the plane x = 0 or x = 2, as a mirror that faces the other plane.
fn whole(is_first: bool, of: &str) -> String {
    let x = if is_first { 0.0 } else { 2.0 };
    let mut corners = [[x, -FAR, -FAR], [x, FAR, -FAR], [x, FAR, FAR], [x, -FAR, FAR]];
    if !is_first {
        corners.reverse();
    }
    surface(if is_first { "first" } else { "second" }, of, &polygon(&corners))
}

fn lamp() -> String {
    material("black", 0) + &surface("lamp", "black", &shining(&sphere(LAMP, RADIUS, false), 9))
}

/// Returns the irradiance of a sphere of radiance 9 at a point, for this normal.
fn of_sphere([x, y, z]: Point, at: Point, normal: Point) -> f64 {
    let way = [x - at[0], y - at[1], z - at[2]];
    let distance = way.iter().map(|part| part * part).sum::<f64>().sqrt();
    let along: f64 = way.iter().zip(normal).map(|(part, n)| part * n).sum();
    9.0 * PI * form_factor_point_sphere(distance, RADIUS, along / distance)
}

pub(super) fn claims() -> Vec<Claim> {
    let [x, y, z] = LAMP;
    let (here, up) = ([0.3, 0.2, 0.1], [0.0, 0.0, 1.0]);
    let at = |position| of_sphere(position, here, up);
    let point = || point_receiver("here", here, up);
    let silver = || mirror("silver", RHO);
    let three = at([x, y, z]) + RHO * (at([-x, y, z]) + at([x, -y, z])) + RHO * RHO * at([-x, -y, z]);
    // image n is shifted by n times two widths, and exists in a mirrored form too
    let facing = |n: i32| {
        let shifted = at([x + 4.0 * f64::from(n), y, z]);
        let turned = at([-x + 4.0 * f64::from(n), y, z]);
        RHO.powi(2 * n.abs()) * shifted + RHO.powi((2 * n - 1).abs()) * turned
    };
    let solid_angle = |x: f64| {
        let to = [x - here[0], y - here[1], z - here[2]];
        solid_angle_sphere(RADIUS, to.iter().map(|part| part * part).sum::<f64>().sqrt())
    };
    let flow = |x: f64, axis: usize| {
        let to = [x - here[0], y - here[1], z - here[2]];
        let squared: f64 = to.iter().map(|part| part * part).sum();
        -9.0 * PI * RADIUS * RADIUS / squared * to[axis] / squared.sqrt()
    };
    let on_floor =
        |u: f64, v: f64| of_sphere(LAMP, [u, v, 0.0], up) + RHO * of_sphere([-x, y, z], [u, v, 0.0], up);
    // cosine at the point where the mirror shows the lamp
    let steep =
        (x + here[0]) / ((x + here[0]).powi(2) + (y - here[1]).powi(2) + (z - here[2]).powi(2)).sqrt();
    vec![
        Claim::new(
            "two mirrors make three images of a small lamp",
            &[silver(), quarter(0), quarter(1), lamp(), point()],
        )
        .irradiance("here", three)
        .within(1e-3),
        Claim::new(
            "facing mirrors make images of a small lamp without end",
            &[silver(), whole(true, "silver"), whole(false, "silver"), lamp(), point()],
        )
        .irradiance("here", (-60..=60).map(facing).sum())
        .within(1e-2),
        Claim::new(
            "a small lamp in a mirror is seen from all sides",
            &[silver(), whole(true, "silver"), lamp(), probe("probe", here)],
        )
        .fluence("probe", 9.0 * (solid_angle(x) + RHO * solid_angle(-x)), {
            [0, 1, 2].map(|axis| flow(x, axis) + RHO * flow(-x, axis))
        })
        .within(1e-2),
        Claim::new(
            "a floor gets the light of a small lamp and of its image",
            &[
                silver(),
                whole(true, "silver"),
                lamp(),
                surface("floor", "black", "polygon = [[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]]"),
                surface_receiver("floor"),
            ],
        )
        .irradiance("floor", 0.5 * integral([0.0, 1.0], |v| integral([0.0, 2.0], |u| on_floor(u, v))))
        .within(5e-3),
        Claim::new(
            "a metal shows a small lamp as it reflects at that angle",
            &[metal("gold", 0.2, 3.0), whole(true, "gold"), lamp(), point()],
        )
        .irradiance("here", at(LAMP) + fresnel_conductor(0.2, 3.0, steep) * at([-x, y, z]))
        .within(1e-3),
        Claim::new(
            "a mirror that is too low shows a part of a lamp",
            &[
                silver(),
                surface("mirror", "silver", "polygon = [[0, -9, 0], [0, 9, 0], [0, 9, 0.3], [0, -9, 0.3]]"),
                material("black", 0),
                surface(
                    "lamp",
                    "black",
                    "polygon = [[1, -0.1, 0.3], [1, -0.1, 0.6], [1, 0.1, 0.6], [1, 0.1, 0.3]]\nradiance = 9",
                ),
                point_receiver("here", [2.0, 0.0, 0.0], [-1.0, 0.0, 0.0]),
            ],
        )
        .irradiance(
            "here",
            9.0 * PI
                * RHO
                * form_factor_point_rectangle(
                    2.0, 0.0, 0.0, -1.0, 0.0, 0.0, -1.0, -0.1, 0.3, 0.0, 0.2, 0.0, 0.0, 0.0, 0.15,
                ),
        )
        .within(1e-2),
    ]
}
