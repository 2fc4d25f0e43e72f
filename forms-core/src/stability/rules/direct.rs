//! Direct rewriting: the form that rules give without samples, for kernels for which no form was
//! chosen.
//!
//! It uses those rules whose result is at no argument less accurate than the expression it
//! replaces. Each step is proved on its own: the result is defined wherever the replaced expression
//! is, and both are equal wherever both are defined.

use super::{Rewriting, exponential, fractions, radical, sums, trigonometric};
use crate::decide::{Budget, Equations, Finding};
use crate::expression::{Condition, Expr, Node, Operation, Pool, Substitution, SymbolKind};
use crate::generation::is_kept;
use crate::theory::Kernel;
use rustc_hash::{FxHashMap, FxHashSet};

/// Proof budget of a step. Both sides of a step are small; a step that needs more is not made.
const EFFORT: Budget = Budget { work: 200_000, candidates: 24, points: 4 };

/// Maximum number of operations of an expression to be rewritten: a step is found and proved during
/// macro expansion.
const LONGEST: usize = 80;

/// Maximum number of passes over a form: one step can enable another.
const ROUNDS: usize = 6;

/// Rule, and a predicate that selects those results that are never less accurate than the replaced
/// expression.
type Direct =
    (fn(&mut Rewriting<'_>, Expr) -> Vec<Expr>, fn(&mut Rewriting<'_>, before: Expr, after: Expr) -> bool);

const DIRECT: &[Direct] = &[
    (exponential::less_one, |_, _, _| true),
    (exponential::hyperbolic, |_, _, _| true),
    (exponential::over_less_one, |_, _, _| true),
    (exponential::near_one, is_logarithm_beside_one),
    (exponential::logarithms, has_a_number_above),
    (trigonometric::versine, |_, _, _| true),
    (trigonometric::half_angle, |_, _, _| true),
    (trigonometric::differences, is_by_an_exact_half),
    (trigonometric::arc_tangents, has_a_number_above),
    (sums::factored, is_of_squares),
    (radical::conjugate, is_a_difference_with_a_number_above),
    (fractions::over_one_denominator, has_a_number_above),
];

/// Rules whose result contains the formula as one of its pieces. They are applied in one pass after
/// the others, to operands before results.
const LAST: &[Direct] = &[(radical::beside_its_root, |_, _, _| true)];

/// Returns the form that the rules give for each output of a kernel; empty if that is the formula,
/// or if the kernel's declaration fixes how it is computed.
pub(crate) fn by_rules(pool: &mut Pool, kernel: &Kernel) -> Vec<Expr> {
    if kernel.has_form() {
        return Vec::new();
    }
    let mut direct = Steps { rules: DIRECT, settled: FxHashSet::default() };
    let mut form = kernel.outputs.clone();
    for _ in 0..ROUNDS {
        let next = direct.round(pool, &kernel.domain, &form);
        if next == form {
            break;
        }
        form = next;
    }
    form = Steps { rules: LAST, settled: FxHashSet::default() }.upwards(pool, &kernel.domain, &form);
    if form == kernel.outputs { Vec::new() } else { form }
}

/// Rewriting steps by a set of rules.
struct Steps {
    rules: &'static [Direct],
    /// Expressions that are a piece of their own replacement, and are not rewritten there again.
    settled: FxHashSet<Expr>,
}

impl Steps {
    /// Makes one step at every operation that has one. The operands of such an operation wait for
    /// the next round, since a step of theirs could hide the first one.
    fn round(&mut self, pool: &mut Pool, conditions: &[Condition], form: &[Expr]) -> Vec<Expr> {
        let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
        for expression in pool.reachable(form) {
            let image = self.step(pool, conditions, expression).unwrap_or_else(|| {
                let node = pool.node(expression).clone();
                pool.image(expression, node, &images)
            });
            images.insert(expression, image);
        }
        form.iter().map(|output| images[output]).collect()
    }

    /// Makes one step at every operation that has one, after its operands.
    fn upwards(&mut self, pool: &mut Pool, conditions: &[Condition], form: &[Expr]) -> Vec<Expr> {
        let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
        for expression in pool.reachable(form) {
            let node = pool.node(expression).clone();
            let image = pool.image(expression, node, &images);
            images.insert(expression, self.step(pool, conditions, image).unwrap_or(image));
        }
        form.iter().map(|output| images[output]).collect()
    }

    /// Returns the first proved result of a rule. Each conditional (`Select`) is replaced by a
    /// variable for the proof: an equation that holds for every value holds for the value of the
    /// conditional, and the prover can do more with a variable.
    fn step(&mut self, pool: &mut Pool, conditions: &[Condition], expression: Expr) -> Option<Expr> {
        if self.settled.contains(&expression) {
            return None;
        }
        let (before, choices) = without_choices(pool, expression)?;
        let after = self.proved(pool, conditions, before)?;
        let is_piece = other_than(pool, before, after) != after;
        let after = pool.substitute(after, &choices);
        if is_piece {
            self.settled.insert(expression);
        }
        Some(after)
    }

