//! Identities between scalars that are written with forms, fields and maps.

use crate::dice::Dice;
use crate::notation::Notation::{self, *};
use crate::notation::{MAPS, image};
use crate::parts::smooth;
use crate::statement::Equation;
use crate::tree::{Tree, number, partial};

fn written<const N: usize>(notation: Notation, parts: [&Tree; N]) -> Tree {
    Tree::Written(notation, parts.map(Tree::clone).to_vec())
}

/// Returns an identity about coefficients of d, wedge products, interior products, Lie derivatives
/// or pullbacks.
pub(crate) fn exterior(dice: &mut Dice) -> Equation {
    let [f, g, p, q] = [0; 4].map(|_| smooth(dice));
    let [x, y] = [|of: &Tree| partial(of, 0), |of: &Tree| partial(of, 1)];
    let map = dice.below(MAPS.len() as u64) as usize;
    let [u, v] = image(map);
    match dice.below(12) {
        0 => [written(Exterior, [&p, &q]), x(&q) - y(&p)],
        1 => [written(Exterior, [&x(&f), &y(&f)]), number(0)],
        2 => [
            written(Exterior, [&(&f * &x(&g)), &(&f * &y(&g))]),
            written(Wedge, [&x(&f), &y(&f), &x(&g), &y(&g)]),
        ],
        3 => [written(Wedge, [&p, &q, &f, &g]), -written(Wedge, [&f, &g, &p, &q])],
        4 => [written(Interior, [&p, &q, &f]), -(f * q)],
        5 => [written(Lie, [&p, &q, &f]), p * x(&f) + q * y(&f)],
        6 => {
            let along = |of: &Tree| written(Lie, [&p, &q, of]);
            [along(&(&f * &g)), f.clone() * along(&g) + g.clone() * along(&f)]
        }
        7 => [written(LieOfArea, [&p, &q, &f]), x(&(&f * &p)) + y(&(&f * &q))],
        8 => {
            let pulled = |of: &Tree| written(Composition(map), [of]);
            [pulled(&(&f * &g)), pulled(&f) * pulled(&g)]
        }
        9 => [written(Pulled(map), [&x(&f), &y(&f)]), x(&written(Composition(map), [&f]))],
        10 => {
            let jacobian = x(&u) * y(&v) - y(&u) * x(&v);
            [written(PulledArea(map), [&f]), written(Composition(map), [&f]) * jacobian]
        }
        _ => [x(&y(&f)), y(&x(&f))],
    }
}
