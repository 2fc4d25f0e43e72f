//! Materials: parses `<bsdf>` into a law of reflection; a boundary of media becomes a material
//! together with the interior medium of a shape.

use super::checkerboard::{COLOURS, Checkerboard};
use super::metals::{METALS, Metal};
use super::microfacets::{microfacets, rough_metal, rough_plastic};
use super::object::Object;
use super::{Node, Reader};
use crate::scene::element::unique;
use crate::scene::microfacets::Microfacets;
use crate::scene::model::{Material, MaterialKind};
use crate::scene::rough::Facet;
use crate::scene::texture::Pattern;
use crate::scene::value::{FRACTION, NOT_NEGATIVE, POSITIVE, one_of};
use std::ops::Range;
use std::sync::Arc;

/// A parsed `<bsdf>`.
#[derive(Clone, Debug)]
pub(super) struct Bsdf {
    pub(super) law: Law,
    pub(super) two_sided: bool,
    name: String,
    key: usize,
    place: Range<usize>,
}

#[derive(Clone, Debug)]
pub(super) enum Law {
    /// A law that does not depend on the shape.
    Opaque(MaterialKind),
    /// A law whose reflectance depends on the place, with the largest reflectance of any place.
    Textured(MaterialKind, Arc<Pattern>),
    /// Diffuse reflection in two colours.
    Checkered(Checkerboard),
    /// A boundary between media of these indices.
    Dielectric { inside: f64, outside: f64, outside_place: Range<usize> },
    /// A boundary without a change of index.
    Null,
    /// An invalid law, which was reported.
    Wrong,
}

/// Identifies a material: its element, and the medium behind it or its colour on a checkerboard.
pub(super) type Key = (usize, Option<usize>);

/// The keys of the materials of shapes without a `<bsdf>`.
const DEFAULT_KEY: usize = usize::MAX;
const BLACK_KEY: usize = usize::MAX - 1;

/// Indices of refraction by name, as in Mitsuba’s table, whose source is Hecht, *Optics*, 4th
/// edition: at 589 nm and 0 to 20 °C.
const INDICES: [(&str, f64); 23] = [
    ("vacuum", 1.0),
    ("helium", 1.000_036),
    ("hydrogen", 1.000_132),
    ("air", 1.000_277),
    ("carbon dioxide", 1.000_45),
    ("water", 1.333),
    ("acetone", 1.36),
    ("ethanol", 1.361),
    ("carbon tetrachloride", 1.461),
    ("glycerol", 1.4729),
    ("benzene", 1.501),
    ("silicone oil", 1.520_45),
    ("bromine", 1.661),
    ("water ice", 1.31),
    ("fused quartz", 1.458),
    ("pyrex", 1.47),
    ("acrylic glass", 1.49),
    ("polypropylene", 1.49),
    ("bk7", 1.5046),
    ("sodium chloride", 1.544),
    ("amber", 1.55),
    ("pet", 1.575),
    ("diamond", 2.419),
];

const KINDS: [&str; 8] =
    ["diffuse", "conductor", "roughconductor", "plastic", "roughplastic", "dielectric", "twosided", "null"];
/// Properties of rough materials.
const ROUGHNESS: [&str; 4] = ["distribution", "alpha", "alpha_u", "alpha_v"];

