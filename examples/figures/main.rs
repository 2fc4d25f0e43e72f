//! The figures of the book: a few numbers become the SVG files in `docs/book/src/figures`.
//!
//! ```text
//! wedge  patch  cone  lambert  … ──────────┐
//! neumann  warps  plan  … ─▶ flat (a plane) ┴─▶ forms_figures::Drawing (points of space, projected) ─▶ SVG text
//! ```
//! `cargo run --example figures` writes them; a test compares the stored files with the current
//! output.

mod cone;
mod flat;
mod lambert;
mod neumann;
mod normals;
mod one_form;
mod patch;
mod phase_function;
mod phase_space;
mod plan;
mod plates;
mod quantities;
mod sharing;
mod solid_angle;
mod stokes;
mod vector_irradiance;
mod warps;
mod wave;
mod wedge;

use std::path::PathBuf;

/// Returns the file names and contents.
fn figures() -> Vec<(&'static str, String)> {
    vec![
        ("one_form.svg", one_form::figure()),
        ("wedge.svg", wedge::figure()),
        ("stokes.svg", stokes::figure()),
        ("patch.svg", patch::figure()),
        ("solid_angle.svg", solid_angle::figure()),
        ("cone.svg", cone::figure()),
        ("quantities.svg", quantities::figure()),
        ("vector_irradiance.svg", vector_irradiance::figure()),
        ("lambert.svg", lambert::figure()),
        ("wave.svg", wave::figure()),
        ("phase_space.svg", phase_space::figure()),
        ("neumann.svg", neumann::figure()),
        ("phase_function.svg", phase_function::figure()),
        ("warps.svg", warps::figure()),
        ("sharing.svg", sharing::figure()),
        ("plates.svg", plates::figure()),
        ("plan.svg", plan::figure()),
        ("normals.svg", normals::figure()),
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
