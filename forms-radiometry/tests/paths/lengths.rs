//! A scene has the same answers at any size, in any place and in any unit of length.

use crate::claims::{self, Claim, Compared, answers};
use crate::{DEVIATIONS, SEED};
use forms_radiometry::geometry::{Disk, Polygon, Sphere, Vector};
use forms_radiometry::scene::{LengthUnit, LightKind, ReceiverKind, Scene, Shape};
use forms_radiometry::simulation::Quantity;

/// Tolerance of all scenes: a wrong use of lengths makes answers wrong by more.
const TOLERANCE: f64 = 0.2;

/// Change of a scene: its coordinates are multiplied and moved, and a length of 1 in it becomes
/// `metres`.
#[derive(Clone, Copy)]
struct Change {
    lengths: f64,
    moved: Vector,
    metres: f64,
    unit: LengthUnit,
}

impl Change {
    fn size(lengths: f64) -> Self {
        Self { lengths, moved: Vector::default(), metres: lengths, unit: LengthUnit::Metre }
    }

    fn by(moved: Vector) -> Self {
        Self { moved, ..Self::size(1.0) }
    }

    fn unit(unit: LengthUnit, lengths: f64) -> Self {
        Self { lengths, metres: 1.0, unit, ..Self::size(1.0) }
    }

    fn place(&self, point: Vector) -> Vector {
        self.lengths * point + self.moved
    }

    fn shape(&self, shape: &Shape) -> Shape {
        match *shape {
            Shape::Polygon(ref polygon) => {
                let vertices = polygon.vertices().iter().map(|&vertex| self.place(vertex)).collect();
                Shape::Polygon(Polygon::new(vertices).expect("the polygon stays one"))
            }
            Shape::Sphere(Sphere { center, radius, inward }) => {
                Shape::Sphere(Sphere { center: self.place(center), radius: self.lengths * radius, inward })
            }
            Shape::Disk(Disk { center, normal, radius, hole }) => {
                let [radius, hole] = [radius, hole].map(|length| self.lengths * length);
                Shape::Disk(Disk { center: self.place(center), normal, radius, hole })
            }
            Shape::Mesh(_) | Shape::Quadric(_) => panic!("no claim has a mesh or a quadric"),
        }
    }

    /// Returns the scene after the change, with lights and times that leave its answers unchanged
    /// except for fluxes.
    fn of(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        scene.unit = self.unit;
        for surface in &mut scene.surfaces {
            surface.shape = self.shape(&surface.shape);
        }
        for medium in &mut scene.media {
            let coefficients = medium.absorption.iter_mut().chain(&mut medium.scattering);
            coefficients.for_each(|coefficient| *coefficient /= self.lengths);
        }
        for light in &mut scene.lights {
            if let LightKind::Point { position, intensity } = &mut light.kind {
                *position = self.place(*position);
                intensity.iter_mut().for_each(|intensity| *intensity *= self.metres * self.metres);
            }
        }
        for receiver in &mut scene.receivers {
            match &mut receiver.kind {
                ReceiverKind::Point { position, .. } | ReceiverKind::Sphere { position } => {
                    *position = self.place(*position);
                }
                ReceiverKind::Ray { origin, .. } => *origin = self.place(*origin),
                ReceiverKind::Camera(camera) => camera.origin = self.place(camera.origin),
                ReceiverKind::Points(points) => {
                    points.positions.iter_mut().for_each(|position| *position = self.place(*position));
                }
                ReceiverKind::Surface { .. } | ReceiverKind::Faces { .. } => {}
            }
            if let Some(time) = &mut receiver.time {
                time.start *= self.metres;
                time.width *= self.metres;
            }
        }
        scene
    }

    /// Returns the wrong answers of a claim after the change.
    fn wrong(&self, what: &str, claim: &Claim) -> Vec<String> {
        let mut scene = self.of(&claim.scene());
        (scene.solve.seed, scene.solve.tolerance) = (SEED, TOLERANCE);
        let mut answers = answers(claim.name, &scene);
        for answer in answers.iter_mut().filter(|answer| answer.quantity == Quantity::Flux) {
            answer.value /= self.metres * self.metres;
            answer.error /= self.metres * self.metres;
        }
        let is_wrong = |compared: &Compared| compared.deviations(1e-8).is_some_and(|off| off > DEVIATIONS);
        let compared = claim.beside(&answers);
        let wrong = compared.iter().filter(|compared| is_wrong(compared));
        wrong.map(|compared| format!("{} {what}: {compared:?}", claim.name)).collect()
    }
}

fn check(what: &str, change: Change) {
    let claims = claims::all();
    // without the claims that take long
    let short = claims.iter().filter(|claim| claim.tolerance <= 0.05);
    let wrong: Vec<String> = short.flat_map(|claim| change.wrong(what, claim)).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn answers_do_not_depend_on_the_size_of_a_scene() {
    check("× 1e100", Change::size(1e100));
    check("× 1e-100", Change::size(1e-100));
}

#[test]
fn answers_do_not_depend_on_where_a_scene_is() {
    check("moved", Change::by(Vector::new(1e6, -1e6, 2e6)));
}

#[test]
fn answers_do_not_depend_on_the_unit_of_lengths() {
    check("in centimetres", Change::unit(LengthUnit::Centimetre, 1e2));
    check("in millimetres", Change::unit(LengthUnit::Millimetre, 1e3));
}
