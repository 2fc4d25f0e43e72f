//! Units of function calls.

use super::inference::Inference;
use super::quantity::Quantity;
use super::unit::Unit;
use crate::diagnostic::Span;
use crate::expression::Operation;
use crate::syntax::ast::{Argument, Expr, Name};
use crate::syntax::words::METRIC_OPERATIONS;
use crate::theory::Value;
use num_bigint::BigInt;
use num_rational::BigRational;

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
            _ if METRIC_OPERATIONS.contains(&name) => self.metric_operation(name, index, &values),
            _ => match Operation::named(name) {
                Some(operation) => self.operation(operation, &values, span),
                None => self.composed(name, &values),
            },
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

    /// Infers the unit of `L(a, b)`; each argument must be in the unit of its variable.
    fn composed(&mut self, function: &str, arguments: &[&Expr]) -> Quantity {
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
