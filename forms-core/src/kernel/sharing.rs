//! Common pairs: two parts that occur together in several sums, or in several products, are put together once.
//!
//! Greedy: the pair that saves most goes first, until no pair saves anything. What a pair is, and what it saves,
//! is the business of sums and of products.

use super::graph::{Form, Graph, Node, Scaled};
use super::tally::Tally;
use rustc_hash::FxHashMap;
use std::hash::Hash;

/// Longer sums and products are left as they are.
const LONGEST: usize = 32;

/// What sums and products have in common: parts, two of which make a pair.
pub(super) trait Pairing {
    /// A term of a sum, a factor of a product.
    type Part: Copy;
    /// Two of them, up to what they may differ by from place to place.
    type Pair: Copy + Ord + Hash;

    /// The parts of a form of this kind.
    fn parts(form: &Form) -> Option<&[Self::Part]>;

    /// The form with these parts.
    fn form(parts: Vec<Self::Part>) -> Form;

    /// The node of a part.
    fn node(part: &Self::Part) -> Node;

    /// A node that every form with this pair has as a part.
    fn anchor(pair: &Self::Pair) -> Node;

    /// The pair of two parts, what the pair itself costs, and what taking it out of this form saves.
    fn saving(graph: &Graph, first: Self::Part, second: Self::Part) -> Option<(Self::Pair, i32, i32)>;

    /// What computes the pair.
    fn computed(graph: &mut Graph, pair: Self::Pair) -> Scaled;

    /// The parts with the pair replaced by what computes it, if they contain it and it can be replaced. A part may
    /// occur several times, because what computes a pair can be a part already: the pair takes one of each with it.
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

/// The nodes of a graph with parts of this kind, unless they are too long.
pub(super) fn shareable<P: Pairing>(graph: &Graph) -> Vec<(Node, Vec<P::Part>)> {
    let parts = |node: Node| P::parts(graph.form(node)).filter(|parts| parts.len() <= LONGEST);
    graph.reachable().into_iter().filter_map(|node| Some((node, parts(node)?.to_vec()))).collect()
}

/// The parts but for those at two places.
pub(super) fn without<T: Copy>(parts: &[T], pair: [usize; 2]) -> Vec<T> {
    (0..parts.len()).filter(|place| !pair.contains(place)).map(|place| parts[place]).collect()
}

struct Sharing<P: Pairing> {
    graph: Graph,
    forms: FxHashMap<Node, Vec<P::Part>>,
    /// The forms that each node has been a part of.
    with_part: FxHashMap<Node, Vec<Node>>,
    /// What each pair saves: operations before, less those after, its own included.
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
        // what is left of the pair is the form that computes it
        self.savings.remove(&pair);
        if let Some(parts) = P::parts(self.graph.form(computed.node))
            && !self.forms.contains_key(&computed.node)
        {
            self.forms.insert(computed.node, parts.to_vec());
        }
    }

    /// Counts the pairs of a form in (+1) or out (−1).
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
