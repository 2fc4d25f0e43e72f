//! The theme: colours with a light and a dark variant, the font stack, and the style sheet of a file.
//!
//! Elements name a colour by class. The style sheet defines the classes in use, first for light pages
//! and then, below a media query, for dark pages; a renderer without media queries draws the light
//! variant. The hues are those of Okabe and Ito, *Color Universal Design* (2008), with a
//! lightness at which text in them can be read on the paper and at which they differ without red or
//! without green cones.

use std::collections::BTreeSet;
use std::fmt::Write;

/// Fonts of all texts, in order of preference.
pub(crate) const FONTS: &str = "system-ui,'Segoe UI','Helvetica Neue',Arial,'DejaVu Sans',sans-serif";

/// Colour of the theme.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Colour {
    /// Background.
    Paper,
    /// Text and axes.
    Ink,
    /// Notes and numbers of axes.
    Quiet,
    /// Auxiliary lines of drawings.
    Faint,
    /// Grid lines.
    Grid,
    /// Fine grid lines, within a decade.
    FineGrid,
    /// First colour of data.
    Blue,
    /// Second colour of data.
    Vermilion,
    /// Third colour of data.
    Green,
    /// Fourth colour of data.
    Purple,
    /// Fifth colour of data.
    Ochre,
}

impl Colour {
    /// Colours of data, in the order in which series take them.
    pub const DATA: [Self; 5] = [Self::Blue, Self::Vermilion, Self::Green, Self::Purple, Self::Ochre];

    const ALL: [Self; 11] = [
        Self::Paper,
        Self::Ink,
        Self::Quiet,
        Self::Faint,
        Self::Grid,
        Self::FineGrid,
        Self::Blue,
        Self::Vermilion,
        Self::Green,
        Self::Purple,
        Self::Ochre,
    ];

    /// Returns the variants on light and on dark paper, as 0xRRGGBB.
    fn variants(self) -> [u32; 2] {
        match self {
            Self::Paper => [0xff_ff_ff, 0x17_1a_1f],
            Self::Ink => [0x1f_23_28, 0xe6_e8_eb],
            Self::Quiet => [0x59_61_6b, 0xa3_ab_b5],
            Self::Faint => [0x8f_97_a1, 0x7a_83_8e],
            Self::Grid => [0xdd_e1_e6, 0x33_39_41],
            Self::FineGrid => [0xee_f0_f3, 0x24_29_30],
            Self::Blue => [0x00_63_b1, 0x4f_9d_f5],
            Self::Vermilion => [0xc4_46_01, 0xff_a2_5c],
            Self::Green => [0x04_81_5f, 0x86_ef_d2],
            Self::Purple => [0x6f_1d_5f, 0xea_6c_b0],
            Self::Ochre => [0x5c_4a_00, 0xb8_94_1f],
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::Ink => "ink",
            Self::Quiet => "quiet",
            Self::Faint => "faint",
            Self::Grid => "grid",
            Self::FineGrid => "fine",
            Self::Blue => "blue",
            Self::Vermilion => "vermilion",
            Self::Green => "green",
            Self::Purple => "purple",
            Self::Ochre => "ochre",
        }
    }

    /// Returns the number of the colour, by which it passes through plotters.
    pub(crate) fn number(self) -> u8 {
        self as u8
    }

    /// Returns the colour of a number.
    pub(crate) fn of_number(number: u8) -> Self {
        Self::ALL[usize::from(number) % Self::ALL.len()]
    }
}

/// Use of a colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Use {
    Fill,
    Stroke,
}

/// Colours in use, and their style sheet.
#[derive(Clone, Debug, Default)]
pub(crate) struct StyleSheet(BTreeSet<(Use, Colour)>);

impl StyleSheet {
    /// Returns the class of a use of a colour, and adds it to the sheet.
    pub(crate) fn class(&mut self, of: Use, colour: Colour) -> String {
        self.0.insert((of, colour));
        class(of, colour)
    }

