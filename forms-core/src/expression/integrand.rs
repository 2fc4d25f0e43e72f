//! Integrands of primitives: splits a product into jets and a remaining factor, and puts its
//! variables and jets into a canonical order.
//!
//! ```text
//! product ─ gather ─▶ jets at variables and parameters · remaining factor ─ least order of the variables ─▶ primitive
//! ```

use super::integral_table::{Factor, Place, Primitive};
use super::node::{Expr, FunctionId, Node, Rational, Symbol};
use super::pool::Pool;
use super::substitution::Substitution;
use num_traits::{One, Zero};
use std::collections::BTreeMap;

/// Powers with at least this absolute exponent stay as they are written.
const HIGHEST_POWER: i64 = 64;

/// Largest number of integration variables that are reordered; more are kept in the order of
/// integration.
const MOST_REORDERED: usize = 4;

/// Largest number of summands that a product of sums is expanded into; a larger product is
/// integrated as it is.
const MOST_SUMMANDS: usize = 64;

/// Jet of an integrand under construction: its arguments, each with its order of differentiation.
struct Jet {
    function: FunctionId,
    arguments: Vec<(Expr, u32)>,
}

/// Integrand under construction, with its integration variables and their upper limits.
struct Integrand {
    jets: Vec<Jet>,
    elementary: Expr,
    integrated: Vec<(Symbol, Expr)>,
}

/// Jet with its integration variables numbered: the factor, then its parameters with their orders
/// of differentiation.
type Numbered = (Factor, Vec<(Expr, u32)>);

/// Integrand with its integration variables numbered: jets, the remaining factor and its parameters,
/// the upper limits.
type Candidate = (Vec<Numbered>, Expr, Vec<Symbol>, Vec<Expr>);

impl Pool {
    /// Integrates a product over some variables up to their upper limits: ∫ Σ cᵢ pᵢ = Σ cᵢ ∫ pᵢ
    /// with numbers cᵢ.
    pub(super) fn primitive_over(&mut self, product: Expr, integrated: Vec<(Symbol, Expr)>) -> Expr {
        let (mut sum, one) = (self.integer(0), self.integer(1));
        for summand in self.distributed(product) {
            let mut integrand = Integrand { jets: vec![], elementary: one, integrated: integrated.clone() };
            self.gather(&mut integrand, summand);
            let (number, elementary) = self.content(integrand.elementary);
            let (number, value) =
                (self.number(number), self.completed(Integrand { elementary, ..integrand }));
            let term = self.multiply(number, value);
            sum = self.add(sum, term);
        }
        sum
    }

    /// Expands a product of sums into its summands, unless there are more than `MOST_SUMMANDS`.
    fn distributed(&mut self, product: Expr) -> Vec<Expr> {
        let mut found = Vec::new();
        for (part, negative) in self.summands(product) {
            let parts: Vec<Expr> = match *self.node(part) {
                Node::Divide(a, b) => self.distributed(a).into_iter().map(|a| self.divide(a, b)).collect(),
                Node::Multiply(a, b) => {
                    let (left, right) = (self.distributed(a), self.distributed(b));
                    let pairs = left.iter().flat_map(|&a| right.iter().map(move |&b| (a, b)));
                    pairs.map(|(a, b)| self.multiply(a, b)).collect()
                }
                _ => vec![part],
            };
            found.extend(parts.into_iter().map(|part| if negative { self.negate(part) } else { part }));
        }
        if found.len() > MOST_SUMMANDS { vec![product] } else { found }
    }

    /// Returns the numeric coefficient of a product, and the remaining factor.
    pub(super) fn content(&mut self, product: Expr) -> (Rational, Expr) {
        match self.node(product).clone() {
            Node::Number(value) => (value, self.integer(1)),
            Node::Negate(a) => {
                let (number, rest) = self.content(a);
                (-number, rest)
            }
            Node::Multiply(a, b) => {
                let ((a, left), (b, right)) = (self.content(a), self.content(b));
                (a * b, self.multiply(left, right))
            }
            Node::Divide(a, b) => {
                let ((a, above), (b, below)) = (self.content(a), self.content(b));
                if b.is_zero() {
                    return (Rational::one(), product);
                }
                (a / b, self.divide(above, below))
            }
            _ => (Rational::one(), product),
        }
    }

