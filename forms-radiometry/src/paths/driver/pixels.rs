//! Pixels: surfaces become the part of each pixel of a camera in which surfaces that send light may
//! be visible.
//!
//! ```text
//! flat faces      the area of their image, pixel by pixel
//! curved shapes   all of a pixel that the cone around the shape touches
//! ```
//! Occlusion is omitted, so no part is too small.

use crate::camera::Camera;
use crate::faces::{is_bright, round_surfaces};
use crate::geometry::{Round, Vector};
use crate::radiosity::driver::images::add_parts;
use crate::radiosity::reflectance;
use crate::scene::{MaterialKind, Medium, Scene};
use crate::visibility::Face;

/// Returns the part of each pixel, row by row, in which surfaces that send light may be visible;
/// all of it where media may scatter light, or where no film of a pinhole shows the surfaces.
pub(super) fn shown(scene: &Scene, faces: &[Face], camera: &Camera) -> Vec<f64> {
    let [columns, rows] = camera.resolution;
    let scatters = |medium: &Medium| medium.scattering.iter().any(|&coefficient| coefficient > 0.0);
    if scene.media.iter().any(scatters) || camera.is_orthographic() {
        return vec![1.0; columns * rows];
    }
    let mut parts = vec![0.0; columns * rows];
    let is_flat = |face: &&Face| !scene.surfaces[face.surface].shape.is_round();
    let is_towards = |face: &&Face| face.normal.dot(camera.origin - face.vertices[0]) > 0.0;
    for face in faces.iter().filter(is_flat).filter(is_towards).filter(|face| sends(scene, face)) {
        let ways: Vec<Vector> = face.vertices.iter().map(|&vertex| vertex - camera.origin).collect();
        add_parts(camera, &ways, &mut parts);
    }
    for (_, round) in round_surfaces(scene) {
        fill(camera, round, &mut parts);
    }
    parts
}

/// Whether a face emits, reflects or transmits light.
fn sends(scene: &Scene, face: &Face) -> bool {
    let surface = &scene.surfaces[face.surface];
    let is_diffuse = matches!(scene.materials[surface.material].kind, MaterialKind::Diffuse { .. });
    let shines = || surface.emits() || reflectance(scene, face.surface).iter().any(|&rho| rho > 0.0);
    !is_diffuse || is_bright(scene, face) && shines()
}

/// Fills the pixels that the cone around a curved shape touches.
fn fill(camera: &Camera, round: &dyn Round, parts: &mut [f64]) {
    let [columns, _] = camera.resolution;
    let way = round.center() - camera.origin;
    // from inside the sphere around the shape, every direction may meet it
    let half =
        if way.length() > round.radius() { (round.radius() / way.length()).asin() } else { f64::INFINITY };
    for (pixel, part) in parts.iter_mut().enumerate() {
        let [x, y] = [pixel % columns, pixel / columns].map(|place| place as f64);
        let middle = camera.direction(x + 0.5, y + 0.5);
        let corners = [[x, y], [x + 1.0, y], [x, y + 1.0], [x + 1.0, y + 1.0]];
        let reach =
            corners.map(|[x, y]| angle(middle, camera.direction(x, y))).into_iter().fold(0.0, f64::max);
        if angle(middle, way) <= half + reach {
            *part = 1.0;
        }
    }
}

fn angle(a: Vector, b: Vector) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::faces::faces;
    use crate::scene::{ReceiverKind, read};

    const MATERIALS: &str = r#"
        [[material]]
        name = "grey"
        kind = "diffuse"
        reflectance = 0.5
        [[material]]
        name = "black"
        kind = "diffuse"
        reflectance = 0
        [[receiver]]
        name = "eye"
        kind = "camera"
        origin = [0, 0, 4]
        target = [0, 0, 0]
        up = [0, 1, 0]
        fov = 90
        resolution = [8, 8]
    "#;

    fn shown_of(surface: &str) -> Vec<f64> {
        let scene = read(&format!("{MATERIALS}[[surface]]\nname = \"it\"\n{surface}"), "scene.toml").unwrap();
        let ReceiverKind::Camera(camera) = &scene.receivers[0].kind else { panic!("no camera") };
        shown(&scene, &faces(&scene, 2), camera)
    }

    #[test]
    fn a_pixel_shows_the_part_of_it_that_the_image_of_a_face_covers() {
        // a pixel is one unit wide in this plane
        let square = "polygon = [[0, 0, 0], [1.5, 0, 0], [1.5, 0.25, 0], [0, 0.25, 0]]";
        let parts = shown_of(&format!("material = \"grey\"\n{square}"));
        let expected = |pixel: usize| match pixel {
            28 => 0.25,
            29 => 0.125,
            _ => 0.0,
        };
        for (pixel, part) in parts.iter().enumerate() {
            assert!((part - expected(pixel)).abs() < 1e-12, "{pixel}: {part}");
        }
        assert!(shown_of(&format!("material = \"black\"\n{square}")).iter().all(|&part| part == 0.0));
    }

    #[test]
    fn a_pixel_beside_a_sphere_shows_nothing_of_it() {
        let parts = shown_of("material = \"grey\"\nsphere = { center = [0, 0, 0], radius = 1 }");
        let count = parts.iter().filter(|&&part| part > 0.0).count();
        assert_eq!((parts[0], parts[27], count), (0.0, 1.0, 4 + 8));
    }
}
