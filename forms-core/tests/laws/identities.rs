//! Random true statements are never refuted and mostly proved. Random false ones are never proved,
//! and their witnesses are confirmed in plain arithmetic.

use forms_core::decide::{Verdict, decide};
use forms_core::expression::{Expr, Symbol};
use forms_core::kernel::evaluate_f64;
use forms_core::resolve::resolve;
use forms_core::syntax::read;
use forms_core::theory::{Statement, Theory, Value};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

const PREAMBLE: &str = "chart R3(x, y, z);";

/// Number of statements of a run, and the minimum share of the true ones that must be proved, in
/// percent.
const STATEMENTS: usize = 220;
const FLOOR: usize = 95;

/// Expressions as text: polynomials, quotients, radicals, sines and cosines.
fn scalar() -> impl Strategy<Value = String> {
    let variable = prop::sample::select(vec!["x", "y", "z"]);
    let number = 1..=4i64;
    let monomial = (number, variable.clone(), variable.clone()).prop_map(|(c, v, w)| format!("{c}*{v}*{w}"));
    let polynomial = (monomial.clone(), variable.clone(), 1..=5i64, any::<bool>())
        .prop_map(|(m, v, c, plus)| format!("({m} {} {c}*{v} + 1)", if plus { "+" } else { "-" }));
    prop_oneof![
        4 => polynomial.clone(),
        2 => (polynomial.clone(), variable.clone()).prop_map(|(p, v)| format!("({p}/(1 + {v}**2))")),
        2 => (polynomial.clone(), variable.clone()).prop_map(|(p, v)| format!("({v}*sqrt(1 + {p}**2))")),
        1 => (polynomial, variable.clone()).prop_map(|(p, v)| format!("({p}*sin(2*{v}))")),
        1 => variable.prop_map(|v| format!("cos({v} + x)")),
    ]
}

/// Linear angles.
fn angle() -> impl Strategy<Value = String> {
    (1..=3i64, 1..=3i64, prop::sample::select(vec!["x", "y"])).prop_map(|(p, q, v)| format!("({p}*{v}/{q})"))
}

/// Both sides of an identity, made by one rewriting step.
fn identity() -> impl Strategy<Value = (String, String)> {
    (0..14usize, scalar(), scalar(), angle(), angle()).prop_map(|(kind, a, b, u, v)| match kind {
        0 => (format!("({a} + {b})**2"), format!("{a}**2 + 2*{a}*{b} + {b}**2")),
        1 => (format!("{a}**2 - {b}**2"), format!("({a} - {b})*({a} + {b})")),
        2 => (format!("1/(1 + {a}**2) + 1/(2 + {b}**2)"), common_denominator(&a, &b)),
        3 => (format!("1/(sqrt(2 + {a}**2) - 1)"), format!("(sqrt(2 + {a}**2) + 1)/(1 + {a}**2)")),
        4 => (format!("sin({u} + {v})"), format!("sin({u})*cos({v}) + cos({u})*sin({v})")),
        5 => (format!("cos({u} - {v})"), format!("cos({u})*cos({v}) + sin({u})*sin({v})")),
        6 => (format!("diff({a}*{b}, x)"), format!("diff({a}, x)*{b} + {a}*diff({b}, x)")),
        7 => (
            format!("diff({a}/(1 + {b}**2), y)"),
            format!("(diff({a}, y)*(1 + {b}**2) - 2*{a}*{b}*diff({b}, y))/(1 + {b}**2)**2"),
        ),
        8 => (format!("sqrt({a}**2)"), format!("abs({a})")),
        9 => (format!("(1 + {a}**2)**(3/2)"), format!("(1 + {a}**2)*sqrt(1 + {a}**2)")),
        10 => (format!("sin({u})**2"), format!("(1 - cos(2*{u}))/2")),
        11 => (format!("diff(sqrt(1 + {a}**2), x)"), format!("{a}*diff({a}, x)/sqrt(1 + {a}**2)")),
        12 => (
            format!("d({a}*dx + {b}*dy)"),
            format!("(diff({b}, x) - diff({a}, y))*dx^dy + diff({a}, z)*dz^dx + diff({b}, z)*dz^dy"),
        ),
        _ => (format!("({a} + {b})**3 - {a}**3 - {b}**3"), format!("3*{a}*{b}*({a} + {b})")),
    })
}

fn common_denominator(a: &str, b: &str) -> String {
    format!("(3 + {a}**2 + {b}**2)/((1 + {a}**2)*(2 + {b}**2))")
}

/// Returns the right side with one number, sign or exponent changed.
fn perturbed(right: &str, place: usize) -> Option<String> {
    let changes: [(&str, &str); 6] =
        [(" + ", " - "), ("**2", "**3"), ("2*", "3*"), ("cos(", "sin("), ("sqrt(", "abs("), ("1 + ", "2 + ")];
    let (from, to) = changes[place % changes.len()];
    let places: Vec<usize> = right.match_indices(from).map(|found| found.0).collect();
    let at = *places.get((place / changes.len()) % places.len().max(1))?;
    Some(format!("{}{to}{}", &right[..at], &right[at + from.len()..]))
}