    /// Returns the first result of a rule for an expression without conditionals, if it is proved.
    fn proved(&self, pool: &mut Pool, conditions: &[Condition], before: Expr) -> Option<Expr> {
        let mut rewriting = Rewriting::new(pool, conditions);
        let found = self.rules.iter().find_map(|(rule, is_never_worse)| {
            let proposed = rule(&mut rewriting, before);
            proposed
                .into_iter()
                .find(|&after| after != before && is_never_worse(&mut rewriting, before, after))
        })?;
        let other = other_than(pool, before, found);
        let finding = Equations { sides: &[(before, other)], conditions }.decide(pool, EFFORT);
        let is_proved = matches!(finding, Finding::Equal { .. }) && is_kept(pool, conditions, before, found);
        is_proved.then_some(found)
    }
}

/// Replaces each conditional by a variable; returns the result and the conditionals of these
/// variables. `None` if the expression outside of conditionals is too long.
fn without_choices(pool: &mut Pool, expression: Expr) -> Option<(Expr, Substitution)> {
    let (mut open, mut count) = (vec![expression], 0);
    let (mut parts, mut choices) = (FxHashMap::default(), Substitution::default());
    while let Some(part) = open.pop() {
        count += 1;
        if count > LONGEST {
            return None;
        }
        match pool.node(part) {
            Node::Select { .. } if parts.contains_key(&part) => {}
            Node::Select { .. } => {
                let symbol = pool.declare_symbol("choice", SymbolKind::Local);
                parts.insert(part, pool.symbol(symbol));
                choices.insert(symbol, part);
            }
            node => node.for_each_operand(|operand| open.push(operand)),
        }
    }
    let outside = if parts.is_empty() { expression } else { pool.replace(expression, &parts) };
    Some((outside, choices))
}

/// Returns the piece of a form that differs from the formula, if all others are the formula.
fn other_than(pool: &Pool, formula: Expr, form: Expr) -> Expr {
    match *pool.node(form) {
        Node::Select { then, otherwise, .. } if otherwise == formula => other_than(pool, formula, then),
        Node::Select { then, otherwise, .. } if then == formula => other_than(pool, formula, otherwise),
        _ => form,
    }
}

/// Accepts log(1 + u) = log1p u, with u unchanged.
fn is_logarithm_beside_one(rewriting: &mut Rewriting<'_>, before: Expr, after: Expr) -> bool {
    let Some(sum) = rewriting.argument_of(Operation::Log, before) else { return false };
    let beside = exponential::beside_one(rewriting, sum);
    beside.is_some() && rewriting.argument_of(Operation::Log1p, after) == beside
}

/// Accepts a result in which the cancelling expression has become a number: the numerator of a
/// quotient, or of an argument of log1p, atan or atan2.
fn has_a_number_above(rewriting: &mut Rewriting<'_>, before: Expr, after: Expr) -> bool {
    let after = other_than(rewriting.pool, before, after);
    let (_, core) = rewriting.scaled(after);
    let ratio = match rewriting.pool.node(core) {
        Node::Apply(Operation::Log1p | Operation::Atan | Operation::Atan2, arguments) => arguments[0],
        _ => after,
    };
    is_a_number_over_something(rewriting, ratio)
}

/// Whether the expression is c or c n/q with nonzero numbers c and n: a quotient in the numerator
/// of another could overflow.
fn is_a_number_over_something(rewriting: &Rewriting<'_>, ratio: Expr) -> bool {
    match *rewriting.pool.node(ratio) {
        Node::Negate(a) => is_a_number_over_something(rewriting, a),
        Node::Multiply(a, b) if !rewriting.varies(a) => is_a_number_over_something(rewriting, b),
        Node::Multiply(a, b) if !rewriting.varies(b) => is_a_number_over_something(rewriting, a),
        Node::Divide(a, _) => !rewriting.varies(a) && !rewriting.pool.is_zero(a),
        _ => !rewriting.varies(ratio) && !rewriting.pool.is_zero(ratio),
    }
}

/// Accepts √p − √q with p − q a number: for a sum of roots the other factor would cancel.
fn is_a_difference_with_a_number_above(rewriting: &mut Rewriting<'_>, before: Expr, after: Expr) -> bool {
    let Some((a, b)) = rewriting.two_terms(before) else { return false };
    let is_negative = |part: Expr| matches!(rewriting.pool.node(part), Node::Negate(_));
    is_negative(a) != is_negative(b) && has_a_number_above(rewriting, before, after)
}

