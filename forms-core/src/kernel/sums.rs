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
    let mut savings = Savings::default();
    for node in graph.reachable() {
        if let Form::Sum(terms) = graph.form(node)
            && terms.len() <= LONGEST
        {
            savings.count(&graph, terms, 1);
            sums.push((node, terms.to_vec()));
        }
    }
    while let Some((left, right, ratio)) = savings.best(&graph) {
        let terms = [(Coefficient::ONE, left), (ratio, right)];
        let pair = graph.sum(&terms.map(|(coefficient, node)| Scaled { coefficient, node }));
        for (node, terms) in sums.iter_mut().filter(|(node, _)| *node != pair.node) {
            if let Some(shorter) = with_pair(terms, (left, right, ratio), pair) {
                savings.count(&graph, terms, -1);
                savings.count(&graph, &shorter, 1);
                *terms = shorter;
                graph.replace(*node, Form::Sum(terms.clone().into()));
            }
        }
        // what is left of the pair is the sum that computes it
        savings.of.remove(&(left, right, ratio));
        if let Form::Sum(terms) = graph.form(pair.node)
            && !sums.iter().any(|(node, _)| *node == pair.node)
        {
            sums.push((pair.node, terms.to_vec()));
        }
    }
    graph.reordered()
}

/// What each pair saves: additions and multiplications before, less those after, its own sum not counted.
#[derive(Default)]
struct Savings {
    of: FxHashMap<Pair, i32>,
}

impl Savings {
    /// Counts the pairs of a sum in (+1) or out (−1).
    fn count(&mut self, graph: &Graph, terms: &[Term], sign: i32) {
        for (place, &first) in terms.iter().enumerate() {
            for &second in &terms[place + 1..] {
                let [(c, left), (d, right)] =
                    if first.1 < second.1 { [first, second] } else { [second, first] };
                let Some(ratio) = d.over(c) else { continue };
                let saved = 1 + multiplications(graph, c, left) + multiplications(graph, d, right)
                    - i32::from(!c.is_unit());
                *self.of.entry((left, right, ratio)).or_insert(0) += sign * saved;
            }
        }
    }

    /// The pair that saves most operations, if one saves any.
    fn best(&self, graph: &Graph) -> Option<Pair> {
        let saving =
            |&((_, right, ratio), saved): &(Pair, i32)| saved - 1 - multiplications(graph, ratio, right);
        let pairs = self.of.iter().map(|(&pair, &saved)| (pair, saved)).filter(|pair| saving(pair) > 0);
        pairs.max_by_key(|pair| (saving(pair), Reverse(pair.0))).map(|(pair, _)| pair)
    }
}

/// How many multiplications c n takes.
fn multiplications(graph: &Graph, coefficient: Coefficient, node: Node) -> i32 {
    i32::from(!coefficient.is_unit() && !matches!(graph.form(node), Form::One))
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
