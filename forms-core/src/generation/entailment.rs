//! Entailment: whether conditions hold wherever others do, by signs that are evident from the form
//! of an expression, or else by a contradiction with the opposite condition.
//!
//! ```text
//! e > 0 ─┬─ by the signs of its parts: sums of non-negative terms, products, powers, monotone functions
//!        └─ known conditions and e ≤ 0 contradict each other
//! ```
//! Every step concerns a single point at which the expression is defined, so it is valid on domains
//! of any shape.

use super::limit::holds;
use super::sign::{Sign, Terms, factors_not_zero, increases_through_zero, is_odd_and_increasing, terms_of};
use crate::assume::vanishes;
use crate::expression::{Condition, Expr, Nature, Node, Operation, Pool, Relation};
use num_traits::{Signed, Zero};
use rustc_hash::FxHashMap;

/// Largest depth of nested subexpressions whose signs are examined.
const DEEPEST: usize = 12;

/// Largest number of conditions that an expression is compared with by normal forms.
const MOST_COMPARED: usize = 12;

/// Largest number of contradictions that are searched for; each takes a proof of its own.
const MOST_CONTRADICTIONS: usize = 48;

/// Known conditions, and the consequences found so far.
pub(super) struct Known<'a> {
    pool: &'a mut Pool,
    conditions: Vec<Condition>,
    /// Each condition as a relation of a difference to zero.
    differences: Vec<(Terms, Relation)>,
    found: FxHashMap<(Expr, Sign), bool>,
    contradictions: usize,
}

/// Returns q ≠ 0 for every condition √q ≠ 0.
fn radicands_not_zero(pool: &Pool, conditions: &[Condition]) -> Vec<Condition> {
    let radicand = |condition: &Condition| match *pool.node(condition.left) {
        Node::Power(left, exponent) if exponent.is_positive() && pool.is_zero(condition.right) => {
            Some(Condition { left, ..*condition })
        }
        _ => None,
    };
    conditions
        .iter()
        .filter(|condition| condition.relation == Relation::NotEqual)
        .filter_map(radicand)
        .collect()
}

impl<'a> Known<'a> {
    pub(super) fn new(pool: &'a mut Pool, mut conditions: Vec<Condition>) -> Self {
        conditions.extend(radicands_not_zero(pool, &conditions));
        let mut difference = |c: &Condition| {
            let difference = pool.subtract(c.left, c.right);
            (terms_of(pool, difference, false), c.relation)
        };
        let mut differences: Vec<(Terms, Relation)> = conditions.iter().map(&mut difference).collect();
        for part in factors_not_zero(pool, &conditions) {
            differences.push((terms_of(pool, part, false), Relation::NotEqual));
        }
        Known { pool, conditions, differences, found: FxHashMap::default(), contradictions: 0 }
    }

    /// Whether at least one of the alternatives is shown to hold wherever the known conditions
    /// hold.
    pub(super) fn imply_one(&mut self, ways: &[Vec<Condition>]) -> bool {
        let by_signs = |known: &mut Self, way: &Vec<Condition>| way.iter().all(|c| known.by_signs(c));
        ways.iter().any(|way| by_signs(self, way))
            || ways.iter().any(|way| way.iter().all(|c| self.by_signs(c) || self.by_contradiction(c)))
    }

    fn by_signs(&mut self, condition: &Condition) -> bool {
        let (left, right) = (condition.left, condition.right);
        let (left, right, sign) = match condition.relation {
            Relation::Greater => (left, right, Sign::Positive),
            Relation::GreaterEqual => (left, right, Sign::NotNegative),
            Relation::Less => (right, left, Sign::Positive),
            Relation::LessEqual => (right, left, Sign::NotNegative),
            Relation::NotEqual => (left, right, Sign::NotZero),
        };
        let difference = self.pool.subtract(left, right);
        self.has(difference, sign, DEEPEST)
    }

    fn by_contradiction(&mut self, condition: &Condition) -> bool {
        if self.contradictions >= MOST_CONTRADICTIONS {
            return false;
        }
        self.contradictions += 1;
        let is_inequation = condition.relation == Relation::NotEqual && self.pool.is_zero(condition.right);
        if is_inequation && self.is_stated_otherwise(condition.left) {
            return true;
        }
        if holds(self.pool, condition, &self.conditions) {
            return true;
        }
        // a product is non-zero where all its factors are
        if !is_inequation {
            return false;
        }
        let zero = self.pool.integer(0);
        let factors = self.pool.factors_that_may_vanish(condition.left);
        factors.len() > 1
            && factors.into_iter().all(|left| {
                let factor = Condition { left, relation: Relation::NotEqual, right: zero };
                self.by_signs(&factor) || holds(self.pool, &factor, &self.conditions)
            })
    }

