//! Random subexpressions of the identities.

use crate::dice::Dice;
use crate::tree::Tree::{self, *};
use crate::tree::{apply, number, power, raised, variable};

pub(crate) fn square(a: &Tree) -> Tree {
    power(a, (2, 1))
}

/// Returns a small expression that is defined everywhere.
pub(crate) fn any(dice: &mut Dice) -> Tree {
    let [x, y, a] = [0, 1, 2].map(variable);
    match dice.below(12) {
        0 | 1 => x,
        2 => y,
        3 => number(dice.between(-3, 3)) * x + number(dice.between(1, 3)) * y,
        4 => x * y,
        5 => square(&x) - y,
        6 => a * x + number(dice.between(-2, 2)),
        7 => x.clone() / (number(1) + square(&x)),
        8 => Number(dice.between(1, 5), dice.between(1, 4)) * y,
        9 => apply(if dice.below(2) == 0 { "sin" } else { "cos" }, &angle(dice)),
        10 => apply(["abs", "atan", "tanh"][dice.below(3) as usize], &x) - y,
        _ => apply("log", &positive(dice)),
    }
}

/// Returns an expression that is positive everywhere.
pub(crate) fn positive(dice: &mut Dice) -> Tree {
    let [x, y, a, b] = [0, 1, 2, 3].map(variable);
    match dice.below(9) {
        0 => a,
        1 => a * b,
        2 => square(&x) + number(1),
        3 => square(&x) + square(&y) + b,
        4 => apply("exp", &if dice.below(2) == 0 { x } else { a * y }),
        5 => a / (b + number(1)),
        6 => apply("cosh", &x),
        7 => a + apply("sqrt", &b),
        _ => square(&(x - y)) + number(dice.between(1, 3)),
    }
}

/// Returns an exponent.
pub(crate) fn exponent(dice: &mut Dice) -> Tree {
    let [x, a, b] = [0, 2, 3].map(variable);
    match dice.below(4) {
        0 => a,
        1 => b + number(dice.between(1, 2)),
        2 => number(dice.between(2, 3)) * a,
        _ => x,
    }
}

/// Returns an angle, linear in the variables.
pub(crate) fn angle(dice: &mut Dice) -> Tree {
    let [x, y, a] = [0, 1, 2].map(variable);
    match dice.below(5) {
        0 => x,
        1 => y,
        2 => number(dice.between(2, 3)) * x,
        3 => x + y,
        _ => a * y,
    }
}

/// Returns an expression of any sign, to be restricted by a condition.
pub(crate) fn signed(dice: &mut Dice) -> Tree {
    let [x, y, a] = [0, 1, 2].map(variable);
    match dice.below(6) {
        0 | 1 => x,
        2 => y,
        3 => x - number(dice.between(1, 3)),
        4 => x - y,
        _ => y - a,
    }
}

/// Returns a smooth expression, which need not be defined everywhere.
pub(crate) fn smooth(dice: &mut Dice) -> Tree {
    match dice.below(5) {
        0 => apply("sin", &any(dice)),
        1 => apply("sqrt", &positive(dice)),
        2 => raised(&positive(dice), &exponent(dice)),
        3 => any(dice) * any(dice),
        _ => any(dice) / positive(dice),
    }
}
