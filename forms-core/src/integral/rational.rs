//! Antiderivatives of rational functions of one variable, by partial fractions over the field of
//! the other variables.
//!
//! ∫ c/(ax+b)ʲ is a logarithm or a power. For p = ax²+bx+c with δ = 4ac − b²: ∫ p′/p = log|p|; ∫
//! 1/p = (2/√δ) atan((2ax+b)/√δ) for δ > 0, and (1/ε) log|(2ax+b−ε)/(2ax+b+ε)| with ε = √−δ for δ <
//! 0; and ∫ 1/pʲ⁺¹ = (2ax+b)/(jδ pʲ) + (2a(2j−1)/(jδ)) ∫ 1/pʲ.

use super::Failure;
use super::known_sign::Strictness;
use super::signs::Region;
use crate::expression::{Expr, Operation, Pool, Symbol};
use crate::normal::{Fraction, Obstacle, RationalFunction, Tower, Univariate};
use crate::polynomial::Polynomial;
use num_traits::Signed;

/// The largest power of one factor in a denominator.
const HIGHEST_POWER: u32 = 24;

/// Largest number that is tried as a divisor of the end coefficients of a polynomial that may have
/// rational roots.
const LARGEST_DIVISOR: i64 = 1000;

/// A part of an antiderivative.
pub(super) enum Part {
    /// A rational function.
    Rational(Expr),
    /// coefficient · log|argument|
    Logarithm(Expr, Expr),
    /// coefficient · atan(above/below), where `below` does not depend on the variable
    ArcTangent(Expr, Expr, Expr),
}

impl Part {
    pub(super) fn expression(self, pool: &mut Pool) -> Expr {
        match self {
            Part::Rational(value) => value,
            Part::Logarithm(coefficient, argument) => {
                let magnitude = pool.apply(Operation::Abs, &[argument]);
                let logarithm = pool.apply(Operation::Log, &[magnitude]);
                pool.multiply(coefficient, logarithm)
            }
            Part::ArcTangent(coefficient, above, below) => {
                let quotient = pool.divide(above, below);
                let angle = pool.apply(Operation::Atan, &[quotient]);
                pool.multiply(coefficient, angle)
            }
        }
    }
}

/// One integration: the tower of the integrand, the variable and its generator.
pub(super) struct Rational<'a> {
    pub(super) pool: &'a mut Pool,
    pub(super) tower: &'a mut Tower,
    pub(super) region: &'a Region,
    pub(super) symbol: Symbol,
}

type Computed<T> = Result<T, Failure>;

