//! LaTeX to MathML.

use pulldown_latex::config::DisplayMode;
use pulldown_latex::event::Event;
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

/// A formula on lines of its own as one `<math>` element.
///
/// # Errors
/// If the formula cannot be read: what is wrong, and where in it.
pub fn display(latex: &str) -> Result<String, String> {
    mathml(latex, DisplayMode::Block)
}

/// A formula within a line as one `<math>` element.
///
/// # Errors
/// If the formula cannot be read: what is wrong, and where in it.
pub fn inline(latex: &str) -> Result<String, String> {
    mathml(latex, DisplayMode::Inline)
}

fn mathml(latex: &str, display_mode: DisplayMode) -> Result<String, String> {
    let storage = Storage::new();
    // The writer would make an error part of the formula.
    let events: Result<Vec<Event<'_>>, _> = Parser::new(latex, &storage).collect();
    let events = events.map_err(|error| error.to_string())?;
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    let mut mathml = String::new();
    let events = events.into_iter().map(Ok::<_, std::fmt::Error>);
    push_mathml(&mut mathml, events, config).map_err(|error| error.to_string())?;
    Ok(mathml)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_that_cannot_be_read_is_an_error() {
        assert!(inline("\\frac{1}{2} \\wedge x").is_ok_and(|mathml| mathml.starts_with("<math")));
        for latex in ["\\frac{1}{", "\\nosuchcommand", "x^", "\\begin{pmatrix} 1"] {
            assert!(display(latex).is_err(), "{latex}");
        }
    }
}
