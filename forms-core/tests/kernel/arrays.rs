//! Arrays, definitions and calls in kernels: equal to the same formulas written out by their entries.

use crate::targets::undocumented;
use forms_core::compile::{Compiled, Options, compile};
use forms_core::emission::{Precision, Target, emit};
use forms_testing::SplitMix;

fn compiled(text: &str) -> Compiled {
    let compiled = compile(text, &Options::default());
    assert!(compiled.diagnostics.is_empty(), "{text}: {:?}", compiled.diagnostics);
    compiled
}

/// Kernels, and the same kernels of numbers.
const EQUAL: &[(&str, &str)] = &[
    ("kernel k(p[2]) = p[0]*p[1];", "kernel k(a, b) = a*b;"),
    ("kernel k(p[2], q[2]) = p - q;", "kernel k(a, b, c, e) = (a - c, b - e);"),
    ("kernel k(p[2], t) = 2*p*t + p/t;", "kernel k(a, b, t) = (2*a*t + a/t, 2*b*t + b/t);"),
    (
        "kernel k(R[2, 3], p[3]) = R*p;",
        "kernel k(a, b, c, e, f, g, x, y, z) = (a*x + b*y + c*z, e*x + f*y + g*z);",
    ),
    (
        "kernel k(R[2, 2], S[2, 2]) = R*S;",
        "kernel k(a, b, c, e, f, g, h, i) = (a*f + b*h, a*g + b*i, c*f + e*h, c*g + e*i);",
    ),
    ("kernel k(R[2, 3]) = transpose(R);", "kernel k(a, b, c, e, f, g) = (a, e, b, f, c, g);"),
    ("kernel k(R[2, 2]) = R[1];", "kernel k(a, b, c, e) = (c, e);"),
    ("kernel k(R[2, 2]) = R[1, 0];", "kernel k(a, b, c, e) = c;"),
    ("kernel k(p[3], q[3]) = dot(p, q);", "kernel k(a, b, c, x, y, z) = a*x + b*y + c*z;"),
    (
        "kernel k(p[3], q[3]) = cross(p, q);",
        "kernel k(a, b, c, x, y, z) = (b*z - c*y, c*x - a*z, a*y - b*x);",
    ),
    ("kernel k(p[2]) = norm(p);", "kernel k(a, b) = sqrt(a**2 + b**2);"),
    (
        "kernel k(a) = [[cos(a), -sin(a)], [sin(a), cos(a)]];",
        "kernel k(a) = (cos(a), -sin(a), sin(a), cos(a));",
    ),
    (
        "kernel k(p[2]) = if p[0] > 1 { p } else { [1, p[1]] };",
        "kernel k(a, b) = (if a > 1 { a } else { 1 }, b);",
    ),
    ("kernel k(p[2]) = p + 0;", "kernel k(a, b) = (a, b);"),
    ("let q = [1, 2]; kernel k(p[2]) = dot(p, q);", "kernel k(a, b) = a + 2*b;"),
    ("let ease(t) = t*t*(3 - 2*t); kernel k(a) = ease(a + 1);", "kernel k(a) = (a + 1)**2*(1 - 2*a);"),
    ("let len(p) = norm(p); kernel k(p[2], t) = len(t*p);", "kernel k(a, b, t) = sqrt((t*a)**2 + (t*b)**2);"),
    ("let f(t) = t**2; let g(t) = f(t) + f(2*t); kernel k(a) = g(a);", "kernel k(a) = 5*a**2;"),
    ("kernel f(t) = t**2; kernel k(a) = f(a) + f(a + 1);", "kernel k(a) = a**2 + (a + 1)**2;"),
    ("kernel f(p[2]) = 2*p; kernel k(a, b) = f([b, a]);", "kernel k(a, b) = (2*b, 2*a);"),
    ("kernel f(x) = x**2; kernel h = jacobian(f; x); kernel k(a) = h(a);", "kernel k(a) = 2*a;"),
    ("kernel k(c[3], x) = sum(c[k]*x**k, k = 0..2);", "kernel k(a, b, c, x) = a + b*x + c*x**2;"),
    ("kernel k(x) = product(x + k, k = 1..3);", "kernel k(x) = (x + 1)*(x + 2)*(x + 3);"),
    ("kernel k(x) = x + sum(k, k = 3..2) + product(k, k = 3..2);", "kernel k(x) = x + 1;"),
    ("kernel k(x) = sum(sum(x**(i*j), i = 1..2), j = 1..2);", "kernel k(x) = x + x**2 + x**2 + x**4;"),
    ("let sum = 3; kernel k(x) = sum*x;", "kernel k(x) = 3*x;"),
    (
        "kernel f(x, y) = x*y**2; kernel k = jacobian(f; x, y);",
        "kernel f(x, y) = x*y**2; kernel k = grad(f; x, y);",
    ),
    ("kernel f(p[2]) = [p[0]*p[1], p[0]**2]; kernel k = jacobian(f; p);", "kernel k(a, b) = (b, a, 2*a, 0);"),
    (
        "kernel f(p[2], t) = t*norm(p); kernel k = value_and_jacobian(f; t, p);",
        "kernel k(a, b, t) = (t*sqrt(a**2 + b**2), sqrt(a**2 + b**2), t*a/sqrt(a**2 + b**2), t*b/sqrt(a**2 + b**2));",
    ),
];

