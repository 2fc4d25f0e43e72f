//! Construction of expressions: constants fold, neutral elements and opposite summands vanish,
//! signs move out of products and quotients, integer powers of powers merge, and derivatives of
//! integrals are lowered. No other rewriting is done.

use super::node::{Expr, FunctionId, Node, Rational, Seam, Symbol};
use super::operation::Operation;
use super::pool::Pool;
use crate::expression::Relation;
use num_rational::Ratio;
use num_traits::{One, Signed, Zero};

/// Largest size in bits of a folded power of a number; larger powers stay as written.
const FOLDED_POWER_BITS: u64 = 4096;

impl Pool {
    /// Builds an exact number.
    pub fn number(&mut self, value: Rational) -> Expr {
        self.intern(Node::Number(value))
    }

    /// Builds an integer.
    pub fn integer(&mut self, value: i64) -> Expr {
        if let Some(&known) = self.integers.get(&value) {
            return known;
        }
        let number = self.number(Rational::from_integer(value.into()));
        self.integers.insert(value, number);
        number
    }

    /// p/q
    pub fn ratio(&mut self, p: i64, q: i64) -> Expr {
        self.number(Rational::new(p.into(), q.into()))
    }

    /// π
    pub fn pi(&mut self) -> Expr {
        self.intern(Node::Pi)
    }

    /// Returns a variable as an expression.
    pub fn symbol(&mut self, symbol: Symbol) -> Expr {
        self.intern(Node::Symbol(symbol))
    }

    /// Returns the value of an expression that is a number literal.
    pub fn as_number(&self, expression: Expr) -> Option<&Rational> {
        match self.node(expression) {
            Node::Number(value) => Some(value),
            _ => None,
        }
    }

    /// Whether an expression is the literal number 0. Whether any other expression vanishes is
    /// decided by the prover.
    pub fn is_zero(&self, expression: Expr) -> bool {
        self.as_number(expression).is_some_and(Zero::is_zero)
    }

    fn is_one(&self, expression: Expr) -> bool {
        self.as_number(expression).is_some_and(One::is_one)
    }

    /// a + b
    pub fn add(&mut self, a: Expr, b: Expr) -> Expr {
        if self.is_zero(a) {
            return b;
        }
        if self.is_zero(b) {
            return a;
        }
        if let (Some(p), Some(q)) = (self.as_number(a), self.as_number(b)) {
            let sum = p + q;
            return self.number(sum);
        }
        if *self.node(a) == Node::Negate(b) || *self.node(b) == Node::Negate(a) {
            return self.integer(0);
        }
        self.intern(Node::Add(a, b))
    }

    /// a − b, represented as a + (−b)
    pub fn subtract(&mut self, a: Expr, b: Expr) -> Expr {
        let negated = self.negate(b);
        self.add(a, negated)
    }

    /// −a
    pub fn negate(&mut self, a: Expr) -> Expr {
        match self.node(a) {
            Node::Negate(inner) => *inner,
            Node::Number(value) => {
                let negated = -value;
                self.number(negated)
            }
            _ => self.intern(Node::Negate(a)),
        }
    }

    /// a b
    pub fn multiply(&mut self, a: Expr, b: Expr) -> Expr {
        if self.is_zero(a) || self.is_one(b) {
            return a;
        }
        if self.is_zero(b) || self.is_one(a) {
            return b;
        }
        match (self.node(a), self.node(b)) {
            (Node::Number(p), Node::Number(q)) => {
                let product = p * q;
                self.number(product)
            }
            (Node::Negate(x), Node::Negate(y)) => {
                let (x, y) = (*x, *y);
                self.multiply(x, y)
            }
            (Node::Negate(x), _) => {
                let x = *x;
                let product = self.multiply(x, b);
                self.negate(product)
            }
            (_, Node::Negate(y)) => {
                let y = *y;
                let product = self.multiply(a, y);
                self.negate(product)
            }
            (Node::Number(p), _) if is_minus_one(p) => self.negate(b),
            (_, Node::Number(q)) if is_minus_one(q) => self.negate(a),
            _ => self.intern(Node::Multiply(a, b)),
        }
    }

