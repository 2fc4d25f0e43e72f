//! View: the visible parts of all faces from an eye become convex pieces, and the radiance from
//! points of these pieces towards the eye is computed.
//!
//! ```text
//! faces, elements ─ visible from the eye ─▶ pieces ─ points ─▶ L = Lₑ + ρ/π (D + reflected light)
//! ```
//! Pieces are exact, and contain no shadow border of a point or distant light. D, the direct light
//! at a point, is exact too. The light reflected to the point is either gathered as for a receiver,
//! or taken from the polynomials of the element on which the point lies, which is fast.

use super::contact::{self, ConvexPiece};
use super::element::Element;
use super::gathered_light::Kinds;
use super::measure::Measure;
use super::reflectance::{is_reflecting, reflectance, reflects};
use super::shadows::Shadows;
use super::system::Radiosity;
use super::transport::{Group, Scratch, Transport};
use crate::faces::{emits, emitted, is_bright};
use crate::geometry::{Vector, closeness};
use crate::parallelism::Parallelism;
use crate::visibility::{Face, ReceivingArea};
use std::f64::consts::PI;

/// A convex piece of a face that an eye sees.
pub(crate) struct SeenPiece {
    face: usize,
    /// The element that it is a part of, if reflections are simulated.
    element: Option<usize>,
    /// The unit normal of its face.
    pub(crate) normal: Vector,
    /// The vectors from the eye to its corners.
    pub(crate) outline: Vec<Vector>,
}

/// Method for the light reflected to a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reflected {
    /// Gathered from all elements, as for receivers.
    Gathered,
    /// Interpolated by the polynomials of the point's own element.
    Interpolated,
}

impl SeenPiece {
    /// Whether the light reflected to the piece can be taken from polynomials.
    pub(crate) fn has_polynomials(&self) -> bool {
        self.element.is_some()
    }
}

impl Transport {
    /// Returns the pieces that an eye sees of the outline of a face, or of an element of it.
    fn seen_from(
        &self,
        eye: Vector,
        (face, element): (usize, Option<usize>),
        outline: &[Vector],
        scratch: &mut Scratch,
    ) -> Vec<SeenPiece> {
        let points = [eye];
        let group = Group { points: &points, outline: &points, measure: Measure::Sphere };
        let normal = self.faces[face].normal;
        let mut pieces = Vec::new();
        self.see(group, (outline, normal), scratch, |_, piece| {
            pieces.push(SeenPiece { face, element, normal, outline: piece.to_vec() });
        });
        pieces
    }
}

