//! Coefficients of the calculus: a commutative ring with commuting partial derivatives.

use super::blade::Coordinate;
use crate::expression::{Expr, Nature, Operation, Pool, Symbol};

/// A signed product ±a b.
pub type Product<'a, S> = (i8, &'a S, &'a S);

/// A commutative ring with one derivation for each coordinate.
///
/// Zero may be hidden (a structured expression need not be recognised as zero);
/// [`Coefficients::is_zero`] returns true only where this is certain, and the calculus uses it only
/// to omit terms.
pub trait Coefficients {
    /// Type of the elements.
    type Scalar: Clone;

    /// 0
    fn zero(&mut self) -> Self::Scalar;
    /// 1
    fn one(&mut self) -> Self::Scalar;
    /// Whether the element is certainly 0.
    fn is_zero(&self, a: &Self::Scalar) -> bool;
    /// a + b
    fn add(&mut self, a: &Self::Scalar, b: &Self::Scalar) -> Self::Scalar;
    /// −a
    fn negate(&mut self, a: &Self::Scalar) -> Self::Scalar;
    /// a b
    fn multiply(&mut self, a: &Self::Scalar, b: &Self::Scalar) -> Self::Scalar;
    /// ∂a/∂x
    fn derivative(&mut self, a: &Self::Scalar, by: Coordinate) -> Self::Scalar;

    /// Σ ±a b; a ring can override it if this is faster than single products.
    fn sum_of_products(&mut self, terms: &[Product<'_, Self::Scalar>]) -> Self::Scalar {
        let mut sum = self.zero();
        for &(sign, a, b) in terms {
            let product = self.multiply(a, b);
            let signed = if sign < 0 { self.negate(&product) } else { product };
            sum = self.add(&sum, &signed);
        }
        sum
    }

    /// One Σ ±a b for each group; a ring can override it to compute the groups in parallel.
    fn sums_of_products(&mut self, groups: &[Vec<Product<'_, Self::Scalar>>]) -> Vec<Self::Scalar> {
        groups.iter().map(|group| self.sum_of_products(group)).collect()
    }

    /// Σ ±∂a/∂x; a ring can override it if this is faster than single derivatives.
    fn sum_of_derivatives(&mut self, terms: &[(i8, &Self::Scalar, Coordinate)]) -> Self::Scalar {
        let mut partials = Vec::with_capacity(terms.len());
        for &(sign, a, by) in terms {
            let partial = self.derivative(a, by);
            if !self.is_zero(&partial) {
                partials.push((sign, partial));
            }
        }
        self.sum(&partials)
    }

    /// Σ ±a
    fn sum(&mut self, terms: &[(i8, Self::Scalar)]) -> Self::Scalar {
        let mut sum = self.zero();
        for (sign, a) in terms {
            let signed = if *sign < 0 { self.negate(a) } else { a.clone() };
            sum = self.add(&sum, &signed);
        }
        sum
    }
}

/// Structured expressions as coefficients; `coordinates` gives each coordinate's variable.
pub struct Structured<'a> {
    /// The pool of the expressions.
    pub pool: &'a mut Pool,
    /// The variable of each coordinate, by its number.
    pub coordinates: &'a [Symbol],
}

impl Coefficients for Structured<'_> {
    type Scalar = Expr;

    fn zero(&mut self) -> Expr {
        self.pool.integer(0)
    }

    fn one(&mut self) -> Expr {
        self.pool.integer(1)
    }

    fn is_zero(&self, a: &Expr) -> bool {
        self.pool.is_zero(*a)
    }

    fn add(&mut self, a: &Expr, b: &Expr) -> Expr {
        self.pool.add(*a, *b)
    }

    fn negate(&mut self, a: &Expr) -> Expr {
        self.pool.negate(*a)
    }

    fn multiply(&mut self, a: &Expr, b: &Expr) -> Expr {
        self.pool.multiply(*a, *b)
    }

    fn derivative(&mut self, a: &Expr, by: Coordinate) -> Expr {
        self.pool.derivative(*a, self.coordinates[by.0 as usize])
    }
}

/// Coefficients that support division and roots of magnitudes.
pub trait Quotients: Coefficients {
    /// a / b
    fn divide(&mut self, a: &Self::Scalar, b: &Self::Scalar) -> Self::Scalar;
    /// √|a| and the sign a/|a|.
    fn magnitude(&mut self, a: &Self::Scalar) -> (Self::Scalar, Self::Scalar);
}

impl Quotients for Structured<'_> {
    fn divide(&mut self, a: &Expr, b: &Expr) -> Expr {
        self.pool.divide(*a, *b)
    }

    fn magnitude(&mut self, a: &Expr) -> (Expr, Expr) {
        let negated = self.pool.negate(*a);
        for (number, value) in [(1, *a), (-1, negated)] {
            if self.pool.nature(value) >= Nature::NotNegative {
                return (self.pool.sqrt(value), self.pool.integer(number));
            }
        }
        let magnitude = self.pool.apply(Operation::Abs, &[*a]);
        (self.pool.sqrt(magnitude), self.pool.divide(*a, magnitude))
    }
}
