//! Edges: the ends of the arguments' ranges, and the parts of a formula that vanish inside them.

use crate::decide::simple_bounds;
use crate::expression::{Condition, Expr, Node, Operation, Pool, Symbol};
use crate::kernel::{KernelSource, Program, lower, nearest_f64};
use crate::theory::Kernel;
use rustc_hash::FxHashSet;

/// Limit on the number of tracked parts of a formula.
const MOST_PARTS: usize = 200;

/// Number of steps that close in on a zero between two numbers.
const CLOSING_STEPS: usize = 90;

/// Places where a kernel is hard to compute accurately.
pub(super) struct Edges {
    /// The least and the greatest value of each argument, if the domain bounds it.
    pub(super) ranges: Vec<(Option<f64>, Option<f64>)>,
    /// Groups of arguments that are subtracted from each other.
    pub(super) groups: Vec<Vec<usize>>,
    /// Pairs of vectors, by the arguments that are multiplied in their scalar products.
    pub(super) vectors: Vec<Vec<(usize, usize)>>,
    /// The parts of the formula that are hard where they vanish, as one program.
    vanishing: Option<Program>,
}

impl Edges {
    pub(super) fn of(pool: &mut Pool, kernel: &Kernel) -> Self {
        let ranges = ranges(pool, kernel);
        let (groups, vectors) = (groups(pool, kernel), vectors(pool, kernel));
        let parts = vanishing_parts(pool, kernel);
        let source =
            KernelSource { arguments: kernel.arguments.clone(), outputs: parts, ..KernelSource::default() };
        Edges { ranges, groups, vectors, vanishing: lower(pool, &source).ok() }
    }

    /// Returns the number of tracked parts.
    pub(super) fn parts(&self) -> usize {
        self.vanishing.as_ref().map_or(0, |program| program.outputs().len())
    }

    /// Returns a value of one argument at which a part vanishes or comes close to zero, with the
    /// other arguments unchanged. The value is searched for between neighbours of a grid.
    pub(super) fn zero(&self, part: usize, argument: usize, point: &[f64], grid: &[f64]) -> Option<f64> {
        let program = self.vanishing.as_ref()?;
        let mut point = point.to_vec();
        let mut value = |x: f64| {
            point[argument] = x;
            program.interpret(&point)[part]
        };
        let values: Vec<f64> = grid.iter().map(|&x| value(x)).collect();
        for (place, pair) in values.windows(2).enumerate() {
            if pair[0] == 0.0 {
                return Some(grid[place]);
            }
            if pair[0] * pair[1] < 0.0 {
                return Some(sign_change(&mut value, grid[place], grid[place + 1], pair[0]));
            }
        }
        let dip = values.windows(3).position(|three| {
            let [a, b, c] = [three[0].abs(), three[1].abs(), three[2].abs()];
            b < a && b < c
        })?;
        Some(least_size(&mut value, grid[dip], grid[dip + 2]))
    }
}

/// Returns the least and the greatest value of each argument of a kernel, where its domain bounds
/// that argument by numbers.
pub fn ranges(pool: &Pool, kernel: &Kernel) -> Vec<(Option<f64>, Option<f64>)> {
    let bounds = simple_bounds(pool, &kernel.domain);
    let range = |argument: &Symbol| {
        let known = bounds.get(argument);
        let end = |value: Option<&crate::expression::Rational>| value.map(nearest_f64);
        (end(known.and_then(|b| b.lower.as_ref())), end(known.and_then(|b| b.upper.as_ref())))
    };
    kernel.arguments.iter().map(range).collect()
}

/// Returns the place where a function changes its sign between two numbers, by bisection.
fn sign_change(value: &mut impl FnMut(f64) -> f64, mut a: f64, mut b: f64, at_a: f64) -> f64 {
    for _ in 0..CLOSING_STEPS {
        let middle = a + (b - a) / 2.0;
        let known = value(middle);
        if known == 0.0 || middle == a || middle == b {
            return middle;
        }
        if (known < 0.0) == (at_a < 0.0) { a = middle } else { b = middle }
    }
    a
}

/// Returns the place where the magnitude of a function is least between two numbers, by ternary
/// search.
fn least_size(value: &mut impl FnMut(f64) -> f64, mut a: f64, mut b: f64) -> f64 {
    for _ in 0..CLOSING_STEPS {
        let third = (b - a) / 3.0;
        let (left, right) = (a + third, b - third);
        if value(left).abs() <= value(right).abs() { b = right } else { a = left }
    }
    a + (b - a) / 2.0
}

