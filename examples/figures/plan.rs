//! The decision whether an effect is simulated: three questions.

use crate::flat::{at, rectangle};
use forms_figures::{Colour, Drawing, Pen, View};

const WIDTH: f64 = 2.4;
const HEIGHT: f64 = 0.62;
/// Distance between the questions.
const STEP: f64 = 1.5;

pub(crate) fn figure() -> String {
    let mut drawing = Drawing::new(
        "Three questions for each effect",
        "Three questions for an effect: a trigger? a bound? does it fit in the tolerance? No trigger or a bound that \
         fits: off; else on",
        [620, 385],
        View::flat(68.0, [240.0, 50.0]),
    );
    let questions = ["Is there a trigger?", "Is there a bound?", "Does it fit?"];
    for (place, question) in (0..).zip(questions) {
        let y = -STEP * f64::from(place);
        let frame = rectangle([-WIDTH / 2.0, y - HEIGHT / 2.0], [WIDTH / 2.0, y + HEIGHT / 2.0]);
        drawing.area(&frame, 0.06, Pen::solid(Colour::Ink, 1.2));
        drawing.words_inside(at(0.0, y), question, Colour::Ink);
        drawing.arrow(at(0.0, y - HEIGHT / 2.0), at(0.0, HEIGHT - STEP), Pen::solid(Colour::Ink, 1.4));
        let (outcome, colour, shift) = match place {
            0 => ("off: it changes nothing", Colour::Blue, 104.0),
            _ => ("on", Colour::Vermilion, 20.0),
        };
        drawing.arrow(at(WIDTH / 2.0, y), at(0.9, 0.0), Pen::solid(colour, 1.4));
        drawing.words(at(WIDTH / 2.0 + 0.45, y), [0.0, -12.0], "no", Colour::Ink);
        drawing.words(at(WIDTH / 2.0 + 0.9, y), [shift, 0.0], outcome, colour);
        drawing.words(at(0.0, y - STEP / 2.0), [18.0, 0.0], "yes", Colour::Ink);
    }
    let last = -STEP * 3.0;
    drawing.words(at(0.0, last), [0.0, 6.0], "off: it changes less than is asked for", Colour::Blue);
    drawing.finish()
}
