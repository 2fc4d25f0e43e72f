//! Text style, and estimates of the width of a text.

use crate::Colour;

/// Mean width of a character, in font sizes, for names, numbers and short sentences.
const CHARACTER: f64 = 0.54;

/// Part of a text that is at its given position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// Left end.
    Start,
    /// Middle.
    Middle,
    /// Right end.
    End,
}

impl Anchor {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Middle => "middle",
            Self::End => "end",
        }
    }
}

/// Text style.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// Part of the text that is at its position.
    pub anchor: Anchor,
    /// Font size, in paper units.
    pub size: f64,
    /// Colour.
    pub colour: Colour,
    /// Whether the text is bold.
    pub bold: bool,
    /// Whether the text is slanted, as symbols are.
    pub italic: bool,
}

impl Style {
    /// Creates an upright style that starts at its position.
    pub fn of(size: f64, colour: Colour) -> Self {
        Self { anchor: Anchor::Start, size, colour, bold: false, italic: false }
    }

    /// Returns the style with another anchor.
    pub fn anchored(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }

    /// Returns the bold style.
    pub fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    /// Returns the slanted style.
    pub fn italic(self) -> Self {
        Self { italic: true, ..self }
    }
}

/// Estimates the width of a text.
pub fn width(content: &str, size: f64) -> f64 {
    content.chars().count() as f64 * size * CHARACTER
}
