//! Printing and parsing are inverse to each other, and every span covers the source of its tree.

use crate::files;
use crate::print::Brackets;
use forms_core::diagnostic::Span;
use forms_core::expression::Relation;
use forms_core::syntax::ast::*;
use forms_core::syntax::{end_of, lex, parse_equation, parse_expression, read};
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;

fn parsed(text: &str) -> Expr {
    let (tokens, diagnostics) = lex(text);
    assert_eq!(diagnostics, [], "{text}");
    parse_expression(&tokens, end_of(text)).unwrap_or_else(|diagnostics| panic!("{text}: {diagnostics:?}"))
}

#[test]
fn precedence_is_that_of_the_language() {
    let cases = [
        ("-x**2", "-(x**2)"),
        ("x**-2", "x**(-2)"),
        ("x**y**z", "x**(y**z)"),
        ("x**-y**2", "x**(-(y**2))"),
        ("-a*b", "(-a)*b"),
        ("a*-b", "a*(-b)"),
        ("a - b - c", "(a - b) - c"),
        ("a - -b", "a - (-b)"),
        ("a/b*c", "(a/b)*c"),
        ("x*dy^dz/r", "((x*dy)^dz)/r"),
        ("a + b*c**d(e)", "a + (b*(c**(d(e))))"),
        ("bracket(X, Y)[x]**2", "((bracket(X, Y))[x])**2"),
        ("d[R3](w)[dx^dy]", "(d[R3](w))[(dx^dy)]"),
        ("volume[g][dx]", "(volume[g])[dx]"),
        ("R[1, 2]**2", "((R)[1, 2])**2"),
        ("[a, b + 1][0]*c", "(([a, (b + 1)])[0])*c"),
        ("[[a, b], [c, d]]*p", "([[a, b], [c, d]])*p"),
        ("-X[x]", "-(X[x])"),
        ("@x + y*@y", "(@x) + (y*(@y))"),
        (
            "if a > 0 { a } else if a < 0 { b } else { c }",
            "if a > 0 { a } else { (if a < 0 { b } else { c }) }",
        ),
    ];
    for (text, bracketed) in cases {
        assert_eq!(Brackets::All.expr(&parsed(text)), Brackets::All.expr(&parsed(bracketed)), "{text}");
    }
}

#[test]
fn numbers_are_exact() {
    let cases = [
        ("12", (12, 1)),
        ("0.5", (1, 2)),
        ("1e-3", (1, 1000)),
        ("1.5e+3", (1500, 1)),
        ("2E2", (200, 1)),
        ("0.10", (1, 10)),
        ("0e9999", (0, 1)),
        ("007", (7, 1)),
        ("62.5e-1", (25, 4)),
        ("1024e-10", (1, 9_765_625)),
    ];
    for (text, (numerator, denominator)) in cases {
        let ExprKind::Number(value) = *parsed(text).kind else { panic!("{text} is no number") };
        let expected = (BigInt::from(numerator), BigInt::from(denominator));
        assert_eq!((value.numer(), value.denom()), (&expected.0, &expected.1), "{text}");
    }
}

#[test]
fn a_range_begins_behind_its_number() {
    let text = "integral(w, u = 0..1, v = 0.5..u)";
    assert_eq!(Brackets::Fewest.expr(&parsed(text)), "integral(w, u = 0..1, v = 5e-1..u)");
}

#[test]
fn units_stand_behind_what_they_belong_to() {
    for text in [
        "chart R3(x: m, y: m**2/s, z);\n",
        "param n, sigma: 1/m where sigma > 0;\n",
        "fn L(x, y): W/m**2/sr where L > 0;\n",
        "let r: m**(1/2) = sqrt(x);\n",
        "form beta: 2, sr/m on R3 = dx^dy;\n",
        "kernel f(a: m, b): m/s = a/b;\n",
        "kernel f(a: m, b): (m, 1/s) = (a, b) where b > 0;\n",
        "kernel f(p[3]: m, R[3, 3], t: s): m/s = R*p/t;\n",
    ] {
        let (file, diagnostics) = read(text);
        assert_eq!(diagnostics, [], "{text}");
        assert_eq!(Brackets::Fewest.file(&file), text);
    }
}

