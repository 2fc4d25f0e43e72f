//! Conversion of structured expressions to fractions.
//!
//! The atoms (variables, jets, roots, functions) are converted first, exactly, with everything in
//! their arguments: this fixes the generators. The other expressions follow, either exactly or, as
//! a filter, modulo a prime.

use super::base::SignConstraint;
use super::fraction::Fraction;
use super::generator::Generator;
use super::obstacle::{Obstacle, OutsidePart, SizeLimit};
use super::plan::{Step, steps};
use super::tower::Tower;
use crate::expression::{Expr, FunctionId, Node, Operation, Pool};
use num_rational::Ratio;
use num_traits::{One, Signed};
use rustc_hash::{FxHashMap, FxHashSet};

/// Largest number of refinements of the generators before the conversion is given up; each one
/// splits a factor or a unit.
const MOST_REFINEMENTS: usize = 64;

/// Expressions whose generators are fixed.
#[derive(Clone, Debug)]
pub struct Normalised {
    order: Vec<Expr>,
    roots: Vec<Expr>,
    /// Constraints under which the radicands met are non-negative, for radicands that depend on no
    /// open sign.
    pub constraints: Vec<SignConstraint>,
    /// The bases whose open signs are needed first: by radicands that depend on no other open sign.
    pub open: Vec<usize>,
    provisional: FxHashSet<Expr>,
}

/// Fixes the generators of some expressions. Elements that the tower knows already are not computed
/// again.
///
/// # Errors
/// An [`Obstacle`] other than [`Obstacle::Refine`] if an atom lies outside the class that is
/// decided.
pub fn normalise(tower: &mut Tower, pool: &Pool, roots: &[Expr]) -> Result<Normalised, Obstacle> {
    let order = pool.reachable(roots);
    let within_atoms = arguments_of_atoms(pool, &order);
    for _ in 0..MOST_REFINEMENTS {
        let is_within =
            |expression: Expr| within_atoms.get(expression.0 as usize).is_some_and(|within| *within);
        let wanted = |expression| is_within(expression) || is_atom(pool, expression);
        match walk(tower, pool, |walk| walk.run(&order, wanted)) {
            Err(Obstacle::Refine) => tower.start_again(),
            result => {
                let prepared = Normalised::of(tower, pool, order, roots, wanted);
                // with another sign the obstacle can disappear
                return if prepared.open.is_empty() { result.map(|()| prepared) } else { Ok(prepared) };
            }
        }
    }
    Err(Obstacle::TooLarge(SizeLimit::Refinements(MOST_REFINEMENTS)))
}

impl Normalised {
    /// Determines which expressions depend on which open sign, operands before results.
    fn of(
        tower: &Tower,
        pool: &Pool,
        order: Vec<Expr>,
        roots: &[Expr],
        wanted: impl Fn(Expr) -> bool,
    ) -> Self {
        let (mut constraints, mut open) = (Vec::new(), Vec::new());
        let mut provisional: FxHashSet<Expr> = FxHashSet::default();
        for &expression in &order {
            let missing = wanted(expression) && !tower.elements.contains_key(&expression);
            let mut inherited = missing;
            if !provisional.is_empty() {
                pool.node(expression).for_each_operand(|operand| inherited |= provisional.contains(&operand));
            }
            let asked = tower.open_signs(expression);
            if !inherited {
                open.extend(asked.iter().filter(|base| !open.contains(*base)).copied().collect::<Vec<_>>());
            }
            if inherited || !asked.is_empty() {
                provisional.insert(expression);
            } else if let Some(constraint) = tower.constraint_of(expression) {
                constraints.push(constraint.clone());
            }
        }
        Normalised { order, roots: roots.to_vec(), constraints, open, provisional }
    }

    /// Returns the fractions of the expressions, in their order.
    ///
    /// # Errors
    /// If one divides by zero everywhere or grows beyond the limit.
    pub fn exact(&self, tower: &mut Tower, pool: &Pool) -> Result<Vec<Fraction>, Obstacle> {
        let steps = steps(tower, pool, &self.roots);
        walk(tower, pool, |walk| walk.follow(steps))?;
        Ok(self.roots.iter().map(|root| tower.elements[root].clone()).collect())
    }

    /// Whether the normal forms are valid for all values of the open signs.
    pub fn is_unconditional(&self) -> bool {
        self.open.is_empty() || !self.roots.iter().any(|root| self.provisional.contains(root))
    }

