//! Second way to find the unit of an expression, by measurement. If every length is given in a unit
//! four times smaller, a value in mᵃ is multiplied by 4ᵃ; the same holds for times. The checker
//! must accept the measured units, and no others.

use forms_core::check::read_theory;
use forms_core::kernel::{KernelSource, lower};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use std::cell::Cell;

/// Lengths a and b, times p and q, a number n, and a map that mixes them.
const SCENE: &str = "chart C(a: m, b: m, p: s, q: s); param n: 1;
map F: C -> C = (2*b + a, a*p/q, q, p + 3*q);
metric g on C = da**2 + 2*db**2 + (a/p)**2*dp**2 + (b/q)**2*dq**2 + a/(3*p)*db*dq;
chart K(a, b, p);
metric h on K = da**2 + db**2 + (b/p)**2*dp**2;";

/// Exponents are measured in 64ths.
const PARTS: f64 = 64.0;

fn expression() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        4 => prop::sample::select(vec!["a", "b", "p", "q", "n"]).prop_map(str::to_owned),
        1 => (1..4_i32).prop_map(|number| number.to_string()),
    ];
    leaf.prop_recursive(5, 24, 2, |part| {
        let pair = (part.clone(), part.clone());
        prop_oneof![
            4 => pair.clone().prop_map(|(x, y)| format!("({x})*({y})")),
            3 => pair.clone().prop_map(|(x, y)| format!("({x})/({y})")),
            3 => pair.clone().prop_map(|(x, y)| format!("({x}) + ({y})")),
            3 => part.clone().prop_map(|x| format!("({x})*a/b + 2*({x})")),
            2 => part.clone().prop_map(|x| format!("({x})*n - ({x})/3")),
            2 => part.clone().prop_map(|x| format!("sqrt({x})")),
            2 => (part.clone(), -2..4_i32).prop_map(|(x, k)| format!("({x})**{k}")),
            1 => part.clone().prop_map(|x| format!("abs(-({x}))")),
            1 => part.clone().prop_map(|x| format!("exp(({x})/(2*({x}) + ({x})*n))")),
            1 => part.clone().prop_map(|x| format!("sin({x})")),
            1 => pair.clone().prop_map(|(x, y)| format!("atan2({x}, {y})")),
            1 => pair.clone().prop_map(|(x, y)| format!("(if a > b {{ {x} }} else {{ {y} }})")),
            2 => part.clone().prop_map(|x| format!("diff({x}, a)")),
            2 => part.clone().prop_map(|x| format!("d(({x})*da)[dq^da]")),
            2 => pair.prop_map(|(x, y)| format!("(d({x})^d({y}))[dp^db]")),
            2 => part.clone().prop_map(|x| format!("lie(a*@p + b*@q, {x})")),
            2 => part.clone().prop_map(|x| format!("interior(p*@p + q*@q, d(({x})*db))[db]")),
            2 => part.clone().prop_map(|x| format!("pullback(F, {x})")),
            2 => part.clone().prop_map(|x| format!("pullback(F, ({x})*db)[dp]")),
            1 => part.clone().prop_map(|x| format!("pair(({x})*da^dp, @a, q*@p)")),
            1 => part.clone().prop_map(|x| format!("bracket(({x})*@a, b*@p)[p]")),
            1 => part.prop_map(|x| format!("integral({x}, b = 0..a)")),
        ]
    })
}

/// Operations that need a metric or a chart, applied to an expression.
fn operation() -> impl Strategy<Value = String> {
    let applied = prop::sample::select(vec![
        "hodge[g]((E)*da^dp)[db^dq]",
        "hodge[g]((E)*db)[da^dp^dq]",
        "hodge[g](E)[da^db^dp^dq]",
        "hodge[h]((E)*dp)[da^db]",
        "codiff[g]((E)*db)",
        "codiff[h]((E)*db^dp)[dp]",
        "laplace[h](E)",
        "flat[g]((E)*@q)[dq]",
        "flat[g]((E)*@b)[dq]",
        "sharp[g]((E)*dq)[q]",
        "inner[g]((E)*@p, q*@p + a*@a)",
        "inner[g]((E)*dp, d(a*p))",
        "inner[g]((E)*da^dp, da^dp)",
        "norm[g]((E)*@p)",
        "norm[g]((E)*dq)",
        "norm[g]((E)*dq^da)",
        "norm[g](E)",
        "volume[g][da^db^dp^dq]*(E)",
        "volume[h][da^db^dp]*(E)",
        "grad[g](E)[p]",
        "div[g]((E)*@p)",
        "curl[h]((E)*@a)[b]",
        "curl[h]((E)*@b)[p]",
        "potential((E)*da^dp)[dp]",
        "potential[C](E)",
    ]);
    let small = prop::sample::select(vec![
        "a",
        "a*q",
        "b/p",
        "p**2",
        "a**2*b",
        "n",
        "sqrt(p)",
        "a*b + 2*b**2",
        "q + p",
    ]);
    (applied, small).prop_map(|(applied, part)| applied.replace('E', part))
}

