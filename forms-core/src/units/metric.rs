//! Units of operations that take a metric.
//!
//! With g = gᵢⱼ dxⁱ dxʲ in the unit G, the inverse gⁱʲ ∂ᵢ ∂ⱼ is in 1/G and the volume √|det g| dx¹
//! ∧ … ∧ dxⁿ in G^(n/2). So raising an index divides by G, and by a ∧ ⋆b = ⟨a, b⟩ volume the factor
//! of ⋆ on k-forms is G^(n/2 − k).

use super::inference::Inference;
use super::quantity::Quantity;
use crate::syntax::ast::{Expr, ExprKind};
use crate::theory::{Named, Value};
use num_bigint::BigInt;
use num_rational::BigRational;

/// Returns k/2.
fn half(k: i64) -> BigRational {
    BigRational::new(BigInt::from(k), BigInt::from(2))
}

impl Inference<'_> {
    /// Infers the unit of `volume[g]`.
    pub(super) fn volume(&self, index: &Expr) -> Quantity {
        let (metric, dimension) = self.metric(index);
        metric.power(&half(dimension))
    }

    /// Infers the unit of `hodge[g](w)` and the other operations that take a metric.
    pub(super) fn metric_operation(
        &mut self,
        name: &str,
        index: Option<&Expr>,
        arguments: &[&Expr],
    ) -> Quantity {
        let (Some(index), [argument, rest @ ..]) = (index, arguments) else { return Quantity::Unstated };
        let (metric, dimension) = self.metric(index);
        let quantity = self.quantity(argument);
        // Twice the exponent of G in the inner product of two such values: 2 for fields, −2k for k-forms.
        let inner = match self.trace.get(&argument.span) {
            Some(Value::Field(_)) => 2,
            Some(Value::Form(form)) => -2 * i64::from(form.degree()),
            Some(Value::Scalar(_) | Value::Zero | Value::Array(_)) => 0,
            None => return Quantity::Unstated,
        };
        let twice_exponent = match name {
            "hodge" => dimension + inner,
            "codiff" | "laplace" | "sharp" | "grad" => -2,
            "flat" => 2,
            "div" => 0,
            "curl" => -1,
            "norm" => inner / 2,
            "inner" => inner,
            _ => return Quantity::Unstated,
        };
        let product = rest.iter().fold(quantity, |product, factor| product.times(&self.quantity(factor)));
        product.times(&metric.power(&half(twice_exponent)))
    }

    /// Returns the quantity of a metric, and its dimension.
    fn metric(&self, index: &Expr) -> (Quantity, i64) {
        let ExprKind::Name(name) = &*index.kind else { return (Quantity::Unstated, 0) };
        match self.theory.named(name) {
            Some(Named::Metric(number)) => {
                let quantity = self.names.get(name).cloned().unwrap_or(Quantity::Unstated);
                (quantity, i64::from(self.theory.metrics[*number].metric.dimension()))
            }
            _ => (Quantity::Unstated, 0),
        }
    }
}
