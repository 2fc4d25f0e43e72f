//! Common parts of sums: a pair of terms that occurs in several sums, with either sign, is added once.
//!
//! a − b − c + d and a − b share a − b; 2x + 2y + z takes one multiplication as 2(x + y) + z. Greedy: the pair
//! that saves most goes first, until no pair saves anything.

use super::graph::{Coefficient, Form, Graph, Node, Scaled, Term};
use super::tally::Tally;
use rustc_hash::FxHashMap;

/// Longer sums are left as they are.
const LONGEST: usize = 32;

/// n₁ + r n₂ up to a factor.
type Pair = (Node, Node, Coefficient);

/// The graph with common pairs of terms in sums of their own.
pub(super) fn share_sums(graph: &Graph) -> Graph {
    let mut sharing = Sharing { graph: graph.clone(), ..Sharing::default() };
    for node in graph.reachable() {
        if let Form::Sum(terms) = graph.form(node)
            && terms.len() <= LONGEST
        {
            sharing.insert(node, terms.to_vec());
        }
    }
    while let Some(pair) = sharing.savings.take_best() {
        sharing.share(pair);
    }
    sharing.graph.reordered()
}

#[derive(Default)]
struct Sharing {
    graph: Graph,
    sums: FxHashMap<Node, Vec<Term>>,
    /// The sums that each node has been a term of.
    with_term: FxHashMap<Node, Vec<Node>>,
    /// What each pair saves: operations before, less those after, its own sum included.
    savings: Tally<Pair>,
}

impl Sharing {
    fn insert(&mut self, node: Node, terms: Vec<Term>) {
        for (_, term) in &terms {
            self.with_term.entry(*term).or_default().push(node);
        }
        self.count(&terms, 1);
        self.sums.insert(node, terms);
    }

    /// Computes a pair once, wherever it occurs.
    fn share(&mut self, pair: Pair) {
        let (left, right, ratio) = pair;
        let terms = [(Coefficient::ONE, left), (ratio, right)];
        let sum = self.graph.sum(&terms.map(|(coefficient, node)| Scaled { coefficient, node }));
        let users = self.with_term.get(&left).cloned().unwrap_or_default();
        for node in users.into_iter().filter(|&node| node != sum.node) {
            let terms = self.sums[&node].clone();
            if let Some(shorter) = with_pair(&terms, pair, sum) {
                self.count(&terms, -1);
                self.graph.replace(node, Form::Sum(shorter.clone().into()));
                self.insert(node, shorter);
            }
        }
        // what is left of the pair is the sum that computes it
        self.savings.remove(&pair);
        if let Form::Sum(terms) = self.graph.form(sum.node)
            && !self.sums.contains_key(&sum.node)
        {
            self.sums.insert(sum.node, terms.to_vec());
        }
    }

    /// Counts the pairs of a sum in (+1) or out (−1).
    fn count(&mut self, terms: &[Term], sign: i32) {
        for (place, &first) in terms.iter().enumerate() {
            for &second in &terms[place + 1..] {
                let [(c, left), (d, right)] =
                    if first.1 < second.1 { [first, second] } else { [second, first] };
                let Some(ratio) = d.over(c) else { continue };
                let saved = 1 + self.multiplications(c, left) + self.multiplications(d, right)
                    - i32::from(!c.is_unit());
                let own = 1 + self.multiplications(ratio, right);
                self.savings.add((left, right, ratio), -own, sign * saved);
            }
        }
    }

    /// How many multiplications c n takes.
    fn multiplications(&self, coefficient: Coefficient, node: Node) -> i32 {
        i32::from(!coefficient.is_unit() && !matches!(self.graph.form(node), Form::One))
    }
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
