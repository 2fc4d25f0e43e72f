//! False-colour pictures of maps: values become colours of a perceptually uniform scale.

use super::{from_above, measured, total};
use crate::answer::Map;
use colorous::VIRIDIS;
use std::io;

/// Least number of pixels of the longer side of the picture.
const SIDE: usize = 256;

/// Relative precision of the largest value in the description, so that files are identical on
/// processors with different rounding.
const SHOWN: f64 = 1e-6;

/// Encodes a map as a picture.
///
/// The value of a cell is the sum of its bands, and a cell is a square of pixels. The colours are
/// those of viridis, from dark at 0 to bright at the largest value; the text chunk `Description` of
/// the file contains that value. Cells without a value are transparent.
pub fn png(map: &Map) -> io::Result<Vec<u8>> {
    let values = total(map);
    let greatest = values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
    let scale = enlargement(map.size);
    let mut pixels = Vec::with_capacity(4 * values.len() * scale * scale);
    for row in from_above(map, &values) {
        let colours = row.iter().map(|&value| colour(value, greatest));
        let line: Vec<u8> = colours.flat_map(|colour| std::iter::repeat_n(colour, scale)).flatten().collect();
        (0..scale).for_each(|_| pixels.extend_from_slice(&line));
    }
    encoded(map.size.map(|cells| cells * scale), &pixels, description(map, greatest))
}

/// Encodes pixels as a file with a text that describes them.
pub(super) fn encoded(
    [width, height]: [usize; 2],
    pixels: &[u8],
    description: String,
) -> io::Result<Vec<u8>> {
    let mut file = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut file, width as u32, height as u32);
    encoder.set_color(::png::ColorType::Rgba);
    encoder.set_depth(::png::BitDepth::Eight);
    encoder.set_source_srgb(::png::SrgbRenderingIntent::Perceptual);
    encoder.add_itxt_chunk("Description".to_owned(), description)?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(file)
}

/// Returns the number of pixels along each side of a cell.
fn enlargement([columns, rows]: [usize; 2]) -> usize {
    SIDE.div_ceil(columns.max(rows))
}

fn colour(value: f64, greatest: f64) -> [u8; 4] {
    if value.is_nan() {
        return [0; 4];
    }
    let share = if greatest > 0.0 { value / greatest } else { 0.0 };
    let [red, green, blue] = viridis(share);
    [red, green, blue, 255]
}

/// Returns the colour of a fraction of the largest value, from 0 to 1: red, green and blue of the
/// viridis scale.
pub fn viridis(share: f64) -> [u8; 3] {
    let colour = VIRIDIS.eval_continuous(share);
    [colour.r, colour.g, colour.b]
}

fn description(map: &Map, greatest: f64) -> String {
    let bands = if map.values.len() == 1 { "" } else { ", sum of all bands" };
    let (quantity, unit) = (map.quantity.name(), map.quantity.unit());
    let [greatest, _] = measured(greatest, SHOWN * greatest);
    format!("{quantity} of {}{bands}, from 0 (dark) to {greatest} {unit} (bright)", map.receiver)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_has_256_pixels_or_more_on_its_longer_side() {
        for (size, scale) in [([1, 1], 256), ([64, 64], 4), ([100, 10], 3), ([10, 257], 1), ([256, 1], 1)] {
            assert_eq!(enlargement(size), scale, "{size:?}");
        }
    }

    #[test]
    fn the_scale_goes_from_dark_to_bright_and_leaves_out_what_is_no_number() {
        let luminance = |share: f64| {
            let [r, g, b, alpha] = colour(3.0 * share, 3.0);
            assert_eq!(alpha, 255);
            2 * u32::from(r) + 7 * u32::from(g) + u32::from(b)
        };
        assert!((1..=20).all(|i| luminance(f64::from(i) / 20.0) > luminance(f64::from(i - 1) / 20.0)));
        assert_eq!(colour(f64::NAN, 3.0)[3], 0);
        assert_eq!(colour(0.0, 0.0), colour(0.0, 3.0));
    }
}
