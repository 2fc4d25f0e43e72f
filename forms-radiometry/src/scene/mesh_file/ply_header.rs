//! PLY header: parses its lines into the data format and the list of elements.

use super::Fault;
use super::words::{Word, extent, lines, words};
use std::ops::Range;

/// Encoding of the numbers after the header.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Ascii,
    LittleEndian,
    BigEndian,
}

/// A number type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

/// A property of an element: a number, or a list preceded by its length.
pub(super) struct Property {
    pub(super) name: String,
    pub(super) scalar: Scalar,
    pub(super) count: Option<Scalar>,
}

/// An element: a number of rows with the same properties.
pub(super) struct Element {
    pub(super) name: String,
    pub(super) rows: u64,
    pub(super) properties: Vec<Property>,
    /// The place of its declaration in the header.
    pub(super) place: Range<usize>,
}

pub(super) struct Header {
    pub(super) format: Format,
    pub(super) elements: Vec<Element>,
    /// The byte of the text after the header.
    pub(super) end: usize,
}

const SCALARS: [(&str, Scalar); 16] = [
    ("char", Scalar::I8),
    ("int8", Scalar::I8),
    ("uchar", Scalar::U8),
    ("uint8", Scalar::U8),
    ("short", Scalar::I16),
    ("int16", Scalar::I16),
    ("ushort", Scalar::U16),
    ("uint16", Scalar::U16),
    ("int", Scalar::I32),
    ("int32", Scalar::I32),
    ("uint", Scalar::U32),
    ("uint32", Scalar::U32),
    ("float", Scalar::F32),
    ("float32", Scalar::F32),
    ("double", Scalar::F64),
    ("float64", Scalar::F64),
];

const FORMATS: [(&str, Format); 3] = [
    ("ascii", Format::Ascii),
    ("binary_little_endian", Format::LittleEndian),
    ("binary_big_endian", Format::BigEndian),
];

impl Header {
    pub(super) fn read(text: &str) -> Result<Self, Fault> {
        let mut lines = lines(text, 0);
        if lines.next().is_none_or(|(_, line)| line.trim_end() != "ply") {
            return Err(Fault::new(0..0, "the file does not begin with `ply`", "a PLY file"));
        }
        let (mut format, mut elements) = (None, Vec::new());
        for (start, line) in lines {
            let line_words: Vec<Word> = words(start, line).collect();
            let texts: Vec<&str> = line_words.iter().map(|word| word.text).collect();
            let place = extent(&line_words);
            match texts[..] {
                [] | ["comment" | "obj_info", ..] => {}
                ["format", name, "1.0"] => format = Some(one_of(&FORMATS, name, &line_words[1])?),
                ["element", name, _] => {
                    let rows = line_words[2].whole()?;
                    let rows = u64::try_from(rows).map_err(|_| {
                        Fault::new(
                            line_words[2].range.clone(),
                            "the number of rows is negative",
                            "zero or more rows",
                        )
                    })?;
                    elements.push(Element { name: name.to_owned(), rows, properties: Vec::new(), place });
                }
                ["property", ..] => property(&mut elements, &line_words)?,
                ["end_header"] => {
                    let format = format.ok_or_else(|| {
                        Fault::new(place, "the header has no `format` line", "format ascii 1.0, or binary")
                    })?;
                    return Self { format, elements, end: start + line.len() }.checked();
                }
                _ => {
                    let expected = "`format … 1.0`, `element`, `property`, `comment` or `end_header`";
                    return Err(Fault::new(place, "this line is not valid in a PLY header", expected));
                }
            }
        }
        Err(Fault::new(text.len()..text.len(), "the end of the header is missing", "`end_header`"))
    }

    fn checked(self) -> Result<Self, Fault> {
        for element in &self.elements {
            if element.properties.is_empty() {
                let message = format!("the element `{}` has no properties", element.name);
                return Err(Fault::new(element.place.clone(), message, "`property` lines after it"));
            }
        }
        Ok(self)
    }
}

/// Parses `property TYPE NAME` or `property list TYPE TYPE NAME`.
fn property(elements: &mut [Element], line: &[Word]) -> Result<(), Fault> {
    let (count, scalar, name) = match line {
        [_, list, count, scalar, name] if list.text == "list" => {
            (Some(one_of(&SCALARS, count.text, count)?), scalar, name)
        }
        [_, scalar, name] => (None, scalar, name),
        _ => {
            let expected = "property TYPE NAME, or property list TYPE TYPE NAME";
            return Err(Fault::new(extent(line), "invalid property declaration", expected));
        }
    };
    if matches!(count, Some(Scalar::F32 | Scalar::F64)) {
        let expected = "an integer type";
        return Err(Fault::new(
            line[2].range.clone(),
            "the length of a list does not have an integer type",
            expected,
        ));
    }
    let scalar = one_of(&SCALARS, scalar.text, scalar)?;
    let Some(element) = elements.last_mut() else {
        return Err(Fault::new(
            extent(line),
            "the property is declared before any element",
            "`element NAME ROWS` before it",
        ));
    };
    element.properties.push(Property { name: name.text.to_owned(), scalar, count });
    Ok(())
}

fn one_of<T: Copy>(known: &[(&str, T)], name: &str, word: &Word) -> Result<T, Fault> {
    let found = known.iter().find(|(known, _)| *known == name).map(|&(_, value)| value);
    found.ok_or_else(|| {
        let expected = crate::scene::value::one_of(known.iter().map(|(name, _)| *name));
        Fault::new(word.range.clone(), format!("`{name}` is unknown"), expected)
    })
}
