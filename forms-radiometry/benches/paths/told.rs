//! Input of the script for a work: the numbers of the scene and of its receiver, and the reference
//! values, as JSON.

use crate::work::Work;
use forms_radiometry::geometry::Vector;
use forms_radiometry::scene::{MaterialKind, ReceiverKind, Scene, Surface};
use serde_json::{Value, json};
use std::io;
use std::path::Path;

/// Writes a work into a directory.
pub(crate) fn write(work: &Work, reference: &[f64], folder: &Path) -> io::Result<()> {
    let surface = |surface: &Surface| of_surface(&work.scene, surface);
    let medium = work.scene.ambient.medium.map(|medium| &work.scene.media[medium]);
    let all = json!({
        "target": work.target,
        "surfaces": work.scene.surfaces.iter().map(surface).collect::<Vec<_>>(),
        "medium": medium.map(|medium| json!({"absorption": medium.absorption[0], "scattering": medium.scattering[0]})),
        "receiver": of_receiver(&work.scene.receivers[0].kind),
        "known": work.known(),
        "reference": reference,
    });
    std::fs::write(folder.join(format!("{}.json", work.name)), all.to_string())
}

fn of_surface(scene: &Scene, surface: &Surface) -> Value {
    let polygon = surface.shape.as_polygon().expect("these scenes are made of polygons");
    let (reflectance, is_mirror) = match &scene.materials[surface.material].kind {
        MaterialKind::Diffuse { reflectance } => (reflectance[0], false),
        MaterialKind::Mirror { reflectance } => (reflectance[0], true),
        _ => panic!("these scenes are made of diffuse surfaces and mirrors"),
    };
    json!({
        "name": surface.name,
        "polygon": polygon.vertices().iter().map(|&vertex| of(vertex)).collect::<Vec<_>>(),
        "reflectance": reflectance,
        "is_mirror": is_mirror,
        "radiance": surface.radiance[0],
    })
}

fn of_receiver(kind: &ReceiverKind) -> Value {
    match kind {
        ReceiverKind::Point { position, normal } => json!({"origin": of(*position), "normal": of(*normal)}),
        ReceiverKind::Ray { origin, direction } => {
            json!({"origin": of(*origin), "direction": of(*direction)})
        }
        ReceiverKind::Camera(camera) => {
            let [width, height] = camera.resolution.map(|side| side as f64);
            json!({
                "origin": of(camera.origin),
                "middle": of(camera.direction(0.5 * width, 0.5 * height)),
                "top": of(camera.direction(0.5 * width, 0.0)),
                "resolution": camera.resolution,
            })
        }
        ReceiverKind::Points(_)
        | ReceiverKind::Surface { .. }
        | ReceiverKind::Faces { .. }
        | ReceiverKind::Sphere { .. } => panic!("no work asks for that"),
    }
}

fn of(vector: Vector) -> [f64; 3] {
    [vector.x, vector.y, vector.z]
}
