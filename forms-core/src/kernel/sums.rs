//! Common parts of sums: a pair of terms that occurs in several sums, with either sign, is added once.
//!
//! a − b − c + d and a − b share a − b; 2x + 2y + z takes one multiplication as 2(x + y) + z. Greedy: the pair
//! that saves most goes first, until no pair saves anything.

use super::graph::{Coefficient, Form, Graph, Node, Scaled, Term};
use rustc_hash::FxHashMap;
use std::cmp::Reverse;

/// Longer sums are left as they are.
const LONGEST: usize = 32;

/// n₁ + r n₂ up to a factor.
type Pair = (Node, Node, Coefficient);

/// The graph with common pairs of terms in sums of their own.
pub(super) fn share_sums(graph: &Graph) -> Graph {
    let mut graph = graph.clone();
    let mut sums: Vec<(Node, Vec<Term>)> = Vec::new();
    for node in graph.reachable() {
        if let Form::Sum(terms) = graph.form(node)
            && terms.len() <= LONGEST
        {
            sums.push((node, terms.to_vec()));
        }
    }
    while let Some((left, right, ratio)) = best_pair(&graph, &sums) {
        let terms = [(Coefficient::ONE, left), (ratio, right)];
        let pair = graph.sum(&terms.map(|(coefficient, node)| Scaled { coefficient, node }));
        for (node, terms) in sums.iter_mut().filter(|(node, _)| *node != pair.node) {
            if let Some(shorter) = with_pair(terms, (left, right, ratio), pair) {
                *terms = shorter;
                graph.replace(*node, Form::Sum(terms.clone().into()));
            }
        }
        if !sums.iter().any(|(node, _)| *node == pair.node) {
            let Form::Sum(terms) = graph.form(pair.node) else { break };
            let terms = terms.to_vec();
            sums.push((pair.node, terms));
        }
    }
    graph.reordered()
}

/// The pair that saves most operations, if one saves any.
fn best_pair(graph: &Graph, sums: &[(Node, Vec<Term>)]) -> Option<Pair> {
    let is_one = |node: Node| matches!(graph.form(node), Form::One);
    let multiplies =
        |coefficient: Coefficient, node: Node| i32::from(!coefficient.is_unit() && !is_one(node));
    // additions and multiplications before, less those after, the pair itself not counted
    let mut savings: FxHashMap<Pair, i32> = FxHashMap::default();
    for (_, terms) in sums {
        for (place, &(c, left)) in terms.iter().enumerate() {
            for &(d, right) in &terms[place + 1..] {
                let (c, left, d, right) =
                    if left < right { (c, left, d, right) } else { (d, right, c, left) };
                let Some(ratio) = d.over(c) else { continue };
                let saved = 1 + multiplies(c, left) + multiplies(d, right) - i32::from(!c.is_unit());
                *savings.entry((left, right, ratio)).or_insert(0) += saved;
            }
        }
    }
    let saving = |&((_, right, ratio), saved): &(Pair, i32)| saved - 1 - multiplies(ratio, right);
    savings
        .into_iter()
        .filter(|pair| saving(pair) > 0)
        .max_by_key(|pair| (saving(pair), Reverse(pair.0)))
        .map(|(pair, _)| pair)
}

/// The terms with n₁ + r n₂ replaced by the pair's node, if they contain it and more.
fn with_pair(terms: &[Term], (left, right, ratio): Pair, pair: Scaled) -> Option<Vec<Term>> {
    let coefficient_of = |node: Node| terms.iter().find(|term| term.1 == node).map(|term| term.0);
    let scale = coefficient_of(left)?;
    if coefficient_of(right)?.over(scale)? != ratio {
        return None;
    }
    let mut rest: Vec<Term> =
        terms.iter().copied().filter(|&(_, node)| node != left && node != right).collect();
    rest.push((scale.times(pair.coefficient)?, pair.node));
    Some(rest)
}
