//! Scalar expressions with shared nodes; operands precede the operations that use them.

use crate::polynomial::{MOST_BITS, is_long};
use num_bigint::BigInt;
use num_rational::BigRational;
use std::collections::{BTreeSet, HashMap};

/// Maximum number of nodes for one file.
const MOST_PARTS: usize = 200_000;

/// Node of an expression, by its index.
pub(crate) type Expr = usize;

/// Operation of a node; its operands are stored separately.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Operation {
    Number(BigRational),
    Pi,
    /// Coordinate or param.
    Variable(usize),
    Add,
    Multiply,
    Divide,
    /// a^(p/q) in lowest terms, q > 0
    Power(i64, i64),
    /// Function, by its name in the language.
    Function(&'static str),
    /// Derivative of an unknown function, with its order in each argument.
    Jet(usize, Vec<u32>),
}

use Operation::{Add, Divide, Function, Jet, Multiply, Number, Power, Variable};

/// Owner of expressions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pool {
    nodes: Vec<(Operation, Vec<Expr>)>,
    numbers: HashMap<(Operation, Vec<Expr>), Expr>,
    /// Derivative, or definition, of each function; its arguments are the variables 0 and 1.
    pub(crate) templates: HashMap<&'static str, Expr>,
}

pub(crate) fn rational(p: i64, q: i64) -> BigRational {
    BigRational::new(BigInt::from(p), BigInt::from(q))
}

/// Returns cⁿ, if it is a number and not too long.
fn small_power(c: &BigRational, n: i64) -> Option<BigRational> {
    let bits = c.numer().bits().max(c.denom().bits()).saturating_mul(n.unsigned_abs());
    let exponent = i32::try_from(n).ok().filter(|_| bits <= MOST_BITS)?;
    (n > 0 || *c != rational(0, 1)).then(|| c.pow(exponent))
}

impl Pool {
    pub(crate) fn node(&self, expr: Expr) -> (&Operation, &[Expr]) {
        (&self.nodes[expr].0, &self.nodes[expr].1)
    }

    /// Whether there is no room for another node. The last node then also stands for others, and
    /// all later results are meaningless.
    pub(crate) fn is_full(&self) -> bool {
        self.nodes.len() >= MOST_PARTS
    }

    pub(crate) fn as_number(&self, expr: Expr) -> Option<&BigRational> {
        if let Number(value) = &self.nodes[expr].0 { Some(value) } else { None }
    }

    pub(crate) fn is(&self, expr: Expr, value: i64) -> bool {
        self.as_number(expr).is_some_and(|number| *number == rational(value, 1))
    }

    /// Makes an operation on operands; sums and products with 0 and 1 are simplified.
    pub(crate) fn make(&mut self, operation: Operation, operands: Vec<Expr>) -> Expr {
        let is = |place: usize, value| self.is(operands[place], value);
        match operation {
            Add if is(0, 0) => return operands[1],
            Add if is(1, 0) => return operands[0],
            Multiply if is(0, 0) || is(1, 1) => return operands[0],
            Multiply if is(1, 0) || is(0, 1) => return operands[1],
            Divide if is(1, 1) => return operands[0],
            Power(1, 1) => return operands[0],
            Power(0, _) => return self.number(rational(1, 1)),
            _ => {}
        }
        if let Power(p, 1) = operation
            && let Some(value) = self.as_number(operands[0]).and_then(|value| small_power(value, p))
        {
            return self.number(value);
        }
        if let [Some(a), Some(b)] = [0, 1].map(|k| operands.get(k).and_then(|e| self.as_number(*e))) {
            let value = match operation {
                Add => Some(a + b),
                Multiply => Some(a * b),
                Divide if *b != rational(0, 1) => Some(a / b),
                _ => None,
            };
            if let Some(value) = value.filter(|value| !is_long(value)) {
                return self.number(value);
            }
        }
        let node = (operation, operands);
        if let Some(known) = self.numbers.get(&node) {
            return *known;
        }
        if !self.is_full() {
            self.numbers.insert(node.clone(), self.nodes.len());
            self.nodes.push(node);
        }
        self.nodes.len() - 1
    }

