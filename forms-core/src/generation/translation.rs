//! Translation validation: the optimised program is raised to an expression again and proved equal
//! to the formula. A form given after `by` is proved equal to the formula in the same way.
//!
//! The equation is decided like any other statement, on the kernel's domain and wherever both sides
//! are defined.

use super::boundary::{replaced, sheets};
use super::cuts::Cuts;
use super::opaque::{Depth, opaque};
use super::pieces::{MOST_PIECES, pieces};
use super::ratios::equal_by_ratios;
use super::roots::{with_one_root, with_roots};
use crate::decide::{Budget, Equations, Finding, KernelReason, UnknownReason, Witness};
use crate::diagnostic::Diagnostic;
use crate::expression::{Condition, Expr, Node, Pool, Relation};
use crate::kernel::Program;
use crate::theory::Kernel;
use std::fmt;

/// Budget for a kernel. A kernel is generated inside its user's compiler, so less is spent on it
/// than on a statement.
pub(super) const EFFORT: Budget = Budget { work: 2_000_000, candidates: 100, points: 12 };

/// Budget for a form given after `by`, which is a claim of its author like a statement.
pub(super) const FORM: Budget = Budget { work: 20_000_000, candidates: 300, points: 20 };

/// Verdict on the agreement of a program with its formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Translation {
    /// They are equal wherever both are defined.
    Proved,
    /// They differ at an exact point.
    Refuted(Witness),
    /// Neither was shown.
    Unknown {
        /// Reason why nothing was shown.
        reason: UnknownReason,
        /// Number of exact points at which both were enclosed and no difference was certain.
        points: usize,
    },
}

impl Translation {
    /// Whether the program is proved to compute its formula.
    pub fn is_proved(&self) -> bool {
        *self == Translation::Proved
    }

    /// Returns the error for a kernel whose program does not compute its formula.
    pub(super) fn objection(&self, kernel: &Kernel) -> Option<Diagnostic> {
        let Translation::Refuted(witness) = self else { return None };
        let message = format!(
            "internal error: the program generated for `{}` does not compute its formula\n{witness}",
            kernel.name
        );
        let help =
            "this is a fault of forms and not of the kernel; please report it with the kernel's source";
        Some(Diagnostic::new(kernel.span, message).with_help(help))
    }

    fn and(self, other: Translation) -> Translation {
        match (self, other) {
            (Translation::Refuted(witness), _) | (_, Translation::Refuted(witness)) => {
                Translation::Refuted(witness)
            }
            (Translation::Proved, other) | (other, Translation::Proved) => other,
            (Translation::Unknown { reason, points }, Translation::Unknown { points: others, .. }) => {
                Translation::Unknown { reason, points: points.min(others) }
            }
        }
    }
}

impl fmt::Display for Translation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Translation::Proved => write!(f, "Proved equal to its formula wherever both are defined."),
            Translation::Refuted(_) => write!(f, "Does not compute its formula."),
            Translation::Unknown { reason, points: 0 } => {
                write!(f, "Not proved equal to its formula: {reason}.")
            }
            Translation::Unknown { reason, points } => write!(
                f,
                "Not proved equal to its formula, only compared with it at {points} points: {reason}."
            ),
        }
    }
}

/// Raises the program and compares it with the kernel: its outputs on its domain, and the domain
/// itself.
pub(super) fn validate(pool: &mut Pool, kernel: &Kernel, program: &Program) -> Translation {
    let raised = program.raise(pool, &kernel.arguments);
    let sides = |condition: &Condition| [condition.left, condition.right];
    let written: Vec<Expr> = kernel.domain.iter().flat_map(sides).collect();
    // a program compares where the formula has the smaller or larger of two numbers
    let (written, formulas) =
        (pool.with_compared_extrema(&written), pool.with_compared_extrema(&kernel.outputs));
    let domain: Vec<(Expr, Expr)> = raised.domain.iter().flat_map(sides).zip(written).collect();
    let outputs: Vec<(Expr, Expr)> = raised.outputs.iter().copied().zip(formulas).collect();
    equality(pool, &domain, &[], EFFORT).and(equality(pool, &outputs, &kernel.domain, EFFORT))
}

