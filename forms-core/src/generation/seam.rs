//! Seams: where the condition of an `if` begins to hold, its two branches have to agree.
//!
//! On the boundary a = b of a relation a < b the branches are compared like the sides of a
//! statement, under the kernel's own conditions and the conditions on the path to the `if`. The
//! boundary is described by one of its parts in terms of the others, so that no equation is ever
//! assumed, only substituted. If a branch is not defined on the boundary, as sin(x)/x at 0, its
//! limit there is compared with the value of the other branch.

use super::boundary::{Sheet, Solution, replaced, sheets};
use super::fault::{Claim, Fault};
use super::limit::{follow, limit};
use super::pieces::{MOST_PIECES, negated, pieces};
use crate::decide::{
    Budget, Equations, Finding, KernelReason, UnknownReason, Witness, contradiction, simplified,
};
use crate::diagnostic::Diagnostic;
use crate::expression::{Condition, Expr, Node, Pool, Seam};
use crate::theory::Kernel;
use rustc_hash::FxHashSet;
use std::cmp::Ordering;

/// Budget for one seam. A seam is a claim of its author like a statement, but one kernel can have
/// many.
const EFFORT: Budget = Budget { work: 10_000_000, candidates: 200, points: 20 };

/// Largest number of seams of one kernel that are examined; the same `if` on another path counts
/// again.
const MOST_SEAMS: usize = 256;

/// Conditional of a kernel.
struct Choice {
    condition: Condition,
    then: Expr,
    otherwise: Expr,
}

/// Result of the comparison on a seam.
enum Agreement {
    Agrees,
    Differs(Witness),
    Undecided(UnknownReason),
}

