//! Expressions of these tests: written in the language, differentiated and evaluated without the
//! engine.

use crate::notation::Notation;
use std::fmt;

/// Names of the variables: two coordinates, then two positive parameters.
pub(crate) const NAMES: [&str; 4] = ["x", "y", "a", "b"];

/// Expression tree.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Tree {
    Variable(usize),
    Number(i64, i64),
    Pi,
    Sum(Box<Tree>, Box<Tree>),
    Difference(Box<Tree>, Box<Tree>),
    Product(Box<Tree>, Box<Tree>),
    Quotient(Box<Tree>, Box<Tree>),
    Negative(Box<Tree>),
    /// Power with a rational exponent.
    Power(Box<Tree>, i64, i64),
    /// Power of a positive base with any exponent.
    Raised(Box<Tree>, Box<Tree>),
    Function(&'static str, Box<Tree>),
    Atan2(Box<Tree>, Box<Tree>),
    /// Scalar that is written with forms and fields.
    Written(Notation, Vec<Tree>),
}

use Tree::*;

pub(crate) fn number(value: i64) -> Tree {
    Number(value, 1)
}
pub(crate) fn variable(place: usize) -> Tree {
    Variable(place)
}
pub(crate) fn power(base: &Tree, exponent: (i64, i64)) -> Tree {
    Power(Box::new(base.clone()), exponent.0, exponent.1)
}
pub(crate) fn raised(base: &Tree, exponent: &Tree) -> Tree {
    Raised(Box::new(base.clone()), Box::new(exponent.clone()))
}
pub(crate) fn apply(name: &'static str, argument: &Tree) -> Tree {
    Function(name, Box::new(argument.clone()))
}
pub(crate) fn atan2(y: &Tree, x: &Tree) -> Tree {
    Atan2(Box::new(y.clone()), Box::new(x.clone()))
}
pub(crate) fn partial(f: &Tree, place: usize) -> Tree {
    Written(Notation::Partial(place), vec![f.clone()])
}

macro_rules! operator {
    ($trait:ident, $method:ident, $variant:ident) => {
        impl std::ops::$trait for Tree {
            type Output = Tree;
            fn $method(self, other: Tree) -> Tree {
                $variant(Box::new(self), Box::new(other))
            }
        }
        impl std::ops::$trait for &Tree {
            type Output = Tree;
            fn $method(self, other: &Tree) -> Tree {
                $variant(Box::new(self.clone()), Box::new(other.clone()))
            }
        }
    };
}
operator!(Add, add, Sum);
operator!(Sub, sub, Difference);
operator!(Mul, mul, Product);
operator!(Div, div, Quotient);

impl std::ops::Neg for Tree {
    type Output = Tree;
    fn neg(self) -> Tree {
        Negative(Box::new(self))
    }
}

impl fmt::Display for Tree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Variable(place) => write!(f, "{}", NAMES[*place]),
            Number(p, 1) if *p >= 0 => write!(f, "{p}"),
            Number(p, 1) => write!(f, "({p})"),
            Number(p, q) => write!(f, "({p}/{q})"),
            Pi => write!(f, "pi"),
            Sum(a, b) => write!(f, "({a} + {b})"),
            Difference(a, b) => write!(f, "({a} - {b})"),
            Product(a, b) => write!(f, "({a}*{b})"),
            Quotient(a, b) => write!(f, "({a}/{b})"),
            Negative(a) => write!(f, "(-{a})"),
            Power(a, p, 1) => write!(f, "({a})**({p})"),
            Power(a, p, q) => write!(f, "({a})**({p}/{q})"),
            Raised(a, e) => write!(f, "({a})**({e})"),
            Function(name, a) => write!(f, "{name}({a})"),
            Atan2(y, x) => write!(f, "atan2({y}, {x})"),
            Written(notation, parts) => notation.write(parts, f),
        }
    }
}

