//! Choices: the forms by which kernels are computed, stored in a file that is committed.
//!
//! ```text
//! search ─▶ entry ─ text ─▶ NAME.stable ─ read ─▶ Choices ─ apply ─▶ kernels computed by their forms
//! ```
//! The file NAME.stable lies next to NAME.forms. It is written in the language: one kernel for each
//! entry. The first line of the kernel's documentation holds a key that identifies the formula for
//! which the choice was made. The key depends on the formula, the domain, the op table and the
//! rules. An entry with another key is ignored, and the kernel is computed by the result of the
//! rules alone. Generation proves each form again.

use super::form::{Form, Found};
use super::rules::VERSION;
use crate::check::read_theory;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expr, Pool, Shape, Symbol, TABLE, number_text};
use crate::notation::results;
use crate::theory::{Kernel, Theory};
use rustc_hash::FxHashMap;
use std::fmt::Write;

/// File extension of a file of choices, which replaces `forms`.
pub const EXTENSION: &str = "stable";

/// Header of every file of choices.
const HEAD: &str = "\
// Forms by which the kernels of the accompanying file are computed; each is proved equal to its formula when it is
// generated. Written by `forms accuracy FILE --write`. The documentation line holds the key of the formula and the mean
// number of bits lost in f64, as written and with this form; an entry with another key is ignored.
";

/// Returns a hash of everything on which a choice depends, as 16 hexadecimal digits: the kernel's
/// name, arguments, formula and domain, the op table, the rules, and the version of this crate,
/// whose prover has to prove the form.
pub fn key(pool: &Pool, kernel: &Kernel) -> String {
    let mut text = format!("{} {VERSION} {}", env!("CARGO_PKG_VERSION"), kernel.name);
    for row in TABLE {
        let _ = write!(text, " {} {}", row.name, row.cost);
    }
    for &argument in &kernel.arguments {
        let _ = write!(text, " {}", pool.symbol_name(argument));
    }
    for output in pool.texts(&kernel.outputs) {
        let _ = write!(text, "; {output}");
    }
    for condition in &kernel.domain {
        let _ = write!(text, ", {}", condition.text(pool));
    }
    format!("{:016x}", fowler_noll_vo(text.as_bytes()))
}