    fn has(&mut self, part: Expr, sign: Sign, depth: usize) -> bool {
        if depth == 0 {
            return false;
        }
        if let Some(&known) = self.found.get(&(part, sign)) {
            return known;
        }
        let found = self.is_stated(part, sign) || self.is_seen(part, sign, depth - 1);
        self.found.insert((part, sign), found);
        found
    }

    /// Whether a condition states in another form that the expression is non-zero: exp q − 1 ≠ 0
    /// for expm1 q, (a² + b²)(c² + d²) ≠ 0 for (ac + bd)² + (ad − bc)².
    fn is_stated_otherwise(&mut self, part: Expr) -> bool {
        let not_zero: Vec<Condition> =
            self.conditions.iter().filter(|c| Sign::NotZero.follows_from(c.relation)).copied().collect();
        not_zero.into_iter().take(MOST_COMPARED).any(|condition| {
            let known = self.pool.subtract(condition.left, condition.right);
            let (difference, sum) = (self.pool.subtract(known, part), self.pool.add(known, part));
            vanishes(self.pool, difference) || vanishes(self.pool, sum)
        })
    }

    /// Whether a condition states this sign of the expression, directly or for its negative.
    fn is_stated(&mut self, part: Expr, sign: Sign) -> bool {
        let [own, opposite] = [false, true].map(|negative| terms_of(self.pool, part, negative));
        self.differences.iter().any(|(difference, relation)| {
            *difference == own && sign.follows_from(*relation)
                || *difference == opposite && sign.follows_from(relation.mirrored())
        })
    }

    fn is_seen(&mut self, part: Expr, sign: Sign, depth: usize) -> bool {
        let nature = self.pool.nature(part);
        if nature == Nature::Positive || nature == Nature::NotNegative && sign == Sign::NotNegative {
            return true;
        }
        let node = self.pool.node(part).clone();
        let seen = match node {
            Node::Number(value) => sign.relation().admits(value.cmp(&Zero::zero())),
            Node::Negate(a) if sign == Sign::NotZero => self.has(a, sign, depth),
            Node::Negate(a) => self.opposite(a, sign, depth),
            Node::Multiply(a, b) | Node::Divide(a, b) => self.product(a, b, sign, depth),
            // where the power is defined its base is non-zero
            Node::Power(_, r) if r.is_negative() && sign == Sign::NotZero => true,
            Node::Power(a, r) if sign == Sign::NotNegative && r.is_integer() => self.has(a, sign, depth),
            Node::Power(a, r) if !r.is_integer() || r.numer() % 2 == 0 => self.has(a, Sign::NotZero, depth),
            Node::Power(a, _) => self.has(a, sign, depth),
            Node::Add(..) => self.sum(part, sign, depth),
            Node::Apply(operation, q) => self.function(operation, &q, sign, depth),
            _ => false,
        };
        seen || sign != Sign::Positive && self.has(part, Sign::Positive, depth)
            || sign == Sign::NotZero && !matches!(self.pool.node(part), Node::Negate(_)) && {
                let opposite = self.pool.negate(part);
                self.has(opposite, Sign::Positive, depth)
            }
            || sign == Sign::Positive && self.is_not_negative_and_not_zero(part)
    }

    /// Whether −a > 0 or −a ≥ 0 is shown by moving the sign into a part of a.
    fn opposite(&mut self, a: Expr, sign: Sign, depth: usize) -> bool {
        match self.pool.node(a).clone() {
            Node::Add(..) => {
                let summands = self.pool.summands(a);
                let terms: Vec<Expr> = summands
                    .into_iter()
                    .map(|(term, negative)| if negative { term } else { self.pool.negate(term) })
                    .collect();
                self.terms(&terms, sign, depth)
            }
            Node::Multiply(p, q) | Node::Divide(p, q) => {
                let [minus_p, minus_q] = [p, q].map(|part| self.pool.negate(part));
                self.has(minus_p, sign, depth) && self.has(q, sign, depth)
                    || self.has(p, sign, depth) && self.has(minus_q, sign, depth)
            }
            Node::Power(base, r) if r.is_integer() && r.numer() % 2 != 0 => {
                let base = self.pool.negate(base);
                self.has(base, sign, depth)
            }
            Node::Apply(operation, q) if is_odd_and_increasing(operation) => {
                let argument = self.pool.negate(q[0]);
                self.has(argument, sign, depth)
            }
            _ => false,
        }
    }

