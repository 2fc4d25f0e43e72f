//! Seams: where the condition of an `if` begins to hold, its two branches have to agree.
//!
//! On the boundary a = b of a relation a < b the branches are compared like the sides of a statement, under the
//! kernel's own conditions and those on the path to the `if`. The boundary is described by one of its parts
//! in terms of the others, so that no equation is ever assumed, only substituted. A branch that is not defined on the
//! boundary, as sin(x)/x at 0, has its limit there compared with the value of the other.

use super::boundary::{Sheet, Solution, replaced, sheets};
use super::limit::{is_defined, limit};
use super::pieces::{negated, pieces};
use crate::decide::{Effort, Equations, Finding, Witness, contradiction, simplified};
use crate::diagnostic::Diagnostic;
use crate::expression::{Condition, Expr, Node, Pool, Seam};
use crate::resolve::Kernel;
use rustc_hash::FxHashSet;

/// A seam is a claim of its author like a statement, but one kernel may have many.
const EFFORT: Effort = Effort { work: 10_000_000, candidates: 200, points: 20 };

/// More seams of one kernel than this are not gone through; the same `if` on another path counts again.
const MOST_SEAMS: usize = 256;

/// An `if` of a kernel.
struct Choice {
    condition: Condition,
    then: Expr,
    otherwise: Expr,
}

/// What is found on a seam.
enum Agreement {
    Agrees,
    Differs(Witness),
    Undecided(String),
}

/// What is to be said of the seams of a kernel at which its pieces are not shown to agree.
pub(super) fn faults(pool: &mut Pool, kernel: &Kernel) -> Vec<Diagnostic> {
    let (mut faults, mut seams) = (Vec::new(), 0);
    let mut seen: FxHashSet<(Expr, Vec<Condition>)> = FxHashSet::default();
    let mut open: Vec<(Expr, Vec<Condition>)> =
        kernel.outputs.iter().rev().map(|&output| (output, Vec::new())).collect();
    while let Some((expression, path)) = open.pop() {
        if !seen.insert((expression, path.clone())) {
            continue;
        }
        let Node::Select { left, relation, right, then, otherwise, seam } = *pool.node(expression) else {
            open.extend(outermost_choices(pool, expression).into_iter().map(|inner| (inner, path.clone())));
            continue;
        };
        seams += 1;
        if seams > MOST_SEAMS {
            let message = format!("`{}` has more than {MOST_SEAMS} seams", kernel.name);
            faults.push(Diagnostic::new(kernel.span, message));
            break;
        }
        let condition = Condition { left, relation, right };
        if seam == Seam::Agrees {
            let assumed: Vec<Condition> = kernel.domain.iter().chain(&path).copied().collect();
            let choice = Choice { condition, then, otherwise };
            faults.extend(choice.fault(pool, &assumed, kernel));
        }
        let with = |more: Vec<Condition>| path.iter().copied().chain(more).collect::<Vec<_>>();
        open.push((otherwise, with(negated(&condition))));
        open.push((then, with(vec![condition])));
        open.extend([left, right].map(|side| (side, path.clone())));
    }
    faults
}

/// Every `if` that an expression contains outside the others.
fn outermost_choices(pool: &Pool, expression: Expr) -> Vec<Expr> {
    let mut found = Vec::new();
    let mut seen: FxHashSet<Expr> = FxHashSet::default();
    let mut open = vec![expression];
    while let Some(part) = open.pop() {
        if !seen.insert(part) {
            continue;
        }
        match pool.node(part) {
            Node::Select { .. } => found.push(part),
            node => node.for_each_operand(|operand| open.push(operand)),
        }
    }
    found.sort_unstable();
    found
}

impl Choice {
    fn fault(&self, pool: &mut Pool, assumed: &[Condition], kernel: &Kernel) -> Option<Diagnostic> {
        for sheet in sheets(pool, &self.condition) {
            let agreement = self.on_sheet(pool, &sheet, assumed);
            let place = format!("the seam {} of `{}`", sheet.text(pool), kernel.name);
            let message = match agreement {
                Agreement::Agrees => continue,
                Agreement::Differs(witness) => format!(
                    "the branches of `if {}` differ at {place}: their difference is {}\n{}",
                    self.condition.text(pool),
                    witness.difference,
                    values(&witness)
                ),
                Agreement::Undecided(reason) => format!(
                    "whether the branches of `if {}` agree at {place} is undecided: {reason}",
                    self.condition.text(pool)
                ),
            };
            let help = "say `jump` after `if` where the branches may differ";
            return Some(Diagnostic::new(kernel.span, message).with_help(help));
        }
        None
    }

