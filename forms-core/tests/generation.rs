//! Generation of kernels: seams that agree, seams that do not, seams that cannot be decided;
//! translations.

use forms_core::check::read_theory;
use forms_core::compile::compile_kernel;
use forms_core::generation::Generated;
use forms_core::syntax::Source;

/// Generates the last kernel of a source; the error is its message.
fn generated(text: &str) -> Result<Generated, String> {
    let source = Source::new("k.forms", text);
    let (mut theory, errors) = read_theory(text);
    assert!(errors.is_empty(), "{}", errors.iter().map(|error| source.render(error)).collect::<String>());
    let kernel = theory.kernels.last().cloned().expect("a kernel");
    compile_kernel(&mut theory.pool, &kernel).map_err(|errors| {
        errors.iter().map(|error| format!("{}\n", error.message)).collect::<String>().trim_end().to_string()
    })
}

fn is_accepted(text: &str) {
    if let Err(message) = generated(text) {
        panic!("{text}\n{message}");
    }
}

/// Asserts that the kernel is refused with this message.
fn is_refused(text: &str, message: &str) {
    match generated(text) {
        Ok(_) => panic!("accepted: {text}"),
        Err(found) => assert_eq!(found, message, "{text}"),
    }
}

#[test]
fn branches_that_meet_are_accepted() {
    for text in [
        "kernel k(u) = if u > 0 { u } else { 0 };",
        "kernel k(u) = if u >= 0 { u } else { -u };",
        "kernel k(u) = 1 + 2*if u < 1 { u**2 } else { 2*u - 1 };",
        "kernel k(u, v) = if u > v { sqrt(1 + u**2) } else { sqrt(1 + v**2) };",
        "kernel k(u, v) = if u*v > 1 { u*v } else { 1 };",
        "kernel k(u, v) = if u < 2*v { exp(u) } else { exp(v)**2 };",
        "kernel k(x, y) = if x**2 + y**2 < 1 { 1 - x**2 - y**2 } else { 0 };",
        "kernel k(x, y) = if sqrt(x**2 + y**2) < 2 { x**2 + y**2 } else { 4 };",
        "kernel k(x) = if abs(x) < 1/2 { x**2 } else { abs(x) - 1/4 };",
        "kernel k(t) = if cos(t) > 0 { cos(t)/pi } else { 0 };",
        "kernel k(t) = if 2*sin(t) < 1 { sin(t)**2 } else { 1/4 };",
        "kernel k(x, y, z, a, b, c) = if x*a + y*b + z*c > 0 { x*a + y*b + z*c } else { 0 };",
        "kernel k(a, x, b) = if a*x > b { a*x - b } else { 0 } where a > 0;",
        "kernel k(u) = if 0 < u < 1 { u*(1 - u) } else { 0 };",
        "kernel k(x) = if x != 1 { x**2 } else { 2*x - 1 };",
    ] {
        is_accepted(text);
    }
}

#[test]
fn nested_choices_are_compared_where_they_are_reached() {
    for text in [
        "kernel k(u) = if u > 1 { 2*u - 1 } else if u > 0 { u**2 } else { 0 };",
        "kernel k(u) = if u > 1 { 1 } else { if u < 0 { 0 } else { u } };",
        "kernel k(u, v) = if u > 0 { if v > 0 { u*v } else { 0 } } else { 0 };",
        // the inner seam u = 3 lies where the inner conditional is never reached
        "kernel k(u) = if u > 2 { 2 } else { if u > 3 { 17 } else { u } };",
    ] {
        is_accepted(text);
    }
    is_refused(
        "kernel k(u) = if u > 1 { 2*u } else if u > 0 { u**2 } else { 0 };",
        "the branches of `if u > 1` differ at the seam u = 1 of `k`: their difference is 1\n\
         at u = 1: 2 in the branch where the condition holds, 1 in the other",
    );
    is_refused(
        "kernel k(u) = if u > 1 { u } else if u > 0 { u**2 } else { 5 };",
        "the branches of `if u > 0` differ at the seam u = 0 of `k`: their difference is -5\n\
         at u = 0: 0 in the branch where the condition holds, 5 in the other",
    );
}

