//! `sum(q, k = 0..3)` and `product(q, k = 0..3)`: one term for each integer from the lower bound to
//! the upper bound, both included.

use super::evaluation::{Evaluated, Evaluator};
use crate::diagnostic::{Diagnostic, Span};
use crate::syntax::ast::{self, Argument};
use crate::theory::Value;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// Maximum number of terms of one sum or product.
const MOST_TERMS: usize = 1_000;

impl Evaluator<'_> {
    /// Evaluates a sum or product by all its terms; an empty sum is 0, an empty product 1.
    pub(super) fn repeated(&mut self, name: &str, arguments: &[Argument], span: Span) -> Evaluated<Value> {
        let [Argument::Value(term), Argument::Range { variable, from, to }] = arguments else {
            let message = format!("`{name}` takes a term and one range: {name}(k**2, k = 0..3)");
            return Err(Diagnostic::new(span, message));
        };
        let (from, to) = (self.bound(name, from)?, self.bound(name, to)?);
        let count: BigInt = (&to - &from + 1_i32).max(BigInt::from(0));
        let Some(terms) = count.to_usize().filter(|&terms| terms <= MOST_TERMS) else {
            let message = format!("`{name}` has {count} terms, more than the limit of {MOST_TERMS}");
            return Err(Diagnostic::new(span, message));
        };
        let is_sum = name == "sum";
        let mut total = None;
        for step in 0..terms {
            self.bindings.count(span)?;
            let place = self.theory.pool.number(BigRational::from_integer(&from + BigInt::from(step)));
            let value = if self.theory.pool.is_zero(place) { Value::Zero } else { Value::Scalar(place) };
            let next = self.with_bound(&variable.text, value, |evaluator| evaluator.value(term))?;
            total = Some(match total {
                None => next,
                Some(total) if is_sum => self.sum(total, next, term.span)?,
                Some(total) => self.product(total, next, term.span)?,
            });
            self.check_size(span)?;
        }
        let empty = if is_sum { Value::Zero } else { Value::Scalar(self.theory.pool.integer(1)) };
        Ok(total.unwrap_or(empty))
    }

    /// Evaluates a bound, which must be an integer.
    fn bound(&mut self, name: &str, bound: &ast::Expr) -> Evaluated<BigInt> {
        let value = self.scalar(bound)?;
        match self.theory.pool.as_number(value).filter(|number| number.is_integer()) {
            Some(number) => Ok(number.to_integer()),
            None => Err(Diagnostic::new(
                bound.span,
                format!("the bounds of `{name}` are integers, as in `k = 0..3`"),
            )),
        }
    }
}
