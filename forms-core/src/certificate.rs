//! Certificates: the data needed to check verdicts without trusting the prover.
//!
//! ```text
//! proof, observed ─▶ bases of radicands, units, cases of signs with reasons ─▶ lines
//! refutation      ─▶ the point, the component, both values                  ─▶ lines
//! ```
//! The format is described in `docs/certificates.md`; `forms-check` reads it. Generators are
//! written as expressions of the language, so that a checker can name them in its own way.

mod entry;
mod reason;
mod writer;

use crate::decide::{Verdict, retrace, retrace_integration};
use crate::theory::{Statement, Theory};
pub use entry::{Entry, Uncovered};
use std::fmt::Write;
use writer::Writer;

/// The first line of a certificate.
pub const HEADER: &str = "forms certificate 1\n";

/// Returns the lines that begin the entries of one file; the reader finds the file by this name.
pub fn file_lines(name: &str, text: &str) -> String {
    format!("\nfile {name}\nhash {:016x}\n", fnv1a(text))
}

/// FNV-1a hash, 64 bits, which detects a changed file.
fn fnv1a(text: &str) -> u64 {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    text.bytes().fold(0xcbf2_9ce4_8422_2325, step)
}

/// Writes an antiderivative for each range of integration in a file, with the proof that its
/// derivative is the integrand. Only the place is written where no antiderivative was found or the
/// proof cannot be written.
pub fn antiderivatives(theory: &mut Theory) -> String {
    let mut lines = String::new();
    for integration in theory.integrations.clone() {
        let _ = write!(lines, "\nintegral {}", integration.place.start);
        let Some(antiderivative) = integration.antiderivative else { continue };
        let Some(text) = theory.pool.full_text(antiderivative) else { continue };
        let mut writer = Writer::new(theory.pool.clone());
        let proved = retrace_integration(&mut theory.pool, &integration, antiderivative, &mut writer);
        if let Ok(proof) = writer.finish()
            && proved
        {
            let _ = write!(lines, " {text}\n{proof}");
        }
    }
    lines
}

/// Returns the entry of one decided statement.
pub fn entry(theory: &mut Theory, statement: &Statement, verdict: &Verdict) -> Entry {
    let name = &statement.name;
    let lines = match verdict {
        Verdict::Proved(_) => {
            let mut writer = Writer::new(theory.pool.clone());
            let proved = retrace(theory, statement, &mut writer);
            writer.finish().and_then(|lines| match proved {
                true => Ok(format!("proved {name}\n{lines}")),
                false => Err(Uncovered::NotReproduced),
            })
        }
        Verdict::Refuted(witness) => {
            let mut lines = format!("refuted {name}\n");
            for (place, value) in &witness.point {
                let _ = writeln!(lines, "at {place} = {value}");
            }
            let _ = writeln!(lines, "component {}", witness.component);
            let _ = writeln!(lines, "left {}\nright {}", witness.left, witness.right);
            Ok(lines)
        }
        Verdict::Unknown { .. } | Verdict::Empty { .. } => Err(Uncovered::Undecided),
    };
    Entry { statement: name.clone(), lines }
}
