//! Runs the code cells of the given notebooks, or of all notebooks, and prints their outputs. A
//! line `FORMS_CELL n` precedes the output of cell n.

#[allow(clippy::all, reason = "the cells are written for readers, who see each by itself")]
mod cells {
    include!(concat!(env!("OUT_DIR"), "/notebooks.rs"));
}

use cells::NOTEBOOKS;
use std::process::ExitCode;

fn main() -> ExitCode {
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    for name in &wanted {
        if !NOTEBOOKS.iter().any(|(known, _)| known == name) {
            let known: Vec<&str> = NOTEBOOKS.iter().map(|(known, _)| *known).collect();
            eprintln!(
                "error: there is no notebook `{name}` in docs/notebooks; there are {}",
                known.join(", ")
            );
            return ExitCode::from(2);
        }
    }
    for (name, run) in NOTEBOOKS {
        if wanted.is_empty() || wanted.iter().any(|wanted| wanted == name) {
            println!("FORMS_NOTEBOOK {name}");
            run();
        }
    }
    ExitCode::SUCCESS
}
