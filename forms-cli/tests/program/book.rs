//! Output of the book, the manual and the completions.

use crate::process::{Folder, forms, forms_on};

#[test]
fn the_book_is_written_from_the_program_alone() {
    let folder = Folder::with(&[]);
    let run = forms(&folder, &["book", "--out", "pages"]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    assert!(run.output.contains("pages/index.html"), "{}", run.output);
    let page = String::from_utf8(folder.read("pages/04-solid-angle.html")).expect("text");
    assert!(page.contains("<code>beta_is_closed</code> proved") && page.contains("<math"), "{page}");
    assert!(folder.read("pages/figures/solid_angle.svg").starts_with(b"<svg"));
}

#[test]
fn mdbook_is_answered_in_its_protocol() {
    let folder = Folder::with(&[]);
    for (renderer, status) in [("html", 0), ("epub", 1)] {
        assert_eq!(
            forms(&folder, &["book", "--preprocess", "supports", renderer]).status,
            status,
            "{renderer}"
        );
    }
    let input = r##"[{},{"items":[{"Chapter":{"content":"# $x$","path":"one.md","sub_items":[]}}]}]"##;
    let run = forms_on(&folder, &["book", "--preprocess"], input);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    assert!(run.output.starts_with("{\"items\"") && run.output.contains("<math"), "{}", run.output);
    let wrong = forms_on(&folder, &["book", "--preprocess"], &input.replace("$x$", "$\\\\nosuch$"));
    assert_eq!(wrong.status, 2);
    assert!(wrong.errors.contains("docs/book/src/one.md:1: this formula cannot be read"), "{}", wrong.errors);
}

#[test]
fn the_manual_has_a_page_for_each_command() {
    let folder = Folder::with(&[]);
    let page = forms(&folder, &["man"]);
    assert!(page.status == 0 && page.output.contains(".TH forms 1"), "{}", page.output);
    assert!(forms(&folder, &["man", "prove"]).output.contains("Decide every statement of files"));
    assert_eq!(forms(&folder, &["man", "nothing"]).status, 2);
    assert_eq!(forms(&folder, &["man", "--out", "pages"]).status, 0);
    for name in ["forms.1", "forms-prove.1", "forms-view-factors.1"] {
        assert!(!folder.read(&format!("pages/{name}")).is_empty(), "{name}");
    }
}

#[test]
fn completions_name_every_command() {
    let folder = Folder::with(&[]);
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = forms(&folder, &["completions", shell]);
        assert!(script.status == 0 && script.output.contains("view-factors"), "{shell}");
    }
}
