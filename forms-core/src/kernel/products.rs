//! Common parts of products: a pair of factors that occurs in several products is multiplied once.
//!
//! Factors below the line pair like those above it. Powers with one exponent that nothing else needs are taken
//! together: x² y² = (x y)².

use super::graph::{Exponent, Factor, Form, Graph, Node};
use super::tally::Tally;
use rustc_hash::FxHashMap;

/// Longer products are left as they are.
const LONGEST: usize = 32;

/// Two factors of a product.
type Pair = [Factor; 2];

/// The graph with common pairs of factors in products of their own.
pub(super) fn share_products(graph: &Graph) -> Graph {
    let mut graph = graph.clone();
    let mut products: Vec<(Node, Vec<Factor>)> = Vec::new();
    for node in graph.reachable() {
        if let Form::Product(factors) = graph.form(node)
            && factors.len() <= LONGEST
        {
            products.push((node, factors.to_vec()));
        }
    }
    group_equal_exponents(&mut graph, &mut products);
    let mut sharing = Sharing { graph, ..Sharing::default() };
    for (node, factors) in products {
        sharing.insert(node, factors);
    }
    while let Some(pair) = sharing.savings.take_best() {
        sharing.share(pair);
    }
    sharing.graph.reordered()
}

#[derive(Default)]
struct Sharing {
    graph: Graph,
    products: FxHashMap<Node, Vec<Factor>>,
    /// The products that each node has been a base of.
    with_base: FxHashMap<Node, Vec<Node>>,
    /// How many products contain each pair, above or below the line, but one.
    savings: Tally<Pair>,
}

impl Sharing {
    fn insert(&mut self, node: Node, factors: Vec<Factor>) {
        for (base, _) in &factors {
            self.with_base.entry(*base).or_default().push(node);
        }
        self.count(&factors, 1);
        self.products.insert(node, factors);
    }

    /// Computes a pair once, wherever it occurs.
    fn share(&mut self, pair: Pair) {
        let product = self.graph.product_of(pair.to_vec());
        let users = self.with_base.get(&pair[0].0).cloned().unwrap_or_default();
        for node in users.into_iter().filter(|&node| node != product) {
            let factors = self.products[&node].clone();
            if let Some(shorter) = with_pair(&factors, pair, product) {
                self.count(&factors, -1);
                self.graph.replace(node, Form::Product(shorter.clone().into()));
                self.insert(node, shorter);
            }
        }
        // what is left of the pair is the product that computes it
        self.savings.remove(&pair);
        self.products.entry(product).or_insert_with(|| pair.to_vec());
    }

    /// Counts the pairs of a product in (+1) or out (−1). Numbers go with the coefficients.
    fn count(&mut self, factors: &[Factor], sign: i32) {
        let is_number = |node: Node| matches!(self.graph.form(node), Form::Number(_));
        for (place, &(left, e)) in factors.iter().enumerate() {
            for &(right, f) in &factors[place + 1..] {
                if e.is_negative() != f.is_negative() || is_number(left) || is_number(right) {
                    continue;
                }
                let mut pair = if e.is_negative() {
                    [(left, e.negated()), (right, f.negated())]
                } else {
                    [(left, e), (right, f)]
                };
                pair.sort();
                self.savings.add(pair, -1, sign);
            }
        }
    }
}

/// The factors with a pair, or its reciprocal, replaced by its node, if they contain it.
fn with_pair(factors: &[Factor], pair: [Factor; 2], node: Node) -> Option<Vec<Factor>> {
    let inverse = pair.map(|(base, e)| (base, e.negated()));
    let contains = |pair: &[Factor; 2]| pair.iter().all(|factor| factors.contains(factor));
    let (pair, exponent) = if contains(&pair) {
        (pair, Exponent::ONE)
    } else if contains(&inverse) {
        (inverse, Exponent::MINUS_ONE)
    } else {
        return None;
    };
    let mut rest: Vec<Factor> = factors.iter().copied().filter(|factor| !pair.contains(factor)).collect();
    rest.push((node, exponent));
    Some(rest)
}

/// Π nᵢᵉ = (Π nᵢ)ᵉ for whole e, where no other product needs one of these powers.
fn group_equal_exponents(graph: &mut Graph, products: &mut [(Node, Vec<Factor>)]) {
    let mut counts: FxHashMap<Node, usize> = FxHashMap::default();
    for &(base, _) in products.iter().flat_map(|(_, factors)| factors) {
        *counts.entry(base).or_insert(0) += 1;
    }
    for (node, factors) in products {
        let mut exponents: Vec<Exponent> = factors.iter().map(|&(_, e)| e).collect();
        exponents.retain(|exponent| exponent.integer().is_some_and(|whole| whole.abs() > 1));
        exponents.dedup();
        for exponent in exponents {
            let is_grouped = |&(base, e): &Factor| {
                e == exponent && counts.get(&base) == Some(&1) && !matches!(graph.form(base), Form::Number(_))
            };
            let (group, mut rest): (Vec<Factor>, Vec<Factor>) = factors.iter().copied().partition(is_grouped);
            if group.len() > 1 {
                let bases = group.iter().map(|&(base, _)| (base, Exponent::ONE)).collect();
                rest.push((graph.product_of(bases), exponent));
                *factors = rest;
                graph.replace(*node, Form::Product(factors.clone().into()));
            }
        }
    }
}
