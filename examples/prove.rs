//! Decides statements that are read at run time, and evaluates kernels.
//!
//! ```text
//! text ─ compile ─┬─▶ verdicts: proved under conditions, refuted at a point, or unknown
//!                 └─▶ kernels, each computed by a form that is proved equal to its formula
//! ```
//! `cargo run --release --example prove`, or with the path of a `.forms` file after `--`. Change a
//! sign to see a refutation.

use forms::core::compile::{Options, compile};
use forms::core::decide::Verdict;
use forms::core::syntax::Source;
use std::process::ExitCode;

const TEXT: &str = "
    chart Hemisphere(theta, phi) where 0 < theta < pi/2;
    chart Disk(a, b);
    map shadow: Hemisphere -> Disk = (sin(theta)*cos(phi), sin(theta)*sin(phi));
    form solid_angle: 2 on Hemisphere = sin(theta)*dtheta^dphi;

    prove nusselt: pullback(shadow, da^db) == cos(theta)*solid_angle;
    refute without_cosine: pullback(shadow, da^db) == solid_angle;

    kernel cap(theta) = 2*pi*(1 - cos(theta)) where 0 <= theta <= pi;
";

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let file = std::env::args().nth(1);
    let text = file.as_ref().map_or(Ok(TEXT.to_string()), std::fs::read_to_string)?;
    let source = Source::new(file.as_deref().unwrap_or("the text of this program"), &text);
    let compiled = compile(&text, &Options::default());
    for (statement, verdict) in &compiled.statements {
        match verdict {
            Verdict::Proved(_) => println!("{}: proved", statement.name),
            Verdict::Refuted(witness) => println!("{}: refuted, {witness}", statement.name),
            Verdict::Unknown { reason } => println!("{}: unknown, {reason}", statement.name),
            Verdict::Empty { .. } => println!("{}: no point meets its conditions", statement.name),
        }
    }
    for kernel in &compiled.kernels {
        let arguments = vec![1e-9; kernel.kernel().arguments.len()];
        println!("{}{arguments:?} = {:?}", kernel.kernel().name, kernel.values(&arguments));
    }
    // The diagnostics include statements that are not as claimed.
    compiled.diagnostics.iter().for_each(|diagnostic| eprintln!("{}", source.render(diagnostic)));
    Ok(if compiled.diagnostics.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