impl Bsdf {
    /// Parses a `<bsdf>`, only once even if it is referenced several times.
    pub(super) fn read<'a>(reader: &mut Reader<'a, '_, '_>, node: Node<'a>) -> Self {
        let key = node.id().get_usize();
        if let Some(bsdf) = reader.bsdfs.get(&key) {
            return bsdf.clone();
        }
        let object = reader.object(node);
        let count = reader.bsdfs.len();
        let name = reader.name(&object, "material", count);
        let mut bsdf = Self { law: Law::Null, two_sided: false, name, key, place: node.range() };
        if object.kind == "twosided" {
            bsdf.two_sided = true;
            bsdf.law = two_sided(reader, object);
        } else {
            bsdf.law = one_sided(reader, object);
        }
        reader.bsdfs.insert(key, bsdf.clone());
        bsdf
    }

    /// Returns Mitsuba's default for a shape without a `<bsdf>`: grey, or black if the shape emits.
    pub(super) fn default(bands: usize, emits: bool, place: Range<usize>) -> Self {
        let (key, name, reflectance) =
            if emits { (BLACK_KEY, "black", 0.0) } else { (DEFAULT_KEY, "grey", 0.5) };
        let law = Law::Opaque(MaterialKind::Diffuse { reflectance: vec![reflectance; bands] });
        Self { law, two_sided: false, name: name.to_owned(), key, place }
    }

    /// Returns the index of the material for this `<bsdf>` with the medium behind it.
    pub(super) fn material(&self, reader: &mut Reader, kind: MaterialKind) -> usize {
        let inside = match kind {
            MaterialKind::Dielectric { inside } => Some(inside),
            _ => None,
        };
        self.known_material(reader, kind, inside, &self.name)
    }

    /// Returns the index of the material for a colour of a checkerboard.
    pub(super) fn material_of_colour(
        &self,
        reader: &mut Reader,
        board: &Checkerboard,
        colour: usize,
    ) -> usize {
        let kind = MaterialKind::Diffuse { reflectance: board.colours[colour].clone() };
        let name = format!("{}/{}", self.name, COLOURS[colour]);
        self.known_material(reader, kind, Some(colour), &name)
    }

    fn known_material(
        &self,
        reader: &mut Reader,
        kind: MaterialKind,
        part: Option<usize>,
        name: &str,
    ) -> usize {
        let next = reader.materials.len();
        let index = *reader.known_materials.entry((self.key, part)).or_insert(next);
        if index == next {
            let name = unique(name, |taken| reader.materials.iter().any(|material| material.name == taken));
            let place = reader.report.place(self.place.clone());
            reader.materials.push(Material { name, kind, place });
        }
        index
    }
}

/// Returns the law of the `<bsdf>` within a `twosided`, which can be neither `twosided` itself nor
/// a boundary of media.
fn two_sided<'a>(reader: &mut Reader<'a, '_, '_>, mut object: Object<'a>) -> Law {
    let node = object.node;
    let inner = reader.take_object(&mut object, "bsdf");
    reader.finish(object, &["bsdf"]);
    let Some(inner) = inner else {
        reader.error(node, "this bsdf of type `twosided` contains no bsdf", "one bsdf");
        return Law::Wrong;
    };
    let kind = reader.kind(inner);
    if matches!(&*kind, "dielectric" | "null" | "twosided") {
        let message = format!("a bsdf of type `{kind}` cannot be two-sided");
        reader.error(inner, message, "`diffuse`, `conductor`, `roughconductor`, `plastic` or `roughplastic`");
        return Law::Wrong;
    }
    Bsdf::read(reader, inner).law
}

fn one_sided<'a>(reader: &mut Reader<'a, '_, '_>, mut object: Object<'a>) -> Law {
    match &*object.kind {
        "diffuse" => diffuse(reader, object),
        "conductor" => conductor(reader, object, None),
        "roughconductor" => {
            let facets = microfacets(reader, &mut object);
            conductor(reader, object, Some(facets))
        }
        "dielectric" => {
            let (inside, _) = index(reader, &mut object, "int_ior", "bk7");
            let (outside, outside_place) = index(reader, &mut object, "ext_ior", "air");
            reader.finish(object, &["int_ior", "ext_ior"]);
            Law::Dielectric { inside, outside, outside_place }
        }
        "plastic" => plastic(reader, object, None),
        "roughplastic" => {
            let facets = microfacets(reader, &mut object);
            plastic(reader, object, Some(facets))
        }
        "null" => {
            reader.finish(object, &[]);
            Law::Null
        }
        _ => {
            reader.unknown(&mut object, &KINDS);
            Law::Wrong
        }
    }
}

