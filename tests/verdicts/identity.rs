//! Known identities with random parts in them, put together, and damaged.

use crate::dice::Dice;
use crate::tree::Tree::{self, *};
use crate::tree::{apply, number, partial, power, variable};

/// Two sides.
pub type Equation = [Tree; 2];

/// A small expression that is defined everywhere.
fn any(dice: &mut Dice) -> Tree {
    let [x, y, a] = [0, 1, 2].map(variable);
    match dice.below(8) {
        0 => x,
        1 => y,
        2 => number(dice.between(-3, 3)) * x + number(dice.between(1, 3)) * y,
        3 => x * y,
        4 => power(&x, (2, 1)) - y,
        5 => a * x + number(dice.between(-2, 2)),
        6 => x.clone() / (number(1) + power(&x, (2, 1))),
        _ => Number(dice.between(1, 5), dice.between(1, 4)) * y,
    }
}

/// An expression that is positive everywhere.
fn positive(dice: &mut Dice) -> Tree {
    let [x, y, a, b] = [0, 1, 2, 3].map(variable);
    match dice.below(7) {
        0 => a,
        1 => a * b,
        2 => power(&x, (2, 1)) + number(1),
        3 => power(&x, (2, 1)) + power(&y, (2, 1)) + b,
        4 => apply("exp", &any(dice)),
        5 => a / (b + number(1)),
        _ => power(&(x - y), (2, 1)) + number(dice.between(1, 3)),
    }
}

/// An angle: linear in the variables.
fn angle(dice: &mut Dice) -> Tree {
    let [x, y, a] = [0, 1, 2].map(variable);
    match dice.below(5) {
        0 => x,
        1 => y,
        2 => number(dice.between(2, 3)) * x,
        3 => x + y,
        _ => a * y,
    }
}

/// A known identity; the variable of its derivatives is a coordinate.
fn known(dice: &mut Dice) -> Equation {
    match dice.below(6) {
        0 => rational(&any(dice), &any(dice), dice),
        1 => trigonometric(&angle(dice), &angle(dice), dice),
        2 => exponential(&any(dice), &any(dice), &positive(dice), &positive(dice), dice),
        3 => radical(&any(dice), &any(dice), &positive(dice), &positive(dice), dice),
        4 => inverse(&any(dice), &positive(dice), dice),
        _ => differential(&any(dice), &positive(dice), dice.below(2) as usize, dice),
    }
}

fn square(a: &Tree) -> Tree {
    power(a, (2, 1))
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
    match dice.below(9) {
        0 => [square(&sin(a)) + square(&cos(a)), number(1)],
        1 => [sin(&(a + b)), sin(a) * cos(b) + cos(a) * sin(b)],
        2 => [cos(&(a - b)), cos(a) * cos(b) + sin(a) * sin(b)],
        3 => [sin(&(number(2) * a.clone())), number(2) * sin(a) * cos(a)],
        4 => [cos(&(number(3) * a.clone())), number(4) * power(&cos(a), (3, 1)) - number(3) * cos(a)],
        5 => [number(1) + square(&tan(a)), number(1) / square(&cos(a))],
        6 => [square(&sin(&(a.clone() / number(2)))), (number(1) - cos(a)) / number(2)],
        7 => [number(2) * sin(a) * sin(b), cos(&(a - b)) - cos(&(a + b))],
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
    match dice.below(9) {
        0 => [sqrt(p) * sqrt(q), sqrt(&(p * q))],
        1 => [sqrt(&square(a)), abs(a)],
        2 => [abs(&(a * b)), abs(a) * abs(b)],
        3 => [power(p, (1, 2)) * power(p, (1, 3)), power(p, (5, 6))],
        4 => [power(&power(p, (3, 1)), (1, 3)), p.clone()],
        5 => [number(1) / (sqrt(p) + sqrt(q)), (sqrt(p) - sqrt(q)) / (p - q)],
        6 => [sqrt(p) / p.clone(), number(1) / sqrt(p)],
        7 => [sqrt(&(p + q + number(2) * sqrt(&(p * q)))), sqrt(p) + sqrt(q)],
        _ => [square(&abs(a)), square(a)],
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

/// Several identities put together in the same way on both sides.
pub fn identity(dice: &mut Dice) -> Equation {
    let [mut left, mut right] = known(dice);
    for _ in 0..dice.below(3) {
        let (factor, [l, r]) = (any(dice), known(dice));
        (left, right) = match dice.below(3) {
            0 => (left + l, right + r),
            1 => (left * factor.clone() - l, right * factor - r),
            _ => (left * l, right * r),
        };
    }
    if dice.below(2) == 0 { [right, left] } else { [left, right] }
}

/// Changes one part of one side: a sign, a number, an exponent, a function, a variable.
pub fn damage(sides: &mut Equation, dice: &mut Dice) {
    let side = &mut sides[dice.below(2) as usize];
    let place = dice.below(side.size() as u64) as usize;
    let (step, other) = (dice.between(1, 2), dice.below(4) as usize);
    side.change(place, &mut |part| {
        *part = match part.clone() {
            Variable(_) => Variable(other),
            Number(p, q) => Number(p + step, q),
            Pi => number(3),
            Sum(a, b) => Difference(a, b),
            Difference(a, b) => Sum(a, b),
            Product(a, b) => if step == 1 { Sum(a, b) } else { *a },
            Quotient(a, b) => if step == 1 { Product(a, b) } else { Quotient(b, a) },
            Negative(a) => *a,
            Power(a, p, q) => Power(a, p + step, q),
            Function(name, a) => Function(exchanged(name), a),
            Partial(a, by) => if step == 1 { Partial(a, 1 - by) } else { *a },
        };
    });
}

/// A function that is easily mistaken for another.
fn exchanged(name: &str) -> &'static str {
    match name {
        "sin" => "cos",
        "cos" => "sin",
        "tan" => "sin",
        "exp" => "cosh",
        "log" => "sqrt",
        "sqrt" => "abs",
        "abs" => "sqrt",
        "atan" => "sin",
        "asin" => "acos",
        "acos" => "atan",
        "sinh" => "cosh",
        "cosh" => "sinh",
        _ => "atan",
    }
}
