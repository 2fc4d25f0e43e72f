//! Integrands with one root of a linear or quadratic polynomial: substitutions that make them
//! rational.
//!
//! For ρⁿ = ax + b: x = (ρⁿ − b)/a. For ρ² = q = a s² + C, with s the distance from the vertex, an
//! integrand R(s)ρ is split into an odd part s O(s²)ρ, rational in y = ρ since s ds = ρ dρ/a, and
//! an even part E(s²)ρ, rational in y = s/ρ since s² = Cy²/(1 − ay²), ρ² = C/(1 − ay²) and ds = ρ³
//! dy/C.

use super::rational::{Part, Rational};
use super::search::{Integrand, Search};
use super::{Failure, normal_form, tidied};
use crate::expression::{Expr, Operation, Substitution, Symbol, SymbolKind};
use crate::normal::{Fraction, Generator, Tower, Trigonometry, Univariate};
use crate::polynomial::Polynomial;

type Computed<T> = Result<T, Failure>;

/// A root with ρ² = a s² + C, s = x + shift, and the root as an expression.
struct Quadratic {
    a: Fraction,
    c: Fraction,
    shift: Fraction,
    root: Expr,
}

impl Search<'_> {
    /// Returns an antiderivative, if the only irrational part is one root of a linear or quadratic
    /// polynomial. Two square roots of linear polynomials count as one if they occur only together.
    pub(super) fn radical(&mut self, integrand: &mut Integrand) -> Computed<Option<Expr>> {
        let roots = integrand.such_that(|generator| matches!(generator, Generator::Root { .. }));
        let x = integrand.tower.variable_number(integrand.symbol);
        if integrand.generators.iter().any(|generator| *generator != x && !roots.contains(generator)) {
            return Ok(None);
        }
        let mut radicands = Vec::new();
        for &root in &roots {
            let Some((radicand, order)) = integrand.tower.radicand(root) else { return Ok(None) };
            if radicand.variables().iter().any(|v| *v != x && integrand.generators.contains(v)) {
                return Ok(None);
            }
            radicands.push((integrand.tower.univariate(&radicand, x), order));
        }
        match (&roots[..], &radicands[..]) {
            ([root], [(radicand, order)]) if radicand.degree() == 1 => {
                self.under_linear(integrand, *root, radicand, *order).map(Some)
            }
            ([root], [(radicand, 2)]) if radicand.degree() == 2 => {
                let Some(terms) = integrand.tower.laurent_terms(&integrand.normal, &[*root]) else {
                    return Ok(None);
                };
                let terms = terms.into_iter().map(|(powers, part)| (powers[0], part)).collect();
                self.under_quadratic(integrand, radicand, terms)
            }
            ([_, _], [(first, 2), (second, 2)]) if first.degree() == 1 && second.degree() == 1 => {
                self.under_two(integrand, &roots, (first, second))
            }
            _ => Ok(None),
        }
    }

    /// Rewrites ρ₁ⁱρ₂ʲ with odd i and j as (ρ₁ρ₂)ᵖ times powers of the radicands, with p the
    /// smaller of i and j.
    fn under_two(
        &mut self,
        integrand: &mut Integrand,
        roots: &[u32],
        (first, second): (&Univariate, &Univariate),
    ) -> Computed<Option<Expr>> {
        let tower = &mut *integrand.tower;
        let Some(terms) = tower.laurent_terms(&integrand.normal, roots) else { return Ok(None) };
        let x: Fraction = Polynomial::variable(tower.variable_number(integrand.symbol)).into();
        let values = [tower.univariate_at(first, &x)?, tower.univariate_at(second, &x)?];
        let mut joined = Vec::new();
        for (powers, mut part) in terms {
            let least = powers[0].min(powers[1]);
            for (power, value) in powers.iter().zip(&values) {
                if (power - least) % 2 != 0 {
                    return Ok(None);
                }
                let factor = tower.integer_power(value, i64::from(power - least) / 2)?;
                part = tower.multiply(&part, &factor)?;
            }
            joined.push((least, part));
        }
        let radicand = tower.univariate_product(first, second)?;
        self.under_quadratic(integrand, &radicand, joined)
    }

    /// x = (yⁿ − b)/a, dx = n yⁿ⁻¹/a dy
    fn under_linear(
        &mut self,
        integrand: &mut Integrand,
        root: u32,
        radicand: &Univariate,
        order: u32,
    ) -> Computed<Expr> {
        let tower = &mut *integrand.tower;
        let y = self.pool.declare_symbol("y", SymbolKind::Local);
        let number = tower.variable_number(y);
        let itself: Fraction = Polynomial::variable(number).into();
        let inverse = tower.inverse(&radicand.coefficient(1))?;
        let power = tower.integer_power(&itself, order.into())?;
        let difference = tower.subtract(&power, &radicand.coefficient(0))?;
        let x = tower.multiply(&difference, &inverse)?;
        let variable = tower.variable_number(integrand.symbol);
        let composed = tower.replaced(&integrand.normal, &[(variable, x), (root, itself.clone())])?;
        let lowered = tower.integer_power(&itself, i64::from(order) - 1)?;
        let times = Polynomial::integer(order.into()).into();
        let scaled = tower.multiply(&lowered, &times)?;
        let jacobian = tower.multiply(&scaled, &inverse)?;
        let rational = tower.multiply(&composed, &jacobian)?;
        let found = self.rational(integrand.tower, &rational, y)?;
        let value = integrand.tower.raise(self.pool, &Polynomial::variable(root).into());
        Ok(self.at(found, y, value))
    }

    fn at(&mut self, expression: Expr, symbol: Symbol, value: Expr) -> Expr {
        let values: Substitution = [(symbol, value)].into_iter().collect();
        self.pool.substitute(expression, &values)
    }

    /// ∫ Σ Rₖ(x) ρᵏ dx, with each coefficient free of roots of the variable.
    fn under_quadratic(
        &mut self,
        integrand: &mut Integrand,
        radicand: &Univariate,
        terms: Vec<(i32, Fraction)>,
    ) -> Computed<Option<Expr>> {
        let tower = &mut *integrand.tower;
        // q = a (x + b/2a)² + c − b²/4a
        let a = radicand.coefficient(2);
        let twice_a = tower.add(&a, &a)?;
        let inverse = tower.inverse(&twice_a)?;
        let shift = tower.multiply(&radicand.coefficient(1), &inverse)?;
        let correction = tower.multiply(&shift, &radicand.coefficient(1))?;
        let half = Fraction::number(&crate::expression::Rational::new(1.into(), 2.into()));
        let correction = tower.multiply(&half, &correction)?;
        let c = tower.subtract(&radicand.coefficient(0), &correction)?;
        if c.is_zero() {
            return Ok(None);
        }
        let x = tower.variable_number(integrand.symbol);
        let q = tower.univariate_at(radicand, &Polynomial::variable(x).into())?;
        let q = tower.raise(self.pool, &q);
        let quadratic = Quadratic { a, c, shift, root: self.pool.sqrt(q) };
        let mut sum = self.pool.integer(0);
        for (power, coefficient) in terms {
            let term = if power % 2 == 0 {
                let factor = self.pool.power(q, i64::from(power / 2).into());
                let rest = integrand.tower.raise(self.pool, &coefficient);
                let rational = self.pool.multiply(rest, factor);
                self.antiderivative(rational, integrand.symbol, integrand.conditions, 0)?
            } else {
                self.times_root(integrand, &coefficient, power, &quadratic)?
            };
            sum = self.pool.add(sum, term);
        }
        Ok(Some(sum))
    }

    /// ∫ R(x) ρᵖ dx for odd p
    fn times_root(
        &mut self,
        integrand: &mut Integrand,
        rational: &Fraction,
        power: i32,
        quadratic: &Quadratic,
    ) -> Computed<Expr> {
        let tower = &mut *integrand.tower;
        let x = tower.variable_number(integrand.symbol);
        let y = self.pool.declare_symbol("y", SymbolKind::Local);
        let itself: Fraction = { Polynomial::variable(tower.variable_number(y)).into() };
        // R as a function of s = x + shift
        let moved = tower.subtract(&Polynomial::variable(x).into(), &quadratic.shift)?;
        let centred = tower.replaced(rational, &[(x, moved)])?;
        let (even, odd) = even_and_odd(tower, &centred, x)?;
        let square = tower.integer_power(&itself, 2)?;
        // odd: s² = (y² − C)/a, s ds = y dy/a
        let inverse_a = tower.inverse(&quadratic.a)?;
        let difference = tower.subtract(&square, &quadratic.c)?;
        let s_squared = tower.multiply(&difference, &inverse_a)?;
        let odd = tower.replaced(&odd, &[(x, s_squared)])?;
        let raised = tower.integer_power(&itself, i64::from(power) + 1)?;
        let jacobian = tower.multiply(&raised, &inverse_a)?;
        let odd = tower.multiply(&odd, &jacobian)?;
        // even: s² = C y²/(1 − a y²), ρᵖ ds = ρᵖ⁺³/C dy
        let product = tower.multiply(&quadratic.a, &square)?;
        let below = tower.subtract(&Fraction::one(), &product)?;
        let inverse = tower.inverse(&below)?;
        let over = tower.multiply(&quadratic.c, &inverse)?;
        let s_squared = tower.multiply(&square, &over)?;
        let even = tower.replaced(&even, &[(x, s_squared)])?;
        let raised = tower.integer_power(&over, i64::from(power + 3) / 2)?;
        let inverse_c = tower.inverse(&quadratic.c)?;
        let jacobian = tower.multiply(&raised, &inverse_c)?;
        let even = tower.multiply(&even, &jacobian)?;
        let odd = self.rational(integrand.tower, &odd, y)?;
        let odd = self.at(odd, y, quadratic.root);
        let even = self.even_part(integrand, &even, y, quadratic)?;
        Ok(self.pool.add(odd, even))
    }

    /// Integrates the even part in y = s/ρ: its rational part without the quotient, and atan(√−a
    /// s/ρ) as asin(√(−a/C) s).
    fn even_part(
        &mut self,
        integrand: &mut Integrand,
        even: &Fraction,
        y: Symbol,
        quadratic: &Quadratic,
    ) -> Computed<Expr> {
        let (symbol, region) = (integrand.symbol, self.region);
        let mut rational = Rational { pool: self.pool, tower: integrand.tower, region, symbol: y };
        let parts = rational.antiderivative(even)?;
        let x = self.pool.symbol(symbol);
        let shift = integrand.tower.raise(self.pool, &quadratic.shift);
        let s = self.pool.add(x, shift);
        let quotient = self.pool.divide(s, quadratic.root);
        let mut sum = self.pool.integer(0);
        for part in parts {
            let term = match part {
                Part::Rational(value) => {
                    let value = self.at(value, y, quotient);
                    tidied(self.pool, value, integrand.conditions)
                }
                Part::Logarithm(coefficient, argument) => {
                    let argument = self.at(argument, y, quotient);
                    let argument = tidied(self.pool, argument, integrand.conditions);
                    Part::Logarithm(coefficient, argument).expression(self.pool)
                }
                Part::ArcTangent(coefficient, above, below) => {
                    let plain = Part::ArcTangent(coefficient, above, below).expression(self.pool);
                    match self.arc_sine(integrand, (above, below), y, quadratic, s)? {
                        Some(angle) => self.pool.multiply(coefficient, angle),
                        None => self.at(plain, y, quotient),
                    }
                }
            };
            sum = self.pool.add(sum, term);
        }
        Ok(sum)
    }

    /// atan(k s/ρ) = asin(k s/√C) where k² = −a
    fn arc_sine(
        &mut self,
        integrand: &mut Integrand,
        (above, below): (Expr, Expr),
        y: Symbol,
        quadratic: &Quadratic,
        s: Expr,
    ) -> Computed<Option<Expr>> {
        let one = self.pool.integer(1);
        let slope = self.at(above, y, one);
        let slope = self.pool.divide(slope, below);
        let square = self.pool.power(slope, 2.into());
        let a = integrand.tower.raise(self.pool, &quadratic.a);
        let sum = self.pool.add(square, a);
        let mut tower = Tower::new(Trigonometry::Circle);
        if !normal_form(self.pool, &mut tower, sum, integrand.conditions)?.is_zero() {
            return Ok(None);
        }
        let c = integrand.tower.raise(self.pool, &quadratic.c);
        let product = self.pool.multiply(slope, s);
        let radius = self.pool.sqrt(c);
        let sine = self.pool.divide(product, radius);
        let sine = tidied(self.pool, sine, integrand.conditions);
        Ok(Some(self.pool.apply(Operation::Asin, &[sine])))
    }
}

