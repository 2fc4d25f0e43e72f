//! Enclosures of expressions: the shared graph evaluated once, operands before results.

use super::bounds::{Enclosure, Precision, Undecided};
use super::quadrature::quadrature;
use crate::expression::{Expr, FunctionId, Node, Operation, Pool, Symbol};
use crate::steps;
use num_rational::Ratio;
use rustc_hash::FxHashMap;

/// Numbers beyond 2^(this) are not computed further: repeated squaring would not end.
const LARGEST_BITS: u64 = 1 << 14;

type Decided = Result<Enclosure, Undecided>;

impl Enclosure {
    /// Applies a function of the table of operations to its arguments; unknown if their number is
    /// wrong.
    pub fn apply(operation: Operation, arguments: &[Enclosure]) -> Result<Enclosure, Undecided> {
        match (operation, arguments) {
            (Operation::Sin, [a]) => Ok(a.sin()),
            (Operation::Cos, [a]) => Ok(a.cos()),
            (Operation::Tan, [a]) => a.tan(),
            (Operation::Asin, [a]) => a.asin(),
            (Operation::Acos, [a]) => a.acos(),
            (Operation::Atan, [a]) => Ok(a.atan()),
            (Operation::Atan2, [y, x]) => Enclosure::atan2(y, x),
            (Operation::Exp, [a]) => a.exp(),
            (Operation::Log, [a]) => a.log(),
            (Operation::Sinh, [a]) => a.sinh(),
            (Operation::Cosh, [a]) => a.cosh(),
            (Operation::Tanh, [a]) => Ok(a.tanh()),
            (Operation::Abs, [a]) => Ok(a.abs()),
            (Operation::Expm1, [a]) => a.expm1(),
            (Operation::Log1p, [a]) => a.log1p(),
            (Operation::Erf, [a]) => Ok(a.erf()),
            (Operation::Expint1, [a]) => a.expint1(),
            (Operation::Expint2, [a]) => a.expint2(),
            (Operation::Expint3, [a]) => a.expint3(),
            (Operation::Dilog, [a]) => a.dilog(),
            (Operation::Clausen, [a]) => Ok(a.clausen()),
            (Operation::Erfc, [a]) => Ok(a.erfc()),
            (Operation::Hypot, [x, y]) => Enclosure::hypot(x, y),
            (Operation::Cbrt, [a]) => a.cbrt(),
            _ => Err(Undecided::Unknown),
        }
    }
}

/// Encloses expressions at given values of the variables and given jets of the unknown functions.
///
/// `jets` returns a partial derivative of an unknown function from its orders and the values of its
/// arguments. A value that is not given is unknown, except for quadratures, which are integrals of
/// known integrands. A result computed from an undefined value is undefined. Where a condition is
/// not decided, the result encloses both branches.
pub fn enclose(
    pool: &Pool,
    expressions: &[Expr],
    values: &impl Fn(Symbol) -> Option<Enclosure>,
    jets: &mut impl FnMut(FunctionId, &[u32], &[Enclosure]) -> Option<Enclosure>,
    precision: Precision,
) -> Vec<Result<Enclosure, Undecided>> {
    enclose_with((pool, expressions), values, jets, precision, |_| None)
}

/// Encloses expressions with the values that a kernel computes: also on the branch cut of `atan2`,
/// which statements exclude.
pub(crate) fn enclose_of_kernel(
    pool: &Pool,
    expressions: &[Expr],
    values: &impl Fn(Symbol) -> Option<Enclosure>,
    precision: Precision,
) -> Vec<Result<Enclosure, Undecided>> {
    let on_the_cut =
        |[y, x]: [&Enclosure; 2]| (y.is_zero() && x.is_negative()).then(|| Enclosure::pi(precision));
    enclose_with((pool, expressions), values, &mut |_, _, _| None, precision, on_the_cut)
}

