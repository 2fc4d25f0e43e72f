//! Functions that are written by others.
//!
//! ```text
//! min(a, b) = (a + b − |a − b|)/2      copysign(a, b) = |a| b/|b|      sec q = 1/cos q
//! max(a, b) = (a + b + |a − b|)/2                                      csc q = 1/sin q, cot q = cos q/sin q
//! ```

use super::arguments::{exactly, wrong_count};
use super::evaluation::{Evaluated, Evaluator};
use crate::diagnostic::Span;
use crate::expression::{Expr, Extremum, Operation};
use crate::syntax::ast;
use crate::theory::Value;

impl Evaluator<'_> {
    fn scalars<const N: usize>(
        &mut self,
        arguments: &[&ast::Expr],
        name: &str,
        span: Span,
    ) -> Evaluated<[Expr; N]> {
        let arguments = exactly::<N>(arguments, name, span)?;
        let mut values = [self.zero(); N];
        for (value, argument) in values.iter_mut().zip(arguments) {
            *value = self.scalar(argument)?;
        }
        Ok(values)
    }

    /// Evaluates `min(a, b)` or `max(a, b)`.
    pub(super) fn extremum(
        &mut self,
        which: Extremum,
        arguments: &[&ast::Expr],
        span: Span,
    ) -> Evaluated<Value> {
        let name = if which == Extremum::Least { "min" } else { "max" };
        if arguments.len() > 2 {
            let help = format!("write `{name}({name}(a, b), c)` for three numbers");
            return Err(wrong_count(name, 2, arguments.len(), span).with_help(help));
        }
        let [a, b] = self.scalars(arguments, name, span)?;
        Ok(Value::Scalar(self.theory.pool.extremum(which, a, b)))
    }

    /// Evaluates `copysign(a, b)`. It has no value for b = 0: the number 0 has no sign.
    pub(super) fn copied_sign(&mut self, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        let [a, b] = self.scalars(arguments, "copysign", span)?;
        let [size, divisor] = [a, b].map(|q| self.theory.pool.apply(Operation::Abs, &[q]));
        let sign = self.over(b, divisor);
        Ok(Value::Scalar(self.theory.pool.multiply(size, sign)))
    }

    /// Evaluates `sec(q)` or `csc(q)`, 1 divided by this function.
    pub(super) fn reciprocal_of(
        &mut self,
        operation: Operation,
        name: &str,
        arguments: &[&ast::Expr],
        span: Span,
    ) -> Evaluated<Value> {
        let [angle] = self.scalars(arguments, name, span)?;
        let (one, divisor) = (self.theory.pool.integer(1), self.theory.pool.apply(operation, &[angle]));
        Ok(Value::Scalar(self.over(one, divisor)))
    }

    /// Evaluates `cot(q)`.
    pub(super) fn cotangent(&mut self, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        let [angle] = self.scalars(arguments, "cot", span)?;
        let [cosine, sine] =
            [Operation::Cos, Operation::Sin].map(|wave| self.theory.pool.apply(wave, &[angle]));
        Ok(Value::Scalar(self.over(cosine, sine)))
    }

    fn over(&mut self, a: Expr, divisor: Expr) -> Expr {
        let domain = self.theory.pool.quotient_domain(divisor);
        self.require(domain);
        self.theory.pool.divide(a, divisor)
    }
}
