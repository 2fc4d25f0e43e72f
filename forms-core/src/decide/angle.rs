//! Angles that vanish: the sine is 0, the cosine is 1, and the angle stays within a full turn.

use super::goal::{Outcome, Task, Turn};
use super::proof::prove_full_turn;
use crate::expression::{Expr, Node, Operation, Pool};
use crate::normal::is_arc;

/// Tries to prove that an angle D vanishes. It tries D, and 2D, whose sine and cosine contain fewer
/// roots; first without, then with a case split on the signs of all arguments.
pub(super) fn prove_angle(pool: &mut Pool, task: Task, angle: Expr, shown: &mut Vec<Expr>) -> Outcome {
    let two = pool.integer(2);
    let twice = pool.multiply(two, angle);
    let arguments = arguments_of_arcs(pool, angle);
    let magnitudes: Vec<Expr> = arguments.iter().map(|&q| pool.apply(Operation::Abs, &[q])).collect();
    let mut last = Outcome::NotZero;
    for (angle, signs) in [(angle, &[] as &[Expr]), (twice, &[]), (angle, &magnitudes), (twice, &magnitudes)]
    {
        let (sine, cosine) = (pool.apply(Operation::Sin, &[angle]), pool.apply(Operation::Cos, &[angle]));
        let one = pool.integer(1);
        let versine = pool.subtract(one, cosine);
        last = prove_full_turn(pool, task, vec![sine, versine], Turn { angle, signs: signs.to_vec() });
        if last == Outcome::Zero {
            shown.push(angle);
            break;
        }
    }
    last
}

fn arguments_of_arcs(pool: &Pool, angle: Expr) -> Vec<Expr> {
    let arguments = |part: Expr| match pool.node(part) {
        Node::Apply(operation, arguments) if is_arc(*operation) => arguments.to_vec(),
        _ => vec![],
    };
    pool.reachable(&[angle]).into_iter().flat_map(arguments).collect()
}
