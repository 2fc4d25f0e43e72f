//! Common pairs: two parts that occur together in several sums, or in several products, are
//! combined once (common subexpression elimination).
//!
//! The search is greedy: the pair that saves most goes first, until no pair saves anything. Sums
//! and products define their pairs and the savings.

use super::graph::{Form, Graph, Node, Scaled};
use super::tally::Tally;
use rustc_hash::FxHashMap;
use std::hash::Hash;

/// Largest number of parts of a sum or product that is shared; longer ones are left as they are.
const LONGEST: usize = 32;

/// Common interface of sums and products: they have parts, two of which make a pair.
pub(super) trait Pairing {
    /// Term of a sum, or factor of a product.
    type Part: Copy;
    /// Two parts, up to the difference that is allowed between their occurrences.
    type Pair: Copy + Ord + Hash;

    /// Returns the parts of a form of this kind.
    fn parts(form: &Form) -> Option<&[Self::Part]>;

    /// Returns the form with these parts.
    fn form(parts: Vec<Self::Part>) -> Form;

    /// Returns the node of a part.
    fn node(part: &Self::Part) -> Node;

    /// Returns a node that every form with this pair has as a part.
    fn anchor(pair: &Self::Pair) -> Node;

    /// Returns the pair of two parts, the cost of the pair itself, and the saving of taking it out
    /// of this form.
    fn saving(graph: &Graph, first: Self::Part, second: Self::Part) -> Option<(Self::Pair, i32, i32)>;

    /// Returns the node that computes the pair.
    fn computed(graph: &mut Graph, pair: Self::Pair) -> Scaled;

    /// Replaces the pair by the node that computes it, if the parts contain the pair and it can be
    /// replaced. A part may occur several times, because the node that computes a pair can be a
    /// part already: the pair takes one occurrence of each.
    fn shortened(parts: &[Self::Part], pair: Self::Pair, computed: Scaled) -> Option<Vec<Self::Part>>;
}

/// Shares the common pairs of these nodes.
pub(super) fn share<P: Pairing>(graph: Graph, nodes: Vec<(Node, Vec<P::Part>)>) -> Graph {
    let mut sharing: Sharing<P> = Sharing {
        graph,
        forms: FxHashMap::default(),
        with_part: FxHashMap::default(),
        savings: Tally::default(),
    };
    for (node, parts) in nodes {
        sharing.insert(node, parts);
    }
    while let Some(pair) = sharing.savings.take_best() {
        sharing.share(pair);
    }
    sharing.graph.reordered()
}

/// Returns the nodes of a graph with parts of this kind, unless they are too long.
pub(super) fn shareable<P: Pairing>(graph: &Graph) -> Vec<(Node, Vec<P::Part>)> {
    let parts = |node: Node| P::parts(graph.form(node)).filter(|parts| parts.len() <= LONGEST);
    graph.reachable().into_iter().filter_map(|node| Some((node, parts(node)?.to_vec()))).collect()
}

/// Returns the parts without the two at these indices.
pub(super) fn without<T: Copy>(parts: &[T], pair: [usize; 2]) -> Vec<T> {
    (0..parts.len()).filter(|place| !pair.contains(place)).map(|place| parts[place]).collect()
}

struct Sharing<P: Pairing> {
    graph: Graph,
    forms: FxHashMap<Node, Vec<P::Part>>,
    /// Forms that each node has been a part of.
    with_part: FxHashMap<Node, Vec<Node>>,
    /// Saving of each pair: operations before minus operations after, its own included.
    savings: Tally<P::Pair>,
}

impl<P: Pairing> Sharing<P> {
    fn insert(&mut self, node: Node, parts: Vec<P::Part>) {
        for part in &parts {
            self.with_part.entry(P::node(part)).or_default().push(node);
        }
        self.count(&parts, 1);
        self.forms.insert(node, parts);
    }

    /// Computes a pair once, wherever it occurs.
    fn share(&mut self, pair: P::Pair) {
        let computed = P::computed(&mut self.graph, pair);
        let users = self.with_part.get(&P::anchor(&pair)).cloned().unwrap_or_default();
        for node in users.into_iter().filter(|&node| node != computed.node) {
            let parts = self.forms[&node].clone();
            if let Some(shorter) = P::shortened(&parts, pair, computed) {
                self.count(&parts, -1);
                self.graph.replace(node, P::form(shorter.clone()));
                self.insert(node, shorter);
            }
        }
        // the only remaining occurrence of the pair is the form that computes it
        self.savings.remove(&pair);
        if let Some(parts) = P::parts(self.graph.form(computed.node))
            && !self.forms.contains_key(&computed.node)
        {
            self.forms.insert(computed.node, parts.to_vec());
        }
    }

    /// Adds (+1) or removes (−1) the savings of the pairs of a form.
    fn count(&mut self, parts: &[P::Part], sign: i32) {
        for (place, &first) in parts.iter().enumerate() {
            for &second in &parts[place + 1..] {
                if let Some((pair, own, saved)) = P::saving(&self.graph, first, second) {
                    self.savings.add(pair, -own, sign * saved);
                }
            }
        }
    }
}
