//! Pictures: renders a scene seen by a camera into pixels for a screen.
//!
//! Rays are first sent through the corners of the pixels, which neighbours share. If the corners of
//! a pixel agree, the pixel is their mean. If they see different surfaces, or visibly different
//! light, the pixel is sampled again at the points of a Hammersley set, the same in every pixel.
//! Nothing is random, and no pixel depends on the samples of another: the picture is the same, to
//! the last bit, for any number of threads.

use crate::camera::Camera;
use crate::scene::{Scene, SceneError};
use crate::sight::{Sample, Sight, Tracing};
use crate::spectrum::{Colour, add_scaled, luminance};
use crate::tone::{Exposure, differ, encode};
use rayon::prelude::*;

/// Number of samples of a pixel with an edge in it: 2⁵.
const EDGE_SAMPLES: u32 = 32;

/// A picture in sRGB, eight bits a component.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    width: usize,
    height: usize,
    pixels: Vec<u8>,
}

/// Renders a camera's view of a scene with direct light only: the lamps, and the surfaces that they
/// illuminate. Everything else is black.
///
/// The exposure is derived from the picture: the 99th percentile of the luminance of the reflecting
/// surfaces is shown at 0.8 of the screen's white. The light of the lamps counts as white. If the
/// scene requests features that are not simulated, returns an error for each of them.
pub fn picture(scene: &Scene, camera: &Camera) -> Result<Picture, Vec<SceneError>> {
    let [width, height] = camera.resolution;
    let sight = Sight::new(scene, camera)?;
    let corners: Vec<Sample> = (0..(width + 1) * (height + 1))
        .into_par_iter()
        .with_min_len(width + 1)
        .map_init(Tracing::default, |tracing, i| {
            sight.sample((i % (width + 1)) as f64, (i / (width + 1)) as f64, tracing)
        })
        .collect();
    let exposure = exposure(&sight, &corners);
    let mut pixels = vec![0; 3 * width * height];
    pixels.par_chunks_mut(3 * width).enumerate().for_each_init(Tracing::default, |tracing, (y, row)| {
        for (x, pixel) in row.chunks_exact_mut(3).enumerate() {
            let above = y * (width + 1) + x;
            let below = above + width + 1;
            let around = [corners[above], corners[above + 1], corners[below], corners[below + 1]];
            let colour = pixel_colour(&sight, exposure, around, (x, y), tracing);
            pixel.copy_from_slice(&colour.map(encode));
        }
    });
    Ok(Picture { width, height, pixels })
}

fn exposure(sight: &Sight, samples: &[Sample]) -> Exposure {
    let reflects = |sample: &&Sample| sample.surface.is_some_and(|surface| !sight.emits(surface));
    Exposure::of(samples.iter().filter(reflects).map(|sample| luminance(sample.colour)).collect())
}

/// Returns the mean colour of a pixel on the screen. Samples are compressed to the range of the
/// screen before the mean is taken. Otherwise one sample of a bright lamp among thirty-two would
/// saturate the pixel, and the edge of the lamp would be jagged.
fn pixel_colour(
    sight: &Sight,
    exposure: Exposure,
    corners: [Sample; 4],
    (x, y): (usize, usize),
    tracing: &mut Tracing,
) -> Colour {
    let shown = corners.map(|corner| exposure.screen(corner.colour));
    let uniform = (1..4).all(|i| corners[i].surface == corners[0].surface && !differ(shown[i], shown[0]));
    if uniform {
        return mean(shown.into_iter(), 4);
    }
    let samples = (0..EDGE_SAMPLES).map(|i| {
        let (u, v) = hammersley(i);
        exposure.screen(sight.sample(x as f64 + u, y as f64 + v, tracing).colour)
    });
    mean(samples, EDGE_SAMPLES)
}

fn mean(colours: impl Iterator<Item = Colour>, count: u32) -> Colour {
    let mut sum = [0.0; 3];
    for colour in colours {
        add_scaled(&mut sum, 1.0 / f64::from(count), colour);
    }
    sum
}

/// Returns the i-th point of the Hammersley set in the unit square: every column and every row of
/// width 1/32 contains one point.
fn hammersley(i: u32) -> (f64, f64) {
    let count = f64::from(EDGE_SAMPLES);
    let reversed = i.reverse_bits() >> (32 - EDGE_SAMPLES.trailing_zeros());
    ((f64::from(i) + 0.5) / count, (f64::from(reversed) + 0.5) / count)
}

impl Picture {
    /// The width in pixels.
    pub fn width(&self) -> usize {
        self.width
    }

    /// The height in pixels.
    pub fn height(&self) -> usize {
        self.height
    }

    /// Red, green and blue of each pixel, row by row from the upper left.
    pub fn pixels(&self) -> &[u8] {
        &self.pixels
    }

    /// The picture as a PNG file.
    pub fn png(&self) -> Result<Vec<u8>, png::EncodingError> {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.pixels)?;
        writer.finish()?;
        Ok(file)
    }
}