    /// Splits a product into jets and a remaining factor. Each argument of these jets is a variable
    /// or contains none of the integration variables.
    fn gather(&mut self, integrand: &mut Integrand, product: Expr) {
        match self.node(product).clone() {
            Node::Multiply(a, b) => {
                self.gather(integrand, a);
                self.gather(integrand, b);
            }
            Node::Negate(a) => {
                integrand.elementary = self.negate(integrand.elementary);
                self.gather(integrand, a);
            }
            Node::Divide(a, b) => {
                self.gather(integrand, a);
                integrand.elementary = self.divide(integrand.elementary, b);
            }
            Node::Power(base, exponent)
                if exponent.is_integer()
                    && (1..=8).contains(exponent.numer())
                    && matches!(self.node(base), Node::Jet { .. } | Node::Multiply(..)) =>
            {
                (0..*exponent.numer()).for_each(|_| self.gather(integrand, base));
            }
            Node::Jet { function, orders, arguments } => {
                self.gather_jet(integrand, product, (function, &orders, &arguments));
            }
            _ => integrand.elementary = self.multiply(integrand.elementary, product),
        }
    }

    fn gather_jet(
        &mut self,
        integrand: &mut Integrand,
        written: Expr,
        (function, orders, arguments): (FunctionId, &[u32], &[Expr]),
    ) {
        let moves = |pool: &Pool, argument: Expr| {
            let symbols = pool.symbols_in(&[argument]);
            integrand.integrated.iter().any(|(symbol, _)| symbols.contains(symbol))
        };
        let is_variable = |pool: &Pool, argument: Expr| matches!(pool.node(argument), Node::Symbol(_));
        if arguments.iter().any(|&argument| moves(self, argument) && !is_variable(self, argument)) {
            integrand.elementary = self.multiply(integrand.elementary, written);
            return;
        }
        let inner = self.primitives.integrands.get(&function).cloned();
        if let Some(inner) = inner
            && !arguments[..inner.integrated].iter().any(|&end| moves(self, end))
        {
            self.gather_primitive(integrand, &inner, orders, arguments);
            return;
        }
        let arguments = arguments.iter().copied().zip(orders.iter().copied()).collect();
        integrand.jets.push(Jet { function, arguments });
    }

    /// Merges a primitive into the integrand that it is a factor of, ∫ g Φ = ∫∫ g φ: its integration
    /// variables join those of the integrand.
    fn gather_primitive(
        &mut self,
        integrand: &mut Integrand,
        inner: &Primitive,
        orders: &[u32],
        arguments: &[Expr],
    ) {
        let mut places = arguments.to_vec();
        let mut candidate = 0;
        for (number, &end) in arguments[..inner.integrated].iter().enumerate() {
            let mut variable = self.inner_variable(candidate);
            while integrand.integrated.iter().any(|(taken, _)| *taken == variable) {
                candidate += 1;
                variable = self.inner_variable(candidate);
            }
            integrand.integrated.push((variable, end));
            places[number] = self.symbol(variable);
        }
        let product = self.value_of_integrand(inner, orders, &places);
        self.gather(integrand, product);
    }

    /// Returns the primitive for the least order of variables and jets, at its arguments.
    fn completed(&mut self, integrand: Integrand) -> Expr {
        let count = integrand.integrated.len();
        let mut best: Option<Candidate> = None;
        for order in orders_of(count) {
            let candidate = self.numbered(&integrand, &order);
            if best.as_ref().is_none_or(|best| precedes(&candidate, best)) {
                best = Some(candidate);
            }
        }
        let Some((jets, elementary, symbols, ends)) = best else { return integrand.elementary };
        let (mut arguments, mut orders) = (ends, vec![0; count]);
        for (argument, order) in jets.iter().flat_map(|(_, parameters)| parameters) {
            arguments.push(*argument);
            orders.push(*order);
        }
        for symbol in symbols {
            arguments.push(self.symbol(symbol));
            orders.push(0);
        }
        let factors = jets.into_iter().map(|(factor, _)| factor).collect();
        let parameters = arguments.len() - count;
        let function =
            self.function_of_primitive(Primitive { factors, elementary, integrated: count, parameters });
        self.jet(function, &orders, &arguments)
    }

