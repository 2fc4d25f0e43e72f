//! Exact integrals of random integrands against Gauss–Legendre quadrature, which uses no
//! antiderivatives.

use forms_core::expression::Expr;
use forms_core::kernel::evaluate_f64;
use forms_core::resolve::resolve;
use forms_core::syntax::read;
use forms_core::theory::{Named, Theory, Value};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

const CASES: usize = 160;

/// Minimum share of the integrals that must be found, in percent; every one is in the class.
const FLOOR: usize = 95;

/// Returns the theory of a text and the messages of its errors.
pub(crate) fn theory_of(text: &str) -> (Theory, Vec<String>) {
    let (file, errors) = read(text);
    let (theory, found) = resolve(&file);
    (theory, errors.into_iter().chain(found).map(|error| error.message).collect())
}

/// Returns the messages of a text's errors.
pub(crate) fn errors(text: &str) -> Vec<String> {
    theory_of(text).1
}

/// Integrands without singularities on [0, 2] for a = 1/2, b = 3/2.
fn integrand() -> impl Strategy<Value = String> {
    let number = || 1..=4i64;
    let linear = (number(), number()).prop_map(|(p, q)| format!("({p}*x + {q})"));
    let quadratic =
        (number(), number(), number()).prop_map(|(p, q, r)| format!("({p}*(x + {q}*b)**2 + {r} + a)"));
    let factor = prop_oneof![
        2 => linear.clone(),
        1 => Just("x".to_string()),
        1 => (number(), number()).prop_map(|(p, q)| format!("({p}*x**2 - {q}*a*x)")),
    ];
    prop_oneof![
        (factor.clone(), linear.clone(), quadratic.clone(), 1..=2u32)
            .prop_map(|(f, l, q, k)| format!("{f}/({l}*{q}**{k})")),
        (factor.clone(), quadratic.clone(), 1..=2u32).prop_map(|(f, q, k)| format!("{f}**2/{q}**{k}")),
        (factor.clone(), linear.clone(), -3..=3i64).prop_map(|(f, l, k)| format!("{f}*{l}**({k}/2)")),
        (factor.clone(), quadratic.clone(), -2..=1i64)
            .prop_map(|(f, q, k)| format!("{f}*{q}**({}/2)", 2 * k + 1)),
        (factor.clone(), number(), number(), linear.clone())
            .prop_map(|(f, p, q, l)| format!("{f}/({l}*sqrt({p}*(x + {q})**2 + a))")),
        (factor.clone(), number(), number()).prop_map(|(f, p, q)| format!("{f}*exp(-{p}*a*x)*cos({q}*b*x)")),
        (factor.clone(), number(), number()).prop_map(|(f, p, q)| format!("{f}*sin({p}*x)**2*cos({q}*a*x)")),
        (number(), number()).prop_map(|(p, q)| format!("sin(x)**{p}/({} + cos(x)*a)", q + 1)),
        (number(), number()).prop_map(|(p, q)| format!("1/({} + {p}*sin(x)*a)", 2 * p + q)),
        (linear.clone(), factor.clone()).prop_map(|(l, f)| format!("{f}*log({l})")),
        (factor.clone(), number()).prop_map(|(f, p)| format!("{f}*atan(x/{p})")),
        (number(), number()).prop_map(|(p, q)| format!("x**{}*exp(-{q}*x**2)", 2 * p - 1)),
        number().prop_map(|p| format!("exp(x)/({p} + exp(x))**2")),
        (number(), number()).prop_map(|(p, q)| format!("sin(x)*sqrt({} + {p}*cos(x))", p + q)),
    ]
}

/// Computes Gauss–Legendre quadrature with eight nodes on each of many subintervals.
pub(crate) fn quadrature(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    const NODES: [(f64, f64); 4] = [
        (0.183_434_642_495_649_8, 0.362_683_783_378_362),
        (0.525_532_409_916_329, 0.313_706_645_877_887_27),
        (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
        (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
    ];
    let parts = 40;
    let half = (to - from) / f64::from(2 * parts);
    let part = |number: i32| {
        let middle = from + half * f64::from(2 * number + 1);
        NODES.iter().map(|(x, w)| w * (f(middle + half * x) + f(middle - half * x))).sum::<f64>()
    };
    half * (0..parts).map(part).sum::<f64>()
}

pub(crate) fn scalar(theory: &Theory, name: &str) -> Expr {
    let Some(Named::Object(number)) = theory.named(name) else { panic!("{name} is a scalar") };
    match theory.objects[*number].value {
        Value::Scalar(value) => value,
        ref other => panic!("{name} is {}", other.kind()),
    }
}

#[test]
fn exact_integrals_agree_with_quadrature() {
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let mut runner = TestRunner::new_with_rng(Config::default(), random);
    let mut refused = Vec::new();
    for case in 0..CASES {
        let f = integrand().new_tree(&mut runner).unwrap().current();
        let to = ["2", "1", "b", "1/2 + a"][case % 4];
        let text = format!(
            "chart Line(x); param a, b where 0 < a < 1, 1 < b < 2; let f = {f}; let it = integral(f, x = 0..{to});"
        );
        let (mut theory, errors) = theory_of(&text);
        if !errors.is_empty() {
            refused.push(format!("{f} to {to}: {}", errors[0]));
            continue;
        }
        let symbols: Vec<_> = theory.pool.symbols_in(&[scalar(&theory, "f")]);
        let value_of = |theory: &Theory, x: f64| {
            let value = |symbol| match theory.pool.symbol_name(symbol) {
                "x" => x,
                "a" => 0.5,
                _ => 1.5,
            };
            symbols.iter().map(|&symbol| (symbol, value(symbol))).collect::<Vec<_>>()
        };
        let (written, exact) = (scalar(&theory, "f"), scalar(&theory, "it"));
        let parameters: Vec<_> = theory
            .pool
            .symbols_in(&[exact])
            .into_iter()
            .map(|symbol| (symbol, if theory.pool.symbol_name(symbol) == "a" { 0.5 } else { 1.5 }))
            .collect();
        let found = evaluate_f64(&theory.pool, &[exact], &parameters).unwrap()[0];
        let upper = [2.0, 1.0, 1.5, 1.0][case % 4];
        let pool = &mut theory;
        let expected =
            quadrature(|x| evaluate_f64(&pool.pool, &[written], &value_of(pool, x)).unwrap()[0], 0.0, upper);
        let close = (found - expected).abs() <= 1e-9 * (1.0 + expected.abs());
        assert!(close, "{f} to {to}: {found} and {expected}");
    }
    println!("{} of {CASES} refused:\n{}", refused.len(), refused.join("\n"));
    assert!(100 * refused.len() <= (100 - FLOOR) * CASES, "refused:\n{}", refused.join("\n"));
}
