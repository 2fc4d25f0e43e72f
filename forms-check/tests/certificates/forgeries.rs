//! Certificates written by an adversary who knows the checker: none is accepted.

use crate::support::checked;
use forms_check::Outcome;
use forms_core::certificate::{HEADER, file_lines};

/// Source with one claim `p`, and the lines of a certificate about it.
type Forgery = (&'static str, &'static str);

/// Whether any entry is accepted.
fn is_taken((source, lines): &Forgery) -> bool {
    let lines = HEADER.to_string() + &file_lines("it.forms", source) + lines;
    checked(&lines, source).is_ok_and(|all| all.iter().any(|one| one.outcome == Outcome::Accepted))
}

fn assert_none_is_taken(forgeries: &[Forgery]) {
    let taken: Vec<&Forgery> = forgeries.iter().filter(|forgery| is_taken(forgery)).collect();
    assert!(taken.is_empty(), "{taken:#?}");
}

#[test]
fn an_expression_is_used_only_where_it_is_defined() {
    assert_none_is_taken(&[
        ("chart L(x); prove p: abs(x) == x;", "proved p\nbase x\npositive sqrt(x)**2\nzero\n"),
        ("chart L(x); prove p: abs(x) == x;", "proved p\nbase x\npositive sqrt(x)*sqrt(x)\nzero\n"),
        ("chart L(x); prove p: abs(x) == x;", "proved p\nbase x\npositive x**(1/3)*x**(2/3)\nzero\n"),
        ("chart L(x); prove p: abs(x) == x;", "proved p\nbase x\npositive exp(log(x))\nzero\n"),
        ("chart L(x); prove p: abs(x) == x;", "proved p\nbase x\npositive sqrt(x**3)**2/x**2\nzero\n"),
        ("chart L(x); prove p: abs(x) == -x;", "proved p\nbase x\nnegative sqrt(-x)**2\nzero\n"),
        ("chart L(x); prove p: abs(x) == x;", "proved p\nbase sqrt(x)**2\npositive sqrt(x)**2\nzero\n"),
        ("chart L(x); prove p: abs(x) == x;", "proved p\nbase x\npositive sin(asin(sqrt(x)))**2\nzero\n"),
        (
            "chart L(x) where x > 0; prove p: x == x + 1;",
            "proved p\nbase x\nnegative sqrt(-x)**2\nsplit 1\nend\n",
        ),
        // the product with y is not negative, and y vanishes at every point of the statement
        (
            "chart L(x, y); prove p: abs(x) == x where x*y >= 0, y >= 0, -y >= 0;",
            "proved p\nbase x\npositive x*y/y\nzero\n",
        ),
        (
            "chart L(x, y); prove p: abs(x) == x where x*y >= 0, y >= 0;",
            "proved p\nbase x\npositive x*y/y\nzero\n",
        ),
        (
            "chart L(x, y); prove p: abs(x) == x where x*y**2 >= 0;",
            "proved p\nbase x\npositive x*y**2/y**2\nzero\n",
        ),
        (
            "chart L(x, y); prove p: abs(x) == x where x*sin(y) >= 0, sin(y) >= 0;",
            "proved p\ncircle y\nbase x\npositive x*sin(y)/sin(y)\nzero\n",
        ),
        // a function that is declared for positive arguments only
        (
            "chart L(x); fn f(x) where x > 0; prove p: abs(x) == x;",
            "proved p\nbase x\npositive x + 0*f\nzero\n",
        ),
    ]);
}

