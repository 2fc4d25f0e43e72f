//! Kernels made of the derivatives of an earlier kernel.
//!
//! ```text
//! grad(f; u, v)                ∂f₀/∂u, ∂f₀/∂v, ∂f₁/∂u, …      as one list
//! jacobian(f; u, v)            the same by rows: one for each number of f, one column for each of u, v
//! value_and_jacobian(f; u, v)  f, then its Jacobian matrix
//! ```
//! The kernels have the arguments and the domain of f. A Jacobian matrix of one number is its row,
//! by one number its column, and of one number by one number the derivative.

use super::evaluation::Evaluated;
use super::items::Resolver;
use crate::diagnostic::Diagnostic;
use crate::expression::{Expr, Node, Pool, Shape, Signature, Symbol};
use crate::syntax::ast::{Derivatives, Item, ItemKind, Name};
use crate::theory::names::unusable;
use crate::theory::{Kernel, KernelUnits, Named, describe};

impl Resolver {
    /// Resolves `kernel g = grad(f; u, v);` and its variants. The form given by `by` is
    /// differentiated as well, unless it is piecewise or an approximation.
    pub(super) fn derivatives(&mut self, item: &Item) -> Evaluated<()> {
        let ItemKind::Derivatives { name, which, of, by } = &item.kind else { return Ok(()) };
        self.theory.names.declare(name, Named::Pending)?;
        let kernel = self.differentiated(of)?;
        let mut variables = Vec::new();
        for variable in by {
            variables.extend(self.variables_of(&kernel, variable)?);
        }
        let pool = &mut self.theory.pool;
        let derivatives = jacobian(pool, &kernel.outputs, &variables);
        let by_form = jacobian(pool, &kernel.computed, &variables);
        // a piece that holds at a single point does not determine the derivative there, and the
        // derivative of an approximation can be far from that of the formula
        let is_piecewise = |part: &Expr| matches!(pool.node(*part), Node::Select { .. });
        let is_lost = kernel.approximation.is_some() || pool.reachable(&by_form).iter().any(is_piecewise);
        let by_form = if is_lost { Vec::new() } else { by_form };
        let (mut outputs, mut computed) = (derivatives, by_form);
        if *which == Derivatives::ValueAndJacobian {
            if !kernel.computed.is_empty() {
                let derivatives = if computed.is_empty() { &outputs } else { &computed };
                computed = kernel.computed.iter().chain(derivatives).copied().collect();
            }
            outputs = kernel.outputs.iter().chain(&outputs).copied().collect();
        }
        let results = shapes(*which, &kernel.signature, kernel.outputs.len(), variables.len());
        let formula = self.theory.pool.texts(&outputs);
        let (name_text, docs) = (name.text.clone(), item.docs.clone());
        let parameters = kernel.signature.parameters.clone();
        let approximation = kernel.approximation.clone();
        let of_this = Kernel { name: name_text, docs, public: item.public, span: item.span, ..kernel };
        self.theory.kernels.push(Kernel {
            signature: Signature { parameters, results },
            outputs,
            approximation: approximation.filter(|_| !computed.is_empty()),
            computed,
            target_forms: Vec::new(),
            within: None,
            effects: Vec::new(),
            formula,
            units: KernelUnits::default(),
            statements: Vec::new(),
            ..of_this
        });
        self.theory.names.set(name, Named::Kernel(self.theory.kernels.len() - 1));
        Ok(())
    }

    /// Returns the kernel to differentiate.
    fn differentiated(&self, of: &Name) -> Evaluated<Kernel> {
        match self.theory.named(&of.text) {
            Some(Named::Kernel(number)) => Ok(self.theory.kernels[*number].clone()),
            Some(named @ (Named::Pending | Named::Poisoned)) => Err(unusable(named, &of.text, of.span)),
            Some(other) => {
                let message = format!("expected a kernel, but `{}` is {}", of.text, describe(other));
                Err(Diagnostic::new(of.span, message))
            }
            None => Err(self.theory.names.unknown(&of.text, of.span, "`kernel`")),
        }
    }

    /// Returns the variables of an argument of a kernel: all entries of an array, or one number,
    /// which can be an entry (`p_0`).
    fn variables_of(&self, kernel: &Kernel, variable: &Name) -> Evaluated<Vec<Symbol>> {
        let mut rest = kernel.arguments.as_slice();
        for parameter in &kernel.signature.parameters {
            let (own, others) = rest.split_at(parameter.shape.entries());
            if parameter.name == variable.text {
                return Ok(own.to_vec());
            }
            rest = others;
        }
        let is_named = |symbol: &&Symbol| self.theory.pool.symbol_name(**symbol) == variable.text;
        kernel.arguments.iter().find(is_named).map(|&symbol| vec![symbol]).ok_or_else(|| {
            let message = format!("`{}` is not an argument of `{}`", variable.text, kernel.name);
            Diagnostic::new(variable.span, message)
        })
    }
}

/// Returns the derivatives of each value by each variable, by rows.
fn jacobian(pool: &mut Pool, values: &[Expr], variables: &[Symbol]) -> Vec<Expr> {
    let pairs = values.iter().flat_map(|&value| variables.iter().map(move |&by| (value, by)));
    pairs.map(|(value, by)| pool.derivative(value, by)).collect()
}

/// Returns the shapes of the results, for a kernel with `outputs` numbers and derivatives by
/// `variables` numbers.
fn shapes(which: Derivatives, of: &Signature, outputs: usize, variables: usize) -> Vec<Shape> {
    let is_one_number = of.results == [Shape::Number];
    let matrix = match (is_one_number, variables) {
        (true, 1) => Shape::Number,
        (true, columns) => Shape::Vector(columns),
        (false, 1) => Shape::Vector(outputs),
        (false, columns) => Shape::Matrix(outputs, columns),
    };
    match which {
        Derivatives::Gradient => vec![Shape::Number; outputs * variables],
        Derivatives::Jacobian => vec![matrix],
        Derivatives::ValueAndJacobian => of.results.iter().copied().chain([matrix]).collect(),
    }
}
