//! The text of this crate's scalar arithmetic, to be pasted next to a kernel.
//!
//! ```text
//! lib.rs ─ mod error_free; ─▶ mod error_free { … } ─ … ─▶ one module that needs nothing but the standard library
//! ```
//! Batches are omitted: the pasted text is for single values. It uses the standard library, and
//! contains no condition on the feature `std`, which is unknown in another crate.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// Files that are pasted, by their path without `.rs`.
const FILES: &[(&str, &str)] = &[
    ("composed", include_str!("composed.rs")),
    ("double_double", include_str!("double_double.rs")),
    ("double_double/arithmetic", include_str!("double_double/arithmetic.rs")),
    ("double_double/circular", include_str!("double_double/circular.rs")),
    ("double_double/ends", include_str!("double_double/ends.rs")),
    ("double_double/error_function", include_str!("double_double/error_function.rs")),
    (
        "double_double/error_function/coefficients",
        include_str!("double_double/error_function/coefficients.rs"),
    ),
    ("double_double/exponential", include_str!("double_double/exponential.rs")),
    ("double_double/real", include_str!("double_double/real.rs")),
    ("elementary", include_str!("elementary.rs")),
    ("elementary/angle", include_str!("elementary/angle.rs")),
    ("elementary/hyperbolic", include_str!("elementary/hyperbolic.rs")),
    ("elementary/logarithm", include_str!("elementary/logarithm.rs")),
    ("elementary/power", include_str!("elementary/power.rs")),
    ("error_free", include_str!("error_free.rs")),
    ("escalate", include_str!("escalate.rs")),
    ("escalate/double_double", include_str!("escalate/double_double.rs")),
    ("escalate/lane", include_str!("escalate/lane.rs")),
    ("escalate/rounding", include_str!("escalate/rounding.rs")),
    ("escalate/tape", include_str!("escalate/tape.rs")),
    ("float", include_str!("float.rs")),
    ("formula", include_str!("formula.rs")),
    ("guarded", include_str!("guarded.rs")),
    ("guarded/arithmetic", include_str!("guarded/arithmetic.rs")),
    ("guarded/beyond", include_str!("guarded/beyond.rs")),
    ("guarded/bound", include_str!("guarded/bound.rs")),
    ("guarded/functions", include_str!("guarded/functions.rs")),
    ("guarded/number", include_str!("guarded/number.rs")),
    ("guarded/real", include_str!("guarded/real.rs")),
    ("guarded/special", include_str!("guarded/special.rs")),
    ("hardware", include_str!("hardware.rs")),
    ("instructions", include_str!("instructions.rs")),
    ("lane", include_str!("lane.rs")),
    ("lane/bounded", include_str!("lane/bounded.rs")),
    ("lane/bounded/functions", include_str!("lane/bounded/functions.rs")),
    ("lane/bounded/real", include_str!("lane/bounded/real.rs")),
    ("lane/coefficients", include_str!("lane/coefficients.rs")),
    ("lane/error_function", include_str!("lane/error_function.rs")),
    ("lane/exponential", include_str!("lane/exponential.rs")),
    ("lane/inverse", include_str!("lane/inverse.rs")),
    ("lane/logarithm", include_str!("lane/logarithm.rs")),
    ("lane/pair", include_str!("lane/pair.rs")),
    ("lane/power", include_str!("lane/power.rs")),
    ("lane/real", include_str!("lane/real.rs")),
    ("lane/trigonometric", include_str!("lane/trigonometric.rs")),
    ("lane/word", include_str!("lane/word.rs")),
    ("number", include_str!("number.rs")),
    ("quadrature", include_str!("quadrature.rs")),
    ("real", include_str!("real.rs")),
    ("scalar", include_str!("scalar.rs")),
    ("special", include_str!("special.rs")),
    ("special/clausen", include_str!("special/clausen.rs")),
    ("special/dilogarithm", include_str!("special/dilogarithm.rs")),
    ("special/error_function", include_str!("special/error_function.rs")),
    ("special/error_function/coefficients", include_str!("special/error_function/coefficients.rs")),
    ("special/exponential_integral", include_str!("special/exponential_integral.rs")),
    ("special/zeta", include_str!("special/zeta.rs")),
    ("table", include_str!("table.rs")),
    ("table/map", include_str!("table/map.rs")),
    ("wide", include_str!("wide.rs")),
    ("wide/circular", include_str!("wide/circular.rs")),
    ("wide/constants", include_str!("wide/constants.rs")),
    ("wide/display", include_str!("wide/display.rs")),
    ("wide/exponential", include_str!("wide/exponential.rs")),
    ("wide/natural", include_str!("wide/natural.rs")),
    ("wide/product", include_str!("wide/product.rs")),
    ("wide/quotient", include_str!("wide/quotient.rs")),
    ("wide/real", include_str!("wide/real.rs")),
    ("wide/representation", include_str!("wide/representation.rs")),
    ("wide/sum", include_str!("wide/sum.rs")),
];