/// Decides whether the sides of each pair are equal under the conditions. The first attempts do not
/// look inside conditionals or at least not inside functions, which suffices for most programs and
/// costs little; the last one does.
pub(super) fn equality(
    pool: &mut Pool,
    pairs: &[(Expr, Expr)],
    conditions: &[Condition],
    budget: Budget,
) -> Translation {
    let different: Vec<Expr> =
        pairs.iter().filter(|(raised, written)| raised != written).flat_map(|&(a, b)| [a, b]).collect();
    let closed = opaque(pool, &different, Depth::Choices);
    let mut cuts = Cuts::default();
    if closed.chunks_exact(2).all(|pair| cuts.are_equal(pool, &pair[..1], &pair[1..])) {
        return Translation::Proved;
    }
    let opaque = opaque(pool, &different, Depth::Functions);
    if by_pieces(pool, &opaque, &[], budget).is_proved() {
        return Translation::Proved;
    }
    let different = with_roots(pool, &different);
    let whole = by_pieces(pool, &different, conditions, budget);
    if !matches!(whole, Translation::Unknown { .. }) {
        return whole;
    }
    if by_operands(pool, &different, conditions, budget) || by_one_root(pool, &different, conditions, budget)
    {
        return Translation::Proved;
    }
    whole
}

/// Whether the two expressions are proved equal with each product of roots written as one root. The
/// one root is defined wherever the product is, and perhaps elsewhere: only a proof carries over.
fn by_one_root(pool: &mut Pool, different: &[Expr], conditions: &[Condition], budget: Budget) -> bool {
    let one_root = with_one_root(pool, different);
    one_root != different
        && (by_operands(pool, &one_root, conditions, budget)
            || by_pieces(pool, &one_root, conditions, budget).is_proved())
}

/// Whether the two expressions apply the same operation to operands that are proved equal, wherever
/// these are defined.
fn by_operands(pool: &mut Pool, different: &[Expr], conditions: &[Condition], budget: Budget) -> bool {
    let [a, b] = *different else { return false };
    let pairs = match (pool.node(a).clone(), pool.node(b).clone()) {
        (Node::Power(a, exponent), Node::Power(b, other)) if exponent == other => vec![(a, b)],
        (Node::Negate(a), Node::Negate(b)) => vec![(a, b)],
        (Node::Apply(operation, a), Node::Apply(other, b)) if operation == other => {
            a.iter().copied().zip(b.iter().copied()).collect()
        }
        (Node::Multiply(a, c), Node::Multiply(b, d))
        | (Node::Add(a, c), Node::Add(b, d))
        | (Node::Divide(a, c), Node::Divide(b, d))
            if a == b || c == d =>
        {
            vec![(a, b), (c, d)]
        }
        _ => return false,
    };
    pairs.into_iter().all(|(a, b)| a == b || equality(pool, &[(a, b)], conditions, budget).is_proved())
}

/// Decides whether each expression at an even index equals the next one under the conditions, piece
/// by piece.
fn by_pieces(pool: &mut Pool, different: &[Expr], conditions: &[Condition], budget: Budget) -> Translation {
    let mut expressions = different.to_vec();
    expressions.extend(conditions.iter().flat_map(|condition| [condition.left, condition.right]));
    let Some(pieces) = pieces(pool, &expressions, is_same_choice) else {
        return Translation::Unknown { reason: KernelReason::Pieces(MOST_PIECES).into(), points: 0 };
    };
    let mut seen = 0;
    let mut nowhere = KernelReason::NoPoint;
    let mut together = Translation::Proved;
    for piece in pieces {
        let (sides, bounds) = piece.expressions.split_at(different.len());
        let sides: Vec<(Expr, Expr)> = sides.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect();
        let mut assumed: Vec<Condition> = conditions
            .iter()
            .zip(bounds.chunks_exact(2))
            .map(|(condition, side)| Condition { left: side[0], right: side[1], ..*condition })
            .collect();
        assumed.extend(piece.path);
        if let Some(points) = equal_by_ratios(pool, &sides, &assumed, budget) {
            seen += points;
            continue;
        }
        match (Equations { sides: &sides, conditions: &assumed }).decide(pool, budget) {
            Finding::Equal { points } => seen += points,
            Finding::Empty(reason) => nowhere = KernelReason::DefinedNowhere(reason),
            Finding::Different(witness) => return Translation::Refuted(witness),
            Finding::Unknown { points, .. } if agree_on_boundary(pool, &sides, &assumed, budget) => {
                seen += points;
            }
            Finding::Unknown { reason, points } => {
                seen += points;
                together = together.and(Translation::Unknown { reason, points });
            }
        }
    }
    match together {
        Translation::Proved if seen == 0 => Translation::Unknown { reason: nowhere.into(), points: 0 },
        known => known,
    }
}

