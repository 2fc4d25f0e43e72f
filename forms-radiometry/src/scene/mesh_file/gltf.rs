//! glTF 2.0: reads the triangles of the nodes of a scene, each moved by the transforms above it. A node
//! is a group. Materials, skins and animations are ignored.
//!
//! ```text
//! .gltf ─ JSON ──────────────┐
//! .glb ─┬─ JSON ─────────────┼─ document: scene ─ nodes ─ meshes ─ primitives ─ accessors
//!       └─ binary ─ buffers ─┘                                                 └─▶ triangles
//! ```

mod data;
mod document;

use super::parts::{Parts, told};
use super::words::coordinate;
use super::{Fault, Read};
use crate::geometry::{Affine, Vector};
use crate::scene::SceneError;
use crate::scene::place::Source;
use data::Data;
use document::{Document, Node, Primitive};
use std::io;

/// Returns the bytes of a file that the mesh names.
pub(super) type Open<'f> = dyn Fn(&str) -> io::Result<Vec<u8>> + 'f;

/// Extensions that change nothing in the geometry that is read, or that are read.
const EXTENSIONS: [&str; 2] = ["KHR_mesh_quantization", "KHR_texture_transform"];

pub(super) fn read(file: &str, bytes: &[u8], open: &Open) -> Result<Read, Vec<SceneError>> {
    let nowhere = Source::new(file, "");
    let fault =
        |message: String| told(&nowhere, vec![Fault::new(0..0, message, "a complete glTF 2.0 file")], 0);
    let (text, binary) = parts(bytes).map_err(fault)?;
    let source = Source::new(file, &String::from_utf8_lossy(text));
    let document: Document = serde_json::from_slice(text).map_err(|error| {
        let line = source.text.split_inclusive('\n').take(error.line().saturating_sub(1));
        let byte = line.map(str::len).sum::<usize>() + error.column().saturating_sub(1);
        let message = error.to_string();
        let message = message.split(" at line ").next().unwrap_or_default().to_owned();
        told(&source, vec![Fault::new(byte..byte + 1, message, "the JSON of glTF 2.0")], 0)
    })?;
    supported(&document).map_err(fault)?;
    let data = Data::open(&document, binary, open).map_err(fault)?;
    let mut reader =
        Reader { parts: Parts::default(), document: &document, data, rest: document.nodes.len() };
    let scene = document.scenes.get(document.scene.unwrap_or(0));
    if let (None, Some(number)) = (scene, document.scene) {
        return Err(fault(format!("there is no scene {number}")));
    }
    let nodes = scene.map_or(&[][..], |scene| &scene.nodes);
    nodes.iter().try_for_each(|&node| reader.node(node, &Affine::IDENTITY)).map_err(fault)?;
    reader.parts.mesh(&nowhere)
}

/// Returns the JSON and the binary part of a file.
fn parts(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), String> {
    if !bytes.starts_with(b"glTF") {
        return Ok((bytes, None));
    }
    // a header of 12 bytes, then for each part its length, its kind and its bytes
    let part = |start: usize| {
        let length = u32::from_le_bytes(*bytes.get(start..)?.first_chunk()?) as usize;
        bytes.get(start + 8..(start + 8).checked_add(length)?)
    };
    let text = part(12).ok_or("the file ends within its JSON")?;
    Ok((text, part(12 + 8 + text.len())))
}

fn supported(document: &Document) -> Result<(), String> {
    let version = &document.asset.version;
    if !version.starts_with("2.") {
        return Err(format!("glTF version {version} is not supported, only 2.0"));
    }
    match document.extensions_required.iter().find(|name| !EXTENSIONS.contains(&name.as_str())) {
        Some(name) => Err(format!("the extension `{name}`, which the file requires, is not supported")),
        None => Ok(()),
    }
}

struct Reader<'d> {
    parts: Parts,
    document: &'d Document,
    data: Data<'d>,
    /// The number of nodes that are left: in a tree each is read once.
    rest: usize,
}

