//! The numbers of a glTF file: accessors are read from views of buffers.

use super::Open;
use super::document::{Accessor, Buffer, Document};
use base64::Engine;

/// The bytes of each buffer of a document.
pub(super) struct Data<'d> {
    document: &'d Document,
    buffers: Vec<Vec<u8>>,
}

impl<'d> Data<'d> {
    /// Opens the buffers; one without a name is the binary part of the file.
    pub(super) fn open(document: &'d Document, binary: Option<&[u8]>, open: &Open) -> Result<Self, String> {
        let buffers = document.buffers.iter().enumerate();
        let buffers = buffers.map(|(index, buffer)| bytes(index, buffer, binary, open));
        Ok(Self { document, buffers: buffers.collect::<Result<_, _>>()? })
    }

    /// Returns the vectors of an accessor of positions.
    pub(super) fn positions(&self, accessor: usize) -> Result<Vec<[f64; 3]>, String> {
        let numbers = self.numbers(accessor, "VEC3", 3)?;
        let (vectors, _) = numbers.as_chunks();
        Ok(vectors.to_vec())
    }

    /// Returns the numbers of an accessor of indices.
    pub(super) fn indices(&self, accessor: usize) -> Result<Vec<u32>, String> {
        Ok(self.numbers(accessor, "SCALAR", 1)?.into_iter().map(|number| number as u32).collect())
    }

    /// Returns all numbers of an accessor, whose items are of this kind.
    fn numbers(&self, index: usize, kind: &str, width: usize) -> Result<Vec<f64>, String> {
        let document = self.document;
        let wrong = |what: &str| format!("accessor {index} {what}");
        let accessor = document.accessors.get(index).ok_or_else(|| wrong("does not exist"))?;
        if accessor.kind != kind {
            return Err(wrong(&format!("has items of type `{}`, not `{kind}`", accessor.kind)));
        }
        if accessor.sparse.is_some() {
            return Err(wrong("is sparse, which is not supported"));
        }
        let number = Number::of(accessor).ok_or_else(|| wrong("has no valid `componentType`"))?;
        let view = accessor.buffer_view.and_then(|view| document.buffer_views.get(view));
        let view = view.ok_or_else(|| wrong("has no buffer view"))?;
        let buffer = self.buffers.get(view.buffer);
        let end = view.byte_offset.checked_add(view.byte_length);
        let bytes = buffer.zip(end).and_then(|(buffer, end)| buffer.get(view.byte_offset..end));
        let bytes = bytes.ok_or_else(|| wrong("reaches beyond its buffer"))?;
        let size = width * number.size;
        let stride = view.byte_stride.unwrap_or(size).max(1);
        let item = |item: usize| {
            let start = item.checked_mul(stride)?.checked_add(accessor.byte_offset)?;
            bytes.get(start..start.checked_add(size)?)
        };
        let mut numbers = Vec::new();
        for place in 0..accessor.count {
            let item = item(place).ok_or_else(|| wrong("reaches beyond its buffer view"))?;
            numbers.extend(item.chunks_exact(number.size).map(|bytes| number.read(bytes)));
        }
        Ok(numbers)
    }
}

/// Returns the bytes of a buffer: the binary part of the file, a file of its own, or text in the file.
fn bytes(index: usize, buffer: &Buffer, binary: Option<&[u8]>, open: &Open) -> Result<Vec<u8>, String> {
    let bytes = match &buffer.uri {
        None => binary.map(<[u8]>::to_vec).ok_or("the file has no binary part")?,
        Some(uri) => match uri.strip_prefix("data:") {
            Some(data) => {
                let text = data.split_once(";base64,").map(|(_, text)| text);
                let text = text.ok_or_else(|| format!("buffer {index} is text, but not in base64"))?;
                let decoded = base64::engine::general_purpose::STANDARD.decode(text);
                decoded.map_err(|error| format!("buffer {index} is not valid base64: {error}"))?
            }
            None => open(&unescaped(uri))
                .map_err(|error| format!("the buffer `{uri}` cannot be read: {error}"))?,
        },
    };
    if bytes.len() < buffer.byte_length {
        let (found, expected) = (bytes.len(), buffer.byte_length);
        return Err(format!("buffer {index} has {found} of its {expected} bytes"));
    }
    Ok(bytes)
}

/// Returns the path in a URI, in which bytes can be written as `%20`.
fn unescaped(uri: &str) -> String {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let [first, others @ ..] = rest {
        let digits = others.get(..2).and_then(|digits| std::str::from_utf8(digits).ok());
        let byte = digits.and_then(|digits| u8::from_str_radix(digits, 16).ok()).filter(|_| *first == b'%');
        bytes.push(byte.unwrap_or(*first));
        rest = if byte.is_some() { &others[2..] } else { others };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// How the numbers of an accessor are stored.
#[derive(Clone, Copy)]
struct Number {
    /// Bytes of a number.
    size: usize,
    is_signed: bool,
    is_float: bool,
    /// The number that stands for 1.
    one: f64,
}

impl Number {
    fn of(accessor: &Accessor) -> Option<Self> {
        let (size, is_signed, is_float) = match accessor.component_type {
            5120 => (1, true, false),
            5121 => (1, false, false),
            5122 => (2, true, false),
            5123 => (2, false, false),
            5125 => (4, false, false),
            5126 => (4, true, true),
            _ => return None,
        };
        let bits = 8 * size as u32 - u32::from(is_signed);
        let one = if accessor.normalized && !is_float { f64::from(bits).exp2() - 1.0 } else { 1.0 };
        Some(Self { size, is_signed, is_float, one })
    }

    /// Reads a number, the least significant byte first.
    fn read(self, bytes: &[u8]) -> f64 {
        let word = bytes.iter().rev().fold(0u32, |word, &byte| word << 8 | u32::from(byte));
        if self.is_float {
            return f32::from_bits(word).into();
        }
        let unused = 32 - 8 * self.size as u32;
        let whole = if self.is_signed { f64::from(((word << unused) as i32) >> unused) } else { word.into() };
        // the smallest integer of a type stands for −1, like the one after it
        if self.one == 1.0 { whole } else { (whole / self.one).max(-1.0) }
    }
}
