//! Environment maps: parses an `<emitter type="envmap">`, whose image is an OpenEXR file, into light from
//! outside that depends on the direction.

use super::Reader;
use super::object::Object;
use crate::geometry::Affine;
use crate::scene::environment_map::EnvironmentMap;
use crate::scene::mesh_file::Found;
use crate::scene::value::NOT_NEGATIVE;
use exr::prelude::{ReadChannels, ReadLayers, read};
use std::io::Cursor;

/// The largest number of pixels of an image.
const MOST_PIXELS: usize = 1 << 26;

/// An image in linear red, green and blue.
struct Picture {
    resolution: [usize; 2],
    /// Red, green and blue of each pixel, row by row from above.
    values: Vec<f64>,
}

impl<'a> Reader<'a, '_, '_> {
    /// Reads light from outside by an image in longitude and latitude.
    pub(super) fn environment(&mut self, object: &mut Object<'a>, to_world: &Affine) {
        let node = object.node;
        let scale = self.float(object, "scale", 1.0, &NOT_NEGATIVE);
        let Some((name, place)) = self.string(object, "filename") else {
            self.error(node, "this emitter of type `envmap` has no `filename`", "a string");
            return;
        };
        let Some(length) = to_world.scale(3) else {
            self.error(node, "non-uniform scaling of an environment map is not supported", "a rotation");
            return;
        };
        let axes = to_world.columns.map(|column| (1.0 / length) * column);
        let picture = self.files.find("environment map", &name).and_then(|found| picture(&name, &found));
        let map = picture.and_then(|picture| {
            let radiances: Vec<f64> = picture.values.iter().map(|value| scale * value).collect();
            EnvironmentMap::new(picture.resolution, 3, &radiances, axes).ok_or_else(|| {
                (format!("the environment map `{name}` is too small"), "two rows and two columns".to_owned())
            })
        });
        match map {
            Ok((map, radiance)) => self.set_outside(object, radiance, Some(map)),
            Err((message, expected)) => self.report.error(place, message, expected),
        }
    }
}

/// Returns the image of an OpenEXR file, or a message and what was expected.
fn picture(name: &str, found: &Found) -> Result<Picture, (String, String)> {
    const EXPECTED: &str = "an OpenEXR file with the channels R, G and B, finite and not negative";
    let wrong = |reason: String| (format!("the environment map `{name}` {reason}"), EXPECTED.to_owned());
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgba_channels(
            |size, _| {
                let is_small = size.width() * size.height() <= MOST_PIXELS;
                let count = if is_small { 3 * size.width() * size.height() } else { 0 };
                Picture { resolution: [size.width(), size.height()], values: vec![0.0; count] }
            },
            |picture: &mut Picture, at, (r, g, b, _): (f32, f32, f32, f32)| {
                let first = 3 * (at.y() * picture.resolution[0] + at.x());
                if let Some(pixel) = picture.values.get_mut(first..first + 3) {
                    pixel.copy_from_slice(&[r, g, b].map(f64::from));
                }
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_buffered(Cursor::new(&found.bytes))
        .map_err(|error| wrong(format!("cannot be read: {error}")))?;
    let picture = image.layer_data.channel_data.pixels;
    if picture.values.is_empty() {
        return Err(wrong(format!("has more than {MOST_PIXELS} pixels")));
    }
    if !picture.values.iter().all(|value| value.is_finite() && *value >= 0.0) {
        return Err(wrong("has a pixel that is not a radiance".to_owned()));
    }
    Ok(picture)
}
