//! Representation of a kernel for the algebraic passes: sums and products of any number of terms.
//!
//! ```text
//! Program ─ collect ─▶ Graph ─ expand ─ factor ─ sums ─ quotients ─ products ─▶ Graph ─ linearise ─▶ Program
//! ```
//! Signs and small rational coefficients are taken out of every node, so that 2a − 2b and b − a
//! share one node a − b, and equal nodes are one. A power keeps its base: x/x is never cancelled,
//! because it is undefined at 0.

mod build;
mod coefficient;
pub(super) mod collect;
mod reorder;

pub(super) use build::joined;
pub(super) use coefficient::{Coefficient, Exponent};

use super::constant::Constant;
use super::program::Program;
use crate::expression::{Operation, Relation};
use num_rational::Ratio;
use rustc_hash::FxHashMap;

/// A node of a [`Graph`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Node(u32);

impl Node {
    pub(super) fn place(self) -> usize {
        self.0 as usize
    }
}

/// c n: a rational multiple of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Scaled {
    pub(super) coefficient: Coefficient,
    pub(super) node: Node,
}

/// A term c n of a sum.
pub(super) type Term = (Coefficient, Node);
/// A factor nᵉ of a product.
pub(super) type Factor = (Node, Exponent);

/// Operation of a node.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Form {
    /// 1
    One,
    /// An argument of the kernel.
    Argument(u32),
    /// A number that is not a small rational: π, 10⁻³⁰.
    Number(Constant),
    /// A function of the operation table.
    Call(Operation, Box<[Scaled]>),
    /// A definite integral: its integrand, then its limits and the other values that it depends on.
    Quadrature(Box<Program>, Box<[Scaled]>),
    /// A power whose exponent is not a small rational.
    Power(Scaled, Ratio<i64>),
    /// A conditional: left, relation, right, then, otherwise.
    Select(Relation, Box<[Scaled; 4]>),
    /// Σ cᵢ nᵢ in the order of the nodes.
    Sum(Box<[Term]>),
    /// Π nᵢ^eᵢ in the order of the nodes.
    Product(Box<[Factor]>),
}

/// Sums and products in which equal nodes are shared.
#[derive(Clone, Debug, Default)]
pub(super) struct Graph {
    forms: Vec<Form>,
    known: FxHashMap<Form, Node>,
    /// Requested values, in the order of [`Program::roots`](super::Program::roots).
    pub(super) roots: Vec<Scaled>,
}

impl Graph {
    pub(super) fn form(&self, node: Node) -> &Form {
        &self.forms[node.place()]
    }

    pub(super) fn len(&self) -> usize {
        self.forms.len()
    }

    pub(super) fn intern(&mut self, form: Form) -> Node {
        if let Some(&known) = self.known.get(&form) {
            return known;
        }
        let fresh = Node(self.forms.len() as u32);
        self.forms.push(form.clone());
        self.known.insert(form, fresh);
        fresh
    }

    /// Returns the nodes that the roots need, operands before results.
    pub(super) fn reachable(&self) -> Vec<Node> {
        let mut needed = vec![false; self.forms.len()];
        for root in &self.roots {
            needed[root.node.place()] = true;
        }
        for place in (0..self.forms.len()).rev() {
            if needed[place] {
                self.forms[place].operands(|operand| needed[operand.place()] = true);
            }
        }
        (0..self.forms.len()).filter(|&place| needed[place]).map(|place| Node(place as u32)).collect()
    }

    /// Whether both graphs compute the same values in the same order.
    pub(super) fn is_same_as(&self, other: &Graph) -> bool {
        self.roots == other.roots && self.forms == other.forms
    }

    /// Counts the nodes and roots that use each node.
    pub(super) fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.forms.len()];
        for root in &self.roots {
            uses[root.node.place()] += 1;
        }
        for node in self.reachable() {
            self.form(node).operands(|operand| uses[operand.place()] += 1);
        }
        uses
    }

    /// Builds a new graph node by node; `rewrite` returns the image of a node, or `None` to leave
    /// it as it is.
    pub(super) fn rebuild(
        &self,
        mut rewrite: impl FnMut(&mut Graph, Node, &[Scaled]) -> Option<Scaled>,
    ) -> Graph {
        let mut new = Graph::default();
        let mut images = vec![new.one(); self.forms.len()];
        for node in self.reachable() {
            let image = rewrite(&mut new, node, &images);
            images[node.place()] = image.unwrap_or_else(|| new.copied(self, node, &images));
        }
        new.roots = self.roots.iter().map(|&root| new.image(root, &images)).collect();
        new
    }

    /// Returns the image of c n in a rebuilt graph.
    pub(super) fn image(&mut self, scaled: Scaled, images: &[Scaled]) -> Scaled {
        self.scale(scaled.coefficient, images[scaled.node.place()])
    }

    /// Copies a form over the images of its operands; a product within a product is not flattened.
    pub(super) fn copied(&mut self, old: &Graph, node: Node, images: &[Scaled]) -> Scaled {
        let form = old.form(node);
        let node = match form {
            Form::One | Form::Argument(_) | Form::Number(_) => self.intern(form.clone()),
            Form::Call(operation, operands) => {
                let operands = operands.iter().map(|&operand| self.image(operand, images)).collect();
                self.intern(Form::Call(*operation, operands))
            }
            Form::Quadrature(integrand, operands) => {
                let operands = operands.iter().map(|&operand| self.image(operand, images)).collect();
                self.intern(Form::Quadrature(integrand.clone(), operands))
            }
            Form::Power(base, exponent) => {
                let base = self.image(*base, images);
                self.intern(Form::Power(base, *exponent))
            }
            Form::Select(relation, operands) => {
                let operands = operands.map(|operand| self.image(operand, images));
                self.intern(Form::Select(*relation, Box::new(operands)))
            }
            Form::Sum(terms) => {
                let terms = terms.iter().map(|&(coefficient, node)| Scaled { coefficient, node });
                let terms: Vec<Scaled> = terms.map(|term| self.image(term, images)).collect();
                return self.sum(&terms);
            }
            Form::Product(factors) => {
                let is_opened = |base: Node| !matches!(old.form(base), Form::Product(_));
                let factors = factors.iter().map(|&(n, e)| (images[n.place()], e, is_opened(n)));
                let factors: Vec<(Scaled, Exponent, bool)> = factors.collect();
                return self.product_with(&factors);
            }
        };
        Scaled { coefficient: Coefficient::ONE, node }
    }
}

impl Form {
    /// Calls `visit` with every node that the form is computed from.
    pub(super) fn operands(&self, mut visit: impl FnMut(Node)) {
        match self {
            Form::One | Form::Argument(_) | Form::Number(_) => {}
            Form::Call(_, operands) | Form::Quadrature(_, operands) => {
                operands.iter().for_each(|operand| visit(operand.node));
            }
            Form::Power(base, _) => visit(base.node),
            Form::Select(_, operands) => operands.iter().for_each(|operand| visit(operand.node)),
            Form::Sum(terms) => terms.iter().for_each(|&(_, node)| visit(node)),
            Form::Product(factors) => factors.iter().for_each(|&(base, _)| visit(base)),
        }
    }
}
