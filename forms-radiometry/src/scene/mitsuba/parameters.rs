//! Parameters: the values of `<default>`, which replace `$name` in attributes.

use roxmltree::Node;
use std::collections::HashMap;

/// The largest length of a value after substitution of parameters, which can refer to each other.
const LONGEST_VALUE: usize = 10_000;

/// The values of the parameters so far. The first definition of a parameter decides.
#[derive(Default)]
pub(super) struct Parameters {
    values: HashMap<String, String>,
}

impl Parameters {
    /// Defines the parameter of a `<default>`. A value that refers to a missing parameter is empty.
    pub(super) fn define(&mut self, node: Node) {
        let Some(name) = Self::name(node) else { return };
        let value = node.attribute("value").unwrap_or_default();
        let value = self.substitute(value).unwrap_or_default();
        self.values.entry(name.to_owned()).or_insert(value);
    }

    /// Returns the name of a parameter, if it is valid.
    pub(super) fn name<'n>(node: Node<'n, '_>) -> Option<&'n str> {
        let is_valid = |name: &&str| {
            !name.is_empty()
                && name.chars().all(|character| character.is_ascii_alphanumeric() || character == '_')
        };
        node.attribute("name").filter(is_valid)
    }

    /// Returns a text with the values of the parameters to which it refers, or a message and what
    /// was expected.
    pub(super) fn substitute(&self, text: &str) -> Result<String, (String, String)> {
        let mut parts = text.split('$');
        let mut value = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
            let end = part.find(|c| !is_name(c)).unwrap_or(part.len());
            let (parameter, rest) = part.split_at(end);
            let Some(put_in) = self.values.get(parameter) else {
                let expected = format!("<default name=\"{parameter}\" value=\"…\"/>");
                return Err((format!("there is no parameter `{parameter}`"), expected));
            };
            value = value + put_in + rest;
            if value.len() > LONGEST_VALUE {
                let message = "the value is too long after substitution of parameters";
                return Err((message.to_owned(), format!("at most {LONGEST_VALUE} characters")));
            }
        }
        Ok(value)
    }
}
