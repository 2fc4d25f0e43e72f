//! Media: parses `<medium>` into coefficients; together with the index from a boundary, they form a
//! medium of the model.

use super::{Node, Reader};
use crate::scene::element::unique;
use crate::scene::model::Medium;
use crate::scene::value::{COEFFICIENT, FRACTION, MEAN_COSINE, NOT_NEGATIVE};
use std::collections::HashMap;
use std::ops::Range;

/// Source of the refractive index of a medium.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Index {
    /// Index from a boundary, as the bits of the number.
    Given(u64),
    /// The same index as in front of its boundary.
    OfFront,
    /// Index of the ambient medium.
    Ambient,
}

/// The media so far.
#[derive(Default)]
pub(super) struct Media {
    /// The parsed elements, by their numbers in the document.
    read: HashMap<usize, Coefficients>,
    /// The media of the scene, by element and index.
    indices: HashMap<(Option<usize>, Index), usize>,
    list: Vec<Medium>,
    /// The element of each medium, by its number in the document.
    pub(super) elements: Vec<Option<usize>>,
}

#[derive(Clone, Debug)]
struct Coefficients {
    name: String,
    absorption: Vec<f64>,
    scattering: Vec<f64>,
    asymmetry: Vec<f64>,
}

impl<'a> Reader<'a, '_, '_> {
    /// Parses a `<medium>`, only once even if it is referenced several times, and returns its
    /// number in the document.
    pub(super) fn medium(&mut self, node: Node<'a>) -> usize {
        let key = node.id().get_usize();
        if !self.media.read.contains_key(&key) {
            let coefficients = self.coefficients(node);
            self.media.read.insert(key, coefficients);
        }
        key
    }

    /// σₛ = α σₜ and σₐ = (1 − α) σₜ, both times the scale.
    fn coefficients(&mut self, node: Node<'a>) -> Coefficients {
        let mut object = self.object(node);
        let count = self.media.read.len();
        let name = self.name(&object, "medium", count);
        let nothing = vec![0.0; self.bands];
        if object.kind != "homogeneous" {
            self.unknown(&mut object, &["homogeneous"]);
            return Coefficients {
                name,
                absorption: nothing.clone(),
                scattering: nothing.clone(),
                asymmetry: nothing,
            };
        }
        let or = |value: Option<Vec<f64>>, default: f64, bands: usize| {
            value.unwrap_or_else(|| vec![default; bands])
        };
        let albedo = or(self.colour(&mut object, "albedo", &FRACTION), 0.75, self.bands);
        let extinction = or(self.colour(&mut object, "sigma_t", &NOT_NEGATIVE), 1.0, self.bands);
        let scale = self.float(&mut object, "scale", 1.0, &NOT_NEGATIVE);
        let asymmetry = self.take_object(&mut object, "phase").map_or(0.0, |phase| self.phase(phase));
        object.ignore(&["sample_emitters"]);
        self.finish(object, &["albedo", "sigma_t", "scale", "phase"]);
        let is_in_range = |&value: &f64| {
            (COEFFICIENT.contains)(value * scale)
                && albedo.iter().all(|albedo| (COEFFICIENT.contains)(albedo * value * scale))
        };
        if !extinction.iter().all(is_in_range) {
            self.error(node, "the coefficients of this medium are out of range", COEFFICIENT.expected);
        }
        let product = |share: fn(f64) -> f64| {
            albedo.iter().zip(&extinction).map(|(&albedo, sigma)| share(albedo) * sigma * scale).collect()
        };
        Coefficients {
            name,
            absorption: product(|albedo| 1.0 - albedo),
            scattering: product(|albedo| albedo),
            asymmetry: vec![asymmetry; self.bands],
        }
    }

    /// Returns the mean cosine of a phase function.
    fn phase(&mut self, node: Node<'a>) -> f64 {
        let mut object = self.object(node);
        match &*object.kind {
            "isotropic" => {
                self.finish(object, &[]);
                0.0
            }
            "hg" => {
                let g = self.float(&mut object, "g", 0.8, &MEAN_COSINE);
                self.finish(object, &["g"]);
                g
            }
            _ => {
                self.unknown(&mut object, &["isotropic", "hg"]);
                0.0
            }
        }
    }

    /// Returns the medium of the scene for an element and an index; without an element, a clear
    /// medium.
    pub(super) fn filled(&mut self, key: Option<usize>, index: Index, place: Range<usize>) -> usize {
        let next = self.media.list.len();
        let found = *self.media.indices.entry((key, index)).or_insert(next);
        if found == next {
            let n = match index {
                Index::Given(bits) => f64::from_bits(bits),
                Index::OfFront | Index::Ambient => 1.0,
            };
            let clear = Coefficients {
                name: match index {
                    Index::Given(_) => format!("clear medium of index {n}"),
                    Index::OfFront | Index::Ambient => "ambient medium".to_owned(),
                },
                absorption: vec![0.0; self.bands],
                scattering: vec![0.0; self.bands],
                asymmetry: vec![0.0; self.bands],
            };
            let Coefficients { name, absorption, scattering, asymmetry } =
                key.and_then(|key| self.media.read.get(&key).cloned()).unwrap_or(clear);
            let name = unique(&name, |taken| self.media.list.iter().any(|medium| medium.name == taken));
            let place = self.report.place(place);
            self.media.elements.push(key);
            self.media.list.push(Medium {
                name,
                absorption,
                scattering,
                asymmetry,
                index: vec![n; self.bands],
                place,
            });
        }
        found
    }

    /// Whether there is a medium that absorbs or scatters.
    pub(super) fn has_media(&self) -> bool {
        let acts =
            |medium: &Medium| medium.absorption.iter().chain(&medium.scattering).any(|&sigma| sigma > 0.0);
        self.media.list.iter().any(acts)
    }

    /// Returns the media of the scene, and the element of each.
    pub(super) fn all_media(&mut self) -> (Vec<Medium>, Vec<Option<usize>>) {
        (std::mem::take(&mut self.media.list), std::mem::take(&mut self.media.elements))
    }
}
