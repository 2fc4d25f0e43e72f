//! Divergences: Σ ±∂aᵢ/∂xᵢ over one denominator; a derivative is a divergence with a single term.
//!
//! With aᵢ = Nᵢ ∏ γ^(−e_γ) ∏ Gⱼ^(−gⱼ), where γ are generators and Gⱼ sums of several terms,
//! ```text
//! Σᵢ ±∂ᵢaᵢ = (T ∏G − Σⱼ gⱼ Uⱼ ∏_{k≠j} G_k) ∏ γ^(−e_γ) ∏ Gⱼ^(−gⱼ−1)
//! T  = Σ_γ Σᵢ ± r_γᵢ D_γ Nᵢ,    Uⱼ = Σ_γ D_γ Gⱼ (Σᵢ ± r_γᵢ Nᵢ)
//! D_γ = ∂/∂γ,  r_γᵢ = ∂ᵢγ    or, for roots and factors of the denominator,    D_γ = γ ∂/∂γ − e_γ,  r_γᵢ = ∂ᵢγ/γ
//! ```
//! (e_γ = 0 in D_γ Gⱼ; a root of a sum Gⱼ in the denominator has a fractional gⱼ). The rate r of a
//! root ρⁿ = f is ∂f/(n f), so that no polynomial is multiplied by a radicand for each variable. T
//! and the Uⱼ are summed, and checked for common factors, before anything is multiplied by a Gⱼ: in
//! a Laplacian most of T cancels.

use super::fraction::Fraction;
use super::generator::Generator;
use super::generators::Relation;
use super::obstacle::Obstacle;
use super::power::{FactorPower, merge_powers};
use super::tower::Tower;
use crate::expression::{Rational, Symbol};
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_traits::One;
use std::collections::BTreeSet;

/// ±Nᵢ with the variables that they are differentiated by.
type Components = Vec<(i8, Polynomial, Symbol)>;

/// Factor Fᵍ, as G^(g/n) with a sum G.
struct Sum {
    polynomial: Polynomial,
    power: FactorPower,
    order: u32,
}

/// Rates r_γᵢ of one generator over one denominator.
struct Rates {
    generator: u32,
    /// Whether r is ∂γ/γ.
    logarithmic: bool,
    numerators: Vec<Polynomial>,
    divisor: BigInt,
    below: Vec<FactorPower>,
}

impl Rates {
    /// D_γ P, with the exponent of γ in the denominator of P.
    fn derivative(&self, polynomial: &Polynomial, below: i32) -> Polynomial {
        let partial = polynomial.derivative(self.generator);
        if !self.logarithmic {
            return partial;
        }
        let raised = partial.multiply_by_monomial(&[(self.generator, 1)]);
        if below == 0 { raised } else { raised.sub(&polynomial.scale(&below.into())) }
    }

    fn over_denominator(&self, numerator: Polynomial, tower: &Tower) -> Fraction {
        tower.cancel(numerator, self.divisor.clone(), self.below.clone())
    }
}

impl Tower {
    /// Σ ±∂a/∂x
    ///
    /// # Errors
    /// The same as for a derivative.
    pub(super) fn divergence(&mut self, terms: &[(i8, &Fraction, Symbol)]) -> Result<Fraction, Obstacle> {
        if let Some(sum) = self.plain_divergence(terms)? {
            return Ok(self.cancel(sum.numerator, sum.divisor, sum.factors));
        }
        let fractions: Vec<Fraction> = terms.iter().map(|term| term.1.clone()).collect();
        let together = self.together(&fractions)?;
        let numerators = together.numerators.into_iter().map(|numerator| numerator.numerator);
        let components: Components =
            terms.iter().zip(numerators).map(|((sign, _, by), numerator)| (*sign, numerator, *by)).collect();
        let sum = self.divergence_over(&components, &together.inverse.factors)?;
        Ok(self.cancel(sum.numerator, sum.divisor * together.inverse.divisor, sum.factors))
    }

