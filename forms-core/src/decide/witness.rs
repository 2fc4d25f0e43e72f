//! Search for points: candidates are exact, and conditions and sides are enclosed until they are
//! certain.

use super::problem::Problem;
use super::sample::{Bounds, Sequence, jet_value, simple_bounds};
use crate::enclosure::{Enclosure, Precision, Undecided, WordRange, enclose, word_ranges};
use crate::expression::{Expr, FunctionId, Node, Pool, Rational, Symbol};
use rustc_hash::FxHashMap;

/// Bits of numerator and denominator up to which an exact value is written in full.
const LONGEST_EXACT: u64 = 256;

/// Precisions of the enclosures in bits, tried in turn.
const PRECISIONS: [u32; 3] = [80, 256, 1024];

/// Result of evaluating a candidate point.
pub(super) enum Found {
    /// Some condition fails, a side is not defined, or nothing is certain.
    NoPoint,
    /// Everything holds and no difference is certain.
    Agrees,
    /// The sides of this component differ.
    Differs(Difference),
}

/// A counterexample.
pub(super) struct Difference {
    pub(super) component: usize,
    pub(super) point: Vec<(String, String)>,
    pub(super) left: String,
    pub(super) right: String,
}

/// Candidate points of one problem, in a fixed order.
pub(super) struct Search<'a> {
    pool: &'a Pool,
    problem: &'a Problem,
    symbols: Vec<Symbol>,
    bounds: FxHashMap<Symbol, Bounds>,
    jet_bounds: FxHashMap<FunctionId, Bounds>,
    round: u32,
}

impl<'a> Search<'a> {
    pub(super) fn new(pool: &'a Pool, problem: &'a Problem, from: u32) -> Self {
        let mut expressions: Vec<Expr> = problem.components.iter().flat_map(|c| [c.left, c.right]).collect();
        expressions.extend(problem.assumptions.iter().flat_map(|c| [c.left, c.right]));
        Search {
            pool,
            problem,
            symbols: pool.symbols_in(&expressions),
            bounds: simple_bounds(pool, &problem.assumptions),
            jet_bounds: jet_bounds(pool, problem),
            round: from,
        }
    }

    /// Returns the number of candidates before the next one.
    pub(super) fn position(&self) -> u32 {
        self.round
    }

    /// Returns the next candidate with its seed.
    fn candidate(&mut self) -> (FxHashMap<Symbol, Rational>, u64) {
        let seed = u64::from(self.round).wrapping_mul(0xa076_1d64_78bd_642f) + 1;
        let point = Sequence::new(seed).point(&self.symbols, &self.bounds, self.round);
        self.round += 1;
        (point, seed)
    }

    /// Whether one of the next candidates is certainly a point at which everything holds and is
    /// defined, and at which no difference is certain, according to machine words.
    pub(super) fn sees_agreement(&mut self, candidates: usize) -> bool {
        for _ in 0..candidates {
            let (point, _) = self.candidate();
            match self.glance(&point) {
                Ok(Some(agrees)) => return agrees,
                Ok(None) | Err(Undecided::Undefined) => {}
                Err(_) => return false,
            }
        }
        false
    }

    /// Whether the sides may agree at a point; `None` if some condition fails.
    fn glance(&self, point: &FxHashMap<Symbol, Rational>) -> Result<Option<bool>, Undecided> {
        let expressions = self.expressions();
        let values = word_ranges(self.pool, &expressions, |symbol| {
            point.get(&symbol).map_or(Err(Undecided::Unknown), WordRange::rational)
        })?;
        let (conditions, sides) = values.split_at(2 * self.problem.assumptions.len());
        for (condition, pair) in self.problem.assumptions.iter().zip(conditions.chunks(2)) {
            match pair[0].decide(condition.relation, pair[1]) {
                Some(true) => {}
                Some(false) => return Ok(None),
                None => return Err(Undecided::Unknown),
            }
        }
        Ok(Some(sides.chunks(2).all(|pair| pair[0].intersects(pair[1]))))
    }

    /// Returns both sides of every condition, then of every component.
    fn expressions(&self) -> Vec<Expr> {
        let conditions = self.problem.assumptions.iter().flat_map(|c| [c.left, c.right]);
        conditions.chain(self.problem.components.iter().flat_map(|c| [c.left, c.right])).collect()
    }

    /// Evaluates the next candidate. If there is only one candidate, all precisions are tried,
    /// since no other candidate can show a small difference.
    pub(super) fn next(&mut self) -> Found {
        let (point, seed) = self.candidate();
        let mut found = Found::NoPoint;
        for precision in PRECISIONS {
            match self.look(&point, seed, Precision(precision)) {
                Ok(Found::Agrees) if self.symbols.is_empty() => found = Found::Agrees,
                Ok(found) => return found,
                Err(Undecided::Undefined | Undecided::TooLarge) => return Found::NoPoint,
                Err(Undecided::Unknown) => {}
            }
        }
        found
    }