/// Returns E and O with R(s) = E(s²) + s O(s²), both as functions of the variable, which replaces
/// s².
fn even_and_odd(tower: &mut Tower, rational: &Fraction, x: u32) -> Computed<(Fraction, Fraction)> {
    let function = tower.rational_function(rational, x)?;
    let mut numerator = function.numerator;
    let mut below = Univariate::one();
    for (factor, exponent) in &function.denominator {
        let is_even = factor.coefficients().iter().skip(1).step_by(2).all(Fraction::is_zero);
        let power = tower.univariate_power(factor, *exponent)?;
        below = tower.univariate_product(&below, &power)?;
        if !is_even {
            // multiplied by D(−s), above and below
            let mirrored = mirrored(tower, &power);
            numerator = tower.univariate_product(&numerator, &mirrored)?;
            below = tower.univariate_product(&below, &mirrored)?;
        }
    }
    let half = |polynomial: &Univariate, from: usize| {
        Univariate::new(polynomial.coefficients().iter().skip(from).step_by(2).cloned().collect())
    };
    let square: Fraction = Polynomial::variable(x).into();
    let below = tower.univariate_at(&half(&below, 0), &square)?;
    let inverse = tower.inverse(&below)?;
    let even = tower.univariate_at(&half(&numerator, 0), &square)?;
    let odd = tower.univariate_at(&half(&numerator, 1), &square)?;
    Ok((tower.multiply(&even, &inverse)?, tower.multiply(&odd, &inverse)?))
}

/// p(−x)
fn mirrored(tower: &Tower, p: &Univariate) -> Univariate {
    let signed = |(k, coefficient): (usize, &Fraction)| {
        if k % 2 == 1 { tower.negate(coefficient) } else { coefficient.clone() }
    };
    Univariate::new(p.coefficients().iter().enumerate().map(signed).collect())
}
