//! In-place changes of sums and products, and the restoration of the order of operands before
//! results.

use super::{Form, Graph, Node, Scaled};

impl Graph {
    /// Replaces the form of a node by another one of the same value, which can use any node that
    /// does not use this one. The graph has to be [`reordered`](Graph::reordered) before it is used
    /// in any other way.
    pub(in crate::kernel) fn replace(&mut self, node: Node, form: Form) {
        self.forms[node.place()] = form;
    }

    /// Returns a graph of the same values with operands before results again.
    pub(in crate::kernel) fn reordered(&self) -> Graph {
        let mut new = Graph::default();
        let mut images: Vec<Scaled> = vec![new.one(); self.forms.len()];
        let mut done = vec![false; self.forms.len()];
        let mut pending: Vec<(Node, bool)> = Vec::new();
        for root in &self.roots {
            pending.push((root.node, false));
            while let Some((node, operands_done)) = pending.pop() {
                if done[node.place()] {
                    continue;
                }
                if operands_done {
                    done[node.place()] = true;
                    images[node.place()] = new.copied(self, node, &images);
                } else {
                    pending.push((node, true));
                    let first = pending.len();
                    self.form(node).operands(|operand| pending.push((operand, false)));
                    pending[first..].reverse();
                }
            }
        }
        new.roots = self.roots.iter().map(|&root| new.image(root, &images)).collect();
        new
    }
}
