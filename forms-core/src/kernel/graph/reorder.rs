//! Changing sums and products in place, and bringing the nodes back into the order of their operands.

use super::{Form, Graph, Node, Scaled};

impl Graph {
    /// Puts another form of the same value in a node's place, which may use any node that does not use this one.
    /// The graph has to be [`reordered`](Graph::reordered) before anything else is done with it.
    pub(in crate::kernel) fn replace(&mut self, node: Node, form: Form) {
        self.forms[node.place()] = form;
    }

    /// The same values with operands before results again.
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
