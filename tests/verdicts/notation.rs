//! Scalars written with forms and fields, and their meaning by rules independent of the engine.

use crate::tree::Tree::{self, *};
use crate::tree::{NAMES, number, power, variable};
use std::fmt;

/// Way to write a scalar with forms and fields in the coordinates x, y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Notation {
    /// `diff(f, x)`
    Partial(usize),
    /// `d(P*dx + Q*dy)[dx^dy]`
    Exterior,
    /// `((P*dx + Q*dy)^(R*dx + S*dy))[dx^dy]`
    Wedge,
    /// `interior(P*@x + Q*@y, R*dx^dy)[dx]`
    Interior,
    /// `lie(P*@x + Q*@y, f)`
    Lie,
    /// `lie(P*@x + Q*@y, R*dx^dy)[dx^dy]`
    LieOfArea,
    /// `pullback(F, f)`
    Composition(usize),
    /// `pullback(F, P*dx + Q*dy)[dx]`
    Pulled(usize),
    /// `pullback(F, f*dx^dy)[dx^dy]`
    PulledArea(usize),
}

use Notation::*;

/// Maps along which forms are pulled back.
pub(crate) const MAPS: [&str; 3] = ["F", "G", "H"];

/// Returns the components of a map.
pub(crate) fn image(map: usize) -> [Tree; 2] {
    let [x, y, a] = [0, 1, 2].map(variable);
    match map {
        0 => [x.clone() + power(&y, (2, 1)), x * y],
        1 => [a * x.clone() - y.clone(), x + y],
        _ => [power(&x, (2, 1)) - power(&y, (2, 1)), number(2) * x * y],
    }
}

/// Returns the items that declare the maps used in a text.
pub(crate) fn declarations(text: &str) -> String {
    let used = (0..MAPS.len()).filter(|&map| text.contains(&format!("pullback({},", MAPS[map])));
    used.map(|map| {
        let [first, second] = image(map);
        format!("map {}: P -> P = ({first}, {second}); ", MAPS[map])
    })
    .collect()
}

impl Notation {
    pub(crate) fn write(self, parts: &[Tree], f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self, parts) {
            (Partial(by), [of]) => write!(f, "diff({of}, {})", NAMES[by]),
            (Exterior, [p, q]) => write!(f, "d({p}*dx + {q}*dy)[dx^dy]"),
            (Wedge, [p, q, r, s]) => write!(f, "(({p}*dx + {q}*dy)^({r}*dx + {s}*dy))[dx^dy]"),
            (Interior, [p, q, r]) => write!(f, "interior({p}*@x + {q}*@y, {r}*dx^dy)[dx]"),
            (Lie, [p, q, of]) => write!(f, "lie({p}*@x + {q}*@y, {of})"),
            (LieOfArea, [p, q, r]) => write!(f, "lie({p}*@x + {q}*@y, {r}*dx^dy)[dx^dy]"),
            (Composition(map), [of]) => write!(f, "pullback({}, {of})", MAPS[map]),
            (Pulled(map), [p, q]) => write!(f, "pullback({}, {p}*dx + {q}*dy)[dx]", MAPS[map]),
            (PulledArea(map), [of]) => write!(f, "pullback({}, {of}*dx^dy)[dx^dy]", MAPS[map]),
            _ => unreachable!("{self:?} has other parts"),
        }
    }

    /// Returns the same scalar without forms; it is defined where the parts are defined.
    pub(crate) fn meaning(self, parts: &[Tree]) -> Tree {
        let d = |of: &Tree, by: usize| of.derivative(by);
        let scalar = match (self, parts) {
            (Partial(by), [of]) => d(of, by),
            (Exterior, [p, q]) => d(q, 0) - d(p, 1),
            (Wedge, [p, q, r, s]) => p * s - q * r,
            (Interior, [_, q, r]) => -(q * r),
            (Lie, [p, q, of]) => p.clone() * d(of, 0) + q.clone() * d(of, 1),
            (LieOfArea, [p, q, r]) => d(&(p * r), 0) + d(&(q * r), 1),
            (Composition(map), [of]) => return of.composed(&image(map)),
            (Pulled(map), [p, q]) => {
                let to = image(map);
                return p.composed(&to) * d(&to[0], 0) + q.composed(&to) * d(&to[1], 0);
            }
            (PulledArea(map), [of]) => {
                let to = image(map);
                let jacobian = d(&to[0], 0) * d(&to[1], 1) - d(&to[0], 1) * d(&to[1], 0);
                return of.composed(&to) * jacobian;
            }
            _ => unreachable!("{self:?} has other parts"),
        };
        parts.iter().fold(scalar, |sum, part| Sum(Box::new(sum), Box::new(number(0) * part.clone())))
    }
}