    /// Returns the text of the sheet.
    pub(crate) fn text(&self) -> String {
        let rules = |variant: usize| {
            self.0.iter().fold(String::new(), |mut rules, &(of, colour)| {
                let property = if of == Use::Fill { "fill" } else { "stroke" };
                let value = colour.variants()[variant];
                write!(rules, ".{}{{{property}:#{value:06x}}}", class(of, colour))
                    .expect("a String takes all text");
                rules
            })
        };
        format!("{}\n@media(prefers-color-scheme:dark){{{}}}", rules(0), rules(1))
    }
}

fn class(of: Use, colour: Colour) -> String {
    let prefix = if of == Use::Fill { "fill" } else { "line" };
    format!("{prefix}-{}", colour.name())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns red, green and blue in linear light.
    fn linear(colour: u32) -> [f64; 3] {
        [16, 8, 0].map(|shift| {
            let share = f64::from((colour >> shift) & 0xff) / 255.0;
            if share <= 0.040_45 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
        })
    }

    fn applied(matrix: [[f64; 3]; 3], vector: [f64; 3]) -> [f64; 3] {
        matrix.map(|row| row.iter().zip(vector).map(|(a, b)| a * b).sum())
    }

    /// Contrast of two colours, W3C *Web Content Accessibility Guidelines* 2.1.
    fn contrast(one: u32, other: u32) -> f64 {
        let luminance = |colour| applied([[0.2126, 0.7152, 0.0722]; 3], linear(colour))[0] + 0.05;
        let [one, other] = [luminance(one), luminance(other)];
        one.max(other) / one.min(other)
    }

    /// Distance of two colours in linear light, in Oklab (Ottosson 2020).
    fn distance(one: [f64; 3], other: [f64; 3]) -> f64 {
        let lab = |light| {
            let cones = [
                [0.412_221, 0.536_333, 0.051_446],
                [0.211_904, 0.680_700, 0.107_397],
                [0.088_302, 0.281_719, 0.629_979],
            ];
            let mixed = [
                [0.210_454, 0.793_618, -0.004_072],
                [1.977_998, -2.428_592, 0.450_594],
                [0.025_904, 0.782_772, -0.808_676],
            ];
            applied(mixed, applied(cones, light).map(f64::cbrt))
        };
        let [one, other] = [lab(one), lab(other)];
        one.iter().zip(other).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    }

    #[test]
    fn text_in_every_colour_of_data_can_be_read_on_light_and_on_dark_paper() {
        for variant in 0..2 {
            let of = |colour: Colour| colour.variants()[variant];
            for colour in Colour::DATA.into_iter().chain([Colour::Ink, Colour::Quiet]) {
                let found = contrast(of(colour), of(Colour::Paper));
                assert!(found >= 4.5, "{colour:?}: {found}");
            }
        }
    }

    #[test]
    fn colours_of_data_are_distinguished_without_red_or_without_green_cones() {
        // Machado, Oliveira and Fernandes 2009: protanopia and deuteranopia
        let protanopia = [[0.152, 1.053, -0.205], [0.115, 0.786, 0.099], [-0.004, -0.048, 1.052]];
        let deuteranopia = [[0.367, 0.861, -0.228], [0.280, 0.673, 0.047], [-0.012, 0.043, 0.969]];
        for (variant, sight) in [(0, protanopia), (0, deuteranopia), (1, protanopia), (1, deuteranopia)] {
            let seen = |colour: Colour| {
                applied(sight, linear(colour.variants()[variant])).map(|light| light.max(0.0))
            };
            for (place, &one) in Colour::DATA.iter().enumerate() {
                for &other in &Colour::DATA[..place] {
                    let found = distance(seen(one), seen(other));
                    assert!(found > 0.07, "{one:?} and {other:?}, variant {variant}: {found}");
                }
            }
        }
    }

    #[test]
    fn a_sheet_has_both_variants_of_the_colours_in_use_only() {
        let mut sheet = StyleSheet::default();
        sheet.class(Use::Fill, Colour::Paper);
        assert_eq!(
            sheet.text(),
            ".fill-paper{fill:#ffffff}\n@media(prefers-color-scheme:dark){.fill-paper{fill:#171a1f}}"
        );
    }

    #[test]
    fn every_colour_passes_through_its_number() {
        assert!(Colour::ALL.into_iter().all(|colour| Colour::of_number(colour.number()) == colour));
    }
}