/// Returns the law of diffuse reflection.
fn diffuse<'a>(reader: &mut Reader<'a, '_, '_>, mut object: Object<'a>) -> Law {
    if let Some(board) = reader.take_checkerboard(&mut object, "reflectance") {
        reader.finish(object, &["reflectance"]);
        return Law::Checkered(board);
    }
    let textured = reader.take_pattern(&mut object, "reflectance", 0.0);
    let grey = vec![0.5; reader.bands];
    let reflectance = reader.colour(&mut object, "reflectance", &FRACTION).unwrap_or(grey);
    reader.finish(object, &["reflectance"]);
    match textured {
        Some((pattern, most)) => Law::Textured(MaterialKind::Diffuse { reflectance: most }, pattern),
        None => Law::Opaque(MaterialKind::Diffuse { reflectance }),
    }
}

/// Returns the law of a metal with index η + ik, given by name or by numbers; without an index, or
/// with the material `none`, a perfect mirror. With microfacets, it is rough.
fn conductor<'a>(
    reader: &mut Reader<'a, '_, '_>,
    mut object: Object<'a>,
    facets: Option<Microfacets>,
) -> Law {
    let metal = named_metal(reader, &mut object);
    if metal.is_some() && (object.has("eta") || object.has("k")) {
        let message = "this conductor has both a `material` and an index";
        reader.error(object.node, message, "one of the two");
        object.ignore(&["eta", "k"]);
    }
    let eta = reader.colour(&mut object, "eta", &POSITIVE).or(metal.map(|metal| metal.eta.to_vec()));
    let k = reader.colour(&mut object, "k", &NOT_NEGATIVE).or(metal.map(|metal| metal.k.to_vec()));
    let reflectance = reader.colour(&mut object, "specular_reflectance", &FRACTION);
    let node = object.node;
    let known = ["material", "eta", "k", "specular_reflectance"];
    reader.finish(object, &[&known[..], if facets.is_some() { &ROUGHNESS } else { &[] }].concat());
    let specular = reflectance.clone().unwrap_or_else(|| vec![1.0; reader.bands]);
    match (eta, k, facets) {
        (None, None, None) => Law::Opaque(MaterialKind::Mirror { reflectance: specular }),
        (None, None, Some(facets)) => rough_metal(facets, Facet::Mirror, specular),
        (Some(eta), Some(k), Some(facets)) => rough_metal(facets, Facet::Conductor { eta, k }, specular),
        (Some(eta), Some(k), None) => {
            if reflectance.is_some_and(|reflectance| reflectance.iter().any(|&r| r != 1.0)) {
                let message = "a `specular_reflectance` other than 1 is not supported for a conductor \
                               with `eta` and `k`";
                reader.error(node, message, "no `specular_reflectance`");
            }
            Law::Opaque(MaterialKind::Conductor { eta, k })
        }
        (eta, _, _) => {
            let (given, missing) = if eta.is_some() { ("eta", "k") } else { ("k", "eta") };
            reader.error(node, format!("this conductor has `{given}` but no `{missing}`"), "both or neither");
            Law::Opaque(MaterialKind::Mirror { reflectance: vec![1.0; reader.bands] })
        }
    }
}

