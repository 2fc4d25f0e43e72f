//! Fog: the light of a point light that a medium scatters once into a ray, isotropically or not;
//! and a boundary between equal media, which has no effect.

use super::Claim;
use super::integral::integral;
use forms_kernels::airlight;
use forms_testing::scene_text::elements::{cuboid, effects, filled_with, gas, medium, point_light, ray};
use forms_testing::scene_text::{material, surface};
use std::f64::consts::PI;

/// Returns a point light of intensity 1 at the distance h from the ray along x, next to the point s
/// of the ray, in fog that ends at a black wall at D.
fn lit([beta, h, s, end]: [f64; 4], g: f64) -> [String; 6] {
    let wall =
        format!("polygon = [[{end:?}, -99, -99], [{end:?}, -99, 99], [{end:?}, 99, 99], [{end:?}, 99, -99]]");
    [
        medium("fog", [&0, &beta, &g, &1]),
        filled_with("fog"),
        material("black", 0),
        surface("wall", "black", &wall) + &point_light([s, h, 0.0], 1),
        ray("ray", [0.0; 3], [1.0, 0.0, 0.0]),
        effects("scattering = 1"),
    ]
}

fn evenly(name: &'static str, [beta, h, s, end]: [f64; 4]) -> Claim {
    Claim::new(name, &lit([beta, h, s, end], 0.0)).radiance("ray", airlight(beta, h, s, end))
}

/// Claims scattering with mean cosine g and absorption: ∫ σₛ p(cos θ) e^(−σ (x + r))/r² dx. Light
/// travels the length r to x, and is scattered there into the direction −x.
fn unevenly(name: &'static str, [beta, absorption, g]: [f64; 3]) -> Claim {
    let [h, s, end] = [1.0, 2.0, 5.0];
    let mut tables = lit([beta, h, s, end], g);
    tables[0] = medium("fog", [&absorption, &beta, &g, &1]);
    let brought = |x: f64| {
        let r = h.hypot(x - s);
        let cosine = (s - x) / r;
        let phase = (1.0 - g * g) / (4.0 * PI * (1.0 + g * g - 2.0 * g * cosine).powf(1.5));
        beta * phase * (-(beta + absorption) * (x + r)).exp() / (r * r)
    };
    Claim::new(name, &tables).radiance("ray", integral([0.0, s], brought) + integral([s, end], brought))
}

pub(super) fn claims() -> Vec<Claim> {
    let through_nothing = {
        let box_of_fog =
            gas("same", 0, 0.2, 0) + &cuboid("box", "same", [[1.0, -0.5, -0.5], [4.0, 0.5, 0.5]], false, "");
        let tables = [&lit([0.2, 1.0, 3.0, 10.0], 0.0)[..], &[box_of_fog]].concat();
        Claim::new("fog in fog of the same kind is one fog", &tables)
            .radiance("ray", airlight(0.2, 1.0, 3.0, 10.0))
    };
    vec![
        // the project's references `airlight-…`
        Claim::new("a light behind the eye lights the fog", &lit([0.2, 1.0, -3.0, 10.0], 0.0))
            .radiance("ray", 0.000_981_192_005_327_111_2),
        Claim::new("a light lights fog that is hardly there", &lit([1e-9, 1.0, 3.0, 10.0], 0.0))
            .radiance("ray", 2.131_040_945_289_220_6e-10),
        evenly("a light lights the fog abreast of it", [0.2, 1.0, 3.0, 10.0]),
        evenly("a light stands beside the ray in dense fog", [1.5, 1e-2, 2.0, 4.0]),
        unevenly("fog scatters forwards", [0.3, 0.0, 0.8]),
        unevenly("fog scatters backwards and absorbs", [0.3, 0.2, -0.5]),
        through_nothing,
    ]
}
