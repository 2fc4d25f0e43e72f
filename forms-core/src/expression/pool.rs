//! The pool: the owner of all nodes of a file or macro body, which shares equal nodes.

use super::integral_table::{Primitives, Quadratures};
use super::node::{Expr, FunctionId, Node, Origin, Symbol, SymbolKind, Unknown};
use rustc_hash::{FxBuildHasher, FxHashMap};
use std::collections::hash_map::Entry;

/// The owner of all nodes, symbols and unknown functions of one file or macro body.
#[derive(Clone, Debug)]
pub struct Pool {
    nodes: Vec<Node>,
    /// For each node, the bit set of its variables: bit k stands for the variables whose numbers
    /// are k modulo 64.
    mentioned: Vec<u64>,
    index: FxHashMap<Node, Expr>,
    symbols: Vec<(String, SymbolKind)>,
    functions: Vec<Unknown>,
    pub(super) derivatives: FxHashMap<(Expr, Symbol), Expr>,
    /// Origins of the expressions that arose as derivatives.
    pub(super) origins: FxHashMap<Expr, Origin>,
    /// The least expression that arose as a derivative.
    pub(super) least_derivative: Option<Expr>,
    /// Cache of the integers built so far, by value.
    pub(super) integers: FxHashMap<i64, Expr>,
    /// Unknown functions that represent integrals.
    pub(super) primitives: Primitives,
    /// Functions that represent integrals to be computed numerically.
    pub(super) quadratures: Quadratures,
}

/// Initial capacity: the nodes of a short statement fit without growth of the tables.
const FIRST_NODES: usize = 256;

impl Default for Pool {
    fn default() -> Self {
        Pool {
            nodes: Vec::with_capacity(FIRST_NODES),
            mentioned: Vec::with_capacity(FIRST_NODES),
            index: FxHashMap::with_capacity_and_hasher(FIRST_NODES, FxBuildHasher),
            symbols: Vec::new(),
            functions: Vec::new(),
            derivatives: FxHashMap::default(),
            origins: FxHashMap::default(),
            least_derivative: None,
            integers: FxHashMap::default(),
            primitives: Primitives::default(),
            quadratures: Quadratures::default(),
        }
    }
}

impl Pool {
    /// Creates an empty pool.
    pub fn new() -> Self {
        Self::default()
    }

    /// Returns the number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether the pool has no nodes yet.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Returns the node of an expression.
    pub fn node(&self, expression: Expr) -> &Node {
        &self.nodes[expression.0 as usize]
    }

    pub(super) fn intern(&mut self, node: Node) -> Expr {
        let fresh = Expr(u32::try_from(self.nodes.len()).expect("a pool holds fewer than 2³² nodes"));
        match self.index.entry(node) {
            Entry::Occupied(known) => *known.get(),
            Entry::Vacant(place) => {
                let node = place.key();
                let mut mentioned = if let Node::Symbol(symbol) = node { symbol.bit() } else { 0 };
                node.for_each_operand(|operand| mentioned |= self.mentioned[operand.0 as usize]);
                self.mentioned.push(mentioned);
                self.nodes.push(node.clone());
                *place.insert(fresh)
            }
        }
    }

    /// Whether a variable may occur in an expression; `false` is certain.
    pub(super) fn may_mention(&self, expression: Expr, symbol: Symbol) -> bool {
        self.mentioned[expression.0 as usize] & symbol.bit() != 0
    }

    /// Declares a new variable; declaring the same name twice gives two variables.
    pub fn declare_symbol(&mut self, name: impl Into<String>, kind: SymbolKind) -> Symbol {
        self.symbols.push((name.into(), kind));
        Symbol(self.symbols.len() as u32 - 1)
    }

    /// Returns the name that a variable was declared with.
    pub fn symbol_name(&self, symbol: Symbol) -> &str {
        &self.symbols[symbol.0 as usize].0
    }

    /// Returns the role of a variable.
    pub fn symbol_kind(&self, symbol: Symbol) -> SymbolKind {
        self.symbols[symbol.0 as usize].1
    }

    /// Declares a new unknown function of these variables.
    pub fn declare_function(&mut self, name: impl Into<String>, arguments: Vec<Symbol>) -> FunctionId {
        self.functions.push(Unknown { name: name.into(), arguments });
        FunctionId(self.functions.len() as u32 - 1)
    }

    /// Returns the name and the declared arguments of an unknown function.
    pub fn function(&self, function: FunctionId) -> &Unknown {
        &self.functions[function.0 as usize]
    }

    /// Returns the summands of a sum in order, each with whether it is subtracted.
    pub(crate) fn summands(&self, sum: Expr) -> Vec<(Expr, bool)> {
        let (mut summands, mut pending) = (Vec::new(), vec![(sum, false)]);
        while let Some((part, negative)) = pending.pop() {
            match *self.node(part) {
                Node::Add(a, b) => pending.extend([(b, negative), (a, negative)]),
                Node::Negate(a) => pending.push((a, !negative)),
                _ => summands.push((part, negative)),
            }
        }
        summands
    }

    /// Returns every node that these expressions are computed from, including themselves, operands
    /// before results.
    pub fn reachable(&self, roots: &[Expr]) -> Vec<Expr> {
        let Some(last) = roots.iter().max() else { return Vec::new() };
        let mut seen = vec![false; last.0 as usize + 1];
        roots.iter().for_each(|root| seen[root.0 as usize] = true);
        let mut order = Vec::with_capacity(seen.len().min(FIRST_NODES));
        for index in (0..=last.0).rev() {
            if seen[index as usize] {
                order.push(Expr(index));
                self.nodes[index as usize].for_each_operand(|operand| seen[operand.0 as usize] = true);
            }
        }
        order.reverse();
        order
    }

    /// Returns the variables that these expressions contain, in the order of their declaration.
    pub fn symbols_in(&self, roots: &[Expr]) -> Vec<Symbol> {
        let mut found: Vec<Symbol> = self
            .reachable(roots)
            .into_iter()
            .filter_map(|expression| match self.node(expression) {
                Node::Symbol(symbol) => Some(*symbol),
                _ => None,
            })
            .collect();
        found.sort_unstable();
        found
    }
}
