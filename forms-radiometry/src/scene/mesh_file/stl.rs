//! STL: reads the triangles of a file in text or binary form. Equal corners become one vertex; the
//! normals of the file are ignored, since the order of the corners decides which side is the front.
//! A solid with a name is a group.

use super::parts::Parts;
use super::words::{Word, coordinate, extent, lines, words};
use super::{Fault, Read};
use crate::geometry::Vector;
use crate::scene::SceneError;
use crate::scene::place::Source;
use forms::core::diagnostic::counted;
use rustc_hash::FxHashMap;
use std::ops::Range;

/// Bytes of the header and of the number of triangles, and of one triangle, in binary form.
const HEAD: usize = 84;
const TRIANGLE: usize = 50;

pub(super) fn read(file: &str, bytes: &[u8]) -> Result<Read, Vec<SceneError>> {
    let mut reader = Reader::default();
    if let Some(count) = triangles(bytes) {
        reader.bytes(&bytes[HEAD..], count);
        return reader.parts.mesh(&Source::new(file, ""));
    }
    let source = Source::new(file, &String::from_utf8_lossy(bytes));
    reader.text(&source.text);
    reader.parts.mesh(&source)
}

/// Returns the number of triangles of a binary file: its length follows from this number, or it does
/// not look like a text.
fn triangles(bytes: &[u8]) -> Option<usize> {
    let count = u32::from_le_bytes(*bytes.get(HEAD - 4..)?.first_chunk()?) as usize;
    let is_text = bytes.trim_ascii_start().starts_with(b"solid")
        && (bytes.windows(5).any(|word| word == b"facet") || !bytes.contains(&0));
    let is_binary = bytes.len() == HEAD + TRIANGLE * count || !is_text;
    is_binary.then_some(count)
}

/// The triangles read so far.
#[derive(Default)]
struct Reader {
    parts: Parts,
    /// The numbers of vertices by the bits of their coordinates.
    numbers: FxHashMap<[u64; 3], u32>,
}

impl Reader {
    /// Returns the number of a vertex; equal vertices have the same number.
    fn number(&mut self, vertex: Vector) -> u32 {
        // adding zero makes −0 equal to 0
        let bits = vertex.coordinates().map(|x| (x + 0.0).to_bits());
        *self.numbers.entry(bits).or_insert_with(|| {
            self.parts.vertices.push(vertex);
            self.parts.vertices.len() as u32 - 1
        })
    }

    fn triangle(&mut self, corners: [Vector; 3], place: Range<usize>) {
        let corners = corners.map(|corner| self.number(corner));
        self.parts.face(corners, place);
    }

    /// Reads triangles in binary form.
    fn bytes(&mut self, body: &[u8], count: usize) {
        if let Some(rest) = body.get(TRIANGLE * count..).filter(|rest| !rest.is_empty()) {
            let (rest, count) = (counted(rest.len(), "byte"), counted(count, "triangle"));
            self.parts.note(format!("{rest} after the {count} that the file declares: ignored"));
        }
        for index in 0..count {
            let place = TRIANGLE * index;
            let fault = |message: &str, expected: String| {
                let message = format!("triangle {} of {count} (byte {}): {message}", index + 1, HEAD + place);
                Fault::new(0..0, message, expected)
            };
            let Some(bytes) = body.get(place..place + TRIANGLE) else {
                let expected = "as many triangles as the file declares".to_owned();
                return self.parts.fault(fault("the file ends within it", expected));
            };
            match corners(bytes) {
                Ok(corners) => self.triangle(corners, 0..0),
                Err(wrong) => self.parts.fault(fault(&wrong.message, wrong.expected)),
            }
        }
    }

    /// Reads the text form: `solid NAME`, then for each triangle `facet`, `outer loop`, three times
    /// `vertex x y z`, `endloop` and `endfacet`, then `endsolid`.
    fn text(&mut self, text: &str) {
        let mut open = Open::default();
        for (start, line) in lines(text, 0) {
            let line: Vec<Word> = words(start, line).collect();
            let Some((keyword, arguments)) = line.split_first() else { continue };
            if let Err(fault) = self.line(keyword, arguments, extent(&line), &mut open) {
                self.parts.fault(fault);
            }
        }
        let place = open.facet.map(|start| (start..start + "facet".len(), "facet"));
        if let Some((place, what)) = place.or(open.solid.map(|solid| (solid, "solid"))) {
            let message = format!("the file ends within this {what}");
            self.parts.fault(Fault::new(place, message, format!("`end{what}`")));
        }
    }

    fn line(
        &mut self,
        keyword: &Word,
        arguments: &[Word],
        place: Range<usize>,
        open: &mut Open,
    ) -> Result<(), Fault> {
        match keyword.text.to_ascii_lowercase().as_str() {
            "solid" => {
                open.solid = Some(place);
                self.parts.group(arguments.first().map_or("", |name| name.text));
            }
            "facet" => {
                open.facet = Some(place.start);
                open.corners.clear();
            }
            "vertex" => open.corners.push(vertex(keyword, arguments)?),
            "endfacet" => {
                let place = open.facet.take().unwrap_or(place.start)..place.end;
                let [a, b, c] = open.corners[..] else {
                    let message = format!("a facet has {} of its three vertices", open.corners.len());
                    return Err(Fault::new(place, message, "vertex x y z, three times"));
                };
                self.triangle([a, b, c], place);
            }
            "endsolid" => open.solid = None,
            "outer" | "endloop" => {}
            word => {
                let message = format!("`{word}` is no line of an STL file");
                let expected =
                    "`solid`, `facet`, `outer loop`, `vertex`, `endloop`, `endfacet` or `endsolid`";
                return Err(Fault::new(keyword.range.clone(), message, expected));
            }
        }
        Ok(())
    }
}

/// What is open at a line of the text form.
#[derive(Default)]
struct Open {
    /// The line that begins the solid.
    solid: Option<Range<usize>>,
    /// The byte at which the facet begins, and its corners so far.
    facet: Option<usize>,
    corners: Vec<Vector>,
}

/// Returns the corners of a triangle in binary form: after its normal, three times three `f32`.
fn corners(triangle: &[u8]) -> Result<[Vector; 3], Fault> {
    let (floats, _) = triangle.as_chunks();
    let mut corners = [Vector::default(); 3];
    for (corner, floats) in corners.iter_mut().zip(floats[3..].chunks(3)) {
        let at = |axis: usize| coordinate(0..0, f64::from(f32::from_le_bytes(floats[axis])));
        *corner = Vector::new(at(0)?, at(1)?, at(2)?);
    }
    Ok(corners)
}

fn vertex(keyword: &Word, arguments: &[Word]) -> Result<Vector, Fault> {
    match arguments {
        [x, y, z] => Ok(Vector::new(x.coordinate()?, y.coordinate()?, z.coordinate()?)),
        _ => {
            let message = format!("a vertex has {}", crate::scene::value::values(arguments.len()));
            Err(Fault::new(keyword.range.clone(), message, "x y z"))
        }
    }
}
