//! Nodes, and the symbols and unknown functions that they refer to.

use super::operation::Operation;
use super::relation::Relation;
use std::hash::{Hash, Hasher};

/// An exact rational number of any size.
pub type Rational = num_rational::BigRational;

/// A scalar expression: the index of its node in a [`Pool`](super::Pool).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Expr(pub(crate) u32);

/// A real variable: a coordinate, a parameter or an argument of a kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(pub(crate) u32);

impl Symbol {
    /// Returns the bit of this variable in the set of variables that an expression contains.
    pub(super) fn bit(self) -> u64 {
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