/// Returns the law of a diffuse base below a smooth coat. The base reflects ρ/(η² (1 − ρ F)), where F is
/// the diffuse reflectance of the coat from inside; by default Mitsuba takes ρ as white in the
/// denominator. With microfacets, the coat is rough.
fn plastic<'a>(reader: &mut Reader<'a, '_, '_>, mut object: Object<'a>, facets: Option<Microfacets>) -> Law {
    let or = |value: Option<Vec<f64>>, default: f64, bands: usize| value.unwrap_or(vec![default; bands]);
    let (inside, _) = index(reader, &mut object, "int_ior", "polypropylene");
    let (outside, place) = index(reader, &mut object, "ext_ior", "air");
    let is_nonlinear = reader.boolean(&mut object, "nonlinear", false, false);
    let n = inside / outside;
    let is_coat = n > 1.0 && n.is_finite();
    let inner = match facets {
        _ if !is_coat => 0.0,
        Some(facets) => facets.inner_reflectance(n),
        None => diffuse_reflectance_from_inside(n),
    };
    let textured =
        reader.take_pattern(&mut object, "diffuse_reflectance", if is_nonlinear { inner } else { 0.0 });
    let base = or(reader.colour(&mut object, "diffuse_reflectance", &FRACTION), 0.5, reader.bands);
    let specular = or(reader.colour(&mut object, "specular_reflectance", &FRACTION), 1.0, reader.bands);
    let known = ["diffuse_reflectance", "specular_reflectance", "int_ior", "ext_ior", "nonlinear"];
    reader.finish(object, &[&known[..], if facets.is_some() { &ROUGHNESS } else { &[] }].concat());
    if !is_coat {
        let message = "the coat of a plastic has no larger index than its exterior";
        reader.report.error(place, message, "`int_ior` above `ext_ior`");
        return Law::Wrong;
    }
    let base = textured.as_ref().map_or(&base, |(_, most)| most);
    let of_band = |rho: &f64| rho / (n * n * (1.0 - inner * if is_nonlinear { *rho } else { 1.0 }));
    let reflectance = base.iter().map(of_band).collect();
    let kind = match facets {
        None => MaterialKind::Plastic { reflectance, specular, index: n },
        Some(facets) => rough_plastic(facets, n, specular, reflectance),
    };
    match textured {
        Some((pattern, _)) => Law::Textured(kind, pattern),
        None => Law::Opaque(kind),
    }
}

/// Returns the diffuse reflectance of a boundary from inside of a medium with this relative index: a
/// fit, as in Mitsuba.
///
/// Source: W. G. Egan, T. W. Hilgeman, Optical properties of inhomogeneous materials (1979).
fn diffuse_reflectance_from_inside(n: f64) -> f64 {
    -1.4399 / (n * n) + 0.7099 / n + 0.6681 + 0.0636 * n
}

/// Returns the metal that a conductor names, if it names one.
fn named_metal<'a>(reader: &mut Reader<'a, '_, '_>, object: &mut Object<'a>) -> Option<&'static Metal> {
    let (name, place) = reader.string(object, "material").filter(|(name, _)| name != "none")?;
    let metal = METALS.iter().find(|metal| metal.name == name);
    if metal.is_none() {
        let names = one_of(METALS.iter().map(|metal| metal.name));
        let message = format!("the refractive index of the metal `{name}` is not known");
        reader.report.error(place, message, format!("`eta` and `k`, the material `none`, or {names}"));
    }
    reader.has_tables |= metal.is_some();
    metal
}

/// Returns an index of refraction, given as a number or by name, and its place.
fn index<'a>(
    reader: &mut Reader<'a, '_, '_>,
    object: &mut Object<'a>,
    key: &str,
    default: &str,
) -> (f64, Range<usize>) {
    let named = |name: &str| INDICES.iter().find(|(known, _)| *known == name.to_lowercase()).map(|&(_, n)| n);
    let given = object.left().find(|node| node.attribute("name") == Some(key));
    let place = given.map_or(object.node.range(), |node| node.range());
    if !given.is_some_and(|node| node.has_tag_name("string")) {
        return (reader.float(object, key, named(default).unwrap_or(1.0), &POSITIVE), place);
    }
    let Some((name, place)) = reader.string(object, key) else { return (1.0, place) };
    let n = named(&name);
    if n.is_none() {
        let expected = one_of(INDICES.iter().map(|(name, _)| *name));
        reader.report.error(
            place.clone(),
            format!("the refractive index of `{name}` is not known"),
            expected,
        );
    }
    (n.unwrap_or(1.0), place)
}
