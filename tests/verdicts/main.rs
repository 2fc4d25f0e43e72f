//! Verdicts compared with values: random statements are decided, and every verdict must agree with
//! values of some 90 digits from another library. The statements are combinations of known
//! identities, some of them damaged.
//!
//! `FORMS_STATEMENTS=100000` runs this number of statements.

mod conditional;
mod dice;
mod forms;
mod identity;
mod mutation;
mod notation;
mod parts;
mod statement;
mod tree;
mod value;

use ::forms::core::check::{decide_all, read_theory};
use ::forms::core::decide::{Verdict, Witness};
use astro_float::BigFloat;
use dice::Dice;
use identity::identity;
use mutation::damage;
use statement::{Condition, Statement};
use tree::{NAMES, apply, number, partial, power, variable};
use value::Calculator;

/// Default number of statements.
const STATEMENTS: u64 = 1_000;
/// Smallest percentage of statements that must be decided.
const DECIDED: u64 = 95;
/// Number of points that are tried, and number of points in the domain of the statement that are
/// sufficient.
const POINTS: usize = 100;
const ENOUGH: usize = 8;

/// Numbers of verdicts, with the unknown and the wrong ones.
#[derive(Default)]
struct Tally {
    proved: u64,
    refuted: u64,
    empty: u64,
    unknown: Vec<String>,
    wrong: Vec<String>,
}

/// Calculators with some 90 digits, and with four times that number for values that appear to
/// differ.
struct Values {
    quick: Calculator,
    sure: Calculator,
}

#[test]
fn no_verdict_on_a_random_statement_contradicts_its_values() {
    let count = std::env::var("FORMS_STATEMENTS")
        .map_or(STATEMENTS, |text| text.parse().expect("FORMS_STATEMENTS is a number"));
    let threads = std::thread::available_parallelism().map_or(1, |threads| threads.get() as u64);
    let tallies: Vec<Tally> = std::thread::scope(|scope| {
        let share = |first: u64| scope.spawn(move || tally((first..count).step_by(threads as usize)));
        let shares: Vec<_> = (0..threads).map(share).collect();
        shares.into_iter().map(|share| share.join().expect("no case panics")).collect()
    });
    let Tally { proved, refuted, empty, unknown, wrong } =
        tallies.into_iter().fold(Tally::default(), Tally::with);
    println!(
        "{count} statements: {proved} proved, {refuted} refuted, {empty} of no point, {} unknown",
        unknown.len()
    );
    for open in &unknown {
        println!("unknown: {open}");
    }
    assert!(wrong.is_empty(), "{} wrong verdicts:\n{}", wrong.len(), wrong.join("\n"));
    assert!((count - unknown.len() as u64) * 100 >= count * DECIDED, "{} unknown of {count}", unknown.len());
    assert!(proved * 4 > count && refuted * 4 > count, "{proved} proved and {refuted} refuted say little");
}

/// Decides these cases and checks the verdicts.
fn tally(cases: impl Iterator<Item = u64>) -> Tally {
    let mut values = Values { quick: Calculator::new(320), sure: Calculator::new(1280) };
    let mut tally = Tally::default();
    for case in cases {
        let mut dice = Dice::of(case);
        let mut statement = identity(&mut dice);
        if dice.below(2) == 0 {
            damage(&mut statement, &mut dice);
        }
        judge(case, &statement, &mut dice, &mut values, &mut tally);
    }
    tally
}

impl Tally {
    fn with(mut self, other: Tally) -> Tally {
        self.unknown.extend(other.unknown);
        self.wrong.extend(other.wrong);
        let (proved, refuted) = (self.proved + other.proved, self.refuted + other.refuted);
        Tally { proved, refuted, empty: self.empty + other.empty, ..self }
    }
}

