//! Text of expressions in the language that they came from.

use super::node::{Expr, FunctionId, Node, Rational, Seam};
use super::pool::Pool;
use num_rational::Ratio;
use num_traits::{One, Signed};
use rustc_hash::FxHashMap;
use std::borrow::Cow;
use std::cell::Cell;

/// Largest number of nodes that are written out. An expression can be exponentially larger than its
/// shared form; a larger one is replaced by its size.
const LONGEST: u64 = 20_000;

/// Smallest exponent of a power of ten that is written in scientific notation.
const LONG_POWER: usize = 7;

/// Precedence of the outermost operator of a text.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Negation,
    Power,
    Atom,
}

struct Written {
    text: String,
    binding: Binding,
}

impl Written {
    /// Returns the text, in brackets if the context needs a higher precedence.
    fn within(&self, needed: Binding) -> Cow<'_, str> {
        if self.binding >= needed {
            Cow::Borrowed(&self.text)
        } else {
            Cow::Owned(format!("({})", self.text))
        }
    }
}

impl Pool {
    /// Returns the expression in the language's own notation; an expression too long to read is
    /// replaced by its size.
    pub fn text(&self, expression: Expr) -> String {
        self.texts(&[expression]).remove(0)
    }

    /// Returns the texts of several expressions.
    pub fn texts(&self, expressions: &[Expr]) -> Vec<String> {
        self.written(expressions, &Cell::new(true))
    }

    /// Returns the expression in the language's own notation; `None` if it is too long to read.
    pub(crate) fn full_text(&self, expression: Expr) -> Option<String> {
        let is_full = Cell::new(true);
        let text = self.written(&[expression], &is_full).remove(0);
        is_full.get().then_some(text)
    }

    /// Returns the texts of several expressions and clears a flag if a part of them is too long.
    fn written(&self, expressions: &[Expr], is_full: &Cell<bool>) -> Vec<String> {
        let mut sizes: FxHashMap<Expr, u64> = FxHashMap::default();
        let mut written: FxHashMap<Expr, Written> = FxHashMap::default();
        for expression in self.reachable(expressions) {
            let mut size = 1u64;
            self.node(expression).for_each_operand(|operand| size = size.saturating_add(sizes[&operand]));
            sizes.insert(expression, size);
            let text = if size > LONGEST {
                is_full.set(false);
                Written { text: format!("<{size} terms and operators>"), binding: Binding::Atom }
            } else {
                self.write(expression, &written, is_full)
            };
            written.insert(expression, text);
        }
        expressions.iter().map(|expression| written[expression].text.clone()).collect()
    }

    fn write(&self, expression: Expr, written: &FxHashMap<Expr, Written>, is_full: &Cell<bool>) -> Written {
        let of = |operand: &Expr, needed: Binding| written[operand].within(needed);
        let (text, binding) = match self.node(expression) {
            Node::Number(value) => return write_number(value),
            Node::Pi => ("pi".to_string(), Binding::Atom),
            Node::Symbol(symbol) => (self.symbol_name(*symbol).to_string(), Binding::Atom),
            Node::Add(a, b) => match self.node(*b) {
                Node::Negate(c) => {
                    (format!("{} - {}", of(a, Binding::Sum), of(c, Binding::Product)), Binding::Sum)
                }
                Node::Number(c) if c.is_negative() => {
                    (format!("{} - {}", of(a, Binding::Sum), write_number(&-c).text), Binding::Sum)
                }
                _ => (format!("{} + {}", of(a, Binding::Sum), of(b, Binding::Product)), Binding::Sum),
            },
            Node::Negate(a) => (format!("-{}", of(a, Binding::Product)), Binding::Product),
            Node::Multiply(a, b) => {
                (format!("{}*{}", of(a, Binding::Product), of(b, Binding::Power)), Binding::Product)
            }
            Node::Divide(a, b) => {
                (format!("{}/{}", of(a, Binding::Product), of(b, Binding::Power)), Binding::Product)
            }
            Node::Power(a, exponent) => write_power(&written[a], *exponent),
            Node::Apply(operation, arguments) => {
                let list: Vec<Cow<str>> = arguments.iter().map(|a| of(a, Binding::Sum)).collect();
                (format!("{}({})", operation.row().name, list.join(", ")), Binding::Atom)
            }
            Node::Jet { function, orders, arguments } => {
                let list: Vec<Cow<str>> = arguments.iter().map(|a| of(a, Binding::Sum)).collect();
                (self.write_jet((*function, orders, arguments), &list, is_full), Binding::Atom)
            }
            Node::Select { left, relation, right, then, otherwise, seam } => {
                let [left, right, then, otherwise] =
                    [left, right, then, otherwise].map(|operand| of(operand, Binding::Sum));
                let relation = relation.text();
                let jump = if *seam == Seam::Jumps { "jump " } else { "" };
                (
                    format!("(if {jump}{left} {relation} {right} {{ {then} }} else {{ {otherwise} }})"),
                    Binding::Atom,
                )
            }
        };
        Written { text, binding }
    }

