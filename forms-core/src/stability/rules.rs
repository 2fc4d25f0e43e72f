//! Rewriting rules for expressions.
//!
//! A rule inspects one operation and proposes expressions that are equal to it where both are
//! defined, with rare exceptions. A rule need not be correct, since every form that is kept is
//! proved.

mod direct;
mod exponential;
mod factors;
mod fractions;
mod lagrange;
mod radical;
mod scaling;
mod sums;
mod trigonometric;

pub(crate) use direct::by_rules;

use crate::approximation::about_singularities;
use crate::decide::{contradiction, simplified_where};
use crate::expression::{Condition, Expr, Node, Operation, Pool, Rational};
use num_rational::Ratio;
use num_traits::Signed;
use rustc_hash::FxHashMap;

/// Version number of the rules and the search; incremented with every change, so that existing
/// choices are made again.
pub(super) const VERSION: u32 = 5;

/// Maximum length of a text that is simplified: nobody would read a longer result, and a kernel
/// should not compute it.
const LONGEST: usize = 600;

/// Context of the rules: the pool, the assumptions, and a cache of simplified expressions.
pub(super) struct Rewriting<'a> {
    pub(super) pool: &'a mut Pool,
    conditions: &'a [Condition],
    simple: FxHashMap<Expr, Expr>,
}

/// Largest relative error of an approximation: a tenth of the rounding error of a value.
pub(super) fn tolerance() -> Rational {
    Rational::new(1.into(), 100_000_000_000_000_000_i64.into())
}

