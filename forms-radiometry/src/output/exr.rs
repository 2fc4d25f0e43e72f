//! OpenEXR output of a map: linear values in 32 bits, one pixel for each cell.

use super::{from_above, total};
use crate::answer::{Layout, Map};
use crate::scene::Scene;
use crate::spectrum::{Colour, add_scaled, band_colours};
use ::exr::prelude::{AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Text, WritableImage};
use std::io::{self, Cursor};

/// Encodes a map of this scene.
///
/// A single band is the channel `Y`. Several bands are the channels `band0`, `band1`, … plus
/// channels for viewers: `R`, `G` and `B`, the colour in linear sRGB under which the lamps are
/// white, or, if no band is visible, `Y`, the sum of all bands. An image also has its errors in
/// channels `error`, or `error0`, `error1`, …. Cells without a value are NaN. Values beyond the
/// range of `f32` are infinite or zero.
pub fn exr(map: &Map, scene: &Scene) -> io::Result<Vec<u8>> {
    let mut channels = match &map.values[..] {
        [values] => vec![channel(map, "Y", values)],
        bands => {
            let raw = |(band, values): (usize, &Vec<f64>)| channel(map, &format!("band{band}"), values);
            bands.iter().enumerate().map(raw).chain(shown(map, scene)).collect()
        }
    };
    if map.layout == Layout::Image {
        let name =
            |band: usize| if map.errors.len() == 1 { "error".to_owned() } else { format!("error{band}") };
        channels
            .extend(map.errors.iter().enumerate().map(|(band, errors)| channel(map, &name(band), errors)));
    }
    let channels = AnyChannels::sort(channels.into());
    let size = (map.size[0], map.size[1]);
    let mut image = Image::from_encoded_channels(size, Encoding::SMALL_LOSSLESS, channels);
    // OpenEXR texts are UTF-8, which the crate writes only if they are given as bytes
    let comment = format!("{} in {}", map.quantity.name(), map.quantity.unit());
    image.layer_data.attributes.comments = Some(Text::from_slice_unchecked(comment.as_bytes()));
    image.layer_data.attributes.software_name = Some("forms".into());
    let mut file = Cursor::new(Vec::new());
    image.write().to_buffered(&mut file).map_err(io::Error::other)?;
    Ok(file.into_inner())
}

type Channel = AnyChannel<FlatSamples>;

fn channel(map: &Map, name: &str, values: &[f64]) -> Channel {
    let samples = from_above(map, values).into_iter().flatten().map(|&value| value as f32).collect();
    AnyChannel::new(name, FlatSamples::F32(samples))
}

/// Returns the channels in which viewers show several bands.
fn shown(map: &Map, scene: &Scene) -> Vec<Channel> {
    let colours = band_colours(scene);
    if colours.iter().flatten().all(|&component| component == 0.0) {
        return vec![channel(map, "Y", &total(map))];
    }
    let colour = |cell: usize| {
        let mut sum = Colour::default();
        map.values.iter().zip(&colours).for_each(|(band, &colour)| add_scaled(&mut sum, band[cell], colour));
        sum
    };
    let cells: Vec<Colour> = (0..map.size[0] * map.size[1]).map(colour).collect();
    let component = |(place, name): (usize, &&str)| {
        let values: Vec<f64> = cells.iter().map(|cell| cell[place]).collect();
        channel(map, name, &values)
    };
    ["R", "G", "B"].iter().enumerate().map(component).collect()
}
