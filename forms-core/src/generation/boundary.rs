//! The boundary of a relation: where a < b begins to hold, a = b, solved for one of its parts.
//!
//! A part is a variable or a whole subexpression. At every point of the boundary the part equals
//! the solution, so an equation with the solution substituted for the part holds or fails there
//! exactly as the original does.

use crate::expression::{Condition, Expr, Node, Operation, Pool, Relation};
use num_traits::Zero;
use rustc_hash::FxHashMap;

/// One sheet of a boundary: the points with left = right that meet the conditions.
#[derive(Clone, Debug)]
pub(super) struct Sheet {
    left: Expr,
    right: Expr,
    pub(super) conditions: Vec<Condition>,
}

/// Solution of a sheet's equation for one of its parts, in terms of the others.
#[derive(Clone, Debug)]
pub(super) struct Solution {
    /// Variable or subexpression that is solved for.
    pub(super) part: Expr,
    /// Its values, each with its own conditions.
    pub(super) values: Vec<(Expr, Vec<Condition>)>,
    /// Whether the values cover every point of the sheet.
    pub(super) is_complete: bool,
    /// Whether each choice of the other variables gives a point of the sheet, as it does if the
    /// part is a variable.
    pub(super) is_parametrisation: bool,
}

/// Returns the sheets of a = b: |q| = b is q = ±b, and √q = b is q = b², both with b ≥ 0.
pub(super) fn sheets(pool: &mut Pool, condition: &Condition) -> Vec<Sheet> {
    for (outer, other) in [(condition.left, condition.right), (condition.right, condition.left)] {
        let zero = pool.integer(0);
        let not_negative = vec![Condition { left: other, relation: Relation::GreaterEqual, right: zero }];
        match pool.node(outer).clone() {
            Node::Apply(Operation::Abs, q) => {
                let opposite = pool.negate(other);
                let sheet = |right| Sheet { left: q[0], right, conditions: not_negative.clone() };
                return if pool.is_zero(other) {
                    vec![sheet(other)]
                } else {
                    vec![sheet(other), sheet(opposite)]
                };
            }
            Node::Power(q, exponent) if *exponent.numer() == 1 && *exponent.denom() == 2 => {
                let right = pool.power(other, 2.into());
                return vec![Sheet { left: q, right, conditions: not_negative }];
            }
            _ => {}
        }
    }
    vec![Sheet { left: condition.left, right: condition.right, conditions: Vec::new() }]
}

impl Sheet {
    /// Returns the sheet's equation in the language's notation.
    pub(super) fn text(&self, pool: &Pool) -> String {
        format!("{} = {}", pool.text(self.left), pool.text(self.right))
    }

    /// Solves the equation in every known way, solutions for a variable first.
    pub(super) fn solutions(&self, pool: &mut Pool, known: &[Condition]) -> Vec<Solution> {
        let difference = pool.subtract(self.left, self.right);
        let symbols: Vec<Expr> =
            pool.symbols_in(&[difference]).into_iter().map(|symbol| pool.symbol(symbol)).collect();
        let is_function = |node: &Node| match node {
            Node::Apply(..) => true,
            Node::Power(_, exponent) => !exponent.is_integer(),
            _ => false,
        };
        let functions: Vec<Expr> =
            pool.reachable(&[difference]).into_iter().filter(|&part| is_function(pool.node(part))).collect();
        let mut solutions: Vec<Solution> =
            symbols.iter().filter_map(|&symbol| solve(pool, difference, symbol, known)).collect();
        for (part, value) in [(self.left, self.right), (self.right, self.left)] {
            if !matches!(pool.node(part), Node::Number(_) | Node::Pi | Node::Symbol(_)) {
                let values = vec![(value, Vec::new())];
                solutions.push(Solution { part, values, is_complete: true, is_parametrisation: false });
            }
        }
        solutions.extend(functions.iter().filter_map(|&part| solve(pool, difference, part, known)));
        solutions
    }
}

/// Solves p = 0 for a part in which p is a polynomial of degree one or two.
fn solve(pool: &mut Pool, polynomial: Expr, part: Expr, known: &[Condition]) -> Option<Solution> {
    let [constant, linear, quadratic] = coefficients(pool, polynomial, part)?;
    let is_parametrisation = matches!(pool.node(part), Node::Symbol(_));
    let zero = pool.integer(0);
    let leading = if pool.is_zero(quadratic) { linear } else { quadratic };
    if pool.is_zero(leading) {
        return None;
    }
    let values = if leading == linear {
        // c + b v = 0
        let opposite = pool.negate(constant);
        vec![(pool.divide(opposite, linear), Vec::new())]
    } else {
        // c + b v + a v² = 0: v = (−b ± √(b² − 4 a c))/(2 a)
        let (square, product) = (pool.power(linear, 2.into()), pool.multiply(quadratic, constant));
        let four = pool.integer(4);
        let product = pool.multiply(four, product);
        let discriminant = pool.subtract(square, product);
        let (root, two) = (pool.sqrt(discriminant), pool.integer(2));
        let (twice, opposite) = (pool.multiply(two, quadratic), pool.negate(linear));
        let real = Condition { left: discriminant, relation: Relation::GreaterEqual, right: zero };
        let other = pool.negate(root);
        [root, other]
            .map(|root| {
                let numerator = pool.add(opposite, root);
                (pool.divide(numerator, twice), vec![real])
            })
            .to_vec()
    };
    let is_complete = is_never_zero(pool, leading, known);
    Some(Solution { part, values, is_complete, is_parametrisation })
}