/// Computes the 64-bit FNV-1a hash (G. Fowler, L. C. Noll, K.-P. Vo), which is the same on every
/// machine and in every version.
fn fowler_noll_vo(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// Returns the text of a file with these choices. A kernel whose formula is the best form has no
/// entry; without entries there is no file.
pub fn written(pool: &Pool, choices: &[(&Kernel, &Found)]) -> Option<String> {
    let mut text = HEAD.to_string();
    for (kernel, found) in choices {
        let (form, promise) = found.chosen();
        if (form.outputs != kernel.outputs || promise.is_some()) && !kernel.has_form() {
            entry(pool, kernel, (&found.written, form, promise), &mut text);
        }
    }
    (text.len() > HEAD.len()).then_some(text)
}

/// Adds the entry of a kernel with the form that it is computed by, in place of the written one, and the
/// promise, if there is one.
fn entry(
    pool: &Pool,
    kernel: &Kernel,
    (before, form, promise): (&Form, &Form, Option<f64>),
    text: &mut String,
) {
    let arguments: Vec<&str> = kernel.arguments.iter().map(|&argument| pool.symbol_name(argument)).collect();
    // an entry is a kernel of numbers: arrays are written by their entries
    let shapes = vec![Shape::Number; form.outputs.len()];
    let written = |outputs: &[Expr]| results(&pool.texts(outputs), &shapes);
    // an approximation is written beside the formula that it is close to
    let formula = match &form.approximation {
        Some(tolerance) => {
            let [formula, form] = [&kernel.outputs, &form.outputs].map(|outputs| written(outputs));
            format!("{formula}\n    by {form}\n    approx {}", number_text(tolerance))
        }
        None => written(&form.outputs),
    };
    let key = key(pool, kernel);
    let promise = promise.map_or(String::new(), |units| format!("\n    within {units}"));
    let _ = write!(
        text,
        "\n/// {key} bits {:.2} -> {:.2}, cost {} -> {}\nkernel {}({}) = {formula}{promise};\n",
        before.loss,
        form.loss,
        before.cost,
        form.cost,
        kernel.name,
        arguments.join(", ")
    );
}

/// Entries of a file of choices.
pub struct Choices {
    theory: Theory,
}

impl Choices {
    /// Reads a file of choices.
    ///
    /// # Errors
    /// If the text is not in the language.
    pub fn read(text: &str) -> Result<Choices, Vec<Diagnostic>> {
        let (theory, errors) = read_theory(text);
        if errors.is_empty() { Ok(Choices { theory }) } else { Err(errors) }
    }

    /// Sets the form of every kernel that has a valid entry and no form of its own; returns the
    /// number of these kernels.
    pub fn apply(&self, theory: &mut Theory) -> usize {
        let mut applied = 0;
        for place in 0..theory.kernels.len() {
            if theory.kernels[place].has_form() {
                continue;
            }
            if let Some((form, entry)) = self.form_of(&mut theory.pool, &theory.kernels[place]) {
                let kernel = &mut theory.kernels[place];
                if form != kernel.outputs {
                    kernel.computed = form;
                }
                (kernel.within, kernel.approximation) = (entry.within.clone(), entry.approximation.clone());
                applied += 1;
            }
        }
        applied
    }

    /// Returns a message about entries that match no kernel, because their kernels have changed;
    /// `None` if all entries match.
    pub fn objection(&self, theory: &Theory) -> Option<String> {
        let fits_none =
            |entry: &&Kernel| !theory.kernels.iter().any(|kernel| fits(entry, &theory.pool, kernel));
        let stale = self.theory.kernels.iter().filter(fits_none);
        let names: Vec<String> = stale.map(|entry| format!("`{}`", entry.name)).collect();
        (!names.is_empty()).then(|| {
            format!(
                "the forms chosen for {} belong to earlier formulas and are not used; `forms accuracy FILE --write` \
                 chooses new ones",
                names.join(", ")
            )
        })
    }

    /// Returns the form that an entry gives for a kernel, as expressions of the kernel's pool, and
    /// the entry.
    fn form_of(&self, pool: &mut Pool, kernel: &Kernel) -> Option<(Vec<Expr>, &Kernel)> {
        let entry = self.theory.kernels.iter().find(|entry| fits(entry, pool, kernel))?;
        let symbols = entry.arguments.iter().zip(&kernel.arguments);
        let variables: FxHashMap<Symbol, Expr> =
            symbols.map(|(&entry, &own)| (entry, pool.symbol(own))).collect();
        let form = if entry.computed.is_empty() { &entry.outputs } else { &entry.computed };
        Some((pool.import(&self.theory.pool, form, &variables)?, entry))
    }
}

/// Whether an entry was made for the present state of a kernel, as its key shows.
fn fits(entry: &Kernel, pool: &Pool, kernel: &Kernel) -> bool {
    let told = entry.docs.first().and_then(|line| line.split_whitespace().next());
    entry.name == kernel.name
        && entry.arguments.len() == kernel.arguments.len()
        && entry.outputs.len() == kernel.outputs.len()
        && told == Some(key(pool, kernel).as_str())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile_kernel;
    use crate::stability::{Budget, search};

    const SOURCE: &str = "kernel root(x) = sqrt(x + 1) - sqrt(x) where x >= 0;\nkernel plain(x) = x + 1;";

    fn theory(source: &str) -> Theory {
        let (theory, errors) = read_theory(source);
        assert!(errors.is_empty(), "{errors:?}");
        theory
    }

    fn chosen(source: &str) -> String {
        let mut theory = theory(source);
        let kernels = theory.kernels.clone();
        let found: Vec<Found> = kernels
            .iter()
            .map(|kernel| search(&mut theory.pool, kernel, Budget::default()).expect("samples"))
            .collect();
        let pairs: Vec<(&Kernel, &Found)> = kernels.iter().zip(&found).collect();
        written(&theory.pool, &pairs).expect("a choice")
    }

    #[test]
    fn a_choice_is_written_read_and_used() {
        let text = chosen(SOURCE);
        assert!(
            text.contains("kernel root(x) = 1/(sqrt(x + 1) + sqrt(x));") && !text.contains("plain"),
            "{text}"
        );
        let mut theory = theory(SOURCE);
        assert_eq!(Choices::read(&text).expect("a file").apply(&mut theory), 1);
        let kernel = theory.kernels[0].clone();
        let generated = compile_kernel(&mut theory.pool, &kernel).expect("a kernel");
        assert!(generated.translation.is_proved());
        assert_eq!(generated.optimised.interpret(&[1e20]), [5e-11]);
        assert_eq!(generated.written.interpret(&[1e20]), [0.0]);
    }

    #[test]
    fn a_choice_for_another_formula_says_nothing() {
        let text = chosen(SOURCE);
        let choices = Choices::read(&text).expect("a file");
        for source in [
            "kernel root(x) = sqrt(x + 2) - sqrt(x) where x >= 0;",
            "kernel root(x) = sqrt(x + 1) - sqrt(x) where x > 0;",
            "kernel root(y) = sqrt(y + 1) - sqrt(y) where y >= 0;",
            "kernel root(x) = sqrt(x + 1) - sqrt(x) by sqrt(1 + x) - sqrt(x) where x >= 0;",
        ] {
            assert_eq!(choices.apply(&mut theory(source)), 0, "{source}");
        }
        let message =
            choices.objection(&theory("kernel root(x) = sqrt(x + 2) - sqrt(x);")).expect("a stale entry");
        assert!(message.starts_with("the forms chosen for `root` belong to earlier formulas"), "{message}");
        assert_eq!(choices.objection(&theory(SOURCE)), None);
    }

    #[test]
    fn a_form_that_is_not_equal_is_an_error() {
        let theory_of_key = theory(SOURCE);
        let key = key(&theory_of_key.pool, &theory_of_key.kernels[0]);
        let choices = Choices::read(&format!("/// {key}\nkernel root(x) = 1/(sqrt(x + 2) + sqrt(x));"));
        let mut theory = theory(SOURCE);
        assert_eq!(choices.expect("a file").apply(&mut theory), 1);
        let kernel = theory.kernels[0].clone();
        let errors = compile_kernel(&mut theory.pool, &kernel).expect_err("a false form");
        assert!(errors[0].message.contains("differs from its formula"), "{errors:?}");
    }
}
