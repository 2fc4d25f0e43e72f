//! Photographs: converts the radiance of an image to tone-mapped colours for a screen.

use super::from_above;
use super::png::encoded;
use crate::answer::Map;
use crate::scene::Scene;
use crate::spectrum::{Colour, add_scaled, band_colours, luminance};
use crate::tone::{Exposure, encode};
use std::io;

/// Encodes the view of a camera of this scene as PNG.
///
/// Bands have their colours for an eye adapted to the lamps; if no band is visible, or there is
/// only one, the picture is grey. The 99th percentile of the luminance is shown at 0.8 of the
/// screen's white, and brighter pixels approach white. Pixels without a value are transparent.
pub fn photograph(map: &Map, scene: &Scene) -> io::Result<Vec<u8>> {
    let mut weights = band_colours(scene);
    if weights.iter().flatten().all(|&weight| weight == 0.0) || weights.len() != map.values.len() {
        weights = vec![[1.0; 3]; map.values.len()];
    }
    let colour = |pixel: usize| {
        let mut sum = Colour::default();
        map.values.iter().zip(&weights).for_each(|(band, &weight)| add_scaled(&mut sum, band[pixel], weight));
        sum
    };
    let colours: Vec<Colour> = (0..map.size[0] * map.size[1]).map(colour).collect();
    let luminances: Vec<f64> =
        colours.iter().map(|&colour| luminance(colour)).filter(|l| !l.is_nan()).collect();
    let exposure = Exposure::of(luminances);
    let shown = |colour: Colour| {
        if colour.iter().any(|component| component.is_nan()) {
            return [0; 4];
        }
        let [r, g, b] = exposure.screen(colour).map(encode);
        [r, g, b, 255]
    };
    let pixels: Vec<u8> = from_above(map, &colours).into_iter().flatten().copied().flat_map(shown).collect();
    let (quantity, unit) = (map.quantity.name(), map.quantity.unit());
    let description =
        format!("{quantity} seen by {} in {unit}, with colours adapted to the lamps", map.receiver);
    encoded(map.size, &pixels, description)
}
