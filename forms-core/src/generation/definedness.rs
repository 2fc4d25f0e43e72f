//! Definedness: a form has a value wherever the formula has one, on the kernel's domain, and it is
//! the same value.
//!
//! ```text
//! form ─ obligations ─▶ conditions, each ─┬─ entailed by the domain and by the conditions of the formula
//!                                         ├─ violated at an exact point where the formula has a value
//!                                         └─ neither: not shown, which proves nothing
//! ```
//! An equation between formula and form covers the points at which both are defined. This module
//! shows that these are all points at which the formula is defined, output by output; isolated
//! points and strata of the domain count like any other points.

use super::entailment::Known;
use super::exact_point::{ExactPoint, NoValue, Point, digits, sign_of};
use super::obligation::{self, MOST_PATHS, Obligation, obligations};
use super::pieces::{MOST_PIECES, negated, pieces};
use super::special_points::SpecialPoints;
use super::translation::{EFFORT, equality};
use crate::decide::{KernelReason, UnknownReason, Witness};
use crate::expression::{Condition, Expr, Node, Pool, Seam};
use crate::theory::Kernel;

/// Number of special points tested before any proof, and, as `MORE_POINTS`, where a proof fails.
const FIRST_POINTS: usize = 24;
const MORE_POINTS: usize = 600;

/// Largest number of conditions that guard a form.
const MOST_GUARDS: usize = 3;

/// Largest number of conditions of the formula that a condition of the form is compared with.
const MOST_COMPARED: usize = 8;

/// Verdict on whether a form is defined wherever its formula is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Definedness {
    /// The form has a value wherever the formula has one.
    Kept,
    /// At an exact point the form has no value, or a different one.
    Broken(Breach),
    /// The form was not shown to have a value.
    Undecided {
        /// Reason, such as the condition that was not shown.
        reason: UnknownReason,
    },
}

/// An exact point at which a form does not have the value of the formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Breach {
    pub(crate) point: Vec<(String, String)>,
    /// The value of the formula.
    pub(crate) formula: String,
    /// The value of the form, or the operation in it that has no value.
    pub(crate) form: Result<String, String>,
}

impl Breach {
    /// ``at x = 0: the formula is 1, the form has no value: `1/x` is not defined``
    pub(crate) fn text(&self) -> String {
        let point: Vec<String> = self.point.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        let place = if point.is_empty() { "everywhere".into() } else { format!("at {}", point.join(", ")) };
        match &self.form {
            Ok(value) => format!("{place}: the formula is {}, the form is {value}", self.formula),
            Err(part) => {
                format!(
                    "{place}: the formula is {}, the form has no value: `{part}` is not defined",
                    self.formula
                )
            }
        }
    }

    pub(crate) fn witness(&self) -> Witness {
        Witness {
            conditions: Vec::new(),
            point: self.point.clone(),
            component: String::new(),
            left: self.formula.clone(),
            right: self.form.clone().unwrap_or_else(|_| "undefined".into()),
            difference: String::new(),
            ratio: None,
        }
    }
}