#[test]
fn arrays_and_calls_mean_what_is_written_out() {
    let mut random = SplitMix(7);
    for (kernel, by_entries) in EQUAL {
        let (one, other) = (compiled(kernel), compiled(by_entries));
        let [one, other] = [&one, &other].map(|compiled| compiled.kernel("k").expect("a kernel"));
        assert_eq!(one.program().arguments().len(), other.program().arguments().len(), "{kernel}");
        for _ in 0..20 {
            let point: Vec<f64> = one.program().arguments().iter().map(|_| 0.25 + random.unit()).collect();
            let (found, wanted) = (one.values(&point), other.values(&point));
            assert_eq!(found.len(), wanted.len(), "{kernel}");
            for (found, wanted) in found.iter().zip(wanted) {
                assert!(
                    (found - wanted).abs() <= 1e-14 * (1.0 + wanted.abs()),
                    "{kernel}: {found} against {wanted}"
                );
            }
        }
    }
}

#[test]
fn a_signature_names_arguments_and_results() {
    for (kernel, arguments, columns) in [
        ("kernel k(p[2], t) = p;", "p_0 p_1 t", "k_0 k_1"),
        ("kernel k(R[1, 2]) = R[0, 1];", "R_0_0 R_0_1", "k"),
        ("kernel k(R[1, 2]) = R;", "R_0_0 R_0_1", "k_0_0 k_0_1"),
        ("kernel k(a, b) = (a, b);", "a b", "k_0 k_1"),
        ("kernel k(p[2]) = (p[0], p);", "p_0 p_1", "k_0 k_1_0 k_1_1"),
        ("kernel f(p[2]) = p; kernel k = jacobian(f; p);", "p_0 p_1", "k_0_0 k_0_1 k_1_0 k_1_1"),
        ("kernel f(p[2]) = norm(p); kernel k = jacobian(f; p);", "p_0 p_1", "k_0 k_1"),
        ("kernel f(p[2]) = p; kernel k = jacobian(f; p_1);", "p_0 p_1", "k_0 k_1"),
        ("kernel f(a) = a; kernel k = value_and_jacobian(f; a);", "a", "k_0 k_1"),
        ("kernel f(p[1]) = p; kernel k = value_and_jacobian(f; p);", "p_0", "k_0_0 k_1_0"),
    ] {
        let compiled = compiled(kernel);
        let signature = compiled.kernel("k").expect("a kernel").program().signature().clone();
        assert_eq!(signature.arguments().join(" "), arguments, "{kernel}");
        assert_eq!(signature.columns("k").join(" "), columns, "{kernel}");
    }
}

#[test]
fn value_and_derivatives_share_their_work() {
    let text = "kernel f(x, y) = exp(x*y)*sin(x*y); kernel k = value_and_jacobian(f; x, y);";
    let compiled = compiled(text);
    let operations = compiled.kernel("k").expect("a kernel").program().operations();
    assert_eq!(operations.function_calls, 3, "exp, sin and cos: {operations}");
}

#[test]
fn the_value_beside_derivatives_keeps_its_stable_form() {
    for form in ["expm1(x)", "if x != 0 { expm1(x)*1 } else { 0 }"] {
        let text = format!("kernel f(x) = exp(x) - 1 by {form}; kernel k = value_and_jacobian(f; x);");
        let compiled = compiled(&text);
        assert_eq!(compiled.kernel("k").expect("a kernel").values(&[1e-17]), [1e-17, 1.0], "{form}");
    }
}

#[test]
fn the_stable_form_is_differentiated() {
    let text = "kernel f(x) = sqrt(x + 1) - sqrt(x) by 1/(sqrt(x + 1) + sqrt(x)) where x > 0;
        kernel k = value_and_jacobian(f; x);";
    let values = compiled(text).kernel("k").expect("a kernel").values(&[1e20]);
    assert!((values[0] - 5e-11).abs() < 1e-25 && (values[1] + 2.5e-31).abs() < 1e-45, "{values:?}");
}