    /// Σ ±∂ᵢ(Nᵢ ∏ γ^(−e) ∏ G^(−g))
    fn divergence_over(
        &mut self,
        components: &Components,
        powers: &[FactorPower],
    ) -> Result<Fraction, Obstacle> {
        let (single, sums) = self.separated(components, powers);
        let rates = self.rates(components, &single, &sums)?;
        let mut flows = Vec::with_capacity(rates.len());
        let mut own = Vec::with_capacity(rates.len());
        for rate in &rates {
            let below = self.exponent_below(&single, rate.generator);
            let derived = components.iter().map(|(sign, n, _)| (*sign, rate.derivative(n, below)));
            let derived: Vec<(i8, Polynomial)> = derived.collect();
            own.push(self.flow(rate, &derived)?);
            if !sums.is_empty() {
                let plain: Vec<(i8, Polynomial)> =
                    components.iter().map(|(sign, n, _)| (*sign, n.clone())).collect();
                flows.push(self.flow(rate, &plain)?);
            }
        }
        let mut summands = vec![self.sum(&own)?];
        let mut dependent = Vec::new();
        let mut factors = powers.to_vec();
        for Sum { polynomial, power, order } in sums {
            let along = self.along_flows(&polynomial, &rates, &flows)?;
            if !along.is_zero() {
                let scale = Rational::new((-power.exponent).into(), order.into());
                summands.push(self.multiply(&along, &Fraction::number(&scale))?);
                dependent.push(polynomial);
                factors = merge_powers(&factors, &[FactorPower { exponent: order as i32, ..power }]);
            }
        }
        self.over_all_factors(&summands, &dependent, factors)
    }

    /// Splits the denominator into generators and sums. The sums are factors of several terms, and
    /// radicands that contain roots themselves if their own root occurs nowhere else.
    fn separated(&self, components: &Components, powers: &[FactorPower]) -> (Vec<FactorPower>, Vec<Sum>) {
        let (mut single, mut sums) = (Vec::new(), Vec::new());
        for &power in powers {
            let Some(variable) = self.factor_variable(power.factor) else {
                let polynomial = self.factor_polynomial(power.factor).clone();
                sums.push(Sum { polynomial, power, order: 1 });
                continue;
            };
            let occurs = components.iter().any(|(_, n, _)| n.contains(variable))
                || powers
                    .iter()
                    .any(|other| *other != power && self.factor_polynomial(other.factor).contains(variable));
            match self.relation_of(variable) {
                Some(relation) if !occurs && self.is_root_over_roots(relation) => {
                    sums.push(Sum { polynomial: relation.value.clone(), power, order: relation.order });
                }
                _ => single.push(power),
            }
        }
        (single, sums)
    }

    fn is_root_over_roots(&self, relation: &Relation) -> bool {
        let is_root = |variable: u32| matches!(self.generator(variable), Generator::Root { .. });
        is_root(relation.variable) && relation.value.variables().into_iter().any(is_root)
    }

    /// (T ∏G + Σⱼ Vⱼ ∏_{k≠j} G_k) over given factors, for summands T, V₁, V₂, …
    fn over_all_factors(
        &mut self,
        summands: &[Fraction],
        dependent: &[Polynomial],
        factors: Vec<FactorPower>,
    ) -> Result<Fraction, Obstacle> {
        let together = self.together(summands)?;
        let mut cofactors = Vec::with_capacity(summands.len());
        for place in 0..summands.len() {
            let mut product = Polynomial::one();
            for (_, factor) in dependent.iter().enumerate().filter(|(other, _)| other + 1 != place) {
                self.charge(&product, factor)?;
                product = self.reduce(product.mul(factor))?;
            }
            cofactors.push(product);
        }
        let mut products = Vec::with_capacity(summands.len());
        for (summand, cofactor) in together.numerators.iter().zip(&cofactors) {
            self.charge(&summand.numerator, cofactor)?;
            products.push((1, &summand.numerator, cofactor));
        }
        let numerator = self.reduce(Polynomial::sum_of_products(&products))?;
        let factors = merge_powers(&factors, &together.inverse.factors);
        Ok(Fraction { numerator, divisor: together.inverse.divisor, factors })
    }