/// Accepts f(b + h) − f(b), where h is a number or a variable, rewritten with the sine of h/2 and a
/// function of the midpoint.
fn is_by_an_exact_half(rewriting: &mut Rewriting<'_>, before: Expr, _: Expr) -> bool {
    let Some((first, second)) = rewriting.two_terms(before) else { return false };
    let [(_, p), (_, q)] = [first, second].map(|term| rewriting.scaled(term));
    let (Node::Apply(_, a), Node::Apply(_, b)) =
        (rewriting.pool.node(p).clone(), rewriting.pool.node(q).clone())
    else {
        return false;
    };
    let difference = rewriting.difference(a[0], b[0]);
    let (_, core) = rewriting.scaled(difference);
    matches!(rewriting.pool.node(core), Node::Symbol(_) | Node::Number(_) | Node::Pi)
        && matches!(rewriting.pool.node(b[0]), Node::Symbol(_))
}

/// Accepts a² − b² = (a − b)(a + b) with a and b unchanged, and neither of them a sum: in a
/// simplified difference, terms that were together in a or in b can cancel, or powers of factors
/// overflow.
fn is_of_squares(rewriting: &mut Rewriting<'_>, before: Expr, after: Expr) -> bool {
    let Some((a, b)) = rewriting.two_terms(before) else { return false };
    let Node::Negate(b) = *rewriting.pool.node(b) else { return false };
    let (Some(a), Some(b)) = (sums::root_of(rewriting, a), sums::root_of(rewriting, b)) else { return false };
    if [a, b].iter().any(|&root| matches!(rewriting.pool.node(root), Node::Add(..))) {
        return false;
    }
    let (difference, sum) = (rewriting.pool.subtract(a, b), rewriting.pool.add(a, b));
    after == rewriting.pool.multiply(difference, sum)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;

    /// Returns the form that the rules give for a formula, or the formula.
    fn form_of(formula: &str) -> String {
        let (mut theory, errors) = read_theory(&format!("kernel k(a, b, x) = {formula} where a > 0, b > 0;"));
        assert!(errors.is_empty(), "{errors:?}");
        let kernel = theory.kernels[0].clone();
        let form = by_rules(&mut theory.pool, &kernel);
        theory.pool.text(*form.first().unwrap_or(&kernel.outputs[0]))
    }

    #[test]
    fn what_cancels_is_rewritten() {
        for (formula, expected) in [
            ("exp(x) - 1", "expm1(x)"),
            ("(1 - exp(-a*b))/a", "-expm1(-a*b)/a"),
            ("exp(x) - exp(-x)", "2*sinh(x)"),
            ("log(1 + x)", "log1p(x)"),
            ("log(1 + x**2*a)", "log1p(x**2*a)"),
            ("log(a + 1) - log(a)", "(if a < 1e-300 { log1p(a) - log(a) } else { log1p(1/a) })"),
            ("log(a + 2) - log(a + 1)", "log1p(1/(a + 1))"),
            ("1 - cos(x)", "2*(sin(x/2)*sin(x/2))"),
            ("(1 - cos(x))/sin(x)", "tan(x/2)"),
            ("sin(x + a) - sin(x)", "2*(sin(a/2)*cos(x + a/2))"),
            ("atan(x + 1) - atan(x)", "atan2(1, 1 + (x + 1)*x)"),
            ("a**2 - b**2", "(a - b)*(a + b)"),
            ("1 - x**2", "(1 - x)*(1 + x)"),
            ("sqrt(a + 1) - sqrt(a)", "1/(sqrt(a + 1) + sqrt(a))"),
            (
                "x + sqrt(a**2 + x**2)",
                "(if jump abs(x + sqrt(a**2 + x**2)) < abs(sqrt(a**2 + x**2) - x)/4 { a**2/(sqrt(a**2 + x**2) - x) } else { x + sqrt(a**2 + x**2) })",
            ),
            ("exp(x)/(exp(x) - 1)", "-1/expm1(-x)"),
            ("1/(a + 1) - 1/a", "-1/((a + 1)*a)"),
            ("sqrt(1 - cos(x)**2) + b", "sqrt(sin(x)*sin(x)) + b"),
        ] {
            assert_eq!(form_of(formula), expected, "{formula}");
        }
    }

    #[test]
    fn what_may_lose_elsewhere_is_left_as_it_is() {
        for formula in [
            "sqrt(a) - sqrt(b)",
            "exp(a) - exp(b)",
            "log(a)",
            "log(a) - log(b)",
            "sin(a) - sin(b)",
            "1/a - 1/b",
            "x**2 + a**2",
            "a*x - b*x",
            "sqrt(a + 1) + sqrt(a)",
            "sqrt(a**2 + b**2)",
        ] {
            assert_eq!(form_of(formula), formula);
        }
    }
}
