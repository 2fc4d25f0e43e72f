//! Media: `<medium>` becomes coefficients; with the index that a boundary gives it, a medium of the model. What
//! shapes and sensors say of their surroundings becomes the ambient medium.

use super::{Node, Reader};
use crate::scene::model::Medium;
use crate::scene::value::{FRACTION, MEAN_COSINE, NOT_NEGATIVE};
use std::collections::HashMap;
use std::ops::Range;

/// The index of a medium: that of a boundary, or the one of what surrounds the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Index {
    /// By the bits of the number.
    Given(u64),
    Surrounding,
}

/// The media so far, and what is said of the surroundings.
#[derive(Default)]
pub(super) struct Media<'a> {
    /// Elements that were read, by their numbers in the document.
    read: HashMap<usize, Coefficients>,
    /// The media of the scene by what they are made of.
    indices: HashMap<(Option<usize>, Index), usize>,
    list: Vec<Medium>,
    /// What lies around shapes and sensors: an element, or vacuum.
    around: Vec<(Option<Node<'a>>, Range<usize>)>,
    /// The index around shapes.
    around_index: Vec<(f64, Range<usize>)>,
}

#[derive(Clone, Debug)]
struct Coefficients {
    name: String,
    absorption: Vec<f64>,
    scattering: Vec<f64>,
    asymmetry: Vec<f64>,
}

impl<'a> Reader<'a, '_, '_> {
    /// Reads a `<medium>`, once however often it is referred to; its number in the document.
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
            self.unknown(&object, &["homogeneous"]);
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
        let asymmetry = object.take_tag("phase").map_or(0.0, |phase| self.phase(phase));
        object.ignore(&["sample_emitters"]);
        self.finish(object, &["albedo", "sigma_t", "scale", "phase"]);
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

    /// The mean cosine of a phase function.
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
                self.unknown(&object, &["isotropic", "hg"]);
                0.0
            }
        }
    }

    /// The medium of the scene that an element is with an index; without an element, a clear one.
    pub(super) fn filled(&mut self, node: Option<Node<'a>>, index: Index, place: Range<usize>) -> usize {
        let key = node.map(|node| self.medium(node));
        let next = self.media.list.len();
        let found = *self.media.indices.entry((key, index)).or_insert(next);
        if found == next {
            let n = match index {
                Index::Given(bits) => f64::from_bits(bits),
                Index::Surrounding => 1.0,
            };
            let clear = Coefficients {
                name: format!("clear medium of index {n}"),
                absorption: vec![0.0; self.bands],
                scattering: vec![0.0; self.bands],
                asymmetry: vec![0.0; self.bands],
            };
            let Coefficients { name, absorption, scattering, asymmetry } =
                key.and_then(|key| self.media.read.get(&key).cloned()).unwrap_or(clear);
            let place = self.report.place(place);
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

    /// Notes what lies around a shape or a sensor.
    pub(super) fn surrounded_by(&mut self, node: Option<Node<'a>>, place: Range<usize>) {
        self.media.around.push((node, place));
    }

    /// Notes the index around a shape.
    pub(super) fn surrounded_by_index(&mut self, n: f64, place: Range<usize>) {
        self.media.around_index.push((n, place));
    }

    /// Whether there is a medium that does anything on the way of light.
    pub(super) fn has_media(&self) -> bool {
        let acts =
            |medium: &Medium| medium.absorption.iter().chain(&medium.scattering).any(|&sigma| sigma > 0.0);
        self.media.list.iter().any(acts)
    }

    /// The media of the scene, and which of them is the ambient one. All that is said of the surroundings has to
    /// agree.
    pub(super) fn fill(&mut self) -> (Vec<Medium>, Option<usize>) {
        let n = self.media.around_index.first().map_or(1.0, |(n, _)| *n);
        for (other, place) in std::mem::take(&mut self.media.around_index) {
            if other != n {
                let message =
                    format!("the index {other} around this boundary is not {n}, as around the first one");
                self.report.error(place, message, "one index around all boundaries, as `ext_ior`");
            }
        }
        let around = std::mem::take(&mut self.media.around);
        let (first, place) = around.first().cloned().unwrap_or((None, 0..0));
        for (_, place) in around.into_iter().filter(|(other, _)| *other != first) {
            let message = "what surrounds this is not what surrounds the first sensor or boundary";
            self.report.error(place, message, "one medium around all sensors and boundaries, as `exterior`");
        }
        let ambient = if first.is_some() || n != 1.0 {
            Some(self.filled(first, Index::Surrounding, place))
        } else {
            None
        };
        for (&(_, index), &medium) in &self.media.indices {
            if index == Index::Surrounding {
                self.media.list[medium].index = vec![n; self.bands];
            }
        }
        (std::mem::take(&mut self.media.list), ambient)
    }
}
