//! Obstacles: reasons why an expression has no normal form, as data.

use crate::expression::Rational;
use std::fmt;

/// Reason why an expression has no normal form here.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// A finer generator is needed (a half angle, a factor of a radicand); the conversion starts
    /// again.
    Refine,
    /// The expression divides by zero everywhere.
    DivisionByZero,
    /// A part lies outside the class that is decided.
    Outside(OutsidePart),
    /// The normal form is too large.
    TooLarge(SizeLimit),
}

/// Part of an expression outside the class that Forms decides.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum OutsidePart {
    /// A radical that contains radicals and that could not be denested, in the language's notation.
    NestedRadical(String),
    /// A root of this order.
    Root(i64),
    /// An angle of this many half turns.
    HalfTurns(Rational),
    /// An angle or exponent with this coefficient.
    AngleOrExponent(Rational),
    /// An exponent with this coefficient.
    Exponent(Rational),
    /// An angle of more than this number of parts.
    AngleParts(usize),
    /// A fraction of an angle that is an odd multiple of π.
    FractionOfHalfTurn,
    /// A multiple of the value of an inverse function.
    Multiple {
        /// The factor.
        coefficient: Rational,
        /// Name of the inverse function.
        function: &'static str,
    },
    /// The logarithm of zero.
    LogarithmOfZero,
    /// A derivative of the operation with this name.
    Derivative(&'static str),
    /// A conditional expression.
    Conditional,
}

impl fmt::Display for OutsidePart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OutsidePart::NestedRadical(radical) => write!(f, "the nested radical {radical}"),
            OutsidePart::Root(order) => write!(f, "a root of order {order}"),
            OutsidePart::HalfTurns(turns) => write!(f, "an angle of {turns} times pi"),
            OutsidePart::AngleOrExponent(coefficient) => {
                write!(f, "an angle or exponent with the coefficient {coefficient}")
            }
            OutsidePart::Exponent(coefficient) => write!(f, "an exponent with the coefficient {coefficient}"),
            OutsidePart::AngleParts(most) => write!(f, "an angle of more than {most} parts"),
            OutsidePart::FractionOfHalfTurn => {
                write!(f, "a fraction of an angle that is an odd multiple of pi")
            }
            OutsidePart::Multiple { coefficient, function } => write!(f, "{coefficient} times `{function}`"),
            OutsidePart::LogarithmOfZero => write!(f, "the logarithm of zero"),
            OutsidePart::Derivative(operation) => write!(f, "a derivative of {operation}"),
            OutsidePart::Conditional => write!(f, "an expression with `if`"),
        }
    }
}

/// Limit that a normal form exceeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SizeLimit {
    /// Largest number of products of terms.
    Products(u64),
    /// Largest exponent.
    Exponent(u32),
    /// Largest power of a sum.
    PowerOfSum(u64),
    /// Largest number of terms of a denominator of exponents.
    ExponentDenominator(usize),
    /// Largest number of refinements of radicands and angles.
    Refinements(usize),
    /// The steps of one statement.
    Steps,
}

impl fmt::Display for SizeLimit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SizeLimit::Products(most) => write!(f, "it takes more than {most} products of terms"),
            SizeLimit::Exponent(largest) => write!(f, "an exponent is beyond {largest}"),
            SizeLimit::PowerOfSum(largest) => write!(f, "a power of a sum is beyond {largest}"),
            SizeLimit::ExponentDenominator(most) => {
                write!(f, "a denominator of exponents has more than {most} terms")
            }
            SizeLimit::Refinements(most) => {
                write!(f, "its radicands and angles need more than {most} refinements")
            }
            SizeLimit::Steps => write!(f, "it exceeds the step limit of one statement"),
        }
    }
}
