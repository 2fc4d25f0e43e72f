//! Scenes of Mitsuba 3: translates the elements of the XML into the model, as far as the model can
//! express them.
//!
//! ```text
//! text, includes ─ roxmltree ─ objects ─┬─ bsdf, medium ──┐
//!                                       ├─ shape ─────────┼─ surfaces, media, receivers
//!                                       ├─ emitter ───────┤  lights, ambient
//!                                       └─ sensor, integrator: receivers, effects
//! ```
//! Every property of an object that the translation does not use is reported as an error. After an
//! error, parsing continues with a default value, since the scene is rejected anyway.

mod bitmap;
mod bsdf;
mod checkerboard;
mod document;
mod emitter;
mod environment;
mod geometry;
mod instance;
mod integrator;
mod media;
mod metals;
mod microfacets;
mod normals;
mod object;
mod parameters;
mod sensor;
mod shape;
mod spectrum;
mod surroundings;
mod textured;
mod transform;
mod values;

use super::element::Names;
use super::environment_map::EnvironmentMap;
use super::error::Report;
use super::mesh_file::MeshFiles;
use super::model::{Ambient, Band, LengthUnit, Light, Material, Receiver, Scene, Surface};
use instance::Instance;
use integrator::Integrator;
use media::Media;
use normals::SmoothMesh;
use object::Object;
use parameters::Parameters;
use std::collections::{HashMap, HashSet};
use std::ops::Range;
pub(super) use surroundings::Surroundings;

type Node<'a> = roxmltree::Node<'a, 'a>;

/// The bands of red, green and blue, in this order: thirds of the visible range with round limits.
const RGB: [Band; 3] =
    [Band { low: 600.0, high: 700.0 }, Band { low: 500.0, high: 600.0 }, Band { low: 400.0, high: 500.0 }];

const SPECTRA_ARE_MEANS: &str =
    "spectra over wavelength are replaced by their means in the bands 600–700, 500–600 and 400–500 nm";

/// State of the parser: the parts of the scene so far.
struct Reader<'a, 'r, 'f> {
    report: &'r mut Report,
    files: &'r mut MeshFiles<'f>,
    /// Values of `<default>`, substituted for `$name`.
    parameters: Parameters,
    ids: HashMap<&'a str, Node<'a>>,
    /// The number of bands: three if a colour is given as red, green and blue, or a spectrum over
    /// wavelength; otherwise one.
    bands: usize,
    /// Whether a spectrum over wavelength was replaced by its means in the bands.
    has_tables: bool,
    /// The kinds of objects that were reported as unsupported, each once.
    refused: HashSet<String>,
    names: Names,
    media: Media,
    surroundings: Surroundings,
    /// The instance whose shapes are being read.
    instance: Option<Instance>,
    smooth_meshes: Vec<SmoothMesh>,
    /// The parsed `<bsdf>` elements by their numbers in the document.
    bsdfs: HashMap<usize, bsdf::Bsdf>,
    materials: Vec<Material>,
    /// The materials of the elements that were parsed before.
    known_materials: HashMap<bsdf::Key, usize>,
    surfaces: Vec<Surface>,
    lights: Vec<Light>,
    receivers: Vec<Receiver>,
    /// The radiance from outside, and its dependence on the direction.
    outside: Option<(Vec<f64>, Option<EnvironmentMap>)>,
    ambient_place: Range<usize>,
    integrator: Option<Integrator>,
}

/// Parses the scene. Also returns its declarations of surrounding media, which are later compared
/// with the regions of the scene.
pub(super) fn read(report: &mut Report, files: &mut MeshFiles) -> Option<(Scene, Surroundings)> {
    let text = document::whole_text(report, files)?;
    let document = match roxmltree::Document::parse(&text) {
        Ok(document) => document,
        // all files are valid by themselves, but an included element can use a namespace of its root
        Err(error) => {
            report.error(0..0, format!("an included file is not valid here: {error}"), "");
            return None;
        }
    };
    let root: Node = document.root_element();
    let mut parameters = Parameters::default();
    root.children().filter(|child| child.has_tag_name("default")).for_each(|node| parameters.define(node));
    let value = |text: &str| parameters.substitute(text).ok();
    let has_colours = root.descendants().any(|node| spectrum::has_bands(node, value));
    let mut reader = Reader {
        report,
        files,
        parameters,
        ids: HashMap::new(),
        bands: if has_colours { RGB.len() } else { 1 },
        has_tables: false,
        refused: HashSet::new(),
        names: Names::default(),
        media: Media::default(),
        surroundings: Surroundings::default(),
        instance: None,
        smooth_meshes: Vec::new(),
        bsdfs: HashMap::new(),
        materials: Vec::new(),
        known_materials: HashMap::new(),
        surfaces: Vec::new(),
        lights: Vec::new(),
        receivers: Vec::new(),
        outside: None,
        ambient_place: 0..0,
        integrator: None,
    };
    reader.root(root);
    Some(reader.scene(has_colours))
}

