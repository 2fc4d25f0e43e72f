//! Effects: specialises a kernel into the lattice of kernels in which some of its effects vanish.
//!
//! ```text
//! kernel ─ an argument gets its value ─ decided conditionals are resolved ─▶ defined there: the formula with the value
//!                                                                        └─▶ not defined: its limit, from series
//!        ─ simplified, if cheaper and proved equal ─▶ kernel without the effect ─ the next effect ─▶ …
//! ```
//! A specialised kernel has the arguments of the full one, so that a program can select either at
//! run time. Its output is proved equal to the full formula under the conditions, or is the limit
//! of the formula there. A specialisation that cannot be proved is an error, never a kernel.

use super::boundary::replaced;
use super::definedness::is_kept;
use super::limit::{follow, holds, limit};
use super::pieces::negated;
use super::seam::is_excluded;
use super::translation::{EFFORT, equality};
use super::with_form;
use crate::decide::{contradiction, simplified};
use crate::diagnostic::Diagnostic;
use crate::expression::{Condition, Expr, Node, Pool};
use crate::kernel::{KernelSource, lower};
use crate::theory::{Effect, Kernel};
use rustc_hash::FxHashMap;

/// Kernel without some of its effects.
#[derive(Clone, Debug)]
pub struct Specialisation {
    /// For each effect of the full kernel, whether it is still present.
    pub present: Vec<bool>,
    /// The specialised kernel, which has the same arguments and no effects.
    pub kernel: Kernel,
}