    /// Evaluates the conditions and sides at a point: `Unknown` asks for a higher precision.
    fn look(
        &self,
        point: &FxHashMap<Symbol, Rational>,
        seed: u64,
        precision: Precision,
    ) -> Result<Found, Undecided> {
        let mut jets =
            Jets { seed, round: self.round, bounds: &self.jet_bounds, known: Vec::new(), mixed: false };
        let (expressions, sides) = (self.expressions(), 2 * self.problem.assumptions.len());
        let values = enclose(
            self.pool,
            &expressions,
            &|symbol| point.get(&symbol).map(|value| Enclosure::exact(value, precision)),
            &mut |function, orders, arguments| jets.value(function, orders, arguments, precision),
            precision,
        );
        if jets.mixed {
            return Err(Undecided::Unknown);
        }
        let values = values.into_iter().collect::<Result<Vec<_>, _>>()?;
        for (condition, pair) in self.problem.assumptions.iter().zip(values[..sides].chunks(2)) {
            match pair[0].decide(condition.relation, &pair[1]) {
                Some(true) => {}
                Some(false) => return Ok(Found::NoPoint),
                None => return Err(Undecided::Unknown),
            }
        }
        for (number, pair) in values[sides..].chunks(2).enumerate() {
            if !pair[0].intersects(&pair[1]) {
                return Ok(Found::Differs(Difference {
                    component: number,
                    point: self.named(point, &jets),
                    left: value_text(&pair[0]),
                    right: value_text(&pair[1]),
                }));
            }
        }
        Ok(Found::Agrees)
    }

    /// Returns the point as names and exact values, with the values of unknown functions that were
    /// needed.
    fn named(&self, point: &FxHashMap<Symbol, Rational>, jets: &Jets) -> Vec<(String, String)> {
        let mut named: Vec<(String, String)> = self
            .symbols
            .iter()
            .map(|symbol| (self.pool.symbol_name(*symbol).to_string(), point[symbol].to_string()))
            .collect();
        for jet in &jets.known {
            named.push((self.jet_name(jet, point), jet.value.to_string()));
        }
        named
    }

    /// Returns `diff(f, x)`, with the place where it is evaluated if that is not the point itself.
    fn jet_name(&self, jet: &Jet, point: &FxHashMap<Symbol, Rational>) -> String {
        let unknown = self.pool.function(jet.function);
        let by: Vec<&str> = unknown
            .arguments
            .iter()
            .zip(&jet.orders)
            .flat_map(|(symbol, order)| std::iter::repeat_n(self.pool.symbol_name(*symbol), *order as usize))
            .collect();
        let head = if by.is_empty() {
            unknown.name.clone()
        } else {
            format!("diff({}, {})", unknown.name, by.join(", "))
        };
        let own =
            unknown.arguments.iter().zip(&jet.arguments).all(|(symbol, place)| {
                point.get(symbol).is_some_and(|value| place.as_exact() == Some(value))
            });
        if own {
            return head;
        }
        let places: Vec<String> = jet.arguments.iter().map(Enclosure::digits).collect();
        format!("{head}({})", places.join(", "))
    }
}

/// Returns an exact value in full if it is short enough to read, and any other value to the digits
/// that are certain.
fn value_text(value: &Enclosure) -> String {
    match value.as_exact() {
        Some(exact) if exact.numer().bits() + exact.denom().bits() <= LONGEST_EXACT => exact.to_string(),
        _ => value.digits(),
    }
}

/// Returns the bounds from conditions on a function's own value, such as n > 0.
fn jet_bounds(pool: &Pool, problem: &Problem) -> FxHashMap<FunctionId, Bounds> {
    let mut bounds: FxHashMap<FunctionId, Bounds> = FxHashMap::default();
    for condition in &problem.assumptions {
        if let (Node::Jet { function, orders, .. }, Some(value)) =
            (pool.node(condition.left), pool.as_number(condition.right))
            && orders.iter().all(|&order| order == 0)
        {
            let enclosure = Enclosure::exact(value, Precision(64));
            let entry: &mut Bounds = bounds.entry(*function).or_default();
            entry.restrict(condition.relation, &enclosure);
        }
    }
    bounds
}

struct Jet {
    function: FunctionId,
    orders: Vec<u32>,
    arguments: Vec<Enclosure>,
    value: Rational,
}

/// Values assigned to unknown functions and their derivatives, one for each place of evaluation.
struct Jets<'a> {
    seed: u64,
    round: u32,
    bounds: &'a FxHashMap<FunctionId, Bounds>,
    known: Vec<Jet>,
    /// Whether a place may coincide with two places that have different values.
    mixed: bool,
}

impl Jets<'_> {
    fn value(
        &mut self,
        function: FunctionId,
        orders: &[u32],
        arguments: &[Enclosure],
        precision: Precision,
    ) -> Option<Enclosure> {
        let mut same: Option<&Rational> = None;
        let alike = |jet: &&Jet| {
            jet.function == function
                && jet.orders == orders
                && may_be_the_same_place(&jet.arguments, arguments)
        };
        for jet in self.known.iter().filter(alike) {
            self.mixed |= same.is_some_and(|value| *value != jet.value);
            same = Some(&jet.value);
        }
        if let Some(value) = same {
            return Some(self.noted(function, orders, arguments, value.clone(), precision));
        }
        let order: u32 = orders.iter().sum();
        let bounds = if order == 0 { self.bounds.get(&function) } else { None };
        let value = jet_value(self.seed, self.known.len(), self.round, bounds);
        Some(self.noted(function, orders, arguments, value, precision))
    }

    fn noted(
        &mut self,
        function: FunctionId,
        orders: &[u32],
        arguments: &[Enclosure],
        value: Rational,
        precision: Precision,
    ) -> Enclosure {
        let enclosure = Enclosure::exact(&value, precision);
        let (orders, arguments) = (orders.to_vec(), arguments.to_vec());
        let is_known =
            |jet: &Jet| jet.function == function && jet.orders == orders && jet.arguments == arguments;
        if !self.known.iter().any(is_known) {
            self.known.push(Jet { function, orders, arguments, value });
        }
        enclosure
    }
}

/// Whether two places may be the same. They may still be different: the same value at both is
/// correct, since some smooth function takes it.
fn may_be_the_same_place(a: &[Enclosure], b: &[Enclosure]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.intersects(b))
}
