//! Runs the notebooks without Jupyter: their cells become a program, and its outputs must equal the
//! stored outputs.
//!
//! ```text
//! docs/notebooks/*.ipynb ─ build ─▶ program ─ run ─▶ output of each cell ─▶ outputs = stored outputs
//! ```
//! With `FORMS_WRITE=1` the stored outputs are rewritten. The outputs of a cell with the tag
//! `nbval-ignore-output` depend on the clock; only their kinds are compared.

use serde::Serialize;
use serde_json::{Map, Value, json};
use std::path::{Path, PathBuf};
use std::process::Command;

fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/notebooks");
    let mut paths: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "ipynb"));
    paths.sort();
    paths
}

fn notebook(path: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn code_cells(notebook: &Value) -> Vec<&Value> {
    notebook["cells"].as_array().unwrap().iter().filter(|cell| is_code(cell)).collect()
}

fn is_code(cell: &Value) -> bool {
    cell["cell_type"] == "code"
}

/// Whether the output of the cell depends on the clock.
fn hangs_on_the_clock(cell: &Value) -> bool {
    cell["metadata"]["tags"].as_array().is_some_and(|tags| tags.contains(&json!("nbval-ignore-output")))
}

/// Returns the printed output of each code cell of a notebook.
fn printed(path: &Path) -> Vec<String> {
    let name = path.file_stem().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_forms-notebooks")).arg(name).output().unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {}: {errors}", path.display(), output.status);
    let mut cells: Vec<String> = Vec::new();
    for line in String::from_utf8(output.stdout).unwrap().split_inclusive('\n') {
        match cells.last_mut() {
            _ if line.starts_with("FORMS_CELL ") => cells.push(String::new()),
            Some(cell) => cell.push_str(line),
            None => assert!(line.starts_with("FORMS_NOTEBOOK "), "{line}"),
        }
    }
    cells
}

/// Converts the printed output of cell `number` to the stored form of Jupyter: its text, then the
/// content between the marks by MIME type.
fn outputs(number: usize, printed: &str) -> Value {
    let (mut text, mut data) = (String::new(), Map::new());
    let mut open: Option<(&str, String)> = None;
    for line in printed.split_inclusive('\n') {
        if let Some(mime) = line.strip_prefix("EVCXR_BEGIN_CONTENT ") {
            open = Some((mime.trim_end(), String::new()));
        } else if line.trim_end() == "EVCXR_END_CONTENT" {
            let (mime, content) = open.take().expect("content begins before it ends");
            let content = content.strip_suffix('\n').unwrap_or(&content).to_owned();
            let stored = if mime.starts_with("image/png") { json!(content) } else { lines(&content) };
            assert!(
                data.insert(mime.to_owned(), stored).is_none(),
                "cell {number} shows two values as {mime}"
            );
        } else if let Some((_, content)) = &mut open {
            content.push_str(line);
        } else {
            text.push_str(line);
        }
    }
    let mut outputs = Vec::new();
    if !text.is_empty() {
        outputs.push(json!({ "name": "stdout", "output_type": "stream", "text": lines(&text) }));
    }
    if !data.is_empty() {
        let result = "execute_result";
        outputs
            .push(json!({ "data": data, "execution_count": number, "metadata": {}, "output_type": result }));
    }
    Value::Array(outputs)
}

fn lines(text: &str) -> Value {
    text.split_inclusive('\n').collect()
}

/// Returns the kinds of outputs without their content.
fn kinds(outputs: &Value) -> Vec<Vec<String>> {
    let kind = |output: &Value| {
        let mimes = output["data"].as_object().into_iter().flat_map(Map::keys).cloned();
        std::iter::once(output["output_type"].to_string()).chain(mimes).collect()
    };
    outputs.as_array().unwrap().iter().map(kind).collect()
}

