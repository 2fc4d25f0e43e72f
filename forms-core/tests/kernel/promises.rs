//! Treatment of `within` where a kernel is emitted: kept by precision or by a bound, or reported as
//! lost.

use forms_core::check::read_theory;
use forms_core::compile::compile_kernel;
use forms_core::emission::{KernelDocs, Precision, Source, Target, broken_promises, emit};

/// Kernel whose rounding errors alone stay within the bound, and kernel for which they do not.
const BOUNDED: &str = "kernel k(x) = x/(1 + x) where 1 <= x <= 4 within 16;";
const CANCELLING: &str = "kernel k(x) = (1 - cos(x))/x**2 within 2;";

fn source(text: &str) -> Source {
    let (mut theory, errors) = read_theory(text);
    assert!(errors.is_empty(), "{errors:?}");
    let kernel = theory.kernels[0].clone();
    let program = compile_kernel(&mut theory.pool, &kernel).expect("a kernel").optimised.clone();
    Source { program, docs: KernelDocs::default(), within: kernel.within }
}

/// Returns the emitted text, and the messages about promises that are not kept.
fn emitted(text: &str, target: Target, precision: Precision) -> (String, Vec<String>) {
    let sources = [source(text)];
    let emitted = emit(&sources, target, precision).expect("a source");
    (emitted, broken_promises(&sources, target, precision))
}

const OTHERS: [(Target, Precision); 5] = [
    (Target::C, Precision::F64),
    (Target::C, Precision::F32),
    (Target::Cuda, Precision::F64),
    (Target::Cuda, Precision::F32),
    (Target::Wgsl, Precision::F32),
];

#[test]
fn a_bound_over_the_domain_keeps_a_promise_in_every_target() {
    for (target, precision) in OTHERS {
        let (text, lost) = emitted(BOUNDED, target, precision);
        assert!(lost.is_empty(), "{lost:?}");
        let unit = if precision == Precision::F32 { "2⁻²⁴" } else { "2⁻⁵³" };
        let sentence =
            format!("Its value is within 16·{unit} of the exact one, relative to it: rounding makes at most");
        assert!(text.contains(&sentence), "{text}");
    }
}

#[test]
fn a_promise_that_is_not_kept_is_told_in_every_target() {
    for (target, precision) in OTHERS {
        let (text, lost) = emitted(CANCELLING, target, precision);
        let sentence = "`within 2` is not kept here: no bound of its error is known, since the domain does not bound `x`";
        assert!(text.contains(sentence), "{text}");
        assert!(lost.len() == 1 && lost[0].starts_with(&format!("`k`: {sentence}")), "{lost:?}");
    }
}

#[test]
fn a_bound_beyond_the_promise_is_told() {
    let text = "kernel k(x) = x/(1 + x) where 1 <= x <= 4 within 1;";
    for (target, precision) in OTHERS {
        let (text, lost) = emitted(text, target, precision);
        assert!(text.contains("`within 1` is not kept here: rounding is known to be within"), "{text}");
        assert_eq!(lost.len(), 1);
    }
}

#[test]
fn rust_keeps_promises_by_precision_in_every_precision() {
    for (precision, function, sentence) in [
        (Precision::F64, "forms_math::escalate::<", "within 2·2⁻⁵³ of the exact one, relative to it, or NaN"),
        (
            Precision::F32,
            "forms_math::escalate_f32::<",
            "within 2·2⁻²⁴ of the exact one, relative to it, or NaN",
        ),
        (Precision::DoubleDouble, "forms_math::escalate_double_double::<", "within 2⁻⁹⁸ of the exact one"),
    ] {
        let (text, lost) = emitted(CANCELLING, Target::Rust, precision);
        assert!(text.contains(function) && text.contains(sentence) && lost.is_empty(), "{}", &text[..800]);
    }
    // a bound that the form alone keeps in `f32` needs no more precision
    let (text, lost) = emitted(BOUNDED, Target::Rust, Precision::F32);
    assert!(!text.contains("escalate_f32") && lost.is_empty());
    assert!(text.contains("relative to it: rounding makes at most"));
}
