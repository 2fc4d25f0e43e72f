//! The figures of the book: a few numbers become the SVG files in `docs/book/src/figures`.
//!
//! ```text
//! wedge  patch  solid_angle ─▶ drawing (points of space, projected) ─▶ SVG text
//! ```
//! `cargo run --example figures` writes them; a test compares the files with what would be written.

mod drawing;
mod patch;
mod solid_angle;
mod vector;
mod wedge;

use std::path::PathBuf;

/// File names and contents.
fn figures() -> [(&'static str, String); 3] {
    [
        ("wedge.svg", wedge::figure()),
        ("patch.svg", patch::figure()),
        ("solid_angle.svg", solid_angle::figure()),
    ]
}

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/book/src/figures").join(name)
}

fn main() -> std::io::Result<()> {
    for (name, text) in figures() {
        std::fs::write(path(name), text)?;
        println!("{name}");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_figures_are_up_to_date() {
        for (name, text) in super::figures() {
            let found = std::fs::read_to_string(super::path(name)).unwrap_or_default();
            assert!(found == text, "{name} is out of date: cargo run --example figures");
        }
    }
}
