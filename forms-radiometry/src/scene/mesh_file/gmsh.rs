//! gmsh: reads the triangles and quadrilaterals of a file of version 2.2 or 4.1, in text or binary
//! form. A physical group of faces is a group, by its name or its number.
//!
//! ```text
//! $MeshFormat ─ version, encoding
//! $PhysicalNames ─ names of groups ─────┐
//! $Entities (4.1) ─ groups of surfaces ─┼─ $Elements ─▶ faces with their groups
//! $Nodes ─ vertices by their numbers ───┘
//! ```
//! Curved elements are read as flat faces between their corners; elements that are no faces are
//! skipped.

use super::numbers::Numbers;
use super::parts::{Elements, Parts, told};
use super::{Fault, Read};
use crate::geometry::Vector;
use crate::scene::SceneError;
use rustc_hash::FxHashMap;
use std::borrow::Cow;
use std::ops::Range;

pub(super) fn read(file: &str, bytes: &[u8]) -> Result<Read, Vec<SceneError>> {
    let mut numbers = Numbers::new(bytes);
    let mut reader = Reader::default();
    let result = reader.sections(&mut numbers);
    let source = numbers.source(file);
    result.map_err(|fault| told(&source, vec![fault], 0))?;
    reader.elements.note(&mut reader.parts, "element", "triangles or quadrilaterals");
    reader.parts.mesh(&source)
}

/// The contents of the file so far.
#[derive(Default)]
struct Reader {
    parts: Parts,
    is_version_4: bool,
    /// The indices of the vertices by their numbers in the file.
    vertices: FxHashMap<u64, u32>,
    /// The names of physical groups of surfaces.
    names: FxHashMap<i64, String>,
    /// The physical group of each surface of the geometry.
    physical: FxHashMap<i64, i64>,
    /// The group of the last face.
    group: Option<i64>,
    elements: Elements,
}

impl Reader {
    fn sections(&mut self, numbers: &mut Numbers) -> Result<(), Fault> {
        self.format(numbers)?;
        while let Some((name, place)) = numbers.section() {
            if self.is_version_4 && matches!(&*name, "$Entities" | "$Nodes" | "$Elements") {
                numbers.begin_binary();
            }
            match &*name {
                "$PhysicalNames" => self.physical_names(numbers)?,
                "$Entities" => self.entities(numbers)?,
                "$Nodes" if self.is_version_4 => self.node_blocks(numbers)?,
                "$Nodes" => self.nodes(numbers)?,
                "$Elements" if self.is_version_4 => self.element_blocks(numbers)?,
                "$Elements" if numbers.is_binary => self.binary_elements(numbers)?,
                "$Elements" => self.elements(numbers)?,
                other => {
                    if !numbers.pass(&end_of(other)) {
                        let message = format!("the section `{other}` has no end");
                        return Err(Fault::new(place, message, format!("`{}`", end_of(other))));
                    }
                    continue;
                }
            }
            numbers.end_section(&name)?;
        }
        Ok(())
    }

    fn format(&mut self, numbers: &mut Numbers) -> Result<(), Fault> {
        const EXPECTED: &str = "a file of gmsh of version 2.2 or 4.1";
        let (name, place) = numbers.section().unwrap_or_default();
        if name != "$MeshFormat" {
            return Err(Fault::new(place, "the file does not begin with `$MeshFormat`", EXPECTED));
        }
        let (version, place) = numbers.word("the version")?;
        self.is_version_4 = match &*version {
            "2.2" | "2.1" | "2" => false,
            "4.1" => true,
            _ => return Err(Fault::new(place, format!("version {version} is not supported"), EXPECTED)),
        };
        numbers.encoding()?;
        numbers.end_section("$MeshFormat")
    }

    fn physical_names(&mut self, numbers: &mut Numbers) -> Result<(), Fault> {
        for _ in 0..numbers.count_in_text()? {
            let (dimension, number) = (numbers.whole_in_text()?, numbers.whole_in_text()?);
            let name = numbers.quoted()?;
            if dimension == 2 {
                self.names.insert(number, name);
            }
        }
        Ok(())
    }

