//! Expressions of the tests' own: written in the language, differentiated and evaluated without the engine.

use std::fmt;

/// The variables: two coordinates, then two positive parameters.
pub const NAMES: [&str; 4] = ["x", "y", "a", "b"];

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Tree {
    Variable(usize),
    Number(i64, i64),
    Pi,
    Sum(Box<Tree>, Box<Tree>),
    Difference(Box<Tree>, Box<Tree>),
    Product(Box<Tree>, Box<Tree>),
    Quotient(Box<Tree>, Box<Tree>),
    Negative(Box<Tree>),
    Power(Box<Tree>, i64, i64),
    Function(&'static str, Box<Tree>),
    /// `diff(f, x)`
    Partial(Box<Tree>, usize),
}

use Tree::*;

pub fn number(value: i64) -> Tree {
    Number(value, 1)
}
pub fn variable(place: usize) -> Tree {
    Variable(place)
}
pub fn power(base: &Tree, exponent: (i64, i64)) -> Tree {
    Power(Box::new(base.clone()), exponent.0, exponent.1)
}
pub fn apply(name: &'static str, argument: &Tree) -> Tree {
    Function(name, Box::new(argument.clone()))
}
pub fn partial(f: &Tree, place: usize) -> Tree {
    Partial(Box::new(f.clone()), place)
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
            Power(a, p, q) => write!(f, "({a})**({p}/{q})"),
            Function(name, a) => write!(f, "{name}({a})"),
            Partial(a, place) => write!(f, "diff({a}, {})", NAMES[*place]),
        }
    }
}

impl Tree {
    /// The partial derivative by the rules of a textbook.
    pub fn derivative(&self, place: usize) -> Tree {
        let d = |tree: &Tree| tree.derivative(place);
        match self {
            Variable(own) => number(i64::from(*own == place)),
            Number(..) | Pi => number(0),
            Sum(a, b) => d(a) + d(b),
            Difference(a, b) => d(a) - d(b),
            Product(a, b) => d(a) * (**b).clone() + (**a).clone() * d(b),
            Quotient(a, b) => (d(a) * (**b).clone() - (**a).clone() * d(b)) / power(b, (2, 1)),
            Negative(a) => -d(a),
            Power(a, p, q) => Number(*p, *q) * power(a, (p - q, *q)) * d(a),
            Function(name, a) => outer_derivative(name, a) * d(a),
            Partial(a, by) => a.derivative(*by).derivative(place),
        }
    }

    /// How many parts it has, itself counted.
    pub fn size(&self) -> usize {
        1 + match self {
            Variable(_) | Number(..) | Pi => 0,
            Sum(a, b) | Difference(a, b) | Product(a, b) | Quotient(a, b) => a.size() + b.size(),
            Negative(a) | Power(a, ..) | Function(_, a) | Partial(a, _) => a.size(),
        }
    }

    /// Changes the part of that number, itself being number 0.
    pub fn change(&mut self, place: usize, by: &mut dyn FnMut(&mut Tree)) {
        if place == 0 {
            return by(self);
        }
        match self {
            Variable(_) | Number(..) | Pi => {}
            Sum(a, b) | Difference(a, b) | Product(a, b) | Quotient(a, b) => {
                if place <= a.size() {
                    a.change(place - 1, by);
                } else {
                    b.change(place - 1 - a.size(), by);
                }
            }
            Negative(a) | Power(a, ..) | Function(_, a) | Partial(a, _) => a.change(place - 1, by),
        }
    }
}

/// f′ at an argument.
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