    /// Returns the rates of all generators that occur and change.
    fn rates(
        &mut self,
        components: &Components,
        single: &[FactorPower],
        sums: &[Sum],
    ) -> Result<Vec<Rates>, Obstacle> {
        let below: Vec<u32> = single.iter().filter_map(|power| self.factor_variable(power.factor)).collect();
        let mut generators: BTreeSet<u32> = below.iter().copied().collect();
        for (_, numerator, _) in components {
            generators.extend(numerator.variables());
        }
        for sum in sums {
            generators.extend(sum.polynomial.variables());
        }
        let mut all = Vec::with_capacity(generators.len());
        for generator in generators {
            let is_root = matches!(self.generator(generator), Generator::Root { .. });
            let logarithmic = is_root || below.contains(&generator);
            let mut rates = Vec::with_capacity(components.len());
            for (_, _, by) in components {
                let rate = self.derivative_of_generator(generator, *by)?;
                rates.push(if logarithmic { self.over_generator(&rate, generator)? } else { rate });
            }
            if rates.iter().all(Fraction::is_zero) {
                continue;
            }
            let together = self.together(&rates)?;
            all.push(Rates {
                generator,
                logarithmic,
                numerators: together.numerators.into_iter().map(|rate| rate.numerator).collect(),
                divisor: together.inverse.divisor,
                below: together.inverse.factors,
            });
        }
        Ok(all)
    }

    fn over_generator(&mut self, a: &Fraction, generator: u32) -> Result<Fraction, Obstacle> {
        let factor = self.factor(Polynomial::variable(generator));
        let factors = vec![FactorPower { factor, exponent: 1 }];
        self.multiply(a, &Fraction { numerator: Polynomial::one(), divisor: BigInt::one(), factors })
    }

    fn exponent_below(&self, single: &[FactorPower], generator: u32) -> i32 {
        let power = single.iter().find(|power| self.factor_variable(power.factor) == Some(generator));
        power.map_or(0, |power| power.exponent)
    }

    /// Σᵢ ± r_γᵢ Pᵢ
    fn flow(&mut self, rates: &Rates, parts: &[(i8, Polynomial)]) -> Result<Fraction, Obstacle> {
        let mut products = Vec::with_capacity(parts.len());
        for ((sign, part), rate) in parts.iter().zip(&rates.numerators) {
            self.charge(part, rate)?;
            products.push((i64::from(*sign), part, rate));
        }
        let numerator = self.reduce(Polynomial::sum_of_products(&products))?;
        Ok(rates.over_denominator(numerator, self))
    }

    /// D_γ G and flow_γ. A γ in the denominator of the flow cancels the γ of γ ∂G/∂γ, so that the
    /// flows need fewer roots over one denominator.
    fn along_flow(&self, factor: &Polynomial, rate: &Rates, flow: &Fraction) -> (Polynomial, Fraction) {
        let is_own = |power: &FactorPower| {
            rate.logarithmic
                && power.exponent > 0
                && self.factor_variable(power.factor) == Some(rate.generator)
        };
        let Some(place) = flow.factors.iter().position(is_own) else {
            return (rate.derivative(factor, 0), flow.clone());
        };
        let mut rest = flow.clone();
        rest.factors[place].exponent -= 1;
        rest.factors.retain(|power| power.exponent != 0);
        (factor.derivative(rate.generator), rest)
    }

    /// U = Σ_γ D_γ G · flow_γ
    fn along_flows(
        &mut self,
        factor: &Polynomial,
        rates: &[Rates],
        flows: &[Fraction],
    ) -> Result<Fraction, Obstacle> {
        let mut partials = Vec::with_capacity(rates.len());
        let mut rests = Vec::with_capacity(rates.len());
        for (rate, flow) in rates.iter().zip(flows) {
            let (partial, rest) = self.along_flow(factor, rate, flow);
            partials.push(partial);
            rests.push(rest);
        }
        let together = self.together(&rests)?;
        let mut products = Vec::with_capacity(partials.len());
        for (partial, flow) in partials.iter().zip(&together.numerators) {
            self.charge(partial, &flow.numerator)?;
            products.push((1, partial, &flow.numerator));
        }
        let numerator = self.reduce(Polynomial::sum_of_products(&products))?;
        Ok(self.cancel(numerator, together.inverse.divisor, together.inverse.factors))
    }
}