    /// a / b; a division by the number 0 stays as written and is undefined everywhere.
    pub fn divide(&mut self, a: Expr, b: Expr) -> Expr {
        if self.is_one(b) {
            return a;
        }
        match (self.node(a), self.node(b)) {
            (Node::Number(p), Node::Number(q)) if !q.is_zero() => {
                let quotient = p / q;
                self.number(quotient)
            }
            (Node::Number(p), Node::Number(_)) if p.is_zero() => self.intern(Node::Divide(a, b)),
            (Node::Number(p), _) if p.is_zero() => a,
            (Node::Negate(x), _) => {
                let x = *x;
                let quotient = self.divide(x, b);
                self.negate(quotient)
            }
            (_, Node::Negate(y)) => {
                let y = *y;
                let quotient = self.divide(a, y);
                self.negate(quotient)
            }
            _ => self.intern(Node::Divide(a, b)),
        }
    }

    /// aʳ. An outer integer power merges with the inner one: (aʳ)ⁿ = a^(rn) wherever aʳ is real.
    pub fn power(&mut self, a: Expr, exponent: Ratio<i64>) -> Expr {
        if exponent.is_zero() {
            return self.integer(1);
        }
        if exponent.is_one() || self.is_one(a) {
            return a;
        }
        match self.node(a) {
            Node::Power(base, inner) if exponent.is_integer() => {
                let base = *base;
                match inner.numer().checked_mul(*exponent.numer()) {
                    Some(numerator) => self.power(base, Ratio::new(numerator, *inner.denom())),
                    None => self.intern(Node::Power(a, exponent)),
                }
            }
            Node::Number(value) if exponent.is_integer() => match integer_power(value, *exponent.numer()) {
                Some(folded) => self.number(folded),
                None => self.intern(Node::Power(a, exponent)),
            },
            _ => self.intern(Node::Power(a, exponent)),
        }
    }

    /// √a
    pub fn sqrt(&mut self, a: Expr) -> Expr {
        self.power(a, Ratio::new(1, 2))
    }

    /// Applies a function of the operation table to its arguments.
    pub fn apply(&mut self, operation: Operation, arguments: &[Expr]) -> Expr {
        debug_assert_eq!(arguments.len(), operation.arity());
        self.intern(Node::Apply(operation, arguments.into()))
    }

    /// Builds a partial derivative of an unknown function at the given arguments, or the function's
    /// value if all orders are zero. The derivative of a primitive with respect to an upper limit
    /// is its integrand there, and a primitive from 0 to 0 is 0. Derivatives of a quadrature are
    /// expanded.
    pub fn jet(&mut self, function: FunctionId, orders: &[u32], arguments: &[Expr]) -> Expr {
        if let Some(lowered) = self.lowered(function, orders, arguments) {
            return lowered;
        }
        if let Some(derivative) = self.derivative_of_quadrature(function, orders, arguments) {
            return derivative;
        }
        if self.quadrature_of(function).is_some() && arguments[0] == arguments[1] {
            return self.integer(0);
        }
        if arguments[..self.upper_ends(function)].iter().any(|&end| self.is_zero(end)) {
            return self.integer(0);
        }
        if let Some(ordered) = self.in_order(function, orders, arguments) {
            return self.intern(ordered);
        }
        self.intern(Node::Jet { function, orders: orders.into(), arguments: arguments.into() })
    }

    /// Builds `then` where the relation holds, else `otherwise`.
    pub fn select(
        &mut self,
        (left, relation, right): (Expr, Relation, Expr),
        then: Expr,
        otherwise: Expr,
        seam: Seam,
    ) -> Expr {
        if then == otherwise {
            return then;
        }
        self.intern(Node::Select { left, relation, right, then, otherwise, seam })
    }
}

fn is_minus_one(value: &Rational) -> bool {
    value.is_negative() && value.denom().is_one() && value.numer().magnitude().is_one()
}

fn integer_power(value: &Rational, exponent: i64) -> Option<Rational> {
    let size = value.numer().bits().max(value.denom().bits());
    if size.saturating_mul(exponent.unsigned_abs()) > FOLDED_POWER_BITS || (value.is_zero() && exponent < 0) {
        return None;
    }
    let power = num_traits::pow(value.clone(), usize::try_from(exponent.unsigned_abs()).ok()?);
    Some(if exponent < 0 { power.recip() } else { power })
}