/// Whether the sides of each pair agree under conditions that include a ≤ b and a ≥ b: with the
/// solution of a = b substituted, they are equal wherever both are defined, or nowhere defined.
fn agree_on_boundary(
    pool: &mut Pool,
    sides: &[(Expr, Expr)],
    conditions: &[Condition],
    budget: Budget,
) -> bool {
    let opposite = |a: &Condition, b: &Condition| {
        let same = (a.left, a.right) == (b.left, b.right);
        let relations = if same { (a.relation, b.relation) } else { (a.relation, b.relation.mirrored()) };
        (same || (a.left, a.right) == (b.right, b.left))
            && relations == (Relation::LessEqual, Relation::GreaterEqual)
    };
    let found = conditions.iter().find(|a| conditions.iter().any(|b| opposite(a, b)));
    let Some(boundary) = found.copied() else { return false };
    sheets(pool, &boundary).iter().all(|sheet| {
        let solutions = sheet.solutions(pool, conditions);
        solutions.iter().filter(|solution| solution.is_complete).any(|solution| {
            solution.values.iter().all(|(value, more)| {
                let known: Vec<Condition> =
                    conditions.iter().chain(&sheet.conditions).chain(more).copied().collect();
                let pairs: Vec<Expr> = sides.iter().flat_map(|&(a, b)| [a, b]).collect();
                let (pairs, known) = replaced(pool, (solution.part, *value), &pairs, &known);
                let sides: Vec<(Expr, Expr)> = pairs.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect();
                let finding = Equations { sides: &sides, conditions: &known }.decide(pool, budget);
                matches!(finding, Finding::Equal { .. } | Finding::Empty(_))
            })
        })
    })
}

