//! Surroundings: in Mitsuba every boundary declares its exterior medium, and every sensor its own
//! medium. In the model, surfaces divide space and the remainder is the ambient medium. The
//! declarations must agree with the model.

use super::media::Index;
use super::{Node, Reader};
use crate::scene::error::Report;
use crate::scene::model::Scene;
use crate::scene::place::Place;
use crate::scene::regions::{Filling, Front};
use std::ops::Range;

/// A boundary's declaration of its exterior.
struct Boundary {
    /// The index of its surface, and of the medium behind it.
    surface: usize,
    inside: usize,
    /// The refractive index outside and the place of its declaration; `None` if the index is the
    /// same on both sides.
    n: Option<(f64, Place)>,
    /// The number of the exterior element; `None` for a clear medium.
    exterior: Option<usize>,
    place: Place,
}

/// The declarations of a scene about the exterior of its boundaries and the media of its sensors.
#[derive(Default)]
pub(in crate::scene) struct Surroundings {
    boundaries: Vec<Boundary>,
    /// The element of the medium that contains each sensor.
    sensors: Vec<(Option<usize>, Place)>,
    /// The element of each medium.
    elements: Vec<Option<usize>>,
}

impl<'a> Reader<'a, '_, '_> {
    /// Records the declaration of a boundary, before its surface is added.
    pub(super) fn boundary(
        &mut self,
        node: Node<'a>,
        inside: usize,
        n: Option<(f64, Range<usize>)>,
        exterior: Option<usize>,
    ) {
        let n = n.map(|(n, place)| (n, self.report.place(place)));
        let (surface, place) = (self.surfaces.len(), self.report.place(node.range()));
        self.surroundings.boundaries.push(Boundary { surface, inside, n, exterior, place });
    }

    /// Records the medium of a sensor.
    pub(super) fn sensor_in(&mut self, node: Node<'a>, medium: Option<usize>) {
        let place = self.report.place(node.range());
        self.surroundings.sensors.push((medium, place));
    }

    /// Returns the ambient medium: the medium of the first sensor, or else the exterior of the
    /// first boundary that declares one. Its refractive index is not known until the regions are.
    pub(super) fn ambient_medium(&mut self) -> Option<usize> {
        let Surroundings { boundaries, sensors, .. } = &self.surroundings;
        if boundaries.is_empty() && sensors.iter().all(|(medium, _)| medium.is_none()) {
            return None;
        }
        let of_boundaries = || boundaries.iter().find_map(|boundary| boundary.exterior);
        let element = sensors.first().map_or_else(of_boundaries, |(medium, _)| *medium);
        Some(self.filled(element, Index::Ambient, 0..0))
    }

    /// Returns the recorded declarations, with the elements of the media.
    pub(super) fn all_surroundings(&mut self, elements: Vec<Option<usize>>) -> Surroundings {
        Surroundings { elements, ..std::mem::take(&mut self.surroundings) }
    }
}

impl Surroundings {
    /// Compares the declarations with the medium in front of each boundary, and sets the refractive
    /// indices of the media.
    pub(in crate::scene) fn settle(self, report: &mut Report, scene: &mut Scene, fronts: &[Front]) {
        let Some(ambient) = scene.ambient.medium else { return };
        for (medium, place) in &self.sensors {
            if *medium != self.elements[ambient] {
                let message =
                    format!("this sensor is not in the ambient medium `{}`", scene.media[ambient].name);
                report.error_at(place, message, "the medium of the first sensor");
            }
        }
        let pairs: Vec<(&Boundary, usize)> = fronts
            .iter()
            .filter_map(|front| {
                let boundary = self.boundaries.iter().find(|boundary| boundary.surface == front.surface)?;
                Some((boundary, front.filling?))
            })
            .collect();
        self.ambient_index(report, scene, ambient, &pairs);
        self.indices_of_fronts(scene, &pairs);
        for (boundary, front) in &pairs {
            self.compare(report, scene, boundary, *front);
        }
        let is_nothing = self.elements[ambient].is_none() && scene.media[ambient].is_vacuum();
        if is_nothing && ambient + 1 == scene.media.len() {
            scene.media.pop();
            scene.ambient.medium = None;
        }
    }

    /// Sets the index of the ambient medium to the exterior index of the first boundary in it.
    fn ambient_index(
        &self,
        report: &mut Report,
        scene: &mut Scene,
        ambient: usize,
        pairs: &[(&Boundary, usize)],
    ) {
        let in_it = pairs.iter().filter(|(_, front)| *front == ambient);
        let mut said = in_it.filter_map(|(boundary, _)| boundary.n.as_ref());
        let Some((n, _)) = said.next() else { return };
        scene.media[ambient].index.fill(*n);
        for (other, place) in said.filter(|(other, _)| other != n) {
            let message = format!(
                "the exterior index {other} differs from the exterior index {n} of the first boundary \
                 in the ambient medium"
            );
            report.error_at(place, message, format!("{n}"));
        }
    }

    /// Sets the index behind each boundary without indices to the index in front of it, which can
    /// be behind another such boundary.
    fn indices_of_fronts(&self, scene: &mut Scene, pairs: &[(&Boundary, usize)]) {
        for _ in 0..pairs.len() {
            for (boundary, front) in pairs.iter().filter(|(boundary, _)| boundary.n.is_none()) {
                scene.media[boundary.inside].index = scene.media[*front].index.clone();
            }
        }
    }

    fn compare(&self, report: &mut Report, scene: &Scene, boundary: &Boundary, front: usize) {
        let (medium, name) = (&scene.media[front], &scene.surfaces[boundary.surface].name);
        if boundary.exterior != self.elements[front] {
            let message = format!(
                "the exterior medium of `{name}` is not `{}`, the medium in front of it",
                medium.name
            );
            report.error_at(&boundary.place, message, "the medium in front of the shape as `exterior`");
        }
        let own = boundary.n.as_ref().map_or(scene.media[boundary.inside].index[0], |(n, _)| *n);
        if front_differs(scene.ambient.medium, front, own, medium.index[0]) {
            let place = boundary.n.as_ref().map_or(&boundary.place, |(_, place)| place);
            let message =
                format!("the exterior index {own} of `{name}` is not the index of `{}`", medium.name);
            report.error_at(place, message, format!("{}", medium.index[0]));
        }
    }
}

/// Whether an index differs from the index of the medium in front. For the ambient medium this was
/// reported before.
fn front_differs(ambient: Filling, front: usize, own: f64, there: f64) -> bool {
    ambient != Some(front) && own != there
}