#[test]
fn a_definition_has_no_meaning_of_the_names_of_its_caller() {
    // `s` is bound by the integral in `mean`, and is not the argument of the kernel
    let text = "let mean(f) = quadrature(f*s**2, s = 0..1); kernel k(s) = mean(s);";
    let k = compiled(text);
    let values = k.kernel("k").expect("a kernel").values(&[3.0]);
    assert!((values[0] - 1.0).abs() < 1e-12, "3 ∫ s² ds = 1, found {values:?}");
}

#[test]
fn a_definition_in_a_statement_is_decided_like_its_expression() {
    let text = "chart P(q, p); fn H(q, p);
        let br(f, g) = diff(f, q)*diff(g, p) - diff(g, q)*diff(f, p);
        prove canonical: br(q, p) == 1;
        prove antisymmetric: br(H, q*p) == -br(q*p, H);
        refute symmetric: br(H, q) == br(q, H);
        let lap(w) = d(w);
        prove forms_too: d(lap(H*p)) == 0;
        prove gauss: sum(k**2, k = 1..4) == 30;";
    compiled(text);
}

/// Emits the last kernel of a text.
fn emitted(text: &str, target: Target) -> String {
    let compiled = compiled(text);
    let program = compiled.kernels.last().expect("a kernel").program();
    let text = emit(&[undocumented(program)], target, target.usual_precision()).expect("a source");
    let start = ["fn k", "void k", "double k"].iter().filter_map(|head| text.find(head)).min();
    text[start.expect("the function")..].to_string()
}

const MOVED: &str = "kernel k(p[2], R[2, 2], t) = R*p + [t, 0];";
const WITH_SLOPE: &str = "kernel f(p[2]) = p[0]*p[1]; kernel k = value_and_jacobian(f; p);";

#[test]
fn arrays_are_arrays_of_the_target() {
    let cases = [
        (
            MOVED,
            Target::Rust,
            "fn k(p: [f64; 2], R: [[f64; 2]; 2], t: f64) -> [f64; 2] {\n    [\n        R[0][0] * p[0]",
        ),
        (MOVED, Target::C, "void k(const double p[2], const double R[4], double t, double *outputs) {\n"),
        (MOVED, Target::C, "R[2]"),
        (
            MOVED,
            Target::Wgsl,
            "fn k(p: array<f32, 2>, R: array<array<f32, 2>, 2>, t: f32) -> array<f32, 2> {\n",
        ),
        (
            WITH_SLOPE,
            Target::Rust,
            "fn k(p: [f64; 2]) -> (f64, [f64; 2]) {\n    (p[0] * p[1], [p[1], p[0]])\n}",
        ),
        (
            WITH_SLOPE,
            Target::C,
            "outputs[0] = p[0] * p[1];\n    outputs[1] = p[1];\n    outputs[2] = p[0];\n",
        ),
        (WITH_SLOPE, Target::Wgsl, "return array<f32, 3>(p[0] * p[1], p[1], p[0]);"),
        (
            "kernel k(a) = [[a, 1], [2, a]] where a > 0;",
            Target::Rust,
            "fn k(a: f64) -> [[f64; 2]; 2] {\n    let inside = a > 0.0;\n    if !inside {\n        return \
             [[f64::NAN; 2]; 2];\n    }\n    [[a, 1.0], [2.0, a]]\n}",
        ),
        (
            "kernel k(a) = [[a, 1], [2, a]];",
            Target::Wgsl,
            "return array<array<f32, 2>, 2>(array<f32, 2>(a, 1.0f), array<f32, 2>(2.0f, a));",
        ),
        ("kernel k(t0[2]) = exp(t0[0]*t0[1])*exp(t0[0]*t0[1] + 1);", Target::C, "const double tt0 = "),
    ];
    for (text, target, part) in cases {
        let source = emitted(text, target);
        assert!(source.contains(part), "{text} in {target:?}:\n{source}");
    }
}

#[test]
fn double_doubles_have_the_declared_shapes() {
    let compiled = compiled(WITH_SLOPE);
    let program = compiled.kernel("k").expect("a kernel").program();
    let text = emit(&[undocumented(program)], Target::Rust, Precision::DoubleDouble).expect("a source");
    let number = "forms_math::DoubleDouble";
    assert!(
        text.contains(&format!("    p: [{number}; 2],\n) -> ({number}, [{number}; 2]) {{")),
        "{}",
        &text[..900]
    );
    assert!(text.contains("::value([p[0], p[1]]);\n    (v0, [v1, v2])\n}"), "{}", &text[..900]);
}