/// Whether two conditions are one: the same relation, and the differences of their sides proved
/// equal.
fn is_same_choice(pool: &mut Pool, a: &Condition, b: &Condition) -> bool {
    let [left, right] = [a, b].map(|condition| pool.subtract(condition.left, condition.right));
    let equations = Equations { sides: &[(left, right)], conditions: &[] };
    a.relation == b.relation && matches!(equations.decide(pool, EFFORT), Finding::Equal { .. })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;
    use crate::kernel::{Instruction, KernelSource, lower};
    use crate::theory::Theory;

    fn theory(source: &str) -> Theory {
        let (theory, errors) = read_theory(source);
        assert!(errors.is_empty(), "{errors:?}");
        theory
    }

    fn written(theory: &Theory) -> Program {
        let kernel = &theory.kernels[0];
        let source = KernelSource {
            name: kernel.name.clone(),
            arguments: kernel.arguments.clone(),
            outputs: kernel.outputs.clone(),
            domain: kernel.domain.clone(),
            ..KernelSource::default()
        };
        lower(&theory.pool, &source).expect("a kernel")
    }

    /// Returns the verdict on each program that has one of the kernel's instructions changed.
    fn with_one_changed(
        source: &str,
        changed: impl Fn(&Instruction) -> Option<Instruction>,
    ) -> Vec<Translation> {
        let mut theory = theory(source);
        let kernel = theory.kernels[0].clone();
        let program = written(&theory);
        let mut found = Vec::new();
        for place in 0..program.instructions().len() {
            let mut instructions = program.instructions().to_vec();
            if let Some(instruction) = changed(&instructions[place]) {
                instructions[place] = instruction;
                let wrong = program.with_instructions(instructions, |value| value);
                found.push(validate(&mut theory.pool, &kernel, &wrong));
            }
        }
        assert!(!found.is_empty(), "{source}");
        found
    }

    fn with_a_sign_lost(source: &str) -> Vec<Translation> {
        with_one_changed(source, |instruction| match *instruction {
            Instruction::Add(a, b) => Some(Instruction::Subtract(a, b)),
            _ => None,
        })
    }

    /// A sum of functions with coefficients that share sums, and with a conditional.
    const SUM_OF_FUNCTIONS: &str =
        "kernel k(a, b, c, d) = atan2((a + b)*(c - d), a*c + b*d)*(a*(b + c) + d*(b + c))
        + clausen(a*(c + d))*(a + b)**2/sqrt(a**2 + b**2 + 1)
        + (if jump a + d > b*c { log1p((a + b)**2)*(c + d) } else { clausen(c - a*d)*(a + b) });";

    #[test]
    fn a_sum_of_functions_that_lost_a_sign_or_has_another_coefficient_is_not_proved() {
        let lost = with_a_sign_lost(SUM_OF_FUNCTIONS);
        let doubled = with_one_changed(SUM_OF_FUNCTIONS, |instruction| match *instruction {
            Instruction::Multiply(a, b) if a != b => Some(Instruction::Multiply(a, a)),
            _ => None,
        });
        assert!(lost.iter().chain(&doubled).all(|translation| !translation.is_proved()));
        let (mut theory, regrouped) =
            (theory(SUM_OF_FUNCTIONS), written(&theory(SUM_OF_FUNCTIONS)).optimise());
        let kernel = theory.kernels[0].clone();
        assert!(validate(&mut theory.pool, &kernel, &regrouped).is_proved());
    }

    #[test]
    fn a_program_that_lost_a_sign_is_refuted() {
        for source in [
            "kernel k(x, y) = (x + y)*sqrt(1 + x**2);",
            "kernel k(x, y) = if x > y { x - y } else { 0 } where x + y > 0;",
            "kernel k(x, y) = (x, y + 1) where x + 2*y > 3;",
            "kernel k(x) = atan(x + 1)*log(2 + x**2);",
        ] {
            let found = with_a_sign_lost(source);
            let refuted = |translation: &Translation| matches!(translation, Translation::Refuted(_));
            assert!(found.iter().all(refuted), "{source}: {found:?}");
        }
    }

    #[test]
    fn a_program_with_its_branches_exchanged_is_refuted() {
        let mut theory = theory("kernel k(x, y) = if x > y { x - y } else { 0 };");
        let kernel = theory.kernels[0].clone();
        let program = written(&theory);
        let exchanged = program.instructions().iter().map(|instruction| match *instruction {
            Instruction::Select { left, relation, right, then, otherwise } => {
                Instruction::Select { left, relation, right, then: otherwise, otherwise: then }
            }
            ref other => other.clone(),
        });
        let wrong = program.with_instructions(exchanged.collect(), |value| value);
        assert!(matches!(validate(&mut theory.pool, &kernel, &wrong), Translation::Refuted(_)));
    }

    /// Compares two forms of a function of x.
    fn compared(kernels: &str) -> Translation {
        let mut theory = theory(kernels);
        let [kernel, other] = [0, 1].map(|place| theory.kernels[place].clone());
        let arguments = other.arguments.iter().zip(&kernel.arguments);
        let names = arguments.map(|(&other, &own)| (own, theory.pool.symbol(other))).collect();
        let pair = (other.outputs[0], theory.pool.substitute(kernel.outputs[0], &names));
        equality(&mut theory.pool, &[pair], &other.domain, EFFORT)
    }

    #[test]
    fn what_is_outside_the_class_is_not_called_proved() {
        // Ramanujan: (2^(1/3) − 1)^(1/3) = (1/9)^(1/3) − (2/9)^(1/3) + (4/9)^(1/3)
        let found = compared(
            "kernel k(x) = x*(2**(1/3) - 1)**(1/3);
             kernel l(x) = ((1/9)**(1/3) - (2/9)**(1/3) + (4/9)**(1/3))*x where x > 0;",
        );
        assert!(matches!(found, Translation::Unknown { points: 1.., .. }), "{found:?}");
        assert!(found.to_string().starts_with("Not proved equal to its formula, only compared"), "{found}");
    }

    #[test]
    fn what_takes_too_much_work_is_compared_at_points_and_not_called_proved() {
        let found = compared(
            "kernel k(x, y, z, s, t) =
                (x + y**2 + z**3 + s*t)**40*x + (x**2 - y**3 + z*s + t)**40;
             kernel l(x, y, z, s, t) =
                ((x + z**3)**2 + (y**2 + s*t)**2 + 2*(x + z**3)*(y**2 + s*t))**20*x
                + ((x**2 + t)**2 + (y**3 - z*s)**2 - 2*(x**2 + t)*(y**3 - z*s))**20;",
        );
        let Translation::Unknown { reason, points: 12 } = &found else { panic!("{found:?}") };
        assert!(matches!(reason, UnknownReason::TooLarge(_)), "{reason}");
        assert!(found.to_string().contains("only compared with it at 12 points: "), "{found}");
    }
}
