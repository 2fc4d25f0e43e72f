//! Emission of a whole source file: the definitions that kernels need, a function for each kernel,
//! and in the languages of arrays a batch function for each.

use super::c::{C, Flavour};
use super::features::check;
use super::names::Functions;
use super::promise::{Promise, arithmetic, assumption, promise};
use super::target::{EmitError, Precision, Source, Target};
use super::{batch, generic, names, rust, wgsl, widened};
use crate::kernel::Program;
use crate::rounding;

impl Source {
    /// Writes the documented functions of the kernel under these names.
    fn functions(&self, functions: &Functions, target: Target, precision: Precision) -> String {
        let promise = self.promise(target, precision);
        let escalates = promise == Some(Promise::ByPrecision);
        let renamed =
            |name: &str| names::renamed(self.computed(escalates, precision), &self.docs, target, name);
        let (program, mut docs) = renamed(&functions.kernel);
        let in_double = matches!(promise, Some(Promise::InDouble { .. }));
        let in_double = in_double.then(|| renamed(&functions.in_double).0);
        let program = &program;
        match (&promise, &self.within) {
            (Some(promise), Some(within)) => docs.rounding = promise.sentence(within, target, precision),
            _ if precision == Precision::F64 => {}
            _ if target == Target::Rust => docs.rounding.clear(),
            _ => {
                let claim = rounding::claim(program, arithmetic(target, precision));
                let sentence = |claim| format!("{claim}{}.", assumption(target, precision));
                docs.rounding = claim.map(sentence).unwrap_or_default();
            }
        }
        let docs = &docs;
        match (target, precision) {
            (Target::Rust, Precision::DoubleDouble) => generic::double_double(program, docs, escalates),
            (Target::Rust, _) => match &self.within {
                Some(within) if escalates => rust::escalating(program, docs, within, precision),
                _ => rust::written(program, docs, generic::MATH, precision),
            },
            (Target::C | Target::Cuda, _) => {
                let language = C::new(flavour(target), precision);
                let function = match &in_double {
                    Some(in_double) => widened::function(&language, program, in_double, docs),
                    None => language.function(program, docs),
                };
                function + "\n" + &batch::of_c(&language, program, &functions.batch)
            }
            (Target::Wgsl, _) => {
                wgsl::function_of(program, docs) + "\n" + &batch::of_wgsl(program, &functions.batch)
            }
        }
    }

    /// Whether the kernel is computed in double precision and rounded.
    fn is_in_double(&self, target: Target, precision: Precision) -> bool {
        matches!(self.promise(target, precision), Some(Promise::InDouble { .. }))
    }

    /// Returns the program that is written: an approximation is not good enough for more precision
    /// than that of `f64`.
    fn computed(&self, escalates: bool, precision: Precision) -> &Program {
        match &self.approximated {
            Some(approximated) if escalates || precision == Precision::DoubleDouble => &approximated.formula,
            _ => &self.program,
        }
    }

    /// Returns how the promise of the kernel is kept, if it has one.
    fn promise(&self, target: Target, precision: Precision) -> Option<Promise> {
        Some(promise(self, self.within.as_ref()?, target, precision))
    }

    /// Whether the kernel's Rust source needs the arithmetic of `forms_math`.
    fn needs_math(&self, precision: Precision) -> bool {
        match precision {
            Precision::F32 | Precision::F64 => {
                let escalates = self.promise(Target::Rust, precision) == Some(Promise::ByPrecision);
                escalates || self.computed(escalates, precision).needs_math()
            }
            Precision::DoubleDouble => true,
        }
    }
}

fn flavour(target: Target) -> Flavour {
    if target == Target::Cuda { Flavour::Cuda } else { Flavour::C }
}

/// Names that a source file adds to those of its kernels.
#[derive(Clone, Copy, Debug, Default)]
pub struct FileNames<'a> {
    /// Prefix of the names of the functions of kernels.
    pub prefix: &'a str,
    /// Name of the file, from which a header of C takes its include guard.
    pub file: &'a str,
}

impl FileNames<'_> {
    /// Returns the name of the include guard: `FORMS_PAGE_F64_H`.
    fn guard(&self, precision: Precision) -> String {
        let file = if self.file.is_empty() { "kernels" } else { self.file };
        let text = format!("forms_{}_{file}_{}_h", self.prefix, precision.name());
        let words = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
        words.collect::<Vec<_>>().join("_").to_uppercase()
    }
}

