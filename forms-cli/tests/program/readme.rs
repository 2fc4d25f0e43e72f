//! What the README prints is what the program prints.
//!
//! ```text
//! README.md ─ fenced blocks ─┬─ forms, after "Save this as `NAME`"   files of a folder
//!                            ├─ text, from `$ forms …`              run there, and compared
//!                            └─ text, in the section on the first command   the tour, compared
//! ```
//! A line `…` stands for any number of lines. Times are not compared, nor is the width of columns.

use crate::process::{Folder, forms};

const README: &str = include_str!("../../../README.md");

/// What stands for lines that are left out.
const ELISION: &str = "…";

/// A fenced block, its kind, and the text between it and the one before.
struct Block {
    before: String,
    kind: String,
    text: String,
}

fn blocks() -> Vec<Block> {
    let parts: Vec<&str> = README.split("```").collect();
    let fenced = parts.chunks_exact(2);
    fenced
        .map(|pair| {
            let (kind, text) = pair[1].split_once('\n').expect("a block has lines");
            Block { before: pair[0].to_string(), kind: kind.to_string(), text: text.to_string() }
        })
        .collect()
}

/// A line as it is compared: one space for several, and `#` for a time.
fn masked(line: &str) -> String {
    let words: Vec<&str> = line.split_whitespace().collect();
    let is_number = |word: &str| word.parse::<f64>().is_ok();
    let is_unit = |word: &str| ["ns", "µs", "ms", "s"].contains(&word.trim_end_matches([',', ';', '.']));
    let mut kept: Vec<&str> = Vec::new();
    for word in words {
        if is_unit(word) && kept.last().is_some_and(|last| is_number(last)) {
            kept.pop();
            kept.push("#");
        } else {
            kept.push(word);
        }
    }
    kept.join(" ")
}

/// Compares a quotation with what is printed.
fn compared(quoted: &str, printed: &str) -> Result<(), String> {
    let printed: Vec<String> = printed.lines().map(masked).collect();
    let mut place = 0;
    let mut elided = false;
    for line in quoted.lines() {
        if line.trim() == ELISION {
            elided = true;
            continue;
        }
        let wanted = masked(line);
        let from = place;
        let rest = if elided { printed.len() } else { printed.len().min(place + 1) };
        let Some(found) = (from..rest).find(|&at| printed[at] == wanted) else {
            let next = printed.get(from).map_or("the end", String::as_str);
            return Err(format!("quoted:  {wanted}\nprinted: {next}"));
        };
        (place, elided) = (found + 1, false);
    }
    match printed.get(place) {
        Some(left) if !elided => Err(format!("printed, but not quoted: {left}")),
        _ => Ok(()),
    }
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

#[test]
fn a_quotation_that_differs_is_noticed() {
    let printed = "a   1.2 ms\nb 5 W\n\nc\nd in 3 s";
    for right in ["a 7 µs\n…", "…\nb 5 W\n\nc\n…", "…\nc\nd in 4.5 ms", "a 1 s\nb 5 W\n\nc\nd in 3 s", "…"]
    {
        assert_eq!(compared(right, printed), Ok(()), "{right}");
    }
    for wrong in ["a 7 µs", "b 5 W\n…", "…\nb 6 W\n…", "a 1 s\nc\n…", "…\nd in 3 s\ne", "…\nc\n…\nb 5 W\n…"]
    {
        assert!(compared(wrong, printed).is_err(), "{wrong}");
    }
}
