//! Nodes, the pool that owns them, and the symbols and unknown functions that they refer to.

use super::operation::Operation;
use super::primitive::Primitives;
use super::quadrature::Quadratures;
use crate::expression::Relation;
use rustc_hash::{FxBuildHasher, FxHashMap};
use std::collections::hash_map::Entry;
use std::hash::{Hash, Hasher};

/// An exact rational number of any size.
pub type Rational = num_rational::BigRational;

/// A scalar expression: the index of its node in a [`Pool`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Expr(pub(crate) u32);

/// A real variable: a coordinate, a parameter or an argument of a kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(pub(crate) u32);

impl Symbol {
    /// Returns the bit of this variable in the set of variables that an expression contains.
    fn bit(self) -> u64 {
        1 << (self.0 % u64::BITS)
    }
}

/// An unknown smooth function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FunctionId(pub(crate) u32);

/// Role of a real variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SymbolKind {
    /// A coordinate of one or more charts.
    Coordinate,
    /// A real constant of the statement.
    Parameter,
    /// A variable local to a kernel or an integral.
    Local,
}

/// Name and arguments of an unknown function.
#[derive(Clone, Debug)]
pub struct Unknown {
    /// Its name.
    pub name: String,
    /// The variables it is declared over.
    pub arguments: Vec<Symbol>,
}

/// The author's statement about the boundary between the pieces of a piecewise expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Seam {
    /// The pieces agree there.
    Agrees,
    /// The pieces can differ there: `if jump`.
    Jumps,
}

/// One operation on earlier expressions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Node {
    /// An exact number.
    Number(Rational),
    /// π
    Pi,
    /// A variable.
    Symbol(Symbol),
    /// a + b
    Add(Expr, Expr),
    /// −a
    Negate(Expr),
    /// a b
    Multiply(Expr, Expr),
    /// a / b
    Divide(Expr, Expr),
    /// aʳ with r rational; the real, non-negative branch if r is a fraction
    Power(Expr, num_rational::Ratio<i64>),
    /// A function of the operation table.
    Apply(Operation, Box<[Expr]>),
    /// A partial derivative of an unknown function, or its value if no order is above zero.
    Jet {
        /// The function.
        function: FunctionId,
        /// Order of differentiation in each argument.
        orders: Box<[u32]>,
        /// Arguments at which it is evaluated.
        arguments: Box<[Expr]>,
    },
    /// One of two values, chosen by a relation.
    Select {
        /// The relation's left side.
        left: Expr,
        /// The relation.
        relation: Relation,
        /// The relation's right side.
        right: Expr,
        /// The value where the relation holds.
        then: Expr,
        /// The value where the relation fails.
        otherwise: Expr,
        /// Whether the two values have to agree on the boundary of the relation.
        seam: Seam,
    },
}

/// Numbers and exponents are in lowest terms, so numerator and denominator are hashed directly: the
/// `Hash` of `Ratio` would divide.
impl Hash for Node {
    fn hash<H: Hasher>(&self, state: &mut H) {
        std::mem::discriminant(self).hash(state);
        match self {
            Node::Number(value) => (value.numer(), value.denom()).hash(state),
            Node::Pi => {}
            Node::Symbol(symbol) => symbol.hash(state),
            Node::Negate(a) => a.hash(state),
            Node::Add(a, b) | Node::Multiply(a, b) | Node::Divide(a, b) => (a, b).hash(state),
            Node::Power(a, exponent) => (a, exponent.numer(), exponent.denom()).hash(state),
            Node::Apply(operation, arguments) => (operation, arguments).hash(state),
            Node::Jet { function, orders, arguments } => (function, orders, arguments).hash(state),
            Node::Select { left, relation, right, then, otherwise, seam } => {
                (left, relation, right, then, otherwise, seam).hash(state);
            }
        }
    }
}

impl Node {
    /// Returns the expressions that the node is computed from.
    pub fn operands(&self) -> Vec<Expr> {
        let mut operands = Vec::new();
        self.for_each_operand(|operand| operands.push(operand));
        operands
    }

    /// Visits the expressions that the node is computed from.
    pub fn for_each_operand(&self, mut visit: impl FnMut(Expr)) {
        match self {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => {}
            Node::Negate(a) | Node::Power(a, _) => visit(*a),
            Node::Add(a, b) | Node::Multiply(a, b) | Node::Divide(a, b) => {
                visit(*a);
                visit(*b);
            }
            Node::Apply(_, arguments) | Node::Jet { arguments, .. } => {
                arguments.iter().for_each(|argument| visit(*argument));
            }
            Node::Select { left, right, then, otherwise, .. } => {
                [left, right, then, otherwise].into_iter().for_each(|operand| visit(*operand));
            }
        }
    }
}

/// Origin of a derivative: the expression that was differentiated, and the variable.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Origin {
    /// f of ∂f/∂x
    pub(crate) of: Expr,
    /// x of ∂f/∂x
    pub(crate) by: Symbol,
    /// Whether f itself contains derivatives.
    pub(crate) repeated: bool,
}

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