/// Asserts that a notebook shows at least four formulas, tables or pictures, and that at least four
/// cells are compared.
fn assert_rich(path: &Path, cells: &[&Value]) {
    let kinds: Vec<String> = cells.iter().flat_map(|cell| kinds(&cell["outputs"])).flatten().collect();
    let is_rich =
        |kind: &&String| ["text/latex", "text/markdown", "text/html", "image/png"].contains(&kind.as_str());
    assert!(kinds.iter().filter(is_rich).count() >= 4, "{}: {kinds:?}", path.display());
    let compared = cells.iter().filter(|cell| !hangs_on_the_clock(cell)).count();
    assert!(compared >= 4, "{}: too little is compared", path.display());
}

/// Serialises a notebook in the format of Jupyter: sorted keys, one space per level.
fn written(notebook: &Value) -> Vec<u8> {
    let formatter = serde_json::ser::PrettyFormatter::with_indent(b" ");
    let mut text = Vec::new();
    notebook.serialize(&mut serde_json::Serializer::with_formatter(&mut text, formatter)).unwrap();
    text.push(b'\n');
    text
}

fn write_outputs(path: &Path, notebook: &mut Value, found: &[Value]) {
    let cells = notebook["cells"].as_array_mut().unwrap();
    for (place, (cell, outputs)) in cells.iter_mut().filter(|cell| is_code(cell)).zip(found).enumerate() {
        cell["outputs"] = outputs.clone();
        cell["execution_count"] = json!(place + 1);
    }
    std::fs::write(path, written(notebook)).unwrap();
}

#[test]
fn every_cell_shows_what_is_stored_below_it() {
    let paths = files();
    assert_eq!(paths.len(), 5, "{paths:?}");
    for path in paths {
        let mut notebook = notebook(&path);
        let printed = printed(&path);
        let found: Vec<Value> =
            printed.iter().enumerate().map(|(place, printed)| outputs(place + 1, printed)).collect();
        if std::env::var_os("FORMS_WRITE").is_some() {
            write_outputs(&path, &mut notebook, &found);
        }
        let cells = code_cells(&notebook);
        assert_eq!(cells.len(), found.len(), "{}", path.display());
        for (number, (cell, found)) in cells.iter().zip(&found).enumerate() {
            let place = format!("{}: code cell {}", path.display(), number + 1);
            if hangs_on_the_clock(cell) {
                assert_eq!(kinds(found), kinds(&cell["outputs"]), "{place}");
            } else {
                assert_eq!(*found, cell["outputs"], "{place}");
            }
        }
        assert_rich(&path, &cells);
    }
}

/// Checks the fields of nbformat 4.5 that a reader needs.
#[test]
fn a_notebook_has_the_shape_of_version_4_5() {
    for path in files() {
        let notebook = notebook(&path);
        assert_eq!((&notebook["nbformat"], &notebook["nbformat_minor"]), (&json!(4), &json!(5)));
        assert_eq!(notebook["metadata"]["kernelspec"]["name"], "rust");
        let mut names = std::collections::BTreeSet::new();
        for cell in notebook["cells"].as_array().unwrap() {
            let id = cell["id"].as_str().unwrap();
            assert!(names.insert(id), "{}: two cells have the id {id}", path.display());
            assert!(cell["metadata"].is_object());
            assert!(cell["source"].is_array());
            assert_eq!(cell["outputs"].is_array(), is_code(cell));
            assert_eq!(cell["execution_count"].is_number(), is_code(cell));
        }
    }
}

#[test]
fn what_stands_between_the_marks_is_content_and_the_rest_is_text() {
    let printed = "a\nEVCXR_BEGIN_CONTENT text/html\n<p>\nb\nEVCXR_END_CONTENT\nc\n";
    let expected = json!([
        { "name": "stdout", "output_type": "stream", "text": ["a\n", "c\n"] },
        { "data": { "text/html": ["<p>\n", "b"] }, "execution_count": 3, "metadata": {},
          "output_type": "execute_result" },
    ]);
    assert_eq!(outputs(3, printed), expected);
}
