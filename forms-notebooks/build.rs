//! Generates one function per notebook from its code cells.
//!
//! ```text
//! docs/notebooks/*.ipynb ─ code cells ─▶ OUT_DIR/notebooks.rs: a module with `run` for each, and the list of them
//! ```
//! As in the evcxr kernel, all cells of a notebook share one scope, lines that begin with `:` are
//! commands of the kernel, and a cell that ends in an expression shows its value by
//! `evcxr_display`.

use serde_json::Value;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/notebooks");
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut paths: Vec<PathBuf> = Vec::new();
    for entry in std::fs::read_dir(&folder)? {
        paths.push(entry?.path());
    }
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "ipynb"));
    paths.sort();
    let (mut modules, mut list) = (String::new(), String::new());
    for path in &paths {
        println!("cargo::rerun-if-changed={}", path.display());
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let module = format!("notebook_{}", name.replace(|c: char| !c.is_ascii_alphanumeric(), "_"));
        let notebook: Value = serde_json::from_str(&std::fs::read_to_string(path)?)
            .map_err(|error| format!("{}: {error}", path.display()))?;
        modules.push_str(&format!("mod {module} {{\npub(super) fn run() {{\n{}}}\n}}\n", body(&notebook)));
        list.push_str(&format!("    ({name:?}, {module}::run),\n"));
    }
    let list = format!(
        "/// Notebooks with the functions that run their cells.\n\
         pub(crate) const NOTEBOOKS: &[(&str, fn())] = &[\n{list}];\n"
    );
    let target = PathBuf::from(std::env::var_os("OUT_DIR").ok_or("cargo sets OUT_DIR")?);
    std::fs::write(target.join("notebooks.rs"), modules + &list)?;
    Ok(())
}

/// Concatenates the code cells; before each, a statement prints its number.
fn body(notebook: &Value) -> String {
    let cells = notebook["cells"].as_array().into_iter().flatten();
    let sources = cells.filter(|cell| cell["cell_type"] == "code").map(|cell| source(&cell["source"]));
    let each = |(number, source): (usize, String)| {
        format!("println!(\"FORMS_CELL {}\");\n{}\n", number + 1, shown(&without_commands(&source)))
    };
    sources.enumerate().map(each).collect()
}

/// Returns a text that can be stored as a list of lines.
fn source(text: &Value) -> String {
    match text {
        Value::Array(lines) => lines.iter().filter_map(Value::as_str).collect(),
        text => text.as_str().unwrap_or_default().to_owned(),
    }
}

fn without_commands(source: &str) -> String {
    let lines = source.lines().filter(|line| !line.starts_with(':'));
    lines.collect::<Vec<_>>().join("\n").trim_end().to_owned()
}

/// Appends the display of a cell's value if the cell ends in an expression, that is, in neither `;`
/// nor `}`. The expression begins at the last line that is not indented and closes no bracket.
fn shown(source: &str) -> String {
    if source.is_empty() || source.ends_with([';', '}']) {
        return source.to_owned();
    }
    let starts = std::iter::once(0).chain(source.match_indices('\n').map(|(place, _)| place + 1));
    let begins = |start: &usize| !source[*start..].starts_with([' ', ')', ']', '}', '.', '\n']);
    let start = starts.rev().find(begins).unwrap_or(0);
    let (before, value) = source.split_at(start);
    format!("{before}({value}).evcxr_display();")
}