fn judge(case: u64, statement: &Statement, dice: &mut Dice, values: &mut Values, tally: &mut Tally) {
    let mut wrong = |what: &str| tally.wrong.push(format!("case {case}: {what}: {statement}"));
    let (mut theory, errors) = read_theory(&statement.source());
    if !errors.is_empty() {
        // The resolver rejects a division by zero; then no point can have values either.
        if values.differ_somewhere(statement, dice).is_some() {
            wrong(&format!("it has points: {errors:?}"));
        }
        tally.empty += 1;
        return;
    }
    match decide_all(&mut theory).remove(0) {
        Verdict::Proved(_) => {
            tally.proved += 1;
            if values.differ_somewhere(statement, dice) == Some(true) {
                wrong("proved, and false");
            }
        }
        Verdict::Refuted(witness) => {
            tally.refuted += 1;
            if !values.bear_out(statement, &witness) {
                wrong(&format!("refuted by a point that does not ({witness})"));
            }
        }
        Verdict::Unknown { reason } => {
            let truth = match values.differ_somewhere(statement, dice) {
                Some(true) => "false",
                Some(false) => "true",
                None => "of no point",
            };
            tally.unknown.push(format!("case {case}, {truth}: {statement}: {reason}"));
        }
        Verdict::Empty { reason } => {
            tally.empty += 1;
            if values.differ_somewhere(statement, dice).is_some() {
                wrong(&format!("it has points, in spite of \"{reason}\""));
            }
        }
    }
}

impl Values {
    /// Whether the sides differ at one of some random points; `None` if the statement applies to
    /// none of them.
    fn differ_somewhere(&mut self, statement: &Statement, dice: &mut Dice) -> Option<bool> {
        let mut met = 0;
        for _ in 0..POINTS {
            let point = random_point(dice, &self.quick);
            match differ(&mut self.quick, statement, &point) {
                None => {}
                Some(true) if differ(&mut self.sure, statement, &point) == Some(true) => return Some(true),
                Some(_) => met += 1,
            }
            if met == ENOUGH {
                break;
            }
        }
        (met > 0).then_some(false)
    }

    /// Whether the sides differ at the point of a witness; variables that the witness does not name
    /// have no influence.
    fn bear_out(&mut self, statement: &Statement, witness: &Witness) -> bool {
        let value =
            |name: &str| witness.point.iter().find(|entry| entry.0 == name).map_or("1", |entry| &entry.1);
        let point: Vec<BigFloat> = NAMES.iter().map(|name| self.sure.coordinate(value(name))).collect();
        differ(&mut self.sure, statement, &point) == Some(true)
    }
}

/// Whether the sides differ at a point; `None` if the statement does not apply to the point.
fn differ(calculator: &mut Calculator, statement: &Statement, point: &[BigFloat]) -> Option<bool> {
    for condition in &statement.conditions {
        if calculator.meets(condition, point) != Some(true) {
            return None;
        }
    }
    let [left, right] = &statement.sides;
    calculator.differ([left, right], point)
}

/// Returns a random point with positive parameters; every second coordinate is small.
fn random_point(dice: &mut Dice, calculator: &Calculator) -> Vec<BigFloat> {
    let coordinate = |low: i64| {
        let high = if dice.below(2) == 0 { 40 } else { 13 };
        (dice.between(low.max(-high), high), dice.between(7, 13))
    };
    [-40, -40, 1, 1].map(coordinate).map(|(p, q)| calculator.ratio(p, q)).to_vec()
}

/// Tests the judge itself: √x² = x holds for some x and for all x > 0, and √(−1 − x²) = x is
/// vacuous.
#[test]
fn values_tell_what_holds_from_what_does_not() {
    let mut values = Values { quick: Calculator::new(320), sure: Calculator::new(1280) };
    let x = variable(0);
    let root = apply("sqrt", &power(&x, (2, 1)));
    let imaginary = apply("sqrt", &(number(-1) - power(&x, (2, 1))));
    let positive = Condition::positive(&x);
    let nearly = Condition::less(&number(-1), &x);
    let expected = [
        (Statement::from([root.clone(), x.clone()]), Some(true)),
        (Statement::new([root.clone(), x.clone()], [positive]), Some(false)),
        (Statement::new([root, x.clone()], [nearly]), Some(true)),
        (Statement::from([imaginary, x.clone()]), None),
        (Statement::from([partial(&apply("abs", &x), 0), number(1)]), Some(true)),
    ];
    for (statement, differs) in expected {
        let found = values.differ_somewhere(&statement, &mut Dice::of(0));
        assert_eq!(found, differs, "{statement}");
    }
}