impl Tree {
    /// Returns the partial derivative, by the rules of a textbook.
    pub(crate) fn derivative(&self, place: usize) -> Tree {
        let d = |tree: &Tree| tree.derivative(place);
        if !self.mentions(place) {
            // Zero even where the derivative by another variable is undefined.
            return number(0);
        }
        match self {
            Variable(own) => number(i64::from(*own == place)),
            Number(..) | Pi => number(0),
            Sum(a, b) => d(a) + d(b),
            Difference(a, b) => d(a) - d(b),
            Product(a, b) => d(a) * (**b).clone() + (**a).clone() * d(b),
            Quotient(a, b) => (d(a) * (**b).clone() - (**a).clone() * d(b)) / power(b, (2, 1)),
            Negative(a) => -d(a),
            Power(a, p, q) => Number(*p, *q) * power(a, (p - q, *q)) * d(a),
            Raised(a, e) => self.clone() * (d(e) * apply("log", a) + (**e).clone() * d(a) / (**a).clone()),
            Function(name, a) => outer_derivative(name, a) * d(a),
            Atan2(y, x) => {
                (d(y) * (**x).clone() - (**y).clone() * d(x)) / (power(y, (2, 1)) + power(x, (2, 1)))
            }
            Written(notation, parts) => notation.meaning(parts).derivative(place),
        }
    }

    /// Returns the composition with a map.
    pub(crate) fn composed(&self, image: &[Tree; 2]) -> Tree {
        match self {
            Variable(place) if *place < 2 => image[*place].clone(),
            Written(notation, parts) => notation.meaning(parts).composed(image),
            _ => {
                let mut tree = self.clone();
                tree.parts_mut().into_iter().for_each(|part| *part = part.composed(image));
                tree
            }
        }
    }

    pub(crate) fn parts(&self) -> Vec<&Tree> {
        match self {
            Variable(_) | Number(..) | Pi => vec![],
            Negative(a) | Power(a, ..) | Function(_, a) => vec![a],
            Sum(a, b) | Difference(a, b) | Product(a, b) | Quotient(a, b) | Raised(a, b) | Atan2(a, b) => {
                vec![a, b]
            }
            Written(_, parts) => parts.iter().collect(),
        }
    }

    pub(crate) fn parts_mut(&mut self) -> Vec<&mut Tree> {
        match self {
            Variable(_) | Number(..) | Pi => vec![],
            Negative(a) | Power(a, ..) | Function(_, a) => vec![a],
            Sum(a, b) | Difference(a, b) | Product(a, b) | Quotient(a, b) | Raised(a, b) | Atan2(a, b) => {
                vec![a, b]
            }
            Written(_, parts) => parts.iter_mut().collect(),
        }
    }

    /// Whether the expression contains a variable, after forms and maps have been expanded.
    fn mentions(&self, place: usize) -> bool {
        match self {
            Written(notation, parts) => notation.meaning(parts).mentions(place),
            _ => *self == Variable(place) || self.parts().into_iter().any(|part| part.mentions(place)),
        }
    }

    /// Returns the number of nodes, including the root.
    pub(crate) fn size(&self) -> usize {
        1 + self.parts().into_iter().map(Tree::size).sum::<usize>()
    }

    /// Returns the node with this number; the root has number 0.
    pub(crate) fn part_mut(&mut self, place: usize) -> &mut Tree {
        if place == 0 {
            return self;
        }
        let mut rest = place - 1;
        for part in self.parts_mut() {
            let size = part.size();
            if rest < size {
                return part.part_mut(rest);
            }
            rest -= size;
        }
        unreachable!("a tree has as many parts as its size says")
    }
}

/// Returns f′ at an argument.
fn outer_derivative(name: &str, a: &Tree) -> Tree {
    let square = || power(a, (2, 1));
    match name {
        "sin" => apply("cos", a),
        "cos" => -apply("sin", a),
        "tan" => number(1) / power(&apply("cos", a), (2, 1)),
        "exp" => apply("exp", a),
        "log" => number(1) / a.clone(),
        "sqrt" => number(1) / (number(2) * apply("sqrt", a)),
        "atan" => number(1) / (number(1) + square()),
        "asin" => number(1) / apply("sqrt", &(number(1) - square())),
        "acos" => -(number(1) / apply("sqrt", &(number(1) - square()))),
        "sinh" => apply("cosh", a),
        "cosh" => apply("sinh", a),
        "tanh" => number(1) / power(&apply("cosh", a), (2, 1)),
        "abs" => a.clone() / apply("abs", a),
        _ => unreachable!("{name} is no function of the language"),
    }
}
