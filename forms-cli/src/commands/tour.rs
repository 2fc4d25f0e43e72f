//! `forms` without a command: a demonstration of the program.

mod cornell_box;
mod generated;
mod theory;

use crate::layout::duration;
use crate::palette::Palette;
use crate::status::Status;
use std::io::{self, Write};
use std::time::Instant;

/// Proves the theory, generates the kernels, lights the scene.
pub(crate) fn tour(output: &mut dyn Write) -> io::Result<Status> {
    let start = Instant::now();
    let palette = Palette::of_output();
    let title = format!("forms {}", env!("CARGO_PKG_VERSION"));
    let subtitle = "exterior calculus: identities proved, then turned into numbers";
    writeln!(output, "\n{}  {}\n", palette.heading(&title), palette.quiet(subtitle))?;
    let mut status = theory::prove(palette, output)?;
    status = status.max(generated::generate(palette, output)?);
    status = status.max(cornell_box::light(palette, output)?);
    let end = format!("All of this took {}.", duration(start.elapsed()));
    writeln!(output, "{}", palette.quiet(&end))?;
    writeln!(output, "\nTry next:\n")?;
    writeln!(output, "  forms serve               a local web page with an editor, and the book")?;
    writeln!(output, "  forms prove FILE.forms    decide the statements of your own file")?;
    writeln!(output, "  forms simulate SCENE      simulate a scene, for example scenes/room.toml")?;
    writeln!(output, "  forms kernels             list the kernels of the library")?;
    writeln!(output, "  forms --help              everything else")?;
    Ok(status)
}

/// Prints a heading with its number.
fn heading(number: u32, text: &str, palette: Palette, output: &mut dyn Write) -> io::Result<()> {
    writeln!(output, "{}\n", palette.heading(&format!("{number}  {text}")))
}
