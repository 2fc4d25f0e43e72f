//! Reduction: brings every bound generator below the order of its relation.
//!
//! With ρᵢ^nᵢ = fᵢ a polynomial Σ Aₖ ∏ ρᵢ^(nᵢ kᵢ) becomes Σ Aₖ ∏ fᵢ^kᵢ, all relations at once and
//! in one accumulator. If an fᵢ contains an earlier bound generator, the sum is reduced again.

use super::generators::Relation;
use super::obstacle::Obstacle;
use super::tower::Tower;
use crate::polynomial::Polynomial;

impl Tower {
    /// Brings a polynomial to reduced form.
    pub(super) fn reduce(&mut self, polynomial: Polynomial) -> Result<Polynomial, Obstacle> {
        let mut reduced = polynomial;
        loop {
            let beyond: Vec<Relation> = self
                .generators
                .relations()
                .iter()
                .filter(|relation| reduced.degree(relation.variable) >= relation.order)
                .cloned()
                .collect();
            if beyond.is_empty() {
                return Ok(reduced);
            }
            reduced = self.reduce_by(&reduced, &beyond)?;
        }
    }

    /// Σ Aₖ ∏ fᵢ^kᵢ
    fn reduce_by(&mut self, polynomial: &Polynomial, relations: &[Relation]) -> Result<Polynomial, Obstacle> {
        let mut powers: Vec<Powers> = Vec::with_capacity(relations.len());
        for relation in relations {
            let highest = polynomial.degree(relation.variable) / relation.order;
            self.check_power(&Polynomial::one(), &relation.value, u64::from(highest))?;
            powers.push(Powers(vec![Polynomial::one()]));
        }
        let orders: Vec<(u32, u32)> = relations.iter().map(|r| (r.variable, r.order)).collect();
        let parts = polynomial.split_by_powers(&orders);
        let mut values = Vec::with_capacity(parts.len());
        for (exponents, part) in &parts {
            let mut value = Polynomial::one();
            for ((&exponent, relation), powers) in exponents.iter().zip(relations).zip(&mut powers) {
                let power = powers.power(self, &relation.value, exponent as usize)?;
                self.charge(&value, power)?;
                value = if value.is_one() { power.clone() } else { value.mul(power) };
            }
            self.charge(part, &value)?;
            values.push(value);
        }
        let products: Vec<(i64, &Polynomial, &Polynomial)> =
            parts.iter().zip(&values).map(|((_, part), value)| (1, part, value)).collect();
        Ok(Polynomial::sum_of_products(&products))
    }
}

/// 1, f, f², …
struct Powers(Vec<Polynomial>);

impl Powers {
    fn power(&mut self, tower: &mut Tower, f: &Polynomial, n: usize) -> Result<&Polynomial, Obstacle> {
        while self.0.len() <= n {
            let last = &self.0[self.0.len() - 1];
            tower.charge(last, f)?;
            self.0.push(if last.is_one() { f.clone() } else { last.mul(f) });
        }
        Ok(&self.0[n])
    }
}
