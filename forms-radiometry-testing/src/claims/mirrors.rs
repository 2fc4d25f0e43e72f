//! Mirrors: a plane mirror shows the image of a scene, times the mirror's reflectance for each
//! reflection.

use super::Claim;
use forms_kernels::form_factor_point_rectangle;
use forms_testing::scene_text::elements::{self, mirror, point_light, ray, shining};
use forms_testing::scene_text::{material, point_receiver, polygon, surface};
use std::f64::consts::PI;

const FAR: f64 = 1e3;

/// Returns the form factor, at the origin's height, of a unit square above whose corner nearest to
/// the axis is (x, y, 1).
fn seen(at: [f64; 2], [x, y]: [f64; 2]) -> f64 {
    form_factor_point_rectangle(at[0], at[1], 0.0, 0.0, 0.0, 1.0, x, y, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0)
}

/// Returns a lamp of radiance 1 over (0.2, 0.3) to (1.2, 1.3), at the height 1.
fn lamp() -> String {
    let corners = [[0.2, 0.3, 1.0], [0.2, 1.3, 1.0], [1.2, 1.3, 1.0], [1.2, 0.3, 1.0]];
    material("black", 0) + &surface("lamp", "black", &shining(&polygon(&corners), 1))
}

/// Returns a mirror in the plane x = 0 or y = 0.
fn wall(axis: usize) -> String {
    let corner = |along: f64, up: f64| if axis == 0 { [0.0, along, up] } else { [along, 0.0, up] };
    let mut corners = [corner(-FAR, -FAR), corner(FAR, -FAR), corner(FAR, FAR), corner(-FAR, FAR)];
    if axis == 0 {
        // faces along x
        return surface("mirror_x", "silver", &polygon(&corners));
    }
    corners.reverse();
    surface("mirror_y", "silver", &polygon(&corners))
}

pub(super) fn claims() -> Vec<Claim> {
    const RHO: f64 = 0.8;
    let here = [0.1, 0.15];
    let at = || point_receiver("here", [here[0], here[1], 0.0], [0.0, 0.0, 1.0]);
    let silver = || mirror("silver", RHO);
    let direct = seen(here, [0.2, 0.3]);
    let (in_x, in_y, in_both) = (seen(here, [-1.2, 0.3]), seen(here, [0.2, -1.3]), seen(here, [-1.2, -1.3]));
    // the back of a mirror is black, so only a quarter of space remains between both
    let corner = direct + RHO * (in_x + in_y) + RHO * RHO * in_both;
    let quarter = |axis: usize| {
        let corners: [[f64; 3]; 4] = if axis == 0 {
            [[0.0, 0.0, -FAR], [0.0, FAR, -FAR], [0.0, FAR, FAR], [0.0, 0.0, FAR]]
        } else {
            [[0.0, 0.0, -FAR], [0.0, 0.0, FAR], [FAR, 0.0, FAR], [FAR, 0.0, -FAR]]
        };
        surface(["quarter_x", "quarter_y"][axis], "silver", &polygon(&corners))
    };
    vec![
        Claim::new("a plane mirror doubles a lamp", &[mirror("silver", 1), wall(0), lamp(), at()])
            .irradiance("here", PI * (direct + in_x)),
        Claim::new("a mirror takes its part of an image", &[silver(), wall(1), lamp(), at()])
            .irradiance("here", PI * (direct + RHO * in_y)),
        Claim::new(
            "two mirrors that meet at a right angle make three images",
            &[silver(), quarter(0), quarter(1), lamp(), at()],
        )
        .irradiance("here", PI * corner),
        Claim::new(
            "between two facing mirrors the images of a wall's light go on for ever",
            &[
                silver(),
                surface(
                    "left",
                    "silver",
                    "polygon = [[0,-9,-9], [0,9,-9], [0,9,9], [0,-9,9]]\nradiance = 0.2",
                ),
                surface(
                    "right",
                    "silver",
                    "polygon = [[1,-9,-9], [1,-9,9], [1,9,9], [1,9,-9]]\nradiance = 0.2",
                ),
                ray("ray", [0.5, 0.0, 0.0], [1.0, 0.0, 0.0]),
            ],
        )
        .radiance("ray", 0.2 / (1.0 - RHO)),
        Claim::new(
            "the back of a mirror is black",
            &[
                silver(),
                surface("mirror", "silver", "polygon = [[-1,-1,1], [1,-1,1], [1,1,1], [-1,1,1]]"),
                material("black", 0),
                surface(
                    "lamp",
                    "black",
                    "polygon = [[-9,-9,-1], [9,-9,-1], [9,9,-1], [-9,9,-1]]\nradiance = 1",
                ),
                ray("ray", [0.0; 3], [0.0, 0.0, 1.0]),
                ray("lamp", [0.0; 3], [0.0, 0.0, -1.0]),
            ],
        )
        .radiance("ray", 0.0)
        .radiance("lamp", 1.0),
        Claim::new(
            "light of a point is reflected by a diffuse wall in fog that is as good as none",
            &[
                elements::medium("air", [&1e-13, &0, &0, &1]),
                elements::filled_with("air"),
                material("white", 0.5),
                surface("wall", "white", "polygon = [[-1,-1,0], [1,-1,0], [1,1,0], [-1,1,0]]"),
                point_light([0.0, 0.0, 2.0], 4),
                ray("ray", [1.0, 0.0, 1.0], [-1.0, 0.0, -1.0]),
            ],
        )
        .radiance("ray", 0.5 / PI),
    ]
}