#[test]
fn the_domain_of_the_kernel_bounds_its_seams() {
    is_accepted("kernel k(u) = if u > 0 { u } else { 7 } where u > 1;");
    is_accepted("kernel k(u) = if u > 0 { u } else { 7 } where 0 < u <= 1e6;");
    is_accepted("kernel k(u, v) = if u > 0 { abs(v) } else { v } where v > 0;");
    is_refused(
        "kernel k(u) = if u > 0 { u } else { 7 } where u > -1;",
        "the branches of `if u > 0` differ at the seam u = 0 of `k`: their difference is -7\n\
         at u = 0: 0 in the branch where the condition holds, 7 in the other",
    );
}

#[test]
fn branches_that_differ_are_refused_with_a_point_of_the_seam() {
    is_refused(
        "kernel k(u) = if u > 0 { u + 1 } else { 0 };",
        "the branches of `if u > 0` differ at the seam u = 0 of `k`: their difference is 1\n\
         at u = 0: 1 in the branch where the condition holds, 0 in the other",
    );
    let message = generated("kernel k(u, v) = if u > 2*v { u**2 } else { v };").unwrap_err();
    assert!(message.contains("at the seam u = 2*v of `k`: their difference is"), "{message}");
    assert!(message.contains("\nat u = 2*v, v = "), "{message}");
    let message = generated("kernel k(x, y) = if x**2 + y**2 < 1 { 1 - x } else { 0 };").unwrap_err();
    assert!(message.contains("differ at the seam x**2 + y**2 = 1"), "{message}");
    let message = generated("kernel k(x) = if abs(x) < 1 { x } else { 1 };").unwrap_err();
    assert!(message.contains("differ at the seam x = -1 of"), "{message}");
    let message = generated("kernel k(u, v) = if u - v > 1 { u - v } else { 0 };").unwrap_err();
    assert!(message.contains("\nat u = v + 1, v = 2: 1 in the branch"), "{message}");
    // switching to a series is a jump, however small
    let series = "kernel k(x) = if abs(x) > 1e-4 { sin(x)/x } else { 1 - x**2/6 };";
    assert!(generated(series).unwrap_err().contains("differ at the seam x = "));
}

#[test]
fn a_seam_that_cannot_be_decided_is_refused_too() {
    for text in [
        "kernel k(x) = if x != 0 { abs(x)/x } else { 1 };",
        "kernel k(x) = if x != 0 { x*(1/x) - abs(x)/x } else { 0 };",
        "kernel k(x) = if x != 0 { x*log(abs(x))/x } else { 0 };",
        "kernel k(x, y) = if x != 0 { x*y/(x*y + x**2) } else { 1 };",
        "kernel k(x) = if x != 0 { (1 - expint2(x))/x } else { 1 } where x >= 0;",
        "kernel k(x) = if x > 0 { 1 } else { sin(x)/x };",
    ] {
        let message = generated(text).unwrap_err();
        assert!(message.contains("of `k`: a branch is not defined there"), "{text}\n{message}");
    }
    let message = generated("kernel k(x) = if sin(x) > x/2 { cos(x) } else { x };").unwrap_err();
    assert!(
        message.starts_with("cannot decide whether the branches of `if sin(x) > x/2` agree at the seam"),
        "{message}"
    );
}

#[test]
fn a_removable_singularity_is_removed_by_the_limit() {
    for text in [
        "kernel k(x) = if x != 0 { sin(x)/x } else { 1 };",
        "kernel k(x) = if x > 0 { expm1(x)/x } else { 1 } where x >= 0;",
        "kernel k(x) = if x != 0 { (1 - cos(x))/x**2 } else { 1/2 };",
        "kernel k(x) = if x != 0 { (x - sin(x))/x**3 } else { 1/6 };",
        "kernel k(x) = if x != 0 { dilog(x)/x } else { 1 } where x < 1;",
        "kernel k(x) = if x != 1 { log(x)/(x - 1) } else { 1 } where x > 0;",
        "kernel k(x, y) = if x != y { (exp(x) - exp(y))/(x - y) } else { exp(x) };",
        "kernel k(x) = if x != 0 { x*tan(pi/2 + x) } else { -1 } where -1 < x < 1;",
        "kernel k(t, s) = if s != 0 { (1 - exp(-s*t))/s } else { t };",
        "kernel k(g, a) = if g != a { (g**3 - a**3)/(g - a) } else { 3*a**2 };",
    ] {
        is_accepted(text);
    }
    for (text, message) in [
        ("kernel k(x) = if x != 0 { sin(x)/x } else { 0 };", "their difference is 1\n"),
        ("kernel k(x) = if x != 0 { x*(1/x) } else { 0 };", "their difference is 1\n"),
        (
            "kernel k(x) = if x != 0 { x*tan(pi/2 + x) } else { 0 } where -1 < x < 1;",
            "their difference is -1\n",
        ),
        ("kernel k(t, s) = if s != 0 { (1 - exp(-s*t))/s } else { 1 };", "their difference is t - 1\n"),
    ] {
        let found = generated(text).unwrap_err();
        assert!(found.contains("differ at the seam") && found.contains(message), "{text}\n{found}");
    }
}

