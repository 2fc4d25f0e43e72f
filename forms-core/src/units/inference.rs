//! Unit inference: the unit of every expression, from the units of the names in it.
//!
//! A form is measured as a whole: dx has the unit of x, so that x dy ∧ dz over metres is in m³ in
//! every chart; @x has the reciprocal unit. Operators then multiply units, and d, which multiplies
//! by dx as often as it divides by x, keeps the unit.

use super::quantity::{Disagreement, Quantity};
use super::unit::Unit;
use super::{Inferred, agreement};
use crate::diagnostic::{Diagnostic, Span};
use crate::resolve::Trace;
use crate::syntax::ast::{Binary, Condition, Expr, ExprKind};
use crate::theory::{KernelUnits, Named, Theory, Value};
use num_rational::BigRational;
use num_traits::{One, Zero};
use rustc_hash::FxHashMap;

/// Arguments of a kernel by name, and its outputs.
#[derive(Clone)]
pub(super) struct Signature {
    pub(super) arguments: Vec<(String, Quantity)>,
    pub(super) outputs: Vec<Quantity>,
}

/// Infers units against the declarations read so far.
pub(super) struct Inference<'a> {
    pub(super) theory: &'a Theory,
    pub(super) trace: &'a Trace,
    /// Quantity of each name.
    pub(super) names: FxHashMap<String, Quantity>,
    /// Arguments of each unknown function.
    pub(super) arguments: FxHashMap<String, Vec<String>>,
    pub(super) errors: Vec<Diagnostic>,
    pub(super) kernels: Vec<(String, KernelUnits)>,
    /// Quantities of the arguments and outputs of each kernel.
    pub(super) signatures: FxHashMap<String, Signature>,
    pub(super) meaningless: Vec<Span>,
    /// Number of bodies of definitions inferred so far.
    pub(super) bodies: usize,
}

impl<'a> Inference<'a> {
    pub(super) fn new(theory: &'a Theory, trace: &'a Trace) -> Self {
        Inference {
            theory,
            trace,
            names: FxHashMap::default(),
            arguments: FxHashMap::default(),
            errors: Vec::new(),
            kernels: Vec::new(),
            signatures: FxHashMap::default(),
            meaningless: Vec::new(),
            bodies: 0,
        }
    }

    /// Returns the results of the inference.
    pub(super) fn finish(self) -> Inferred {
        let object = |(name, quantity): (&String, &Quantity)| match self.theory.named(name) {
            Some(Named::Object(number)) => Some((*number, quantity.unit()?.to_string())),
            _ => None,
        };
        let objects = self.names.iter().filter_map(object).collect();
        Inferred { errors: self.errors, objects, kernels: self.kernels, meaningless: self.meaningless }
    }

    /// Infers the quantity of an expression. Chains of operators are processed in a loop.
    pub(super) fn quantity(&mut self, expression: &Expr) -> Quantity {
        let mut spine = Vec::new();
        let mut leftmost = expression;
        while let ExprKind::Binary(operator, place, left, right) = &*leftmost.kind {
            spine.push((*operator, *place, left.span, right));
            leftmost = left;
        }
        let mut quantity = self.operand(leftmost);
        while let Some((operator, place, left_span, right)) = spine.pop() {
            quantity = self.binary(operator, place, (quantity, left_span), right);
        }
        quantity
    }

    fn operand(&mut self, expression: &Expr) -> Quantity {
        match &*expression.kind {
            ExprKind::Number(value) if value.is_zero() => Quantity::Zero,
            ExprKind::Number(_) => Quantity::Number,
            ExprKind::Name(name) => self.name(name),
            ExprKind::Basis(name) => self.name(&name.text).power(&-BigRational::one()),
            ExprKind::Negate(inner) => self.quantity(inner),
            ExprKind::Call { function, index, arguments } => {
                self.call(function, index.as_ref(), arguments, expression.span)
            }
            ExprKind::Index { base, indices } => match indices.as_slice() {
                [index] if self.is_of_basis(index) => self.coefficient(base, index),
                _ => self.quantity(base),
            },
            ExprKind::Array(entries) => {
                let entries = entries.iter().map(|entry| self.quantity(entry)).collect();
                self.common(entries)
            }
            ExprKind::Select { condition, then, otherwise, .. } => {
                self.condition(condition);
                let (then, otherwise_quantity) = (self.quantity(then), self.quantity(otherwise));
                self.alike(
                    (then, "the first branch"),
                    (otherwise_quantity, "the second"),
                    otherwise.span,
                    "the branches of `if` have different units",
                )
            }
            ExprKind::Binary(..) => Quantity::Unstated,
        }
    }

    fn name(&self, name: &str) -> Quantity {
        match self.theory.named(name) {
            _ if name == "pi" => Quantity::Number,
            Some(Named::Differential(coordinate)) => self
                .names
                .get(self.theory.coordinate_name(*coordinate))
                .cloned()
                .unwrap_or(Quantity::Unstated),
            _ => self.names.get(name).cloned().unwrap_or(Quantity::Unstated),
        }
    }