    /// Reads for each point, curve, surface and volume: its number, its bounding box, its physical
    /// groups, and the entities that bound it.
    fn entities(&mut self, numbers: &mut Numbers) -> Result<(), Fault> {
        let counts = [numbers.size()?, numbers.size()?, numbers.size()?, numbers.size()?];
        for (dimension, count) in counts.into_iter().enumerate() {
            for _ in 0..count {
                let tag = numbers.int()?;
                for _ in 0..if dimension == 0 { 3 } else { 6 } {
                    numbers.real()?;
                }
                for place in 0..numbers.size()? {
                    let group = numbers.int()?;
                    if dimension == 2 && place == 0 {
                        self.physical.insert(tag, group);
                    }
                }
                if dimension > 0 {
                    for _ in 0..numbers.size()? {
                        numbers.int()?;
                    }
                }
            }
        }
        Ok(())
    }

    fn nodes(&mut self, numbers: &mut Numbers) -> Result<(), Fault> {
        for _ in 0..numbers.count_in_text()? {
            let number = numbers.int()? as u64;
            self.node(number, numbers)?;
        }
        Ok(())
    }

    fn node_blocks(&mut self, numbers: &mut Numbers) -> Result<(), Fault> {
        let (blocks, ..) = (numbers.size()?, numbers.size()?, numbers.size()?, numbers.size()?);
        for _ in 0..blocks {
            let (dimension, _, is_parametric) = (numbers.int()?, numbers.int()?, numbers.int()? != 0);
            let count = numbers.size()?;
            let mut tags = Vec::new();
            for _ in 0..count {
                tags.push(numbers.size()?);
            }
            for tag in tags {
                self.node(tag, numbers)?;
                for _ in 0..if is_parametric { dimension } else { 0 } {
                    numbers.real()?;
                }
            }
        }
        Ok(())
    }

    fn node(&mut self, number: u64, numbers: &mut Numbers) -> Result<(), Fault> {
        let mut coordinate = || numbers.real().and_then(|number| numbers.coordinate(number));
        let vertex = Vector::new(coordinate()?, coordinate()?, coordinate()?);
        self.vertices.insert(number, self.parts.vertices.len() as u32);
        self.parts.vertices.push(vertex);
        Ok(())
    }

    /// Reads elements of version 2 in text form: number, kind, tags, and nodes; the first tag is the
    /// physical group.
    fn elements(&mut self, numbers: &mut Numbers) -> Result<(), Fault> {
        for _ in 0..numbers.count_in_text()? {
            let start = numbers.next_start();
            numbers.int()?;
            let kind = Kind::read(numbers)?;
            let group = self.tags(numbers, None)?;
            self.element(kind, group, start, numbers)?;
        }
        Ok(())
    }

    /// Reads elements of version 2 in binary form: blocks of the same kind and number of tags.
    fn binary_elements(&mut self, numbers: &mut Numbers) -> Result<(), Fault> {
        let mut rest = numbers.count_in_text()?;
        while rest > 0 {
            let kind = Kind::read(numbers)?;
            let (count, tags) = (numbers.int()?.max(1) as u64, numbers.int()?);
            for _ in 0..count.min(rest) {
                numbers.int()?;
                let group = self.tags(numbers, Some(tags))?;
                self.element(kind, group, 0, numbers)?;
            }
            rest = rest.saturating_sub(count);
        }
        Ok(())
    }

    /// Reads tags and returns the first one. Zero stands for no group.
    fn tags(&mut self, numbers: &mut Numbers, count: Option<i64>) -> Result<Option<i64>, Fault> {
        let count = count.map_or_else(|| numbers.int(), Ok)?;
        let mut first = None;
        for _ in 0..count {
            let tag = numbers.int()?;
            first = first.or(Some(tag));
        }
        Ok(first.filter(|&group| group != 0))
    }

    /// Reads elements of version 4: blocks of the same kind on the same entity of the geometry.
    fn element_blocks(&mut self, numbers: &mut Numbers) -> Result<(), Fault> {
        let (blocks, ..) = (numbers.size()?, numbers.size()?, numbers.size()?, numbers.size()?);
        for _ in 0..blocks {
            let (_, entity) = (numbers.int()?, numbers.int()?);
            let kind = Kind::read(numbers)?;
            let group = self.physical.get(&entity).copied().filter(|_| kind.corners > 0);
            for _ in 0..numbers.size()? {
                let start = numbers.next_start();
                numbers.size()?;
                self.element(kind, group, start, numbers)?;
            }
        }
        Ok(())
    }