#[test]
fn a_sign_is_shown_of_the_base_and_a_number_is_taken_whole() {
    let magnitude = "chart L(x); prove p: abs(x) == x;";
    assert_none_is_taken(&[
        (magnitude, "proved p\nbase x\nzero\n"),
        (magnitude, "proved p\nbase x\npositive x**2\nzero\n"),
        (magnitude, "proved p\nbase x\npositive x\nzero\n"),
        (magnitude, "proved p\nbase x\npositive x + exp(x)\nzero\n"),
        (magnitude, "proved p\nbase x\npositive x*1\nzero\n"),
        (magnitude, "proved p\nbase x\npositive (x**3)/(x**2)\nzero\n"),
        ("chart L(x); prove p: sqrt(3) == 1;", "proved p\nzero\n"),
        ("chart L(x); prove p: sqrt(12) == 2;", "proved p\nbase 2\nzero\n"),
        ("chart L(x); prove p: log(3) == 0;", "proved p\nzero\n"),
        ("chart L(x); prove p: sin(x/2) == sin(x);", "proved p\ncircle x\nzero\n"),
        ("chart L(x); prove p: exp(x/2) == exp(x);", "proved p\nexponent x\nzero\n"),
        (
            "chart L(x); prove p: log(x**2) == 2*log(x) + log(-x) - log(-x);",
            "proved p\nbase x\nlogarithm\nzero\n",
        ),
        (
            "chart L(x); prove p: sqrt(x**2 + 1) == x + 1;",
            "proved p\nbase x**2 + 2*x + 1\npositive (x + 1)**2\nzero\n",
        ),
    ]);
}

#[test]
fn a_root_has_the_order_it_was_declared_with() {
    let powers = "chart L(x) where x > 0; prove p: x**(1/3) == x**(1/2);";
    let cube = "chart L(x) where x > 0; prove p: x**(1/3) == x;";
    assert_none_is_taken(&[
        (powers, "proved p\nbase x\nroot 2\npositive sqrt(x)**2\nroot 3\nzero\n"),
        (powers, "proved p\nbase x\nroot 2\npositive sqrt(x)**2\nroot 6\nzero\n"),
        (cube, "proved p\nbase x\nroot 2\npositive sqrt(x)**2\nroot 6\nzero\n"),
        (powers, "proved p\nbase x\nroot 2\npositive x\nbase sqrt(x)\nroot 3\npositive sqrt(x)\nzero\n"),
        (
            "chart L(x) where x > 0; prove p: x**(1/3)*exp(x**(1/6)) == x*exp(x**(1/6));",
            "proved p\nbase x\nroot 2\npositive x\nexponent sqrt(x)\nroot 6\nzero\n",
        ),
        (powers, "proved p\nbase x\nroot 1\npositive x\nzero\n"),
        (powers, "proved p\nbase x\nroot 0\npositive x\nzero\n"),
        (powers, "proved p\nbase x\nroot -6\npositive x\nzero\n"),
        (
            "chart L(x) where x > 0; prove p: x**(1/3)*cos(sqrt(x)) == x*cos(sqrt(x));",
            "proved p\nbase x\nroot 2\npositive x\ncircle sqrt(x)\nroot 6\nzero\n",
        ),
        (powers, "proved p\nbase x\nroot 18446744073709551616\npositive x\nzero\n"),
        (powers, "proved p\nbase x\nroot 256\npositive x\nzero\n"),
        ("chart L(x); prove p: sqrt(4) == 4;", "proved p\nbase 4\nroot 2\nbase 2\nroot 4\nzero\n"),
        ("chart L(x); prove p: sqrt(2) == 2;", "proved p\nbase 2\nroot 2\nroot 1\nzero\n"),
        ("chart L(x); prove p: sqrt(8) == 2;", "proved p\nbase 2\nroot 2\nzero\n"),
        ("chart L(x); prove p: sqrt(2) == sqrt(3);", "proved p\nbase 6\nroot 2\nzero\n"),
    ]);
}