    /// Whether q ≥ 0 is stated or evident, and q ≠ 0 is stated.
    fn is_not_negative_and_not_zero(&mut self, part: Expr) -> bool {
        let not_negative =
            self.is_stated(part, Sign::NotNegative) || self.pool.nature(part) == Nature::NotNegative;
        not_negative && self.is_stated(part, Sign::NotZero)
    }

    fn product(&mut self, a: Expr, b: Expr, sign: Sign, depth: usize) -> bool {
        if a == b {
            return sign == Sign::NotNegative || self.has(a, Sign::NotZero, depth);
        }
        if self.has(a, sign, depth) && self.has(b, sign, depth) {
            return true;
        }
        let (a, b) = (self.pool.negate(a), self.pool.negate(b));
        sign != Sign::NotZero && self.has(a, sign, depth) && self.has(b, sign, depth)
    }

    fn sum(&mut self, part: Expr, sign: Sign, depth: usize) -> bool {
        let summands = self.pool.summands(part);
        let terms: Vec<Expr> = summands
            .into_iter()
            .map(|(term, negative)| if negative { self.pool.negate(term) } else { term })
            .collect();
        sign != Sign::NotZero && self.terms(&terms, sign, depth)
    }

    /// Whether all terms of a sum are non-negative and, for a positive sum, at least one term is
    /// positive.
    fn terms(&mut self, terms: &[Expr], sign: Sign, depth: usize) -> bool {
        terms.iter().all(|&term| self.has(term, Sign::NotNegative, depth))
            && (sign == Sign::NotNegative || terms.iter().any(|&term| self.has(term, Sign::Positive, depth)))
    }

    fn function(&mut self, operation: Operation, q: &[Expr], sign: Sign, depth: usize) -> bool {
        match operation {
            Operation::Exp | Operation::Cosh | Operation::Erfc => true,
            Operation::Hypot => {
                sign == Sign::NotNegative || q.iter().any(|&side| self.has(side, Sign::NotZero, depth))
            }
            Operation::Abs => sign == Sign::NotNegative || self.has(q[0], Sign::NotZero, depth),
            Operation::Acos => sign == Sign::NotNegative,
            Operation::Sin | Operation::Cos => {
                self.within_half_a_turn(operation, q[0], sign)
                    || sign == Sign::NotZero && self.half_angle(operation, q[0])
            }
            _ if increases_through_zero(operation) => {
                self.has(q[0], sign, depth)
                    || sign == Sign::NotZero && {
                        let part = self.pool.apply(operation, q);
                        self.is_stated_otherwise(part)
                    }
            }
            _ => false,
        }
    }
}

