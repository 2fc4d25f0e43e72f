//! Documentation of emitted functions: the formula, the statements that it rests on, and its cost.

use crate::kernel::Program;

/// Documentation of an emitted function.
#[derive(Clone, Debug, Default)]
pub struct KernelDocs {
    /// Formula in the language's notation, on one line or several.
    pub formula: String,
    /// Names of the statements that the formula rests on.
    pub statements: Vec<String>,
    /// Conditions under which it holds.
    pub conditions: Vec<String>,
    /// Units of arguments and results, if known.
    pub units: String,
    /// Verdict on the agreement of the program with the formula.
    pub translation: String,
    /// Bound of the error in `f64`, if there is one.
    pub rounding: String,
    /// Lines that the author wrote.
    pub docs: Vec<String>,
}

/// Writes the lines above a function, each with the prefix `comment`.
pub(super) fn documentation(program: &Program, docs: &KernelDocs, comment: &str) -> String {
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
        lines.push(format!("Statements used: {}.", quoted(&docs.statements)));
    }
    if !docs.conditions.is_empty() {
        separate(&mut lines);
        lines.push(format!("Holds where {}.", quoted(&docs.conditions)));
    }
    if !docs.translation.is_empty() {
        separate(&mut lines);
        lines.push(docs.translation.clone());
    }
    if !docs.rounding.is_empty() {
        separate(&mut lines);
        lines.push(docs.rounding.clone());
    }
    separate(&mut lines);
    let outside = if program.domain.is_empty() { "" } else { " outside its domain and" };
    lines.push(format!("Its value is NaN{outside} where an argument it depends on is NaN."));
    lines.push(format!("Cost: {}.", program.operations()));
    self::comment(&lines, comment)
}

/// Writes each line after the prefix of a comment.
pub fn comment(lines: &[String], comment: &str) -> String {
    lines.iter().fold(String::new(), |text, line| {
        let line = in_a_comment(line);
        text + comment + if line.is_empty() { "" } else { " " } + &line + "\n"
    })
}

/// Returns a line that ends where the comment ends and reads as it appears. The line has no
/// backslash at its end, which would continue the comment in C, no `??/` there, which is a
/// backslash in C, no character that ends a line in WGSL, and none that changes the direction of
/// text, which Rust rejects.
fn in_a_comment(line: &str) -> String {
    let ends_or_turns = |c: char| {
        c.is_control()
            || matches!(c, '\u{2028}' | '\u{2029}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    let visible: String = line.chars().map(|c| if ends_or_turns(c) { ' ' } else { c }).collect();
    let mut line = visible.trim();
    loop {
        let shorter = line.trim_end_matches('\\').trim_end_matches("??/").trim_end();
        if shorter.len() == line.len() {
            return line.to_string();
        }
        line = shorter;
    }
}

fn separate(lines: &mut Vec<String>) {
    if !lines.is_empty() {
        lines.push(String::new());
    }
}

fn quoted(items: &[String]) -> String {
    items.iter().map(|item| format!("`{item}`")).collect::<Vec<_>>().join(", ")
}