#[test]
fn a_kernel_is_computed_by_an_equal_form() {
    for text in [
        "kernel k(x) = (exp(x) - 1)/x by if x != 0 { expm1(x)/x } else { 1 } within 2;",
        "kernel k(t, s) = (1 - exp(-s*t))/s by if s > 0 { -expm1(-s*t)/s } else { t } where s >= 0, t > 0;",
        "kernel k(x, y) = (x**2 - y**2, x) by ((x - y)*(x + y), x);",
        "kernel k(x) = sqrt(x + 1) - sqrt(x) by 1/(sqrt(x + 1) + sqrt(x)) where x > 0;",
    ] {
        let found = generated(text).unwrap_or_else(|message| panic!("{text}\n{message}"));
        assert!(found.translation.is_proved() && found.written != found.optimised, "{text}");
    }
    let found =
        generated("kernel k(x) = (exp(x) - 1)/x by if x != 0 { expm1(x)/x } else { 1 };").expect("a kernel");
    assert_eq!(found.optimised.interpret(&[0.0]), [1.0]);
    assert!(found.written.interpret(&[0.0])[0].is_nan());
}

#[test]
fn a_form_that_is_not_proved_equal_is_refused() {
    is_refused(
        "kernel k(x) = sin(x) by 1 - x where x > 0;",
        "the stable form of `k` differs from its formula\n\
         at x = 1: the formula is 0.841470984807896506…, the form is 0",
    );
    let message =
        generated("kernel k(x) = (exp(x) - 1)/x by if x != 0 { expm1(x)/x } else { 2 };").unwrap_err();
    assert!(message.contains("differ at the seam x = 0"), "{message}");
    let message = generated("kernel k(x) = sqrt(x**2) by if x > 1 { x } else { x**2 };").unwrap_err();
    assert!(message.starts_with("the stable form of `k` differs from its formula"), "{message}");
    let undecided = "kernel k(x) = dilog(x) + dilog(-x) by dilog(x**2)/2 where 0 < x < 1;";
    let message = generated(undecided).unwrap_err();
    assert!(
        message.starts_with("cannot decide whether the stable form of `k` equals its formula"),
        "{message}"
    );
}

/// Forms with products and quotients of roots, where their product or quotient is the formula's radicand, and whether
/// the form has the value of the formula wherever that has one.
const ROOTS: [(&str, bool); 10] = [
    ("sqrt(x*y) by sqrt(x)*sqrt(y) where x >= 0, y >= 0", true),
    ("sqrt(x*y) by sqrt(x)*sqrt(y)", false),
    ("sqrt(x*y) by -sqrt(x)*sqrt(y) where x >= 0, y >= 0", false),
    ("sqrt(x)*sqrt(y) by sqrt(x*y)", true),
    ("sqrt(x/y) by sqrt(x)/sqrt(y) where x >= 0, y > 0", true),
    ("sqrt(x/y) by sqrt(x)/sqrt(y)", false),
    ("sqrt(1 - (1 - x*y)**2) by sqrt(x)*sqrt(y)*sqrt(2 - x*y) where 0 < x < 1, 0 < y < 1", true),
    ("sqrt(1 - (1 - x*y)**2) by sqrt(x)*sqrt(y)*sqrt(2 + x*y) where 0 < x < 1, 0 < y < 1", false),
    ("sqrt(cos(x)*cos(y) + 1) by hypot(sqrt(cos(x)*cos(y)), 1) where abs(x) <= pi/2, abs(y) <= pi/2", true),
    ("sqrt(cos(x)*cos(y) + 1) by hypot(sqrt(cos(x)*cos(y)), 1) where abs(x) <= pi/2, abs(y) <= pi", false),
];