/// Returns a point among the first special points at which the form does not have the formula's
/// value.
pub(super) fn first_breach(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> Option<Breach> {
    breach(pool, kernel, form, &[], FIRST_POINTS)
}

/// Returns such a point from a longer sequence of special points.
pub(super) fn any_breach(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> Option<Breach> {
    breach(pool, kernel, form, &[], MORE_POINTS)
}

/// Whether `after` has a value wherever `before` has one and the conditions hold.
pub(crate) fn is_kept(pool: &mut Pool, conditions: &[Condition], before: Expr, after: Expr) -> bool {
    let Some(obligations) = obligations(pool, &[after]) else { return false };
    open_obligations(pool, conditions, before, obligations).is_ok_and(|open| open.is_empty())
}

/// Whether a form is shown to have a value wherever the kernel's formula has one, on its domain.
pub(super) fn is_kept_by_form(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> bool {
    not_shown(pool, kernel, form).is_ok_and(|open| open.is_empty())
}

/// Decides whether a form has a value wherever the kernel's formula has one, on its domain.
pub(crate) fn of_form(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> Definedness {
    let open = match not_shown(pool, kernel, form) {
        Ok(open) if open.is_empty() => return Definedness::Kept,
        Ok(open) => open,
        Err(reason) => return Definedness::Undecided { reason: reason.into() },
    };
    let zeros: Vec<Expr> = open
        .iter()
        .flat_map(|obligation| obligation.ways.iter().flatten())
        .map(|condition| pool.subtract(condition.left, condition.right))
        .collect();
    if let Some(breach) = breach(pool, kernel, form, &zeros, MORE_POINTS) {
        return Definedness::Broken(breach);
    }
    let Obligation { part, ways, .. } = &open[0];
    let conditions: Vec<String> = ways[0].iter().map(|condition| condition.text(pool)).collect();
    let reason = KernelReason::Undefined { condition: conditions.join(", "), part: pool.text(*part) };
    Definedness::Undecided { reason: reason.into() }
}

/// Returns the form with the formula in its place wherever the form is not shown to be defined:
/// `if c { form } else { formula }`, in the branch where it is needed. `None` if that takes too
/// many conditions.
pub(crate) fn guarded(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> Option<Vec<Expr>> {
    let mut found = Vec::new();
    for (&form, &formula) in form.iter().zip(&kernel.outputs) {
        let open = match obligations(pool, &[form]) {
            Some(obligations) if form != formula => {
                open_obligations(pool, &kernel.domain, formula, obligations).ok()?
            }
            Some(_) => Vec::new(),
            None => return None,
        };
        let mut guards: Vec<Guard> = Vec::new();
        for obligation in open {
            for condition in &obligation.ways[0] {
                let guard = Guard { path: obligation.path.clone(), condition: *condition };
                if is_piecewise(pool, condition) {
                    return None;
                }
                if !guards.contains(&guard) {
                    guards.push(guard);
                }
            }
        }
        if guards.len() > MOST_GUARDS {
            return None;
        }
        found.push(with_guards(pool, form, formula, &guards));
    }
    Some(found)
}

/// Condition that a form needs, and the branch conditions on the path to the operation that needs
/// it.
#[derive(Clone, PartialEq)]
struct Guard {
    path: Vec<Condition>,
    condition: Condition,
}

fn is_piecewise(pool: &Pool, condition: &Condition) -> bool {
    let parts = pool.reachable(&[condition.left, condition.right]);
    parts.iter().any(|&inner| matches!(pool.node(inner), Node::Select { .. }))
}

/// Guards a form in the branches that the paths lead to; a condition that belongs to no branch
/// guards the whole form.
fn with_guards(pool: &mut Pool, form: Expr, formula: Expr, guards: &[Guard]) -> Expr {
    let (mut whole, mut guarded) = (Vec::new(), form);
    if let Node::Select { left, relation, right, then, otherwise, seam } = *pool.node(form) {
        let condition = Condition { left, relation, right };
        let choices = [vec![condition], negated(&condition)];
        let mut inner: [Vec<Guard>; 2] = Default::default();
        for guard in guards {
            match choices.iter().position(|choice| guard.path.starts_with(choice)) {
                Some(branch) => {
                    let path = guard.path[choices[branch].len()..].to_vec();
                    inner[branch].push(Guard { path, condition: guard.condition });
                }
                None => whole.push(guard.condition),
            }
        }
        let then = with_guards(pool, then, formula, &inner[0]);
        let otherwise = with_guards(pool, otherwise, formula, &inner[1]);
        guarded = pool.select((left, relation, right), then, otherwise, seam);
    } else {
        whole.extend(guards.iter().map(|guard| guard.condition));
    }
    whole
        .iter()
        .rev()
        .fold(guarded, |form, c| pool.select((c.left, c.relation, c.right), form, formula, Seam::Jumps))
}

/// Returns the obligations of a form that are not shown to hold wherever its formula has a value.
fn not_shown(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> Result<Vec<Obligation>, KernelReason> {
    let mut open: Vec<Obligation> = Vec::new();
    for (&form, &formula) in form.iter().zip(&kernel.outputs) {
        if form != formula {
            let Some(obligations) = obligations(pool, &[form]) else {
                return Err(KernelReason::Paths(MOST_PATHS));
            };
            let found = open_obligations(pool, &kernel.domain, formula, obligations)?;
            open.extend(
                found.into_iter().filter(|obligation| !open.contains(obligation)).collect::<Vec<_>>(),
            );
        }
    }
    Ok(open)
}

/// Returns the obligations that do not follow from the domain and from the conditions under which
/// the formula has a value.
fn open_obligations(
    pool: &mut Pool,
    domain: &[Condition],
    formula: Expr,
    obligations: Vec<Obligation>,
) -> Result<Vec<Obligation>, KernelReason> {
    let mut open = Vec::new();
    for obligation in obligations {
        // all expressions without conditionals, piece by piece
        let mut expressions = vec![formula];
        let conditions: Vec<Condition> =
            domain.iter().chain(&obligation.path).chain(obligation.ways.iter().flatten()).copied().collect();
        expressions.extend(conditions.iter().flat_map(|condition| [condition.left, condition.right]));
        let Some(pieces) = pieces(pool, &expressions, |_, _, _| false) else {
            return Err(KernelReason::Pieces(MOST_PIECES));
        };
        let stated = domain.len() + obligation.path.len();
        let follows = pieces.into_iter().all(|piece| {
            let sides = piece.expressions[1..].chunks_exact(2).zip(&conditions);
            let images: Vec<Condition> = sides
                .map(|(side, condition)| Condition { left: side[0], right: side[1], ..*condition })
                .collect();
            let (known, wanted) = images.split_at(stated);
            let mut known: Vec<Condition> = known.to_vec();
            known.extend(&piece.path);
            let sides: Vec<Expr> = known.iter().flat_map(|c| [c.left, c.right]).collect();
            known.extend(obligation::domain(pool, &[piece.expressions[0]]));
            known.extend(obligation::domain(pool, &sides));
            let mut wanted = wanted.iter().copied();
            let ways: Vec<Vec<Condition>> =
                obligation.ways.iter().map(|way| wanted.by_ref().take(way.len()).collect()).collect();
            excludes_itself(&known) || Known::new(pool, known).imply_one(&ways)
        });
        if !follows && !is_of_the_formula(pool, domain, formula, &obligation) {
            open.push(obligation);
        }
    }
    Ok(open)
}

/// Whether the formula has the same obligation in another form: the sides of one of its conditions
/// and the sides of the obligation have equal differences.
fn is_of_the_formula(pool: &mut Pool, domain: &[Condition], formula: Expr, obligation: &Obligation) -> bool {
    let [wanted] = obligation.ways[0][..] else { return false };
    let Some(stated) = obligations(pool, &[formula]) else { return false };
    let stated: Vec<Condition> = stated
        .into_iter()
        .filter(|stated| stated.path.is_empty())
        .flat_map(|stated| stated.ways[0].clone())
        .filter(|condition| condition.relation == wanted.relation)
        .take(MOST_COMPARED)
        .collect();
    let conditions: Vec<Condition> = domain.iter().chain(&obligation.path).copied().collect();
    stated.iter().any(|condition| {
        let [wanted, stated] = [&wanted, condition].map(|c| pool.subtract(c.left, c.right));
        equality(pool, &[(wanted, stated)], &conditions, EFFORT).is_proved()
    })
}

/// Whether a condition occurs together with its complement.
fn excludes_itself(conditions: &[Condition]) -> bool {
    conditions.iter().any(|a| {
        let is_opposite = |b: &Condition| {
            (a.left, a.right) == (b.left, b.right) && a.relation.complement() == Some(b.relation)
        };
        conditions.iter().any(is_opposite)
    })
}

/// Searches the special points of the domain for one at which the form does not have the value of
/// the formula.
fn breach(pool: &mut Pool, kernel: &Kernel, form: &[Expr], zeros: &[Expr], count: usize) -> Option<Breach> {
    let mut zeros = zeros.to_vec();
    for condition in &kernel.domain {
        zeros.push(pool.subtract(condition.left, condition.right));
    }
    let mut expressions = kernel.outputs.clone();
    expressions.extend(form);
    expressions.extend(kernel.domain.iter().flat_map(|c| [c.left, c.right]));
    let mut points = SpecialPoints::new(pool, &kernel.arguments, &expressions, &zeros);
    let (mut point, mut breach) = (0..count).find_map(|_| {
        let point = points.next(pool);
        let breach = breach_at(pool, kernel, form, &point)?;
        Some((point, breach))
    })?;
    // a simpler point explains more
    for &argument in &kernel.arguments {
        for simpler in points.simpler(pool, argument, point[&argument]) {
            let mut other = point.clone();
            other.insert(argument, simpler);
            if let Some(found) = breach_at(pool, kernel, form, &other) {
                (point, breach) = (other, found);
                break;
            }
        }
    }
    Some(breach)
}

fn breach_at(pool: &mut Pool, kernel: &Kernel, form: &[Expr], point: &Point) -> Option<Breach> {
    let mut values = Vec::new();
    let mut at = ExactPoint::new(pool, point);
    // a coordinate that was solved for can itself be undefined
    if point.values().any(|&coordinate| at.value(coordinate).is_err()) {
        return None;
    }
    for condition in &kernel.domain {
        if at.holds(condition) != Ok(true) {
            return None;
        }
    }
    for (&formula, &form) in kernel.outputs.iter().zip(form) {
        if formula != form
            && let Ok(expected) = at.value(formula)
        {
            values.push((expected, at.value(form)));
        }
    }
    for (expected, found) in values {
        let form = match found {
            Ok(value) => {
                let difference = pool.subtract(expected, value);
                if sign_of(pool, difference).is_none_or(std::cmp::Ordering::is_eq) {
                    continue;
                }
                Ok(digits(pool, value))
            }
            Err(NoValue::Undefined(part)) => Err(pool.text(part)),
            Err(NoValue::Unknown) => continue,
        };
        let name = |&argument: &_| (pool.symbol_name(argument).to_string(), pool.text(point[&argument]));
        let point = kernel.arguments.iter().map(name).collect();
        return Some(Breach { point, formula: digits(pool, expected), form });
    }
    None
}
