//! Documents: puts the text of a scene together. Each `<include>` is replaced by the elements of the
//! file that it names, and the folders of `<path>` are added to those in which files are looked up.
//! Errors refer to the files in which the elements stand.

use super::parameters::Parameters;
use crate::scene::error::{Report, Span};
use crate::scene::file::LARGEST_SCENE;
use crate::scene::mesh_file::{Found, MeshFiles};
use crate::scene::place::{Place, Source};
use crate::scene::xml;
use roxmltree::Node;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

/// The largest number of files that include each other, as in Mitsuba.
const DEEPEST_INCLUDE: usize = 15;

pub(super) const VERSIONS: &str = "version=\"3.0.0\", or another version from 2.0 on";

/// Whether scenes of this version have the same elements as those of Mitsuba 3. Names differ in
/// versions below 2.
pub(super) fn is_supported(version: &str) -> bool {
    let major = version.split('.').next().unwrap_or_default();
    major.parse::<u32>().is_ok_and(|major| (2..=3).contains(&major))
}

/// Returns the text of the scene with all included elements, or reports the files that cannot be
/// included.
pub(super) fn whole_text(report: &mut Report, files: &mut MeshFiles) -> Option<String> {
    let source = report.source();
    let mut assembly = Assembly {
        report,
        files,
        text: String::new(),
        spans: Vec::new(),
        parameters: Parameters::default(),
        open: Vec::new(),
        bytes: source.text.len() as u64,
    };
    let is_complete = assembly.file(&source, Path::new(""));
    let Assembly { text, spans, .. } = assembly;
    if is_complete {
        report.set_spans(spans);
    }
    is_complete.then_some(text)
}

/// The text that is put together.
struct Assembly<'r, 'm, 'f> {
    report: &'r mut Report,
    files: &'m mut MeshFiles<'f>,
    text: String,
    spans: Vec<Span>,
    /// The parameters that are known so far, for the names of files.
    parameters: Parameters,
    /// The paths of the files whose elements include this one.
    open: Vec<String>,
    /// The number of bytes of all files so far. A file counts each time it is included, which
    /// bounds the number of includes.
    bytes: u64,
}

impl Assembly<'_, '_, '_> {
    /// Appends a file in this folder: the scene itself, or the elements of an included file. Returns
    /// whether it could be read.
    fn file(&mut self, source: &Arc<Source>, folder: &Path) -> bool {
        let document = match xml::parsed(&source.text) {
            Ok(document) => document,
            Err((byte, message)) => {
                self.error(source, byte..byte, message, "");
                return false;
            }
        };
        let root = document.root_element();
        let is_included = !self.open.is_empty();
        let mut rest = if is_included { contents(root) } else { 0..source.text.len() };
        let mut is_complete = !is_included || self.check_root(source, root);
        for child in root.children().filter(Node::is_element) {
            match child.tag_name().name() {
                "default" => self.parameters.define(child),
                "path" => self.path(child, folder),
                "include" => {
                    let element = child.range();
                    self.copy(source, rest.start..element.start);
                    rest.start = element.end;
                    is_complete &= self.include(source, child);
                }
                _ => {}
            }
        }
        self.copy(source, rest);
        is_complete
    }

    fn check_root(&mut self, source: &Arc<Source>, root: Node) -> bool {
        if !root.has_tag_name("scene") {
            let message = format!("the root of this included file is `{}`", root.tag_name().name());
            self.error(source, root.range(), message, "`scene`");
            return false;
        }
        let version = root.attribute_node("version");
        if let Some(version) = version.filter(|version| !is_supported(version.value())) {
            let message = format!("scene version `{}` is not supported", version.value());
            self.error(source, version.range_value(), message, VERSIONS);
            return false;
        }
        true
    }

    /// Adds a folder. An invalid element is reported later, with all others.
    fn path(&mut self, node: Node, folder: &Path) {
        if let Some(Ok(value)) = node.attribute("value").map(|value| self.parameters.substitute(value)) {
            self.files.add_folder(folder, &value);
        }
    }

    fn include(&mut self, source: &Arc<Source>, node: Node) -> bool {
        let known = |name: &str| name == "filename";
        let unknown = node.attributes().find(|attribute| !known(attribute.name()));
        if let Some(attribute) = unknown {
            let message = format!("unknown attribute `{}` of `include`", attribute.name());
            self.error(source, attribute.range(), message, "`filename`");
            return false;
        }
        let Some(attribute) = node.attribute_node("filename") else {
            self.error(source, node.range(), "this include has no `filename`", "filename=\"…\"");
            return false;
        };
        let place = attribute.range_value();
        match self.parameters.substitute(attribute.value()).and_then(|name| self.included(&name)) {
            Err((message, expected)) => {
                self.error(source, place, message, expected);
                false
            }
            Ok((path, file)) => {
                self.bytes += file.text.len() as u64;
                let folder = Path::new(&path).parent().unwrap_or(Path::new("")).to_owned();
                self.open.push(path);
                let is_complete = self.file(&file, &folder);
                self.open.pop();
                is_complete
            }
        }
    }

    /// Returns the path and the text of an included file, or a message and what was expected.
    fn included(&self, name: &str) -> Result<(String, Arc<Source>), (String, String)> {
        let Found { path, bytes } = self.files.find("included file", name)?;
        let shown = self.files.shown(&path);
        if self.open.contains(&path) || shown == self.report.source().file {
            return Err((
                format!("the file `{name}` includes itself"),
                "a file without this include".to_owned(),
            ));
        }
        if self.open.len() == DEEPEST_INCLUDE {
            let expected = format!("at most {DEEPEST_INCLUDE} files that include each other");
            return Err((format!("the file `{name}` is included too deeply"), expected));
        }
        if self.bytes + bytes.len() as u64 > LARGEST_SCENE {
            let expected = format!("at most {} MiB", LARGEST_SCENE >> 20);
            return Err(("the scene is too large with its included files".to_owned(), expected));
        }
        let text = String::from_utf8(bytes)
            .map_err(|_| (format!("the included file `{name}` is not valid UTF-8"), String::new()))?;
        Ok((path, Source::new(&shown, text.strip_prefix('\u{feff}').unwrap_or(&text))))
    }

    /// Appends a part of a file.
    fn copy(&mut self, source: &Arc<Source>, range: Range<usize>) {
        let Some(part) = source.text.get(range.clone()).filter(|part| !part.is_empty()) else { return };
        self.spans.push(Span { start: self.text.len(), source: Arc::clone(source), offset: range.start });
        self.text.push_str(part);
    }

    /// Reports an error in one of the files.
    fn error(
        &mut self,
        source: &Arc<Source>,
        range: Range<usize>,
        message: impl Into<String>,
        expected: impl Into<String>,
    ) {
        let place = Place::new(source, range).in_text_at(self.text.len());
        self.report.error_at(&place, message, expected);
    }
}

/// Returns the bytes between the tags of an element.
fn contents(node: Node) -> Range<usize> {
    let end = node.range().end;
    let first = node.first_child().map_or(end, |child| child.range().start);
    first..node.last_child().map_or(end, |child| child.range().end)
}