impl Rational<'_> {
    /// Returns the parts of an antiderivative of an element that is rational in the variable.
    pub(super) fn antiderivative(&mut self, integrand: &Fraction) -> Computed<Vec<Part>> {
        let variable = self.tower.variable_number(self.symbol);
        let function = self.tower.rational_function(integrand, variable)?;
        let function = self.factored(function)?;
        let mut parts = Vec::new();
        let mut whole = Univariate::one();
        for (factor, exponent) in &function.denominator {
            if *exponent > HIGHEST_POWER {
                return Err(format!("a denominator to a power above {HIGHEST_POWER}").into());
            }
            let power = self.tower.univariate_power(factor, *exponent)?;
            whole = self.tower.univariate_product(&whole, &power)?;
        }
        let (quotient, rest) = self.tower.univariate_division(&function.numerator, &whole)?;
        parts.push(Part::Rational(self.polynomial_antiderivative(&quotient)?));
        for (factor, exponent) in &function.denominator {
            let power = self.tower.univariate_power(factor, *exponent)?;
            let (cofactor, _) = self.tower.univariate_division(&whole, &power)?;
            let inverse = self.tower.univariate_inverse(&cofactor, &power)?;
            let product = self.tower.univariate_product(&rest, &inverse)?;
            let (_, mut digits) = self.tower.univariate_division(&product, &power)?;
            // digits / pᵐ = Σ dⱼ / pʲ
            for j in (1..=*exponent).rev() {
                let (above, digit) = self.tower.univariate_division(&digits, factor)?;
                digits = above;
                if !digit.is_zero() {
                    self.simple_fraction(&digit, factor, j, &mut parts)?;
                }
            }
        }
        Ok(parts)
    }

    /// Σ aₖ xᵏ⁺¹/(k+1)
    fn polynomial_antiderivative(&mut self, polynomial: &Univariate) -> Computed<Expr> {
        let x = self.pool.symbol(self.symbol);
        let mut sum = self.pool.integer(0);
        for (k, coefficient) in polynomial.coefficients().iter().enumerate() {
            let coefficient = self.tower.raise(self.pool, coefficient);
            let power = self.pool.power(x, (k as i64 + 1).into());
            let share = self.pool.ratio(1, k as i64 + 1);
            let scaled = self.pool.multiply(share, power);
            let term = self.pool.multiply(coefficient, scaled);
            sum = self.pool.add(sum, term);
        }
        Ok(sum)
    }

    fn expression(&mut self, polynomial: &Univariate) -> Expr {
        let x = self.pool.symbol(self.symbol);
        let mut sum = self.pool.integer(0);
        for (k, coefficient) in polynomial.coefficients().iter().enumerate().rev() {
            let coefficient = self.tower.raise(self.pool, coefficient);
            let power = self.pool.power(x, (k as i64).into());
            let term = self.pool.multiply(coefficient, power);
            sum = self.pool.add(sum, term);
        }
        sum
    }

    /// ∫ d/pʲ with deg d < deg p, by the degree of p
    fn simple_fraction(
        &mut self,
        digit: &Univariate,
        factor: &Univariate,
        j: u32,
        parts: &mut Vec<Part>,
    ) -> Computed<()> {
        match factor.degree() {
            1 => {
                let inverse = self.tower.inverse(&factor.coefficient(1))?;
                let slope = self.tower.multiply(&digit.coefficient(0), &inverse)?;
                self.power_or_logarithm(&slope, factor, j, parts)
            }
            2 => self.over_quadratic(digit, factor, j, parts),
            _ => self.over_higher_degree(digit, factor, j, parts),
        }
    }

    /// ∫ c p′/pʲ, which is known for p of any degree
    fn over_higher_degree(
        &mut self,
        digit: &Univariate,
        p: &Univariate,
        j: u32,
        parts: &mut Vec<Part>,
    ) -> Computed<()> {
        let mut derivative = Vec::new();
        for (k, coefficient) in p.coefficients().iter().enumerate().skip(1) {
            derivative.push(self.tower.multiply(coefficient, &Polynomial::integer(k as i64).into())?);
        }
        let (share, rest) = self.tower.univariate_division(digit, &Univariate::new(derivative))?;
        if share.degree() > 0 || !rest.is_zero() {
            let degree = p.degree();
            return Err(format!("a denominator of degree {degree} that was not factored").into());
        }
        self.power_or_logarithm(&share.coefficient(0), p, j, parts)
    }

    /// ∫ c p′/pʲ = c log|p| or −c/((j−1) pʲ⁻¹)
    fn power_or_logarithm(
        &mut self,
        c: &Fraction,
        factor: &Univariate,
        j: u32,
        parts: &mut Vec<Part>,
    ) -> Computed<()> {
        if c.is_zero() {
            return Ok(());
        }
        let coefficient = self.tower.raise(self.pool, c);
        let below = self.expression(factor);
        parts.push(if j == 1 {
            Part::Logarithm(coefficient, below)
        } else {
            let power = self.pool.power(below, (1 - i64::from(j)).into());
            let share = self.pool.ratio(-1, i64::from(j) - 1);
            let scaled = self.pool.multiply(share, power);
            Part::Rational(self.pool.multiply(coefficient, scaled))
        });
        Ok(())
    }

    /// (ex + f)/pʲ = (e/2a) p′/pʲ + (f − eb/2a)/pʲ
    fn over_quadratic(
        &mut self,
        digit: &Univariate,
        p: &Univariate,
        j: u32,
        parts: &mut Vec<Part>,
    ) -> Computed<()> {
        let twice_a = self.tower.add(&p.coefficient(2), &p.coefficient(2))?;
        let inverse = self.tower.inverse(&twice_a)?;
        let share = self.tower.multiply(&digit.coefficient(1), &inverse)?;
        self.power_or_logarithm(&share, p, j, parts)?;
        let correction = self.tower.multiply(&share, &p.coefficient(1))?;
        let mut constant = self.tower.subtract(&digit.coefficient(0), &correction)?;
        if constant.is_zero() {
            return Ok(());
        }
        // δ = 4ac − b²
        let ac = self.tower.multiply(&p.coefficient(2), &p.coefficient(0))?;
        let four = Fraction::from(Polynomial::integer(4));
        let four_ac = self.tower.multiply(&four, &ac)?;
        let square = self.tower.multiply(&p.coefficient(1), &p.coefficient(1))?;
        let delta = self.tower.subtract(&four_ac, &square)?;
        let inverse = self.tower.inverse(&delta)?;
        let derivative = Univariate::new(vec![p.coefficient(1), twice_a.clone()]);
        for k in (1..j).rev() {
            // ∫ 1/pᵏ⁺¹ = p′/(kδ pᵏ) + 2a(2k−1)/(kδ) ∫ 1/pᵏ
            let over_k = Fraction::number(&crate::expression::Rational::new(1.into(), k.into()));
            let step = self.tower.multiply(&inverse, &over_k)?;
            let share = self.tower.multiply(&constant, &step)?;
            let scaled = self.tower.univariate_scaled(&derivative, &share)?;
            let (above, below) = (self.expression(&scaled), self.expression(p));
            let power = self.pool.power(below, i64::from(k).into());
            parts.push(Part::Rational(self.pool.divide(above, power)));
            let odd = Fraction::from(Polynomial::integer(2 * i64::from(k) - 1));
            let factor = self.tower.multiply(&twice_a, &odd)?;
            constant = self.tower.multiply(&share, &factor)?;
        }
        self.inverse_quadratic(&constant, &delta, &derivative, parts)
    }

    /// ∫ c/p: an arc tangent or a logarithm, by the sign of δ.
    fn inverse_quadratic(
        &mut self,
        constant: &Fraction,
        delta: &Fraction,
        derivative: &Univariate,
        parts: &mut Vec<Part>,
    ) -> Computed<()> {
        let value = self.tower.raise(self.pool, delta);
        let above = self.expression(derivative);
        let coefficient = self.tower.raise(self.pool, constant);
        let two = self.pool.integer(2);
        match self.region.sign(self.pool, value) {
            Some((true, Strictness::Strict)) => {
                let root = self.root_of(delta);
                let twice = self.pool.multiply(two, coefficient);
                let share = self.pool.divide(twice, root);
                parts.push(Part::ArcTangent(share, above, root));
                Ok(())
            }
            Some((false, Strictness::Strict)) => {
                let negated = self.tower.negate(delta);
                let root = self.root_of(&negated);
                let share = self.pool.divide(coefficient, root);
                let (less, more) = (self.pool.subtract(above, root), self.pool.add(above, root));
                let negative = self.pool.negate(share);
                parts.push(Part::Logarithm(share, less));
                parts.push(Part::Logarithm(negative, more));
                Ok(())
            }
            _ => Err(format!("the sign of `{}` is not known", self.pool.text(value)).into()),
        }
    }

    /// Returns √a, without a root sign if a is the square of a positive element.
    fn root_of(&mut self, a: &Fraction) -> Expr {
        if let Some(root) = self.tower.exact_root(a) {
            let root = self.tower.raise(self.pool, &root);
            match self.region.sign(self.pool, root) {
                Some((true, _)) => return root,
                Some((false, _)) => return self.pool.negate(root),
                None => {}
            }
        }
        let value = self.tower.raise(self.pool, a);
        self.pool.sqrt(value)
    }

    /// Factors the denominator into factors of degree 1 or 2, where rational roots and square
    /// discriminants allow it.
    fn factored(&mut self, function: RationalFunction) -> Computed<RationalFunction> {
        let mut denominator = Vec::new();
        let mut rest = function.denominator;
        while let Some((factor, exponent)) = rest.pop() {
            let split = match factor.degree() {
                0 | 1 => None,
                2 => self.split_quadratic(&factor)?,
                _ => self.split_by_root(&factor)?.or(self.split_biquadratic(&factor)?),
            };
            match split {
                Some((one, other)) => rest.extend([(one, exponent), (other, exponent)]),
                None => denominator.push((factor, exponent)),
            }
        }
        denominator.reverse();
        Ok(RationalFunction { numerator: function.numerator, denominator })
    }

    /// Factors a polynomial of degree 2 as a (x − r)(x − s) if b² − 4ac is a square.
    fn split_quadratic(&mut self, p: &Univariate) -> Computed<Option<(Univariate, Univariate)>> {
        let (a, b, c) = (p.coefficient(2), p.coefficient(1), p.coefficient(0));
        let ac = self.tower.multiply(&a, &c)?;
        let four_ac = self.tower.multiply(&Polynomial::integer(4).into(), &ac)?;
        let square = self.tower.multiply(&b, &b)?;
        let discriminant = self.tower.subtract(&square, &four_ac)?;
        let Some(root) = self.tower.exact_root(&discriminant) else { return Ok(None) };
        let twice_a = self.tower.add(&a, &a)?;
        let inverse = self.tower.inverse(&twice_a)?;
        let sum = self.tower.add(&b, &root)?;
        let shift = self.tower.multiply(&sum, &inverse)?;
        let linear = Univariate::new(vec![shift, Fraction::one()]);
        let (other, _) = self.tower.univariate_division(p, &linear)?;
        Ok(Some((linear, other)))
    }

    /// Splits off a rational root of a polynomial with rational coefficients.
    fn split_by_root(&mut self, p: &Univariate) -> Computed<Option<(Univariate, Univariate)>> {
        let numbers: Option<Vec<_>> = p.coefficients().iter().map(Fraction::as_number).collect();
        let Some(numbers) = numbers else { return Ok(None) };
        let common = numbers
            .iter()
            .fold(num_bigint::BigInt::from(1), |all, number| num_integer::Integer::lcm(&all, number.denom()));
        let integer = |k: usize| (numbers[k].clone() * &common).to_integer();
        let divisors = |number: num_bigint::BigInt| {
            let number = number.abs();
            (1..=LARGEST_DIVISOR).filter(move |d| (&number % d) == 0.into())
        };
        for below in divisors(integer(p.degree())) {
            for above in divisors(integer(0)).flat_map(|d| [d, -d]) {
                let candidate = crate::expression::Rational::new(above.into(), below.into());
                let root = Fraction::number(&candidate);
                if self.tower.univariate_at(p, &root)?.is_zero() {
                    let linear = Univariate::new(vec![self.tower.negate(&root), Fraction::one()]);
                    let (other, _) = self.tower.univariate_division(p, &linear)?;
                    return Ok(Some((linear, other)));
                }
            }
        }
        Ok(None)
    }

    /// Factors a x⁴ + b x² + c: two factors in x², or with q = √(c/a) and r = √(2q − b/a) the
    /// factors x² ± rx + q.
    fn split_biquadratic(&mut self, p: &Univariate) -> Computed<Option<(Univariate, Univariate)>> {
        let even = p.degree() == 4 && p.coefficient(1).is_zero() && p.coefficient(3).is_zero();
        if !even {
            return Ok(None);
        }
        let (a, b, c) = (p.coefficient(4), p.coefficient(2), p.coefficient(0));
        let in_square = Univariate::new(vec![c.clone(), b.clone(), a.clone()]);
        if let Some((one, other)) = self.split_quadratic(&in_square)? {
            let spread =
                |p: &Univariate| Univariate::new(vec![p.coefficient(0), Fraction::zero(), p.coefficient(1)]);
            return Ok(Some((spread(&one), spread(&other))));
        }
        let inverse = self.tower.inverse(&a)?;
        let ratio = self.tower.multiply(&c, &inverse)?;
        let Some(q) = self.tower.exact_root(&ratio) else { return Ok(None) };
        let middle = self.tower.multiply(&b, &inverse)?;
        let twice = self.tower.add(&q, &q)?;
        let square = self.tower.subtract(&twice, &middle)?;
        let Some(r) = self.tower.exact_root(&square) else { return Ok(None) };
        let linear = self.tower.negate(&r);
        let one = Univariate::new(vec![q.clone(), r, Fraction::one()]);
        let other = Univariate::new(vec![q, linear, Fraction::one()]);
        Ok(Some((one, self.tower.univariate_scaled(&other, &a)?)))
    }
}

impl From<Obstacle> for Failure {
    fn from(obstacle: Obstacle) -> Self {
        Failure(match obstacle {
            Obstacle::DivisionByZero => "the integrand divides by zero".to_string(),
            Obstacle::Outside(part) => part.to_string(),
            Obstacle::TooLarge(limit) => limit.to_string(),
            Obstacle::Refine => "the radicands of the integrand could not be factored".to_string(),
        })
    }
}
