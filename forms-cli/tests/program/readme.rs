//! The program prints the outputs that the README quotes.
//!
//! ```text
//! README.md ─ fenced blocks ─┬─ forms, after "Save this as `NAME`"   files of a folder
//!                            ├─ text, from `$ forms …`              run there, and compared
//!                            └─ text, in the section on the first command   the tour, compared
//! ```
//! A line `…` matches any number of lines. Times are not compared.

use crate::process::{Folder, forms};
use forms_book::{Page, agrees};

const README: &str = include_str!("../../../README.md");

/// Fenced block, its kind, and the text between it and the previous block.
struct Block {
    before: String,
    kind: String,
    text: String,
}

fn blocks() -> Vec<Block> {
    let mut end = 0;
    let with_text_before = |block: forms_book::Block| {
        let before = README[end..block.place.start].to_owned();
        end = block.place.end;
        Block { before, kind: block.kind, text: block.text }
    };
    Page::new("README.md", README).blocks().into_iter().map(with_text_before).collect()
}

/// Compares a quotation with the printed text.
fn compared(quoted: &str, printed: &str) -> Result<(), String> {
    if agrees(quoted, printed) { Ok(()) } else { Err(format!("quoted:\n{quoted}\nprinted:")) }
}

#[test]
fn the_commands_of_the_readme_print_what_it_says() {
    let folder = Folder::with(&[]);
    let mut runs = 0;
    for block in blocks() {
        if let Some((_, name)) = block.before.rsplit_once("Save this as `")
            && block.kind == "forms"
        {
            let name = name.split('`').next().expect("a name");
            folder.write(name, block.text.as_bytes());
        }
        if let Some((command, quoted)) = block.text.split_once('\n')
            && let Some(arguments) = command.strip_prefix("$ forms ")
        {
            let arguments: Vec<&str> = arguments.split(' ').collect();
            let run = forms(&folder, &arguments);
            assert_eq!((run.status, run.errors.as_str()), (0, ""), "{command}");
            compared(quoted, &run.output)
                .unwrap_or_else(|error| panic!("{command}\n{error}\n{}", run.output));
            runs += 1;
        }
    }
    assert!(runs > 0, "no command was found");
}

#[test]
fn the_tour_prints_what_the_readme_shows_and_paints() {
    let folder = Folder::with(&[]);
    let run = forms(&folder, &[]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""), "{}", run.output);
    let blocks = blocks();
    let first = blocks.iter().find(|block| block.kind == "sh").expect("the first command");
    assert!(first.text.starts_with("cargo run --release\n"));
    let tour = blocks.iter().find(|block| block.before.contains("## What the first command prints"));
    compared(&tour.expect("what it prints").text, &run.output)
        .unwrap_or_else(|error| panic!("{error}\n\n{}", run.output));
    let picture = folder.read("forms-output/cornell_box.png");
    assert!(picture.starts_with(b"\x89PNG"));
    let widest = run.output.lines().map(|line| line.chars().count()).max();
    assert!(widest <= Some(80), "{widest:?}");
}