#[test]
fn numbers_at_the_edge_of_their_types_do_not_wrap() {
    let overflow = "chart L(x, y, z); prove p: (1/(x - y**60 + z)*(1/(x + y**60 + z))\
        *(1/((x+z)**2 + (x+z)*y**60 + y**120)))*((x+z)**6 - y**104) == (x+z)**2 - (x+z)*y**60 + y**120;";
    assert_none_is_taken(&[
        (overflow, "proved p\nzero\n"),
        ("chart L(x); prove p: x**100*x**100*x**56 == 1;", "proved p\nzero\n"),
        ("chart L(x); prove p: x**100*x**100*x**57 == x;", "proved p\nzero\n"),
        ("chart L(x); prove p: x**120/x**-120/x**-16 == 1;", "proved p\nzero\n"),
        ("chart L(x); prove p: x**256 == 1;", "proved p\nzero\n"),
        (
            "chart L(x) where x > 0; prove p: x**(1/256) == 1;",
            "proved p\nbase x\nroot 256\npositive x\nzero\n",
        ),
        ("chart L(x) where x > 0; prove p: (x + 1)**(1/255)*(x + 1)**120 == 1;", "proved p\nzero\n"),
        ("chart L(x); prove p: sin(256*x) == sin(0*x);", "proved p\ncircle x\nzero\n"),
        ("chart L(x); prove p: exp(256*x) == 1;", "proved p\nexponent x\nzero\n"),
        ("chart L(x); prove p: exp(18446744073709551616*x) == 1;", "proved p\nexponent x\nzero\n"),
        ("chart L(x); prove p: cos(pi*18446744073709551617) == 1;", "proved p\nzero\n"),
        ("chart L(x); prove p: cos(pi/18446744073709551616) == 1;", "proved p\nzero\n"),
        ("chart L(x); prove p: x**1048576 == 1;", "proved p\nzero\n"),
        ("chart L(x); prove p: x**1048577 == x;", "proved p\nzero\n"),
    ]);
}

#[test]
fn every_point_lies_in_a_case() {
    let magnitude = "chart L(x); prove p: abs(x) == x;";
    let strict = "chart L(x, y); prove p: abs(x) == x where x*y > 0;";
    assert_none_is_taken(&[
        (magnitude, "proved p\nbase x\nsplit 1\ncase +\nbase x\npositive x\nzero\nend\n"),
        (magnitude, "proved p\nbase x**2\nsplit 1\ncase +\nbase x\npositive x\nzero\nend\n"),
        (magnitude, "proved p\nbase x\nsplit 1\nend\n"),
        (magnitude, "proved p\nbase x\nbase -x\nsplit 1 2\ncase ++\nbase x\npositive x\nzero\nend\n"),
        (
            magnitude,
            "proved p\nbase x\nsplit 1 1\ncase ++\nbase x\npositive x\nzero\ncase +-\nbase x\npositive x\nzero\nend\n",
        ),
        (magnitude, "proved p\nbase x\nsplit 1\ncase +\nbase x\npositive x\nzero\ncase -\nundefined\nend\n"),
        (magnitude, "proved p\nbase x\nsplit 1\ncase \nzero\nend\n"),
        (magnitude, "proved p\nbase x\nsplit 1\ncase *\nbase x\npositive x\nzero\nend\n"),
        (strict, "proved p\nbase y\nbase x\nsplit 1\ncase +\nbase x\npositive x*y/y\nzero\nend\n"),
        (strict, "proved p\nbase y\nbase x\nsplit 1 2\ncase ++\nbase x\npositive x\nzero\nend\n"),
        // closed conditions hold where the base vanishes
        (
            "chart L(x, y); prove p: abs(y) == y where x*y >= 0, x >= 0;",
            "proved p\nbase x\nbase y\nsplit 1 2\ncase ++\nbase y\npositive y\nzero\nend\n",
        ),
    ]);
}