/// Files that are not pasted, since they process several values at a time.
const OTHER_FILES: &[(&str, &str)] = &[
    ("batch", include_str!("batch.rs")),
    ("batch/block", include_str!("batch/block.rs")),
    ("batch/compiled", include_str!("batch/compiled.rs")),
    ("batch/length", include_str!("batch/length.rs")),
    ("batch/method", include_str!("batch/method.rs")),
];

/// Returns this crate as files of a folder, by their relative paths, for compilation with kernels
/// where the crate itself is not available: without features, tests and this function.
///
/// ```
/// let files = forms_math::crate_files();
/// assert!(files.iter().any(|(path, text)| path == "lib.rs" && text.contains("pub use batch::")));
/// ```
pub fn crate_files() -> Vec<(String, String)> {
    let root = with_standard_library(include_str!("lib.rs"));
    let root = root.lines().filter(|line| !line.contains("source"));
    let root = root.map(|line| format!("{line}\n")).collect();
    let modules = FILES.iter().chain(OTHER_FILES);
    let modules = modules.map(|(path, text)| (format!("{path}.rs"), with_standard_library(text)));
    core::iter::once(("lib.rs".to_string(), root)).chain(modules).collect()
}

/// Returns `mod forms_math { … }` for the root of a crate: `f32`, `f64`,
/// [`DoubleDouble`](crate::DoubleDouble), lanes and [`Wide`](crate::Wide) as [`Real`](crate::Real)s,
/// without module comments and tests.
///
/// ```
/// let text = forms_math::source();
/// assert!(text.contains("pub trait Real") && !text.contains("#[test]"));
/// ```
pub fn source() -> String {
    let text = pasted("", include_str!("lib.rs"));
    format!(
        "#[allow(dead_code, unused_imports, reason = \"kernels use parts of it\")]\nmod forms_math {{\n\n{}}}\n",
        text.trim_start()
    )
}

/// Condition of an item that needs the standard library.
const WITH_STANDARD_LIBRARY: &str = "#[cfg(feature = \"std\")]";
/// Beginnings of the condition of an item that is compiled only without the standard library.
const WITHOUT_STANDARD_LIBRARY: [&str; 3] = [
    "#[cfg(not(feature = \"std\"))]",
    "#[cfg(not(any(feature = \"std\"",
    "#[cfg(all(not(feature = \"std\"), ",
];

/// Returns a file as it is compiled with the standard library: the conditions that require it are
/// removed, and so are the items that are compiled only without it.
fn with_standard_library(text: &str) -> String {
    let mut lines: Vec<&str> = Vec::new();
    // Indentation of an item that is left out.
    let mut left_out = None;
    for line in text.lines() {
        let start = line.trim_start();
        let indentation = line.len() - start.len();
        if left_out.is_some() {
            if left_out == Some(indentation) && line.ends_with([';', '}']) {
                left_out = None;
            }
        } else if WITHOUT_STANDARD_LIBRARY.iter().any(|condition| start.starts_with(condition)) {
            // The documentation above the condition is dropped too.
            while lines.last().is_some_and(|line| line.trim_start().starts_with("///")) {
                lines.pop();
            }
            left_out = Some(indentation);
        } else if start != WITH_STANDARD_LIBRARY {
            lines.push(line);
        }
    }
    lines.join("\n") + "\n"
}

/// Whether a line belongs to a pasted module: module comments and lines for the whole crate do not.
fn belongs_to_module(line: &str) -> bool {
    !["//!", "#![no_std]", "extern crate "].iter().any(|start| line.trim_start().starts_with(start))
}

