//! Mutation: changes one part of a statement, which usually makes the statement false.

use crate::dice::Dice;
use crate::notation::{MAPS, Notation};
use crate::statement::Statement;
use crate::tree::Tree::{self, *};
use crate::tree::{apply, number};

/// Mutates an expression of a statement, or one of its conditions.
pub(crate) fn damage(statement: &mut Statement, dice: &mut Dice) {
    if !statement.conditions.is_empty() && dice.below(2) == 0 {
        return weaken(statement, dice);
    }
    let expression = statement.expression(dice);
    let place = dice.below(expression.size() as u64) as usize;
    change(expression.part_mut(place), dice);
}

/// Drops a condition, reverses it, or makes it weaker or stronger.
fn weaken(statement: &mut Statement, dice: &mut Dice) {
    let place = dice.below(statement.conditions.len() as u64) as usize;
    let condition = &mut statement.conditions[place];
    let right = condition.right.clone();
    match dice.below(5) {
        0 => drop(statement.conditions.remove(place)),
        1 => std::mem::swap(&mut condition.left, &mut condition.right),
        2 => condition.right = right + number(1),
        3 => condition.right = right - number(1),
        _ => condition.right = right + Number(1, 10),
    }
}

/// Changes a sign, number, exponent, function, variable or order, or drops a part.
fn change(part: &mut Tree, dice: &mut Dice) {
    let (step, other, first) = (dice.between(1, 2), dice.below(4) as usize, dice.below(2) == 0);
    *part = match part.clone() {
        Variable(_) => Variable(other),
        Number(p, q) => Number(if first { p + step } else { p - step }, q),
        Pi => number(3),
        Sum(a, b) => {
            if first {
                Difference(a, b)
            } else {
                *a
            }
        }
        Difference(a, b) => {
            if first {
                Sum(a, b)
            } else {
                Difference(b, a)
            }
        }
        Product(a, b) => {
            if first {
                Sum(a, b)
            } else {
                *a
            }
        }
        Quotient(a, b) => {
            if first {
                Product(a, b)
            } else {
                Quotient(b, a)
            }
        }
        Negative(a) => *a,
        Power(a, p, q) => Power(a, if first { p + step } else { -p }, q),
        Raised(a, e) => Raised(a, Box::new(if first { *e + number(step) } else { -*e })),
        Function("sqrt", a) if first => apply("sqrt", &-*a),
        Function(name, a) => Function(exchanged(name), a),
        Atan2(a, b) => {
            if first {
                Atan2(b, a)
            } else {
                Atan2(Box::new(-*a), b)
            }
        }
        Written(notation, parts) => rewritten(notation, parts, first),
    };
}

/// Changes the coordinate or map of a notation, or the order of its parts.
fn rewritten(notation: Notation, mut parts: Vec<Tree>, first: bool) -> Tree {
    let next = |map: usize| (map + 1) % MAPS.len();
    let notation = match notation {
        Notation::Partial(by) if first => Notation::Partial(1 - by),
        Notation::Composition(map) if first => Notation::Composition(next(map)),
        Notation::Pulled(map) if first => Notation::Pulled(next(map)),
        Notation::PulledArea(map) if first => Notation::PulledArea(next(map)),
        _ if parts.len() == 1 => return parts.remove(0),
        other => {
            parts.rotate_left(1);
            other
        }
    };
    Written(notation, parts)
}

/// Returns a function that is easily confused with the given one.
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
