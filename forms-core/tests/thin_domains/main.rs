//! Statements on thin domains, whose conditions hold only on points, curves and boundaries: no
//! verdict contradicts the exact values at points of these strata.
//!
//! The reference computes with fractions, and with cosines known at multiples of π/6; it shares
//! nothing with the prover. `FORMS_STATEMENTS=100000` sets the number of statements.

mod statement;
mod tree;
mod value;

use forms_core::check::read_theory;
use forms_core::decide::{Verdict, decide};
use statement::{Dice, Statement};

/// Default number of statements.
const STATEMENTS: u64 = 240;

/// Number of points for each statement.
const POINTS: usize = 120;

#[derive(Default)]
struct Tally {
    proved: u64,
    refuted: u64,
    unknown: u64,
    /// Number of statements that the reference found false at a point of a stratum.
    seen_false: u64,
    wrong: Vec<String>,
}

#[test]
fn no_verdict_on_a_thin_domain_contradicts_exact_points_on_its_strata() {
    let count = std::env::var("FORMS_STATEMENTS")
        .map_or(STATEMENTS, |text| text.parse().expect("FORMS_STATEMENTS is a number"));
    let threads = std::thread::available_parallelism().map_or(1, |threads| threads.get() as u64);
    let tallies: Vec<Tally> = std::thread::scope(|scope| {
        let share = |first: u64| scope.spawn(move || tally((first..count).step_by(threads as usize)));
        let shares: Vec<_> = (0..threads).map(share).collect();
        shares.into_iter().map(|share| share.join().expect("no case panics")).collect()
    });
    let total = |of: fn(&Tally) -> u64| tallies.iter().map(of).sum::<u64>();
    let wrong: Vec<&String> = tallies.iter().flat_map(|tally| &tally.wrong).collect();
    let (proved, refuted) = (total(|tally| tally.proved), total(|tally| tally.refuted));
    println!(
        "{count} statements: {proved} proved, {refuted} refuted, {} unknown",
        total(|tally| tally.unknown)
    );
    assert!(wrong.is_empty(), "{} wrong verdicts: {wrong:#?}", wrong.len());
    assert!(proved * 20 > count && refuted * 4 > count, "{proved} proved and {refuted} refuted say little");
    assert!(total(|tally| tally.seen_false) * 4 > count, "the judge sees too little");
}

fn tally(cases: impl Iterator<Item = u64>) -> Tally {
    let mut tally = Tally::default();
    for case in cases {
        let mut dice = Dice::of(case);
        let statement = dice.statement();
        let seen: Vec<bool> = (0..POINTS).filter_map(|_| statement.differs_at(&dice.point())).collect();
        judge(case, &statement, &seen, &mut tally);
    }
    tally
}

/// Compares a verdict with the differences of the sides at points that satisfy the conditions.
fn judge(case: u64, statement: &Statement, seen: &[bool], tally: &mut Tally) {
    let is_false = seen.contains(&true);
    tally.seen_false += u64::from(is_false);
    let (mut theory, errors) = read_theory(&statement.source());
    if !errors.is_empty() {
        tally.wrong.push(format!("case {case}: {errors:?}: {statement}"));
        return;
    }
    let written = theory.statements[0].clone();
    match decide(&mut theory, &written) {
        Verdict::Proved(_) if is_false => {
            tally.wrong.push(format!("case {case}: proved and false: {statement}"));
        }
        Verdict::Empty { reason } if !seen.is_empty() => {
            tally.wrong.push(format!("case {case}: it has points, in spite of \"{reason}\": {statement}"));
        }
        Verdict::Proved(_) => tally.proved += 1,
        Verdict::Refuted(_) => tally.refuted += 1,
        Verdict::Unknown { .. } | Verdict::Empty { .. } => tally.unknown += 1,
    }
}

/// Statements that are false at points where the closed form found for an integral or a limit is
/// not valid.
const FALSE: &[&str] = &[
    "abs(y) + integral(cos(k*x), x = 0..1) == integral(cos(k*x), x = 0..1) - y where k**2*y <= 0",
    "integral(cos(k*x), x = 0..1) == 2 where k**2 <= 0",
    "integral(exp(k*x), x = 0..1) + abs(y) == integral(exp(k*x), x = 0..1) - y where abs(k)*y <= 0",
    // the divisor is zero in half of the space
    "integral(cos((abs(k) - k)*x), x = 0..1)*(k + abs(k)) == 0",
    "abs(k) + integral(exp((abs(k) - k)*x), x = 0..1) == integral(exp((abs(k) - k)*x), x = 0..1) - k",
    "integral(x**(abs(k) - k - 1), x = 1..2)*(k + abs(k)) == 0",
    "integral(cos((sqrt(k**2) - k)*x), x = 0..1)*(k + abs(k)) == 0",
    "integral(x*sin((abs(k) + k)*x) + 1, x = 0..1)*(k - abs(k)) == 0",
    "abs(k) == -k where integral(cos((abs(k) - k)*x), x = 0..1) <= 5",
    "k == 1 where integral(cos(k*x), x = 0..1)**2 >= 1, k**2 <= 1, integral(sin(k*x), x = 0..1) >= k/2",
    "integral(exp((asin(sin(k)) - k)*x), x = 0..1)*(abs(cos(k)) + cos(k)) == 0 where 0 < k, k < pi",
];

#[test]
fn no_false_statement_about_integrals_is_proved_on_a_thin_domain() {
    for statement in FALSE {
        let (mut theory, errors) = read_theory(&format!("chart C(x, y); param k; refute it: {statement};"));
        assert_eq!(errors, [], "{statement}");
        let written = theory.statements[0].clone();
        let verdict = decide(&mut theory, &written);
        assert!(!matches!(verdict, Verdict::Proved(_)), "{statement}: {verdict:?}");
    }
}

/// The reference is reliable: |y| = −y fails at x = π, y = 1 under (1 + cos x) y <= 0, and at no
/// point under y <= 0.
#[test]
fn the_judge_knows_a_point_from_its_surroundings() {
    use statement::Condition;
    use tree::{Angle, Tree};
    let y = || Tree::Plain(0);
    let sides = |condition| Statement { left: y().abs(), right: y().negated(), conditions: vec![condition] };
    let angle = Angle { of_x: 1, of_z: 0, over: 1 };
    let distance = Tree::Number(1).plus(Tree::Cos(angle));
    let on_the_stratum = sides(Condition(distance.times(y()), Tree::Number(0)));
    let below = sides(Condition(y(), Tree::Number(0)));
    let at = |x: i64, y: i64| [x.into(), 0.into(), y.into(), 0.into()];
    assert_eq!(on_the_stratum.differs_at(&at(1, 1)), Some(true));
    assert_eq!(on_the_stratum.differs_at(&at(0, 1)), None);
    assert_eq!(on_the_stratum.differs_at(&at(0, -1)), Some(false));
    assert_eq!(below.differs_at(&at(1, -1)), Some(false));
    assert_eq!(below.differs_at(&at(1, 1)), None);
}
