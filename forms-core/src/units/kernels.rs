//! Units of the arguments and results of kernels, derivatives of kernels and warps.

use super::inference::{Inference, Signature};
use super::quantity::Quantity;
use crate::diagnostic::{Diagnostic, counted};
use crate::expression::Shape;
use crate::syntax::ast::{Declared, Derivatives, Expr, Item, ItemKind, Name, Warp};
use crate::theory::{KernelUnits, Named};

impl Inference<'_> {
    /// Infers the units of a kernel. The names of its arguments are local unless they are declared
    /// elsewhere.
    pub(super) fn kernel(&mut self, kind: &ItemKind) {
        let ItemKind::Kernel {
            name,
            arguments,
            units,
            outputs,
            computed,
            target_forms,
            conditions,
            effects,
            ..
        } = kind
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
        let forms = std::iter::once(computed).chain(target_forms.iter().map(|form| &form.computed));
        for (place, (computed, result)) in forms.flat_map(|form| form.iter().zip(&results).enumerate()) {
            let quantity = self.quantity(computed);
            let message = format!("the form after `by` has a different unit than {}", subject(place));
            let formula = (result.clone(), "the formula");
            self.alike(formula, (quantity, "the form after `by`"), computed.span, &message);
        }
        self.conditions(conditions);
        effects.iter().for_each(|effect| self.effect(effect));
        let arguments = self.known(arguments);
        let outputs = self.of_numbers(name, results);
        self.sign(&name.text, Signature { arguments, outputs });
        self.names = outside;
    }

    /// Returns the quantity of each number in the results of a kernel, given one for each result:
    /// the entries of an array have one unit.
    fn of_numbers(&self, kernel: &Name, results: Vec<Quantity>) -> Vec<Quantity> {
        let Some(Named::Kernel(number)) = self.theory.named(&kernel.text) else { return results };
        let shapes = &self.theory.kernels[*number].signature.results;
        let pairs = results.into_iter().zip(shapes);
        pairs.flat_map(|(quantity, shape)| vec![quantity; shape.entries()]).collect()
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

    /// Infers the units of derivatives: the unit of the output divided by the unit of the variable.
    pub(super) fn derivatives(&mut self, name: &Name, which: Derivatives, of: &Name, by: &[Name]) {
        let Some(Signature { arguments, outputs }) = self.signatures.get(&of.text).cloned() else { return };
        let quantities = |variable: &Name| {
            let names = self.numbers_of(of, variable);
            let quantity = |name: &String| {
                let known = arguments.iter().find(|(argument, _)| argument == name);
                known.map_or(Quantity::Unstated, |known| known.1.clone())
            };
            names.iter().map(quantity).collect::<Vec<_>>()
        };
        let variables: Vec<Quantity> = by.iter().flat_map(quantities).collect();
        let quotients =
            |output: &Quantity| variables.iter().map(|by| output.clone().over(by)).collect::<Vec<_>>();
        let derivatives: Vec<Quantity> = outputs.iter().flat_map(quotients).collect();
        let outputs = match which {
            Derivatives::ValueAndJacobian => [outputs, derivatives].concat(),
            Derivatives::Gradient | Derivatives::Jacobian => derivatives,
        };
        self.sign(&name.text, Signature { arguments, outputs });
    }

    /// Returns the names of the numbers in an argument of a kernel.
    fn numbers_of(&self, kernel: &Name, argument: &Name) -> Vec<String> {
        let own = vec![argument.text.clone()];
        let Some(Named::Kernel(number)) = self.theory.named(&kernel.text) else { return own };
        let parameters = &self.theory.kernels[*number].signature.parameters;
        let parameter = parameters.iter().find(|parameter| parameter.name == argument.text);
        parameter.map_or(own, |parameter| parameter.shape.names(&parameter.name))
    }

    /// Infers the unit of a call of a kernel; each argument must be in the unit of its parameter.
    pub(super) fn kernel_value(&mut self, kernel: &str, values: &[&Expr]) -> Quantity {
        let (Some(signature), Some(Named::Kernel(number))) =
            (self.signatures.get(kernel).cloned(), self.theory.named(kernel))
        else {
            return Quantity::Unstated;
        };
        let parameters = self.theory.kernels[*number].signature.parameters.clone();
        let mut first = 0;
        for (parameter, value) in parameters.iter().zip(values) {
            let declared = signature.arguments.get(first).map_or(Quantity::Unstated, |known| known.1.clone());
            first += parameter.shape.entries();
            let quantity = self.quantity(value);
            let message = format!("`{kernel}` takes a different unit for `{}`", parameter.name);
            let name = format!("`{}`", parameter.name);
            self.alike((declared, &name), (quantity, "the argument"), value.span, &message);
        }
        self.common(signature.outputs)
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
        let numbers = |Declared { name, extents, .. }: &Declared| {
            let names = Shape::of(extents).unwrap_or_default().names(&name.text);
            names.into_iter().map(|number| (number, quantity(&name.text))).collect::<Vec<_>>()
        };
        declared.iter().flat_map(numbers).collect()
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