/// Whether an expression is a number other than zero, or one of the known conditions says that it
/// is not zero.
fn is_never_zero(pool: &Pool, expression: Expr, known: &[Condition]) -> bool {
    let says_so = |condition: &Condition| {
        let is_strict = !matches!(condition.relation, Relation::LessEqual | Relation::GreaterEqual);
        let sides = [(condition.left, condition.right), (condition.right, condition.left)];
        is_strict && sides.iter().any(|&(side, other)| side == expression && pool.is_zero(other))
    };
    match pool.node(expression) {
        Node::Number(value) => !value.is_zero(),
        Node::Pi => true,
        _ => known.iter().any(says_so),
    }
}

/// Returns the coefficients of 1, v and v² in an expression that is a polynomial in v of degree at
/// most two.
fn coefficients(pool: &mut Pool, polynomial: Expr, v: Expr) -> Option<[Expr; 3]> {
    let zero = pool.integer(0);
    let one = pool.integer(1);
    let mut known: FxHashMap<Expr, Option<[Expr; 3]>> = FxHashMap::default();
    for part in pool.reachable(&[polynomial]) {
        let found = coefficients_of_part(pool, part, v, &known, [zero, one]);
        known.insert(part, found);
    }
    known[&polynomial]
}

fn coefficients_of_part(
    pool: &mut Pool,
    part: Expr,
    v: Expr,
    known: &FxHashMap<Expr, Option<[Expr; 3]>>,
    [zero, one]: [Expr; 2],
) -> Option<[Expr; 3]> {
    if part == v {
        return Some([zero, one, zero]);
    }
    let node = pool.node(part).clone();
    let is_constant = |a: Expr| known[&a].is_some_and(|[_, b, c]| b == zero && c == zero);
    if node.operands().into_iter().all(is_constant) {
        return Some([part, zero, zero]);
    }
    match node {
        Node::Add(a, b) => {
            let (a, b) = (known[&a]?, known[&b]?);
            Some([0, 1, 2].map(|power| pool.add(a[power], b[power])))
        }
        Node::Negate(a) => Some(known[&a]?.map(|coefficient| pool.negate(coefficient))),
        Node::Multiply(a, b) => product(pool, known[&a]?, known[&b]?),
        Node::Divide(a, b) if is_constant(b) => {
            Some(known[&a]?.map(|coefficient| pool.divide(coefficient, b)))
        }
        Node::Power(a, exponent) if exponent.is_integer() && *exponent.numer() == 2 => {
            product(pool, known[&a]?, known[&a]?)
        }
        _ => None,
    }
}

/// (a₀ + a₁ v + a₂ v²)(b₀ + b₁ v + b₂ v²), if its degree is at most two.
fn product(pool: &mut Pool, a: [Expr; 3], b: [Expr; 3]) -> Option<[Expr; 3]> {
    let mut sums = [pool.integer(0); 5];
    for (i, &left) in a.iter().enumerate() {
        for (j, &right) in b.iter().enumerate() {
            let product = pool.multiply(left, right);
            sums[i + j] = pool.add(sums[i + j], product);
        }
    }
    let [constant, linear, quadratic, rest @ ..] = sums;
    rest.iter().all(|&coefficient| pool.is_zero(coefficient)).then_some([constant, linear, quadratic])
}

/// Substitutes a value for a part in expressions and conditions.
pub(super) fn replaced(
    pool: &mut Pool,
    (part, value): (Expr, Expr),
    expressions: &[Expr],
    conditions: &[Condition],
) -> (Vec<Expr>, Vec<Condition>) {
    let mut all = expressions.to_vec();
    all.extend(conditions.iter().flat_map(|condition| [condition.left, condition.right]));
    let node = pool.node(part).clone();
    let mut images = pool.replace_all(&all, |found, _| (*found == node).then_some(value));
    let sides = images.split_off(expressions.len());
    let conditions = conditions.iter().zip(sides.chunks_exact(2));
    let conditions =
        conditions.map(|(condition, side)| Condition { left: side[0], right: side[1], ..*condition });
    (images, conditions.collect())
}
