//! Rough materials: parses the roughness of a `<bsdf>` into a distribution of microfacets.

use super::Reader;
use super::bsdf::Law;
use super::object::Object;
use crate::scene::microfacets::{Distribution, Microfacets};
use crate::scene::model::MaterialKind;
use crate::scene::rough::{Facet, Rough};
use crate::scene::value::Domain;

/// Mitsuba replaces smaller numbers by the least of these.
const ROUGHNESS: Domain =
    Domain { expected: "a number from 1e-4 to 1e4", contains: |alpha| (1e-4..=1e4).contains(&alpha) };
const DEFAULT: f64 = 0.1;

/// Returns the microfacets of a rough material. Like in Mitsuba, their distribution is Beckmann’s by
/// default.
pub(super) fn microfacets<'a>(reader: &mut Reader<'a, '_, '_>, object: &mut Object<'a>) -> Microfacets {
    let node = object.node;
    let distribution = match reader.string(object, "distribution") {
        None => Distribution::Beckmann,
        Some((name, place)) => match &*name.to_lowercase() {
            "beckmann" => Distribution::Beckmann,
            "ggx" => Distribution::Ggx,
            _ => {
                let message = format!("the distribution `{name}` of microfacets is not known");
                reader.report.error(place, message, "`beckmann` or `ggx`");
                Distribution::Beckmann
            }
        },
    };
    object.ignore(&["sample_visible"]);
    let along_axes = ["alpha_u", "alpha_v"].map(|name| object.has(name));
    let alpha = match along_axes {
        [false, false] => reader.float(object, "alpha", DEFAULT, &ROUGHNESS),
        _ => {
            let both = ["alpha_u", "alpha_v"].map(|name| reader.float(object, name, DEFAULT, &ROUGHNESS));
            if along_axes != [true; 2] || both[0] != both[1] {
                let message = "a roughness that differs between directions is not supported";
                reader.error(node, message, "`alpha`, or equal `alpha_u` and `alpha_v`");
            }
            both[0]
        }
    };
    Microfacets { distribution, alpha }
}

/// Returns the law of a rough metal or mirror.
pub(super) fn rough_metal(facets: Microfacets, facet: Facet, specular: Vec<f64>) -> Law {
    let (base, albedo) = (vec![0.0; specular.len()], specular.clone());
    Law::Opaque(MaterialKind::Rough(Rough { facets, facet, specular, base, albedo }))
}

/// Returns the law of a diffuse base, with this reflectance, below a rough coat of this relative index.
pub(super) fn rough_plastic(
    facets: Microfacets,
    index: f64,
    specular: Vec<f64>,
    base: Vec<f64>,
) -> MaterialKind {
    let (facet, albedo) = (Facet::Coat { index }, vec![1.0; base.len()]);
    MaterialKind::Rough(Rough { facets, facet, specular, base, albedo })
}