    /// Reads the nodes of an element, and adds it if it is a face.
    fn element(
        &mut self,
        kind: Kind,
        group: Option<i64>,
        start: usize,
        numbers: &mut Numbers,
    ) -> Result<(), Fault> {
        let mut corners = Vec::with_capacity(kind.corners);
        for place in 0..kind.nodes {
            let number = if self.is_version_4 { numbers.size()? } else { numbers.int()? as u64 };
            if place < kind.corners {
                corners.push(self.vertex(number, numbers.place())?);
            }
        }
        if kind.corners == 0 {
            self.elements.skipped += 1;
            return Ok(());
        }
        self.elements.curved += usize::from(kind.nodes > kind.corners);
        if group != self.group {
            self.group = group;
            let name = group.map_or(String::new(), |group| {
                self.names.get(&group).cloned().unwrap_or_else(|| format!("physical {group}"))
            });
            self.parts.group(&name);
        }
        self.parts.face(corners, start..numbers.place().end);
        Ok(())
    }

    fn vertex(&self, number: u64, place: Range<usize>) -> Result<u32, Fault> {
        let found = self.vertices.get(&number).copied();
        found.ok_or_else(|| Fault::new(place, format!("there is no node {number}"), "a node of `$Nodes`"))
    }
}

/// Sections: `$Name` … `$EndName`.
impl<'b> Numbers<'b> {
    /// Returns the name of the next section, such as `$Nodes`, and its place.
    fn section(&mut self) -> Option<(Cow<'b, str>, Range<usize>)> {
        loop {
            let word = self.next_word()?;
            if word.starts_with('$') {
                return Some((word, self.place()));
            }
        }
    }

    /// Reads the end of a section.
    fn end_section(&mut self, name: &str) -> Result<(), Fault> {
        let end = end_of(name);
        let (word, place) = self.word(&format!("`{end}`"))?;
        if word == end {
            Ok(())
        } else {
            Err(self.fault(place, &format!("found `{word}`"), &format!("`{end}`")))
        }
    }

    /// Reads the encoding, the size of numbers, and in a binary file the number one, which tells the
    /// byte order.
    fn encoding(&mut self) -> Result<(), Fault> {
        let (binary, size) = (self.whole_in_text()?, self.whole_in_text()?);
        if size != 8 {
            return Err(self.fault(self.place(), &format!("numbers have {size} bytes"), "8"));
        }
        self.is_binary = binary == 1;
        if self.is_binary {
            self.line_end();
            self.is_big_endian = self.int()? != 1;
        }
        Ok(())
    }

    /// Returns the name in quotes on the rest of the line.
    fn quoted(&mut self) -> Result<String, Fault> {
        let (line, place) = self.rest_of_line();
        let name = line.split('"').nth(1).map(str::to_owned);
        name.ok_or_else(|| self.fault(place, "the group has no name", "\"…\""))
    }
}

fn end_of(name: &str) -> String {
    format!("$End{}", &name[1..])
}

/// A kind of element.
#[derive(Clone, Copy)]
struct Kind {
    /// The number of its nodes.
    nodes: usize,
    /// The number of its corners, which come first; zero if it is no face.
    corners: usize,
}

impl Kind {
    fn read(numbers: &mut Numbers) -> Result<Self, Fault> {
        let number = numbers.int()?;
        let nodes = match number {
            15 => 1,
            1 => 2,
            2 | 8 => 3,
            3 | 4 | 26 => 4,
            7 | 27 => 5,
            6 | 9 | 28 => 6,
            5 | 16 => 8,
            10 | 20 => 9,
            11 | 21 => 10,
            22 => 12,
            19 => 13,
            14 => 14,
            18 | 23 | 24 => 15,
            36 => 16,
            13 => 18,
            17 | 29 => 20,
            25 => 21,
            37 => 25,
            12 => 27,
            30 => 35,
            31 => 56,
            92 => 64,
            93 => 125,
            _ => {
                let message = format!("elements of kind {number} are not supported");
                return Err(Fault::new(numbers.place(), message, "2 (triangle), 3 (quadrilateral), …"));
            }
        };
        let corners = match number {
            2 | 9 | 20..=25 => 3,
            3 | 10 | 16 | 36 | 37 => 4,
            _ => 0,
        };
        Ok(Self { nodes, corners })
    }
}
