//! Common parts of products: a pair of factors that occurs in several products is multiplied once.
//!
//! Factors below the line pair like those above it. Powers with one exponent that nothing else needs are taken
//! together: x² y² = (x y)².

use super::graph::{Exponent, Factor, Form, Graph, Node};
use rustc_hash::FxHashMap;
use std::cmp::Reverse;

/// Longer products are left as they are.
const LONGEST: usize = 32;

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
    while let Some(pair) = best_pair(&graph, &products) {
        let node = graph.product_of(pair.to_vec());
        for (product, factors) in products.iter_mut().filter(|(product, _)| *product != node) {
            if let Some(shorter) = with_pair(factors, pair, node) {
                *factors = shorter;
                graph.replace(*product, Form::Product(factors.clone().into()));
            }
        }
        if !products.iter().any(|(product, _)| *product == node) {
            products.push((node, pair.to_vec()));
        }
    }
    graph.reordered()
}

/// The pair that most products contain, if more than one does. Numbers go with the coefficients.
fn best_pair(graph: &Graph, products: &[(Node, Vec<Factor>)]) -> Option<[Factor; 2]> {
    let is_number = |node: Node| matches!(graph.form(node), Form::Number(_));
    let mut counts: FxHashMap<[Factor; 2], usize> = FxHashMap::default();
    for (_, factors) in products {
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
                *counts.entry(pair).or_insert(0) += 1;
            }
        }
    }
    let shared = counts.into_iter().filter(|(_, count)| *count > 1);
    shared.max_by_key(|(pair, count)| (*count, Reverse(*pair))).map(|(pair, _)| pair)
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
    let mut bases: FxHashMap<Node, usize> = FxHashMap::default();
    for &(base, _) in products.iter().flat_map(|(_, factors)| factors) {
        *bases.entry(base).or_insert(0) += 1;
    }
    for (node, factors) in products {
        let exponents: Vec<Exponent> = factors.iter().map(|&(_, e)| e).collect();
        for exponent in exponents {
            let is_grouped = |&(base, e): &Factor| e == exponent && bases[&base] == 1;
            let is_power = exponent.integer().is_some_and(|whole| whole.abs() > 1);
            if !is_power || factors.iter().filter(|factor| is_grouped(factor)).count() < 2 {
                continue;
            }
            let (group, mut rest): (Vec<Factor>, Vec<Factor>) =
                factors.iter().partition(|&factor| is_grouped(factor));
            let bases = group.iter().map(|&(base, _)| (base, Exponent::ONE)).collect();
            rest.push((graph.product_of(bases), exponent));
            *factors = rest;
            graph.replace(*node, Form::Product(factors.clone().into()));
        }
    }
}
