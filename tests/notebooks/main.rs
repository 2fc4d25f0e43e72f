//! The notebooks run without Jupyter: their cells become a program, and print what is stored.
//!
//! ```text
//! docs/notebooks/*.ipynb ─ code cells ─▶ tests/notebooks/*.rs ─ run ─▶ what each cell prints = stored output
//! ```
//! With `FORMS_WRITE=1` the program, and in a second run the stored outputs, are written anew.

#[rustfmt::skip]
mod cosine_term;

use serde::Serialize;
use serde_json::{Value, json};
use std::path::PathBuf;

const NOTEBOOK: &str = "docs/notebooks/01-cosine-term.ipynb";
const PROGRAM: &str = "tests/notebooks/cosine_term.rs";

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn is_written_anew() -> bool {
    std::env::var_os("FORMS_WRITE").is_some()
}

fn notebook() -> Value {
    let text = std::fs::read_to_string(path(NOTEBOOK)).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn cells(notebook: &Value) -> &[Value] {
    notebook["cells"].as_array().unwrap()
}

fn is_code(cell: &Value) -> bool {
    cell["cell_type"] == "code"
}

/// A text that may be stored as a list of lines.
fn joined(text: &Value) -> String {
    match text {
        Value::Array(lines) => lines.iter().map(|line| line.as_str().unwrap()).collect(),
        text => text.as_str().unwrap().to_string(),
    }
}

/// The code cells one after the other, printing into a list; commands of the kernel (`:dep`) are left out.
fn program(notebook: &Value) -> String {
    let mut program = format!(
        "//! The code cells of `{NOTEBOOK}`, written by\n//! `FORMS_WRITE=1 cargo test --test notebooks`.\n\n\
         /// Runs the cells and gives what each of them prints.\npub(crate) fn run() -> Vec<String> {{\n    \
         let mut printed: Vec<String> = Vec::new();\n    macro_rules! println {{\n        \
         ($($part:tt)*) => {{ *printed.last_mut().unwrap() += &(format!($($part)*) + \"\\n\") }};\n    }}\n"
    );
    for cell in cells(notebook).iter().filter(|cell| is_code(cell)) {
        program.push_str("\n    printed.push(String::new());\n");
        for line in joined(&cell["source"]).lines().filter(|line| !line.starts_with(':')) {
            let indented = format!("    {line}");
            program.push_str(indented.trim_end());
            program.push('\n');
        }
    }
    program.push_str("\n    printed\n}\n");
    program
}

/// What is stored below a cell.
fn stored(cell: &Value) -> String {
    cell["outputs"].as_array().unwrap().iter().map(|output| joined(&output["text"])).collect()
}

/// What Jupyter stores for printed text.
fn as_outputs(printed: &str) -> Value {
    let lines: Vec<String> = printed.split_inclusive('\n').map(str::to_string).collect();
    if lines.is_empty() {
        return json!([]);
    }
    json!([{ "name": "stdout", "output_type": "stream", "text": lines }])
}

/// As Jupyter writes it: sorted keys, one space a level.
fn written(notebook: &Value) -> Vec<u8> {
    let formatter = serde_json::ser::PrettyFormatter::with_indent(b" ");
    let mut text = Vec::new();
    notebook.serialize(&mut serde_json::Serializer::with_formatter(&mut text, formatter)).unwrap();
    text.push(b'\n');
    text
}

#[test]
fn the_program_is_the_cells_of_the_notebook() {
    let expected = program(&notebook());
    if is_written_anew() {
        std::fs::write(path(PROGRAM), &expected).unwrap();
    }
    assert_eq!(std::fs::read_to_string(path(PROGRAM)).unwrap(), expected);
}

#[test]
fn every_cell_prints_what_is_stored_below_it() {
    let mut notebook = notebook();
    let printed = cosine_term::run();
    if is_written_anew() {
        let cells = notebook["cells"].as_array_mut().unwrap();
        for (cell, printed) in cells.iter_mut().filter(|cell| is_code(cell)).zip(&printed) {
            cell["outputs"] = as_outputs(printed);
        }
        std::fs::write(path(NOTEBOOK), written(&notebook)).unwrap();
    }
    let stored: Vec<String> = cells(&notebook).iter().filter(|cell| is_code(cell)).map(stored).collect();
    assert_eq!(printed, stored);
    assert!(stored.iter().filter(|text| !text.is_empty()).count() >= 4, "too little is printed");
}

/// The parts of nbformat 4.5 that a reader needs.
#[test]
fn the_notebook_has_the_shape_of_version_4_5() {
    let notebook = notebook();
    assert_eq!((&notebook["nbformat"], &notebook["nbformat_minor"]), (&json!(4), &json!(5)));
    assert_eq!(notebook["metadata"]["kernelspec"]["name"], "rust");
    let mut names = std::collections::BTreeSet::new();
    for cell in cells(&notebook) {
        assert!(names.insert(cell["id"].as_str().unwrap()), "two cells have the id {}", cell["id"]);
        assert!(cell["metadata"].is_object());
        assert!(cell["source"].is_array());
        assert_eq!(cell["outputs"].is_array(), is_code(cell));
        assert_eq!(cell["execution_count"].is_number(), is_code(cell));
    }
}
