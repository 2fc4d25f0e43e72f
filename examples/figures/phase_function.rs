//! The Henyey-Greenstein phase function as a polar diagram, for three mean cosines.

use crate::flat::at;
use forms_figures::{Colour, Drawing, Pen, View};
use std::f64::consts::PI;

/// Returns the phase function relative to isotropic scattering.
fn relative(g: f64, cosine: f64) -> f64 {
    (1.0 - g * g) / (1.0 + g * g - 2.0 * g * cosine).powf(1.5)
}

pub(crate) fn figure() -> String {
    let mut drawing = Drawing::new(
        "The phase function of Henyey and Greenstein",
        "Polar diagrams of the phase function: a circle for g = 0, and lobes to the right for g = 0.3 and g = 0.55",
        [620, 230],
        View::flat(48.0, [200.0, 115.0]),
    );
    drawing.arrow(at(-3.6, 0.0), at(3.4, 0.0), Pen::solid(Colour::Ink, 1.6));
    for (g, colour) in [(0.0, Colour::Blue), (0.3, Colour::Green), (0.55, Colour::Vermilion)] {
        drawing.curve(180, Pen::solid(colour, 1.8), |share| {
            let angle = 2.0 * PI * share;
            let radius = relative(g, angle.cos());
            at(radius * angle.cos(), radius * angle.sin())
        });
    }
    drawing.dot(at(0.0, 0.0), Colour::Ink);
    drawing.words(at(-2.9, 0.0), [0.0, -16.0], "light", Colour::Ink);
    drawing.label(at(-0.75, 0.75), [-26.0, -10.0], "g = 0", Colour::Blue);
    drawing.label(at(1.9, 0.0), [0.0, 0.0], "g = 0.3", Colour::Green);
    drawing.label(at(4.9, 0.0), [0.0, 0.0], "g = 0.55", Colour::Vermilion);
    drawing.finish()
}