    /// `f`, `f(a, b)`, `diff(f, x)`, `diff(f, x)(a, b)`
    fn write_jet(
        &self,
        (function, orders, arguments): (FunctionId, &[u32], &[Expr]),
        written: &[Cow<str>],
        is_full: &Cell<bool>,
    ) -> String {
        if self.is_primitive(function) {
            return self.write_integral((function, orders, arguments), written, is_full);
        }
        if self.quadrature_of(function).is_some() {
            return self.write_quadrature((function, arguments), written, is_full);
        }
        let unknown = self.function(function);
        let mut head = unknown.name.clone();
        if orders.iter().any(|&order| order > 0) {
            let by: Vec<&str> = unknown
                .arguments
                .iter()
                .zip(orders)
                .flat_map(|(&symbol, &order)| std::iter::repeat_n(self.symbol_name(symbol), order as usize))
                .collect();
            head = format!("diff({head}, {})", by.join(", "));
        }
        let own = unknown
            .arguments
            .iter()
            .zip(arguments)
            .all(|(symbol, argument)| *self.node(*argument) == Node::Symbol(*symbol));
        if own { head } else { format!("{head}({})", written.join(", ")) }
    }

    /// `quadrature(w, s1 = a..b)`
    fn write_quadrature(
        &self,
        (function, arguments): (FunctionId, &[Expr]),
        written: &[Cow<str>],
        is_full: &Cell<bool>,
    ) -> String {
        let mut pool = self.clone();
        match (pool.integrand_at(function, arguments), written) {
            (Some((integrand, variable)), [from, to, ..]) => {
                let name = pool.symbol_name(variable);
                format!("quadrature({}, {name} = {from}..{to})", pool.written(&[integrand], is_full)[0])
            }
            _ => self.function(function).name.clone(),
        }
    }

    /// `integral(w, s1 = 0..b)`
    fn write_integral(
        &self,
        (function, orders, arguments): (FunctionId, &[u32], &[Expr]),
        written: &[Cow<str>],
        is_full: &Cell<bool>,
    ) -> String {
        let mut pool = self.clone();
        let Some((integrand, variables)) = pool.primitive_integrand_at(function, orders, arguments) else {
            return self.function(function).name.clone();
        };
        let ranges: Vec<String> = variables
            .iter()
            .zip(written)
            .map(|(&variable, end)| format!("{} = 0..{end}", pool.symbol_name(variable)))
            .collect();
        format!("integral({}, {})", pool.written(&[integrand], is_full)[0], ranges.join(", "))
    }
}

/// Returns a number in the language's own notation.
pub(crate) fn number_text(value: &Rational) -> String {
    write_number(value).text
}

fn write_number(value: &Rational) -> Written {
    let binding = match (value.is_negative(), value.denom().is_one()) {
        (true, _) => Binding::Negation,
        (false, true) => Binding::Atom,
        (false, false) => Binding::Product,
    };
    Written { text: scientific(value).unwrap_or_else(|| value.to_string()), binding }
}

/// Writes a long number that is a short number times a power of ten in scientific notation:
/// `3e-20`.
fn scientific(value: &Rational) -> Option<String> {
    let (top, bottom) = (value.numer().to_string(), value.denom().to_string());
    let zeros = |digits: &str| digits.len() - digits.trim_end_matches('0').len();
    if bottom == "1" {
        let power = zeros(&top);
        return (power >= LONG_POWER).then(|| format!("{}e{power}", &top[..top.len() - power]));
    }
    let power = zeros(&bottom);
    (power >= LONG_POWER && bottom.len() == power + 1 && bottom.starts_with('1'))
        .then(|| format!("{top}e-{power}"))
}

/// `sqrt(q)`, `q**3`, `q**(3/2)`; `1/q**2` keeps the division it was written with
fn write_power(base: &Written, exponent: Ratio<i64>) -> (String, Binding) {
    if exponent == Ratio::new(1, 2) {
        return (format!("sqrt({})", base.text), Binding::Atom);
    }
    let base = base.within(Binding::Atom);
    if exponent.is_integer() {
        (format!("{base}**{exponent}"), Binding::Power)
    } else {
        (format!("{base}**({exponent})"), Binding::Power)
    }
}
