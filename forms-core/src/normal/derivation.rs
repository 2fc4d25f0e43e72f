//! The tower as a ring of coefficients: partial derivatives of fractions.
//!
//! They follow from the chain rule over the generators, with Dρ = Df/(n ρⁿ⁻¹) for ρⁿ = f,
//! Dcos u = −sin u Du, Dsin u = cos u Du, Dtan(u/2) = (1 + tan²(u/2)) Du/2, Dexp u = exp u Du,
//! Dlog|g| = Dg/g, and the chain rule for jets.

use super::fraction::Fraction;
use super::generator::{Generator, Quantity, Unit};
use super::obstacle::{Obstacle, OutsidePart};
use super::power::FactorPower;
use super::tower::Tower;
use crate::calculus::{Coefficients, Coordinate, Product};
use crate::expression::{FunctionId, Operation, Rational, Symbol};
use crate::polynomial::Polynomial;
use num_traits::One;

impl Tower {
    /// ∂a/∂x
    ///
    /// # Errors
    /// If the derivative grows beyond the limit, or an opaque function without a derivative rule
    /// occurs.
    pub fn derivative(&mut self, a: &Fraction, by: Symbol) -> Result<Fraction, Obstacle> {
        if let Some(derivative) = self.plain_divergence(&[(1, a, by)])? {
            return Ok(derivative);
        }
        self.divergence(&[(1, a, by)])
    }

    /// Σ ∂N/∂γ Dγ over the generators.
    fn derivative_of_polynomial(
        &mut self,
        polynomial: &Polynomial,
        by: Symbol,
    ) -> Result<Fraction, Obstacle> {
        let mut sum = Fraction::zero();
        for variable in polynomial.variables() {
            let inner = self.derivative_of_generator(variable, by)?;
            if inner.is_zero() {
                continue;
            }
            let partial = self.reduce(polynomial.derivative(variable))?;
            let term = self.multiply(&partial.into(), &inner)?;
            sum = self.add(&sum, &term)?;
        }
        Ok(sum)
    }

    pub(super) fn derivative_of_generator(
        &mut self,
        variable: u32,
        by: Symbol,
    ) -> Result<Fraction, Obstacle> {
        match self.generator(variable).clone() {
            Generator::Variable(_) => {
                let motion = self.motion(by);
                let speed = motion.iter().find(|(moved, _)| *moved == variable).map_or(0, |entry| entry.1);
                Ok(Polynomial::integer(speed).into())
            }
            Generator::Pi | Generator::Chord { .. } => Ok(Fraction::zero()),
            Generator::Jet { function, orders, arguments } => {
                self.derivative_of_jet(function, &orders, &arguments, by)
            }
            Generator::Cosine(unit) => {
                let sine = self.element(Generator::Sine(unit.clone()));
                let negated = self.negate(&sine);
                self.times_derivative_of_unit(&negated, &unit, by)
            }
            Generator::Sine(unit) => {
                let cosine = self.element(Generator::Cosine(unit.clone()));
                self.times_derivative_of_unit(&cosine, &unit, by)
            }
            Generator::HalfTangent(unit) => {
                let norm = Polynomial::one().add(&Polynomial::variable(variable).square());
                let half = Fraction { numerator: norm, divisor: 2.into(), factors: vec![] };
                self.times_derivative_of_unit(&half, &unit, by)
            }
            Generator::Exponential(unit) => {
                let itself = Polynomial::variable(variable).into();
                self.times_derivative_of_unit(&itself, &unit, by)
            }
            Generator::Root { .. } => self.derivative_of_root(variable, by),
            Generator::Logarithm { base } => self.derivative_of_logarithm(base, by),
            Generator::Opaque { operation, arguments } => {
                self.derivative_of_opaque(operation, &arguments, by)
            }
        }
    }

    /// D f(a, b, …) = f₁ Da + f₂ Db + …
    fn derivative_of_jet(
        &mut self,
        function: FunctionId,
        orders: &[u32],
        arguments: &[Fraction],
        by: Symbol,
    ) -> Result<Fraction, Obstacle> {
        let mut sum = Fraction::zero();
        for (place, argument) in arguments.iter().enumerate() {
            let inner = self.derivative(argument, by)?;
            if inner.is_zero() {
                continue;
            }
            let mut raised = orders.to_vec();
            raised[place] += 1;
            let jet =
                self.element(Generator::Jet { function, orders: raised, arguments: arguments.to_vec() });
            let term = self.multiply(&jet, &inner)?;
            sum = self.add(&sum, &term)?;
        }
        Ok(sum)
    }