impl<'a> Reader<'a, '_, '_> {
    fn root(&mut self, root: Node<'a>) {
        if !root.has_tag_name("scene") {
            self.error(root, format!("the root is `{}`", root.tag_name().name()), "`scene`");
            return;
        }
        self.attributes(root, &["version"]);
        let version = root.attribute("version").unwrap_or_default();
        if !document::is_supported(version) {
            let place = root.attribute_node("version").map_or(root.range(), |version| version.range_value());
            self.report.error(
                place,
                format!("scene version `{version}` is not supported"),
                document::VERSIONS,
            );
        }
        self.parameters(root);
        self.collect_ids(root);
        for child in self.elements(root) {
            self.top(child);
        }
    }

    /// Parses a top-level element of the scene.
    fn top(&mut self, node: Node<'a>) {
        match node.tag_name().name() {
            "default" => {}
            "path" => self.path(node),
            "bsdf" => {
                bsdf::Bsdf::read(self, node);
            }
            "medium" => {
                self.medium(node);
            }
            "shape" => self.top_shape(node),
            "emitter" => self.emitter(node),
            // an unsupported texture is reported even if nothing refers to it
            "texture" if !matches!(&*self.kind(node), "bitmap" | "checkerboard") => self.texture(node),
            // these are read where other elements refer to them
            "sampler" | "film" | "rfilter" | "texture" => {}
            "alias" => {
                self.attributes(node, &["id", "as"]);
            }
            "sensor" => self.sensor(node),
            "integrator" => self.integrator(node),
            other => {
                let expected = "`default`, `path`, `include`, `alias`, `bsdf`, `medium`, `shape`, `emitter`, `sensor` \
                                or `integrator`";
                self.error(node, format!("the element `{other}` is not supported in a scene"), expected);
            }
        }
    }

    fn parameters(&mut self, root: Node<'a>) {
        for node in root.children().filter(|child| child.has_tag_name("default")) {
            self.attributes(node, &["name", "value"]);
            if Parameters::name(node).is_none() {
                self.error(node, "this `default` has no valid `name`", "name=\"…\" of letters, digits and _");
            }
            self.attribute(node, "value");
        }
    }

    /// Checks a search path, which was added when the files were read.
    fn path(&mut self, node: Node<'a>) {
        self.attributes(node, &["value"]);
        if self.attribute(node, "value").is_none() && !node.has_attribute("value") {
            self.error(node, "this path has no `value`", "value=\"…\", a folder");
        }
    }

    fn collect_ids(&mut self, root: Node<'a>) {
        let named = root.descendants().filter(|node| !matches!(node.tag_name().name(), "ref" | "alias"));
        for (node, id) in named.filter_map(|node| Some((node, node.attribute_node("id")?))) {
            self.names.give(self.report, "id", id.value(), id.range_value());
            self.ids.entry(id.value()).or_insert(node);
        }
        for alias in root.children().filter(|node| node.has_tag_name("alias")) {
            self.alias(alias);
        }
    }

    /// Gives an element another id.
    fn alias(&mut self, node: Node<'a>) {
        let (Some(id), Some(other)) = (node.attribute_node("id"), node.attribute_node("as")) else {
            self.error(node, "this alias has no `id` or no `as`", "id=\"…\" as=\"…\"");
            return;
        };
        self.names.give(self.report, "id", other.value(), other.range_value());
        match self.ids.get(id.value()).copied() {
            Some(element) => {
                self.ids.entry(other.value()).or_insert(element);
            }
            None => {
                let message = format!("no element has the id `{}`", id.value());
                self.report.error(id.range_value(), message, "the id of an element of the scene");
            }
        }
    }

    /// Returns the id of an object, or a name made of its kind and a number.
    fn name(&mut self, object: &Object<'a>, what: &str, count: usize) -> String {
        let own = object.node.attribute("id").map(str::to_owned);
        own.unwrap_or_else(|| {
            let candidates = (count + 1..).map(|number| format!("{what} {number}"));
            candidates.into_iter().find(|name| !self.ids.contains_key(&**name)).unwrap_or_default()
        })
    }

    fn error(&mut self, node: Node<'a>, message: impl Into<String>, expected: impl Into<String>) {
        self.report.error(node.range(), message, expected);
    }

    fn scene(mut self, has_colours: bool) -> (Scene, Surroundings) {
        if self.has_tables {
            self.report.note(SPECTRA_ARE_MEANS.to_owned());
        }
        let solve = self.solve();
        self.check_normals();
        let medium = self.ambient_medium();
        let (media, elements) = self.all_media();
        let surroundings = self.all_surroundings(elements);
        let (radiance, map) = self.outside.unwrap_or_else(|| (vec![0.0; self.bands], None));
        let ambient = Ambient { medium, radiance, map, place: self.report.place(self.ambient_place) };
        let scene = Scene {
            name: String::new(),
            unit: LengthUnit::Metre,
            bands: if has_colours { RGB.to_vec() } else { Vec::new() },
            media,
            materials: self.materials,
            surfaces: self.surfaces,
            lights: self.lights,
            receivers: self.receivers,
            ambient,
            solve,
            notes: self.report.take_notes(),
        };
        (scene, surroundings)
    }
}
