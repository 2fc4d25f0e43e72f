//! LaTeX of values and expressions.

use super::name::latex_name;
use super::sum::{Coefficient, Term, joined, terms};
use crate::calculus::Coordinate;
use crate::expression::{Expr, Extremum, FunctionId, Node, Operation, Pool, Rational, Relation, Shape};
use crate::theory::{Theory, Value};
use num_rational::Ratio;
use num_traits::{One, Signed};
use rustc_hash::FxHashMap;

/// Largest number of nodes that are written out. An expression can be exponentially larger than its
/// shared form; a larger one is replaced by its size.
const LONGEST: u64 = 20_000;

/// Precedence of the outermost operator.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Binding {
    Sum,
    Product,
    Fraction,
    Power,
    Atom,
}

pub(super) struct Written {
    pub(super) latex: String,
    pub(super) binding: Binding,
}

impl Written {
    pub(super) fn within(&self, needed: Binding) -> String {
        if self.binding >= needed { self.latex.clone() } else { bracketed(&self.latex) }
    }
}

pub(super) fn bracketed(latex: &str) -> String {
    format!("\\left({latex}\\right)")
}

/// Writes a value in LaTeX:
/// `\frac{4}{\left(u^{2} + v^{2} + 1\right)^{2}}\,\mathrm{d}u\wedge\mathrm{d}v`.
pub fn latex(theory: &Theory, value: &Value) -> String {
    let basis = |coordinates: &[Coordinate]| {
        let names = coordinates.iter().map(|c| latex_name(theory.coordinate_name(*c)));
        if matches!(value, Value::Field(_)) {
            names.map(|name| format!("\\partial_{{{name}}}")).collect::<String>()
        } else {
            names.map(|name| format!("\\mathrm{{d}}{name}")).collect::<Vec<_>>().join("\\wedge ")
        }
    };
    match value {
        Value::Zero => "0".to_string(),
        Value::Scalar(scalar) => latex_of_expression(&theory.pool, *scalar),
        Value::Array(array) => {
            let entries = array.entries.iter().map(|&entry| latex_of_expression(&theory.pool, entry));
            let entries: Vec<String> = entries.collect();
            let columns = if let Shape::Matrix(_, columns) = array.shape { columns } else { 1 };
            let rows: Vec<String> = entries.chunks(columns).map(|row| row.join(" & ")).collect();
            format!("\\begin{{pmatrix}} {} \\end{{pmatrix}}", rows.join(" \\\\ "))
        }
        Value::Form(_) | Value::Field(_) => {
            let written = |term: Term| {
                let write = |scalar| latex_of_expression(&theory.pool, scalar);
                let brackets = |latex: String| bracketed(&latex);
                let coefficient = Coefficient::new(&theory.pool, term.coefficient, write, brackets);
                (coefficient, basis(&term.coordinates))
            };
            joined(terms(value).into_iter().map(written).collect(), "\\,")
        }
    }
}

/// Writes a name in LaTeX: `\theta`, `\sigma_{a}`.
pub fn latex_of_name(name: &str) -> String {
    latex_name(name)
}

/// Writes a scalar expression in LaTeX; an expression too long to read is replaced by its size.
pub fn latex_of_expression(pool: &Pool, expression: Expr) -> String {
    let mut sizes: FxHashMap<Expr, u64> = FxHashMap::default();
    let mut written: FxHashMap<Expr, Written> = FxHashMap::default();
    for part in pool.reachable(&[expression]) {
        let operands = pool.node(part).operands();
        let size = operands.iter().fold(1u64, |sum, operand| sum.saturating_add(sizes[operand]));
        sizes.insert(part, size);
        let latex = if size > LONGEST {
            let latex = format!("\\langle\\text{{{size} terms and operators}}\\rangle");
            Written { latex, binding: Binding::Atom }
        } else {
            Writer { pool, written: &written }.write(part)
        };
        written.insert(part, latex);
    }
    written.remove(&expression).map(|written| written.latex).unwrap_or_default()
}

struct Writer<'a> {
    pool: &'a Pool,
    written: &'a FxHashMap<Expr, Written>,
}

