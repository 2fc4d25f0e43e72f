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
        let sentence = format!("Its relative error is at most 16·{unit}: the bound of the rounding error is");
        assert!(text.contains(&sentence), "{text}");
    }
}

#[test]
fn a_promise_that_is_not_kept_is_told_in_every_target() {
    for (target, precision) in OTHERS {
        let (text, lost) = emitted(CANCELLING, target, precision);
        let sentence = "`within 2` is not guaranteed by the generated code: no error bound is known, because the \
                        domain does not bound `x`";
        assert!(text.contains(sentence), "{text}");
        assert!(lost.len() == 1 && lost[0].starts_with(&format!("`k`: {sentence}")), "{lost:?}");
    }
}

#[test]
fn a_bound_beyond_the_promise_is_told() {
    let text = "kernel k(x) = x/(1 + x) where 1 <= x <= 4 within 1;";
    for (target, precision) in OTHERS {
        let (text, lost) = emitted(text, target, precision);
        assert!(
            text.contains("`within 1` is not guaranteed by the generated code: the relative rounding error"),
            "{text}"
        );
        assert_eq!(lost.len(), 1);
    }
}

#[test]
fn rust_keeps_promises_by_precision_in_every_precision() {
    for (precision, function, sentence) in [
        (Precision::F64, "forms_math::escalate::<", "Its relative error is at most 2·2⁻⁵³; its value is NaN"),
        (
            Precision::F32,
            "forms_math::escalate_f32::<",
            "Its relative error is at most 2·2⁻²⁴; its value is NaN",
        ),
        (
            Precision::DoubleDouble,
            "forms_math::escalate_double_double::<",
            "Its relative error is at most 2⁻⁹⁸; its value is NaN",
        ),
    ] {
        let (text, lost) = emitted(CANCELLING, Target::Rust, precision);
        assert!(text.contains(function) && text.contains(sentence) && lost.is_empty(), "{}", &text[..800]);
    }
    // a bound that the form alone keeps in `f32` needs no more precision
    let (text, lost) = emitted(BOUNDED, Target::Rust, Precision::F32);
    assert!(!text.contains("escalate_f32") && lost.is_empty());
    assert!(text.contains(": the bound of the rounding error is"));
}
