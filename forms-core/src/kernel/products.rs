//! Common subexpressions of products: a pair of factors that occurs in several products is
//! multiplied once.
//!
//! Factors in denominators pair in the same way as factors in numerators. Powers with equal
//! exponents that no other product needs are grouped: x² y² = (x y)².

use super::graph::{Coefficient, Exponent, Factor, Form, Graph, Node, Scaled};
use super::sharing::{Pairing, share, shareable, without};
use rustc_hash::FxHashMap;

/// Returns the graph with common pairs of factors in products of their own.
pub(super) fn share_products(graph: &Graph) -> Graph {
    let mut graph = graph.clone();
    let mut products = shareable::<Products>(&graph);
    group_equal_exponents(&mut graph, &mut products);
    share::<Products>(graph, products)
}

struct Products;

impl Pairing for Products {
    type Part = Factor;
    /// Two factors, or both their reciprocals.
    type Pair = [Factor; 2];

    fn parts(form: &Form) -> Option<&[Factor]> {
        if let Form::Product(factors) = form { Some(factors) } else { None }
    }

    fn form(factors: Vec<Factor>) -> Form {
        Form::Product(factors.into())
    }

    fn node(factor: &Factor) -> Node {
        factor.0
    }

    fn anchor(pair: &Self::Pair) -> Node {
        pair[0].0
    }

    /// Sharing saves one multiplication in every product but one. Numbers stay with the
    /// coefficients.
    fn saving(graph: &Graph, (left, e): Factor, (right, f): Factor) -> Option<(Self::Pair, i32, i32)> {
        let is_number = |node: Node| matches!(graph.form(node), Form::Number(_));
        if e.is_negative() != f.is_negative() || is_number(left) || is_number(right) {
            return None;
        }
        let mut pair = if e.is_negative() {
            [(left, e.negated()), (right, f.negated())]
        } else {
            [(left, e), (right, f)]
        };
        pair.sort();
        Some((pair, 1, 1))
    }

    fn computed(graph: &mut Graph, pair: Self::Pair) -> Scaled {
        Scaled { coefficient: Coefficient::ONE, node: graph.product_of(pair.to_vec()) }
    }

    fn shortened(factors: &[Factor], pair: Self::Pair, computed: Scaled) -> Option<Vec<Factor>> {
        let inverse = pair.map(|(base, e)| (base, e.negated()));
        let (places, exponent) = match places_of(factors, pair) {
            Some(places) => (places, Exponent::ONE),
            None => (places_of(factors, inverse)?, Exponent::MINUS_ONE),
        };
        let mut rest = without(factors, places);
        rest.push((computed.node, exponent));
        Some(rest)
    }
}

/// Returns two indices at which the factors contain the pair.
fn places_of(factors: &[Factor], [left, right]: [Factor; 2]) -> Option<[usize; 2]> {
    let first = factors.iter().position(|&factor| factor == left)?;
    let second = (0..factors.len()).find(|&place| place != first && factors[place] == right)?;
    Some([first, second])
}

/// Groups Π nᵢᵉ = (Π nᵢ)ᵉ for integer e, where no other product needs one of these powers.
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