/// Source of the kernels that a target can express.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Emitted {
    /// The source; empty if the target can express none of the kernels.
    pub text: String,
    /// For each omitted kernel, the feature that the target lacks.
    pub omitted: Vec<EmitError>,
}

/// Emits kernels as source that compiles as it stands: the definitions that they need, and a
/// documented function for each. In C, CUDA and WGSL every function is followed by one that computes
/// it over arrays.
///
/// # Errors
/// The missing feature of the target, for the first kernel that needs it.
pub fn emit(kernels: &[Source], target: Target, precision: Precision) -> Result<String, EmitError> {
    let emitted = emit_possible(kernels, target, precision, FileNames::default())?;
    emitted.omitted.into_iter().next().map_or(Ok(emitted.text), Err)
}

/// Emits kernels as [`emit`] does, and omits those that the target cannot express.
///
/// ```
/// use forms_core::{check::read_theory, compile::compile_kernel};
/// use forms_core::emission::{FileNames, Precision, Source, Target, emit_possible};
/// let (mut theory, _) = read_theory("kernel half(x) = x/2; kernel thick(x) = expint3(x) where x > 0;");
/// let kernels = theory.kernels.clone();
/// let sources: Vec<Source> = kernels
///     .iter()
///     .map(|kernel| compile_kernel(&mut theory.pool, kernel).unwrap().into())
///     .collect();
/// let names = FileNames { prefix: "acme_", file: "beams" };
/// let emitted = emit_possible(&sources, Target::C, Precision::F64, names).unwrap();
/// assert!(emitted.text.starts_with("#ifndef FORMS_ACME_BEAMS_F64_H"));
/// assert!(emitted.text.contains("static inline double acme_half(double x) {"));
/// assert!(emitted.omitted[0].to_string().starts_with("the kernel `thick` calls `expint3`"));
/// ```
///
/// # Errors
/// If the target does not have the precision.
pub fn emit_possible(
    kernels: &[Source],
    target: Target,
    precision: Precision,
    file: FileNames<'_>,
) -> Result<Emitted, EmitError> {
    if !target.has(precision) {
        return Err(EmitError::Precision(target, precision));
    }
    let (mut possible, mut omitted) = (Vec::new(), Vec::new());
    for kernel in kernels {
        let mut kernel = kernel.in_target(target, precision);
        match check(&kernel.program, target, precision) {
            Ok(()) => {
                kernel.program.name.insert_str(0, file.prefix);
                possible.push(kernel);
            }
            Err(error) => omitted.push(error),
        }
    }
    let is_empty = possible.is_empty() && !omitted.is_empty();
    let text = if is_empty { String::new() } else { written(&possible, target, precision, file) };
    Ok(Emitted { text, omitted })
}

/// Writes the file of kernels that the target can express.
fn written(kernels: &[Source], target: Target, precision: Precision, file: FileNames<'_>) -> String {
    let programs: Vec<&Program> = kernels.iter().map(|kernel| &kernel.program).collect();
    let guard = file.guard(precision);
    let language = C::new(flavour(target), precision);
    let is_wide = |kernel: &&Source| kernel.is_in_double(target, precision);
    let (wide, narrow): (Vec<&Source>, Vec<&Source>) = kernels.iter().partition(is_wide);
    let [wide, narrow] =
        [wide, narrow].map(|kernels| kernels.into_iter().map(|kernel| &kernel.program).collect::<Vec<_>>());
    let (head, foot) = match target {
        Target::Rust if kernels.iter().any(|kernel| kernel.needs_math(precision)) => {
            (forms_math::source(), "")
        }
        Target::Rust => (String::new(), ""),
        Target::C | Target::Cuda => (language.head(&narrow, &wide, &guard), language.foot()),
        Target::Wgsl => (wgsl::head(&programs), ""),
    };
    let names: Vec<String> = programs.iter().map(|program| program.name.clone()).collect();
    let names = names::of_functions(target, &names);
    let functions =
        kernels.iter().zip(&names).map(|(kernel, names)| kernel.functions(names, target, precision));
    let functions = functions.collect::<Vec<_>>().join("\n");
    // in Rust the needed definitions come last, so that the kernels can be read first
    let parts = if target == Target::Rust {
        [functions, head, String::new()]
    } else {
        [head, functions, foot.to_string()]
    };
    let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    parts.join("\n")
}