impl Reader<'_> {
    fn node(&mut self, index: usize, above: &Affine) -> Result<(), String> {
        let document = self.document;
        self.rest = self.rest.checked_sub(1).ok_or("a node is below itself, or below two others")?;
        let node = document.nodes.get(index).ok_or_else(|| format!("there is no node {index}"))?;
        let map = above.after(&affine(node));
        if let Some(number) = node.mesh {
            let mesh = document.meshes.get(number).ok_or_else(|| format!("there is no mesh {number}"))?;
            let name = node.name.clone().or_else(|| mesh.name.clone());
            self.parts.group(&name.unwrap_or_else(|| format!("node {index}")));
            for (place, primitive) in mesh.primitives.iter().enumerate() {
                self.primitive(primitive, &map)
                    .map_err(|message| format!("mesh {number}, primitive {place}: {message}"))?;
            }
        }
        node.children.iter().try_for_each(|&child| self.node(child, &map))
    }

    fn primitive(&mut self, primitive: &Primitive, map: &Affine) -> Result<(), String> {
        let mode = Mode::of(primitive);
        if mode == Mode::NoFaces {
            return Ok(());
        }
        let first = self.parts.vertices.len() as u32;
        let positions = self.data.positions(primitive.attributes.position.ok_or("it has no positions")?)?;
        for (place, position) in positions.iter().enumerate() {
            let point = map.point(Vector::new(position[0], position[1], position[2]));
            for number in point.coordinates() {
                coordinate(0..0, number).map_err(|wrong| format!("vertex {place}: {}", wrong.message))?;
            }
            self.parts.vertices.push(point);
        }
        let count = positions.len() as u32;
        let indices = match primitive.indices {
            Some(accessor) => self.data.indices(accessor)?,
            None => (0..count).collect(),
        };
        if let Some(wrong) = indices.iter().find(|&&index| index >= count) {
            return Err(format!("there is no vertex {wrong}: it has {count}"));
        }
        for [a, b, c] in mode.triangles(&indices) {
            let [a, b, c] = [a, b, c].map(|index| first + index);
            self.parts.face(if map.mirrors() { [a, c, b] } else { [a, b, c] }, 0..0);
        }
        Ok(())
    }
}

/// How vertices form triangles.
#[derive(Clone, Copy, PartialEq)]
enum Mode {
    List,
    Strip,
    Fan,
    NoFaces,
}

impl Mode {
    fn of(primitive: &Primitive) -> Self {
        match primitive.mode.unwrap_or(4) {
            4 => Self::List,
            5 => Self::Strip,
            6 => Self::Fan,
            _ => Self::NoFaces,
        }
    }

    fn triangles(self, indices: &[u32]) -> Vec<[u32; 3]> {
        let turned =
            |(place, [a, b, c]): (usize, [u32; 3])| if place % 2 == 0 { [a, b, c] } else { [b, a, c] };
        let three = |corners: &[u32]| [corners[0], corners[1], corners[2]];
        match self {
            Self::List => indices.chunks_exact(3).map(three).collect(),
            Self::Strip => indices.windows(3).map(three).enumerate().map(turned).collect(),
            Self::Fan => {
                let pairs = indices.get(1..).unwrap_or_default().windows(2);
                pairs.map(|pair| [indices[0], pair[0], pair[1]]).collect()
            }
            Self::NoFaces => Vec::new(),
        }
    }
}

/// Returns the map of a node from its own coordinates to those of the node above.
fn affine(node: &Node) -> Affine {
    if let Some(m) = &node.matrix {
        let column = |j: usize| Vector::new(m[4 * j], m[4 * j + 1], m[4 * j + 2]);
        return Affine { columns: [column(0), column(1), column(2)], shift: column(3) };
    }
    let [x, y, z] = node.translation.unwrap_or_default();
    let [a, b, c] = node.scale.unwrap_or([1.0; 3]);
    let turned = node.rotation.map_or(Affine::IDENTITY, rotation);
    let shifted = Affine::translation(Vector::new(x, y, z));
    shifted.after(&turned.after(&Affine::scaling(Vector::new(a, b, c))))
}

/// The rotation x ↦ q x q* by a unit quaternion q = (v, w): x + 2w v × x + 2v × (v × x).
fn rotation([x, y, z, w]: [f64; 4]) -> Affine {
    let v = Vector::new(x, y, z);
    let turned = |e: Vector| e + (2.0 * w) * v.cross(e) + 2.0 * v.cross(v.cross(e));
    Affine { columns: Affine::IDENTITY.columns.map(turned), shift: Vector::default() }
}
