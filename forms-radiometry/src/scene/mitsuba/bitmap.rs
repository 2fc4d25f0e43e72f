//! Textures of a reflectance: parses a `<texture>` of type `bitmap`, whose image is a PNG or JPEG file,
//! or `checkerboard` into a pattern.

use super::object::Object;
use super::{Node, Reader};
use crate::geometry::Affine;
use crate::scene::mesh_file::Found;
use crate::scene::texture::{Filter, Pattern, Picture, Wrap};
use crate::scene::value::one_of;
use std::io::Cursor;
use std::sync::Arc;

/// The largest number of pixels of an image.
const MOST_PIXELS: usize = 1 << 26;
const EXPECTED: &str = "a PNG or JPEG file with 8 bits for each of its channels";
const KNOWN: [&str; 5] = ["filename", "filter_type", "wrap_mode", "raw", "to_uv"];

/// An image of bytes, row by row from above, with one or three numbers for each pixel.
struct Bytes {
    resolution: [usize; 2],
    channels: usize,
    bytes: Vec<u8>,
}

impl<'a> Reader<'a, '_, '_> {
    /// Takes the texture that a property of an object is, or refers to, if its type is one of these.
    pub(super) fn take_texture(
        &mut self,
        object: &mut Object<'a>,
        name: &str,
        kinds: &[&str],
    ) -> Option<Node<'a>> {
        let node = object.left().find(|node| node.attribute("name") == Some(name))?;
        let texture = match node.has_tag_name("ref") {
            true => node.attribute("id").and_then(|id| self.ids.get(id).copied())?,
            false => node,
        };
        if !texture.has_tag_name("texture") || !kinds.contains(&&*self.kind(texture)) {
            return None;
        }
        object.take(name);
        Some(texture)
    }

    /// Takes the pattern of a property of an object, and its largest value in each band. With an inner
    /// reflectance, it is the base of plastic whose inner reflections depend on the place.
    pub(super) fn take_pattern(
        &mut self,
        object: &mut Object<'a>,
        name: &str,
        inner: f64,
    ) -> Option<(Arc<Pattern>, Vec<f64>)> {
        let texture = self.take_texture(object, name, &["bitmap", "checkerboard"])?;
        let (picture, to_uv) = match &*self.kind(texture) {
            "bitmap" => self.bitmap(texture),
            _ => {
                let board = self.checkerboard(texture);
                Some((Picture::Checkerboard(board.colours), board.to_uv))
            }
        }
        .unwrap_or_else(|| {
            (Picture::Checkerboard([vec![0.0; self.bands], vec![0.0; self.bands]]), Affine::IDENTITY)
        });
        let (pattern, most) = Pattern::new(picture, to_uv, inner, self.bands);
        Some((Arc::new(pattern), most))
    }

    /// Returns the image of a texture, and the map of texture coordinates.
    fn bitmap(&mut self, node: Node<'a>) -> Option<(Picture, Affine)> {
        let mut object = self.object(node);
        let filter = [("bilinear", Filter::Bilinear), ("nearest", Filter::Nearest)];
        let filter = self.one_of_names(&mut object, "filter_type", &filter);
        let wrap = [("repeat", Wrap::Repeat), ("mirror", Wrap::Mirror), ("clamp", Wrap::Clamp)];
        let wrap = self.one_of_names(&mut object, "wrap_mode", &wrap);
        let is_linear = self.boolean(&mut object, "raw", false, false);
        let to_uv = self.transform_named(&mut object, "to_uv");
        let file = self.string(&mut object, "filename");
        self.finish(object, &KNOWN);
        let Some((name, place)) = file else {
            self.error(node, "this texture of type `bitmap` has no `filename`", "a string");
            return None;
        };
        match self.files.find("image", &name).and_then(|found| image(&name, &found)) {
            Ok(image) => {
                let (resolution, values) = (image.resolution, image.values(is_linear, self.bands));
                Some((Picture::Image { resolution, values, filter, wrap }, to_uv))
            }
            Err((message, expected)) => {
                self.report.error(place, message, expected);
                None
            }
        }
    }

    /// Returns the value that a property names; the first one by default.
    fn one_of_names<T: Copy>(&mut self, object: &mut Object<'a>, key: &str, values: &[(&str, T)]) -> T {
        let Some((name, place)) = self.string(object, key) else { return values[0].1 };
        let found = values.iter().find(|(known, _)| *known == name);
        if found.is_none() {
            let expected = one_of(values.iter().map(|(known, _)| *known));
            self.report.error(place, format!("`{key}` cannot be `{name}`"), expected);
        }
        found.unwrap_or(&values[0]).1
    }
}

