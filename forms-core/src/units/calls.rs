//! Units of function calls.

use super::inference::Inference;
use super::quantity::Quantity;
use super::unit::Unit;
use crate::diagnostic::Span;
use crate::expression::Operation;
use crate::syntax::ast::{Argument, Expr, Name};
use crate::syntax::words::{COMMON_FUNCTIONS, METRIC_OPERATIONS};
use crate::theory::{Named, Value};
use num_bigint::BigInt;
use num_rational::BigRational;
use std::sync::Arc;

/// Largest number of bodies of definitions that are inferred in one source.
const MOST_BODIES: usize = 100_000;

impl Inference<'_> {
    pub(super) fn call(
        &mut self,
        function: &Name,
        index: Option<&Expr>,
        arguments: &[Argument],
        span: Span,
    ) -> Quantity {
        let name = function.text.as_str();
        match name {
            "integral" | "quadrature" => return self.integral(arguments),
            "boundary_integral" => return self.boundary_integral(arguments),
            "sum" | "product" if self.theory.named(name).is_none() => return self.repeated(name, arguments),
            _ => {}
        }
        let values: Vec<&Expr> = arguments
            .iter()
            .filter_map(|argument| match argument {
                Argument::Value(value) => Some(value),
                Argument::Range { .. } => None,
            })
            .collect();
        match (name, values.as_slice()) {
            ("d" | "potential", [form]) | ("pullback", [_, form]) => self.quantity(form),
            ("interior" | "lie" | "bracket", [_, _]) => self.product(&values),
            ("pair", [_, ..]) => self.product(&values),
            ("diff", [function, by @ ..]) => {
                let value = self.quantity(function);
                by.iter().fold(value, |value, variable| value.over(&self.quantity(variable)))
            }
            ("sqrt", [radicand]) => {
                self.quantity(radicand).power(&BigRational::new(BigInt::from(1), BigInt::from(2)))
            }
            ("norm" | "transpose", [array]) if index.is_none() => self.quantity(array),
            ("dot" | "cross", [_, _]) if self.theory.named(name).is_none() => self.product(&values),
            _ if METRIC_OPERATIONS.contains(&name) => self.metric_operation(name, index, &values),
            _ if COMMON_FUNCTIONS.contains(&name) && self.theory.named(name).is_some() => {
                self.composed(name, &values, span)
            }
            ("min" | "max" | "hypot", [first, second]) => self.extremum(name, [first, second], span),
            ("copysign", [size, sign]) => {
                self.quantity(sign);
                self.quantity(size)
            }
            ("sec" | "csc" | "cot", [angle]) => {
                let quantity = self.quantity(angle);
                self.pure(&quantity, angle.span, &format!("`{name}` takes a number"));
                Quantity::one()
            }
            _ => match Operation::named(name) {
                Some(operation) => self.operation(operation, &values, span),
                None => self.composed(name, &values, span),
            },
        }
    }

    /// Infers the unit of a call of a definition: that of its expression with the quantities of the
    /// values for its arguments.
    fn defined(&mut self, number: usize, values: &[&Expr], span: Span) -> Quantity {
        let definition = Arc::clone(&self.theory.definitions[number]);
        self.bodies += 1;
        if self.bodies > MOST_BODIES {
            return Quantity::Unstated;
        }
        let quantities: Vec<Quantity> = values.iter().map(|value| self.quantity(value)).collect();
        let errors = self.errors.len();
        let bound = definition.arguments.iter().cloned().zip(quantities).collect();
        let quantity = self.with_names(bound, &definition.value);
        for error in &mut self.errors[errors..] {
            error.related.get_or_insert_with(|| (span, format!("the call of `{}`", definition.name.text)));
        }
        quantity
    }

    /// Infers an expression in which some names have other quantities.
    fn with_names(&mut self, bound: Vec<(String, Quantity)>, expression: &Expr) -> Quantity {
        let replaced: Vec<(String, Option<Quantity>)> = bound
            .into_iter()
            .map(|(name, quantity)| (name.clone(), self.names.insert(name, quantity)))
            .collect();
        let quantity = self.quantity(expression);
        for (name, outside) in replaced.into_iter().rev() {
            match outside {
                Some(outside) => self.names.insert(name, outside),
                None => self.names.remove(&name),
            };
        }
        quantity
    }

    /// Infers `sum(q, k = 0..3)` or `product(q, k = 0..3)`; the index is a number.
    fn repeated(&mut self, name: &str, arguments: &[Argument]) -> Quantity {
        let [Argument::Value(term), Argument::Range { variable, .. }] = arguments else {
            return Quantity::Unstated;
        };
        let term = self.with_names(vec![(variable.text.clone(), Quantity::Number)], term);
        match term {
            Quantity::Stated(unit) if name == "product" && unit != Unit::one() => Quantity::Unstated,
            term => term,
        }
    }

    fn product(&mut self, factors: &[&Expr]) -> Quantity {
        factors.iter().fold(Quantity::Number, |product, factor| product.times(&self.quantity(factor)))
    }

    /// Infers the unit of an integral: the unit of a form is kept; the unit of a scalar is
    /// multiplied by the unit of each variable.
    fn integral(&mut self, arguments: &[Argument]) -> Quantity {
        let Some((Argument::Value(integrand), ranges)) = arguments.split_first() else {
            return Quantity::Unstated;
        };
        let mut integral = self.quantity(integrand);
        let is_form = match self.trace.get(&integrand.span) {
            Some(value) => matches!(value, Value::Form(_)),
            None => return Quantity::Unstated,
        };
        for range in ranges {
            let unit = self.range(range);
            if !is_form {
                integral = integral.times(&unit);
            }
        }
        integral
    }

    /// Infers the unit of `boundary_integral(F, w, u = a..b)`, which is the unit of w.
    fn boundary_integral(&mut self, arguments: &[Argument]) -> Quantity {
        let [_, Argument::Value(form), ranges @ ..] = arguments else { return Quantity::Unstated };
        ranges.iter().for_each(|range| {
            self.range(range);
        });
        self.quantity(form)
    }

    /// Returns the quantity of a range's variable, and checks that its bounds agree with it.
    fn range(&mut self, range: &Argument) -> Quantity {
        let Argument::Range { variable, from, to } = range else { return Quantity::Unstated };
        let unit = self.named(variable);
        for bound in [from, to] {
            let quantity = self.quantity(bound);
            let message = format!("the range of `{}` has a different unit", variable.text);
            self.alike((unit.clone(), "the variable"), (quantity, "the bound"), bound.span, &message);
        }
        unit
    }

    /// Returns the quantity of the coordinate, param or function with this name.
    fn named(&self, name: &Name) -> Quantity {
        self.names.get(&name.text).cloned().unwrap_or(Quantity::Unstated)
    }

    fn operation(&mut self, operation: Operation, arguments: &[&Expr], span: Span) -> Quantity {
        let quantities: Vec<Quantity> = arguments.iter().map(|argument| self.quantity(argument)).collect();
        let name = operation.row().name;
        let [first, rest @ ..] = quantities.as_slice() else { return Quantity::Unstated };
        match (operation, rest) {
            (Operation::Abs, []) => return first.clone(),
            (Operation::Cbrt, []) => return first.clone().power(&BigRational::new(1.into(), 3.into())),
            (Operation::Atan2, [second]) => {
                let message = "the arguments of `atan2` have different units";
                self.alike((first.clone(), "the first"), (second.clone(), "the second"), span, message);
            }
            _ => {
                for (argument, quantity) in arguments.iter().zip(&quantities) {
                    self.pure(quantity, argument.span, &format!("`{name}` takes a number"));
                }
            }
        }
        let is_number = |quantity: &Quantity| matches!(quantity, Quantity::Number | Quantity::Zero);
        if quantities.iter().all(is_number) {
            return Quantity::Number;
        }
        match operation {
            Operation::Asin | Operation::Acos | Operation::Atan | Operation::Atan2 => {
                Quantity::Stated(Unit::radian())
            }
            _ => Quantity::one(),
        }
    }

    /// Infers the unit of the smaller or larger of two quantities, which have one unit.
    fn extremum(&mut self, name: &str, values: [&Expr; 2], span: Span) -> Quantity {
        let [first, second] = values.map(|value| self.quantity(value));
        let message = format!("the arguments of `{name}` have different units");
        self.alike((first.clone(), "the first"), (second.clone(), "the second"), span, &message);
        match first {
            Quantity::Number | Quantity::Zero => second,
            first => first,
        }
    }

    /// Infers the unit of `L(a, b)`; each argument must be in the unit of its variable.
    fn composed(&mut self, function: &str, arguments: &[&Expr], span: Span) -> Quantity {
        match self.theory.named(function) {
            Some(&Named::Definition(number)) => return self.defined(number, arguments, span),
            Some(Named::Kernel(_)) => return self.kernel_value(function, arguments),
            _ => {}
        }
        let variables = self.arguments.get(function).cloned().unwrap_or_default();
        for (variable, argument) in variables.iter().zip(arguments) {
            let declared = self.names.get(variable).cloned().unwrap_or(Quantity::Unstated);
            let quantity = self.quantity(argument);
            let message = format!("`{function}` takes a different unit for `{variable}`");
            self.alike(
                (declared, &format!("`{variable}`")),
                (quantity, "the argument"),
                argument.span,
                &message,
            );
        }
        self.names.get(function).cloned().unwrap_or(Quantity::Unstated)
    }
}
