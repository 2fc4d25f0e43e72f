//! Every element of a scene file is read into the model unchanged. Elements that no solver
//! supports are refused with their place, by the plan and not by the reader.

use crate::{EVERYTHING, scene, shown};
use forms_radiometry::geometry::{Disk, Sphere, Vector};
use forms_radiometry::scene::{
    Effect, Force, LengthUnit, LightKind, MaterialKind, ReceiverKind, Scene, Shape, SurfaceSide,
    not_simulated,
};
use forms_radiometry::simulation::plan;
use std::f64::consts::PI;

fn everything() -> Scene {
    scene(EVERYTHING, "box.toml")
}

#[test]
fn the_frame_of_a_scene_is_read() {
    let scene = everything();
    assert_eq!((&*scene.name, scene.unit, scene.band_count()), ("Box", LengthUnit::Metre, 2));
    assert_eq!((scene.ambient.medium, &scene.ambient.radiance), (Some(0), &vec![0.25, 0.25]));
    assert_eq!((scene.solve.tolerance, scene.solve.seed), (1e-2, 7));
    let forced: Vec<(Effect, Force)> = scene.solve.forced.iter().map(|f| (f.effect, f.force)).collect();
    let expected = [
        (Effect::Occlusion, Force::On),
        (Effect::Interreflection, Force::Off),
        (Effect::Scattering, Force::Orders(2)),
    ];
    assert_eq!(forced, expected);
}

#[test]
fn what_is_left_out_has_its_default() {
    let scene = scene("[[medium]]\nname = \"nothing\"\n", "empty.toml");
    assert_eq!((scene.unit, scene.band_count(), scene.ambient.medium), (LengthUnit::Metre, 1, None));
    assert_eq!((scene.solve.tolerance, scene.solve.seed, scene.solve.forced.len()), (1e-3, 1, 0));
    assert!(scene.media[0].is_vacuum() && scene.media[0].asymmetry == [0.0]);
    assert_eq!(scene.ambient.radiance, [0.0]);
}

#[test]
fn a_medium_has_one_number_a_band() {
    let scene = everything();
    let [haze, glass] = &scene.media[..] else { panic!("there are two media") };
    assert_eq!((&haze.absorption, &haze.scattering), (&vec![0.1, 0.1], &vec![0.2, 0.3]));
    assert_eq!((&haze.asymmetry, &haze.index), (&vec![-0.5, -0.5], &vec![1.0, 1.0]));
    assert_eq!((&glass.absorption, &glass.index), (&vec![0.0, 0.0], &vec![1.52, 1.51]));
}

#[test]
fn there_are_four_kinds_of_materials() {
    let kinds: Vec<MaterialKind> = everything().materials.into_iter().map(|material| material.kind).collect();
    let expected = [
        MaterialKind::Diffuse { reflectance: vec![0.75, 0.75] },
        MaterialKind::Mirror { reflectance: vec![0.9, 1.0] },
        MaterialKind::Dielectric { inside: 1 },
        MaterialKind::Conductor { eta: vec![1.4, 0.4], k: vec![2.0, 2.0] },
    ];
    assert_eq!(kinds, expected);
}

#[test]
fn there_are_four_shapes_of_surfaces() {
    let scene = everything();
    let [floor, part, ball, lid] = &scene.surfaces[..] else { panic!("there are four surfaces") };
    assert_eq!(floor.shape.as_polygon().unwrap().vertices().len(), 4);
    let Shape::Mesh(mesh) = &part.shape else { panic!("the part is a mesh") };
    assert_eq!((mesh.vertices().len(), mesh.faces().len()), (4, 4));
    let Shape::Sphere(sphere) = ball.shape else { panic!("the ball is a sphere") };
    assert_eq!(sphere, Sphere { center: Vector::new(0.0, 0.0, 4.0), radius: 0.5, inward: false });
    let Shape::Disk(disk) = lid.shape else { panic!("the lid is a disk") };
    let expected = Disk {
        center: Vector::new(0.0, 0.0, 8.0),
        normal: Vector::new(0.0, 0.0, -1.0),
        radius: 2.0,
        hole: 0.0,
    };
    assert_eq!(disk, expected);
    assert_eq!([floor.material, part.material, ball.material, lid.material], [0, 3, 2, 1]);
    assert_eq!([floor.two_sided, lid.two_sided], [false, true]);
}

