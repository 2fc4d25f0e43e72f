//! The claim of an approximation: wherever the formula has a value on the kernel's domain, the form has
//! a value within the stated tolerance of it, relative to it.
//!
//! ```text
//! form, formula ─ pieces without `if` ─▶ each nowhere in the domain, equal, or within the tolerance
//!                                        └─ none of these: points at which it is certainly farther away
//! ```

use super::definedness::is_kept;
use super::fault::{Claim, Fault};
use super::pieces::{MOST_PIECES, pieces};
use super::translation::{EFFORT, equality};
use crate::approximation;
use crate::decide::{KernelReason, UnknownReason, Witness, contradiction};
use crate::diagnostic::Diagnostic;
use crate::enclosure::{Enclosure, Precision, enclose_of_kernel};
use crate::expression::{Condition, Expr, Pool, Rational, Symbol, number_text};
use crate::random::SplitMix;
use crate::theory::Kernel;
use num_traits::Signed;
use rustc_hash::FxHashMap;

/// Binary places of the enclosures at a point.
const PRECISION: Precision = Precision(256);

/// Number of points at which a counterexample is looked for.
const POINTS: usize = 400;

/// Digits of the values of a counterexample.
const DIGITS: u32 = 20;

const CLOSE: &str = "each piece of an approximation must be equal to the formula, or a function of one quantity whose range \
                     its condition bounds: `if abs(x) < 1/2 { … } else { … }`";

/// Returns the fault of a form that is not proved to be within the tolerance of its formula.
pub(super) fn fault(pool: &mut Pool, kernel: &Kernel, tolerance: &Rational) -> Option<Fault> {
    for (&form, &formula) in kernel.computed.iter().zip(&kernel.outputs) {
        let Some(pieces) = pieces(pool, &[form, formula], |_, one, other| one == other) else {
            return Some(undecided(kernel, tolerance, KernelReason::Pieces(MOST_PIECES).into()));
        };
        for piece in pieces {
            let known: Vec<Condition> = kernel.domain.iter().chain(&piece.path).copied().collect();
            let sides = (piece.expressions[0], piece.expressions[1]);
            if contradiction(pool, &known).is_some() || is_close(pool, sides, &known, tolerance) {
                continue;
            }
            return Some(match counterexample(pool, kernel, (form, formula), tolerance) {
                Some(witness) => refuted(kernel, tolerance, witness),
                None => {
                    let texts: Vec<String> =
                        piece.path.iter().map(|condition| condition.text(pool)).collect();
                    undecided(kernel, tolerance, KernelReason::NotClose(texts.join(", ")).into())
                }
            });
        }
    }
    None
}

/// Whether a piece of the form is within the tolerance of the formula, or equal to it.
fn is_close(
    pool: &mut Pool,
    (form, formula): (Expr, Expr),
    known: &[Condition],
    tolerance: &Rational,
) -> bool {
    approximation::is_within(pool, (form, formula), known, tolerance)
        || equality(pool, &[(form, formula)], known, EFFORT).is_proved()
            && is_kept(pool, known, formula, form)
}

/// Returns a point of the domain at which form and formula are certainly farther apart.
fn counterexample(
    pool: &mut Pool,
    kernel: &Kernel,
    (form, formula): (Expr, Expr),
    tolerance: &Rational,
) -> Option<Witness> {
    let mut random = SplitMix(0);
    let sides: Vec<Expr> =
        kernel.domain.iter().flat_map(|condition| [condition.left, condition.right]).collect();
    let expressions: Vec<Expr> = [form, formula].into_iter().chain(sides).collect();
    for _ in 0..POINTS {
        let point: FxHashMap<Symbol, Rational> =
            kernel.arguments.iter().map(|&argument| (argument, number(random.next()))).collect();
        let values = |symbol: Symbol| point.get(&symbol).map(|value| Enclosure::exact(value, PRECISION));
        let found = enclose_of_kernel(pool, &expressions, &values, PRECISION);
        let Ok(found) = found.into_iter().collect::<Result<Vec<Enclosure>, _>>() else { continue };
        let conditions = kernel.domain.iter().zip(found[2..].chunks_exact(2));
        let mut holds = conditions.map(|(condition, sides)| sides[0].decide(condition.relation, &sides[1]));
        if holds.all(|holds| holds == Some(true)) && is_far(&found[0], &found[1], tolerance) {
            return Some(witness(pool, kernel, &point, [&found[0], &found[1]]));
        }
    }
    None
}

/// Whether two values certainly differ by more than the tolerance, relative to the second.
fn is_far(form: &Enclosure, formula: &Enclosure, tolerance: &Rational) -> bool {
    let difference = form.sub(formula);
    let least = difference.lower().max(-difference.upper());
    let largest = formula.lower().abs().max(formula.upper().abs());
    least > tolerance * largest
}

/// Returns a number of moderate size: n/64 with |n| ≤ 64, or this times a power of two.
fn number(random: u64) -> Rational {
    let sixty_fourths = (random % 129) as i64 - 64;
    let scale = Rational::from_integer(2.into()).pow([0, 1, 3, -4, -8, 6][(random >> 32) as usize % 6]);
    Rational::new(sixty_fourths.into(), 64.into()) * scale
}

fn witness(
    pool: &Pool,
    kernel: &Kernel,
    point: &FxHashMap<Symbol, Rational>,
    [form, formula]: [&Enclosure; 2],
) -> Witness {
    let named = |argument: &Symbol| (pool.symbol_name(*argument).to_string(), point[argument].to_string());
    Witness {
        conditions: Vec::new(),
        point: kernel.arguments.iter().map(named).collect(),
        component: String::new(),
        left: shown(formula),
        right: shown(form),
        difference: String::new(),
        ratio: None,
    }
}

fn shown(value: &Enclosure) -> String {
    value.rounded(DIGITS).unwrap_or_else(|| value.digits())
}

fn refuted(kernel: &Kernel, tolerance: &Rational, witness: Witness) -> Fault {
    let point: Vec<String> = witness.point.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    let message = format!(
        "the form of `{}` is not within {} of its formula\nat {}: the formula is {}, the form is {}",
        kernel.name,
        number_text(tolerance),
        point.join(", "),
        witness.left,
        witness.right
    );
    let help =
        "give the approximation more terms or a smaller range, or state a larger tolerance after `approx`";
    let diagnostic = Diagnostic::new(kernel.span, message).with_help(help);
    Fault::refuted(&kernel.name, Claim::By, witness, diagnostic)
}

fn undecided(kernel: &Kernel, tolerance: &Rational, reason: UnknownReason) -> Fault {
    let message = format!(
        "cannot decide whether the form of `{}` is within {} of its formula: {reason}",
        kernel.name,
        number_text(tolerance)
    );
    Fault::unknown(&kernel.name, Claim::By, reason, Diagnostic::new(kernel.span, message).with_help(CLOSE))
}