/// Returns groups of arguments with functions that are subtracted from each other or
/// compared; groups that share an argument are joined.
fn groups(pool: &Pool, kernel: &Kernel) -> Vec<Vec<usize>> {
    let argument = |expression: Expr| match pool.symbols_in(&[expression])[..] {
        [symbol] => kernel.arguments.iter().position(|&known| known == symbol),
        _ => None,
    };
    let mut group: Vec<usize> = (0..kernel.arguments.len()).collect();
    let sides = kernel.domain.iter().flat_map(|condition| [condition.left, condition.right]);
    let roots: Vec<Expr> = kernel.outputs.iter().copied().chain(sides).collect();
    let mut join = |a: usize, b: usize| {
        let (from, to) = (group[a], group[b]);
        group.iter_mut().filter(|known| **known == from).for_each(|known| *known = to);
    };
    for expression in pool.reachable(&roots) {
        let terms = pool.summands(expression);
        if let [(a, false), (b, true)] | [(a, true), (b, false)] = terms[..]
            && let (Some(a), Some(b)) = (argument(a), argument(b))
        {
            join(a, b);
        }
    }
    for condition in &kernel.domain {
        if let (Some(a), Some(b)) = (argument(condition.left), argument(condition.right)) {
            join(a, b);
        }
    }
    let members = |name: usize| (0..group.len()).filter(|&place| group[place] == name).collect::<Vec<_>>();
    (0..group.len()).map(members).filter(|members| members.len() > 1).collect()
}

/// Returns the pairs of arguments that are multiplied in each sum of products of different arguments.
fn vectors(pool: &Pool, kernel: &Kernel) -> Vec<Vec<(usize, usize)>> {
    let argument = |expression: Expr| match *pool.node(expression) {
        Node::Symbol(symbol) => kernel.arguments.iter().position(|&known| known == symbol),
        _ => None,
    };
    let mut found: Vec<Vec<(usize, usize)>> = Vec::new();
    for expression in pool.reachable(&kernel.outputs) {
        let mut pairs: Vec<(usize, usize)> = Vec::new();
        for (term, _) in pool.summands(expression) {
            let Node::Multiply(a, b) = *pool.node(term) else { continue };
            let (Some(a), Some(b)) = (argument(a), argument(b)) else { continue };
            let is_used = |place: usize| pairs.iter().any(|&(p, q)| p == place || q == place);
            if a != b && !is_used(a) && !is_used(b) {
                pairs.push((a, b));
            }
        }
        if pairs.len() > 1 && !found.contains(&pairs) {
            found.push(pairs);
        }
    }
    found
}

/// Returns divisors, radicands, arguments of logarithms and their distance from 1, sums, and the
/// margins of the domain.
fn vanishing_parts(pool: &mut Pool, kernel: &Kernel) -> Vec<Expr> {
    let margins: Vec<Expr> =
        kernel.domain.iter().map(|Condition { left, right, .. }| pool.subtract(*left, *right)).collect();
    let one = pool.integer(1);
    let mut parts = Vec::new();
    for expression in pool.reachable(&kernel.outputs) {
        match pool.node(expression).clone() {
            Node::Add(..) => parts.push(expression),
            Node::Divide(_, divisor) => parts.push(divisor),
            Node::Power(base, exponent) if !exponent.is_integer() || *exponent.numer() < 0 => {
                parts.push(base);
            }
            Node::Apply(Operation::Log, q) => parts.extend([q[0], pool.subtract(q[0], one)]),
            Node::Apply(Operation::Asin | Operation::Acos, q) => {
                parts.push(pool.subtract(one, q[0]));
                parts.push(pool.add(one, q[0]));
            }
            Node::Apply(Operation::Atan2, q) => parts.extend(q.iter().copied()),
            Node::Select { left, right, .. } => parts.push(pool.subtract(left, right)),
            _ => {}
        }
    }
    parts.extend(margins);
    let mut seen: FxHashSet<Expr> = FxHashSet::default();
    parts.retain(|&part| !is_fixed(pool, part, &kernel.arguments) && seen.insert(part));
    parts.truncate(MOST_PARTS);
    parts
}

fn is_fixed(pool: &Pool, part: Expr, arguments: &[Symbol]) -> bool {
    !pool.symbols_in(&[part]).iter().any(|symbol| arguments.contains(symbol))
}
