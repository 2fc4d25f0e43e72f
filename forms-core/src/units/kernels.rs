//! Units of the arguments and results of kernels, gradients of kernels and warps.

use super::inference::{Inference, Signature};
use super::quantity::Quantity;
use crate::diagnostic::{Diagnostic, counted};
use crate::syntax::ast::{Declared, Expr, Item, ItemKind, Name, Warp};
use crate::theory::{KernelUnits, Named};

impl Inference<'_> {
    /// Infers the units of a kernel. The names of its arguments are local unless they are declared
    /// elsewhere.
    pub(super) fn kernel(&mut self, kind: &ItemKind) {
        let ItemKind::Kernel { name, arguments, units, outputs, computed, conditions, effects, .. } = kind
        else {
            return;
        };
        let outside = self.names.clone();
        arguments.iter().for_each(|argument| self.variable(argument));
        self.check_count(name, units, outputs);
        let subject = |place: usize| match outputs.len() {
            1 => format!("the result of `{}`", name.text),
            _ => format!("result {} of `{}`", place + 1, name.text),
        };
        let results: Vec<Quantity> = outputs
            .iter()
            .enumerate()
            .map(|(place, output)| self.declared_value(&subject(place), units.get(place), output))
            .collect();
        for (place, (computed, result)) in computed.iter().zip(&results).enumerate() {
            let quantity = self.quantity(computed);
            let message = format!("the form after `by` has a different unit than {}", subject(place));
            let formula = (result.clone(), "the formula");
            self.alike(formula, (quantity, "the form after `by`"), computed.span, &message);
        }
        self.conditions(conditions);
        effects.iter().for_each(|effect| self.effect(effect));
        let arguments = self.known(arguments);
        self.sign(&name.text, Signature { arguments, outputs: results });
        self.names = outside;
    }

    /// Checks that the number of units, if any are stated, equals the number of results.
    fn check_count(&mut self, name: &Name, units: &[Expr], outputs: &[Expr]) {
        if units.is_empty() || units.len() == outputs.len() {
            return;
        }
        let place = units.iter().fold(units[0].span, |all, unit| all.to(unit.span));
        let (results, units) = (counted(outputs.len(), "result"), counted(units.len(), "unit"));
        self.errors.push(Diagnostic::new(place, format!("`{}` has {results} and {units}", name.text)));
    }

    /// Infers the units of a gradient: the unit of the output divided by the unit of the variable.
    pub(super) fn gradient(&mut self, name: &Name, of: &Name, by: &[Name]) {
        let Some(Signature { arguments, outputs }) = self.signatures.get(&of.text).cloned() else { return };
        let quantity = |variable: &Name| {
            let known = arguments.iter().find(|(argument, _)| *argument == variable.text);
            known.map_or(Quantity::Unstated, |known| known.1.clone())
        };
        let variables: Vec<Quantity> = by.iter().map(quantity).collect();
        let quotients =
            |output: &Quantity| variables.iter().map(|by| output.clone().over(by)).collect::<Vec<_>>();
        let outputs = outputs.iter().flat_map(quotients).collect();
        self.sign(&name.text, Signature { arguments, outputs });
    }

    /// Infers the units of a warp: of its map, its claims, and its kernels.
    pub(super) fn warp(&mut self, item: &Item, warp: &Warp) {
        let outside = self.names.clone();
        warp.parameters.iter().chain(&warp.uniforms).for_each(|argument| self.variable(argument));
        for (uniform, quantity) in self.known(&warp.uniforms) {
            self.names.insert(format!("d{uniform}"), quantity);
        }
        self.map(&warp.target, &warp.components);
        self.map(&warp.target, &warp.computed);
        // the sign of a claim makes no difference to its units
        warp.claims(item, false).iter().for_each(|claim| self.item(claim));
        let density = self.quantity(&warp.density);
        let inverse = warp.inverse.iter().map(|value| self.quantity(value)).collect();
        let components = warp.components.iter().map(|value| self.quantity(value)).collect();
        let (parameters, uniforms) = (self.known(&warp.parameters), self.known(&warp.uniforms));
        let target = self.coordinates_of(&warp.target);
        let with = |others: &[(String, Quantity)]| [parameters.as_slice(), others].concat();
        for (part, arguments, outputs) in [
            ("sample", with(&uniforms), components),
            ("pdf", with(&target), vec![density]),
            ("inverse", with(&target), inverse),
        ] {
            self.sign(&warp.part(part).text, Signature { arguments, outputs });
        }
        self.names = outside;
    }

    /// Returns the coordinates of a chart with their units.
    fn coordinates_of(&self, chart: &Name) -> Vec<(String, Quantity)> {
        let Some(Named::Chart(number)) = self.theory.named(&chart.text) else { return Vec::new() };
        let coordinates = &self.theory.charts[*number].coordinates;
        let names = coordinates.iter().map(|coordinate| self.theory.coordinate_name(*coordinate).to_owned());
        names
            .map(|name| (name.clone(), self.names.get(&name).cloned().unwrap_or(Quantity::Unstated)))
            .collect()
    }

    fn known(&self, declared: &[Declared]) -> Vec<(String, Quantity)> {
        let quantity = |name: &str| self.names.get(name).cloned().unwrap_or(Quantity::Unstated);
        declared.iter().map(|Declared { name, .. }| (name.text.clone(), quantity(&name.text))).collect()
    }

    /// Records the signature of a kernel, and its units for display.
    fn sign(&mut self, name: &str, signature: Signature) {
        let written = |quantity: &Quantity| quantity.unit().map(|unit| unit.to_string());
        let units = KernelUnits {
            arguments: signature.arguments.iter().map(|(_, quantity)| written(quantity)).collect(),
            outputs: signature.outputs.iter().map(written).collect(),
        };
        self.kernels.push((name.to_owned(), units));
        self.signatures.insert(name.to_owned(), signature);
    }
}
