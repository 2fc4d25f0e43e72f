//! Rust source: one function a kernel, its documentation above it, every value as the program computes it.
//!
//! Emission never simplifies. A value used once is written where it is used as long as the line stays short;
//! the others are named `t0`, `t1`, … in the order of their computation.

mod body;
mod number;

use super::program::{Instruction, Program};

/// The longest line of a signature.
const WIDTH: usize = 100;
/// The most arguments a function has before clippy asks for a structure.
const MANY_ARGUMENTS: usize = 7;

/// What is said above the function.
#[derive(Clone, Debug, Default)]
pub struct RustDocs {
    /// The formula, in the language's notation, one line or several.
    pub formula: String,
    /// The names of the statements the formula rests on.
    pub statements: Vec<String>,
    /// Under which conditions.
    pub conditions: Vec<String>,
    /// The units of arguments and results, where they are known.
    pub units: String,
    /// What is known of the agreement of the program with the formula.
    pub translation: String,
    /// The author's own lines.
    pub docs: Vec<String>,
}

/// A documented function that needs nothing but the standard library.
pub fn emit_rust(program: &Program, docs: &RustDocs) -> String {
    let mut source = documentation(program, docs);
    source.push_str(&attributes(program));
    source.push_str(&signature(program));
    source.push_str(" {\n");
    body::write(program, &mut source);
    source.push_str("}\n");
    source
}

fn documentation(program: &Program, docs: &RustDocs) -> String {
    let mut lines = docs.docs.clone();
    if !docs.formula.is_empty() {
        separate(&mut lines);
        lines.push("```text".to_string());
        lines.extend(docs.formula.lines().map(str::to_string));
        lines.push("```".to_string());
    }
    if !docs.units.is_empty() {
        separate(&mut lines);
        lines.push(docs.units.clone());
    }
    if !docs.statements.is_empty() {
        separate(&mut lines);
        lines.push(format!("Rests on {}.", quoted(&docs.statements)));
    }
    if !docs.conditions.is_empty() {
        separate(&mut lines);
        lines.push(format!("Holds where {}.", quoted(&docs.conditions)));
    }
    if !docs.translation.is_empty() {
        separate(&mut lines);
        lines.push(docs.translation.clone());
    }
    separate(&mut lines);
    let outside = if program.domain.is_empty() { "" } else { " outside its domain and" };
    lines.push(format!("Its value is NaN{outside} where an argument it depends on is NaN."));
    lines.push(format!("Takes {}.", program.operations()));
    lines.iter().fold(String::new(), |text, line| {
        let line = line.trim();
        text + "///" + if line.is_empty() { "" } else { " " } + line + "\n"
    })
}

fn separate(lines: &mut Vec<String>) {
    if !lines.is_empty() {
        lines.push(String::new());
    }
}

fn quoted(items: &[String]) -> String {
    items.iter().map(|item| format!("`{item}`")).collect::<Vec<_>>().join(", ")
}

/// Only the lints that the names and the number of the arguments make necessary.
fn attributes(program: &Program) -> String {
    let mut text = String::new();
    if program.arguments.len() > MANY_ARGUMENTS {
        text.push_str(
            "#[allow(clippy::too_many_arguments, reason = \"one for each variable\")]
",
        );
    }
    let names = std::iter::once(&program.name).chain(&program.arguments);
    if names.flat_map(|name| name.chars()).any(char::is_uppercase) {
        text.push_str("#[allow(non_snake_case, reason = \"the names of the formula\")]\n");
    }
    text
}

fn signature(program: &Program) -> String {
    let used = |place: usize| program.instructions.contains(&Instruction::Argument(place as u32));
    let arguments: Vec<String> = program
        .arguments
        .iter()
        .enumerate()
        .map(|(place, name)| format!("{}{name}: f64", if used(place) { "" } else { "_" }))
        .collect();
    let public = if program.public { "pub " } else { "" };
    let result = match program.outputs.len() {
        1 => "f64".to_string(),
        several => format!("[f64; {several}]"),
    };
    let name = &program.name;
    let line = format!("{public}fn {name}({}) -> {result}", arguments.join(", "));
    if line.len() + 2 <= WIDTH {
        return line;
    }
    let arguments: String = arguments.iter().map(|argument| format!("    {argument},\n")).collect();
    format!("{public}fn {name}(\n{arguments}) -> {result}")
}