    pub(crate) fn number(&mut self, value: BigRational) -> Expr {
        self.make(Number(value), vec![])
    }

    pub(crate) fn negate(&mut self, a: Expr) -> Expr {
        let minus = self.number(rational(-1, 1));
        self.make(Multiply, vec![minus, a])
    }

    /// Returns all nodes of some expressions, operands first.
    pub(crate) fn parts(&self, roots: &[Expr]) -> BTreeSet<Expr> {
        let (mut open, mut parts) = (roots.to_vec(), BTreeSet::new());
        while let Some(expr) = open.pop() {
            if parts.insert(expr) {
                open.extend(&self.nodes[expr].1);
            }
        }
        parts
    }

    /// Returns the variables on which an expression depends.
    pub(crate) fn variables(&self, root: Expr) -> BTreeSet<usize> {
        let variable = |part: Expr| if let Variable(v) = self.nodes[part].0 { Some(v) } else { None };
        self.parts(&[root]).into_iter().filter_map(variable).collect()
    }

    /// Replaces variables of an expression.
    pub(crate) fn substitute(&mut self, root: Expr, images: &HashMap<usize, Expr>) -> Expr {
        let mut done: HashMap<Expr, Expr> = HashMap::new();
        for part in self.parts(&[root]) {
            let (operation, operands) = self.nodes[part].clone();
            let image = match operation {
                Variable(v) => images.get(&v).copied().unwrap_or(part),
                other => self.make(other, operands.iter().map(|operand| done[operand]).collect()),
            };
            done.insert(part, image);
        }
        done[&root]
    }

    /// Returns ∂root/∂x = Σ ∂root/∂aₖ ∂aₖ/∂x over the operands.
    pub(crate) fn derivative(&mut self, root: Expr, x: usize) -> Expr {
        let mut done: HashMap<Expr, Expr> = HashMap::new();
        for part in self.parts(&[root]) {
            let (operation, operands) = self.nodes[part].clone();
            let mut sum = self.number(rational(i64::from(operation == Variable(x)), 1));
            for (place, operand) in operands.iter().enumerate() {
                if !self.is(done[operand], 0) {
                    let outer = self.partial(part, &operation, &operands, place);
                    let term = self.make(Multiply, vec![outer, done[operand]]);
                    sum = self.make(Add, vec![sum, term]);
                }
            }
            done.insert(part, sum);
        }
        done[&root]
    }

    /// Returns the derivative of an operation by the operand at `place`.
    fn partial(&mut self, part: Expr, operation: &Operation, a: &[Expr], place: usize) -> Expr {
        let one = self.number(rational(1, 1));
        match operation {
            Multiply => a[1 - place],
            Divide if place == 0 => self.make(Divide, vec![one, a[1]]),
            Divide => {
                let quotient = self.make(Divide, vec![part, a[1]]);
                self.negate(quotient)
            }
            Power(p, 1) => {
                let (factor, lowered) =
                    (self.number(rational(*p, 1)), self.make(Power(p - 1, 1), vec![a[0]]));
                self.make(Multiply, vec![factor, lowered])
            }
            Power(p, q) => {
                let (factor, lowered) = (self.number(rational(*p, *q)), self.make(Divide, vec![part, a[0]]));
                self.make(Multiply, vec![factor, lowered])
            }
            Jet(f, orders) => {
                let mut raised = orders.clone();
                raised[place] += 1;
                self.make(Jet(*f, raised), a.to_vec())
            }
            Function(name) => {
                let slope = self.templates.get(name).copied().unwrap_or(one);
                self.substitute(slope, &HashMap::from([(0, a[0])]))
            }
            _ => one,
        }
    }
}
