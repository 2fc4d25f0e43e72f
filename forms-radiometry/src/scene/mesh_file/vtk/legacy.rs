//! Legacy VTK files: reads points and cells of an unstructured grid or of polygons, in text or
//! big-endian binary form.

use super::super::numbers::Numbers;
use super::super::parts::told;
use super::super::{Fault, Read};
use super::cell::{Cells, POLYGON, STRIP};
use crate::geometry::Vector;
use crate::scene::SceneError;
use std::ops::Range;

pub(in super::super) fn read(file: &str, bytes: &[u8]) -> Result<Read, Vec<SceneError>> {
    let mut numbers = Numbers::new(bytes);
    let mut reader = Reader::default();
    let result = reader.file(&mut numbers);
    let source = numbers.source(file);
    result.map_err(|fault| told(&source, vec![fault], 0))?;
    reader.cells.finish(&source)
}

/// The nodes of a cell, and its place in the file.
type Nodes = (Vec<u64>, Range<usize>);

#[derive(Default)]
struct Reader {
    cells: Cells,
    /// Whether cells are lists of offsets and of nodes, as from version 5 on.
    has_offsets: bool,
    /// The cells of a grid, whose kinds follow.
    lists: Vec<Nodes>,
}

impl Reader {
    fn file(&mut self, numbers: &mut Numbers) -> Result<(), Fault> {
        self.head(numbers)?;
        while let Some(word) = numbers.next_word() {
            let place = numbers.place();
            match &*word.to_ascii_uppercase() {
                "POINTS" => self.points(numbers)?,
                "POLYGONS" => self.faces(POLYGON, numbers)?,
                "TRIANGLE_STRIPS" => self.faces(STRIP, numbers)?,
                "VERTICES" | "LINES" => {
                    self.lists(numbers)?;
                }
                "CELLS" => self.lists = self.lists(numbers)?,
                "CELL_TYPES" => self.kinds(numbers)?,
                "FIELD" => skip_field(numbers)?,
                "METADATA" => {
                    numbers.line_end();
                    while !numbers.rest_of_line().1.is_empty() {}
                }
                // values on cells and points follow
                "CELL_DATA" | "POINT_DATA" => break,
                _ => {
                    let expected =
                        "`POINTS`, `CELLS`, `CELL_TYPES`, `POLYGONS`, `TRIANGLE_STRIPS` or `FIELD`";
                    return Err(numbers.fault(place, &format!("`{word}` is no section of a mesh"), expected));
                }
            }
        }
        Ok(())
    }

    /// Reads the version, the title, the encoding, and the kind of the mesh.
    fn head(&mut self, numbers: &mut Numbers) -> Result<(), Fault> {
        let (first, place) = numbers.rest_of_line();
        let version = first.to_ascii_lowercase();
        let version = version.trim().strip_prefix("# vtk datafile version");
        let Some(version) = version.and_then(|version| version.trim().parse::<f64>().ok()) else {
            let message = "the file does not begin with a VTK version";
            return Err(Fault::new(place, message, "# vtk DataFile Version 3.0, or another version"));
        };
        self.has_offsets = version >= 5.0;
        numbers.line_end();
        let (encoding, place) = numbers.word("ASCII or BINARY")?;
        numbers.is_binary = match &*encoding.to_ascii_uppercase() {
            "ASCII" => false,
            "BINARY" => true,
            _ => return Err(Fault::new(place, format!("found `{encoding}`"), "ASCII or BINARY")),
        };
        numbers.is_big_endian = true;
        let (keyword, place) = numbers.word("`DATASET`")?;
        let (kind, kind_place) = numbers.word("the kind of the mesh")?;
        if !keyword.eq_ignore_ascii_case("DATASET") {
            return Err(numbers.fault(place, &format!("found `{keyword}`"), "`DATASET`"));
        }
        match &*kind.to_ascii_uppercase() {
            "POLYDATA" | "UNSTRUCTURED_GRID" => Ok(()),
            _ => {
                let message = format!("a mesh of kind `{kind}` is not supported");
                Err(numbers.fault(kind_place, &message, "`POLYDATA` or `UNSTRUCTURED_GRID`"))
            }
        }
    }

    fn points(&mut self, numbers: &mut Numbers) -> Result<(), Fault> {
        let count = numbers.whole_in_text()?;
        let kind = Kind::read(numbers)?;
        numbers.begin_binary();
        for _ in 0..count {
            let mut point = [0.0; 3];
            for number in &mut point {
                let read = kind.number(numbers)?;
                *number = numbers.coordinate(read)?;
            }
            let [x, y, z] = point;
            self.cells.parts.vertices.push(Vector::new(x, y, z));
        }
        Ok(())
    }

    fn faces(&mut self, kind: u8, numbers: &mut Numbers) -> Result<(), Fault> {
        for (nodes, place) in self.lists(numbers)? {
            let added = self.cells.add(kind, &nodes, 0, place.clone());
            added.map_err(|message| numbers.fault(place, &message, ""))?;
        }
        Ok(())
    }

