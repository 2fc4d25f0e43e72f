//! Error budgets: for every scene of the gallery, the parts of its error, the cost of half the
//! error, and the decrease of the error with time.
//!
//! ```text
//! scenes/*.toml ─┬─ as they are ───────────────▶ parts of the worst error ┐
//!                ├─ half the requested error ──▶ time of halving it ──────┴─▶ docs/benchmarks.md
//!                ├─ decreasing tolerances ─────▶ errors against time ─────┬─▶ docs/figures/scenes
//!                └─ each effect forced off ────▶ time of each effect ─────┘
//! ```
//! `cargo run --release -p forms-radiometry --example budgets [--write] [SCENE…]` measures all
//! scenes or the given ones, and prints the table, one row per scene. With `--write` the figures
//! (`docs/figures/scenes/*.svg`) are rewritten, and with all scenes also the page.

mod figure;
mod measured;
mod table;

use forms_radiometry_testing::gallery::{self, Problem};
use forms_testing::page;
use measured::Measured;

const WRITE: &str = "--write";

fn main() -> Result<(), Problem> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let is_written = arguments.iter().any(|word| word == WRITE);
    let named: Vec<&String> = arguments.iter().filter(|word| *word != WRITE).collect();
    let mut table = format!("Processor: {}.\n\n{}", page::processor(), table::HEAD);
    print!("{table}");
    let documents = gallery::folder().join("../docs");
    for file in gallery::files()? {
        let name = gallery::name(&file);
        if !(named.is_empty() || named.contains(&&name)) {
            continue;
        }
        let measured = Measured::of(&file)?;
        let row = table::row(&measured)?;
        print!("{row}");
        table += &row;
        if is_written {
            let folder = documents.join("figures/scenes");
            std::fs::create_dir_all(&folder)?;
            std::fs::write(folder.join(format!("{name}.svg")), figure::svg(&measured))?;
        }
    }
    if is_written && named.is_empty() {
        let path = documents.join("benchmarks.md");
        std::fs::write(&path, page::replaced(&std::fs::read_to_string(&path)?, "error budgets", &table))?;
    }
    Ok(())
}
