//! Operators on values: sums of values of one type, products of a scalar and any value, wedge
//! products, powers.

use super::evaluation::{Evaluated, Evaluator};
use crate::calculus::{Form, wedge};
use crate::diagnostic::{Diagnostic, Span};
use crate::expression::{Expr, Operation, Pool};
use crate::syntax::ast::{self, Binary};
use crate::theory::Value;
use num_rational::Ratio;
use num_traits::{Signed, ToPrimitive};

/// Largest numerator and denominator of an exponent.
const LARGEST_EXPONENT: i64 = 1_000_000;

/// Maximum number of products of terms in one wedge product.
const MOST_PRODUCTS: usize = 1_000_000;

impl Evaluator<'_> {
    pub(super) fn negated(&mut self, value: Value) -> Value {
        match value {
            Value::Zero => Value::Zero,
            Value::Scalar(a) => Value::Scalar(self.theory.pool.negate(a)),
            Value::Form(w) => Value::Form(w.negate(&mut self.ring())),
            Value::Field(x) => Value::Field(x.negate(&mut self.ring())),
            Value::Array(array) => self.mapped(array, Pool::negate),
        }
    }

    pub(super) fn binary(
        &mut self,
        operator: Binary,
        place: Span,
        (left, left_span): (Value, Span),
        right: &ast::Expr,
    ) -> Evaluated<Value> {
        if operator == Binary::Power {
            return self.power((left, left_span), right);
        }
        let right_value = self.value(right)?;
        match operator {
            Binary::Add => self.sum(left, right_value, place),
            Binary::Subtract if is_array(&left) || is_array(&right_value) => {
                self.entrywise("`-` needs sides of one shape", place, (left, right_value), Pool::subtract)
            }
            Binary::Subtract => {
                let negated = self.negated(right_value);
                self.sum(left, negated, place)
            }
            Binary::Multiply => self.product(left, right_value, place),
            Binary::Divide => self.quotient(left, right_value, right.span),
            Binary::Wedge => self.wedge_product(left, right_value, place),
            Binary::Power => Ok(left),
        }
    }

    pub(super) fn sum(&mut self, left: Value, right: Value, place: Span) -> Evaluated<Value> {
        match (left, right) {
            (Value::Zero, other) | (other, Value::Zero) => Ok(other),
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(self.theory.pool.add(a, b))),
            (a, b) if is_array(&a) || is_array(&b) => {
                self.entrywise("`+` needs sides of one shape", place, (a, b), Pool::add)
            }
            (Value::Form(a), Value::Form(b)) if a.degree() == b.degree() => {
                Ok(Value::Form(a.add(&mut self.ring(), &b)))
            }
            (Value::Field(a), Value::Field(b)) => Ok(Value::Field(a.add(&mut self.ring(), &b))),
            (a, b) => Err(unlike(&a, &b, "add", place)),
        }
    }

    pub(super) fn product(&mut self, left: Value, right: Value, place: Span) -> Evaluated<Value> {
        match (left, right) {
            (Value::Zero, other) | (other, Value::Zero) => Ok(self.zero_like(&other)),
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(self.theory.pool.multiply(a, b))),
            (Value::Scalar(a), Value::Form(w)) => Ok(Value::Form(w.scale(&mut self.ring(), &a))),
            (Value::Form(w), Value::Scalar(a)) => {
                let scaled = w.map(&mut self.ring(), |ring, value| ring.pool.multiply(*value, a));
                Ok(Value::Form(scaled))
            }
            (Value::Scalar(a), Value::Field(x)) | (Value::Field(x), Value::Scalar(a)) => {
                Ok(Value::Field(x.scale(&mut self.ring(), &a)))
            }
            (Value::Scalar(a), Value::Array(array)) => {
                Ok(self.mapped(array, |pool, entry| pool.multiply(a, entry)))
            }
            (Value::Array(array), Value::Scalar(b)) => {
                Ok(self.mapped(array, |pool, entry| pool.multiply(entry, b)))
            }
            (Value::Array(a), Value::Array(b)) => self.matrix_product(&a, &b, place),
            (Value::Form(_), Value::Form(_)) => {
                Err(Diagnostic::new(place, "`*` multiplies by scalars, and both sides are forms")
                    .with_help("use ^, the wedge product"))
            }
            (a, b) => Err(Diagnostic::new(place, format!("cannot multiply {} by {}", a.kind(), b.kind()))),
        }
    }

    /// Returns the zero of the same type as `value`.
    fn zero_like(&mut self, value: &Value) -> Value {
        match value {
            Value::Zero => Value::Zero,
            Value::Scalar(_) => Value::Scalar(self.zero()),
            Value::Form(form) => Value::Form(Form::zero(form.degree())),
            Value::Field(_) => Value::Field(crate::calculus::Field::zero()),
            Value::Array(array) => self.zeros(array.shape),
        }
    }

    pub(super) fn quotient(&mut self, left: Value, right: Value, right_span: Span) -> Evaluated<Value> {
        let divisor = match right {
            Value::Scalar(divisor) if !self.theory.pool.is_zero(divisor) => divisor,
            Value::Zero | Value::Scalar(_) => {
                return Err(Diagnostic::new(right_span, "division by zero"));
            }
            Value::Form(form) if form.is_zero() => {
                return Err(Diagnostic::new(
                    right_span,
                    format!("division by a {}-form that is zero", form.degree()),
                )
                .with_help("only scalars divide; take a coefficient with `w[dx]` first"));
            }
            other => {
                let help = match other {
                    Value::Array(_) => {
                        "only scalars divide; take an entry with `p[0]`, or the length `norm(p)`"
                    }
                    _ => "only scalars divide; take a coefficient with `w[dx]` first",
                };
                let message = format!("cannot divide by {}", other.kind());
                return Err(Diagnostic::new(right_span, message).with_help(help));
            }
        };
        let nonzero = self.theory.pool.quotient_domain(divisor);
        self.require(nonzero);
        Ok(match left {
            Value::Zero => Value::Zero,
            Value::Scalar(a) => Value::Scalar(self.theory.pool.divide(a, divisor)),
            Value::Form(w) => {
                Value::Form(w.map(&mut self.ring(), |ring, value| ring.pool.divide(*value, divisor)))
            }
            Value::Field(x) => {
                Value::Field(x.map(&mut self.ring(), |ring, value| ring.pool.divide(*value, divisor)))
            }
            Value::Array(array) => self.mapped(array, |pool, entry| pool.divide(entry, divisor)),
        })
    }

    fn wedge_product(&mut self, left: Value, right: Value, place: Span) -> Evaluated<Value> {
        match (left, right) {
            (Value::Form(a), Value::Form(b)) => {
                if a.terms().len().saturating_mul(b.terms().len()) > MOST_PRODUCTS {
                    return Err(Diagnostic::new(
                        place,
                        format!("the wedge product takes more than {MOST_PRODUCTS} products of terms"),
                    ));
                }
                Ok(Value::Form(wedge(&mut self.ring(), &a, &b)))
            }
            (Value::Scalar(_) | Value::Zero, Value::Scalar(_) | Value::Zero) => {
                Err(Diagnostic::new(place, "`^` is the wedge product, and both sides are scalars")
                    .with_help("use ** for powers and * for products of scalars"))
            }
            (Value::Field(_), _) | (_, Value::Field(_)) => Err(Diagnostic::new(
                place,
                "`^` is the wedge product of forms, and one side is a vector field",
            )
            .with_help("use * to multiply a field by a scalar")),
            (a, b) if is_array(&a) || is_array(&b) => {
                let array = if is_array(&a) { a } else { b };
                let message = format!("`^` is the wedge product of forms, and one side is {}", array.kind());
                Err(Diagnostic::new(place, message).with_help("use * for products with arrays"))
            }
            (a, b) => self.product(a, b, place),
        }
    }

    pub(super) fn power(
        &mut self,
        (base, base_span): (Value, Span),
        exponent: &ast::Expr,
    ) -> Evaluated<Value> {
        let base = match base {
            Value::Zero => self.zero(),
            Value::Scalar(base) => base,
            other => {
                return Err(Diagnostic::new(
                    base_span,
                    format!("`**` takes a scalar base, and this is {}", other.kind()),
                ));
            }
        };
        let written = self.scalar(exponent)?;
        let Some(number) = self.theory.pool.as_number(written).cloned() else {
            return Ok(Value::Scalar(self.general_power(base, written)));
        };
        let small = |part: &num_bigint::BigInt| part.to_i64().filter(|part| part.abs() <= LARGEST_EXPONENT);
        let (Some(p), Some(q)) = (small(number.numer()), small(number.denom())) else {
            return Err(Diagnostic::new(
                exponent.span,
                format!("the exponent is beyond the limit of {LARGEST_EXPONENT}"),
            ));
        };
        let exponent = Ratio::new(p, q);
        self.require_power(base, exponent);
        if self.theory.pool.is_zero(base) && exponent.is_negative() {
            return Err(Diagnostic::new(base_span, "division by zero: 0 has no negative power"));
        }
        Ok(Value::Scalar(self.theory.pool.power(base, exponent)))
    }

    /// Requires the conditions under which qʳ is real.
    pub(super) fn require_power(&mut self, base: Expr, exponent: Ratio<i64>) {
        let domain = self.theory.pool.power_domain(base, exponent);
        self.require(domain);
    }

    /// Returns q^e = exp(e log q) for q > 0.
    fn general_power(&mut self, base: Expr, exponent: Expr) -> Expr {
        let positive = self.theory.pool.operation_domain(Operation::Log, &[base]);
        self.require(positive);
        let logarithm = self.theory.pool.apply(Operation::Log, &[base]);
        let product = self.theory.pool.multiply(exponent, logarithm);
        self.theory.pool.apply(Operation::Exp, &[product])
    }
}

fn is_array(value: &Value) -> bool {
    matches!(value, Value::Array(_))
}

/// Returns the error for two operands whose types do not match.
pub(super) fn unlike(left: &Value, right: &Value, verb: &str, place: Span) -> Diagnostic {
    match (left, right) {
        (Value::Form(a), Value::Form(b)) => Diagnostic::new(
            place,
            format!("cannot {verb} forms of different degree: {} and {}", a.degree(), b.degree()),
        ),
        _ => Diagnostic::new(place, format!("cannot {verb} {} and {}", left.kind(), right.kind())),
    }
}
