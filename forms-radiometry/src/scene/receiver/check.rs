//! Checks of receivers against the shapes of their surfaces, after a scene was read without errors.

use crate::geometry::{Flat, common_area, off_plane};
use crate::scene::error::Report;
use crate::scene::model::{ReceiverKind, Scene, Shape, SurfaceSide};
use std::cell::OnceCell;

/// Part of a side that other surfaces cover, above which all of it is covered.
const COVERED: f64 = 1.0 - 1e-6;

/// Reports receivers of faces on surfaces without faces, and receivers on sides that see nothing.
pub(in crate::scene) fn check(report: &mut Report, scene: &Scene) {
    let working = OnceCell::new();
    for receiver in &scene.receivers {
        let (ReceiverKind::Surface { surface, side, .. } | ReceiverKind::Faces { surface, side }) =
            receiver.kind
        else {
            continue;
        };
        let name = &scene.surfaces[surface].name;
        if matches!(receiver.kind, ReceiverKind::Faces { .. })
            && scene.surfaces[surface].shape.face_count() == 0
        {
            let message = format!("`{name}` has no faces: it is neither a polygon nor a mesh");
            let expected =
                "kind = \"surface\", which measures the surface as a whole, and a disk also with `grid`";
            report.error_at(&receiver.place, message, expected);
        }
        if side == SurfaceSide::Back
            && let Some(cover) = cover(working.get_or_init(|| scene.in_working_units().scene), surface)
        {
            let message = format!("the back of `{name}` sees nothing: `{cover}` touches it back to back");
            report.error_at(&receiver.place, message, "side = \"front\"");
        }
    }
}

/// Returns the name of a surface of a scene in working units that is in contact with the back of a
/// planar surface, if others cover that completely.
fn cover(scene: &Scene, surface: usize) -> Option<&str> {
    let own = flat(&scene.surfaces[surface].shape)?;
    let mut covers = Vec::new();
    for (index, other) in scene.surfaces.iter().enumerate().filter(|(index, _)| *index != surface) {
        let Some(flat) = flat(&other.shape) else { continue };
        let is_back_to_back = flat.normal().dot(own.normal()) < 0.0 && off_plane(&flat, &own).is_none();
        if is_back_to_back {
            covers.push((index, common_area(&own, &flat)));
        }
    }
    let covered: f64 = covers.iter().map(|(_, area)| area).sum();
    let (index, _) = covers.into_iter().max_by(|(_, a), (_, b)| a.total_cmp(b))?;
    (covered >= COVERED * own.area()).then(|| scene.surfaces[index].name.as_str())
}

fn flat(shape: &Shape) -> Option<Flat> {
    match shape {
        Shape::Polygon(polygon) => Some(Flat::Polygon(polygon.clone())),
        Shape::Disk(disk) => Some(Flat::Disk(*disk)),
        _ => None,
    }
}