impl Bytes {
    /// Returns the linear values of each band. Unless they are linear already, the bytes are those of
    /// the standard sRGB (IEC 61966-2-1).
    fn values(&self, is_linear: bool, bands: usize) -> Vec<f32> {
        let linear = |byte: usize| {
            let value = byte as f64 / 255.0;
            let decoded = if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) };
            (if is_linear { value } else { decoded }) as f32
        };
        let table: [f32; 256] = std::array::from_fn(linear);
        let pixels = self.bytes.chunks_exact(self.channels);
        let of_pixel = |pixel: &[u8]| -> Vec<f32> {
            (0..bands).map(|band| table[usize::from(pixel[band % self.channels])]).collect()
        };
        pixels.flat_map(of_pixel).collect()
    }
}

/// Returns the image of a file, or a message and what was expected.
fn image(name: &str, found: &Found) -> Result<Bytes, (String, String)> {
    let wrong = |reason: String| (format!("the image `{name}` {reason}"), EXPECTED.to_owned());
    let image = match found.bytes.starts_with(&[0xff, 0xd8]) {
        true => jpeg(&found.bytes),
        false => png(&found.bytes),
    };
    let image = image.map_err(wrong)?;
    let [width, height] = image.resolution;
    if width == 0 || height == 0 || image.bytes.len() != width * height * image.channels {
        return Err(wrong("has another number of pixels than its size tells".to_owned()));
    }
    Ok(image)
}

fn png(bytes: &[u8]) -> Result<Bytes, String> {
    let unreadable = |error: png::DecodingError| format!("cannot be read: {error}");
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(unreadable)?;
    let [width, height] = [reader.info().width, reader.info().height].map(|side| side as usize);
    check_size(width, height)?;
    let (color, depth) = reader.output_color_type();
    if depth != png::BitDepth::Eight {
        return Err("has channels of more than 8 bits".to_owned());
    }
    let size = reader.output_buffer_size().ok_or_else(|| "is too large".to_owned())?;
    let mut pixels = vec![0; size];
    let frame = reader.next_frame(&mut pixels).map_err(unreadable)?;
    pixels.truncate(frame.buffer_size());
    // opacity is ignored, as in Mitsuba
    let (channels, kept) = match color {
        png::ColorType::Grayscale => (1, 1),
        png::ColorType::GrayscaleAlpha => (2, 1),
        png::ColorType::Rgb => (3, 3),
        png::ColorType::Rgba => (4, 3),
        png::ColorType::Indexed => return Err("has a palette that cannot be read".to_owned()),
    };
    let bytes = pixels.chunks_exact(channels).flat_map(|pixel| &pixel[..kept]).copied().collect();
    Ok(Bytes { resolution: [width, height], channels: kept, bytes })
}

fn jpeg(bytes: &[u8]) -> Result<Bytes, String> {
    let unreadable = |error: jpeg_decoder::Error| format!("cannot be read: {error}");
    let mut decoder = jpeg_decoder::Decoder::new(Cursor::new(bytes));
    decoder.read_info().map_err(unreadable)?;
    let info = decoder.info().ok_or_else(|| "has no size".to_owned())?;
    let resolution = [info.width, info.height].map(usize::from);
    check_size(resolution[0], resolution[1])?;
    let channels = match info.pixel_format {
        jpeg_decoder::PixelFormat::L8 => 1,
        jpeg_decoder::PixelFormat::RGB24 => 3,
        jpeg_decoder::PixelFormat::L16 | jpeg_decoder::PixelFormat::CMYK32 => {
            return Err("has neither grey nor red, green and blue".to_owned());
        }
    };
    let bytes = decoder.decode().map_err(unreadable)?;
    Ok(Bytes { resolution, channels, bytes })
}

fn check_size(width: usize, height: usize) -> Result<(), String> {
    match width.saturating_mul(height) {
        pixels if pixels > MOST_PIXELS => Err(format!("has more than {MOST_PIXELS} pixels")),
        _ => Ok(()),
    }
}