    pub(super) fn order(&self) -> &[Expr] {
        &self.order
    }

    pub(super) fn roots(&self) -> &[Expr] {
        &self.roots
    }
}

/// Computes elements that the tower does not know.
fn walk<'a>(
    tower: &'a mut Tower,
    pool: &'a Pool,
    compute: impl FnOnce(&mut Walk<'a>) -> Result<(), Obstacle>,
) -> Result<(), Obstacle> {
    tower.signs.take();
    let elements = std::mem::take(&mut tower.elements);
    let mut walk = Walk { tower, pool, elements, inverses: FxHashMap::default() };
    let result = compute(&mut walk);
    walk.tower.elements = walk.elements;
    result
}

/// Whether a node is a generator or a function of one, not an operation of the field.
fn is_atom(pool: &Pool, expression: Expr) -> bool {
    match pool.node(expression) {
        Node::Number(_) | Node::Pi | Node::Symbol(_) | Node::Apply(..) | Node::Jet { .. } => true,
        Node::Power(_, exponent) => !exponent.is_integer(),
        _ => false,
    }
}

/// Returns for each expression, by its number, whether it is part of an atom's argument.
fn arguments_of_atoms(pool: &Pool, order: &[Expr]) -> Vec<bool> {
    let mut arguments: Vec<Expr> = Vec::new();
    for &expression in order {
        if is_atom(pool, expression) {
            pool.node(expression).for_each_operand(|operand| arguments.push(operand));
        }
    }
    let mut within = vec![false; arguments.iter().max().map_or(0, |last| last.0 as usize + 1)];
    for expression in pool.reachable(&arguments) {
        within[expression.0 as usize] = true;
    }
    within
}

struct Walk<'a> {
    tower: &'a mut Tower,
    pool: &'a Pool,
    elements: FxHashMap<Expr, Fraction>,
    /// Inverses of divisors: the coefficients of a form often have the same divisor.
    inverses: FxHashMap<Expr, Fraction>,
}