    /// Whether the branches agree on a sheet: by the first description of it that shows so.
    fn on_sheet(&self, pool: &mut Pool, sheet: &Sheet, assumed: &[Condition]) -> Agreement {
        let mut undecided = None;
        for solution in sheet.solutions(pool, assumed) {
            match self.by_solution(pool, sheet, &solution, assumed) {
                Agreement::Agrees if solution.is_complete => return Agreement::Agrees,
                Agreement::Differs(witness) if solution.is_parametrisation => {
                    return Agreement::Differs(witness);
                }
                Agreement::Undecided(reason) if undecided.is_none() => undecided = Some(reason),
                _ => {}
            }
        }
        Agreement::Undecided(undecided.unwrap_or_else(|| "the seam could not be described".into()))
    }

    fn by_solution(
        &self,
        pool: &mut Pool,
        sheet: &Sheet,
        solution: &Solution,
        assumed: &[Condition],
    ) -> Agreement {
        for (value, conditions) in &solution.values {
            let conditions: Vec<Condition> =
                assumed.iter().chain(&sheet.conditions).chain(conditions).copied().collect();
            let branches = [self.then, self.otherwise];
            let (replaced, conditions) = replaced(pool, (solution.part, *value), &branches, &conditions);
            let mut agreement = compare(pool, replaced[0], replaced[1], &conditions);
            if matches!(agreement, Agreement::Undecided(_))
                && let Some((then, otherwise)) =
                    self.limits(pool, (solution.part, *value), (replaced[0], replaced[1]), &conditions)
            {
                agreement = compare(pool, then, otherwise, &conditions);
            }
            match agreement {
                Agreement::Agrees => {}
                Agreement::Differs(mut witness) => {
                    let value = simplified(pool, *value);
                    witness.point.insert(0, (pool.text(solution.part), pool.text(value)));
                    return Agreement::Differs(witness);
                }
                undecided => return undecided,
            }
        }
        Agreement::Agrees
    }
}

impl Choice {
    /// The values of both branches on a seam variable = value: of the one that applies there its own, of the other its
    /// limit. `replaced` are the branches with the value in the place of the variable.
    fn limits(
        &self,
        pool: &mut Pool,
        (part, value): (Expr, Expr),
        (then, otherwise): (Expr, Expr),
        conditions: &[Condition],
    ) -> Option<(Expr, Expr)> {
        let Node::Symbol(variable) = *pool.node(part) else { return None };
        let is_piecewise = |pool: &Pool, branch: Expr| {
            pool.reachable(&[branch]).iter().any(|&part| matches!(pool.node(part), Node::Select { .. }))
        };
        if is_piecewise(pool, self.then) || is_piecewise(pool, self.otherwise) {
            return None;
        }
        let then_applies = self.condition.relation.admits(std::cmp::Ordering::Equal);
        let (own, other) = if then_applies { (then, self.otherwise) } else { (otherwise, self.then) };
        if !is_defined(pool, own, conditions) {
            return None;
        }
        let limit = limit(pool, other, (variable, value), conditions)?;
        Some(if then_applies { (own, limit) } else { (limit, own) })
    }
}

/// Whether two expressions agree wherever the conditions hold, piece by piece.
fn compare(pool: &mut Pool, left: Expr, right: Expr, conditions: &[Condition]) -> Agreement {
    let mut expressions = vec![left, right];
    expressions.extend(conditions.iter().flat_map(|condition| [condition.left, condition.right]));
    let Some(pieces) = pieces(pool, &expressions, |_, _, _| false) else {
        return Agreement::Undecided("its branches have too many pieces".into());
    };
    for piece in pieces {
        let sides = piece.expressions[2..].chunks_exact(2);
        let mut assumed: Vec<Condition> = conditions
            .iter()
            .zip(sides)
            .map(|(condition, side)| Condition { left: side[0], right: side[1], ..*condition })
            .collect();
        assumed.extend(piece.path);
        let equations =
            Equations { sides: &[(piece.expressions[0], piece.expressions[1])], conditions: &assumed };
        match equations.decide(pool, EFFORT) {
            Finding::Equal { .. } => {}
            Finding::Different(witness) => return Agreement::Differs(witness),
            Finding::Unknown { reason, .. } => return Agreement::Undecided(reason),
            Finding::Empty(reason) => {
                // either the seam is nowhere in the domain, or a branch is not defined on it
                if contradiction(pool, &assumed).is_none() {
                    return Agreement::Undecided(format!("a branch is not defined there: {reason}"));
                }
            }
        }
    }
    Agreement::Agrees
}

/// The point, and the value of each branch there.
fn values(witness: &Witness) -> String {
    let point: Vec<String> = witness.point.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    format!(
        "at {}: {} from the side where it holds, {} from the other",
        point.join(", "),
        witness.left,
        witness.right
    )
}