    /// Returns the products ±a b without denominators, with their work counted.
    fn charged<'f>(
        &mut self,
        terms: &[Product<'f, Fraction>],
    ) -> Result<Vec<(i64, &'f Polynomial, &'f Polynomial)>, Obstacle> {
        let mut products = Vec::with_capacity(terms.len());
        for (sign, a, b) in terms {
            self.charge(&a.numerator, &b.numerator)?;
            products.push((i64::from(*sign), &a.numerator, &b.numerator));
        }
        Ok(products)
    }

    /// Σ ±a b without denominators, reduced once.
    fn sum_of_polynomial_products(&mut self, terms: &[Product<'_, Fraction>]) -> Result<Fraction, Obstacle> {
        let products = self.charged(terms)?;
        Ok(self.reduce(Polynomial::sum_of_products(&products))?.into())
    }

    /// Σ ±a b without denominators for each group, each reduced once.
    fn sums_of_polynomial_products(
        &mut self,
        groups: &[Vec<Product<'_, Fraction>>],
    ) -> Result<Vec<Fraction>, Obstacle> {
        let products: Vec<Vec<_>> =
            groups.iter().map(|group| self.charged(group)).collect::<Result<_, _>>()?;
        let sums = Polynomial::sums_of_products(&products);
        sums.into_iter().map(|sum| Ok(self.reduce(sum)?.into())).collect()
    }

    fn times_derivative_of_unit(
        &mut self,
        outer: &Fraction,
        unit: &Unit,
        by: Symbol,
    ) -> Result<Fraction, Obstacle> {
        let quantity = self.quantity(&unit.quantity);
        let inner = self.derivative(&quantity, by)?;
        let part = Fraction::number(&Rational::new(1.into(), unit.divisor.into()));
        let inner = self.multiply(&inner, &part)?;
        self.multiply(outer, &inner)
    }

    /// Returns a quantity as a fraction.
    pub(super) fn quantity(&self, quantity: &Quantity) -> Fraction {
        let numerator = Polynomial::one().multiply_by_monomial(&quantity.monomial);
        self.cancel(numerator, One::one(), quantity.factors.clone())
    }

    /// Dρ = ρ Df/(n f) = Df/(n ρⁿ⁻¹)
    fn derivative_of_root(&mut self, variable: u32, by: Symbol) -> Result<Fraction, Obstacle> {
        let Some(relation) = self.relation_of(variable).cloned() else { return Ok(Fraction::zero()) };
        let inner = self.derivative_of_polynomial(&relation.value, by)?;
        let root = self.factor(Polynomial::variable(variable));
        let outer = Fraction {
            numerator: Polynomial::one(),
            divisor: relation.order.into(),
            factors: vec![FactorPower { factor: root, exponent: relation.order as i32 - 1 }],
        };
        self.multiply(&inner, &outer)
    }

    /// D log|g| = Dg/g
    fn derivative_of_logarithm(&mut self, base: usize, by: Symbol) -> Result<Fraction, Obstacle> {
        let argument = self.bases[base].polynomial.clone();
        let inner = self.derivative_of_polynomial(&argument, by)?;
        if inner.is_zero() {
            return Ok(inner);
        }
        let outer = self.inverse(&argument.into())?;
        self.multiply(&outer, &inner)
    }

    fn derivative_of_opaque(
        &mut self,
        operation: Operation,
        arguments: &[Fraction],
        by: Symbol,
    ) -> Result<Fraction, Obstacle> {
        let mut inner = Vec::with_capacity(arguments.len());
        for argument in arguments {
            inner.push(self.derivative(argument, by)?);
        }
        if inner.iter().all(Fraction::is_zero) {
            return Ok(Fraction::zero());
        }
        match operation {
            Operation::Atan => {
                let square = self.multiply(&arguments[0], &arguments[0])?;
                let norm = self.add(&Fraction::one(), &square)?;
                let outer = self.inverse(&norm)?;
                self.multiply(&outer, &inner[0])
            }
            _ => Err(Obstacle::Outside(OutsidePart::Derivative(operation.row().name))),
        }
    }
}

/// Fractions as coefficients of forms. The first obstacle is kept and every later result is zero,
/// so code that uses forms over this ring has to check [`Normal::obstacle`] before it trusts a
/// result.
pub struct Normal<'a> {
    tower: &'a mut Tower,
    coordinates: &'a [Symbol],
    obstacle: Option<Obstacle>,
}

impl<'a> Normal<'a> {
    /// Creates the ring over a tower; `coordinates` gives the variable of each coordinate.
    pub fn new(tower: &'a mut Tower, coordinates: &'a [Symbol]) -> Self {
        Normal { tower, coordinates, obstacle: None }
    }

