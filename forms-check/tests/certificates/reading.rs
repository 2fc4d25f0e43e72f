//! The checker reads every source and certificate that the prover reads and writes.

use crate::support::{certificate, checked};
use forms_check::Outcome;
use forms_core::certificate::{HEADER, file_lines};
use forms_core::check::read_theory;
use std::path::Path;

/// Every function of one argument, whether the checker knows it or not.
const FUNCTIONS: [&str; 27] = [
    "sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh", "abs",
    "clausen", "dilog", "erf", "expm1", "log1p", "expint1", "expint2", "expint3", "cbrt", "erfc", "sec",
    "csc", "cot", "-",
];

fn sources_in(folder: &Path, found: &mut Vec<(String, String)>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() && path.file_name().is_none_or(|name| name != "target") {
            sources_in(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "forms") {
            found.push((path.display().to_string(), std::fs::read_to_string(&path).expect("a source")));
        }
    }
}

#[test]
fn every_file_of_the_repository_can_be_read() {
    let mut sources = Vec::new();
    for folder in ["tests", "forms-kernels/theory", "forms-book", "docs", "examples"] {
        sources_in(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(folder), &mut sources);
    }
    assert!(sources.len() > 50, "{} files", sources.len());
    for (name, source) in sources {
        let read = checked(&(HEADER.to_string() + &file_lines("it.forms", &source)), &source);
        // the checker is allowed to refuse a source that the prover refuses
        assert!(read.is_ok() || !read_theory(&source).1.is_empty(), "{name}: {read:?}");
    }
}

/// Returns sources in which a function is applied to an argument wherever the language allows it.
fn sources_with(function: &str) -> Vec<String> {
    let f = |a: &str| format!("{function}({a})");
    vec![
        format!("param n where n != {}; chart L(x); prove p: n*x == x*n; refute q: n == n + 1;", f("n")),
        format!("chart L(x, y) where {} < 2; prove p: x*y == y*x; refute q: x == x + y;", f("x/3")),
        format!("chart L(x); fn f(x) where f > {}; prove p: f == f; refute q: f == f + 1;", f("x/3")),
        format!(
            "chart L(x); let v = {}; form w = v*dx; field X = v*@x; prove p: d(w) == 0; refute q: v == v + 1;",
            f("x")
        ),
        format!(
            "chart L(x); map m: L -> L = ({}); prove p: pullback(m, x) == {}; prove r: x == x;",
            f("x"),
            f("x")
        ),
        format!(
            "chart L(x); metric g = (1 + {}**2)*dx**2; prove p: norm[g](@x)**2 == 1 + {}**2;",
            f("x"),
            f("x")
        ),
        format!(
            "chart L(x); prove p: diff({}, x) == diff({} + 1, x); refute q: {} == {} + x;",
            f("x"),
            f("x"),
            f("x"),
            f("2*x")
        ),
        format!(
            "chart L(x); prove p: integral({}, x = 0..1) == integral({}, x = 0..1); prove q: x == x;",
            f("x"),
            f("x")
        ),
        format!("chart L(x); prove p: abs({})*x == x*abs({}) where {} > 0, x > 0;", f("x"), f("x"), f("x")),
        format!(
            "chart L(x); prove p: {}**(1/2)*{}**(1/2) == {} where {} > 0;",
            f("x"),
            f("x"),
            f("x"),
            f("x")
        ),
        format!(
            "chart L(x); kernel k(x) = if x > 0 {{ {} }} else {{ {} }} jump; prove p: x == x;",
            f("x"),
            f("-x")
        ),
        format!(
            "chart L(x); warp s(; u) = ({}) onto L density 1 of dx inverse (x); prove p: x == x;",
            f("u")
        ),
    ]
}

#[test]
fn what_is_written_about_any_function_can_be_read() {
    let (mut written, mut accepted) = (0, 0);
    for source in FUNCTIONS.iter().flat_map(|function| sources_with(function)) {
        if !read_theory(&source).1.is_empty() {
            continue;
        }
        let lines = certificate(&source);
        let all = checked(&lines, &source).unwrap_or_else(|why| panic!("{why}\n{source}\n{lines}"));
        written += all.len();
        accepted += all.iter().filter(|one| one.outcome == Outcome::Accepted).count();
    }
    assert!(written > 300 && 2 * accepted > written, "{accepted} of {written}");
}

#[test]
fn what_the_checker_does_not_know_is_an_obstacle_to_what_uses_it_alone() {
    let source =
        "param n where n != clausen(n); param m; chart L(x); prove p: n*x == x*n; prove q: m*x == x*m;";
    let all = checked(&certificate(source), source).expect("a certificate that can be read");
    let outcomes: Vec<bool> = all.iter().map(|one| one.outcome == Outcome::Accepted).collect();
    assert_eq!(outcomes, [false, true], "{all:?}");
}