#[test]
fn a_half_angle_leaves_out_only_limits_of_other_points() {
    assert_none_is_taken(&[
        // false at x = pi, y = 1
        (
            "chart L(x, y); prove p: abs(y) == -y where (1 + cos(x))*y <= 0;",
            "proved p\ntangent x\nbase y\nnegative -y\nzero\n",
        ),
        (
            "chart L(x, y); prove p: abs(y)*(2 + cos(x)) == -y*(2 + cos(x)) where (1 + cos(x))*y <= 0;",
            "proved p\ntangent x\nbase y\nnegative -(1 + cos(x))*y*(1 + tan(x/2)**2)/2\nzero\n",
        ),
        (
            "chart L(x, y); prove p: abs(y)*(2 + cos(x)) == -y*(2 + cos(x)) where sqrt(-(1 + cos(x))*y) > -1;",
            "proved p\ntangent x\nbase y\nnegative sqrt(-(1 + cos(x))*y)**2*(1 + tan(x/2)**2)/2\nzero\n",
        ),
        // only odd multiples of pi
        (
            "chart L(x); prove p: cos(x) == 2 + sin(x) where 1 + cos(x) <= 0;",
            "proved p\ntangent x\nbase 1 + tan(x/2)**2\nsplit 1\nend\n",
        ),
        // the variables of the unit cannot be perturbed
        (
            "chart L(x, y); fn f(y); prove p: abs(y)*(2 + cos(f)) == y*(2 + cos(f)) where (1 + cos(f))*y >= 0;",
            "proved p\ntangent f\nbase y\npositive (1 + cos(f))*y*(1 + tan(f/2)**2)/2\nzero\n",
        ),
        ("chart L(x); prove p: cos(pi) == sin(pi);", "proved p\ntangent pi\nzero\n"),
    ]);
}

#[test]
fn no_theorem_speaks_of_no_point() {
    assert_none_is_taken(&[
        ("chart L(x, y); prove p: x/(y - y) == 1;", "proved p\nundefined\n"),
        ("chart L(x); prove p: x == x + 1 where x > 0, x < 0;", "proved p\nbase x\nsplit 1\nend\n"),
        ("chart L(x); prove p: x == x where x > 0, x < 0;", "proved p\nzero\n"),
        ("chart L(x); prove p: log(-x**2) == 5;", "proved p\nundefined\n"),
        ("chart L(x); prove p: sqrt(-1 - x**2) == sqrt(-1 - x**2);", "proved p\nzero\n"),
        ("chart L(x); prove p: x == x where x > 0, x < 0;", "proved p\nat x = 1\nzero\n"),
        ("chart L(x); prove p: 1/(x - x) == 1/(x - x);", "proved p\nat x = 1\nzero\n"),
        ("chart L(x); prove p: (-8)**(1/3) == -2;", "proved p\nzero\n"),
    ]);
}

#[test]
fn an_integral_is_not_taken_across_what_its_antiderivative_loses() {
    // the entry names the byte at which the variable of each range begins
    let entry = |source: &str, offer: &str| {
        let place = source.find(" x = ").or_else(|| source.find(" y = ")).expect("a range") + 1;
        let lines = format!("integral {place} {offer}\nproved p\nzero\n");
        is_taken(&(Box::leak(source.to_string().into_boxed_str()), Box::leak(lines.into_boxed_str())))
    };
    for (source, offer) in [
        ("chart L(x); prove p: integral(1/x**2, x = -1..1) == -2;", "-1/x\nzero"),
        ("chart L(x); prove p: integral(0*x, x = -1..1) == 2;", "abs(x)/x\nbase x\nzero"),
        ("chart L(x); prove p: integral(0*x, x = -1..1) == pi;", "atan(x) + atan(1/x)\nzero"),
        ("chart L(x); prove p: integral(1 + tan(x)**2, x = 0..pi) == 0;", "tan(x)\nzero"),
        ("chart L(x); prove p: integral(sqrt(x)*sqrt(x), x = -1..1) == 0;", "x**2/2\nzero"),
        ("chart L(x); prove p: integral(x/x, x = 0..0*x) == 1;", "x\nzero"),
        ("chart L(x); prove p: integral((abs(x) - x)/(abs(x) - x), x = 1..2) == 1;", "x\nzero"),
        ("chart L(x); prove p: integral(1, x = 0..1) == 17;", "17*x + 1/(x - x)\nundefined"),
        (
            "chart L(x); prove p: integral(1, x = 0..1) == 17;",
            "17*x\nbase x\nnegative sqrt(-x)**2\nsplit 1\nend",
        ),
        // the value is valid at x = 0, but not in a neighbourhood
        (
            "chart L(x, y); prove p: diff(integral(x, y = 0..1), x) == -1 where sqrt(x) + sqrt(-x) + 1 > 0;",
            "-abs(x)*y\nbase x\nnegative sqrt(-x)**2\nzero",
        ),
        // the variable of the half angle cannot be perturbed
        ("chart L(x, y); prove p: integral(0*x, x = 0..1) == 1;", "x*(1 + cos(y))\ntangent y\nzero"),
    ] {
        assert!(!entry(source, offer), "{source} {offer}");
    }
}