#[test]
fn products_of_roots_are_forms_where_each_root_has_a_value() {
    for (form, holds) in ROOTS {
        let found = generated(&format!("kernel k(x, y) = {form};"));
        assert_eq!(found.is_ok(), holds, "{form}: {:?}", found.err());
    }
}

#[test]
fn the_derivatives_of_a_kernel_are_a_kernel() {
    let text =
        "kernel f(x, y) = (x*y**2, exp(x*y)) by (x*y*y, exp(y*x)) where x > 0; kernel g = grad(f; x, y);";
    let found = generated(text).expect("a kernel");
    assert!(found.translation.is_proved());
    let (x, y) = (0.5_f64, 2.0);
    let expected = [y * y, 2.0 * x * y, y * (x * y).exp(), x * (x * y).exp()];
    for (value, expected) in found.optimised.interpret(&[x, y]).into_iter().zip(expected) {
        assert!((value - expected).abs() <= 1e-15 * expected.abs(), "{value} {expected}");
    }
    assert!(found.optimised.interpret(&[-1.0, 2.0]).iter().all(|value| value.is_nan()));
    // the slopes of the pieces differ where they meet
    let message = generated("kernel f(x) = if x > 0 { x } else { 0 }; kernel g = grad(f; x);").unwrap_err();
    assert!(message.contains("differ at the seam x = 0 of `g`"), "{message}");
}

#[test]
fn a_jump_is_not_looked_at() {
    is_accepted("kernel k(u) = if jump u > 0 { u + 1 } else { 0 };");
    is_accepted("kernel k(x) = if jump x != 0 { sin(x)/x } else { 1 };");
    is_refused(
        "kernel k(u) = if jump u > 1 { 7 } else if u > 0 { 1 } else { 0 };",
        "the branches of `if u > 0` differ at the seam u = 0 of `k`: their difference is 1\n\
         at u = 0: 1 in the branch where the condition holds, 0 in the other",
    );
}

#[test]
fn a_seam_inside_a_name_is_a_seam_of_the_kernel() {
    let message = generated(
        "chart A(x); chart B(y); map f: A -> B = (x**2,); \
         let step = if y > 4 { 1 } else { 0 }; kernel k(x) = pullback(f, step);",
    );
    assert!(message.unwrap_err().contains("differ at the seam x**2 = 4 of `k`"));
}

/// Returns "term(x0) + term(x1) + … + term(x39)" and the names "x0, x1, …, x39".
fn sum_of_forty(term: impl Fn(&str) -> String) -> (String, String) {
    let names: Vec<String> = (0..40).map(|n| format!("x{n}")).collect();
    let terms: Vec<String> = names.iter().map(|name| term(name)).collect();
    (terms.join(" + "), names.join(", "))
}

#[test]
fn programs_of_many_choices_are_proved_without_a_case_for_each() {
    let (positive_parts, names) = sum_of_forty(|x| format!("(if {x} > 0 {{ {x} }} else {{ 0 }})"));
    let text = format!("kernel k({names}) = ({positive_parts})**3*({}) + 1;", names.replace(", ", " + "));
    let translation = generated(&text).expect("every seam agrees").translation;
    assert!(translation.is_proved(), "{translation}");
}

#[test]
fn many_pieces_end_in_a_bound_and_not_in_a_long_search() {
    let (positive_parts, names) = sum_of_forty(|x| format!("(if {x} > 0 {{ {x} }} else {{ 0 }})"));
    let (halves, _) = sum_of_forty(|x| format!("({x} + abs({x}))/2"));
    is_refused(
        &format!("kernel k({names}) = {halves} by {positive_parts};"),
        "cannot decide whether the stable form of `k` equals its formula: it has more than 64 pieces",
    );
}