impl Writer<'_> {
    fn of(&self, operand: Expr, needed: Binding) -> String {
        self.written[&operand].within(needed)
    }

    fn write(&self, expression: Expr) -> Written {
        if let Some((which, operands)) = self.pool.as_extremum(expression) {
            return self.extremum(which, operands);
        }
        let (latex, binding) = match self.pool.node(expression) {
            Node::Number(value) => number(value),
            Node::Pi => ("\\pi".to_string(), Binding::Atom),
            Node::Symbol(symbol) => (latex_name(self.pool.symbol_name(*symbol)), Binding::Atom),
            Node::Add(a, b) => (self.sum(*a, *b), Binding::Sum),
            Node::Negate(a) => (format!("-{}", self.of(*a, Binding::Product)), Binding::Product),
            Node::Multiply(a, b) => (self.product(*a, *b), Binding::Product),
            Node::Divide(a, b) => {
                let (above, below) = (self.of(*a, Binding::Sum), self.of(*b, Binding::Sum));
                (format!("\\frac{{{above}}}{{{below}}}"), Binding::Fraction)
            }
            Node::Power(a, exponent) => self.power(*a, *exponent),
            Node::Apply(operation, arguments) => self.function(*operation, arguments, ""),
            Node::Jet { function, orders, arguments } => self.jet(*function, orders, arguments),
            Node::Select { left, relation, right, then, otherwise, .. } => {
                let [left, right, then, otherwise] =
                    [left, right, then, otherwise].map(|operand| self.of(*operand, Binding::Sum));
                let relation = latex_of_relation(*relation);
                let cases =
                    format!("{then} & {left} {relation} {right} \\\\ {otherwise} & \\text{{otherwise}}");
                (format!("\\begin{{cases}} {cases} \\end{{cases}}"), Binding::Sum)
            }
        };
        Written { latex, binding }
    }

    fn sum(&self, a: Expr, b: Expr) -> String {
        let left = self.of(a, Binding::Sum);
        match self.pool.node(b) {
            Node::Negate(c) => format!("{left} - {}", self.of(*c, Binding::Product)),
            Node::Number(c) if c.is_negative() => format!("{left} - {}", number(&-c).0),
            _ => format!("{left} + {}", self.of(b, Binding::Product)),
        }
    }

    /// Writes two factors next to each other, with a dot between a factor that ends in a digit and
    /// digits that follow it.
    fn product(&self, a: Expr, b: Expr) -> String {
        let (left, right) = (self.of(a, Binding::Product), self.of(b, Binding::Fraction));
        let digits = right.starts_with(|c: char| c.is_ascii_digit()) || right.starts_with("\\frac{");
        let numeric = left.ends_with(|c: char| c.is_ascii_digit());
        let between = if digits && numeric { "\\cdot " } else { "\\," };
        format!("{left}{between}{right}")
    }

    /// √q, ⁿ√q, sinⁿ q, q^r
    fn power(&self, a: Expr, exponent: Ratio<i64>) -> (String, Binding) {
        if exponent.numer().is_one() && !exponent.is_integer() {
            let radicand = self.of(a, Binding::Sum);
            let index =
                if *exponent.denom() == 2 { String::new() } else { format!("[{}]", exponent.denom()) };
            return (format!("\\sqrt{index}{{{radicand}}}"), Binding::Atom);
        }
        if let Node::Apply(operation, arguments) = self.pool.node(a)
            && exponent.is_integer()
            && exponent.is_positive()
            && !matches!(operation, Operation::Exp | Operation::Abs)
        {
            return self.function(*operation, arguments, &format!("^{{{exponent}}}"));
        }
        let base = self.of(a, Binding::Atom);
        (format!("{base}^{{{exponent}}}"), Binding::Power)
    }

    fn function(&self, operation: Operation, arguments: &[Expr], exponent: &str) -> (String, Binding) {
        let list: Vec<String> = arguments.iter().map(|&a| self.of(a, Binding::Sum)).collect();
        let list = list.join(", ");
        match operation {
            Operation::Exp => (format!("e^{{{list}}}"), Binding::Power),
            Operation::Abs => (format!("\\left|{list}\\right|"), Binding::Atom),
            _ => (format!("{}{exponent}\\left({list}\\right)", operation.row().latex), Binding::Power),
        }
    }

    /// min(a, b), max(a, b)
    fn extremum(&self, which: Extremum, operands: [Option<Expr>; 2]) -> Written {
        let name = if which == Extremum::Least { "min" } else { "max" };
        let [a, b] = operands.map(|q| q.map_or_else(|| "0".to_owned(), |q| self.of(q, Binding::Sum)));
        Written { latex: format!("\\{name}\\left({a}, {b}\\right)"), binding: Binding::Power }
    }

    /// f, f(a, b), ∂²f/∂x∂y, (∂f/∂x)(a, b)
    fn jet(&self, function: FunctionId, orders: &[u32], arguments: &[Expr]) -> (String, Binding) {
        if let Some(integral) = self.integral(function, orders, arguments) {
            return integral;
        }
        if let Some(quadrature) = self.quadrature(function, arguments) {
            return quadrature;
        }
        let unknown = self.pool.function(function);
        let name = latex_name(&unknown.name);
        let total: u32 = orders.iter().sum();
        let (head, binding) = if total == 0 {
            (name, Binding::Atom)
        } else {
            let by: Vec<String> = unknown
                .arguments
                .iter()
                .zip(orders)
                .filter(|(_, order)| **order > 0)
                .map(|(&symbol, &order)| {
                    format!("\\partial {}{}", latex_name(self.pool.symbol_name(symbol)), raised(order))
                })
                .collect();
            let fraction = format!("\\frac{{\\partial{} {name}}}{{{}}}", raised(total), by.join("\\,"));
            (fraction, Binding::Fraction)
        };
        let own = unknown
            .arguments
            .iter()
            .zip(arguments)
            .all(|(symbol, argument)| *self.pool.node(*argument) == Node::Symbol(*symbol));
        if own {
            return (head, binding);
        }
        let list: Vec<String> = arguments.iter().map(|&a| self.of(a, Binding::Sum)).collect();
        (format!("{head}{}", bracketed(&list.join(", "))), Binding::Fraction)
    }

    /// ∫ₐᵇ w ds, if the function is a quadrature
    fn quadrature(&self, function: FunctionId, arguments: &[Expr]) -> Option<(String, Binding)> {
        let mut pool = self.pool.clone();
        let (integrand, variable) = pool.integrand_at(function, arguments)?;
        let [from, to] = [arguments[0], arguments[1]].map(|end| self.of(end, Binding::Sum));
        let name = latex_name(pool.symbol_name(variable));
        let integrand = latex_of_expression(&pool, integrand);
        Some((format!("\\int_{{{from}}}^{{{to}}} {integrand}\\,\\mathrm{{d}}{name}"), Binding::Sum))
    }

    /// ∫₀ᵇ w ds, if the function is a primitive
    fn integral(
        &self,
        function: FunctionId,
        orders: &[u32],
        arguments: &[Expr],
    ) -> Option<(String, Binding)> {
        let mut pool = self.pool.clone();
        let (integrand, variables) = pool.primitive_integrand_at(function, orders, arguments)?;
        let ends = variables.iter().zip(arguments);
        let signs: String =
            ends.map(|(_, &end)| format!("\\int_0^{{{}}}", self.of(end, Binding::Sum))).collect();
        let steps: Vec<String> = variables
            .iter()
            .map(|&variable| format!("\\,\\mathrm{{d}}{}", latex_name(pool.symbol_name(variable))))
            .collect();
        Some((format!("{signs} {}{}", latex_of_expression(&pool, integrand), steps.concat()), Binding::Sum))
    }
}

fn raised(order: u32) -> String {
    if order == 1 { String::new() } else { format!("^{{{order}}}") }
}

pub(super) fn number(value: &Rational) -> (String, Binding) {
    let magnitude = value.abs();
    let (latex, binding) = if value.denom().is_one() {
        (magnitude.to_string(), Binding::Atom)
    } else {
        (format!("\\frac{{{}}}{{{}}}", magnitude.numer(), magnitude.denom()), Binding::Fraction)
    };
    if value.is_negative() { (format!("-{latex}"), Binding::Product) } else { (latex, binding) }
}

/// Returns a relation in LaTeX: `<`, `\le`, `\ne`.
pub fn latex_of_relation(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "<",
        Relation::LessEqual => "\\le",
        Relation::Greater => ">",
        Relation::GreaterEqual => "\\ge",
        Relation::NotEqual => "\\ne",
    }
}