impl Known<'_> {
    /// Whether sin q is not negative by 0 ≤ q ≤ π, or cos q by −π/2 ≤ q ≤ π/2; positive with < for ≤.
    fn within_half_a_turn(&mut self, operation: Operation, q: Expr, sign: Sign) -> bool {
        if sign == Sign::NotZero {
            return false; // shown by the positive sign
        }
        let (zero, pi, two) = (self.pool.integer(0), self.pool.pi(), self.pool.integer(2));
        let half = self.pool.divide(pi, two);
        let (low, high) =
            if operation == Operation::Sin { (zero, pi) } else { (self.pool.negate(half), half) };
        let relation = sign.relation();
        let bounds = [(q, low), (high, q)].map(|(left, right)| Condition { left, relation, right });
        bounds.iter().all(|bound| self.by_signs(bound) || self.by_contradiction(bound))
    }

    /// Whether sin q or cos q is non-zero by a condition that sin 2q = 2 sin q cos q is non-zero,
    /// or 1 ∓ cos 2q, which is 2 sin² q or 2 cos² q.
    fn half_angle(&mut self, operation: Operation, q: Expr) -> bool {
        let pool = &mut *self.pool;
        let [sine, cosine] = [Operation::Sin, Operation::Cos].map(|wave| pool.apply(wave, &[q]));
        let own = if operation == Operation::Sin { sine } else { cosine };
        let two = pool.integer(2);
        let products = [(sine, cosine), (own, own)].map(|(a, b)| {
            let product = pool.multiply(a, b);
            pool.multiply(two, product)
        });
        let stated: Vec<Condition> =
            self.conditions.iter().filter(|c| Sign::NotZero.follows_from(c.relation)).copied().collect();
        stated.into_iter().any(|condition| {
            let known = self.pool.subtract(condition.left, condition.right);
            products.iter().any(|&product| {
                let (difference, sum) = (self.pool.subtract(known, product), self.pool.add(known, product));
                vanishes(self.pool, difference) || vanishes(self.pool, sum)
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;

    /// Whether signs alone prove `claim` under the conditions.
    fn shown(claim: &str, conditions: &str) -> bool {
        let (mut theory, errors) = read_theory(&format!("kernel k(x, y) = 0 where {claim}, {conditions};"));
        assert!(errors.is_empty(), "{errors:?}");
        let mut domain = theory.kernels[0].domain.clone();
        let claim = domain.remove(0);
        Known::new(&mut theory.pool, domain).by_signs(&claim)
    }

    #[test]
    fn signs_of_parts_show_signs_of_the_whole() {
        for (claim, conditions) in [
            ("sqrt(x + 1) + sqrt(x) > 0", "x >= 0"),
            ("(x + 1)*x != 0", "x + 1 != 0, x != 0"),
            ("1 + x**2 > 0", "y > 0"),
            ("x**2 + y**2 > 0", "x != 0, y >= 0"),
            ("expm1(x*y) > 0", "x > 0, y > 0"),
            ("x*y > 0", "x < 0, y < 0"),
            ("abs(x) > 0", "x != 0, y > 0"),
            ("-x - y != 0", "x > 0, y >= 0"),
            ("x/y >= 0", "x >= 0, y > 0"),
            ("x > 0", "x >= 0, x != 0"),
            ("cos(x/2) != 0", "sin(x) != 0, y > 0"),
            ("expm1(x*y) != 0", "exp(x*y) - 1 != 0, y > 0"),
            ("expm1(-x) != 0", "exp(x) - 1 != 0, y > 0"),
            ("x*y != 0", "1 - exp(x) != 0, y > 0"),
            ("x != 0", "x**2*y != 0, y > 0"),
            ("x/y > 0", "x*y**2 > 0, x >= 0, y >= 0"),
            ("cos(x) != 0", "1 + cos(2*x) != 0, y > 0"),
            ("cos(x) >= 0", "x >= -pi/2, x <= pi/2"),
            ("cos(x)*cos(y) > 0", "x > -pi/2, x < pi/2, abs(y) < 1"),
            ("sin(x/2) >= 0", "x >= 0, x <= 2*pi"),
            ("sin(x) > 0", "x > 0, x <= 3"),
        ] {
            assert!(shown(claim, conditions), "{claim} where {conditions}");
        }
    }

    #[test]
    fn signs_that_some_point_breaks_are_not_shown() {
        for (claim, conditions) in [
            ("sqrt(x + y) + sqrt(x) > 0", "x >= 0, y >= 0"),
            ("x**2 + y**2 > 0", "x >= 0, y >= 0"),
            ("x*y != 0", "x != 0, y >= 0"),
            ("x*y > 0", "x < 0, y > 0"),
            ("x - y != 0", "x > 0, y > 0"),
            ("x**3 >= 0", "x != 0, y > 0"),
            ("abs(x) > 0", "x >= 0, y > 0"),
            ("acos(x) > 0", "x >= 0, y > 0"),
            ("sin(x) >= 0", "x >= 0, y > 0"),
            ("x + y != 0", "x != 0, y != 0"),
            ("x**(-1) > 0", "x != 0, y > 0"),
            ("cos(x) != 0", "sin(x) != 0, y > 0"),
            ("cos(x) != 0", "1 - cos(2*x) != 0, y > 0"),
            ("x != 0", "exp(x) + 1 != 0, y > 0"),
            ("x != 0", "exp(x) - 2 != 0, y > 0"),
            ("x != 0", "-exp(x) - 1 != 0, y > 0"),
            ("cos(x) > 0", "x >= -pi/2, x <= pi/2"),
            ("cos(x) >= 0", "x >= -pi/2, x <= 1.571"),
            ("cos(x) >= 0", "x >= 0, x <= pi"),
            ("sin(x) >= 0", "x >= 0, x <= 3.1416"),
            ("sin(x) > 0", "x >= 0, x <= 3"),
            ("cos(2*x) >= 0", "x >= -pi/2, x <= pi/2"),
        ] {
            assert!(!shown(claim, conditions), "{claim} where {conditions}");
        }
    }
}
