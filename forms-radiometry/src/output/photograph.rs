//! An image as a photograph: radiance becomes the colours of a screen.

use super::from_above;
use super::png::encoded;
use crate::scene::Scene;
use crate::simulation::Map;
use crate::spectrum::{Colour, add_scaled, band_colours, luminance};
use crate::tone::{Exposure, encode};
use std::io;

/// The file of what a camera of this scene sees.
///
/// Bands have the colour that the eye gives them, adapted to the lamps; where none is visible, or there is a single one, the picture is grey. The
/// 99th percentile of the luminance is shown at 0.8 of the screen's white, and what is brighter approaches white. Pixels without a value
/// are transparent.
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
        format!("{quantity} that {} sees, in {unit}, as an eye adapted to the lamps", map.receiver);
    encoded(map.size, &pixels, description)
}
