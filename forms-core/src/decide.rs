//! Deciding statements: an exact proof, an exact counterexample, or neither.
//!
//! ```text
//! statement ─▶ differences by component + assumptions
//!      │ witness: exact points, values enclosed            ─▶ Refuted
//!      └ normal forms, zero in every case                  ─▶ Proved
//!                                                     else ─▶ Unknown
//! ```
//! A quick check in machine words comes first: if it is certain of a point at which the sides may
//! agree, the normal forms are computed before any other point is tried.
//!
//! A proof never rests on a sample. A refutation rests on values at an exact point: enclosed, or on
//! strata decided by their normal forms. A few points are tried first, since almost any point refutes a false statement; a
//! proved statement needs a point as well, to show that it is not vacuous.

mod account;
mod angle;
mod angle_equation;
mod cases;
mod empty;
mod equation;
mod finding;
mod goal;
mod instance;
mod observer;
mod principal_branch;
mod problem;
mod proof;
mod ratio;
mod reasons;
mod relation;
mod report;
mod sample;
mod separation;
#[cfg(test)]
mod soundness;
mod special;
mod strata;
mod tactics;
mod translation;
mod trigonometric_signs;
mod verdict;
mod witness;

#[cfg(feature = "internals")]
pub use account::{Account, Bound, Cancellation, Case, account};
#[cfg(not(feature = "internals"))]
pub(crate) use account::{Account, Bound, Cancellation, Case, account};
#[cfg(feature = "internals")]
pub use angle_equation::vanishing_angles;
#[cfg(not(feature = "internals"))]
pub(crate) use angle_equation::vanishing_angles;
pub(crate) use finding::{Budget, Equations, Finding, contradiction, nowhere_defined};
pub(crate) use observer::Observer;

pub use reasons::{EmptyReason, KernelReason, UnknownReason};
pub(crate) use report::simplified;
pub use report::simplified_where;
pub(crate) use sample::simple_bounds;
#[cfg(feature = "internals")]
pub use separation::{Separated, separated};
#[cfg(not(feature = "internals"))]
pub(crate) use separation::{Separated, separated};
#[cfg(feature = "internals")]
pub use tactics::{Attempt, attempts};
#[cfg(not(feature = "internals"))]
pub(crate) use tactics::{Attempt, attempts};
pub use verdict::{Ratio, Theorem, Verdict, Witness};

use crate::assume::{is_not_zero_densely, is_open, vanishes};
use crate::expression::{Condition, Expr, Pool, Relation};
pub use crate::normal::{OutsidePart, SizeLimit};
use crate::normal::{Tower, Trigonometry};
use crate::steps;
use crate::theory::{Integration, Statement, Theory};
use problem::Problem;

/// Limit on the products of terms in one normal form of a retraced proof.
const RETRACED_WORK: u64 = 2_000_000;

/// Decides one statement.
///
/// ```
/// use forms_core::{decide::decide, resolve::resolve, syntax::read};
/// let (file, errors) = read("chart R3(x, y, z); prove twice: d(d(x*y**2*dz)) == 0;");
/// assert!(errors.is_empty());
/// let (mut theory, errors) = resolve(&file);
/// assert!(errors.is_empty());
/// let statement = theory.statements[0].clone();
/// assert_eq!(decide(&mut theory, &statement).name(), "proved");
/// ```
pub fn decide(theory: &mut Theory, statement: &Statement) -> Verdict {
    decide_with_effort(theory, statement, 1)
}

/// Decides one statement with `budget` times the usual steps, which are about a second of work.
pub fn decide_with_effort(theory: &mut Theory, statement: &Statement, budget: u32) -> Verdict {
    let granted = steps::STATEMENT.saturating_mul(budget.max(1).into());
    steps::limited(granted, || decide_within(theory, statement, budget.max(1)))
}

fn decide_within(theory: &mut Theory, statement: &Statement, budget: u32) -> Verdict {
    if let Some(message) = statement.obstacle.clone() {
        return Verdict::Unknown { reason: UnknownReason::NoValue(message) };
    }
    let problem = Problem::new(theory, statement);
    let found = finding::find(&mut theory.pool, &problem, Budget::STATEMENT.times(budget));
    // At the point of a refutation the known value of an integral holds.
    if !matches!(found, Finding::Different(_) | Finding::Unknown { .. })
        && let Some(reason) = narrowed(theory, &problem)
    {
        return Verdict::Unknown { reason };
    }
    match found {
        Finding::Equal { points: 0 } => Verdict::Unknown { reason: UnknownReason::NoPoint },
        Finding::Equal { .. } => Verdict::Proved(report::theorem(&mut theory.pool, &problem)),
        Finding::Different(witness) => {
            let ratio = ratio::ratio(theory, &problem);
            Verdict::Refuted(Witness { ratio, ..witness })
        }
        Finding::Empty(reason) => Verdict::Empty { reason },
        Finding::Unknown { reason, .. } => Verdict::Unknown { reason },
    }
}

