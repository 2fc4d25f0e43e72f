//! Generators of the field in which expressions are compared: each is one variable of the polynomials.

use super::factor::FactorPower;
use super::fraction::Fraction;
use crate::expression::{FunctionId, Operation, Symbol};

/// The number of an interned denominator factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct FactorId(pub(super) u32);

/// A product of generators over known factors, without a number in front: what an angle or an exponent is a
/// rational combination of.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Quantity {
    pub(super) monomial: Vec<(u32, u32)>,
    pub(super) factors: Vec<FactorPower>,
}

/// A function of one unit u = quantity/divisor of an angle or exponent.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Unit {
    /// What is divided …
    pub(super) quantity: Quantity,
    /// … into this many parts.
    pub(super) divisor: u32,
}

impl Quantity {
    /// The product of generators, if nothing is divided by.
    pub(crate) fn as_monomial(&self) -> Option<&[(u32, u32)]> {
        self.factors.is_empty().then_some(&self.monomial)
    }

    /// The one generator that it is, if it is no more than that.
    pub(super) fn as_variable(&self) -> Option<u32> {
        match self.as_monomial()? {
            [(variable, 1)] => Some(*variable),
            _ => None,
        }
    }
}

impl Unit {
    /// The product of generators that is divided into parts, if it has no denominator of its own.
    pub fn as_monomial(&self) -> Option<&[(u32, u32)]> {
        self.quantity.as_monomial()
    }

    /// Into how many parts the quantity is divided.
    pub fn divisor(&self) -> u32 {
        self.divisor
    }
}

/// What one polynomial variable stands for.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Generator {
    /// A real variable.
    Variable(Symbol),
    /// π, which no polynomial relation over ℚ binds.
    Pi,
    /// A derivative of an unknown function at the given arguments.
    Jet {
        /// The function.
        function: FunctionId,
        /// How often it is differentiated by each argument.
        orders: Vec<u32>,
        /// Where it is taken.
        arguments: Vec<Fraction>,
    },
    /// 2 cos(2π/q) or 2 sin(2π/q), bound by its minimal polynomial
    Chord {
        /// q
        sides: u32,
        /// Whether it is the sine.
        sine: bool,
    },
    /// cos u
    Cosine(Unit),
    /// sin u, bound by sin² u = 1 − cos² u
    Sine(Unit),
    /// tan(u/2), free: sin u and cos u are rational in it
    HalfTangent(Unit),
    /// exp u
    Exponential(Unit),
    /// (±g)^(1/n) for the base g of that number, with the sign that makes ±g positive
    Root {
        /// The base's number.
        base: usize,
        /// n
        order: u32,
        /// Whether the root is of −g.
        negated: bool,
    },
    /// log |g| for the base g of that number
    Logarithm {
        /// The base's number.
        base: usize,
    },
    /// A function of the op table that nothing more is known of.
    Opaque {
        /// The function.
        operation: Operation,
        /// Its arguments.
        arguments: Vec<Fraction>,
    },
}
