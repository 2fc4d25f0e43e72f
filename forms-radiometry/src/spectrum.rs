//! Colour: converts radiance in wavelength bands to linear sRGB, as seen by an eye adapted to the
//! lamps.

use crate::scene::{Band, LightKind, Scene};

/// Linear sRGB, or a weight for each of its components.
pub(crate) type Colour = [f64; 3];

type Matrix = [[f64; 3]; 3];

/// Matrix from XYZ to linear sRGB (IEC 61966-2-1).
const XYZ_TO_SRGB: Matrix =
    [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]];

/// The white point of sRGB, CIE illuminant D65.
const D65: [f64; 3] = [0.9505, 1.0, 1.089];

/// Matrix from XYZ to the cone responses of Lam's Bradford transform, and its inverse.
const BRADFORD: Matrix = [[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]];
const BRADFORD_INVERSE: Matrix = [
    [0.9869929, -0.1470543, 0.1599627],
    [0.4323053, 0.5183603, 0.0492912],
    [-0.0085287, 0.0400428, 0.9684867],
];

/// Returns the luminance of a linear sRGB colour.
pub(crate) fn luminance(colour: Colour) -> f64 {
    0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2]
}

/// Returns the contribution of each band to a colour, per unit of radiance in the band. The light
/// of all lamps together is white, as it appears to an eye adapted to it: a picture lit by a
/// reddish lamp is not reddish. Without bands, colours are grey.
pub(crate) fn band_colours(scene: &Scene) -> Vec<Colour> {
    if scene.bands.is_empty() {
        return vec![[1.0; 3]];
    }
    let bands: Vec<[f64; 3]> = scene.bands.iter().map(mean_response).collect();
    let mut white = [0.0; 3];
    let of_lights = scene.lights.iter().map(|light| match &light.kind {
        LightKind::Point { intensity, .. } => intensity,
        LightKind::Distant { irradiance, .. } => irradiance,
    });
    let of_surfaces = scene.surfaces.iter().map(|surface| &surface.radiance);
    for spectrum in of_surfaces.chain(of_lights).chain([&scene.ambient.radiance]) {
        for (&radiance, response) in spectrum.iter().zip(&bands) {
            add_scaled(&mut white, radiance, *response);
        }
    }
    bands.iter().map(|&response| apply(&XYZ_TO_SRGB, adapted(response, white))).collect()
}

/// Adds a multiple of a colour to a colour.
pub(crate) fn add_scaled(sum: &mut Colour, factor: f64, colour: Colour) {
    for (sum, component) in sum.iter_mut().zip(colour) {
        *sum += factor * component;
    }
}

/// Adapts an XYZ colour from a white point to D65: the cone responses are scaled by the ratio of
/// the responses of the two white points (von Kries).
fn adapted(xyz: [f64; 3], white: [f64; 3]) -> [f64; 3] {
    if white.iter().any(|&component| component <= 0.0) {
        return xyz;
    }
    let (from, to) = (apply(&BRADFORD, white.map(|component| component / white[1])), apply(&BRADFORD, D65));
    let cones = apply(&BRADFORD, xyz);
    apply(&BRADFORD_INVERSE, std::array::from_fn(|i| cones[i] * to[i] / from[i]))
}

fn apply(matrix: &Matrix, v: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

/// Returns the mean of the colour matching functions over a band, by the midpoint rule with
/// intervals of 1 nm or less.
fn mean_response(band: &Band) -> [f64; 3] {
    let low = band.low.clamp(300.0, 900.0);
    let high = band.high.clamp(300.0, 900.0);
    let count = (high - low).ceil().max(1.0);
    let step = (high - low) / count;
    let mut sum = [0.0; 3];
    for i in 0..count as usize {
        add_scaled(&mut sum, step / (band.high - band.low), colour_matching(low + (i as f64 + 0.5) * step));
    }
    sum
}

/// Returns the CIE 1931 2° colour matching functions x̄, ȳ, z̄ at a wavelength in nm, by the
/// multi-lobe fit of Wyman, Sloan and Shirley, "Simple analytic approximations to the CIE XYZ color
/// matching functions", JCGT 2(2), 2013.
fn colour_matching(wavelength: f64) -> [f64; 3] {
    let lobe = |height: f64, peak: f64, left: f64, right: f64| {
        let t = (wavelength - peak) / if wavelength < peak { left } else { right };
        height * (-0.5 * t * t).exp()
    };
    [
        lobe(1.056, 599.8, 37.9, 31.0) + lobe(0.362, 442.0, 16.0, 26.7) + lobe(-0.065, 501.1, 20.4, 26.2),
        lobe(0.821, 568.8, 46.9, 40.5) + lobe(0.286, 530.9, 16.3, 31.1),
        lobe(1.217, 437.0, 11.8, 36.0) + lobe(0.681, 459.0, 26.0, 13.8),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CORNELL_BOX, scene};

    #[test]
    fn the_colour_matching_functions_are_those_of_the_cie_table() {
        // CIE 1931 2°, CIE 15:2004, at 450, 550 and 600 nm; the fit stays within 0.03 of it.
        for (wavelength, expected) in [
            (450.0, [0.3362, 0.0380, 1.7721]),
            (550.0, [0.4334, 0.9950, 0.0087]),
            (600.0, [1.0622, 0.6310, 0.0008]),
        ] {
            let found = colour_matching(wavelength);
            for i in 0..3 {
                assert!((found[i] - expected[i]).abs() < 0.03, "{wavelength} nm: {found:?}");
            }
        }
    }

    #[test]
    fn the_light_of_the_lamps_is_white() {
        let scene = scene::read(CORNELL_BOX, "cornell_box.toml").unwrap();
        let mut colour = [0.0; 3];
        for (&radiance, band) in scene.surfaces[0].radiance.iter().zip(band_colours(&scene)) {
            add_scaled(&mut colour, radiance, band);
        }
        for component in colour {
            assert!((component / colour[1] - 1.0).abs() < 1e-3, "{colour:?}");
        }
    }

    #[test]
    fn bands_outside_the_visible_are_black() {
        for band in [Band { low: 1000.0, high: 2000.0 }, Band { low: 100.0, high: 200.0 }] {
            assert_eq!(mean_response(&band), [0.0; 3]);
        }
    }
}