/// Returns the specialisation of a kernel for every non-empty set of omitted effects, the smallest
/// sets first. Empty for a kernel without effects.
///
/// # Errors
/// If an effect vanishes nowhere in the kernel's domain, or the kernel is neither defined nor shown
/// to have a limit there.
pub fn specialisations(pool: &mut Pool, kernel: &Kernel) -> Result<Vec<Specialisation>, Vec<Diagnostic>> {
    let full = Specialisation { present: vec![true; kernel.effects.len()], kernel: kernel.clone() };
    let (mut found, mut faults) = (vec![full], Vec::new());
    for (place, effect) in kernel.effects.iter().enumerate() {
        let mut fault = None;
        for known in 0..found.len() {
            let mut present = found[known].present.clone();
            present[place] = false;
            match without(pool, &found[known].kernel, effect) {
                Ok(kernel) => found.push(Specialisation { present, kernel }),
                Err(diagnostic) => fault = fault.or(Some(diagnostic)),
            }
        }
        faults.extend(fault);
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    found.remove(0);
    found.iter_mut().for_each(|specialisation| specialisation.kernel.effects.clear());
    found.sort_by_key(|specialisation| specialisation.present.iter().filter(|present| !**present).count());
    Ok(found)
}

/// Specialises the kernel to where an effect vanishes.
fn without(pool: &mut Pool, kernel: &Kernel, effect: &Effect) -> Result<Kernel, Diagnostic> {
    // the kernel's own copy of the effect: its value has the values of effects omitted earlier
    // substituted
    let effect = &kernel.effects.iter().find(|own| own.variable == effect.variable).unwrap_or(effect).clone();
    let (variable, value) = (pool.symbol(effect.variable), effect.value);
    let condition = format!("{} = {}", pool.symbol_name(effect.variable), pool.text(value));
    let (_, domain) = replaced(pool, (variable, value), &[], &kernel.domain);
    if let Some(reason) = contradiction(pool, &domain) {
        let message = format!("`{}` is not defined at {condition}: {reason}", kernel.name);
        return Err(Diagnostic::new(effect.span, message).with_help(format!(
            "the domain of the kernel excludes the value at which the effect `{}` vanishes",
            effect.name
        )));
    }
    let mut outputs = Vec::new();
    for &output in &kernel.outputs {
        let Some(value) = value_at(pool, output, (variable, value), &domain) else {
            let message =
                format!("`{}` is neither defined nor shown to have a limit at {condition}", kernel.name);
            return Err(Diagnostic::new(effect.span, message)
                .with_help("the kernel needs a value or a limit where the effect vanishes"));
        };
        outputs.push(value);
    }
    let computed: Vec<Expr> = kernel
        .computed
        .iter()
        .map_while(|&form| {
            let chosen = with_choices_made(pool, form, (variable, value), &domain);
            defined_at(pool, chosen, (variable, value), &domain)
        })
        .collect();
    let computed = if computed.len() == outputs.len() { computed } else { Vec::new() };
    let mut effects = kernel.effects.clone();
    effects.retain(|other| other.variable != effect.variable);
    for other in &mut effects {
        other.value = replaced(pool, (variable, value), &[other.value], &[]).0[0];
    }
    let domain = domain.into_iter().filter(|condition| condition.decided(pool) != Some(true)).collect();
    let mut without = kernel.clone();
    (without.outputs, without.computed) = (outputs, computed);
    without.target_forms = Vec::new();
    (without.domain, without.effects) = (domain, effects);
    let mut without = at_less_cost(pool, without);
    without.formula = pool.texts(&without.outputs);
    Ok(without)
}

/// Evaluates an expression where a variable has a value: the expression there if it is defined, or
/// else its limit.
fn value_at(
    pool: &mut Pool,
    expression: Expr,
    (variable, value): (Expr, Expr),
    known: &[Condition],
) -> Option<Expr> {
    let chosen = with_choices_made(pool, expression, (variable, value), known);
    if let Some(defined) = defined_at(pool, chosen, (variable, value), known) {
        return Some(defined);
    }
    let Node::Symbol(symbol) = *pool.node(variable) else { return None };
    limit(pool, chosen, (symbol, value), known)
}

/// Evaluates an expression if it is defined there as written: 0·(1/0) is not, although it becomes 0
/// by substitution.
fn defined_at(pool: &mut Pool, expression: Expr, put_in: (Expr, Expr), known: &[Condition]) -> Option<Expr> {
    let domain = pool.domain(&[expression]);
    let (values, domain) = replaced(pool, put_in, &[expression], &domain);
    (!is_excluded(pool, &domain, known)).then(|| values[0])
}

/// Resolves every conditional of an expression that the value of a variable decides.
fn with_choices_made(pool: &mut Pool, expression: Expr, put_in: (Expr, Expr), known: &[Condition]) -> Expr {
    let mut decided: FxHashMap<Node, bool> = FxHashMap::default();
    for part in pool.reachable(&[expression]) {
        let Node::Select { left, relation, right, .. } = *pool.node(part) else { continue };
        let (_, there) = replaced(pool, put_in, &[], &[Condition { left, relation, right }]);
        let opposite = negated(&there[0]);
        if holds(pool, &there[0], known) {
            decided.insert(pool.node(part).clone(), true);
        } else if opposite.len() == 1 && follow(pool, &opposite, known) {
            decided.insert(pool.node(part).clone(), false);
        }
    }
    pool.replace_all(&[expression], |node, images| match node {
        Node::Select { then, otherwise, .. } => {
            decided.get(node).map(|&holds| images[if holds { then } else { otherwise }])
        }
        _ => None,
    })[0]
}

/// Replaces the formula of a kernel by its simplified form, if that costs less and is proved equal
/// to the formula.
fn at_less_cost(pool: &mut Pool, kernel: Kernel) -> Kernel {
    let outputs: Vec<Expr> = kernel.outputs.iter().map(|&output| simplified(pool, output)).collect();
    let Some(simple) = with_form(&kernel, &outputs) else { return kernel };
    let pairs: Vec<(Expr, Expr)> = outputs.into_iter().zip(kernel.outputs.iter().copied()).collect();
    let is_less = cost(pool, &simple) < cost(pool, &kernel);
    let is_kept = |pool: &mut Pool| {
        pairs.iter().all(|&(simple, formula)| is_kept(pool, &kernel.domain, formula, simple))
            && equality(pool, &pairs, &kernel.domain, EFFORT).is_proved()
    };
    if is_less && is_kept(pool) { simple } else { kernel }
}

/// Returns the cost of the kernel's formula, or `u32::MAX` if it cannot be lowered.
fn cost(pool: &Pool, kernel: &Kernel) -> u32 {
    let source = KernelSource {
        name: kernel.name.clone(),
        arguments: kernel.arguments.clone(),
        outputs: kernel.outputs.clone(),
        ..KernelSource::default()
    };
    lower(pool, &source).map_or(u32::MAX, |program| program.optimise().cost())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;
    use crate::decide::{Equations, Finding};
    use crate::theory::Theory;

    fn theory(source: &str) -> Theory {
        let (theory, errors) = read_theory(source);
        assert!(errors.is_empty(), "{source}: {errors:?}");
        theory
    }

    /// Returns the formulas of the specialisations of the only kernel.
    fn formulas(source: &str) -> Vec<(Vec<bool>, String)> {
        let mut theory = theory(source);
        let kernel = theory.kernels[0].clone();
        let found = specialisations(&mut theory.pool, &kernel).unwrap_or_else(|errors| panic!("{errors:?}"));
        found.into_iter().map(|one| (one.present, one.kernel.formula.join("; "))).collect()
    }

    #[test]
    fn a_kernel_without_an_effect_is_its_value_or_its_limit_there() {
        let without = |source: &str| formulas(source)[0].1.clone();
        for (what, source, expected) in [
            ("a value", "kernel k(a, t) = t*exp(-a*t) effects { e: a = 0; };", "t"),
            ("a limit", "kernel k(a, t) = (1 - exp(-a*t))/a effects { e: a = 0; };", "t"),
            ("0 times a pole", "kernel k(a, t) = a*(1/a)*t effects { e: a = 0; };", "t"),
            (
                "another argument",
                "kernel k(a, b) = (a - b)/(a + b) + a effects { e: b = a; } where a > 0;",
                "a",
            ),
            ("a choice", "kernel k(a, t) = if a > 0 { sin(a*t)/a } else { t } effects { e: a = 0; };", "t"),
            ("a simpler formula", "kernel k(a, x) = sin(x)**2 + cos(x + a)**2 effects { e: a = 0; };", "1"),
            ("its form", "kernel k(a, t) = exp(a*t) - 1 by expm1(a*t) effects { e: a = 1; };", "exp(t) - 1"),
        ] {
            assert_eq!(without(source), expected, "{what}");
        }
    }

    #[test]
    fn each_set_of_effects_is_left_out_in_any_order() {
        let source = "kernel k(a, b, c) = a + b*c effects { first: a = b; second: b = 0; third: c = 1; };";
        let found = formulas(source);
        let of = |present: [bool; 3]| {
            let place = found.iter().position(|one| one.0 == present).expect("each set has its kernel");
            (place, found[place].1.as_str())
        };
        assert_eq!(found.len(), 7);
        assert_eq!(of([false, true, true]).1, "b + b*c");
        assert_eq!(of([true, false, false]).1, "a");
        assert_eq!(of([false, false, true]), (3, "0"), "a is what b is");
        assert_eq!(of([false, false, false]).0, 6, "the fewest left out first");
    }

    #[test]
    fn a_specialised_kernel_equals_the_full_one_where_the_effect_vanishes() {
        for source in [
            "kernel k(a, x, y) = (x*cos(a) + y*sin(a))**2/(x**2 + y**2) effects { turn: a = 0; };",
            "kernel k(a, x, y) = sqrt(x**2 + 2*a*x*y + y**2) effects { skew: a = 1; };",
            "kernel k(n, c) = ((n*c - sqrt(1 - (1 - c**2)/n**2))/(n*c + sqrt(1 - (1 - c**2)/n**2)))**2
             effects { index: n = 1; } where 0 < c, c < 1, n >= 1;",
        ] {
            let mut theory = theory(source);
            let kernel = theory.kernels[0].clone();
            let found = specialisations(&mut theory.pool, &kernel).expect("it has a value there");
            let effect = &kernel.effects[0];
            let variable = theory.pool.symbol(effect.variable);
            let put_in = (variable, effect.value);
            let (full, domain) = replaced(&mut theory.pool, put_in, &kernel.outputs, &kernel.domain);
            let sides: Vec<(Expr, Expr)> = full.into_iter().zip(found[0].kernel.outputs.clone()).collect();
            let equations = Equations { sides: &sides, conditions: &domain };
            assert!(matches!(equations.decide(&mut theory.pool, EFFORT), Finding::Equal { .. }), "{source}");
        }
    }

    #[test]
    fn an_effect_that_leaves_no_kernel_is_an_error() {
        for (source, said) in [
            (
                "kernel k(a) = 1/a effects { e: a = 0; };",
                "neither defined nor shown to have a limit at a = 0",
            ),
            ("kernel k(a) = abs(a)/a effects { e: a = 0; };", "neither defined nor shown to have a limit"),
            ("kernel k(a) = a effects { e: a = 0; } where a > 0;", "is not defined at a = 0"),
            ("kernel k(a, b) = 1/a + 1/b effects { e: a = 0; f: b = 0; };", "a limit at a = 0"),
        ] {
            let mut theory = theory(source);
            let kernel = theory.kernels[0].clone();
            let faults = specialisations(&mut theory.pool, &kernel).expect_err(source);
            assert!(faults[0].message.contains(said), "{source}: {faults:?}");
            assert_eq!(faults.len(), kernel.effects.len(), "one for each effect");
        }
    }
}