    /// Returns the first obstacle that a computation met, if any.
    pub fn obstacle(&self) -> Option<&Obstacle> {
        self.obstacle.as_ref()
    }

    fn keep(&mut self, result: Result<Fraction, Obstacle>) -> Fraction {
        result.unwrap_or_else(|obstacle| {
            self.obstacle.get_or_insert(obstacle);
            Fraction::zero()
        })
    }
}

impl Coefficients for Normal<'_> {
    type Scalar = Fraction;

    fn zero(&mut self) -> Fraction {
        Fraction::zero()
    }

    fn one(&mut self) -> Fraction {
        Fraction::one()
    }

    fn is_zero(&self, a: &Fraction) -> bool {
        a.is_zero()
    }

    fn add(&mut self, a: &Fraction, b: &Fraction) -> Fraction {
        let sum = self.tower.add(a, b);
        self.keep(sum)
    }

    fn negate(&mut self, a: &Fraction) -> Fraction {
        self.tower.negate(a)
    }

    fn multiply(&mut self, a: &Fraction, b: &Fraction) -> Fraction {
        let product = self.tower.multiply(a, b);
        self.keep(product)
    }

    fn derivative(&mut self, a: &Fraction, by: Coordinate) -> Fraction {
        let derivative = self.tower.derivative(a, self.coordinates[by.0 as usize]);
        self.keep(derivative)
    }

    fn sum_of_derivatives(&mut self, terms: &[(i8, &Fraction, Coordinate)]) -> Fraction {
        let coordinates = self.coordinates;
        let symbols: Vec<_> =
            terms.iter().map(|&(sign, a, by)| (sign, a, coordinates[by.0 as usize])).collect();
        let sum = self.tower.divergence(&symbols);
        self.keep(sum)
    }

    fn sum(&mut self, terms: &[(i8, Fraction)]) -> Fraction {
        let signed: Vec<Fraction> = terms
            .iter()
            .map(|(sign, term)| if *sign < 0 { self.tower.negate(term) } else { term.clone() })
            .collect();
        let sum = self.tower.sum(&signed);
        self.keep(sum)
    }

    fn sums_of_products(&mut self, groups: &[Vec<Product<'_, Fraction>>]) -> Vec<Fraction> {
        if !groups.iter().all(|group| without_denominators(group)) {
            return groups.iter().map(|group| self.sum_of_products(group)).collect();
        }
        self.tower.sums_of_polynomial_products(groups).unwrap_or_else(|obstacle| {
            self.obstacle.get_or_insert(obstacle);
            vec![Fraction::zero(); groups.len()]
        })
    }

    fn sum_of_products(&mut self, terms: &[Product<'_, Fraction>]) -> Fraction {
        if without_denominators(terms) {
            let sum = self.tower.sum_of_polynomial_products(terms);
            return self.keep(sum);
        }
        let mut sum = Fraction::zero();
        for &(sign, a, b) in terms {
            let product = self.multiply(a, b);
            let signed = if sign < 0 { self.tower.negate(&product) } else { product };
            sum = self.add(&sum, &signed);
        }
        sum
    }
}

fn without_denominators(terms: &[Product<'_, Fraction>]) -> bool {
    terms.iter().all(|(_, a, b)| a.is_polynomial() && b.is_polynomial())
}