/// Returns the messages about a kernel with this result.
fn messages(unit: &str, expression: &str) -> Vec<String> {
    let text = format!("{SCENE} kernel k(a, b, p, q, n){unit} = {expression};");
    read_theory(&text).1.into_iter().map(|error| error.message).collect()
}

/// Returns the values of an expression at a point, and at the same point in other units.
fn values(expression: &str, point: [f64; 5], [metre, second]: [f64; 2]) -> Option<[f64; 2]> {
    // Read without units: the value of an expression does not depend on them.
    let scene = [": m", ": s", ": 1"].iter().fold(SCENE.to_owned(), |scene, unit| scene.replace(unit, ""));
    let (theory, errors) = read_theory(&format!("{scene} kernel k(a, b, p, q, n) = {expression};"));
    if !errors.is_empty() {
        return None;
    }
    let kernel = &theory.kernels[0];
    let (arguments, outputs) = (kernel.arguments.clone(), kernel.outputs.clone());
    let source = KernelSource { name: "k".into(), arguments, outputs, ..KernelSource::default() };
    let program = lower(&theory.pool, &source).ok()?;
    let [a, b, p, q, n] = point;
    let other = [a * metre, b * metre, p * second, q * second, n];
    let values = [point, other].map(|point| program.interpret(&point)[0]);
    let regular = |value: &f64| value.is_normal() && (1e-60..1e60).contains(&value.abs());
    values.iter().all(regular).then_some(values)
}

const POINT: [f64; 5] = [2.375, 1.25, 0.8125, 1.5, 0.625];

/// Returns the exponents of metre and second, in 64ths; `None` if the expression has no value or
/// does not scale.
fn measured(expression: &str) -> Option<[i64; 2]> {
    let exponent = |units: [f64; 2]| {
        let [value, other] = values(expression, POINT, units)?;
        let exponent = (other / value).log(4.0) * PARTS;
        ((exponent - exponent.round()).abs() < 1e-6).then_some(exponent.round() as i64)
    };
    Some([exponent([4.0, 1.0])?, exponent([1.0, 4.0])?])
}

/// Returns a runner that draws the same expressions in every run, so that the number of informative
/// ones is known.
fn runner() -> TestRunner {
    let config = Config { cases: 400, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha))
}

fn unit([metre, second]: [i64; 2]) -> String {
    format!(": m**({metre}/64)*s**({second}/64)")
}

#[test]
fn the_unit_of_an_expression_is_the_one_that_is_measured() {
    let (scaling, with_dimension) = (Cell::new(0), Cell::new(0));
    let mut runner = runner();
    runner
        .run(&prop_oneof![2 => expression(), 1 => operation()], |text| {
            if !messages("", &text).is_empty() || values(&text, POINT, [1.0, 1.0]).is_none() {
                return Ok(());
            }
            let exponents = measured(&text);
            prop_assert!(exponents.is_some(), "accepted and does not scale: {}", text);
            let [metre, second] = exponents.unwrap_or_default();
            prop_assert_eq!(messages(&unit([metre, second]), &text), Vec::<String>::new(), "{}", text);
            scaling.set(scaling.get() + 1);
            if [metre, second] != [0, 0] {
                with_dimension.set(with_dimension.get() + 1);
                let others = [[metre + 1, second], [metre, second - 64], [second + 3, metre]];
                for other in others.into_iter().filter(|&other| other != [metre, second]) {
                    prop_assert_eq!(messages(&unit(other), &text).len(), 1, "{}", text);
                }
            }
            Ok(())
        })
        .unwrap();
    assert!(scaling.get() > 150 && with_dimension.get() > 100, "{} {}", scaling.get(), with_dimension.get());
}

#[test]
fn a_sum_is_accepted_if_its_terms_scale_alike() {
    let (alike, unlike) = (Cell::new(0), Cell::new(0));
    let mut runner = runner();
    runner
        .run(&(expression(), expression(), any::<bool>()), |(left, right, as_left)| {
            let right = if as_left { format!("({right})*({left})/({right})") } else { right };
            if [&left, &right].iter().any(|text| !messages("", text).is_empty()) {
                return Ok(());
            }
            let (Some(a), Some(b)) = (measured(&left), measured(&right)) else { return Ok(()) };
            let found = messages("", &format!("({left}) + ({right})"));
            prop_assert_eq!(found.is_empty(), a == b, "({}) + ({}): {:?}", left, right, found);
            let counter = if a == b { &alike } else { &unlike };
            counter.set(counter.get() + 1);
            Ok(())
        })
        .unwrap();
    assert!(alike.get() > 20 && unlike.get() > 20, "{} {}", alike.get(), unlike.get());
}
