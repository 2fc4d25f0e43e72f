//! Forms for one precision or target, `for f32 { by … }`: where each is computed, and what is proved of it.

use forms_core::check::read_theory;
use forms_core::compile::compile_kernel;
use forms_core::diagnostic::Diagnostic;
use forms_core::emission::{Precision, Source, Target, emit};

/// Every precision of every target, but double-double.
const PLACES: [(Target, Precision); 7] = [
    (Target::Rust, Precision::F64),
    (Target::Rust, Precision::F32),
    (Target::C, Precision::F64),
    (Target::C, Precision::F32),
    (Target::Cuda, Precision::F64),
    (Target::Cuda, Precision::F32),
    (Target::Wgsl, Precision::F32),
];

fn compiled(text: &str) -> Result<Source, Vec<Diagnostic>> {
    let (mut theory, errors) = read_theory(text);
    if !errors.is_empty() {
        return Err(errors);
    }
    let kernel = theory.kernels[0].clone();
    let generated = compile_kernel(&mut theory.pool, &kernel)?;
    Ok(Source { within: kernel.within, ..generated.into() })
}

/// Returns the places whose source contains a text.
fn places_with(source: &Source, text: &str) -> Vec<(Target, Precision)> {
    let sources = std::slice::from_ref(source);
    let contains = |&(target, precision): &(Target, Precision)| {
        emit(sources, target, precision).expect("a source").contains(text)
    };
    PLACES.into_iter().filter(|place| contains(place)).collect()
}

fn first_error(text: &str) -> (String, String) {
    let errors = compiled(text).expect_err("an error");
    (errors[0].message.clone(), text[errors[0].span.start as usize..errors[0].span.end as usize].to_string())
}

#[test]
fn a_form_for_f32_is_computed_in_f32_of_every_target() {
    let source =
        compiled("kernel k(x) = (1 - cos(x))/x by 2*sin(x/2)**2/x for f32 { by x*(2*(sin(x/2)/x)**2) };");
    let source = source.expect("a kernel");
    let single: Vec<_> = PLACES.into_iter().filter(|place| place.1 == Precision::F32).collect();
    assert_eq!(places_with(&source, "Computed by its form for `f32`."), single);
}

#[test]
fn a_form_for_a_language_is_computed_in_its_precisions() {
    for (name, target) in [("c", Target::C), ("cuda", Target::Cuda), ("wgsl", Target::Wgsl)] {
        let source =
            compiled(&format!("kernel k(x) = (x + 1)**2 - x**2 for {name} {{ by x*2.5 - x/2 + 1 }};"));
        let own: Vec<_> = PLACES.into_iter().filter(|place| place.0 == target).collect();
        assert_eq!(places_with(&source.expect("a kernel"), "2.5"), own, "{name}");
    }
}

#[test]
fn the_first_form_that_applies_is_computed() {
    let source = "kernel k(x) = 2*x for cuda { by 3*x - x } for f32 { by 5*x - 3*x };";
    let source = compiled(source).expect("a kernel");
    let cuda = [(Target::Cuda, Precision::F64), (Target::Cuda, Precision::F32)];
    assert_eq!(places_with(&source, "Computed by its form for `cuda`."), cuda);
}

#[test]
fn a_form_for_f64_is_the_one_after_by() {
    let [one, other] = ["by log1p(x)", "for f64 { by log1p(x) }"]
        .map(|form| compiled(&format!("kernel k(x) = log(1 + x) {form};")).expect("a kernel"));
    assert_eq!(one.program, other.program);
}

#[test]
fn an_approximation_for_f32_has_its_own_tolerance() {
    let source = "kernel k(t) = exp(t) for f32 { by 1 + t + t**2/2 + t**3/6 + t**4/24 approx 1e-7 }
        where -1/10 <= t <= 1/10;";
    let source = compiled(source).expect("a kernel");
    let claim = "Proved to differ from its formula by at most 1e-7 of the value, before rounding.";
    let single: Vec<_> = PLACES.into_iter().filter(|place| place.1 == Precision::F32).collect();
    assert_eq!(places_with(&source, claim), single);
}

#[test]
fn a_false_form_for_a_target_is_refuted_at_its_target() {
    for (form, what) in [
        ("f32 { by sin(x)/2 }", "the stable form of `k` differs from its formula"),
        ("wgsl { by x*sin(x)/x }", "the stable form of `k` is undefined at a point"),
        ("c { by x approx 1e-3 }", "the form of `k` is not within 1/1000 of its formula"),
    ] {
        let (message, place) = first_error(&format!("kernel k(x) = sin(x) for {form};"));
        assert!(message.contains(what), "{message}");
        assert_eq!(place, form.split(' ').next().expect("a target"));
    }
}

#[test]
fn mistakes_lead_to_what_can_be_written() {
    for (clauses, what, place) in [
        ("for rust { by x }", "`rust` is not a precision or target that can have a form of its own", "rust"),
        ("for f32 { by x } for f32 { by x }", "a kernel has at most one form for `f32`", "f32"),
        ("by x for f64 { by x }", "the form after `by` is the one for `f64`", "f64"),
        ("for f32 { by (x, x) }", "`k` has 1 outputs, but `by` gives 2", "f32"),
        ("for f32 { x }", "expected `by`, found `x`", "x"),
        ("for f32 by x", "expected `{`, found `by`", "by"),
    ] {
        let (message, quoted) = first_error(&format!("kernel k(x) = x {clauses};"));
        assert!(message.contains(what), "{clauses}: {message}");
        assert_eq!(quoted, place, "{clauses}");
    }
}