#[test]
fn kernels_inside_the_class_are_proved_to_compute_their_formulas() {
    for text in [
        "kernel k(x) = x**7 + 3*x**5 + x;",
        "kernel k(x, y) = (x + y)**2/sqrt(x**2 + y**2)**3 + x/sqrt(x**2 + y**2);",
        "kernel k(x, y) = (x/(x + y), y/(x + y), x*y/(x + y)**2) where x + y > 0;",
        "kernel k(u) = if u > 0 { u*u + u*u*u } else { 0 };",
        "kernel k(u, v) = if 2*u - 2*v > 0 { (u - v)*(u - v)*3 } else { 0 } where u*u + 2*u*v + v*v < 9;",
        "kernel k(x, y, z) = atan2(sqrt(x*x + y*y), z)*(x*x + y*y)/(2*pi);",
        "kernel k(g, c) = (1 - g**2)/(4*pi*(1 + g**2 - 2*g*c)**(3/2));",
    ] {
        let translation = generated(text).expect("a kernel").translation;
        assert!(translation.is_proved(), "{text}: {translation}");
    }
}

#[test]
fn powers_of_sums_need_not_be_multiplied_out_to_prove_a_program() {
    let text = "kernel k(x, y, z, s, t) = (1 + x + y + z + s + t)**30*x + (1 + x + y + z + s + t)**30*y
        + (1 + x - y + z - s + t)**30;";
    let translation = generated(text).expect("a kernel").translation;
    assert!(translation.is_proved(), "{translation}");
}

#[test]
fn seams_are_limited() {
    let choice = |i: u32| format!("(if u > {i} {{ u - {i} }} else {{ 0 }})");
    let kernel =
        |count: u32| format!("kernel k(u) = {};", (1..=count).map(choice).collect::<Vec<_>>().join(" + "));
    is_accepted(&kernel(60));
    is_refused(&kernel(257), "`k` has more than 256 seams");
}

#[test]
fn an_integral_that_is_known_on_a_part_of_the_domain_asks_for_that_part() {
    let chart = "chart S(s);\nparam p;";
    for (text, condition) in [
        ("kernel k(u) = integral(cos(u*s), s = 0..1);", "u != 0"),
        ("kernel k(u) = integral(cos(u*s), s = 0..1) by sin(u)/u;", "u != 0"),
        ("kernel k(u) = u by u + 0*integral(cos(u*s), s = 0..1);", "u != 0"),
        ("let f = integral(cos(p*s), s = 0..1);\nkernel k(p) = f;", "p != 0"),
        ("let f = integral(cos(p*s), s = 0..1);\nlet g = 2*f + 1;\nkernel k(p) = g;", "p != 0"),
        (
            "chart T(t);\nchart X(x);\nmap F: T -> X = (integral(cos(t*s), s = 0..1));\nkernel k(t) = pullback(F, x);",
            "t != 0",
        ),
    ] {
        let (_, errors) = read_theory(&format!("{chart}\n{text}"));
        let messages: Vec<&str> = errors.iter().map(|error| error.message.as_str()).collect();
        assert_eq!(
            messages,
            [format!("the value of an integral in `k` is known only where `{condition}`")],
            "{text}"
        );
        let with_condition = format!("{chart}\n{} where {condition};", text.trim_end_matches(';'));
        is_accepted(&with_condition);
    }
    // a division of the kernel itself is no reason to refuse it: the formula is undefined there as
    // well
    for text in [
        "let f = integral(cos(p*s), s = 0..1);\nkernel k(p) = sin(p)/p;",
        "kernel k(u) = integral(u*s, s = 0..1);",
    ] {
        is_accepted(&format!("{chart}\n{text}"));
    }
}

#[test]
fn a_form_has_the_value_of_atan2_on_its_cut() {
    is_refused(
        "kernel k(u, v) = atan2(u, v) by 2*atan(u/(sqrt(u*u + v*v) + v));",
        "the stable form of `k` is undefined at a point where its formula has a value\n\
         at u = 0, v = -1: the formula is \
         3.141592653589793238…, the form has no value: `u/(sqrt(u*u + v*v) + v)` is not defined",
    );
    is_accepted("kernel k(u, v) = atan2(u, v) by 2*atan(u/(sqrt(u*u + v*v) + v)) where v > 0;");
    is_accepted("kernel k(u, v) = atan2(u, v)/2 by atan2(2*u, 2*v)/2;");
}