/// Returns the reason why an integral that is known only under a condition does not decide the
/// statement: where the condition fails, the statement may include points that are not limits of
/// other points.
///
/// A condition that follows from the others removes no point. Any other condition, such as k ≠ 0
/// for an integral of cos(k x), is a legitimate condition of a theorem if the points that meet the
/// rest form an open set in which the zeros of k are nowhere dense: the remaining points are dense
/// in it, and both sides are continuous.
fn narrowed(theory: &mut Theory, problem: &Problem) -> Option<UnknownReason> {
    let stated = &problem.assumptions[..problem.stated];
    let is_narrowing =
        |condition: &&Condition| theory.narrowing.contains(condition) && !stated.contains(condition);
    let (narrowing, others): (Vec<&Condition>, Vec<&Condition>) =
        problem.assumptions.iter().partition(is_narrowing);
    let narrowing: Vec<Condition> = narrowing.into_iter().copied().collect();
    let others: Vec<Condition> = others.into_iter().copied().collect();
    let pool = &mut theory.pool;
    let sides: Vec<Expr> = problem.components.iter().flat_map(|c| [c.left, c.right]).collect();
    if narrowing.is_empty() {
        return None;
    }
    let has_limits = is_open(pool, &others, &sides);
    // A condition that is not defined everywhere may contain the integral itself, together with its
    // divisors.
    let plain: Vec<Condition> =
        stated.iter().copied().filter(|c| is_defined_without_divisors(pool, c)).collect();
    let open = narrowing.into_iter().find(|condition| {
        let difference = pool.subtract(condition.left, condition.right);
        let is_harmless =
            has_limits && is_not_zero_densely(pool, difference) || is_implied(pool, condition, &plain);
        !is_harmless
    })?;
    Some(UnknownReason::NarrowIntegral { condition: open.text(pool) })
}

/// Whether a condition is defined without requiring that a divisor is not zero.
fn is_defined_without_divisors(pool: &mut Pool, condition: &Condition) -> bool {
    let domain = pool.domain(&[condition.left, condition.right]);
    domain.iter().all(|needed| needed.relation != Relation::NotEqual)
}

/// Whether a ≠ b follows from other conditions: from one of them with the same difference up to its
/// sign, or because a = b contradicts them.
pub(crate) fn is_implied(pool: &mut Pool, condition: &Condition, others: &[Condition]) -> bool {
    let Condition { left, right, .. } = *condition;
    let difference = pool.subtract(left, right);
    let is_same = |pool: &mut Pool, other: &Condition| {
        let known = pool.subtract(other.left, other.right);
        let (minus, plus) = (pool.subtract(known, difference), pool.add(known, difference));
        vanishes(pool, minus) || vanishes(pool, plus)
    };
    let is_strict =
        |other: &&Condition| !matches!(other.relation, Relation::LessEqual | Relation::GreaterEqual);
    if others.iter().filter(is_strict).any(|other| is_same(pool, other)) {
        return true;
    }
    let equal =
        [Relation::LessEqual, Relation::GreaterEqual].map(|relation| Condition { left, relation, right });
    let both: Vec<Condition> = others.iter().copied().chain(equal).collect();
    finding::contradiction(pool, &both).is_some()
}

/// Proves a statement again, reports the steps to an observer, and returns whether it is proved.
pub(crate) fn retrace(theory: &mut Theory, statement: &Statement, observer: &mut dyn Observer) -> bool {
    let problem = Problem::new(theory, statement);
    retrace_problem(&mut theory.pool, &problem, observer)
}

/// Proves again that the derivative of an antiderivative is the integrand, and reports the steps to
/// an observer.
pub(crate) fn retrace_integration(
    pool: &mut Pool,
    integration: &Integration,
    antiderivative: Expr,
    observer: &mut dyn Observer,
) -> bool {
    let slope = pool.derivative(antiderivative, integration.variable);
    let problem = Problem::of_scalars(pool, &[(slope, integration.integrand)], &integration.conditions);
    retrace_problem(pool, &problem, observer)
}

fn retrace_problem(pool: &mut Pool, problem: &Problem, observer: &mut dyn Observer) -> bool {
    let mut tower = Tower::new(Trigonometry::Circle).with_work_limit(RETRACED_WORK);
    if problem.components.is_empty() {
        observer.zero(pool, &tower, &[]);
        return true;
    }
    cases::settled_cases(pool, problem, &mut tower, Some(observer)).is_some()
}

/// Returns the conditions that a verdict on a statement assumes; the verdict carries their texts.
pub(crate) fn conditions(theory: &mut Theory, statement: &Statement) -> Vec<Condition> {
    let problem = Problem::new(theory, statement);
    report::conditions(&mut theory.pool, &problem)
}