#[test]
fn where_and_effects_stand_in_either_order() {
    let kernels = [
        "kernel f(x) = x where x > 0 effects { a: x = 0; b: x = 1; };",
        "kernel f(x) = x effects { a: x = 0; b: x = 1 } where x > 0;",
    ];
    let [first, second] = kernels.map(|text| Brackets::All.file(&read(text).0));
    assert!(first.contains("where") && first.contains("effects"), "{first}");
    assert_eq!(first, second);
}

#[test]
fn definitions_and_derivatives_are_printed_as_written() {
    for text in [
        "let ease(t) = t*t*(3 - 2*t);\n",
        "let mix(a, b, t) = a + t*(b - a);\n",
        "kernel g = grad(f; p, t);\n",
        "kernel j = jacobian(f; p, t);\n",
        "kernel vj = value_and_jacobian(f; p);\n",
    ] {
        let (file, diagnostics) = read(text);
        assert_eq!(diagnostics, [], "{text}");
        assert_eq!(Brackets::Fewest.file(&file), text);
    }
}

#[test]
fn a_comment_belongs_to_the_next_item_and_pub_to_its_kernel() {
    let (file, diagnostics) =
        read("/// One.\n///  Two.  \n// three\n//// four\npub kernel f(x) = x; let a = 1;");
    assert_eq!(diagnostics, []);
    assert_eq!(file.items[0].docs, ["One.", " Two."]);
    assert_eq!(file.items[1].docs, [""; 0]);
    assert_eq!([file.items[0].public, file.items[1].public], [true, false]);
}

#[test]
fn an_equation_stands_alone_with_its_conditions() {
    for text in ["abs(a) == a where a > 0, a != 1", "abs(a) == a where a > 0, a != 1;"] {
        let equation = parse_equation(&lex(text).0, end_of(text)).expect("it is an equation");
        assert_eq!((Brackets::Fewest.expr(&equation.left)).as_str(), "abs(a)");
        assert_eq!(equation.conditions.len(), 2);
    }
    let rest = "a == b; c";
    assert!(parse_equation(&lex(rest).0, end_of(rest)).is_err());
}

/// Returns every part of an expression, including the expression itself.
fn parts(expr: &Expr) -> Vec<&Expr> {
    let mut parts = vec![expr];
    let mut next = 0;
    while let Some(part) = parts.get(next).copied() {
        next += 1;
        match &*part.kind {
            ExprKind::Negate(inner) => parts.push(inner),
            ExprKind::Binary(_, _, left, right) => parts.extend([left, right]),
            ExprKind::Index { base, indices } => parts.extend(std::iter::once(base).chain(indices)),
            ExprKind::Array(entries) => parts.extend(entries),
            ExprKind::Call { index, arguments, .. } => {
                parts.extend(index);
                for argument in arguments {
                    match argument {
                        Argument::Value(value) => parts.push(value),
                        Argument::Range { from, to, .. } => parts.extend([from, to]),
                    }
                }
            }
            _ => {}
        }
    }
    parts
}

#[test]
fn the_text_of_a_span_is_the_expression() {
    let mut count = 0;
    for source in files::sources() {
        for item in read(&source.text).0.items {
            let ItemKind::Statement { left, right, .. } = &item.kind else { continue };
            for part in [left, right].into_iter().flat_map(parts) {
                let text = &source.text[part.span.start as usize..part.span.end as usize];
                assert_eq!(Brackets::All.expr(&parsed(text)), Brackets::All.expr(part), "{text}");
                count += 1;
            }
            let text = &source.text[item.span.start as usize..item.span.end as usize];
            assert!(
                text.ends_with(';') && (text.starts_with("prove") || text.starts_with("refute")),
                "{text}"
            );
        }
    }
    assert!(count > 2000, "the files have only {count} expressions");
}