impl Radiosity<'_> {
    /// Returns the pieces that an eye sees: of all faces with `all`, otherwise only of faces that
    /// send light. `sight` is the geometry with all occluders.
    pub(crate) fn seen_from(&self, eye: Vector, sight: &Transport, all: bool) -> Vec<SeenPiece> {
        let faces = &self.transport.faces;
        let sends = |index: usize| {
            let face = &faces[index];
            emits(self.scene, face) || is_reflecting(self.scene, face)
        };
        let mut has_elements = vec![false; faces.len()];
        let mut targets: Vec<(usize, Option<usize>, &[Vector])> = Vec::new();
        for (index, element) in self.sources() {
            has_elements[element.face] = true;
            targets.push((element.face, Some(index), &self.outlines[index]));
        }
        let parts = self.parts_in_shadows();
        for index in (0..faces.len()).filter(|&index| !has_elements[index] && (all || sends(index))) {
            let whole = parts[index].is_empty().then_some(&faces[index].vertices[..]);
            let outlines = parts[index].iter().map(|part| &part.outline[..]).chain(whole);
            targets.extend(outlines.map(|outline| (index, None, outline)));
        }
        let of_target =
            |scratch: &mut Scratch, (face, element, outline): (usize, Option<usize>, &[Vector])| {
                if self.watch.is_stopped() {
                    Vec::new()
                } else {
                    sight.seen_from(eye, (face, element), outline, scratch)
                }
            };
        let parallelism = Parallelism::of(sight.operations(1, 4 * targets.len()));
        parallelism.map(targets, of_target).into_iter().flatten().collect()
    }

    /// Returns for each face the parts without a shadow border of a point or distant light, if
    /// there are no elements that are cut so.
    fn parts_in_shadows(&self) -> Vec<Vec<ConvexPiece>> {
        let faces = &self.transport.faces;
        if self.question.orders != Some(0) || self.scene.lights.is_empty() {
            return faces.iter().map(|_| Vec::new()).collect();
        }
        let reflects = |face: &Face| is_reflecting(self.scene, face);
        let shadows = Shadows::of(self.scene, self.transport, reflects, self.watch);
        let closeness = closeness(faces.iter().flat_map(|face| &face.vertices).copied());
        contact::pieces(faces, closeness, reflects, |index, face| shadows.borders(index, face, closeness))
    }

    /// Gathers the light that reaches points of a surface that is seen, including direct light.
    pub(crate) fn gather_seen(&self, group: Group, scratch: &mut Scratch, gathered: &mut [f64]) {
        let kinds = Kinds::of(self.question.seen_kinds(self.lights.kinds()));
        self.gather_kinds(kinds, group, scratch, gathered);
    }

    /// Returns the number of bands.
    pub(crate) fn band_count(&self) -> usize {
        self.scene.band_count()
    }

    /// Whether light counts that receivers get straight from a light source.
    pub(crate) fn counts_direct(&self) -> bool {
        self.question.direct
    }

    /// Returns the radiance that an eye gets from a piece in each band as from a light source; empty
    /// if there is none.
    pub(crate) fn emitted(&self, piece: &SeenPiece) -> &[f64] {
        match self.counts_direct() {
            true => emitted(self.scene, &self.transport.faces[piece.face]),
            false => &[],
        }
    }

    /// Computes the radiance of points of a piece, point by point and band by band; the outline
    /// contains the points.
    pub(crate) fn radiance(
        &self,
        piece: &SeenPiece,
        [points, outline]: [&[Vector]; 2],
        reflected: Reflected,
        scratch: &mut Scratch,
        radiance: &mut [f64],
    ) {
        let face = &self.transport.faces[piece.face];
        if !is_bright(self.scene, face) {
            radiance.fill(0.0);
            return;
        }
        let emitted = &self.scene.surfaces[face.surface].radiance;
        let bands = emitted.len();
        let seen = self.question.seen_part();
        if !reflects(self.scene, face.surface) {
            let emitted = emitted.iter().map(|emitted| seen * emitted).cycle();
            radiance.iter_mut().zip(emitted).for_each(|(value, emitted)| *value = emitted);
            return;
        }
        let group = Group { points, outline, measure: Measure::Plane(piece.normal) };
        match piece.element.filter(|_| reflected == Reflected::Interpolated) {
            Some(element) => self.gather_on(element, group, scratch, radiance),
            None => self.gather_seen(group, scratch, radiance),
        }
        let reflectances = reflectance(self.scene, face.surface);
        for of_point in radiance.chunks_exact_mut(bands) {
            for ((value, emitted), rho) in of_point.iter_mut().zip(emitted).zip(reflectances) {
                *value = seen * emitted + rho / PI * *value;
            }
        }
    }

    /// Computes the irradiance of points of an element: D exactly, the remainder by its
    /// polynomials.
    fn gather_on(&self, element: usize, group: Group, scratch: &mut Scratch, gathered: &mut [f64]) {
        let bands = self.scene.band_count();
        gathered.fill(0.0);
        self.lights.gather(group, self.transport, scratch, gathered);
        for (&point, of_point) in group.points.iter().zip(gathered.chunks_exact_mut(bands)) {
            self.add_reflected_on(element, point, of_point);
        }
    }

    /// Adds the light reflected to a point of an element, by its polynomials.
    fn add_reflected_on(&self, element: usize, point: Vector, sums: &mut [f64]) {
        let nodes = self.first[element]..self.first[element + 1];
        let basis = self.elements[element].basis(point);
        for (sum, (all, direct)) in sums.iter_mut().zip(self.irradiance.iter().zip(&self.direct)) {
            let nodes = basis.iter().zip(all[nodes.clone()].iter().zip(&direct[nodes.clone()]));
            *sum += nodes.map(|(b, (all, direct))| b * (all - direct)).sum::<f64>();
        }
    }

    /// Returns the elements of an area.
    pub(crate) fn elements_on(&self, area: ReceivingArea) -> Vec<usize> {
        let is_on = |element: &Element| area.contains(&self.transport.faces[element.face]);
        (0..self.elements.len()).filter(|&element| is_on(&self.elements[element])).collect()
    }

    /// Adds the light reflected to a point, by the polynomials of the one of these elements on
    /// which the point lies.
    pub(crate) fn add_polynomial(&self, elements: &[usize], point: Vector, sums: &mut [f64]) {
        if let Some(&element) = elements.iter().find(|&&element| self.elements[element].contains(point)) {
            self.add_reflected_on(element, point, sums);
        }
    }
}
