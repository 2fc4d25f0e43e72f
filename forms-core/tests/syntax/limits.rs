//! Every limit gives an error that names it, one step beyond the allowed value, on the 2 MiB stack
//! of a test's thread.

use forms_core::syntax::{MAXIMUM_DEPTH, MAXIMUM_NESTING, MAXIMUM_TOKENS, lex, read};

/// Returns the messages about a text.
fn messages(text: &str) -> Vec<String> {
    read(text).1.into_iter().map(|diagnostic| diagnostic.message).collect()
}

/// Returns `let a = ((( … x … )));`, nested `levels` deep.
fn nested(levels: usize, open: &str, inner: &str, close: &str) -> String {
    format!("let a = {}{inner}{};", open.repeat(levels), close.repeat(levels))
}

#[test]
fn nesting_is_limited_in_each_of_its_shapes() {
    let shapes = [
        ("brackets", "(", "x", ")"),
        ("calls", "f(", "x", ")"),
        ("indices", "X[", "x", "]"),
        ("indexed calls", "d[", "x", "](x)"),
        ("bounds", "integral(x, u = 0..", "x", ")"),
        ("signs", "-", "x", ""),
        ("powers", "x**", "x", ""),
        ("branches", "if x > 0 {", "x", "} else {0}"),
        ("conditions", "if 0 < ", "x", " {1} else {0}"),
    ];
    let expected = format!("the expression is nested more than {MAXIMUM_NESTING} levels deep");
    for (name, open, inner, close) in shapes {
        assert_eq!(messages(&nested(MAXIMUM_NESTING / 2 - 1, open, inner, close)), [""; 0], "{name}");
        assert_eq!(messages(&nested(MAXIMUM_NESTING, open, inner, close)), [expected.as_str()], "{name}");
        assert_eq!(messages(&nested(50_000, open, inner, close)), [expected.as_str()], "{name}");
    }
}

#[test]
fn a_ladder_of_else_if_is_limited() {
    let ladder = |rungs: usize| format!("kernel f(x) = {}{{ x }};", "if x > 0 { 1 } else ".repeat(rungs));
    let expected = format!("the expression is nested more than {MAXIMUM_NESTING} levels deep");
    assert_eq!(messages(&ladder(MAXIMUM_NESTING - 2)), [""; 0]);
    assert_eq!(messages(&ladder(50_000)), [expected]);
}

#[test]
fn chains_of_operators_are_limited() {
    let expected = format!("the expression is nested more than {MAXIMUM_DEPTH} operations deep");
    for operator in ["+", "-", "*", "/", "^"] {
        let chain = |operators: usize| format!("let a = x{};", format!("{operator}x").repeat(operators));
        assert_eq!(messages(&chain(MAXIMUM_DEPTH - 1)), [""; 0], "{operator}");
        assert_eq!(messages(&chain(MAXIMUM_DEPTH)), [expected.as_str()], "{operator}");
        assert_eq!(messages(&chain(100_000)), [expected.as_str()], "{operator}");
    }
    let indices = format!("let a = x{};", "[x]".repeat(MAXIMUM_DEPTH));
    assert_eq!(messages(&indices), [expected]);
}

#[test]
fn the_highest_tree_is_the_sum_of_its_chains() {
    let half = "+x".repeat(MAXIMUM_DEPTH / 2);
    let expected = format!("the expression is nested more than {MAXIMUM_DEPTH} operations deep");
    assert_eq!(messages(&format!("let a = (x{half}){half};")), [expected]);
    assert_eq!(messages(&format!("let a = (x{half})*(x{half});")), [""; 0]);
}

#[test]
fn the_tokens_of_a_source_are_limited() {
    let text = "x ".repeat(MAXIMUM_TOKENS + 1);
    let expected = format!("a source has at most {MAXIMUM_TOKENS} names, numbers and symbols");
    assert_eq!(messages(&text), [expected]);
}

#[test]
fn the_digits_and_the_exponent_of_a_number_are_limited() {
    let digits = |count: usize| format!("let a = {};", "7".repeat(count));
    assert_eq!(messages(&digits(10_000)), [""; 0]);
    assert_eq!(messages(&digits(10_001)), ["a number has at most 10000 digits"]);
    let quoted = format!("`{}…` is not a number", "7".repeat(40));
    assert_eq!(messages(&format!("let a = {}x;", "7".repeat(10_001))), [quoted]);
    let expected = "the power of ten of a number is at most 10000 in magnitude";
    for exponent in ["10001", "-10001", "999999", "99999999999999999999999999"] {
        assert_eq!(messages(&format!("let a = 1e{exponent};")), [expected], "{exponent}");
    }
    assert_eq!(messages("let a = 1e10000 + 1e-10000 + 1e+00000000000000000000000000001;"), [""; 0]);
}

#[test]
fn a_number_of_the_greatest_length_is_one_token() {
    let (tokens, diagnostics) = lex(&"7".repeat(10_000));
    assert_eq!((tokens.len(), diagnostics.len()), (1, 0));
}