/// Rewriting rule: returns the possible replacements of an expression.
type Rule = fn(&mut Rewriting<'_>, Expr) -> Vec<Expr>;

/// All rules, in the order in which they are tried.
const RULES: &[Rule] = &[
    simplification,
    sums::factored,
    sums::regrouped,
    sums::shared_function,
    lagrange::identity,
    radical::conjugate,
    radical::beside_its_root,
    radical::rationalised,
    radical::of_quotients_and_products,
    fractions::over_one_denominator,
    fractions::without_a_common_factor,
    fractions::term_by_term,
    fractions::reordered,
    fractions::power_of_a_quotient,
    exponential::less_one,
    exponential::difference,
    exponential::hyperbolic,
    exponential::hyperbolic_tangent,
    exponential::over_less_one,
    exponential::reciprocal,
    exponential::near_one,
    exponential::logarithms,
    exponential::logarithm_of_a_sum,
    exponential::complementary_error_function,
    trigonometric::versine,
    trigonometric::differences,
    trigonometric::of_a_sum,
    trigonometric::half_angle,
    trigonometric::arc_tangents,
    trigonometric::from_the_other_leg,
    lagrange::angle,
    scaling::hypotenuse,
    scaling::scaled_root,
    scaling::beside_a_square,
];

impl<'a> Rewriting<'a> {
    pub(super) fn new(pool: &'a mut Pool, conditions: &'a [Condition]) -> Self {
        Rewriting { pool, conditions, simple: FxHashMap::default() }
    }

    /// Returns all replacements that the rules propose for an expression, without duplicates and
    /// without the expression itself.
    pub(super) fn alternatives(&mut self, expression: Expr) -> Vec<Expr> {
        let mut found: Vec<Expr> = Vec::new();
        for rule in RULES {
            for proposed in rule(self, expression) {
                if proposed != expression && !found.contains(&proposed) {
                    found.push(proposed);
                }
            }
        }
        found
    }

    /// Returns replacements that are proved to be close to an expression, but not equal to it:
    /// series near removable singularities, as `if abs(x) < 1 { 1/6 - x**2/120 + … } else { … }`.
    pub(super) fn approximations(&mut self, expression: Expr) -> Vec<Expr> {
        about_singularities(self.pool, expression, &tolerance())
    }

    /// Returns the normal form of the expression if it is shorter, otherwise the expression.
    pub(super) fn simplified(&mut self, expression: Expr) -> Expr {
        if let Some(&known) = self.simple.get(&expression) {
            return known;
        }
        let mut simple = expression;
        if let Some(before) = self.short_text(expression) {
            let proposed = simplified_where(self.pool, self.conditions, expression);
            if self.short_text(proposed).is_some_and(|after| after < before) {
                simple = proposed;
            }
        }
        self.simple.insert(expression, simple);
        simple
    }

    /// Returns the length of an expression's text, unless it is too long. No text is made of an
    /// expression with more nodes than the maximum number of characters: with shared subexpressions
    /// it could be exponentially long.
    fn short_text(&self, expression: Expr) -> Option<usize> {
        let may_be = is_short(self.pool, expression, LONGEST);
        may_be.then(|| self.pool.text(expression).len()).filter(|&length| length <= LONGEST)
    }

    /// Returns a − b, simplified.
    pub(super) fn difference(&mut self, a: Expr, b: Expr) -> Expr {
        let difference = self.pool.subtract(a, b);
        self.simplified(difference)
    }

    /// Returns a + b, simplified.
    pub(super) fn sum(&mut self, a: Expr, b: Expr) -> Expr {
        let sum = self.pool.add(a, b);
        self.simplified(sum)
    }

    /// Returns a² as a product.
    pub(super) fn square(&mut self, a: Expr) -> Expr {
        self.pool.multiply(a, a)
    }

    /// Returns |a|, or a where it is known not to be negative.
    pub(super) fn size(&mut self, a: Expr) -> Expr {
        let size = self.pool.apply(Operation::Abs, &[a]);
        self.simplified(size)
    }

    /// Returns a/2, with a unchanged except for its numeric factor: over a common denominator it
    /// could overflow.
    pub(super) fn half(&mut self, a: Expr) -> Expr {
        let two = self.pool.integer(2);
        let (number, rest) = self.scaled(a);
        let number = self.pool.divide(number, two);
        let number = self.simplified(number);
        let Some(value) = self.pool.as_number(number).cloned() else {
            return self.pool.multiply(number, rest);
        };
        let [above, below] = [value.numer().abs(), value.denom().clone()].map(Rational::from_integer);
        let (above, below) = (self.pool.number(above), self.pool.number(below));
        let half = self.pool.multiply(above, rest);
        let half = self.pool.divide(half, below);
        if value.is_negative() { self.pool.negate(half) } else { half }
    }

    /// Returns c a for an integer c.
    pub(super) fn times(&mut self, factor: i64, a: Expr) -> Expr {
        let factor = self.pool.integer(factor);
        self.pool.multiply(factor, a)
    }

    /// Returns the first argument of an expression that applies this operation.
    pub(super) fn argument_of(&self, operation: Operation, expression: Expr) -> Option<Expr> {
        match self.pool.node(expression) {
            Node::Apply(known, arguments) if *known == operation => Some(arguments[0]),
            _ => None,
        }
    }

    /// Returns q for an expression √q.
    pub(super) fn radicand(&self, expression: Expr) -> Option<Expr> {
        match self.pool.node(expression) {
            Node::Power(base, exponent) if *exponent == Ratio::new(1, 2) => Some(*base),
            _ => None,
        }
    }

    /// Returns a for an expression a², written as a power or as a product.
    pub(super) fn squared(&self, expression: Expr) -> Option<Expr> {
        match self.pool.node(expression) {
            Node::Power(base, exponent) if *exponent == Ratio::from_integer(2) => Some(*base),
            Node::Multiply(a, b) if a == b => Some(*a),
            _ => None,
        }
    }

    /// Returns the two operands of a sum a + b; a sign in front of b belongs to b.
    pub(super) fn two_terms(&mut self, expression: Expr) -> Option<(Expr, Expr)> {
        let Node::Add(a, b) = *self.pool.node(expression) else { return None };
        Some((a, b))
    }

    /// Returns the summands of a sum with their signs; empty if the expression is not a sum.
    pub(super) fn terms(&mut self, expression: Expr) -> Vec<Expr> {
        if !matches!(self.pool.node(expression), Node::Add(..)) {
            return Vec::new();
        }
        let summands = self.pool.summands(expression);
        summands
            .into_iter()
            .map(|(term, negative)| if negative { self.pool.negate(term) } else { term })
            .collect()
    }

    /// Adds terms from the first to the last.
    pub(super) fn total(&mut self, terms: &[Expr]) -> Expr {
        let mut sum = self.pool.integer(0);
        for &term in terms {
            sum = self.pool.add(sum, term);
        }
        sum
    }

    /// Whether a condition is proved to hold nowhere in the domain.
    pub(super) fn excludes(&mut self, condition: Condition) -> bool {
        let all: Vec<Condition> = self.conditions.iter().copied().chain([condition]).collect();
        contradiction(self.pool, &all).is_some()
    }

    /// Whether the expression contains a variable.
    pub(super) fn varies(&self, expression: Expr) -> bool {
        !self.pool.symbols_in(&[expression]).is_empty()
    }

    /// Splits an expression c q into its numeric factor c, including the sign, and the remaining
    /// factor q.
    pub(super) fn scaled(&mut self, expression: Expr) -> (Expr, Expr) {
        let (above, below, negative) = factors::factors(self.pool, expression);
        let is_number = |pool: &Pool, factor: &Expr| pool.symbols_in(&[*factor]).is_empty();
        let split = |pool: &Pool, list: Vec<Expr>| -> (Vec<Expr>, Vec<Expr>) {
            list.into_iter().partition(|factor| is_number(pool, factor))
        };
        let (numbers_above, above) = split(self.pool, above);
        let (numbers_below, below) = split(self.pool, below);
        let number = factors::quotient(self.pool, &numbers_above, &numbers_below);
        let number = if negative { self.pool.negate(number) } else { number };
        (number, factors::quotient(self.pool, &above, &below))
    }
}

/// Whether an expression is written with at most `most` operations, variables and numbers; shared
/// ones are counted at each occurrence.
fn is_short(pool: &Pool, expression: Expr, most: usize) -> bool {
    let (mut open, mut count) = (vec![expression], 0);
    while let Some(part) = open.pop() {
        count += 1;
        if count > most {
            return false;
        }
        pool.node(part).for_each_operand(|operand| open.push(operand));
    }
    true
}

/// Proposes the normal form if it is shorter: common factors cancel, and terms hidden by
/// cancellation appear.
fn simplification(rewriting: &mut Rewriting<'_>, expression: Expr) -> Vec<Expr> {
    match rewriting.pool.node(expression) {
        Node::Add(..) | Node::Divide(..) | Node::Multiply(..) => vec![rewriting.simplified(expression)],
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;

    /// Returns the proposals of the rules for a formula, as texts.
    fn proposed(formula: &str) -> Vec<String> {
        let (mut theory, errors) = read_theory(&format!("kernel k(a, b, x) = {formula} where a > 0, b > 0;"));
        assert!(errors.is_empty(), "{errors:?}");
        let kernel = theory.kernels[0].clone();
        let found = Rewriting::new(&mut theory.pool, &kernel.domain).alternatives(kernel.outputs[0]);
        theory.pool.texts(&found)
    }

    #[test]
    fn each_rule_proposes_the_form_it_is_named_for() {
        for (formula, expected) in [
            ("sqrt(a + 1) - sqrt(a)", "1/(sqrt(a + 1) + sqrt(a))"),
            ("1/(a + 1) - 1/a", "-1/((a + 1)*a)"),
            ("a**2 - b**2", "(a - b)*(a + b)"),
            ("x*a - x*b", "x*(a - b)"),
            ("exp(x) - 1", "expm1(x)"),
            ("3*exp(x) - 3", "3*expm1(x)"),
            ("exp(a) - exp(b)", "exp(b)*expm1(a - b)"),
            ("exp(x) - 2 + exp(-x)", "4*(sinh(x/2)*sinh(x/2))"),
            ("exp(x) - exp(-x)", "2*sinh(x)"),
            ("exp(x)/expm1(x)", "-1/expm1(-x)"),
            ("log(1 + x)", "log1p(x)"),
            ("log(a) - log(b)", "log1p((a - b)/b)"),
            ("1 - cos(x)", "2*(sin(x/2)*sin(x/2))"),
            ("cos(a) - cos(b)", "-2*(sin((a - b)/2)*sin((a + b)/2))"),
            ("(1 - cos(x))/sin(x)", "tan(x/2)"),
            ("atan(a) - atan(b)", "atan2(a - b, 1 + a*b)"),
            ("sin(a + b)", "sin(a)*cos(b) + cos(a)*sin(b)"),
            ("acos(x)", "atan2(sqrt((1 - x)*(1 + x)), x)"),
            ("acos(x)", "2*atan2(sqrt(1 - x), sqrt(1 + x))"),
            ("sin(x)**2/x**2", "(sin(x)/x)**2"),
            ("sqrt(a**2 + x**2)", "a*sqrt(1 + x/a*(x/a))"),
            ("(x - sin(x))/x**3", "(1 - sin(x)/x)/x**2"),
            ("1 - (1 - x*a)**2", "x*a*(1 + (1 - x*a))"),
            ("sqrt(a**2 + b**2 + x**2)", "hypot(hypot(a, b), x)"),
            ("sqrt((1 - b)*a**2 + b*x**2)", "hypot(sqrt(1 - b)*a, sqrt(b)*x)"),
            ("log(exp(a) + exp(x))", "(a + x + abs(a - x))/2 + log1p(exp(-abs(a - x)))"),
            ("log1p(exp(x))", "(x + abs(x))/2 + log1p(exp(-abs(x)))"),
            ("hypot(a, x) - a", "x**2/(hypot(a, x) + a)"),
            ("2*sinh(x/a)/(2*cosh(x/a))", "tanh(x/a)"),
            ("1 + erf(x/a)", "erfc(-x/a)"),
        ] {
            let found = proposed(formula);
            assert!(found.iter().any(|text| text == expected), "{formula}: {found:#?}");
        }
    }
}
