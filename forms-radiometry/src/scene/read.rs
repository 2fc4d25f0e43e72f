//! Parsing: the text of a scene file becomes a [`Scene`], or the list of all its errors.

use super::element::{Element, Names};
use super::error::Report;
use super::file::{LARGEST_MESH, LARGEST_SCENE, read_file};
use super::known::Known;
use super::mesh_file::MeshFiles;
use super::model::{Ambient, Band, LengthUnit, Scene};
use super::overlaps::Format;
use super::place::Source;
use super::subsurfaces::Subsurface;
use super::value::{Domain, NOT_NEGATIVE, Value, array, choice, number, text};
use super::{
    SceneError, light, material, medium, mitsuba, overlaps, receiver, regions, solve, subsurfaces, surface,
    view3d,
};
use std::io;
use std::path::Path;
use toml::de::DeTable;

const KEYS: &[&str] =
    &["name", "unit", "bands", "medium", "material", "surface", "light", "receiver", "ambient", "solve"];
const WAVELENGTH: Domain = Domain { expected: "a wavelength in nm, above 0", contains: |x| x > 0.0 };

/// Reads the scene in a file, and the meshes that it names by paths relative to the folder of the
/// file.
///
/// A file with the extension `.xml` is a scene of Mitsuba 3, one with `.vs3` a scene of View3D, any
/// other a scene in TOML.
pub fn open(path: &Path) -> Result<Scene, Vec<SceneError>> {
    let text = text_of(path)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    read_with_files(&text, &path.to_string_lossy(), &|file| read_file(&folder.join(file), LARGEST_MESH))
}

/// Returns the text of a file.
pub(super) fn text_of(path: &Path) -> Result<String, Vec<SceneError>> {
    let name = path.to_string_lossy();
    let whole = |message: String| vec![SceneError::of_file(&name, message)];
    let bytes =
        read_file(path, LARGEST_SCENE).map_err(|error| whole(format!("the file cannot be read: {error}")))?;
    String::from_utf8(bytes).map_err(|error| {
        let line =
            error.as_bytes()[..error.utf8_error().valid_up_to()].iter().filter(|&&b| b == b'\n').count();
        whole(format!("the file is not valid UTF-8 from line {} on", line + 1))
    })
}

/// Parses a scene that names no files. `file_name` appears in the errors; nothing is opened.
pub fn read(text: &str, file_name: &str) -> Result<Scene, Vec<SceneError>> {
    read_with_files(text, file_name, &|_| {
        Err(io::Error::other("a scene that is read from text cannot refer to files"))
    })
}

/// Parses a scene; `files` returns the bytes of each file that it names.
pub fn read_with_files(
    text: &str,
    file_name: &str,
    files: &dyn Fn(&str) -> io::Result<Vec<u8>>,
) -> Result<Scene, Vec<SceneError>> {
    let source = Source::new(file_name, text);
    let mut report = Report::new(&source);
    let mut files = MeshFiles::new(file_name, files);
    let ending = Path::new(file_name).extension().map(|ending| ending.to_string_lossy().to_lowercase());
    if ending.as_deref() == Some("xml") {
        let read = mitsuba::read(&mut report, &mut files);
        return finished(report, read, |report, (mut scene, surroundings)| {
            overlaps::check(report, &scene, Format::Mitsuba);
            if !report.is_empty() {
                return scene;
            }
            let fronts = regions::check(report, &scene);
            if report.is_empty() {
                surroundings.settle(report, &mut scene, &fronts);
            }
            scene
        });
    }
    let read = match ending.as_deref() {
        Some("vs3") => view3d::read(&mut report, &source.text),
        _ => read_toml(&mut report, &source.text, &mut files),
    };
    finished(report, read, |report, (mut scene, subsurfaces)| {
        subsurfaces::cut(report, &mut scene, &subsurfaces);
        if report.is_empty() {
            overlaps::check(report, &scene, Format::Toml);
        }
        if report.is_empty() {
            regions::check(report, &scene);
        }
        receiver::check(report, &scene);
        scene
    })
}

/// Returns the scene after a last check, or all errors. The check runs only if there were no errors
/// before.
fn finished<T>(
    mut report: Report,
    read: Option<T>,
    check: impl FnOnce(&mut Report, T) -> Scene,
) -> Result<Scene, Vec<SceneError>> {
    let scene = read.filter(|_| report.is_empty()).map(|read| check(&mut report, read));
    for (place, message, expected) in scene.iter().flat_map(Scene::lost_lengths) {
        report.error_at(place, message, expected);
    }
    scene.filter(|_| report.is_empty()).ok_or_else(|| report.into_errors())
}

/// A parsed scene, and its surfaces that lie on others.
type Read = (Scene, Vec<Subsurface>);

