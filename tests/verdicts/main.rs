//! Verdicts against values: random statements, made from known identities by putting them together and damaging
//! some, are decided; whoever is right must agree with values of some 90 digits from another library.
//!
//! `FORMS_STATEMENTS=100000` tries that many statements.

mod dice;
mod identity;
mod tree;
mod value;

use astro_float::BigFloat;
use dice::Dice;
use forms::core::check::{decide_all, read_theory};
use forms::core::decide::{Verdict, Witness};
use identity::{Equation, damage, identity};
use tree::NAMES;
use value::Calculator;

/// How many statements are tried where nobody asks for more.
const STATEMENTS: u64 = 1_000;
/// Of a hundred statements so many have to be decided.
const DECIDED: u64 = 95;
/// Points looked at, and how many of them where both sides are defined are enough.
const POINTS: usize = 60;
const ENOUGH: usize = 6;

/// What is found of the statements.
#[derive(Default)]
struct Tally {
    proved: u64,
    refuted: u64,
    empty: u64,
    unknown: Vec<String>,
    wrong: Vec<String>,
}

#[test]
fn no_verdict_on_a_random_statement_contradicts_its_values() {
    let count = std::env::var("FORMS_STATEMENTS")
        .map_or(STATEMENTS, |text| text.parse().expect("FORMS_STATEMENTS is a number"));
    let (mut tally, mut calculator) = (Tally::default(), Calculator::new());
    for case in 0..count {
        let mut dice = Dice::of(case);
        let mut sides = identity(&mut dice);
        if dice.below(2) == 0 {
            damage(&mut sides, &mut dice);
        }
        judge(case, &sides, &mut dice, &mut calculator, &mut tally);
    }
    let Tally { proved, refuted, empty, unknown, wrong } = tally;
    println!("{count} statements: {proved} proved, {refuted} refuted, {empty} of no point, {} unknown", unknown.len());
    for open in &unknown {
        println!("unknown: {open}");
    }
    assert!(wrong.is_empty(), "{} wrong verdicts:\n{}", wrong.len(), wrong.join("\n"));
    assert!((count - unknown.len() as u64) * 100 >= count * DECIDED, "{} unknown of {count}", unknown.len());
    assert!(proved * 4 > count && refuted * 4 > count, "{proved} proved and {refuted} refuted say little");
}

fn judge(case: u64, sides: &Equation, dice: &mut Dice, calculator: &mut Calculator, tally: &mut Tally) {
    let equation = format!("{} == {}", sides[0], sides[1]);
    let source = format!("chart P(x, y); param a, b where a > 0, b > 0; prove s: {equation};");
    let (mut theory, errors) = read_theory(&source);
    if !errors.is_empty() {
        // The resolver refuses a division by zero; the values must have no point either.
        if differs_somewhere(sides, dice, calculator).is_some() {
            tally.wrong.push(format!("case {case}: {equation}: {errors:?}"));
        }
        tally.empty += 1;
        return;
    }
    match decide_all(&mut theory).remove(0) {
        Verdict::Proved(_) => {
            tally.proved += 1;
            if differs_somewhere(sides, dice, calculator) == Some(true) {
                tally.wrong.push(format!("case {case}: proved, and false: {equation}"));
            }
        }
        Verdict::Refuted(witness) => {
            tally.refuted += 1;
            let point = point_of(&witness, calculator);
            if calculator.differ([&sides[0], &sides[1]], &point) != Some(true) {
                tally.wrong.push(format!("case {case}: refuted by a point that does not: {equation}: {witness}"));
            }
        }
        Verdict::Unknown { reason } => {
            let truth = match differs_somewhere(sides, dice, calculator) {
                Some(true) => "false",
                Some(false) => "true",
                None => "of no point",
            };
            tally.unknown.push(format!("case {case}, {truth}: {equation}: {reason}"));
        }
        Verdict::Empty { reason } => {
            tally.empty += 1;
            if differs_somewhere(sides, dice, calculator).is_some() {
                tally.wrong.push(format!("case {case}: it has points: {equation}: {reason}"));
            }
        }
    }
}

/// Random points with positive parameters.
fn points(dice: &mut Dice, calculator: &Calculator) -> impl Iterator<Item = Vec<BigFloat>> + use<> {
    let mut found = Vec::new();
    for _ in 0..POINTS {
        let coordinates = (0..2).map(|_| (dice.between(-40, 40), dice.between(7, 13)));
        let mut point: Vec<(i64, i64)> = coordinates.collect();
        point.extend((0..2).map(|_| (dice.between(1, 40), dice.between(7, 13))));
        found.push(point.iter().map(|&(p, q)| calculator.ratio(p, q)).collect());
    }
    found.into_iter()
}

/// Whether the sides differ at one of some random points; nothing where both are defined at none of them.
fn differs_somewhere(sides: &Equation, dice: &mut Dice, calculator: &mut Calculator) -> Option<bool> {
    let mut defined = 0;
    for point in points(dice, calculator) {
        match calculator.differ([&sides[0], &sides[1]], &point) {
            None => {}
            Some(true) => return Some(true),
            Some(false) => defined += 1,
        }
        if defined == ENOUGH {
            break;
        }
    }
    (defined > 0).then_some(false)
}

/// The point of a witness; a variable it does not name has no influence.
fn point_of(witness: &Witness, calculator: &Calculator) -> Vec<BigFloat> {
    let value = |name: &str| witness.point.iter().find(|entry| entry.0 == name).map_or("1", |entry| &entry.1);
    NAMES
        .iter()
        .map(|name| {
            let text = value(name);
            let (p, q) = text.split_once('/').unwrap_or((text, "1"));
            let [p, q] = [p, q].map(|part| part.parse().expect("the value of a witness is a fraction"));
            calculator.ratio(p, q)
        })
        .collect()
}