    fn binary(
        &mut self,
        operator: Binary,
        place: Span,
        (left, left_span): (Quantity, Span),
        right: &Expr,
    ) -> Quantity {
        if operator == Binary::Power {
            return self.power(left, left_span, right);
        }
        let right = self.quantity(right);
        match operator {
            Binary::Add => self.alike(
                (left, "the left side"),
                (right, "the right side"),
                place,
                "cannot add different units",
            ),
            Binary::Subtract => self.alike(
                (left, "the left side"),
                (right, "the right side"),
                place,
                "cannot subtract different units",
            ),
            Binary::Divide => left.over(&right),
            Binary::Multiply | Binary::Wedge | Binary::Power => left.times(&right),
        }
    }

    /// Infers a power: a pure number can have any exponent, another quantity needs a known
    /// exponent.
    fn power(&mut self, base: Quantity, base_span: Span, exponent: &Expr) -> Quantity {
        let quantity = self.quantity(exponent);
        self.pure(&quantity, exponent.span, "an exponent is a number");
        let known = match self.trace.get(&exponent.span) {
            _ if let ExprKind::Number(value) = &*exponent.kind => Some(value.clone()),
            Some(Value::Scalar(value)) => self.theory.pool.as_number(*value).cloned(),
            Some(Value::Zero) => Some(BigRational::zero()),
            _ => return Quantity::Unstated,
        };
        match known {
            Some(exponent) => base.power(&exponent),
            None => {
                self.pure(&base, base_span, "only a number has powers with a variable exponent");
                let numbers = base == Quantity::Number && quantity == Quantity::Number;
                if numbers { Quantity::Number } else { Quantity::one() }
            }
        }
    }

    /// Whether an index names coordinates, differentials or a metric, and not a place in an array.
    fn is_of_basis(&self, index: &Expr) -> bool {
        let mut leftmost = index;
        while let ExprKind::Binary(_, _, left, _) = &*leftmost.kind {
            leftmost = left;
        }
        let ExprKind::Name(name) = &*leftmost.kind else { return false };
        let named = self.theory.named(name);
        matches!(named, Some(Named::Coordinate(_) | Named::Differential(_) | Named::Metric(_)))
    }

    /// Returns the quantity of an array: that of all its entries, if they have one unit.
    pub(super) fn common(&self, entries: Vec<Quantity>) -> Quantity {
        let mut entries = entries.into_iter();
        let first = entries.next().unwrap_or(Quantity::Unstated);
        let common = entries.try_fold(first, Quantity::alike);
        common.unwrap_or(Quantity::Unstated)
    }

    /// Infers a coefficient: the unit of `w[dx^dy]` is divided by the units of dx and dy, the unit
    /// of `X[x]` is multiplied by the unit of x.
    fn coefficient(&mut self, base: &Expr, index: &Expr) -> Quantity {
        if let ExprKind::Name(name) = &*base.kind
            && name == "volume"
        {
            return self.volume(index);
        }
        let quantity = self.quantity(base);
        let mut leftmost = index;
        let mut unit = Quantity::Number;
        while let ExprKind::Binary(_, _, left, right) = &*leftmost.kind {
            unit = unit.times(&self.quantity(right));
            leftmost = left;
        }
        unit = unit.times(&self.quantity(leftmost));
        match &*leftmost.kind {
            ExprKind::Name(name) if matches!(self.theory.named(name), Some(Named::Coordinate(_))) => {
                quantity.times(&unit)
            }
            _ => quantity.over(&unit),
        }
    }

    /// Compares the sides of each relation.
    pub(super) fn condition(&mut self, condition: &Condition) {
        let mut left = self.quantity(&condition.first);
        for (_, right) in &condition.rest {
            let right = self.quantity(right);
            self.alike(
                (left, "the left side"),
                (right.clone(), "the right side"),
                condition.span,
                "cannot compare different units",
            );
            left = right;
        }
    }

    /// Returns the common quantity of two quantities that must agree; if they do not, records an
    /// error and returns `Unstated`.
    pub(super) fn alike(
        &mut self,
        (left, left_name): (Quantity, &str),
        (right, right_name): (Quantity, &str),
        place: Span,
        message: &str,
    ) -> Quantity {
        left.alike(right).unwrap_or_else(|Disagreement(left, right)| {
            let message = format!("{message}: {left_name} is in {left}, {right_name} in {right}");
            let advice = agreement::advice(&left, &right, (left_name, right_name));
            self.errors.push(Diagnostic::new(place, message).with_help(advice));
            Quantity::Unstated
        })
    }

    /// Requires a number, or an angle in radians.
    pub(super) fn pure(&mut self, quantity: &Quantity, place: Span, message: &str) {
        if let Some(unit) = quantity.unit()
            && agreement::common(&unit, &Unit::one()).is_none()
        {
            let diagnostic = Diagnostic::new(place, format!("{message}, and this is in {unit}"));
            self.errors.push(diagnostic.with_help(format!("divide it by a quantity in {unit}")));
        }
    }
}
