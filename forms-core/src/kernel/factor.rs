//! Factoring: a sum with a common factor becomes a product, S = f A + B, and recursively inside A
//! and B.
//!
//! Denominators come first: a/c + b/c = (a + b)/c. The factor that saves most multiplications
//! follows, which for a polynomial is Horner's rule. Among factors with equal savings, a factor
//! whose cofactor A is needed anyway is preferred, so that a map and its derivatives share
//! subexpressions: in p = a + v(c−a) + u p_u the cofactor of u is the derivative p_u.

use super::graph::{Coefficient, Exponent, Factor, Form, Graph, Node, Scaled, joined};
use rustc_hash::{FxHashMap, FxHashSet};
use std::cmp::Reverse;

/// Preference among factors with equal savings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    /// The factor that occurs first in the formula.
    First,
    /// The factor that occurs last.
    Last,
}

/// Returns the graph with common factors taken out of its sums.
pub(super) fn factor(graph: &Graph, order: Order) -> Graph {
    let is_sum = |node: &Node| matches!(graph.form(*node), Form::Sum(_));
    let sums: Vec<Node> = graph.reachable().into_iter().filter(is_sum).collect();
    let mut factoring = Factoring { graph: graph.clone(), needed: sums.iter().copied().collect(), order };
    let mut done: FxHashSet<Node> = FxHashSet::default();
    let mut pending: Vec<Node> = sums.into_iter().rev().collect();
    while let Some(node) = pending.pop() {
        if done.insert(node) {
            pending.extend(factoring.factor_sum(node));
        }
    }
    factoring.graph.reordered()
}

/// c Π nᵢ^eᵢ
type Monomial = (Coefficient, Vec<Factor>);

struct Factoring {
    graph: Graph,
    /// Sums that are computed in any case.
    needed: FxHashSet<Node>,
    order: Order,
}

/// Factor that can be taken out of some of the terms.
#[derive(Clone, Copy)]
struct Candidate {
    base: Node,
    /// Exponent taken out of each of these terms.
    exponent: Exponent,
    /// Weighted number of operations that this saves.
    saving: usize,
}

impl Candidate {
    /// Returns the index of the factor in a term, with the same sign of the exponent.
    fn place_in(&self, factors: &[Factor]) -> Option<usize> {
        let is_same =
            |(base, e): &Factor| *base == self.base && e.is_negative() == self.exponent.is_negative();
        factors.iter().position(is_same)
    }
}

impl Factoring {
    /// Rewrites one sum and returns the cofactors that arise, which are to be factored in turn.
    fn factor_sum(&mut self, node: Node) -> Vec<Node> {
        let Form::Sum(terms) = self.graph.form(node).clone() else { return vec![] };
        let mut rest: Vec<Monomial> =
            terms.iter().map(|&(coefficient, node)| (coefficient, self.factors(node))).collect();
        let mut done: Vec<Scaled> = Vec::new();
        let mut cofactors = Vec::new();
        while let Some(best) = self.best(&rest) {
            let (inside, outside) = self.split(&rest, best);
            let cofactor = self.sum(&inside);
            let product = joined(vec![(best.base, best.exponent), (cofactor.node, Exponent::ONE)]);
            let product = self.graph.product_of(product);
            done.push(Scaled { coefficient: cofactor.coefficient, node: product });
            cofactors.push(cofactor.node);
            rest = outside;
        }
        if !done.is_empty() {
            let mut terms: Vec<(Coefficient, Node)> =
                done.iter().map(|term| (term.coefficient, term.node)).collect();
            for (coefficient, factors) in rest {
                terms.push((coefficient, self.graph.product_of(factors)));
            }
            self.graph.replace(node, Form::Sum(terms.into()));
        }
        cofactors
    }

    fn factors(&self, node: Node) -> Vec<Factor> {
        match self.graph.form(node) {
            Form::One => vec![],
            Form::Product(factors) => factors.to_vec(),
            _ => vec![(node, Exponent::ONE)],
        }
    }

    fn sum(&mut self, monomials: &[Monomial]) -> Scaled {
        let terms: Vec<Scaled> = monomials
            .iter()
            .map(|(coefficient, factors)| Scaled {
                coefficient: *coefficient,
                node: self.graph.product_of(factors.clone()),
            })
            .collect();
        self.graph.sum(&terms)
    }

    /// Splits terms into those that contain the factor, divided by it, and the others.
    fn split(&self, terms: &[Monomial], by: Candidate) -> (Vec<Monomial>, Vec<Monomial>) {
        let (mut inside, mut outside) = (Vec::new(), Vec::new());
        for (coefficient, factors) in terms {
            let Some(place) = by.place_in(factors) else {
                outside.push((*coefficient, factors.clone()));
                continue;
            };
            let mut factors = factors.clone();
            let left = Exponent(factors[place].1.0 - by.exponent.0);
            if left.0 == 0 {
                factors.remove(place);
            } else {
                factors[place].1 = left;
            }
            inside.push((*coefficient, joined(factors)));
        }
        (inside, outside)
    }

    /// Returns the factor to take out next: a denominator, or else the factor that saves most.
    fn best(&mut self, terms: &[Monomial]) -> Option<Candidate> {
        let candidates = candidates(terms);
        let most = candidates.iter().map(|candidate| candidate.saving).max()?;
        let mut equals: Vec<Candidate> =
            candidates.into_iter().filter(|candidate| candidate.saving == most).collect();
        if equals.len() > 1 {
            equals.sort_by_key(|candidate| (candidate.base, candidate.exponent));
            if self.order == Order::Last {
                equals.reverse();
            }
            let is_needed = |candidate: &Candidate| {
                let cofactor = self.sum(&self.split(terms, *candidate).0);
                Reverse(self.needed.contains(&cofactor.node))
            };
            equals.sort_by_cached_key(is_needed);
        }
        equals.first().copied()
    }
}

/// Weight of a saved division relative to a saved multiplication.
const DIVISION: usize = 100;

/// Returns the factors that at least two terms have in common and that save operations.
fn candidates(terms: &[Monomial]) -> Vec<Candidate> {
    let mut found: FxHashMap<(Node, bool), (Exponent, usize, usize)> = FxHashMap::default();
    for (coefficient, factors) in terms {
        let is_alone = coefficient.is_unit() && factors.len() == 1;
        for &(base, exponent) in factors {
            let is_bare = is_alone && exponent == Exponent::ONE;
            let entry = found.entry((base, exponent.is_negative())).or_insert((exponent, 0, 0));
            // the lowest power of a numerator, the highest of a denominator
            entry.0 = entry.0.min(exponent);
            entry.1 += 1;
            entry.2 += usize::from(!is_bare);
        }
    }
    let candidate = |((base, is_negative), (exponent, count, compound)): ((Node, bool), _)| {
        let saving = if is_negative { (count - 1) * DIVISION } else { usize::max(compound, 1) - 1 };
        (count > 1 && saving > 0).then_some(Candidate { base, exponent, saving })
    };
    found.into_iter().filter_map(candidate).collect()
}
