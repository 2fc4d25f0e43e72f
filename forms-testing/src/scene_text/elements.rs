//! Elements of scenes with more than diffuse surfaces, each as its table of a scene file.

use super::{CUBE, Point, material, polygon, surface};
use std::fmt::Display;

/// Returns a medium with this absorption, scattering, mean cosine and index, each a number or a
/// list of one number per band.
pub fn medium(name: &str, [sigma_a, sigma_s, g, n]: [&dyn Display; 4]) -> String {
    format!("[[medium]]\nname = \"{name}\"\nsigma_a = {sigma_a}\nsigma_s = {sigma_s}\ng = {g}\nn = {n}\n")
}

/// Returns a medium that only refracts light, with a boundary material of its name.
pub fn glass(name: &str, n: impl Display) -> String {
    medium(name, [&0, &0, &0, &n]) + &dielectric(name)
}

/// Returns a medium of index 1, with a boundary material of its name.
pub fn gas(name: &str, sigma_a: impl Display, sigma_s: impl Display, g: impl Display) -> String {
    medium(name, [&sigma_a, &sigma_s, &g, &1]) + &dielectric(name)
}

/// Returns the boundary material of a medium, with the medium's name.
pub fn dielectric(medium: &str) -> String {
    format!("[[material]]\nname = \"{medium}\"\nkind = \"dielectric\"\ninside = \"{medium}\"\n")
}

/// Returns a mirror.
pub fn mirror(name: &str, reflectance: impl Display) -> String {
    format!("[[material]]\nname = \"{name}\"\nkind = \"mirror\"\nreflectance = {reflectance}\n")
}

/// Returns a metal of the index η + ik.
pub fn metal(name: &str, eta: f64, k: f64) -> String {
    format!("[[material]]\nname = \"{name}\"\nkind = \"conductor\"\neta = {eta:?}\nk = {k:?}\n")
}

/// Returns the shape of a sphere.
pub fn sphere(center: Point, radius: f64, inward: bool) -> String {
    format!("sphere = {{ center = {center:?}, radius = {radius:?}, inward = {inward} }}")
}

/// Returns the shape of a disk.
pub fn disk(center: Point, normal: Point, radius: f64) -> String {
    format!("disk = {{ center = {center:?}, normal = {normal:?}, radius = {radius:?} }}")
}

/// Returns a shape that emits this radiance.
pub fn shining(shape: &str, radiance: impl Display) -> String {
    format!("{shape}\nradiance = {radiance}")
}

/// Returns a shape whose back is like its front.
pub fn two_sided(shape: &str) -> String {
    format!("{shape}\ntwo_sided = true")
}

/// Returns a horizontal square about the axis z, at this height, with sides of twice this length;
/// its front faces up or down.
pub fn square(height: f64, half: f64, looks_up: bool) -> String {
    let [low, high] = [-half, half];
    let up = [[low, low, height], [high, low, height], [high, high, height], [low, high, height]];
    let [a, b, c, d] = up;
    polygon(&if looks_up { up } else { [a, d, c, b] })
}

/// Returns the six faces of a cuboid of one material, facing in or out, named `NAME_floor` and so
/// on; `more` holds further keys of each shape.
pub fn cuboid(name: &str, of: &str, [low, high]: [Point; 2], inward: bool, more: &str) -> String {
    let faces = CUBE.map(|(face, corners)| {
        let mut corners = corners.map(|corner| {
            std::array::from_fn(|axis| if corner[axis] == 0.0 { low[axis] } else { high[axis] })
        });
        if !inward {
            corners.reverse();
        }
        surface(&format!("{name}_{face}"), of, &(polygon(&corners) + more))
    });
    faces.concat()
}

/// Returns a basin filled to its edge with a medium: black walls, facing inwards, that emit this
/// radiance.
pub fn basin(medium: &str, [low, high]: [Point; 2], radiance: f64) -> String {
    let cover = format!("{medium}_ceiling");
    let walls = cuboid(medium, "wall", [low, high], true, &format!("\nradiance = {radiance:?}"));
    let tables = walls.split("[[surface]]\n").filter(|table| !table.is_empty() && !table.contains(&cover));
    let walls: String = tables.map(|table| format!("[[surface]]\n{table}")).collect();
    let [[x, y, _], [to_x, to_y, z]] = [low, high];
    let top = polygon(&[[x, y, z], [to_x, y, z], [to_x, to_y, z], [x, to_y, z]]);
    material("wall", 0) + &walls + &surface("water_level", medium, &top)
}

/// Returns a receiver of the radiance that arrives from a direction.
pub fn ray(name: &str, origin: Point, direction: Point) -> String {
    format!(
        "[[receiver]]\nname = \"{name}\"\nkind = \"ray\"\norigin = {origin:?}\ndirection = {direction:?}\n"
    )
}

/// Returns a receiver of light from all sides.
pub fn probe(name: &str, position: Point) -> String {
    format!("[[receiver]]\nname = \"{name}\"\nkind = \"sphere\"\nposition = {position:?}\n")
}

/// Returns a camera.
pub fn camera([origin, target, up]: [Point; 3], fov: f64, resolution: [usize; 2]) -> String {
    format!(
        "[[receiver]]\nname = \"camera\"\nkind = \"camera\"\norigin = {origin:?}\ntarget = {target:?}\n\
         up = {up:?}\nfov = {fov:?}\nresolution = {resolution:?}\n"
    )
}

/// Returns the time bins of the receiver before it.
pub fn time(start: f64, width: f64, bins: usize) -> String {
    format!("time = {{ start = {start:?}, width = {width:?}, bins = {bins} }}\n")
}

/// Returns a point light.
pub fn point_light(position: Point, intensity: impl Display) -> String {
    format!("[[light]]\nkind = \"point\"\nposition = {position:?}\nintensity = {intensity}\n")
}

/// Returns a light at an infinite distance.
pub fn distant_light(direction: Point, irradiance: impl Display) -> String {
    format!("[[light]]\nkind = \"distant\"\ndirection = {direction:?}\nirradiance = {irradiance}\n")
}

/// Returns the setting of a medium that fills the scene.
pub fn filled_with(medium: &str) -> String {
    format!("[ambient]\nmedium = \"{medium}\"\n")
}

/// Returns light from outside.
pub fn sky(radiance: impl Display) -> String {
    format!("[ambient]\nradiance = {radiance}\n")
}

/// Returns forced effects.
pub fn effects(forced: &str) -> String {
    format!("[solve]\neffects = {{ {forced} }}\n")
}

/// Returns a mirror that is visible from nowhere: with it, a scene of diffuse surfaces is path
/// traced.
pub fn mirror_aside() -> String {
    mirror("aside", 0.5)
        + &surface("aside", "aside", "polygon = [[0, 0, -50], [0, 1, -50], [1, 1, -50], [1, 0, -50]]")
}
