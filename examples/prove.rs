//! Decides statements that are read at run time.
//!
//! ```text
//! text ─▶ theory ─▶ verdicts: proved under conditions, refuted at a point, or unknown
//! ```
//! `cargo run --release --example prove`, or with the path of a `.forms` file behind `--`. Change a sign and see what happens.

use forms::core::check::{decide_all, read_theory};
use forms::core::decide::Verdict;
use forms::core::syntax::Source;
use std::process::ExitCode;

const TEXT: &str = "
    chart Hemisphere(theta, phi) where 0 < theta < pi/2;
    chart Disk(a, b);
    map shadow: Hemisphere -> Disk = (sin(theta)*cos(phi), sin(theta)*sin(phi));
    form solid_angle: 2 on Hemisphere = sin(theta)*dtheta^dphi;

    prove nusselt: pullback(shadow, da^db) == cos(theta)*solid_angle;
    prove without_cosine: pullback(shadow, da^db) == solid_angle;
";

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let file = std::env::args().nth(1);
    let text = file.as_ref().map_or(Ok(TEXT.to_string()), std::fs::read_to_string)?;
    let source = Source::new(file.as_deref().unwrap_or("the text of this program"), &text);
    let (mut theory, errors) = read_theory(&text);
    if !errors.is_empty() {
        errors.iter().for_each(|error| eprintln!("{}", source.render(error)));
        return Ok(ExitCode::FAILURE);
    }
    let verdicts = decide_all(&mut theory);
    for (statement, verdict) in theory.statements.iter().zip(&verdicts) {
        match verdict {
            Verdict::Proved(_) => println!("{}: proved", statement.name),
            Verdict::Refuted(witness) => println!("{}: refuted, {witness}", statement.name),
            Verdict::Unknown { reason } => println!("{}: unknown, {reason}", statement.name),
            Verdict::Empty { .. } => println!("{}: no point meets its conditions", statement.name),
        }
    }
    Ok(ExitCode::SUCCESS)
}