#[test]
fn the_value_of_an_integral_holds_all_around_the_points_it_is_used_at() {
    // the condition leaves only x = 0, where x can be replaced by −|x| and −|x| by −x
    let source = "chart L(x, y, z); prove p: diff(integral(integral(x, y = 0..1), z = 0..1), x) == -1 \
        where sqrt(x) + sqrt(-x) + 1 > 0;";
    let place = |range: &str| source.find(range).expect("a range");
    let lines = format!(
        "integral {} -abs(x)*y\nbase x\nnegative sqrt(-x)**2\nzero\n\
         integral {} -x*z\nbase x\npositive sqrt(x)**2\nzero\nproved p\nzero\n",
        place("y = "),
        place("z = ")
    );
    let lines = HEADER.to_string() + &file_lines("it.forms", source) + &lines;
    let all = checked(&lines, source).expect("a certificate that can be read");
    assert_ne!(all[0].outcome, Outcome::Accepted);
}

#[test]
fn a_refutation_is_a_point_of_the_statement() {
    let same = "chart L(x); fn f(x); prove p: f(1) == f(1 + 1e60*(sqrt(2)**2 - 2));";
    assert_none_is_taken(&[
        // places whose enclosures are too wide to distinguish them
        (same, "refuted p\nat f(0) = 0\nat f(1) = 5\ncomponent\nleft 5\nright 0\n"),
        (same, "refuted p\nat f(1) = 5\nat f(1 + 1e-11) = 0\ncomponent\nleft 5\nright 0\n"),
        (
            "chart L(x); fn f(x); prove p: f(2*x) == f(x + x);",
            "refuted p\nat x = 1\nat f(2) = 1\nat f(2 + 1e-13) = 2\ncomponent\nleft 1\nright 2\n",
        ),
        (
            "chart L(x); prove p: sqrt(x**2) == x where x > 0;",
            "refuted p\nat x = -1\ncomponent\nleft 1\nright -1\n",
        ),
        ("chart L(x); prove p: log(x)*0 == 0;", "refuted p\nat x = 1\ncomponent\nleft 0\nright 1\n"),
        ("chart L(x); prove p: x/x == 1;", "refuted p\nat x = 0\ncomponent\nleft 0\nright 1\n"),
        ("chart L(x); prove p: x == x;", "refuted p\nat x = 0\nat x = 1\ncomponent\nleft 0\nright 1\n"),
        ("chart L(x); prove p: x == x;", "refuted p\nat x = 0\ncomponent dx\nleft 0\nright 1\n"),
        ("chart L(x); prove p: sin(pi) == 0;", "refuted p\ncomponent\nleft 1e-40\nright 0\n"),
        (
            "chart L(x); prove p: x**(1/3)*x**(2/3) == x;",
            "refuted p\nat x = -1\ncomponent\nleft 1\nright -1\n",
        ),
        (
            "chart L(x, y); prove p: atan2(y, x) == atan2(y, x);",
            "refuted p\nat x = -1\nat y = 0\ncomponent\nleft 3\nright -3\n",
        ),
        // a chart whose domain the checker does not read still constrains its coordinates
        (
            "chart L(x) where x > 0 or x > 1; prove p: abs(x) == x;",
            "refuted p\nat x = -1\ncomponent\nleft 1\nright -1\n",
        ),
        (
            "param n where n > 0, n != clausen(n); chart L(x); prove p: abs(n) == n;",
            "refuted p\nat n = -1\ncomponent\nleft 1\nright -1\n",
        ),
    ]);
}