#[test]
fn an_exitance_is_pi_times_the_radiance() {
    let scene = everything();
    assert_eq!(scene.surfaces[0].radiance, [0.5, 1.0]);
    assert_eq!(scene.surfaces[3].radiance, [3.0 / PI; 2]);
}

#[test]
fn there_are_two_kinds_of_lights() {
    let scene = everything();
    let position = Vector::new(0.0, 0.0, 2.0);
    assert_eq!(scene.lights[0].kind, LightKind::Point { position, intensity: vec![1.5, 1.5] });
    let direction = Vector::new(0.0, 0.6, -0.8);
    assert_eq!(scene.lights[1].kind, LightKind::Distant { direction, irradiance: vec![1000.0, 900.0] });
    assert_eq!([&*scene.lights[0].name, &*scene.lights[1].name], ["", "sun"]);
}

#[test]
fn there_are_five_kinds_of_receivers() {
    let scene = everything();
    let names: Vec<&str> = scene.receivers.iter().map(|receiver| &*receiver.name).collect();
    assert_eq!(names, ["here", "map", "beam", "eye", "all around"]);
    let point = Vector::new(0.0, 0.0, 1.0);
    let ReceiverKind::Point { normal, .. } = scene.receivers[0].kind else { panic!("here is a point") };
    assert_eq!(normal, Vector::new(0.0, 0.0, -1.0));
    assert_eq!(
        scene.receivers[1].kind,
        ReceiverKind::Surface { surface: 0, side: SurfaceSide::Front, grid: Some([64, 32]) }
    );
    let direction = Vector::new(0.0, 1.0, 0.0);
    assert_eq!(scene.receivers[2].kind, ReceiverKind::Ray { origin: point, direction });
    let ReceiverKind::Camera(camera) = &scene.receivers[3].kind else { panic!("the eye is a camera") };
    assert_eq!(camera.resolution, [8, 6]);
    assert_eq!(scene.receivers[4].kind, ReceiverKind::Sphere { position: point });
    let time = scene.receivers[4].time.as_ref().unwrap();
    assert_eq!((time.start, time.width, time.bins), (0.0, 1e-9, 100));
}

#[test]
fn every_element_knows_where_it_was_said() {
    let scene = everything();
    let line = |place: &forms_radiometry::scene::Place| place.position().map(|(_, line, _)| line);
    assert_eq!(line(&scene.media[1].place), Some(13));
    assert_eq!(line(&scene.materials[2].place), Some(26));
    assert_eq!(line(&scene.surfaces[2].place), Some(47));
    assert_eq!(line(&scene.lights[1].place), Some(61));
    assert_eq!(line(&scene.receivers[4].place), Some(90));
}

/// Elements that are not simulated, each with its line.
const REFUSED: &[(usize, &str)] = &[(
    47,
    "light from point or distant lights that the curved surface `ball` reflects or refracts is not supported",
)];

/// Effects as a file can force them.
const FORCED: &[&str] = &[
    "direct = \"on\", occlusion = \"on\", bands = \"on\", mirror = \"on\", scattering = 2",
    "mirror = \"off\", absorption = \"off\", refraction = \"off\", dispersion = \"off\", time = \"off\"",
    "direct = \"off\", occlusion = \"off\", bands = \"off\", interreflection = \"off\"",
    "interreflection = 1",
];

#[test]
fn every_effect_can_be_forced() {
    for effects in FORCED {
        let scene = scene(&format!("[solve]\neffects = {{ {effects} }}\n"), "forced.toml");
        assert_eq!(not_simulated(&scene), [], "{effects}");
    }
}

#[test]
fn what_is_not_simulated_is_refused_with_its_place_and_the_rest_is_not() {
    let scene = everything();
    let refused = not_simulated(&scene);
    let told: Vec<(usize, &str)> = refused.iter().map(|error| (error.line, &*error.message)).collect();
    assert_eq!(told, REFUSED, "{}", shown(&refused));
    assert_eq!(plan(&scene).unwrap_err(), refused);
}
