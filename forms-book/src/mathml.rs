//! Conversion of LaTeX to MathML.

use pulldown_latex::config::DisplayMode;
use pulldown_latex::event::Event;
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

/// Longest formula shown, in characters of LaTeX. Longer ones are omitted: they are unreadable and
/// slow to typeset.
pub const LONGEST_FORMULA: usize = 4000;

/// Converts a displayed formula to one `<math>` element.
///
/// # Errors
/// If the formula cannot be parsed: the message and its position.
pub fn display(latex: &str) -> Result<String, String> {
    mathml(latex, DisplayMode::Block)
}

/// Converts an inline formula to one `<math>` element.
///
/// # Errors
/// If the formula cannot be parsed: the message and its position.
pub fn inline(latex: &str) -> Result<String, String> {
    mathml(latex, DisplayMode::Inline)
}

fn mathml(latex: &str, display_mode: DisplayMode) -> Result<String, String> {
    let storage = Storage::new();
    // The MathML writer would render a parse error as part of the formula.
    let events: Result<Vec<Event<'_>>, _> = Parser::new(latex, &storage).collect();
    let events = events.map_err(|error| error.to_string())?;
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    let mut mathml = String::new();
    let events = events.into_iter().map(Ok::<_, std::fmt::Error>);
    push_mathml(&mut mathml, events, config).map_err(|error| error.to_string())?;
    Ok(with_spaces_outside(&escaped_outside_tags(&mathml)))
}

/// Escapes the signs < and >, which the MathML writer leaves as they are. A tag begins with a
/// letter or a slash; neither follows a sign.
fn escaped_outside_tags(mathml: &str) -> String {
    let (mut result, mut is_tag) = (String::with_capacity(mathml.len()), false);
    let mut characters = mathml.chars().peekable();
    while let Some(character) = characters.next() {
        let begins_tag = characters.peek().is_some_and(|next| next.is_ascii_alphabetic() || *next == '/');
        match character {
            '<' if !is_tag && !begins_tag => result.push_str("&lt;"),
            '>' if !is_tag => result.push_str("&gt;"),
            _ => {
                is_tag = if is_tag { character != '>' } else { character == '<' };
                result.push(character);
            }
        }
    }
    result
}

/// Moves spaces out of elements with scripts. The MathML writer puts the space before an operator
/// with scripts inside that element, as an additional child: `<msup><mspace/><mi>cos</mi>…`. The
/// space belongs before the element.
fn with_spaces_outside(mathml: &str) -> String {
    let elements = ["msub", "msup", "msubsup", "munder", "mover", "munderover"];
    let (mut result, mut rest) = (String::with_capacity(mathml.len()), mathml);
    while let Some(start) = rest.find("><mspace") {
        let (before, behind) = rest.split_at(start + 1);
        let element =
            elements.iter().map(|name| format!("<{name}>")).find(|tag| before.ends_with(tag.as_str()));
        let length = behind.find('>').map_or(behind.len(), |end| end + 1);
        let (space, behind) = behind.split_at(length);
        let tag = element.unwrap_or_default();
        result.push_str(&before[..before.len() - tag.len()]);
        result.push_str(space);
        result.push_str(&tag);
        rest = behind;
    }
    result + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_of_order_are_no_tags() {
        let mathml = inline("0 < x > y").expect("a formula");
        assert!(mathml.contains("<mo>&lt;</mo><mi>x</mi><mo>&gt;</mo><mi>y</mi></math>"), "{mathml}");
        let mathml = inline("\\text{a < b}").expect("a formula");
        assert_eq!(mathml.matches('<').count(), mathml.matches('>').count(), "{mathml}");
        assert!(mathml.contains("a &lt; b"), "{mathml}");
    }

    #[test]
    fn elements_with_scripts_have_no_child_too_many() {
        let cases =
            ["\\sin x\\,\\cos^2 x", "x\\sum_{k=0}^n a_k", "x\\,\\max_{k} a_k", "\\int_0^1 x\\,\\log_2 x"];
        for latex in cases {
            for mathml in [inline(latex), display(latex)] {
                let mathml = mathml.expect(latex);
                for element in ["msub", "msup", "msubsup", "munder", "mover", "munderover"] {
                    assert!(!mathml.contains(&format!("<{element}><mspace")), "{latex}: {mathml}");
                }
            }
        }
        let mathml = inline("x\\,\\cos^2 y").expect("a formula");
        assert!(mathml.contains("<mspace width=\"0.1667em\" /><msup><mi>cos</mi>"), "{mathml}");
    }

    #[test]
    fn a_formula_that_cannot_be_read_is_an_error() {
        assert!(inline("\\frac{1}{2} \\wedge x").is_ok_and(|mathml| mathml.starts_with("<math")));
        for latex in ["\\frac{1}{", "\\nosuchcommand", "x^", "\\begin{pmatrix} 1"] {
            assert!(display(latex).is_err(), "{latex}");
        }
    }
}