fn read_toml(report: &mut Report, text: &str, files: &mut MeshFiles) -> Option<Read> {
    let (root, syntax_errors) = DeTable::parse_recoverable(text);
    for error in syntax_errors {
        report.error(error.span().unwrap_or(0..0), error.message(), "");
    }
    report.is_empty().then(|| read_root(report, root.get_ref(), files))
}

fn read_root(report: &mut Report, root: &DeTable, files: &mut MeshFiles) -> Read {
    let element = Element { kind: "scene", table: root, place: 0..0 };
    element.check_keys(report, KEYS);
    let name = element.optional("name").and_then(|value| text(report, value, "`name`")).unwrap_or_default();
    let unit = element.optional("unit").and_then(|value| unit(report, value)).unwrap_or(LengthUnit::Metre);
    let bands = element.optional("bands").map_or(Some(Vec::new()), |value| bands(report, value));
    let mut known = Known { bands: bands.as_ref().map(|bands| bands.len().max(1)), ..Known::default() };
    let bands = bands.unwrap_or_default();
    let media = each(report, root, "medium", |report, element, names, index| {
        medium::read(report, element, names, &mut known, index)
    });
    let materials = each(report, root, "material", |report, element, names, index| {
        material::read(report, element, names, &mut known, index)
    });
    // an invalid surface keeps its index
    let mut next = 0;
    let surfaces = each(report, root, "surface", |report, element, names, _| {
        let surfaces = surface::read(report, element, names, &mut known, next, files);
        next += surfaces.len().max(1);
        Some(surfaces)
    });
    let surfaces = surfaces.concat();
    let subsurfaces = subsurfaces::resolve(report, &known.on, &known.surfaces);
    let lights = each(report, root, "light", |report, element, names, _| {
        light::read(report, element, names, known.bands)
    });
    let receivers = each(report, root, "receiver", |report, element, names, _| {
        receiver::read(report, element, names, &known, files)
    });
    let ambient = ambient(report, root, &known);
    let solve = solve::read(report, root);
    let name = name.to_owned();
    let notes = report.take_notes();
    let scene =
        Scene { name, unit, bands, media, materials, surfaces, lights, receivers, ambient, solve, notes };
    (scene, subsurfaces)
}

/// Reads the elements of a `[[key]]` list, each with the names before it and its index.
fn each<T>(
    report: &mut Report,
    root: &DeTable,
    key: &'static str,
    mut read: impl FnMut(&mut Report, &Element, &mut Names, usize) -> Option<T>,
) -> Vec<T> {
    let mut names = Names::default();
    let elements = Element::list(report, root, key);
    let elements = elements.iter().enumerate();
    elements.filter_map(|(index, element)| read(report, element, &mut names, index)).collect()
}

fn ambient(report: &mut Report, root: &DeTable, known: &Known) -> Ambient {
    let nothing = Ambient { radiance: vec![0.0; known.bands.unwrap_or(1)], ..Ambient::default() };
    let Some(value) = root.get("ambient") else { return nothing };
    let Some(element) = Element::single(report, value, "table [ambient]", "`ambient`", "[ambient]") else {
        return nothing;
    };
    element.check_keys(report, &["medium", "radiance"]);
    let medium = element
        .optional("medium")
        .and_then(|_| element.reference(report, "medium", "the name of a medium", "medium", &known.media));
    let radiance = element.spectrum_or(report, "radiance", 0.0, &NOT_NEGATIVE, known.bands);
    let place = report.place(element.place.clone());
    Ambient { medium, radiance: radiance.unwrap_or_default(), map: None, place }
}

fn unit(report: &mut Report, value: &Value) -> Option<LengthUnit> {
    let units = [("m", LengthUnit::Metre), ("cm", LengthUnit::Centimetre), ("mm", LengthUnit::Millimetre)];
    let found = text(report, value, "`unit`")?;
    choice(report, value.span(), found, "the unit", &units)
}

fn bands(report: &mut Report, value: &Value) -> Option<Vec<Band>> {
    const EXPECTED: &str = "a list of bands [low, high] in nm";
    let Some(list) = value.get_ref().as_array().filter(|list| !list.is_empty()) else {
        report.error(value.span(), "`bands` is not a non-empty list", EXPECTED);
        return None;
    };
    let bands: Vec<Option<Band>> = list.iter().map(|value| band(report, value)).collect();
    bands.into_iter().collect()
}

fn band(report: &mut Report, value: &Value) -> Option<Band> {
    let ends = array(report, value, "a band", 2, "its two ends [low, high] in nm")?;
    let mut numbers = ends.iter().map(|end| number(report, end, "the end of a band", &WAVELENGTH));
    let (low, high) = (numbers.next()??, numbers.next()??);
    drop(numbers);
    if low >= high {
        report.error(value.span(), "the band ends before it begins", "[low, high] with low below high");
        return None;
    }
    Some(Band { low, high })
}
