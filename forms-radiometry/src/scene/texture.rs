//! Textures: a reflectance that depends on the place on a surface.
//!
//! ```text
//! place ─ texture coordinates (u, v) ─ map ─▶ pattern: an image, or a checkerboard ─▶ factor
//! ```
//! The material of the surface holds the largest reflectance of any place. The factor of a place is its
//! reflectance relative to that, so that bounds on the material hold for the surface.

use super::midrange::middle;
use crate::geometry::{Affine, Vector};
use std::sync::Arc;

/// A texture of the reflectance of a surface.
#[derive(Clone, Debug)]
pub struct Texture {
    pub(crate) pattern: Arc<Pattern>,
    pub(crate) coordinates: TextureCoordinates,
}

impl Texture {
    /// Returns the texture in a single band; `most` is the reflectance of the material in each band.
    pub(crate) fn with_one_band(&self, most: &[f64]) -> Self {
        let pattern = Arc::new(self.pattern.with_one_band(most));
        Self { pattern, coordinates: self.coordinates.clone() }
    }
}

/// Texture coordinates of a surface.
#[derive(Clone, Debug)]
pub(crate) enum TextureCoordinates {
    /// Those at the corners of a parallelogram.
    Corners(Vec<[f64; 2]>),
    /// Those that a mesh of triangles has.
    Mesh,
    /// Those of a sphere or a disk with these unit axes: by the azimuth from the first axis towards the
    /// second, and by the angle to the third or the distance from the centre.
    Polar([Vector; 3]),
}

/// A reflectance that depends on texture coordinates.
#[derive(Clone, Debug)]
pub(crate) struct Pattern {
    /// The map of texture coordinates, of which z is ignored.
    to_uv: Affine,
    picture: Picture,
    /// For each band, the part s of light that reflections inside a coat of plastic return to the place
    /// with the largest reflectance: a factor t becomes t (1 − s)/(1 − s t).
    returned: Vec<f64>,
}

/// Values of a pattern in each band, from 0 to 1.
#[derive(Clone, Debug)]
pub(crate) enum Picture {
    /// Colours of the fields in which ⌊2u⌋ and ⌊2v⌋ are both even or both odd, and of the others.
    Checkerboard([Vec<f64>; 2]),
    /// An image, whose first row is at v = 0.
    Image { resolution: [usize; 2], values: Vec<f32>, filter: Filter, wrap: Wrap },
}

/// Interpolation between the pixels of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Filter {
    /// Linear between the centres of pixels.
    Bilinear,
    /// Constant on each pixel.
    Nearest,
}

/// Continuation of an image beyond its borders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wrap {
    Repeat,
    Mirror,
    Clamp,
}

impl Wrap {
    /// Returns the pixel along a side of this length that stands for another one.
    fn pixel(self, place: f64, count: usize) -> usize {
        let side = count as f64;
        let within = match self {
            Self::Repeat => place.rem_euclid(side),
            Self::Clamp => place,
            Self::Mirror => {
                let twice = place.rem_euclid(2.0 * side);
                if twice < side { twice } else { 2.0 * side - 1.0 - twice }
            }
        };
        // the conversion saturates at zero
        (within as usize).min(count - 1)
    }
}

impl Pattern {
    /// Returns a pattern, and its largest value in each band. With an inner reflectance, it is the base
    /// of plastic whose reflections inside the coat depend on the place.
    pub(crate) fn new(mut picture: Picture, to_uv: Affine, inner: f64, bands: usize) -> (Self, Vec<f64>) {
        let most = picture.most(bands);
        picture.divide(&most);
        let returned = most.iter().map(|most| inner * most).collect();
        (Self { to_uv, picture, returned }, most)
    }

    /// Returns the factors of `N` bands, of which `count` are used, from the first one on.
    pub(crate) fn factor<const N: usize>(&self, uv: [f64; 2], [first, count]: [usize; 2]) -> [f64; N] {
        let [x, y, _] = self.to_uv.columns;
        let shift = self.to_uv.shift;
        let [u, v] = [uv[0] * x.x + uv[1] * y.x + shift.x, uv[0] * x.y + uv[1] * y.y + shift.y];
        let lookup = self.picture.lookup([u, v]);
        std::array::from_fn(|band| {
            if band >= count {
                return 0.0;
            }
            let factor = self.picture.value(&lookup, first + band, self.returned.len());
            let returned = self.returned[first + band];
            factor * (1.0 - returned) / (1.0 - returned * factor)
        })
    }

    /// Returns the pattern in a single band, where the value of a place is halfway between the smallest
    /// and the largest of its bands; `most` is the reflectance of the material in each band.
    fn with_one_band(&self, most: &[f64]) -> Self {
        let picture = self.picture.with_one_band(most);
        Self { to_uv: self.to_uv, picture, returned: vec![middle(&self.returned)] }
    }
}

/// Pixels with their weights.
type Lookup = [(usize, f64); 4];

impl Picture {
    /// Returns the places of a picture that determine its value at these coordinates.
    fn lookup(&self, [u, v]: [f64; 2]) -> Lookup {
        match self {
            Self::Checkerboard(_) => {
                let is_second = ((2.0 * u).floor() - (2.0 * v).floor()).rem_euclid(2.0) == 1.0;
                [(usize::from(is_second), 1.0), (0, 0.0), (0, 0.0), (0, 0.0)]
            }
            Self::Image { resolution: [width, height], filter, wrap, .. } => {
                let pixel = |x: f64, y: f64| wrap.pixel(y, *height) * width + wrap.pixel(x, *width);
                let [x, y] = [u * *width as f64, v * *height as f64];
                if let Filter::Nearest = filter {
                    return [(pixel(x.floor(), y.floor()), 1.0), (0, 0.0), (0, 0.0), (0, 0.0)];
                }
                let [left, top] = [(x - 0.5).floor(), (y - 0.5).floor()];
                let [p, q] = [x - 0.5 - left, y - 0.5 - top];
                [
                    (pixel(left, top), (1.0 - p) * (1.0 - q)),
                    (pixel(left + 1.0, top), p * (1.0 - q)),
                    (pixel(left, top + 1.0), (1.0 - p) * q),
                    (pixel(left + 1.0, top + 1.0), p * q),
                ]
            }
        }
    }

