//! Computes view factors between surfaces, and compares one of them with its closed form as a
//! kernel.
//!
//! ```text
//! scene ─▶ matrix of view factors with errors          a, b, c ─▶ view_factor_parallel_rectangles
//! ```
//! `cargo run --release --example view_factors`. The two methods agree, also for squares that are
//! far away or nearly touch.

use forms_kernels::view_factor_parallel_rectangles;
use forms_radiometry::scene::{SceneError, read};
use forms_radiometry::view_factors;

/// Returns a scene of two unit squares that face each other.
fn opposed(distance: f64) -> String {
    format!(
        r#"
        [[material]]
        name = "black"
        kind = "diffuse"
        reflectance = 0

        [[surface]]
        name = "below"
        material = "black"
        polygon = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]

        [[surface]]
        name = "above"
        material = "black"
        polygon = [[0, 0, {distance:?}], [0, 1, {distance:?}], [1, 1, {distance:?}], [1, 0, {distance:?}]]

        [solve]
        tolerance = 1e-12
        "#
    )
}

fn main() -> Result<(), SceneError> {
    println!("{:>10}{:>28}{:>28}", "distance", "of the scene", "closed form");
    for distance in [1e-6, 0.25, 1.0, 100.0, 1e6] {
        let scene = read(&opposed(distance), "squares").map_err(|mut errors| errors.remove(0))?;
        let found = view_factors(&scene).rows[0][1].value;
        println!("{distance:>10e}{found:>28e}{:>28e}", view_factor_parallel_rectangles(1.0, 1.0, distance));
    }
    Ok(())
}
