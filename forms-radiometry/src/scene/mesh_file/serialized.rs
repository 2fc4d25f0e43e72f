//! Serialized meshes of Mitsuba: reads one of the triangle meshes of a file, with its normals and its
//! texture coordinates.
//!
//! ```text
//! 0x041C, version │ zlib: flags, name, counts, positions, normals, texture, colours, triangles │ …
//!                 │ zlib: the next mesh │ … │ the byte at which each mesh begins │ number of meshes
//! ```
//! Numbers are little-endian. The name exists from version 4 on, whose bytes of meshes have 8 bytes
//! instead of 4.

use super::Read;
use super::parts::Parts;
use super::words::coordinate;
use crate::geometry::Vector;
use crate::scene::SceneError;
use crate::scene::file::LARGEST_MESH;
use crate::scene::place::Source;
use flate2::read::ZlibDecoder;
use std::io::Read as _;

const MAGIC: u16 = 0x041C;
const HAS_NORMALS: u32 = 0x1;
const HAS_TEXTURE: u32 = 0x2;
const HAS_COLOURS: u32 = 0x8;
const IS_DOUBLE: u32 = 0x2000;

/// Reads the mesh with this number, counted from zero.
pub(super) fn read(file: &str, bytes: &[u8], mesh: usize) -> Result<Read, Vec<SceneError>> {
    let source = Source::new(file, "");
    let parts = compressed(bytes, mesh).and_then(|(part, version)| {
        let mut bytes = Vec::new();
        let decoded = ZlibDecoder::new(part).take(LARGEST_MESH).read_to_end(&mut bytes);
        // a stream that is not complete is noticed where bytes are missing
        decoded.map_err(|error| format!("mesh {mesh} cannot be decompressed: {error}"))?;
        Stream { bytes: &bytes, is_double: false }.mesh(version)
    });
    let parts = parts.map_err(|message| vec![SceneError::of_file(file, message)])?;
    parts.mesh(&source)
}

/// Returns the compressed bytes of a mesh, and the version of the file.
fn compressed(bytes: &[u8], mesh: usize) -> Result<(&[u8], u16), String> {
    let short = |at: usize| bytes.get(at..at + 2).map(|pair| u16::from_le_bytes([pair[0], pair[1]]));
    let version = match (short(0), short(2)) {
        (Some(MAGIC), Some(version @ 3..=4)) => version,
        (Some(MAGIC), Some(version)) => {
            return Err(format!("version {version} of the format is not supported"));
        }
        _ => return Err("it does not begin like a serialized mesh".to_owned()),
    };
    let ended = || "the file ends within its list of meshes".to_owned();
    let directory = bytes.len().checked_sub(4).ok_or_else(ended)?;
    let count = Stream { bytes: &bytes[directory..], is_double: false }.number(4)? as usize;
    if mesh >= count.max(1) {
        return Err(format!("there is no mesh {mesh}: `shape_index` counts the {count} meshes from 0"));
    }
    let width = if version == 4 { 8 } else { 4 };
    let entry = || directory.checked_sub(width * (count - mesh));
    let start = match mesh {
        0 => 0,
        _ => Stream { bytes: &bytes[entry().ok_or_else(ended)?..], is_double: false }.number(width)? as usize,
    };
    let part = start.checked_add(4).and_then(|start| bytes.get(start..)).ok_or_else(ended)?;
    Ok((part, version))
}

/// Bytes that are read one after the other.
struct Stream<'b> {
    bytes: &'b [u8],
    is_double: bool,
}

impl Stream<'_> {
    /// Returns an unsigned integer of up to eight bytes.
    fn number(&mut self, width: usize) -> Result<u64, String> {
        let Some((own, rest)) = self.bytes.split_at_checked(width) else {
            return Err("the file ends within a mesh".to_owned());
        };
        self.bytes = rest;
        Ok(own.iter().rev().fold(0, |number, &byte| number << 8 | u64::from(byte)))
    }

    fn float(&mut self) -> Result<f64, String> {
        let number = self.number(if self.is_double { 8 } else { 4 })?;
        Ok(if self.is_double { f64::from_bits(number) } else { f64::from(f32::from_bits(number as u32)) })
    }

    fn vector(&mut self) -> Result<Vector, String> {
        Ok(Vector::new(self.float()?, self.float()?, self.float()?))
    }

    fn mesh(mut self, version: u16) -> Result<Parts, String> {
        let flags = self.number(4)? as u32;
        while version == 4 && self.number(1)? != 0 {}
        let (vertices, triangles) = (self.number(8)?, self.number(8)?);
        self.is_double = flags & IS_DOUBLE != 0;
        let mut parts = Parts::default();
        for _ in 0..vertices {
            let position = self.vector()?;
            for x in position.coordinates() {
                coordinate(0..0, x).map_err(|fault| fault.message)?;
            }
            parts.vertices.push(position);
        }
        let values = |has: u32| if flags & has == 0 { 0 } else { vertices };
        for _ in 0..values(HAS_NORMALS) {
            parts.normals.values.push(self.vector()?);
        }
        for _ in 0..values(HAS_TEXTURE) {
            parts.texture.values.push([self.float()?, self.float()?]);
        }
        for _ in 0..values(HAS_COLOURS) {
            self.vector()?;
        }
        for _ in 0..triangles {
            let corners = [self.number(4)? as u32, self.number(4)? as u32, self.number(4)? as u32];
            parts.face(corners, 0..0);
        }
        parts.keep_attributes(flags & HAS_NORMALS != 0, flags & HAS_TEXTURE != 0);
        Ok(parts)
    }
}
