//! Treatment of `within` where a kernel is emitted: kept by precision or by a bound, or reported as
//! lost.

use forms_core::check::read_theory;
use forms_core::compile::compile_kernel;
use forms_core::emission::{Precision, Source, Target, broken_promises, emit};

/// Kernel whose rounding errors alone stay within the bound, and kernel for which they do not.
const BOUNDED: &str = "kernel k(x) = x/(1 + x) where 1 <= x <= 4 within 16;";
const CANCELLING: &str = "kernel k(x) = (1 - cos(x))/x**2 within 2;";

fn source(text: &str) -> Source {
    let (mut theory, errors) = read_theory(text);
    assert!(errors.is_empty(), "{errors:?}");
    let kernel = theory.kernels[0].clone();
    let generated = compile_kernel(&mut theory.pool, &kernel).expect("a kernel");
    Source { within: kernel.within, ..generated.into() }
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

/// Difference that loses ten bits, which single precision does not have.
const LOSING: &str = "kernel k(x) = 1000*x - 999 where 1 <= x <= 2 within 4;";

#[test]
fn in_c_and_cuda_a_promise_in_single_precision_is_kept_in_double() {
    for target in [Target::C, Target::Cuda] {
        let (text, lost) = emitted(LOSING, target, Precision::F32);
        assert!(lost.is_empty(), "{lost:?}");
        for part in [
            "Its relative error is at most 4·2⁻²⁴: it is computed in `double`, and the bound of the rounding error",
            "inline double k_in_double(double x) {",
            "inline float k(float x) {\n    return (float)k_in_double(x);\n}",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
        // a promise that single precision keeps needs no other
        assert!(!emitted(BOUNDED, target, Precision::F32).0.contains("double"));
        // what is promised of a value that can vanish is not known, and double precision keeps more of it
        let vanishing = "kernel k(p[2], q[2]) = [p[0]*q[1] - p[1]*q[0], p[0]] within 16;";
        let (text, lost) = emitted(vanishing, target, Precision::F32);
        assert!(lost.len() == 1 && lost[0].contains("It is computed in `double`, and rounded."), "{lost:?}");
        let wide = "const double p_in_double[2] = {p[0], p[1]};";
        assert!(text.contains(wide) && text.contains("outputs[1] = (float)values[1];"), "{text}");
    }
    let (_, lost) = emitted(LOSING, Target::Wgsl, Precision::F32);
    assert_eq!(lost.len(), 1);
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
fn a_function_that_wgsl_lacks_keeps_a_promise_by_the_bound_of_its_definition() {
    let kernel = |function: &str| format!("kernel k(x) = {function}(x) where 1/8 <= x <= 1 within 64;");
    let lost = |function: &str| emitted(&kernel(function), Target::Wgsl, Precision::F32).1;
    for function in ["expm1", "log1p", "erf"] {
        assert!(lost(function).is_empty(), "{:?}", lost(function));
    }
    // WGSL states only absolute errors of its own functions
    assert_eq!(lost("sin").len(), 1);
}

#[test]
fn a_bound_is_that_of_the_precision_and_the_target() {
    let kernel = "kernel k(x) = x/(1 + x) where 1 <= x <= 4;";
    let sentence = "The rounding error of its value in `f32` is at most ";
    for target in [Target::C, Target::Cuda, Target::Wgsl] {
        let (text, _) = emitted(kernel, target, Precision::F32);
        assert!(text.contains(sentence) && text.contains("·2⁻²⁴ of its magnitude"), "{text}");
    }
    let (rust, _) = emitted(kernel, Target::Rust, Precision::F32);
    assert!(!rust.contains("The rounding error"), "{rust}");
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
    // a bound that the form alone keeps needs no more precision
    for precision in [Precision::F32, Precision::F64] {
        let (text, lost) = emitted(BOUNDED, Target::Rust, precision);
        assert!(!text.contains("escalate") && lost.is_empty());
        assert!(text.contains(": the bound of the rounding error is"));
    }
}
