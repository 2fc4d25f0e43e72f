//! Combinations of known identities with random subexpressions.

use crate::conditional::conditional;
use crate::dice::Dice;
use crate::forms::exterior;
use crate::parts::{angle, any, exponent, positive, square};
use crate::statement::{Equation, Statement};
use crate::tree::Tree::{self, *};
use crate::tree::{apply, atan2, number, partial, power, raised};

/// Returns a known identity; its derivatives are by a coordinate.
fn known(dice: &mut Dice) -> Statement {
    let sides = match dice.below(10) {
        0 => rational(&any(dice), &any(dice), dice),
        1 => trigonometric(&angle(dice), &angle(dice), dice),
        2 => exponential(&any(dice), &any(dice), &positive(dice), &positive(dice), dice),
        3 => radical(&any(dice), &any(dice), &positive(dice), &positive(dice), dice),
        4 => inverse(&any(dice), &positive(dice), dice),
        5 => differential(&any(dice), &positive(dice), dice.below(2) as usize, dice),
        6 => symbolic(&positive(dice), &positive(dice), [exponent(dice), exponent(dice)], dice),
        7 => polar(&any(dice), &positive(dice), dice),
        8 => exterior(dice),
        _ => return conditional(dice),
    };
    sides.into()
}

fn rational(a: &Tree, b: &Tree, dice: &mut Dice) -> Equation {
    match dice.below(4) {
        0 => [square(&(a + b)), square(a) + number(2) * a.clone() * b.clone() + square(b)],
        1 => [(square(a) - square(b)) / (a - b), a + b],
        2 => [number(1) / a.clone() + number(1) / b.clone(), (a + b) / (a * b)],
        _ => [power(&(a - b), (3, 1)), (a - b) * square(&(b - a))],
    }
}

fn trigonometric(a: &Tree, b: &Tree, dice: &mut Dice) -> Equation {
    let [sin, cos, tan] = ["sin", "cos", "tan"].map(|name| move |of: &Tree| apply(name, of));
    match dice.below(11) {
        0 => [square(&sin(a)) + square(&cos(a)), number(1)],
        1 => [sin(&(a + b)), sin(a) * cos(b) + cos(a) * sin(b)],
        2 => [cos(&(a - b)), cos(a) * cos(b) + sin(a) * sin(b)],
        3 => [sin(&(number(2) * a.clone())), number(2) * sin(a) * cos(a)],
        4 => [cos(&(number(3) * a.clone())), number(4) * power(&cos(a), (3, 1)) - number(3) * cos(a)],
        5 => [number(1) + square(&tan(a)), number(1) / square(&cos(a))],
        6 => [square(&sin(&(a.clone() / number(2)))), (number(1) - cos(a)) / number(2)],
        7 => [number(2) * sin(a) * sin(b), cos(&(a - b)) - cos(&(a + b))],
        8 => [tan(&(a.clone() / number(2))), sin(a) / (number(1) + cos(a))],
        9 => [sin(a) + sin(b), number(2) * sin(&((a + b) / number(2))) * cos(&((a - b) / number(2)))],
        _ => [tan(&(a + b)), (tan(a) + tan(b)) / (number(1) - tan(a) * tan(b))],
    }
}

fn exponential(a: &Tree, b: &Tree, p: &Tree, q: &Tree, dice: &mut Dice) -> Equation {
    let [exp, log, sinh, cosh] = ["exp", "log", "sinh", "cosh"].map(|name| move |of: &Tree| apply(name, of));
    match dice.below(9) {
        0 => [exp(&(a + b)), exp(a) * exp(b)],
        1 => [exp(&-a.clone()), number(1) / exp(a)],
        2 => [square(&cosh(a)) - square(&sinh(a)), number(1)],
        3 => [sinh(&(number(2) * a.clone())), number(2) * sinh(a) * cosh(a)],
        4 => [apply("tanh", a), sinh(a) / cosh(a)],
        5 => [exp(&log(p)), p.clone()],
        6 => [log(&(p * q)), log(p) + log(q)],
        7 => [log(&(square(p) / q.clone())), number(2) * log(p) - log(q)],
        _ => [log(&apply("sqrt", p)), log(p) / number(2)],
    }
}

fn radical(a: &Tree, b: &Tree, p: &Tree, q: &Tree, dice: &mut Dice) -> Equation {
    let [sqrt, abs] = ["sqrt", "abs"].map(|name| move |of: &Tree| apply(name, of));
    match dice.below(15) {
        0 => [sqrt(p) * sqrt(q), sqrt(&(p * q))],
        1 => [sqrt(&square(a)), abs(a)],
        2 => [abs(&(a * b)), abs(a) * abs(b)],
        3 => [power(p, (1, 2)) * power(p, (1, 3)), power(p, (5, 6))],
        4 => [power(&power(p, (3, 1)), (1, 3)), p.clone()],
        5 => [number(1) / (sqrt(p) + sqrt(q)), (sqrt(p) - sqrt(q)) / (p - q)],
        6 => [sqrt(p) / p.clone(), number(1) / sqrt(p)],
        7 => [sqrt(&(p + q + number(2) * sqrt(&(p * q)))), sqrt(p) + sqrt(q)],
        8 => [(sqrt(p) + sqrt(q)) * (sqrt(p) - sqrt(q)), p - q],
        9 => [sqrt(&(p / q)), sqrt(&(p * q)) / q.clone()],
        10 => [square(&(abs(a) + abs(b))), square(a) + square(b) + number(2) * abs(&(a * b))],
        11 => [abs(&(a / p)), abs(a) / p.clone()],
        12 => [power(&square(a), (3, 2)), power(&abs(a), (3, 1))],
        13 => [sqrt(a) * sqrt(b), sqrt(&(a * b))],
        _ => [square(&abs(a)), square(a)],
    }
}

