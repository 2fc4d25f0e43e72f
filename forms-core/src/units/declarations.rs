//! Units of items: of the declared names, and of the sides of claims.

use super::inference::Inference;
use super::quantity::Quantity;
use super::unit::Unit;
use super::{agreement, reading};
use crate::diagnostic::{Diagnostic, Span};
use crate::syntax::ast::{Condition, Declared, Effect, Expr, Item, ItemKind, Name};
use crate::theory::Named;

impl Inference<'_> {
    pub(super) fn item(&mut self, item: &Item) {
        match &item.kind {
            ItemKind::Chart { coordinates: declared, conditions, .. }
            | ItemKind::Param { names: declared, conditions } => {
                declared.iter().for_each(|declared| self.variable(declared));
                self.conditions(conditions);
            }
            ItemKind::ProductChart { conditions, .. } => self.conditions(conditions),
            ItemKind::Function { name, arguments, unit, conditions } => {
                self.function(name, arguments, unit.as_ref());
                self.conditions(conditions);
            }
            ItemKind::Let { name, unit, value } | ItemKind::Form { name, unit, value, .. } => {
                let quantity = self.declared_value(&format!("`{}`", name.text), unit.as_ref(), value);
                self.names.insert(name.text.clone(), quantity);
            }
            ItemKind::Field { name, value, .. } | ItemKind::Metric { name, value, .. } => {
                let quantity = self.quantity(value);
                self.names.insert(name.text.clone(), quantity);
            }
            ItemKind::Map { target, components, .. } => self.map(target, components),
            ItemKind::Statement { name, left, right, conditions, .. } => {
                self.statement(item.span, name, (left, right), conditions);
            }
            ItemKind::Kernel { .. } => self.kernel(&item.kind),
            // a definition has the units of the values in the place of its arguments
            ItemKind::Definition { .. } => {}
            ItemKind::Derivatives { name, which, of, by } => self.derivatives(name, *which, of, by),
            ItemKind::Warp(warp) => self.warp(item, warp),
        }
    }

    fn statement(
        &mut self,
        span: Span,
        name: &Name,
        (left, right): (&Expr, &Expr),
        conditions: &[Condition],
    ) {
        let errors = self.errors.len();
        let quantities = (self.quantity(left), self.quantity(right));
        let message = format!("`{}` equates different units", name.text);
        let place = left.span.to(right.span);
        self.alike((quantities.0, "the left side"), (quantities.1, "the right side"), place, &message);
        self.conditions(conditions);
        if self.errors.len() > errors {
            self.meaningless.push(span);
        }
    }

    pub(super) fn conditions(&mut self, conditions: &[Condition]) {
        conditions.iter().for_each(|condition| self.condition(condition));
    }

    /// Reads a unit as written; `Unstated` if it cannot be read.
    fn stated(&mut self, unit: Option<&Expr>) -> Quantity {
        match unit.map(reading::unit) {
            None => Quantity::Unstated,
            Some(Ok(unit)) => Quantity::Stated(unit),
            Some(Err(error)) => {
                self.errors.push(error);
                Quantity::Unstated
            }
        }
    }

    /// Declares a coordinate, param or argument. A name that was declared before keeps its unit.
    pub(super) fn variable(&mut self, Declared { name, unit, .. }: &Declared) {
        let stated = self.stated(unit.as_ref());
        let place = unit.as_ref().map_or(name.span, |unit| unit.span);
        match self.names.get(&name.text) {
            Some(Quantity::Stated(known)) => {
                if let Quantity::Stated(unit) = &stated
                    && unit.meaning() != known.meaning()
                {
                    let message = format!("`{}` is declared in {known} above, and here in {unit}", name.text);
                    self.errors.push(Diagnostic::new(place, message));
                }
            }
            _ => {
                self.names.insert(name.text.clone(), stated);
            }
        }
    }

    fn function(&mut self, name: &Name, arguments: &[Name], unit: Option<&Expr>) {
        let stated = self.stated(unit);
        self.names.insert(name.text.clone(), stated);
        let arguments = arguments.iter().map(|argument| argument.text.clone()).collect();
        self.arguments.insert(name.text.clone(), arguments);
    }

    /// Infers a value, checks it against its declared unit, and returns the declared unit if there
    /// is one; `subject` names the value.
    pub(super) fn declared_value(&mut self, subject: &str, unit: Option<&Expr>, value: &Expr) -> Quantity {
        let declared = self.stated(unit);
        let quantity = self.quantity(value);
        let Quantity::Stated(wanted) = &declared else { return quantity };
        match &quantity {
            Quantity::Stated(found) if !agreement::admits(wanted, found) => {
                self.refuse_value(subject, wanted, found, value.span);
            }
            _ => {}
        }
        declared
    }

    fn refuse_value(&mut self, subject: &str, wanted: &Unit, found: &Unit, place: Span) {
        let message = format!("{subject} is declared in {wanted}, and its value is in {found}");
        let advice = agreement::advice(wanted, found, ("the declaration", "the value"));
        self.errors.push(Diagnostic::new(place, message).with_help(advice));
    }

    /// Checks that each component is in the unit of its target coordinate.
    pub(super) fn map(&mut self, target: &Name, components: &[Expr]) {
        let theory = self.theory;
        let coordinates = match theory.named(&target.text) {
            Some(Named::Chart(number)) => theory.charts[*number].coordinates.as_slice(),
            _ => &[],
        };
        for (place, component) in components.iter().enumerate() {
            let quantity = self.quantity(component);
            let Some(coordinate) = coordinates.get(place) else { continue };
            let coordinate = theory.coordinate_name(*coordinate);
            let declared = self.names.get(coordinate).cloned().unwrap_or(Quantity::Unstated);
            let message = format!("the component for `{coordinate}` has a different unit");
            self.alike((declared, "the coordinate"), (quantity, "the component"), component.span, &message);
        }
    }

    /// Checks an effect such as `absorption: sigma_a = 0`.
    pub(super) fn effect(&mut self, effect: &Effect) {
        let variable = self.names.get(&effect.variable.text).cloned().unwrap_or(Quantity::Unstated);
        let value = self.quantity(&effect.value);
        let message = format!("the effect `{}` compares different units", effect.name.text);
        self.alike((variable, "the variable"), (value, "the value"), effect.value.span, &message);
    }
}
