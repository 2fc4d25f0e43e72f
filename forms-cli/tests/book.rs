//! The program prints the outputs that the pages quote.
//!
//! ```text
//! docs/**/*.md ─ blocks `console` ─▶ calls ─ each in a folder with page.forms ─▶ printed ─ compared, except durations
//! ```
//! With `FORMS_WRITE=1` the outputs on the pages are rewritten.
#![cfg(unix)]

use forms_book::{Call, Page, calls, pages, with_outputs};
use rayon::prelude::*;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("a workspace").to_path_buf()
}

/// Folder with the entries of the repository root that calls use, and with a file page.forms. It is
/// removed after its calls.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder =
            Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("book-{}-{name}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder in the build's folder");
        for entry in ["scenes", "docs", "tests", "forms-radiometry"] {
            std::os::unix::fs::symlink(root().join(entry), folder.join(entry)).expect("a link");
        }
        Folder(folder)
    }

    /// Returns the printed text of a call: its output, then its errors.
    fn printed(&self, call: &Call) -> String {
        fs::write(self.0.join("page.forms"), &call.theory).expect("a file in the folder");
        let mut program = Command::new(env!("CARGO_BIN_EXE_forms"))
            .args(&call.arguments)
            .current_dir(&self.0)
            .env_remove("CLICOLOR_FORCE")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        // A program that rejects its arguments does not wait for its input.
        let _ = program.stdin.take().expect("a pipe").write_all(call.input.as_bytes());
        let output = program.wait_with_output().expect("the program ends");
        [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("text")).concat()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Returns the calls of a page with their current outputs.
fn printed(page: &Page) -> Vec<(Call, String)> {
    let found = calls(page).unwrap_or_else(|(line, message)| panic!("{}:{line}: {message}", page.path));
    if found.is_empty() {
        return vec![];
    }
    let folder = Folder::new(&page.path.replace('/', "-"));
    found.into_iter().map(|call| (folder.printed(&call), call)).map(|(text, call)| (call, text)).collect()
}

/// Returns the differences between a page and the current outputs.
fn differences(page: &Page, outputs: &[(Call, String)]) -> Vec<String> {
    let differ = outputs.iter().filter(|(call, printed)| !call.expects(printed));
    let told = |(call, printed): &(Call, String)| {
        format!(
            "{}:{}: `{}` is said to print\n{}and prints\n{printed}",
            page.path, call.line, call.command, call.output
        )
    };
    differ.map(told).collect()
}

#[test]
fn every_call_on_a_page_prints_what_the_page_says() {
    let (mut wrong, mut run) = (vec![], 0);
    let pages = pages(&root(), "docs").expect("the pages");
    let outputs: Vec<Vec<(Call, String)>> = pages.par_iter().map(printed).collect();
    for (page, outputs) in pages.iter().zip(&outputs) {
        run += outputs.len();
        if std::env::var_os("FORMS_WRITE").is_some() {
            let written = with_outputs(page, outputs);
            if written != *page {
                fs::write(root().join(&page.path), written.text).expect("the page is written");
            }
        } else {
            wrong.extend(differences(page, outputs));
        }
    }
    println!("{run} calls were run");
    let how = "FORMS_WRITE=1 cargo test -p forms-cli --test book";
    assert!(wrong.is_empty(), "{} of {run} calls differ; {how}\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn a_wrong_output_on_a_page_is_noticed_and_can_be_written_anew() {
    let text =
        "```forms\nchart P(x, y);\nlet a = x + x;\n```\n\n```console\n$ forms show page.forms a\n3*x\n```\n";
    let page = Page::new("docs/example.md", text);
    let outputs = printed(&page);
    let wrong = differences(&page, &outputs);
    assert_eq!(wrong.len(), 1);
    assert!(
        wrong[0]
            .contains("docs/example.md:7: `forms show page.forms a` is said to print\n3*x\nand prints\n2*x")
    );
    let written = with_outputs(&page, &outputs);
    assert_eq!(written.text, text.replace("3*x", "2*x"));
    assert_eq!(differences(&written, &printed(&written)), Vec::<String>::new());
}
