//! Many lights of all strengths: their light at a point is the sum of the light of each, a closed
//! form.

use crate::claims::answers;
use forms_kernels::form_factor_point_sphere;
use forms_radiometry::scene::read;
use forms_testing::SplitMix;
use forms_testing::scene_text::elements::{distant_light, mirror_aside, point_light, shining, sphere};
use forms_testing::scene_text::{Point, material, point_receiver, surface, tolerance};
use std::f64::consts::PI;

/// Number of standard errors that an answer may be off.
const DEVIATIONS: f64 = 4.0;

/// Returns suns, point lights and spheres around the origin, and the irradiance there of those
/// above.
fn lights(random: &mut SplitMix) -> (String, f64) {
    let most = random.of(&[4, 40]);
    let count = 2 + random.below(most);
    let (mut text, mut irradiance) = (String::new(), 0.0);
    for number in 0..count {
        let [z, turn] = [2.0 * random.unit() - 1.0, 2.0 * PI * random.unit()];
        let across = (1.0 - z * z).sqrt();
        let way = [across * turn.cos(), across * turn.sin(), z];
        let distance = 10.0_f64.powf(2.0 * random.unit() - 1.0);
        let position: Point = way.map(|part| distance * part);
        let strength = 10.0_f64.powf(6.0 * random.unit() - 3.0);
        let radius = 1e-4 * distance * random.unit();
        irradiance += match random.below(3) {
            0 => {
                text += &distant_light(way.map(|part| -part), strength);
                strength * z.max(0.0)
            }
            1 => {
                text += &point_light(position, strength);
                strength * z.max(0.0) / (distance * distance)
            }
            _ => {
                let name = format!("lamp {number}");
                let radiance = strength / (radius * radius);
                text += &surface(&name, "black", &shining(&sphere(position, radius, false), radiance));
                PI * radiance * form_factor_point_sphere(distance, radius, z)
            }
        };
    }
    (text, irradiance)
}

#[test]
fn what_a_point_gets_is_the_sum_of_what_each_light_brings() {
    let mut random = SplitMix(1);
    for number in 0..40 {
        let (lights, right) = lights(&mut random);
        let here = point_receiver("here", [0.0; 3], [0.0, 0.0, 1.0]);
        let text = [material("black", 0), lights, mirror_aside(), here, tolerance(1e-2)].concat();
        let scene = read(&text, "lights.toml").unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]));
        let here = &answers("many lights", &scene)[0];
        let off = (here.value - right).abs();
        assert!(off <= DEVIATIONS * here.error, "{number}: {here:?}, {right} is right");
    }
}