#[test]
fn every_case_file_survives_printing() {
    for source in files::sources() {
        let file = read(&source.text).0;
        let (again, diagnostics) = read(&Brackets::Fewest.file(&file));
        assert_eq!(diagnostics, [], "{}", source.name);
        assert_eq!(Brackets::All.file(&again), Brackets::All.file(&file), "{}", source.name);
    }
}

fn name() -> impl Strategy<Value = Name> {
    prop::sample::select(vec!["x", "y", "beta", "R3", "r_2", "dx", "X"])
        .prop_map(|text| Name { text: text.to_owned(), span: Span::default() })
}

fn expr(kind: ExprKind) -> Expr {
    Expr { kind: Box::new(kind), span: Span::default() }
}

fn leaf() -> impl Strategy<Value = Expr> {
    prop_oneof![
        (0_u32..1000, 0_u32..4).prop_map(|(digits, places)| {
            expr(ExprKind::Number(BigRational::new(digits.into(), 10_u32.pow(places).into())))
        }),
        name().prop_map(|name| expr(ExprKind::Name(name.text))),
        name().prop_map(|name| expr(ExprKind::Basis(name))),
    ]
}

fn condition(side: impl Strategy<Value = Expr> + Clone) -> impl Strategy<Value = Condition> {
    use Relation::{Greater, GreaterEqual, Less, LessEqual, NotEqual};
    let relation = prop::sample::select(vec![Less, LessEqual, Greater, GreaterEqual, NotEqual]);
    (side.clone(), prop::collection::vec((relation, side), 1..3)).prop_map(|(first, rest)| Condition {
        first,
        rest,
        span: Span::default(),
    })
}

fn argument(value: impl Strategy<Value = Expr> + Clone) -> impl Strategy<Value = Argument> {
    let range = (name(), value.clone(), value.clone());
    prop_oneof![
        3 => value.prop_map(Argument::Value),
        1 => range.prop_map(|(variable, from, to)| Argument::Range { variable, from, to }),
    ]
}

fn expression() -> impl Strategy<Value = Expr> + Clone {
    use Binary::{Add, Divide, Multiply, Power, Subtract, Wedge};
    let operation = prop::sample::select(vec![Add, Subtract, Multiply, Divide, Wedge, Power]);
    leaf()
        .prop_recursive(6, 40, 3, move |part| {
            let call =
                (name(), prop::option::of(part.clone()), prop::collection::vec(argument(part.clone()), 0..4));
            prop_oneof![
                1 => part.clone().prop_map(|inner| expr(ExprKind::Negate(inner))),
                4 => (operation.clone(), part.clone(), part.clone()).prop_map(|(operation, left, right)| {
                    expr(ExprKind::Binary(operation, Span::default(), left, right))
                }),
                2 => call.prop_map(|(function, index, arguments)| {
                    expr(ExprKind::Call { function, index, arguments })
                }),
                1 => (part.clone(), prop::collection::vec(part.clone(), 1..3))
                    .prop_map(|(base, indices)| expr(ExprKind::Index { base, indices })),
                1 => prop::collection::vec(part.clone(), 1..4)
                    .prop_map(|entries| expr(ExprKind::Array(entries))),
                1 => (condition(part.clone()), part.clone(), part, any::<bool>()).prop_map(
                    |(condition, then, otherwise, jump)| {
                        expr(ExprKind::Select { condition, then, otherwise, jump })
                    }
                ),
            ]
        })
        .boxed()
}

proptest! {
    #[test]
    fn parsing_undoes_printing(expr in expression()) {
        let text = Brackets::Fewest.expr(&expr);
        prop_assert_eq!(Brackets::All.expr(&parsed(&text)), Brackets::All.expr(&expr), "{}", text);
    }

    #[test]
    fn brackets_change_nothing_where_precedence_puts_them(expr in expression()) {
        let text = Brackets::All.expr(&expr);
        prop_assert_eq!(Brackets::All.expr(&parsed(&text)), text);
    }
}
