//! Identities that hold only under a condition.

use crate::dice::Dice;
use crate::parts::{any, positive, signed, square};
use crate::statement::{Condition, Statement};
use crate::tree::Tree::{self, *};
use crate::tree::{apply, atan2, number, power, variable};

/// Returns an identity with the conditions that it needs.
pub(crate) fn conditional(dice: &mut Dice) -> Statement {
    if dice.below(2) == 0 { of_a_sign(dice) } else { of_a_range(dice) }
}

/// Returns an identity that needs the sign of an expression, for example u > 0.
fn of_a_sign(dice: &mut Dice) -> Statement {
    let (u, w, p) = (signed(dice), signed(dice), positive(dice));
    let [sqrt, abs, log, atan] = ["sqrt", "abs", "log", "atan"].map(|name| move |of: &Tree| apply(name, of));
    let (is_positive, is_negative) = (Condition::positive(&u), Condition::less(&u, &number(0)));
    let not_negative = Condition::less_equal(&number(0), &u);
    let half_turn = Pi / number(2);
    let two = || number(2);
    match dice.below(13) {
        0 => Statement::new([sqrt(&square(&u)), u], [is_positive]),
        1 => Statement::new([abs(&u), u], [not_negative]),
        2 => Statement::new([abs(&u), -u], [is_negative]),
        3 => Statement::new([log(&square(&u)), two() * log(&-u)], [is_negative]),
        4 => {
            Statement::new([log(&square(&u)), two() * log(&abs(&u))], [Condition::not_equal(&u, &number(0))])
        }
        5 => Statement::new([atan(&u) + atan(&(number(1) / u)), half_turn], [is_positive]),
        6 => Statement::new([atan(&u) + atan(&(number(1) / u)), -half_turn], [is_negative]),
        7 => Statement::new([sqrt(&(square(&u) * p.clone())), u * sqrt(&p)], [not_negative]),
        8 => Statement::new([power(&power(&u, (6, 1)), (1, 6)), u], [is_positive]),
        9 => Statement::new([atan2(&w, &u), atan(&(w / u))], [is_positive]),
        10 => Statement::new([abs(&(&u - &w)), &u - &w], [Condition::less_equal(&w, &u)]),
        11 => {
            let sum = square(&u) + two() * u.clone() * w.clone() + square(&w);
            let conditions = [is_positive, Condition::positive(&w)];
            Statement::new([sqrt(&sum), u + w], conditions)
        }
        _ => {
            let a = any(dice);
            let difference = square(&a) - two() * a.clone() + number(1);
            Statement::new([sqrt(&difference), number(1) - a.clone()], [Condition::less(&a, &number(1))])
        }
    }
}

/// Returns an identity that needs the range of an angle.
fn of_a_range(dice: &mut Dice) -> Statement {
    let v = variable(dice.below(2) as usize);
    let [sin, cos, tan] = ["sin", "cos", "tan"].map(|name| move |of: &Tree| apply(name, of));
    let [asin, acos, atan] = ["asin", "acos", "atan"].map(|name| move |of: &Tree| apply(name, of));
    let half_turn = Pi / number(2);
    let within = |low: &Tree, high: &Tree| [Condition::less(low, &v), Condition::less(&v, high)];
    let acute = within(&-half_turn.clone(), &half_turn);
    let upper = within(&number(0), &Pi);
    let whole = within(&-Pi, &Pi);
    let half = v.clone() / number(2);
    match dice.below(9) {
        0 => Statement::new([asin(&sin(&v)), v.clone()], acute),
        1 => Statement::new([acos(&cos(&v)), v.clone()], upper),
        2 => Statement::new([atan(&tan(&v)), v.clone()], acute),
        3 => Statement::new([atan2(&sin(&v), &cos(&v)), v.clone()], whole),
        4 => Statement::new([apply("sqrt", &(number(1) - square(&sin(&v)))), cos(&v)], acute),
        5 => Statement::new([apply("sqrt", &((number(1) - cos(&v)) / number(2))), sin(&half)], upper),
        6 => Statement::new([apply("sqrt", &((number(1) + cos(&v)) / number(2))), cos(&half)], whole),
        7 => Statement::new([apply("abs", &sin(&v)), sin(&v)], upper),
        _ => Statement::new([acos(&sin(&v)), half_turn - v.clone()], acute),
    }
}