fn theory_of(left: &str, right: &str) -> (Theory, Statement) {
    let text = format!("{PREAMBLE} prove it: {left} == {right};");
    let (file, errors) = read(&text);
    assert_eq!(errors, [], "{text}");
    let (theory, errors) = resolve(&file);
    assert_eq!(errors, [], "{text}");
    let statement = theory.statements[0].clone();
    (theory, statement)
}

/// Draws the same values in every run.
fn draws<S: Strategy>(strategy: &S, count: usize) -> Vec<S::Value> {
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let mut runner = TestRunner::new_with_rng(Config::default(), random);
    (0..count).map(|_| strategy.new_tree(&mut runner).unwrap().current()).collect()
}

/// Returns the components of both sides, paired by blade.
fn sides(theory: &mut Theory, statement: &Statement) -> Vec<[Expr; 2]> {
    let zero = theory.pool.integer(0);
    match (&statement.left, &statement.right) {
        (Value::Form(left), Value::Form(right)) => {
            let blades = left.terms().iter().chain(right.terms()).map(|term| term.0);
            let of = |form: &forms_core::calculus::Form<Expr>, blade| {
                form.coefficient(blade).copied().unwrap_or(zero)
            };
            blades.map(|blade| [of(left, blade), of(right, blade)]).collect()
        }
        (left, right) => {
            let scalar = |value: &Value| value.scalars().first().copied().unwrap_or(zero);
            vec![[scalar(left), scalar(right)]]
        }
    }
}

/// Whether some component differs at a point by more than the rounding error.
fn differ(theory: &mut Theory, statement: &Statement, point: &[(Symbol, f64)]) -> bool {
    sides(theory, statement).iter().any(|pair| {
        let values = evaluate_f64(&theory.pool, pair, point).unwrap_or_default();
        matches!(values[..], [l, r] if (l - r).abs() > 1e-7 * (1.0 + l.abs() + r.abs()))
    })
}

fn variables(theory: &Theory) -> Vec<(String, Symbol)> {
    theory.coordinates.iter().map(|&symbol| (theory.pool.symbol_name(symbol).to_string(), symbol)).collect()
}

fn number(text: &str) -> f64 {
    match text.split_once('/') {
        Some((p, q)) => p.parse::<f64>().unwrap() / q.parse::<f64>().unwrap(),
        None => text.parse().unwrap(),
    }
}

#[test]
fn true_statements_are_never_refuted_and_mostly_proved() {
    let mut proved = 0;
    let mut open = Vec::new();
    for (left, right) in draws(&identity(), STATEMENTS) {
        let (mut theory, statement) = theory_of(&left, &right);
        match decide(&mut theory, &statement) {
            Verdict::Proved(_) => proved += 1,
            Verdict::Unknown { reason } => open.push(format!("{left} == {right}: {reason}")),
            wrong => panic!("{left} == {right}: {wrong:?}"),
        }
    }
    println!("proved {proved} of {STATEMENTS}");
    assert!(100 * proved >= FLOOR * STATEMENTS, "proved {proved} of {STATEMENTS}:\n{}", open.join("\n"));
}

#[test]
fn false_statements_are_never_proved_and_their_witnesses_stand() {
    let grid = [[0.7, -1.3, 0.4], [-2.1, 0.6, 1.9], [1.1, 2.3, -0.8], [-0.35, -0.9, -1.7]];
    let (mut refuted, mut false_ones) = (0, 0);
    for (count, (left, right)) in draws(&identity(), STATEMENTS).into_iter().enumerate() {
        let Some(wrong) = perturbed(&right, count) else { continue };
        let (mut theory, statement) = theory_of(&left, &wrong);
        let names = variables(&theory);
        let at = |point: [f64; 3]| names.iter().map(|name| name.1).zip(point).collect::<Vec<_>>();
        let is_false = grid.iter().any(|&point| differ(&mut theory, &statement, &at(point)));
        match decide(&mut theory, &statement) {
            Verdict::Proved(_) => assert!(!is_false, "{left} == {wrong} is proved"),
            Verdict::Refuted(witness) => {
                refuted += 1;
                let value_of = |name: &str| witness.point.iter().find(|entry| entry.0 == name);
                let point: Vec<(Symbol, f64)> = names
                    .iter()
                    .map(|(name, symbol)| (*symbol, value_of(name).map_or(0.5, |entry| number(&entry.1))))
                    .collect();
                assert!(differ(&mut theory, &statement, &point), "{left} == {wrong}: {witness:?}");
            }
            Verdict::Empty { reason } => panic!("{left} == {wrong} is said to be empty: {reason}"),
            Verdict::Unknown { .. } => {}
        }
        false_ones += usize::from(is_false);
    }
    println!("refuted {refuted} of {false_ones}");
    assert!(100 * refuted >= FLOOR * false_ones, "refuted {refuted} of {false_ones}");
}