/// Encloses expressions, with values of `atan2` where it has none otherwise.
fn enclose_with(
    (pool, expressions): (&Pool, &[Expr]),
    values: &impl Fn(Symbol) -> Option<Enclosure>,
    jets: &mut impl FnMut(FunctionId, &[u32], &[Enclosure]) -> Option<Enclosure>,
    precision: Precision,
    angle: impl Fn([&Enclosure; 2]) -> Option<Enclosure>,
) -> Vec<Result<Enclosure, Undecided>> {
    let mut known: FxHashMap<Expr, Decided> = FxHashMap::default();
    for expression in pool.reachable(expressions) {
        let cost = match pool.node(expression) {
            Node::Apply(..) | Node::Power(..) => steps::of_function(precision.0),
            _ => steps::of_arithmetic(precision.0),
        };
        let value = match pool.node(expression) {
            _ if !steps::spend(cost) => Err(Undecided::TooLarge),
            Node::Symbol(symbol) => values(*symbol).ok_or(Undecided::Unknown),
            Node::Jet { function, orders, arguments } => all(arguments, &known).and_then(|arguments| {
                quadrature(pool, *function, &arguments, precision)
                    .unwrap_or_else(|| jets(*function, orders, &arguments).ok_or(Undecided::Unknown))
            }),
            Node::Apply(Operation::Atan2, q) => all(q, &known)
                .and_then(|q| angle([&q[0], &q[1]]).map_or_else(|| Enclosure::atan2(&q[0], &q[1]), Ok)),
            node => evaluate(node, &known, precision),
        };
        known.insert(expression, value.and_then(bounded));
    }
    expressions.iter().map(|expression| known[expression].clone()).collect()
}

/// Encloses the value of an expression without variables and unknown functions.
pub(crate) fn enclose_number(pool: &Pool, number: Expr, precision: Precision) -> Decided {
    enclose(pool, &[number], &|_| None, &mut |_, _, _| None, precision).remove(0)
}

/// Rejects values that have become too large to compute with.
fn bounded(value: Enclosure) -> Decided {
    if value.magnitude_bits() <= LARGEST_BITS {
        return Ok(value);
    }
    let certain = value.least_magnitude_bits() > LARGEST_BITS;
    Err(if certain { Undecided::TooLarge } else { Undecided::Unknown })
}

/// Returns the values of several operands, or the most serious reason why one is missing.
fn all(operands: &[Expr], known: &FxHashMap<Expr, Decided>) -> Result<Vec<Enclosure>, Undecided> {
    if let Some(worst) = operands.iter().filter_map(|operand| known[operand].as_ref().err()).min() {
        return Err(*worst);
    }
    operands.iter().map(|operand| known[operand].clone()).collect()
}

fn evaluate(node: &Node, known: &FxHashMap<Expr, Decided>, precision: Precision) -> Decided {
    let both = |a: &Expr, b: &Expr| match (&known[a], &known[b]) {
        (Ok(a), Ok(b)) => Ok((a, b)),
        (Err(a), Err(b)) => Err(*a.min(b)),
        (Err(why), Ok(_)) | (Ok(_), Err(why)) => Err(*why),
    };
    let one = |a: &Expr| known[a].as_ref().map_err(|&why| why);
    match node {
        Node::Number(value) => Ok(Enclosure::exact(value, precision)),
        Node::Pi => Ok(Enclosure::pi(precision)),
        Node::Add(a, b) => both(a, b).map(|(a, b)| a.add(b)),
        Node::Negate(a) => one(a).map(Enclosure::neg),
        Node::Multiply(a, b) if a == b => one(a)?.power(Ratio::from_integer(2)),
        Node::Multiply(a, b) => both(a, b).map(|(a, b)| a.mul(b)),
        Node::Divide(a, b) => both(a, b).and_then(|(a, b)| a.div(b)),
        Node::Power(a, exponent) => one(a)?.power(*exponent),
        Node::Apply(operation, arguments) => Enclosure::apply(*operation, &all(arguments, known)?),
        Node::Select { left, relation, right, then, otherwise, .. } => {
            let (left, right) = both(left, right)?;
            match left.decide(*relation, right) {
                Some(true) => known[then].clone(),
                Some(false) => known[otherwise].clone(),
                None => either(&known[then], &known[otherwise]),
            }
        }
        Node::Symbol(_) | Node::Jet { .. } => Err(Undecided::Unknown),
    }
}

/// Encloses the result of a choice whose condition is not decided.
fn either(a: &Decided, b: &Decided) -> Decided {
    match (a, b) {
        (Ok(a), Ok(b)) => Ok(a.hull(b)),
        (Err(a), Err(b)) => Err(*a.max(b)),
        _ => Err(Undecided::Unknown),
    }
}