impl Walk<'_> {
    fn follow(&mut self, steps: Vec<(Expr, Step)>) -> Result<(), Obstacle> {
        self.elements.reserve(steps.len());
        for (expression, step) in steps {
            let element = match step {
                Step::Operation => self.element(expression)?,
                Step::Divergence(terms) => {
                    let terms: Vec<_> =
                        terms.iter().map(|&(sign, of, by)| (sign, &self.elements[&of], by)).collect();
                    self.tower.divergence(&terms)?
                }
            };
            self.tower.signs.note(expression);
            self.elements.insert(expression, element);
        }
        Ok(())
    }

    fn run(&mut self, order: &[Expr], wanted: impl Fn(Expr) -> bool) -> Result<(), Obstacle> {
        self.elements.reserve(order.len().saturating_sub(self.elements.len()));
        for &expression in order {
            if !self.elements.contains_key(&expression) && wanted(expression) {
                let element = self.element(expression)?;
                self.tower.signs.note(expression);
                self.elements.insert(expression, element);
            }
        }
        Ok(())
    }

    fn of(&self, operand: Expr) -> Fraction {
        self.elements[&operand].clone()
    }

    fn element(&mut self, expression: Expr) -> Result<Fraction, Obstacle> {
        match self.pool.node(expression) {
            Node::Number(value) => Ok(Fraction::number(value)),
            Node::Pi => Ok(self.tower.element(Generator::Pi)),
            Node::Symbol(symbol) => Ok(self.tower.variable_in_frame(*symbol).into()),
            Node::Add(a, b) => self.tower.add(&self.elements[a], &self.elements[b]),
            Node::Negate(a) => Ok(self.tower.negate(&self.elements[a])),
            Node::Multiply(a, b) => self.tower.multiply(&self.elements[a], &self.elements[b]),
            Node::Divide(a, b) => {
                if !self.inverses.contains_key(b) {
                    let inverse = self.tower.inverse(&self.elements[b])?;
                    self.inverses.insert(*b, inverse);
                }
                self.tower.multiply(&self.elements[a], &self.inverses[b])
            }
            Node::Power(a, exponent) => self.power(*a, *exponent),
            Node::Apply(operation, arguments) => self.function(*operation, arguments),
            Node::Jet { function, orders, arguments } => self.jet(*function, orders, arguments),
            Node::Select { .. } => Err(Obstacle::Outside(OutsidePart::Conditional)),
        }
    }

    fn power(&mut self, operand: Expr, exponent: Ratio<i64>) -> Result<Fraction, Obstacle> {
        let base = self.of(operand);
        if exponent.is_integer() {
            return self.tower.factored_power(&base, *exponent.numer());
        }
        if base.is_zero() {
            return if exponent.is_positive() { Ok(base) } else { Err(Obstacle::DivisionByZero) };
        }
        let (power, constraint) = self.tower.magnitude_power(&base, exponent)?;
        if let Some(constraint) = constraint {
            self.tower.constrain(operand, constraint);
        }
        Ok(power)
    }

    fn function(&mut self, operation: Operation, arguments: &[Expr]) -> Result<Fraction, Obstacle> {
        let argument = self.of(arguments[0]);
        match operation {
            Operation::Sin => Ok(self.tower.circular(&argument)?.1),
            Operation::Cos => Ok(self.tower.circular(&argument)?.0),
            Operation::Tan => self.tower.tangent(&argument),
            Operation::Exp => self.tower.exponential(&argument),
            Operation::Expm1 => {
                let power = self.tower.exponential(&argument)?;
                self.tower.subtract(&power, &Fraction::one())
            }
            Operation::Log1p => {
                let sum = self.tower.add(&Fraction::one(), &argument)?;
                self.tower.logarithm(&sum)
            }
            Operation::Sinh => Ok(self.tower.hyperbolic(&argument)?.1),
            Operation::Cosh => Ok(self.tower.hyperbolic(&argument)?.0),
            Operation::Tanh => {
                let (cosh, sinh) = self.tower.hyperbolic(&argument)?;
                self.quotient(&sinh, &cosh)
            }
            Operation::Abs if argument.is_zero() => Ok(argument),
            Operation::Abs => Ok(self.tower.magnitude_power(&argument, Ratio::one())?.0),
            Operation::Asin | Operation::Atan if argument.is_zero() => Ok(argument),
            Operation::Log => self.tower.logarithm(&argument),
            Operation::Asin | Operation::Acos | Operation::Atan | Operation::Atan2 => {
                let arguments: Vec<Fraction> = arguments.iter().map(|&a| self.of(a)).collect();
                self.tower.opaque(operation, &arguments)
            }
            Operation::Erf => self.tower.error_function(&argument),
            Operation::Expint1 => self.tower.exponential_integral(1, &argument),
            Operation::Expint2 => self.tower.exponential_integral(2, &argument),
            Operation::Expint3 => self.tower.exponential_integral(3, &argument),
            Operation::Dilog => self.tower.dilogarithm(&argument),
            Operation::Clausen => self.tower.clausen(&argument),
            Operation::Erfc => {
                let error_function = self.tower.error_function(&argument)?;
                self.tower.subtract(&Fraction::one(), &error_function)
            }
            Operation::Hypot => self.hypotenuse(argument, self.of(arguments[1])),
            Operation::Cbrt => self.tower.cube_root(&argument),
        }
    }

    /// √(x² + y²)
    fn hypotenuse(&mut self, x: Fraction, y: Fraction) -> Result<Fraction, Obstacle> {
        let squares = [self.tower.multiply(&x, &x)?, self.tower.multiply(&y, &y)?];
        let sum = self.tower.add(&squares[0], &squares[1])?;
        if sum.is_zero() {
            return Ok(sum);
        }
        Ok(self.tower.magnitude_power(&sum, Ratio::new(1, 2))?.0)
    }

    fn quotient(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, Obstacle> {
        let inverse = self.tower.inverse(b)?;
        self.tower.multiply(a, &inverse)
    }

    fn jet(&mut self, function: FunctionId, orders: &[u32], at: &[Expr]) -> Result<Fraction, Obstacle> {
        let arguments: Vec<Fraction> = at.iter().map(|&a| self.of(a)).collect();
        if arguments[..self.pool.upper_ends(function)].iter().any(Fraction::is_zero) {
            return Ok(Fraction::zero());
        }
        let fresh = Generator::Jet { function, orders: orders.to_vec(), arguments: arguments.clone() };
        let generator = self.tower.with_same_arguments(&arguments, fresh, |generator| match generator {
            Generator::Jet { function: f, orders: o, arguments } if *f == function && o == orders => {
                Some(arguments)
            }
            _ => None,
        })?;
        Ok(self.tower.element(generator))
    }
}
