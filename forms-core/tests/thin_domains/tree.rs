//! Random expressions over two angles x, z, which are multiples of π at the points looked at, and two fractions y, w.

use crate::value::Value;
use num_rational::Ratio;

/// A point: x/π, z/π, y and w.
pub(crate) type Point = [Ratio<i64>; 4];

/// A sum of multiples of the angles, over a small number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Angle {
    pub(crate) of_x: i64,
    pub(crate) of_z: i64,
    pub(crate) over: i64,
}

#[derive(Clone, Debug)]
pub(crate) enum Tree {
    Number(i64),
    /// y or w
    Plain(usize),
    Cos(Angle),
    Sin(Angle),
    Add(Box<Tree>, Box<Tree>),
    Multiply(Box<Tree>, Box<Tree>),
    Negate(Box<Tree>),
    Abs(Box<Tree>),
    Sqrt(Box<Tree>),
    Exp(Box<Tree>),
}

use Tree::{Abs, Add, Cos, Exp, Multiply, Negate, Number, Plain, Sin, Sqrt};

impl Tree {
    pub(crate) fn plus(self, other: Tree) -> Tree {
        Add(Box::new(self), Box::new(other))
    }

    pub(crate) fn minus(self, other: Tree) -> Tree {
        self.plus(other.negated())
    }

    pub(crate) fn times(self, other: Tree) -> Tree {
        Multiply(Box::new(self), Box::new(other))
    }

    pub(crate) fn negated(self) -> Tree {
        Negate(Box::new(self))
    }

    pub(crate) fn squared(self) -> Tree {
        self.clone().times(self)
    }

    pub(crate) fn abs(self) -> Tree {
        Abs(Box::new(self))
    }

    pub(crate) fn sqrt(self) -> Tree {
        Sqrt(Box::new(self))
    }

    pub(crate) fn exp(self) -> Tree {
        Exp(Box::new(self))
    }

    /// The value at a point; nothing where it is not defined, or may not be.
    pub(crate) fn at(&self, point: &Point) -> Option<Value> {
        Some(match self {
            Number(n) => Value::fraction(*n, 1),
            Plain(place) => Value::fraction(*point[2 + place].numer(), *point[2 + place].denom()),
            Cos(angle) => Value::cosine_of_turns(angle.turns(point)),
            Sin(angle) => Value::sine_of_turns(angle.turns(point)),
            Add(a, b) => a.at(point)?.add(b.at(point)?),
            Multiply(a, b) => a.at(point)?.multiply(b.at(point)?),
            Negate(a) => a.at(point)?.negate(),
            Abs(a) => a.at(point)?.abs(),
            Sqrt(a) => a.at(point)?.sqrt()?,
            Exp(a) => a.at(point)?.exp(),
        })
    }
}

impl Angle {
    fn turns(self, [x, z, ..]: &Point) -> Ratio<i64> {
        (x * Ratio::from_integer(self.of_x) + z * Ratio::from_integer(self.of_z))
            / Ratio::from_integer(self.over)
    }
}

impl std::fmt::Display for Angle {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "({}*x + {}*z)/{}", self.of_x, self.of_z, self.over)
    }
}

impl std::fmt::Display for Tree {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Number(n) if *n < 0 => write!(f, "({n})"),
            Number(n) => write!(f, "{n}"),
            Plain(place) => write!(f, "{}", ["y", "w"][*place]),
            Cos(angle) => write!(f, "cos({angle})"),
            Sin(angle) => write!(f, "sin({angle})"),
            Add(a, b) => write!(f, "({a} + {b})"),
            Multiply(a, b) => write!(f, "{a}*{b}"),
            Negate(a) => write!(f, "(-{a})"),
            Abs(a) => write!(f, "abs({a})"),
            Sqrt(a) => write!(f, "sqrt({a})"),
            Exp(a) => write!(f, "exp({a})"),
        }
    }
}