#[test]
fn a_name_means_one_thing() {
    assert_none_is_taken(&[
        ("chart L(x); prove p: 1 == 2; prove p: x == x;", "proved p\nzero\n"),
        ("chart L(x); let x = 1; prove p: x == 1;", "proved p\nzero\n"),
        ("chart L(x); let a = 1; let a = 2; prove p: a == 2;", "proved p\nzero\n"),
        ("chart L(x); let dx = 0; prove p: d(x) == 0;", "proved p\nzero\n"),
        ("let dx = 0; chart L(x); prove p: x == x;", "proved p\nzero\n"),
        ("chart L(x); fn sin(x); prove p: x == x;", "proved p\nzero\n"),
        ("chart L(x); let pi = 3; prove p: pi == pi;", "proved p\nzero\n"),
        ("chart L(x); let a = a; prove p: x == x;", "proved p\nzero\n"),
        ("param x; chart L(x); prove p: d(x) == 0;", "proved p\nzero\n"),
        ("chart L(x); prove p: dx == 0*x;", "proved p\nzero\n"),
        ("chart L(x, y); prove p: dx + dx^dy == dx + dx^dy;", "proved p\nzero\n"),
        ("chart L(x); prove p: x == x; prove q: x == x;", "proved p\nzero\nproved p\nzero\n"),
    ]);
}

#[test]
fn an_exponent_that_is_a_number_asks_no_more_than_a_number() {
    let source = |exponent: &str| {
        let text = format!("chart L(x, y); prove p: abs(x)*x**{exponent} == x*x**{exponent};");
        &*Box::leak(text.into_boxed_str())
    };
    let forged =
        ["2**2", "(y - y + 2)", "(2*cos(0))", "sqrt(4)", "(2*y/y)", "(2*sin(pi/2))", "abs(2)", "(3 - 1**2)"];
    let lines = ["proved p\nbase x\npositive x\nzero\n", "proved p\nbase x\npositive x\nexponent y\nzero\n"];
    for exponent in forged {
        assert_none_is_taken(&lines.map(|lines| (source(exponent), lines)));
    }
}

#[test]
fn a_condition_that_is_zero_ends_the_search_for_factors() {
    assert_none_is_taken(&[(
        "chart L(x, y); prove p: abs(x)*exp(y) == x*exp(y) where x - x >= 0;",
        "proved p\nexponent y\nbase x\nsplit 1\ncase +\nexponent y\nbase x\npositive x\nzero\nend\n",
    )]);
}

#[test]
fn depth_and_length_are_refused_and_no_panic() {
    let nested = |open: &str, close: &str, n: usize| format!("{}x{}", open.repeat(n), close.repeat(n));
    for text in [
        nested("(", ")", 100_000),
        nested("-", "", 100_000),
        nested("sin(", ")", 50_000),
        nested("sqrt(x+", ")", 5_000),
        format!("x{}", "**2".repeat(5_000)),
        format!("x{}", "*x".repeat(100_000)),
        "9".repeat(9_000),
        "1e9999*1e9999*1e9999".to_string(),
    ] {
        let source = format!("chart L(x); prove p: {text} == x + 1;");
        let lines = HEADER.to_string() + &file_lines("it.forms", &source);
        let _ =
            checked(&(lines.clone() + &format!("proved p\nbase {text}\npositive {text}\nzero\n")), &source);
        let all = checked(&(lines + "proved p\nzero\n"), &source);
        assert!(!all.is_ok_and(|all| all.iter().any(|one| one.outcome == Outcome::Accepted)));
    }
    // hundreds of coordinates, more generators than any proof needs
    let names: Vec<String> = (0..300).map(|k| format!("x{k}")).collect();
    let source = format!("chart L({}); prove p: x0 == x1;", names.join(", "));
    let lines = HEADER.to_string() + &file_lines("it.forms", &source) + "proved p\nzero\n";
    let all = checked(&lines, &source).expect("a file that can be read");
    assert!(all.iter().all(|one| one.outcome != Outcome::Accepted));
}
