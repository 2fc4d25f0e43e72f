//! PLY: reads the vertices and the faces of a file in text or binary format. Other elements and
//! properties are ignored.

use super::parts::{Parts, told};
use super::ply_header::{Element, Format, Header, Property};
use super::ply_rows::{ByteRows, Rows, Stop, TextRows};
use super::words::{coordinate, lines};
use super::{Fault, Read};
use crate::geometry::Vector;
use crate::scene::SceneError;
use crate::scene::place::Source;
use forms::core::diagnostic::counted;

const HEADER_END: &[u8] = b"\nend_header";

pub(super) fn read(file: &str, bytes: &[u8]) -> Result<Read, Vec<SceneError>> {
    let body = bytes.windows(HEADER_END.len()).position(|window| window == HEADER_END);
    let body = body.map_or(bytes.len(), |position| {
        let rest = &bytes[position + 1..];
        position + 1 + rest.iter().position(|&byte| byte == b'\n').map_or(rest.len(), |newline| newline + 1)
    });
    let head = Source::new(file, &String::from_utf8_lossy(&bytes[..body]));
    let header = Header::read(&head.text).and_then(shape_of).map_err(|fault| told(&head, vec![fault], 0))?;
    let mut parts = Parts::default();
    if header.format == Format::Ascii {
        let source = Source::new(file, &String::from_utf8_lossy(bytes));
        let mut rows = TextRows::new(lines(&source.text, header.end), source.text.len());
        parts.read(&header, &mut rows);
        return parts.mesh(&source);
    }
    parts.read(&header, &mut ByteRows::new(bytes, body, header.format));
    parts.mesh(&head)
}

/// Returns the header, if it declares the coordinates of vertices, and the corners of faces if there
/// are any.
fn shape_of(header: Header) -> Result<Header, Fault> {
    let element = |name: &str| header.elements.iter().find(|element| element.name == name);
    let has_axis = |vertex: &Element, axis: &str| {
        vertex.properties.iter().any(|property| property.name == axis && property.count.is_none())
    };
    if let Some(vertex) = element("vertex")
        && let Some(axis) = ["x", "y", "z"].into_iter().find(|axis| !has_axis(vertex, axis))
    {
        let message = format!("the vertices have no `{axis}`");
        return Err(Fault::new(vertex.place.clone(), message, "property float x, y and z"));
    }
    if let Some(face) = element("face").filter(|face| !face.properties.iter().any(is_corners)) {
        let expected = "property list uchar int vertex_indices";
        return Err(Fault::new(face.place.clone(), "the faces have no vertices", expected));
    }
    Ok(header)
}

fn is_corners(property: &Property) -> bool {
    property.count.is_some() && matches!(&*property.name, "vertex_indices" | "vertex_index")
}

impl Parts {
    fn read(&mut self, header: &Header, rows: &mut impl Rows) {
        let vertex = header.elements.iter().find(|element| element.name == "vertex");
        let has = |names: &[&str]| {
            let properties = vertex.map_or(&[][..], |vertex| &vertex.properties);
            names.iter().all(|name| properties.iter().any(|own| own.name == *name && own.count.is_none()))
        };
        let has_normals = has(&["nx", "ny", "nz"]);
        let has_texture = has(&["u", "v"]) || has(&["s", "t"]);
        let mut longer = 0;
        for (element, row) in header.elements.iter().flat_map(|e| (0..e.rows).map(move |row| (e, row))) {
            if let Err(stop) = self.row(element, row, rows) {
                self.fault(stop.fault);
                if stop.for_good {
                    return;
                }
            } else if rows.has_more() {
                longer += 1;
            }
        }
        self.keep_attributes(has_normals, has_texture);
        if longer > 0 {
            let rows = counted(longer, "row");
            self.note(format!(
                "{rows} with more numbers than the header declares: the last ones are ignored"
            ));
        }
        if let Some(rest) = rows.rest() {
            self.note(format!("{rest} after the rows that the header declares: ignored"));
        }
    }

    fn row(&mut self, element: &Element, row: u64, rows: &mut impl Rows) -> Result<(), Stop> {
        rows.begin(element, row)?;
        let (mut vertex, mut corners) = (Vertex::default(), Vec::new());
        for property in &element.properties {
            let Some(count) = property.count else {
                let number = rows.number(property.scalar)?;
                if element.name == "vertex" {
                    vertex.set(property, number, rows)?;
                }
                continue;
            };
            for _ in 0..rows.number(count)?.max(0.0) as u64 {
                let number = rows.number(property.scalar)?;
                if element.name == "face" && is_corners(property) {
                    corners.push(corner(number, rows)?);
                }
            }
        }
        match &*element.name {
            "vertex" => {
                self.vertices.push(vertex.position);
                self.normals.values.push(vertex.normal);
                self.texture.values.push(vertex.texture);
            }
            "face" => self.face(corners, rows.row_place()),
            _ => {}
        }
        Ok(())
    }
}

/// A vertex, with the normal and the texture coordinates that the file can have.
#[derive(Default)]
struct Vertex {
    position: Vector,
    normal: Vector,
    texture: [f64; 2],
}

impl Vertex {
    /// Sets the coordinate that a property stands for.
    fn set(&mut self, property: &Property, number: f64, rows: &impl Rows) -> Result<(), Stop> {
        let axis = match &*property.name {
            "x" => &mut self.position.x,
            "y" => &mut self.position.y,
            "z" => &mut self.position.z,
            "nx" => &mut self.normal.x,
            "ny" => &mut self.normal.y,
            "nz" => &mut self.normal.z,
            "u" | "s" => &mut self.texture[0],
            "v" | "t" => &mut self.texture[1],
            _ => return Ok(()),
        };
        *axis = number;
        if matches!(&*property.name, "x" | "y" | "z") {
            coordinate(rows.place(), number).map_err(|fault| passing(fault, rows))?;
        }
        Ok(())
    }
}

fn corner(number: f64, rows: &impl Rows) -> Result<u32, Stop> {
    if number.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&number) {
        return Ok(number as u32);
    }
    let fault =
        Fault::new(rows.place(), format!("there is no vertex {number}"), "a vertex index, counted from 0");
    Err(passing(fault, rows))
}

/// Converts a fault of one number: reading continues after a faulty row of text, but not of bytes,
/// where the rest of the row would be misread.
fn passing(fault: Fault, rows: &impl Rows) -> Stop {
    let prefix = rows.prefix();
    Stop { for_good: !prefix.is_empty(), fault: Fault { message: prefix + &fault.message, ..fault } }
}
