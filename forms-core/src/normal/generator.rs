//! Generators of the field in which expressions are compared; each is one variable of the
//! polynomials.

use super::fraction::Fraction;
use super::power::FactorPower;
use crate::expression::{FunctionId, Operation, Symbol};

/// Representation of sines and cosines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trigonometry {
    /// By c and s with s² = 1 − c²: small and readable, but not a ring with unique factorisation.
    Circle,
    /// By t = tan(u/2), in which radicands can be factored.
    HalfAngle,
}

/// Product of generators over known factors, without a numeric coefficient. An angle or an exponent
/// is a rational combination of quantities.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Quantity {
    pub(super) monomial: Vec<(u32, u32)>,
    pub(super) factors: Vec<FactorPower>,
}

/// Unit u = quantity/divisor of an angle or exponent, of which a generator is a function.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Unit {
    /// The quantity that is divided …
    pub(super) quantity: Quantity,
    /// … into this many parts.
    pub(super) divisor: u32,
}

impl Quantity {
    /// Returns the product of generators, if there is no denominator.
    pub(crate) fn as_monomial(&self) -> Option<&[(u32, u32)]> {
        self.factors.is_empty().then_some(&self.monomial)
    }

    /// Returns the generator that the quantity consists of, if it is a single one.
    pub(super) fn as_variable(&self) -> Option<u32> {
        match self.as_monomial()? {
            [(variable, 1)] => Some(*variable),
            _ => None,
        }
    }
}

impl Unit {
    /// Returns the product of generators that is divided into parts, if it has no denominator of
    /// its own.
    pub fn as_monomial(&self) -> Option<&[(u32, u32)]> {
        self.quantity.as_monomial()
    }

    /// Returns the number of parts that the quantity is divided into.
    pub fn divisor(&self) -> u32 {
        self.divisor
    }
}

/// Function that one polynomial variable represents.
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
        /// Order of differentiation in each argument.
        orders: Vec<u32>,
        /// Arguments at which it is evaluated.
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
    /// (±g)^(1/n) for the base g with this number, with the sign that makes ±g positive
    Root {
        /// Number of the base.
        base: usize,
        /// n
        order: u32,
        /// Whether the root is of −g.
        negated: bool,
    },
    /// log |g| for the base g with this number
    Logarithm {
        /// Number of the base.
        base: usize,
    },
    /// A function of the operation table without further known relations.
    Opaque {
        /// The function.
        operation: Operation,
        /// Its arguments.
        arguments: Vec<Fraction>,
    },
}
