//! Looks for the stable forms of the kernels of the files given, and prints the file of choices.
use forms_core::check::read_theory;
use forms_core::stability::{Effort, search, written};
fn main() {
    for name in std::env::args().skip(1) {
        let text = std::fs::read_to_string(&name).expect("the file can be read");
        let (mut theory, errors) = read_theory(&text);
        errors.iter().for_each(|error| eprintln!("{}", error.message));
        let kernels = theory.kernels.clone();
        let mut choices = Vec::new();
        for (place, kernel) in kernels.iter().enumerate() {
            let start = std::time::Instant::now();
            if kernel.has_form() {
                continue;
            }
            let Some(found) = search(&mut theory.pool, kernel, Effort::default()) else { continue };
            let form = found.chosen();
            eprintln!(
                "{} {:.2} -> {:.2} {:.1?} {}",
                kernel.name,
                found.written.loss,
                form.loss,
                start.elapsed(),
                theory.pool.texts(&form.outputs).join(", ").chars().take(300).collect::<String>()
            );
            choices.push((place, found));
        }
        let pairs: Vec<_> = choices.iter().map(|(place, found)| (&kernels[*place], found)).collect();
        println!("{}", written(&theory.pool, &pairs).unwrap_or_default());
    }
}