/// Returns the text of a module with its submodules inserted.
fn pasted(path: &str, text: &str) -> String {
    let mut lines = Vec::new();
    let mut within_left_out = false;
    let own = text.split("\n#[cfg(test)]").next().unwrap_or_default();
    for line in with_standard_library(own).lines().filter(|line| belongs_to_module(line)) {
        let declared = line.strip_suffix(';').and_then(|line| Some(line.split_once("mod ")?.1));
        let imported = line.strip_prefix("pub use ").and_then(|rest| rest.split("::").next());
        let left_out = match (declared, imported) {
            (Some(module), _) => file(path, module).is_none(),
            (None, Some(module)) => path.is_empty() && file(path, module).is_none(),
            (None, None) => within_left_out,
        };
        within_left_out = left_out && !line.ends_with(';');
        if left_out {
            // The attributes above the line are dropped too.
            while lines.last().is_some_and(|line: &String| line.starts_with("#[")) {
                lines.pop();
            }
        } else if let Some((path, text)) = declared.and_then(|module| file(path, module)) {
            lines.push(format!("{} {{\n{}}}", line.trim_end_matches(';'), pasted(&path, text)));
        } else if let Some(item) = line.strip_prefix("use alloc::") {
            // Only the root of a crate declares `alloc` for all of its modules.
            lines.push(format!("use std::{item}"));
        } else {
            lines.push(line.replace("crate::", "crate::forms_math::"));
        }
    }
    lines.join("\n") + "\n"
}

/// Returns the file of a module within another.
fn file(path: &str, module: &str) -> Option<(String, &'static str)> {
    let path = if path.is_empty() { module.to_string() } else { format!("{path}/{module}") };
    let (_, text) = FILES.iter().find(|(known, _)| *known == path)?;
    Some((path, text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pasted_module_needs_the_standard_library_and_no_features() {
        let text = source();
        for absent in ["feature =", "alloc::", "extern crate", "no_std", "libm::", "once_lock"] {
            assert!(!text.contains(absent), "{absent}");
        }
        let files = crate_files();
        assert!(files.iter().all(|(_, text)| !text.contains("feature = \"std\"")));
    }

    /// [`Real`](crate::Real) has methods of these names for `f64` that compute something else, and a
    /// method call means them where the standard library is missing.
    #[test]
    fn functions_that_real_numbers_have_too_are_called_by_paths() {
        for (path, text) in FILES.iter().chain(OTHER_FILES) {
            for line in text.lines().filter(|line| !line.trim_start().starts_with("//")) {
                let is_ambiguous = [".mul_add(", ".hypot("].iter().any(|call| line.contains(call));
                assert!(!is_ambiguous, "{path}: {line}");
            }
        }
    }

    #[test]
    fn items_for_programs_without_the_standard_library_are_left_out() {
        let text = "\
#[cfg(feature = \"std\")]
use a::f;
#[cfg(not(feature = \"std\"))]
use b::f;

impl A {
    /// One.
    #[cfg(feature = \"std\")]
    fn one() {}
    /// The other.
    #[cfg(not(feature = \"std\"))]
    fn one() {
        if true {
            f();
        }
    }
    fn two() {}
}
";
        let left = "use a::f;\n\nimpl A {\n    /// One.\n    fn one() {}\n    fn two() {}\n}\n";
        assert_eq!(with_standard_library(text), left);
    }

    #[test]
    fn the_crate_as_files_has_every_module_that_is_compiled() {
        let files = crate_files();
        for (path, text) in &files {
            let folder = path.strip_suffix("lib.rs").unwrap_or(path.trim_end_matches(".rs"));
            let folder = if folder.is_empty() { String::new() } else { format!("{folder}/") };
            let lines: Vec<&str> = text.lines().collect();
            for (place, line) in lines.iter().enumerate() {
                let declared = line.strip_suffix(';').and_then(|line| Some(line.split_once("mod ")?.1));
                let conditional = place > 0 && lines[place - 1].starts_with("#[cfg(");
                if let Some(module) = declared.filter(|_| !conditional) {
                    let wanted = format!("{folder}{module}.rs");
                    assert_eq!(files.iter().filter(|(path, _)| *path == wanted).count(), 1, "{wanted}");
                }
            }
        }
    }
}