    fn value(&self, lookup: &Lookup, band: usize, bands: usize) -> f64 {
        match self {
            Self::Checkerboard(colours) => colours[lookup[0].0][band],
            Self::Image { values, .. } => lookup
                .iter()
                .filter(|(_, weight)| *weight > 0.0)
                .map(|&(pixel, weight)| weight * f64::from(values[pixel * bands + band]))
                .sum(),
        }
    }

    /// Returns the largest value in each band.
    fn most(&self, bands: usize) -> Vec<f64> {
        let mut most = vec![0.0; bands];
        let mut raise = |band: usize, value: f64| most[band] = value.max(most[band]);
        match self {
            Self::Checkerboard(colours) => {
                for colour in colours {
                    colour.iter().enumerate().for_each(|(band, &value)| raise(band, value));
                }
            }
            Self::Image { values, .. } => {
                values.iter().enumerate().for_each(|(place, &value)| raise(place % bands, f64::from(value)));
            }
        }
        most
    }

    /// Divides the values of each band by the largest one.
    fn divide(&mut self, most: &[f64]) {
        let relative = |value: f64, most: f64| if most > 0.0 { value / most } else { 0.0 };
        match self {
            Self::Checkerboard(colours) => {
                for colour in colours {
                    colour.iter_mut().zip(most).for_each(|(value, &most)| *value = relative(*value, most));
                }
            }
            Self::Image { values, .. } => {
                for (place, value) in values.iter_mut().enumerate() {
                    *value = relative(f64::from(*value), most[place % most.len()]) as f32;
                }
            }
        }
    }

    fn with_one_band(&self, most: &[f64]) -> Self {
        let whole = middle(most);
        let merged = |values: &mut dyn Iterator<Item = f64>| {
            let reflectances: Vec<f64> = values.zip(most).map(|(value, most)| value * most).collect();
            if whole > 0.0 { middle(&reflectances) / whole } else { 0.0 }
        };
        match self {
            Self::Checkerboard(colours) => {
                Self::Checkerboard(colours.each_ref().map(|colour| vec![merged(&mut colour.iter().copied())]))
            }
            Self::Image { resolution, values, filter, wrap } => {
                let pixels = values.chunks_exact(most.len());
                let of_pixel =
                    |pixel: &[f32]| merged(&mut pixel.iter().map(|&value| f64::from(value))) as f32;
                let (resolution, filter, wrap) = (*resolution, *filter, *wrap);
                Self::Image { resolution, values: pixels.map(of_pixel).collect(), filter, wrap }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An image of 3 × 2 pixels, of which the first two and the last one are 1 in one band each, and
    /// its values in Mitsuba 3.9.1 at texture coordinates.
    const VALUES: [(Filter, Wrap, [f64; 2], [f64; 3]); 8] = [
        (Filter::Nearest, Wrap::Repeat, [1.3, 1.2], [1.0, 0.0, 0.0]),
        (Filter::Nearest, Wrap::Mirror, [1.3, 1.2], [0.0, 0.0, 1.0]),
        (Filter::Nearest, Wrap::Clamp, [0.5, 0.25], [0.0, 1.0, 0.0]),
        (Filter::Bilinear, Wrap::Repeat, [1.3, 1.2], [0.54, 0.36, 0.0]),
        (Filter::Bilinear, Wrap::Mirror, [1.3, 1.2], [0.0, 0.0, 0.6]),
        (Filter::Bilinear, Wrap::Clamp, [1.3, 1.2], [0.0, 0.0, 1.0]),
        (Filter::Bilinear, Wrap::Clamp, [-0.1, 0.2], [1.0, 0.0, 0.0]),
        (Filter::Bilinear, Wrap::Repeat, [0.5, 0.25], [0.0, 1.0, 0.0]),
    ];

    #[test]
    fn images_have_the_values_of_mitsuba() {
        for (filter, wrap, uv, expected) in VALUES {
            let mut values = vec![0.0; 18];
            [0, 4, 17].iter().for_each(|&place: &usize| values[place] = 1.0);
            let picture = Picture::Image { resolution: [3, 2], values, filter, wrap };
            let (pattern, most) = Pattern::new(picture, Affine::IDENTITY, 0.0, 3);
            let found: [f64; 3] = pattern.factor(uv, [0, 3]);
            let is_near = found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-9);
            assert!(is_near && most == [1.0; 3], "{filter:?} {wrap:?} {uv:?}: {found:?}");
        }
    }

    #[test]
    fn a_single_band_is_the_middle_of_all_bands() {
        let picture = Picture::Checkerboard([vec![0.2, 0.8], vec![0.4, 0.4]]);
        let (pattern, most) = Pattern::new(picture, Affine::IDENTITY, 0.0, 2);
        assert_eq!(most, [0.4, 0.8]);
        let one = pattern.with_one_band(&most);
        let value = |uv: [f64; 2]| one.factor::<1>(uv, [0, 1])[0] * 0.6;
        assert!((value([0.1, 0.1]) - 0.5).abs() < 1e-12 && (value([0.1, 0.6]) - 0.4).abs() < 1e-12);
    }
}
