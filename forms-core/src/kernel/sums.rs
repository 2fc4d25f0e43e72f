//! Common subexpressions of sums: a pair of terms that occurs in several sums, with either sign, is
//! added once.
//!
//! a − b − c + d and a − b share a − b; 2x + 2y + z takes one multiplication as 2(x + y) + z.

use super::graph::{Coefficient, Form, Graph, Node, Scaled, Term};
use super::sharing::{Pairing, share, shareable, without};

/// Returns the graph with common pairs of terms in sums of their own.
pub(super) fn share_sums(graph: &Graph) -> Graph {
    share::<Sums>(graph.clone(), shareable::<Sums>(graph))
}

struct Sums;

impl Pairing for Sums {
    type Part = Term;
    /// n₁ + r n₂ up to a factor.
    type Pair = (Node, Node, Coefficient);

    fn parts(form: &Form) -> Option<&[Term]> {
        if let Form::Sum(terms) = form { Some(terms) } else { None }
    }

    fn form(terms: Vec<Term>) -> Form {
        Form::Sum(terms.into())
    }

    fn node(term: &Term) -> Node {
        term.1
    }

    fn anchor(pair: &Self::Pair) -> Node {
        pair.0
    }

    fn saving(graph: &Graph, first: Term, second: Term) -> Option<(Self::Pair, i32, i32)> {
        let [(c, left), (d, right)] = if first.1 < second.1 { [first, second] } else { [second, first] };
        let ratio = d.over(c)?;
        let saved =
            1 + multiplications(graph, c, left) + multiplications(graph, d, right) - i32::from(!c.is_unit());
        Some(((left, right, ratio), 1 + multiplications(graph, ratio, right), saved))
    }

    fn computed(graph: &mut Graph, (left, right, ratio): Self::Pair) -> Scaled {
        let terms = [(Coefficient::ONE, left), (ratio, right)];
        graph.sum(&terms.map(|(coefficient, node)| Scaled { coefficient, node }))
    }

    fn shortened(terms: &[Term], (left, right, ratio): Self::Pair, computed: Scaled) -> Option<Vec<Term>> {
        let places = |node: Node| (0..terms.len()).filter(move |&place| terms[place].1 == node);
        let is_pair = |&(first, second): &(usize, usize)| {
            first != second && terms[second].0.over(terms[first].0) == Some(ratio)
        };
        let mut candidates = places(left).flat_map(|first| places(right).map(move |second| (first, second)));
        let (first, second) = candidates.find(is_pair)?;
        let mut rest = without(terms, [first, second]);
        rest.push((terms[first].0.times(computed.coefficient)?, computed.node));
        Some(rest)
    }
}

/// Returns the number of multiplications in c n.
fn multiplications(graph: &Graph, coefficient: Coefficient, node: Node) -> i32 {
    i32::from(!coefficient.is_unit() && !matches!(graph.form(node), Form::One))
}