    /// Returns a product with its factors in the order of the pool and equal factors merged into
    /// powers.
    pub(super) fn with_factors_in_order(&mut self, product: Expr) -> Expr {
        let mut exponents: BTreeMap<Expr, i64> = BTreeMap::new();
        let mut open = vec![(product, 1)];
        while let Some((part, exponent)) = open.pop() {
            match *self.node(part) {
                Node::Multiply(a, b) => open.extend([(a, exponent), (b, exponent)]),
                Node::Divide(a, b) => open.extend([(a, exponent), (b, -exponent)]),
                Node::Power(a, power) if power.is_integer() && power.numer().abs() < HIGHEST_POWER => {
                    open.push((a, exponent * power.numer()));
                }
                _ => *exponents.entry(part).or_insert(0) += exponent,
            }
        }
        let mut ordered = self.integer(1);
        for (factor, exponent) in exponents {
            let power = self.power(factor, exponent.into());
            ordered = self.multiply(ordered, power);
        }
        ordered
    }

    /// Numbers the integration variables of an integrand in the given order and sorts its jets.
    fn numbered(&mut self, integrand: &Integrand, order: &[usize]) -> Candidate {
        let number_of = |pool: &Pool, argument: Expr| match pool.node(argument) {
            Node::Symbol(symbol) => order.iter().position(|&place| integrand.integrated[place].0 == *symbol),
            _ => None,
        };
        let mut jets: Vec<Numbered> = Vec::new();
        for jet in &integrand.jets {
            let (mut places, mut parameters) = (Vec::new(), Vec::new());
            for &(argument, derivatives) in &jet.arguments {
                match number_of(self, argument) {
                    Some(number) => places.push(Place::Integrated(number, derivatives)),
                    None => {
                        places.push(Place::Parameter);
                        parameters.push((argument, derivatives));
                    }
                }
            }
            jets.push((Factor { function: jet.function, places }, parameters));
        }
        jets.sort();
        let own = jets.iter().map(|(_, parameters)| parameters.len()).sum::<usize>();
        let mut values: Substitution = Substitution::default();
        let mut free = Vec::new();
        for symbol in self.symbols_in(&[integrand.elementary]) {
            let place = order.iter().position(|&place| integrand.integrated[place].0 == symbol);
            let formal = match place {
                Some(number) => self.formal_variable(number),
                None => {
                    free.push(symbol);
                    self.formal_parameter(own + free.len() - 1)
                }
            };
            values.insert(symbol, self.symbol(formal));
        }
        let elementary = self.substitute(integrand.elementary, &values);
        let elementary = self.with_factors_in_order(elementary);
        let ends = order.iter().map(|&place| integrand.integrated[place].1).collect();
        (jets, elementary, free, ends)
    }
}

/// Whether an integrand precedes another: by its jets, then its remaining factor, then the arguments it
/// is evaluated at.
fn precedes(a: &Candidate, b: &Candidate) -> bool {
    let shape = |candidate: &Candidate| -> Vec<Factor> {
        candidate.0.iter().map(|(factor, _)| factor.clone()).collect()
    };
    let places = |candidate: &Candidate| -> Vec<Vec<(Expr, u32)>> {
        candidate.0.iter().map(|(_, parameters)| parameters.clone()).collect()
    };
    (shape(a), a.1, &a.3, places(a)) < (shape(b), b.1, &b.3, places(b))
}

/// Returns all permutations of `count` variables, or only the identity above `MOST_REORDERED`.
fn orders_of(count: usize) -> Vec<Vec<usize>> {
    if count > MOST_REORDERED {
        return vec![(0..count).collect()];
    }
    let mut orders: Vec<Vec<usize>> = vec![vec![]];
    for place in 0..count {
        orders = orders
            .into_iter()
            .flat_map(|order| {
                (0..=order.len()).map(move |at| {
                    let mut longer = order.clone();
                    longer.insert(at, place);
                    longer
                })
            })
            .collect();
    }
    orders
}
