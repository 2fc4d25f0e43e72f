//! The page with the editor, its scripts, styles and examples, embedded from the folder `page`.

use crate::reply::{kind, nothing, reply};
use axum::response::Response;
use include_dir::{Dir, include_dir};
use serde_json::{Value, json};

static PAGE: Dir = include_dir!("$CARGO_MANIFEST_DIR/page");

/// Template of a page to read: `{title}`, `{body}`, and links of which the current one gets marked.
const SHELL: &str = include_str!("../page/shell.html");

/// Extension of files that are not served directly.
const INSIDE: &str = "html";

/// Replies with a script, a style or a picture, by its name.
pub(crate) fn file(name: &str) -> Response {
    let found = PAGE.get_file(name).filter(|_| !name.ends_with(INSIDE));
    found.map_or_else(nothing, |file| reply(kind(name), file.contents()))
}

/// Replies with the page of the editor.
pub(crate) fn editor() -> Response {
    reply(kind(".html"), include_str!("../page/index.html"))
}

/// Fills the template of a page to read.
pub(crate) fn shell(title: &str, current: &str, body: &str) -> String {
    let current = format!("href=\"/{current}/\"");
    let marked = SHELL.replace(&current, &format!("{current} aria-current=\"page\""));
    marked.replace("{title}", title).replace("{body}", body)
}

/// Returns the examples in order: each with a name, a title, which is its first line, and its text.
pub(crate) fn examples() -> Value {
    let mut files: Vec<_> = PAGE.get_dir("examples").into_iter().flat_map(Dir::files).collect();
    files.sort_by_key(|file| file.path().to_owned());
    let example = |file: &include_dir::File| {
        let text = file.contents_utf8().unwrap_or_default();
        let title =
            text.lines().next().unwrap_or_default().trim_start_matches('/').trim().trim_end_matches('.');
        let name = file.path().file_stem().unwrap_or_default().to_string_lossy().into_owned();
        json!({ "name": name, "title": title, "text": text })
    };
    Value::Array(files.into_iter().map(example).collect())
}
