//! The generators of a tower by their variables, and the relations that bind some of them.

use super::generator::Generator;
use crate::polynomial::Polynomial;
use rustc_hash::FxHashMap;

/// ρⁿ = value
#[derive(Clone, Debug)]
pub(super) struct Relation {
    pub(super) variable: u32,
    pub(super) order: u32,
    pub(super) value: Polynomial,
}

/// Generators in the order of their creation; the number of a generator is its polynomial variable.
#[derive(Clone, Debug, Default)]
pub(super) struct Generators {
    list: Vec<Generator>,
    numbers: FxHashMap<Generator, u32>,
    relations: Vec<Relation>,
}

impl Generators {
    /// Returns the generators in order.
    pub(super) fn list(&self) -> &[Generator] {
        &self.list
    }

    /// Returns the generator that a polynomial variable represents.
    pub(super) fn get(&self, variable: u32) -> &Generator {
        &self.list[variable as usize]
    }

    /// Returns the polynomial variable of a generator, if the generator occurs.
    pub(super) fn known(&self, generator: &Generator) -> Option<u32> {
        self.numbers.get(generator).copied()
    }

    /// Returns the polynomial variable of a generator, which is created if needed.
    pub(super) fn variable_of(&mut self, generator: Generator) -> u32 {
        if let Some(known) = self.known(&generator) {
            return known;
        }
        let fresh = self.list.len() as u32;
        self.list.push(generator.clone());
        self.numbers.insert(generator, fresh);
        fresh
    }

    /// Returns the relations in the order in which they were stated.
    pub(super) fn relations(&self) -> &[Relation] {
        &self.relations
    }

    /// Returns the relation that binds a generator.
    pub(super) fn relation_of(&self, variable: u32) -> Option<&Relation> {
        self.relations.iter().find(|relation| relation.variable == variable)
    }

    /// Binds a generator by ρⁿ = value, once.
    pub(super) fn bind(&mut self, variable: u32, order: u32, value: Polynomial) {
        if self.relation_of(variable).is_none() {
            self.relations.push(Relation { variable, order, value });
        }
    }
}