    fn kinds(&mut self, numbers: &mut Numbers) -> Result<(), Fault> {
        let count = numbers.count_in_text()?;
        if count != self.lists.len() as u64 {
            let message = format!("there are {} cells, but {count} types of cells", self.lists.len());
            return Err(numbers.fault(numbers.place(), &message, ""));
        }
        for (nodes, place) in std::mem::take(&mut self.lists) {
            let kind = numbers.int()?;
            let kind =
                u8::try_from(kind).map_err(|_| numbers.fault(numbers.place(), "no type of cell", ""))?;
            let added = self.cells.add(kind, &nodes, 0, place.clone());
            added.map_err(|message| numbers.fault(place, &message, ""))?;
        }
        Ok(())
    }

    /// Reads the nodes of cells: before version 5 the number of nodes of each before its nodes, from
    /// then on a list of offsets and one of nodes.
    fn lists(&self, numbers: &mut Numbers) -> Result<Vec<Nodes>, Fault> {
        let (count, size) = (numbers.whole_in_text()?, numbers.whole_in_text()?);
        let mut lists = Vec::new();
        if !self.has_offsets {
            numbers.begin_binary();
            for _ in 0..count {
                let start = numbers.next_start();
                let nodes = numbers.int()?;
                let nodes: Vec<u64> =
                    (0..nodes).map(|_| node(numbers.int()?, numbers)).collect::<Result<_, _>>()?;
                lists.push((nodes, start..numbers.place().end));
            }
            return Ok(lists);
        }
        let offsets = array("OFFSETS", count, numbers)?;
        let nodes = array("CONNECTIVITY", size, numbers)?;
        for ends in offsets.windows(2) {
            let (&[start, end], place) = (ends, numbers.place()) else { continue };
            let Some(nodes) = nodes.get(start as usize..end as usize) else {
                return Err(numbers.fault(
                    place,
                    &format!("the offsets of a cell are {start} and {end}"),
                    "",
                ));
            };
            lists.push((nodes.to_vec(), place));
        }
        Ok(lists)
    }
}

/// Reads a named array of nodes: `OFFSETS vtktypeint64`, then the numbers.
fn array(name: &str, count: i64, numbers: &mut Numbers) -> Result<Vec<u64>, Fault> {
    let (word, place) = numbers.word(&format!("`{name}`"))?;
    if !word.eq_ignore_ascii_case(name) {
        return Err(numbers.fault(place, &format!("found `{word}`"), &format!("`{name}`")));
    }
    let kind = Kind::read(numbers)?;
    numbers.begin_binary();
    let number = |_| {
        let number = kind.number(numbers)?;
        node(number as i64, numbers)
    };
    (0..count).map(number).collect()
}

fn node(number: i64, numbers: &Numbers) -> Result<u64, Fault> {
    u64::try_from(number)
        .map_err(|_| numbers.fault(numbers.place(), &format!("there is no point {number}"), ""))
}

/// Passes over `FIELD NAME COUNT`, and for each array its name, width, length, kind and numbers.
fn skip_field(numbers: &mut Numbers) -> Result<(), Fault> {
    numbers.word("the name of the field")?;
    for _ in 0..numbers.whole_in_text()? {
        numbers.word("the name of an array")?;
        let (width, length) = (numbers.whole_in_text()?, numbers.whole_in_text()?);
        let kind = Kind::read(numbers)?;
        numbers.begin_binary();
        for _ in 0..width.saturating_mul(length) {
            kind.number(numbers)?;
        }
    }
    Ok(())
}

/// A kind of numbers.
#[derive(Clone, Copy)]
enum Kind {
    Float,
    Double,
    /// An integer of this number of bytes.
    Whole(usize),
}

impl Kind {
    fn read(numbers: &mut Numbers) -> Result<Self, Fault> {
        let (word, place) = numbers.word("a kind of numbers")?;
        Ok(match &*word.to_ascii_lowercase() {
            "float" => Self::Float,
            "double" => Self::Double,
            "char" | "unsigned_char" | "vtktypeint8" | "vtktypeuint8" => Self::Whole(1),
            "short" | "unsigned_short" | "vtktypeint16" | "vtktypeuint16" => Self::Whole(2),
            "int" | "unsigned_int" | "vtktypeint32" | "vtktypeuint32" => Self::Whole(4),
            "long" | "unsigned_long" | "vtktypeint64" | "vtktypeuint64" | "vtkidtype" => Self::Whole(8),
            _ => {
                let message = format!("the kind of numbers `{word}` is not supported");
                return Err(numbers.fault(place, &message, "`float`, `double`, `int`, `vtktypeint64`, …"));
            }
        })
    }

    fn number(self, numbers: &mut Numbers) -> Result<f64, Fault> {
        if !numbers.is_binary {
            return numbers.real();
        }
        match self {
            Self::Double => numbers.real(),
            Self::Float => numbers.take().map(|bytes| f32::from_le_bytes(bytes).into()),
            Self::Whole(1) => numbers.take().map(|bytes| i8::from_le_bytes(bytes).into()),
            Self::Whole(2) => numbers.take().map(|bytes| i16::from_le_bytes(bytes).into()),
            Self::Whole(4) => numbers.take().map(|bytes| i32::from_le_bytes(bytes).into()),
            Self::Whole(_) => numbers.take().map(|bytes| i64::from_le_bytes(bytes) as f64),
        }
    }
}