/// Returns an identity about powers with arbitrary exponents.
fn symbolic(p: &Tree, q: &Tree, [e, f]: [Tree; 2], dice: &mut Dice) -> Equation {
    match dice.below(8) {
        0 => [raised(p, &e) * raised(p, &f), raised(p, &(e + f))],
        1 => [raised(&raised(p, &e), &f), raised(p, &(e * f))],
        2 => [raised(&(p * q), &e), raised(p, &e) * raised(q, &e)],
        3 => [apply("log", &raised(p, &e)), e * apply("log", p)],
        4 => [apply("exp", &(e.clone() * apply("log", p))), raised(p, &e)],
        5 => [raised(p, &-e.clone()), number(1) / raised(p, &e)],
        6 => [raised(&apply("exp", &e), &f), apply("exp", &(e * f))],
        _ => {
            let logarithmic = partial(&e, 0) * apply("log", p) + e.clone() * partial(p, 0) / p.clone();
            [partial(&raised(p, &e), 0), raised(p, &e) * logarithmic]
        }
    }
}

/// Returns an identity about the angle of a point.
fn polar(a: &Tree, p: &Tree, dice: &mut Dice) -> Equation {
    let angle = atan2(a, p);
    let radius = || apply("sqrt", &(square(a) + square(p)));
    match dice.below(6) {
        0 => [apply("tan", &angle), a / p],
        1 => [apply("cos", &angle), p.clone() / radius()],
        2 => [apply("sin", &angle), a.clone() / radius()],
        3 => [angle, apply("atan", &(a / p))],
        4 => [atan2(&(a * p), &square(p)), angle],
        _ => {
            let area = partial(a, 1) * p.clone() - a.clone() * partial(p, 1);
            [partial(&angle, 1), area / (square(a) + square(p))]
        }
    }
}

fn inverse(a: &Tree, p: &Tree, dice: &mut Dice) -> Equation {
    let root = || apply("sqrt", &(number(1) + square(a)));
    let atan = |of: &Tree| apply("atan", of);
    let half_turn = || Pi / number(2);
    match dice.below(6) {
        0 => [apply("cos", &atan(a)), number(1) / root()],
        1 => [apply("sin", &atan(a)), a.clone() / root()],
        2 => [apply("tan", &atan(a)), a.clone()],
        3 => [atan(p) + atan(&(number(1) / p.clone())), half_turn()],
        4 => [apply("asin", &(a.clone() / root())) + apply("acos", &(a.clone() / root())), half_turn()],
        _ => [apply("asin", &(a.clone() / root())), atan(a)],
    }
}

fn differential(a: &Tree, p: &Tree, x: usize, dice: &mut Dice) -> Equation {
    let d = |of: &Tree| partial(of, x);
    match dice.below(8) {
        0 => [d(&(a * p)), d(a) * p.clone() + a.clone() * d(p)],
        1 => [d(&(a / p)), (d(a) * p.clone() - a.clone() * d(p)) / square(p)],
        2 => [d(&apply("sin", a)), apply("cos", a) * d(a)],
        3 => [d(&apply("atan", a)), d(a) / (number(1) + square(a))],
        4 => [d(&apply("log", p)), d(p) / p.clone()],
        5 => [d(&apply("sqrt", p)), d(p) / (number(2) * apply("sqrt", p))],
        6 => [d(&power(p, (-3, 2))), Number(-3, 2) * power(p, (-5, 2)) * d(p)],
        _ => [partial(&d(&(a * p)), 1 - x), d(&partial(&(a * p), 1 - x))],
    }
}

/// Combines several identities in the same way on both sides.
pub(crate) fn identity(dice: &mut Dice) -> Statement {
    let Statement { sides: [mut left, mut right], mut conditions } = known(dice);
    for _ in 0..dice.below(3) {
        let (factor, Statement { sides: [l, r], conditions: more }) = (any(dice), known(dice));
        conditions.extend(more);
        (left, right) = match dice.below(3) {
            0 => (left + l, right + r),
            1 => (left * factor.clone() - l, right * factor - r),
            _ => (left * l, right * r),
        };
    }
    Statement::new(if dice.below(2) == 0 { [right, left] } else { [left, right] }, conditions)
}