/// Returns the faults of a kernel's seams: the seams at which its pieces are not shown to agree.
pub(super) fn faults(pool: &mut Pool, kernel: &Kernel) -> Vec<Fault> {
    let claims = with_claims(pool, &kernel.outputs);
    let (mut faults, mut seams) = (Vec::new(), 0);
    let mut seen: FxHashSet<(Expr, Vec<Condition>)> = FxHashSet::default();
    let mut open: Vec<(Expr, Vec<Condition>)> =
        kernel.outputs.iter().rev().map(|&output| (output, Vec::new())).collect();
    while let Some((expression, path)) = open.pop() {
        if !claims.contains(&expression) || !seen.insert((expression, path.clone())) {
            continue;
        }
        let Node::Select { left, relation, right, then, otherwise, seam } = *pool.node(expression) else {
            open.extend(outermost_choices(pool, expression).into_iter().map(|inner| (inner, path.clone())));
            continue;
        };
        seams += 1;
        if seams > MOST_SEAMS {
            let message = format!("`{}` has more than {MOST_SEAMS} seams", kernel.name);
            faults.push(Fault::told(&kernel.name, Claim::Seam, Diagnostic::new(kernel.span, message)));
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

/// Returns the expressions that contain an `if` whose branches have to agree.
fn with_claims(pool: &Pool, expressions: &[Expr]) -> FxHashSet<Expr> {
    let mut found: FxHashSet<Expr> = FxHashSet::default();
    for expression in pool.reachable(expressions) {
        let node = pool.node(expression);
        let mut claims = matches!(node, Node::Select { seam: Seam::Agrees, .. });
        node.for_each_operand(|operand| claims |= found.contains(&operand));
        if claims {
            found.insert(expression);
        }
    }
    found
}

/// Returns every `if` that an expression contains outside the other ones.
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
    fn fault(&self, pool: &mut Pool, assumed: &[Condition], kernel: &Kernel) -> Option<Fault> {
        for sheet in sheets(pool, &self.condition) {
            let agreement = self.on_sheet(pool, &sheet, assumed);
            let place = format!("the seam {} of `{}`", sheet.text(pool), kernel.name);
            let condition = self.condition.text(pool);
            let help = "write `if jump` where the branches are allowed to differ";
            let diagnostic = |message: String| Diagnostic::new(kernel.span, message).with_help(help);
            return Some(match agreement {
                Agreement::Agrees => continue,
                Agreement::Differs(witness) => {
                    let message = format!(
                        "the branches of `if {condition}` differ at {place}: their difference is {}\n{}",
                        witness.difference,
                        values(&witness)
                    );
                    Fault::refuted(&kernel.name, Claim::Seam, witness, diagnostic(message))
                }
                Agreement::Undecided(reason) => {
                    let message = format!(
                        "cannot decide whether the branches of `if {condition}` agree at {place}: {reason}"
                    );
                    Fault::unknown(&kernel.name, Claim::Seam, reason, diagnostic(message))
                }
            });
        }
        None
    }

    /// Decides whether the branches agree on a sheet, by the first description of the sheet that
    /// shows it.
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
        Agreement::Undecided(undecided.unwrap_or(KernelReason::UnsolvedSeam.into()))
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
            let put_in = (solution.part, *value);
            let mut agreement = self.where_defined(pool, put_in, &conditions);
            if matches!(agreement, Agreement::Undecided(_))
                && let Some(by_limits) = self.by_limits(pool, put_in, &conditions)
            {
                agreement = by_limits;
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
    /// Compares the branches with a value substituted for a part, if they are defined there as
    /// written: 0·(1/0) is not, although it becomes 0 by substitution.
    fn where_defined(&self, pool: &mut Pool, put_in: (Expr, Expr), conditions: &[Condition]) -> Agreement {
        let branches = [self.then, self.otherwise];
        let (values, mut known) = replaced(pool, put_in, &branches, conditions);
        let domain = pool.domain(&branches);
        let (_, domain) = replaced(pool, put_in, &[], &domain);
        if is_excluded(pool, &domain, &known) {
            return Agreement::Undecided(KernelReason::UndefinedBranch(None).into());
        }
        known.extend(domain);
        compare(pool, values[0], values[1], &known)
    }

    /// Compares the branches by limits: the branch that applies on the seam has a value there, the
    /// other tends to it.
    fn by_limits(
        &self,
        pool: &mut Pool,
        (part, value): (Expr, Expr),
        conditions: &[Condition],
    ) -> Option<Agreement> {
        let Node::Symbol(variable) = *pool.node(part) else { return None };
        let branches = [self.then, self.otherwise];
        let is_piecewise = |part: &Expr| matches!(pool.node(*part), Node::Select { .. });
        if pool.reachable(&branches).iter().any(is_piecewise) {
            return None;
        }
        let then_applies = self.condition.relation.admits(Ordering::Equal);
        let (own, other) =
            if then_applies { (self.then, self.otherwise) } else { (self.otherwise, self.then) };
        let (values, known) = replaced(pool, (part, value), &[own], conditions);
        let domain = pool.domain(&[own]);
        let (_, domain) = replaced(pool, (part, value), &[], &domain);
        if !follow(pool, &domain, &known) {
            return None;
        }
        let limit = limit(pool, other, (variable, value), &known)?;
        let (then, otherwise) = if then_applies { (values[0], limit) } else { (limit, values[0]) };
        Some(compare(pool, then, otherwise, &known))
    }
}

/// Whether the conditions contradict the known ones, while the known ones do not contradict each
/// other.
pub(super) fn is_excluded(pool: &mut Pool, conditions: &[Condition], known: &[Condition]) -> bool {
    let open: Vec<Condition> =
        conditions.iter().filter(|condition| condition.decided(pool) != Some(true)).copied().collect();
    if open.is_empty() {
        return false;
    }
    let all: Vec<Condition> = known.iter().chain(&open).copied().collect();
    contradiction(pool, &all).is_some() && contradiction(pool, known).is_none()
}

/// Compares two expressions wherever the conditions hold, piece by piece.
fn compare(pool: &mut Pool, left: Expr, right: Expr, conditions: &[Condition]) -> Agreement {
    let mut expressions = vec![left, right];
    expressions.extend(conditions.iter().flat_map(|condition| [condition.left, condition.right]));
    let Some(pieces) = pieces(pool, &expressions, |_, _, _| false) else {
        return Agreement::Undecided(KernelReason::BranchPieces(MOST_PIECES).into());
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
                // the seam lies nowhere in the domain, or a branch is not defined on it
                if contradiction(pool, &assumed).is_none() {
                    return Agreement::Undecided(KernelReason::UndefinedBranch(Some(reason)).into());
                }
            }
        }
    }
    Agreement::Agrees
}

/// Formats the point, and the value of each branch there.
fn values(witness: &Witness) -> String {
    let point: Vec<String> = witness.point.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    if witness.left == witness.right {
        // they differ beyond the digits that are shown
        return format!(
            "at {}: both branches print as {}, and differ in later digits",
            point.join(", "),
            witness.left
        );
    }
    format!(
        "at {}: {} in the branch where the condition holds, {} in the other",
        point.join(", "),
        witness.left,
        witness.right
    )
}
