//! Sources that state few or no units are read as usual.

use forms_core::check::read_theory;

#[test]
fn a_name_without_a_unit_is_unchecked() {
    for text in [
        "chart C(x: m, y); let a = x + y; let b = x*y + 1; let c = y + 1;",
        "chart C(x: m, u); map F: C -> C = (u, x);",
        "param a: m; kernel k(a, b) = a + b;",
        "param b; param a: m; fn f(a); let s = f(b) + f; prove p: f + 1 == f + a/a;",
    ] {
        let (_, errors) = read_theory(text);
        assert!(errors.is_empty(), "{text}: {errors:?}");
    }
}

#[test]
fn a_source_without_units_is_unchecked() {
    let (theory, errors) = read_theory("chart C(x, y); let a = x + exp(x)*y**2; kernel k(x) = 1 + x;");
    assert!(errors.is_empty(), "{errors:?}");
    assert_eq!(theory.objects[0].unit, None);
    assert!(theory.kernels[0].units.arguments.is_empty());
}

#[test]
fn a_unit_may_be_stated_with_a_later_chart() {
    let (theory, errors) = read_theory("chart A(x); chart B(x: m); let a = x**2;");
    assert!(errors.is_empty(), "{errors:?}");
    assert_eq!(theory.objects[0].unit.as_deref(), Some("m**2"));
}

#[test]
fn names_of_units_are_free_for_other_use() {
    let (_, errors) = read_theory("chart C(m: m, s: s); param W: W; let J = W*s; prove watt: J/s == W;");
    assert!(errors.is_empty(), "{errors:?}");
}

#[test]
fn arguments_of_a_kernel_are_its_own() {
    let text = "param b: m; kernel k(a: s, b) = a*b; kernel l(a: m, b) = a + b; let c = b;";
    let (theory, errors) = read_theory(text);
    assert!(errors.is_empty(), "{errors:?}");
    let outputs: Vec<_> =
        theory.kernels.iter().map(|kernel| kernel.units.outputs[0].clone().unwrap()).collect();
    assert_eq!(outputs, ["s*m", "m"]);
}
