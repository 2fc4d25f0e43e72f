//! Tone mapping: linear colour of any brightness becomes a colour for the screen.

use crate::spectrum::Colour;

/// Fraction of the samples on reflecting surfaces that is darker than the brightness mapped to
/// [`KEY`].
const PERCENTILE: f64 = 0.99;
/// Linear screen brightness of that percentile.
const KEY: f64 = 0.8;
/// Upper end of the linear part of the tone curve. Above it, brightness approaches 1 without
/// reaching it.
const SHOULDER: f64 = 0.7;

/// Factor from radiance to the brightness of the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Exposure(f64);

impl Exposure {
    /// Returns the exposure that shows the 99th percentile of these luminances at 0.8, or 1 for a
    /// picture without light.
    pub(crate) fn of(mut luminances: Vec<f64>) -> Self {
        if luminances.is_empty() {
            return Self(1.0);
        }
        let rank = ((luminances.len() - 1) as f64 * PERCENTILE) as usize;
        let (_, &mut bright, rest) = luminances.select_nth_unstable_by(rank, f64::total_cmp);
        let brightest = rest.iter().copied().fold(bright, f64::max);
        let reference = if bright > 0.0 { bright } else { brightest };
        Self(if reference > 0.0 { KEY / reference } else { 1.0 })
    }

    /// Returns the linear colour on the screen, each component from 0 to 1.
    ///
    /// Where the largest component m exceeds s = 0.7, it is compressed to s + (1 − s)(1 − e^(−(m −
    /// s)/(1 − s))), which is smooth at s. The other components are scaled in proportion, which
    /// keeps the hue.
    pub(crate) fn screen(self, colour: Colour) -> Colour {
        let exposed = colour.map(|component| (self.0 * component).max(0.0));
        let largest = exposed.into_iter().fold(0.0, f64::max);
        if largest <= SHOULDER {
            return exposed;
        }
        let room = 1.0 - SHOULDER;
        let compressed = 1.0 - room * (-(largest - SHOULDER) / room).exp();
        exposed.map(|component| component * (compressed / largest))
    }
}

/// Encodes a linear component in eight bits by the transfer function of sRGB (IEC 61966-2-1).
pub(crate) fn encode(linear: f64) -> u8 {
    let encoded = if linear <= 0.0031308 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (255.0 * encoded.clamp(0.0, 1.0)).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_percentile_is_shown_at_the_key() {
        let luminances: Vec<f64> = (0..=1000).map(|i| f64::from(i) * 0.01).rev().collect();
        assert_eq!(Exposure::of(luminances), Exposure(KEY / 9.9));
        assert_eq!(Exposure::of(vec![]), Exposure(1.0));
        assert_eq!(Exposure::of(vec![0.0; 9]), Exposure(1.0));
    }

    #[test]
    fn the_screen_never_overflows_and_keeps_the_order_of_brightness() {
        let mut last = 0.0;
        for i in 1..2000 {
            let [r, g, b] = Exposure(1.0).screen([f64::from(i) * 1e-3; 3]);
            assert!(r > last && r <= 1.0 && r == g && g == b, "{i}: {r}");
            last = r;
        }
        assert_eq!(Exposure(1.0).screen([1e9, -1.0, 0.0]), [1.0, 0.0, 0.0]);
    }

    #[test]
    fn the_transfer_function_is_that_of_srgb() {
        for (linear, expected) in
            [(0.0, 0), (0.0031308, 10), (0.21586, 128), (0.5, 188), (1.0, 255), (7.0, 255)]
        {
            assert_eq!(encode(linear), expected, "{linear}");
        }
    }
}
