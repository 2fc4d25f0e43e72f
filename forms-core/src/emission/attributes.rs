//! Lint attributes of emitted Rust functions.

use crate::kernel::Program;

/// Largest number of arguments of a function before clippy asks for a structure.
pub const MANY_ARGUMENTS: usize = 7;

/// Returns the lint attributes that the names and the number of the arguments make necessary, and
/// no others.
pub(super) fn attributes(program: &Program) -> String {
    let mut text = String::new();
    let parameters = &program.signature.parameters;
    if parameters.len() > MANY_ARGUMENTS {
        text.push_str(
            "#[allow(clippy::too_many_arguments, reason = \"one for each variable\")]
",
        );
    }
    let mut names = std::iter::once(&program.name).chain(parameters.iter().map(|parameter| &parameter.name));
    let is_snake_case =
        |name: &String| !name.chars().any(char::is_uppercase) && !name.trim_matches('_').contains("__");
    if !names.all(is_snake_case) {
        text.push_str("#[allow(non_snake_case, reason = \"the names of the formula\")]\n");
    }
    text
}
