//! Vectors and matrices of scalars: literals, entries, products and their functions.
//!
//! An array is the list of its entries by rows. An operation on arrays is the operations on their
//! entries, so that everything after resolution knows scalars only.

use super::arguments::exactly;
use super::evaluation::{Evaluated, Evaluator};
use crate::diagnostic::{Diagnostic, Span};
use crate::expression::{Expr, Pool, Shape};
use crate::syntax::ast;
use crate::theory::{Array, Value};
use num_rational::Ratio;
use num_traits::ToPrimitive;

impl Evaluator<'_> {
    /// Evaluates `[a, b, c]`, or a matrix by its rows `[[a, b], [c, d]]`.
    pub(super) fn array(&mut self, entries: &[ast::Expr]) -> Evaluated<Value> {
        let (mut all, mut rows): (Vec<Expr>, Option<Shape>) = (Vec::new(), None);
        for entry in entries {
            let (shape, numbers) = self.row(entry)?;
            match rows {
                Some(first) if first != shape => {
                    let message =
                        format!("an array has rows of one shape: the first is {first}, this is {shape}");
                    return Err(Diagnostic::new(entry.span, message));
                }
                _ => rows = Some(shape),
            }
            all.extend(numbers);
        }
        let shape = match rows {
            Some(Shape::Vector(columns)) => Shape::Matrix(entries.len(), columns),
            _ => Shape::Vector(entries.len()),
        };
        Ok(Value::Array(Array { shape, entries: all }))
    }

    /// Evaluates an entry of an array: a scalar, or a vector that is a row of a matrix.
    fn row(&mut self, entry: &ast::Expr) -> Evaluated<(Shape, Vec<Expr>)> {
        match self.numbers(entry)? {
            Value::Array(Array { shape: shape @ Shape::Vector(_), entries }) => Ok((shape, entries)),
            Value::Array(array) => {
                let message = format!("expected a scalar or a row of a matrix, found {}", array.shape);
                Err(Diagnostic::new(entry.span, message))
            }
            value => Ok((Shape::Number, vec![self.number(value)])),
        }
    }

    /// Evaluates an expression that must be a scalar or an array.
    pub(super) fn numbers(&mut self, expression: &ast::Expr) -> Evaluated<Value> {
        match self.value(expression)? {
            value @ (Value::Zero | Value::Scalar(_) | Value::Array(_)) => Ok(value),
            other => {
                Err(Diagnostic::new(expression.span, format!("expected a scalar, found {}", other.kind())))
            }
        }
    }

    /// Returns a scalar, or the scalar 0 for the literal zero.
    fn number(&mut self, value: Value) -> Expr {
        match value {
            Value::Scalar(scalar) => scalar,
            _ => self.zero(),
        }
    }

    /// Applies an operation of two scalars to each pair of entries; `need` opens the message for
    /// operands of different shapes.
    pub(super) fn entrywise(
        &mut self,
        need: &str,
        place: Span,
        (left, right): (Value, Value),
        operation: impl Fn(&mut Pool, Expr, Expr) -> Expr,
    ) -> Evaluated<Value> {
        let (left, right) = match (left, right) {
            (Value::Array(a), Value::Zero) => (Value::Array(a.clone()), self.zeros(a.shape)),
            (Value::Zero, Value::Array(b)) => (self.zeros(b.shape), Value::Array(b)),
            both => both,
        };
        match (left, right) {
            (Value::Array(a), Value::Array(b)) if a.shape == b.shape => {
                let pairs = a.entries.into_iter().zip(b.entries);
                let entries = pairs.map(|(a, b)| operation(&mut self.theory.pool, a, b)).collect();
                Ok(Value::Array(Array { shape: a.shape, entries }))
            }
            (a, b) if matches!(a, Value::Array(_)) || matches!(b, Value::Array(_)) => {
                let message = format!("{need}: the first is {}, the second is {}", a.kind(), b.kind());
                Err(Diagnostic::new(place, message))
            }
            (a, b) => {
                let (a, b) = (self.number(a), self.number(b));
                Ok(Value::Scalar(operation(&mut self.theory.pool, a, b)))
            }
        }
    }

    pub(super) fn zeros(&mut self, shape: Shape) -> Value {
        let zero = self.zero();
        Value::Array(Array { shape, entries: vec![zero; shape.entries()] })
    }

    /// Applies an operation to each entry.
    pub(super) fn mapped(&mut self, array: Array, operation: impl Fn(&mut Pool, Expr) -> Expr) -> Value {
        let entries =
            array.entries.into_iter().map(|entry| operation(&mut self.theory.pool, entry)).collect();
        Value::Array(Array { shape: array.shape, entries })
    }

    /// Returns the entry, or the row of a matrix, at these indices.
    pub(super) fn entry(&mut self, array: &Array, indices: &[ast::Expr]) -> Evaluated<Value> {
        let extents = array.shape.extents();
        if let Some(surplus) = indices.get(extents.len()) {
            let message = format!("{} has no index number {}", array.shape, extents.len() + 1);
            return Err(Diagnostic::new(surplus.span, message));
        }
        let mut start = 0;
        for (index, &extent) in indices.iter().zip(&extents) {
            start = start * extent + self.index(array.shape, index, extent)?;
        }
        let rest = Shape::of(&extents[indices.len()..]).unwrap_or_default();
        let count = rest.entries();
        Ok(Array::value(rest, array.entries[start * count..(start + 1) * count].to_vec()))
    }

    /// Evaluates an index, which must be an integer below `extent`.
    fn index(&mut self, shape: Shape, index: &ast::Expr, extent: usize) -> Evaluated<usize> {
        let value = self.scalar(index)?;
        let number = self.theory.pool.as_number(value).filter(|number| number.is_integer()).cloned();
        let Some(number) = number else {
            return Err(Diagnostic::new(index.span, "an index is an integer, as in `p[0]`"));
        };
        number.to_usize().filter(|&place| place < extent).ok_or_else(|| {
            let message =
                format!("the index {number} is out of range: indices of {shape} go from 0 to {}", extent - 1);
            Diagnostic::new(index.span, message)
        })
    }

    /// Returns the product of a matrix and a vector or matrix.
    pub(super) fn matrix_product(&mut self, left: &Array, right: &Array, place: Span) -> Evaluated<Value> {
        let (rows, inner, columns, shape) = match (left.shape, right.shape) {
            (Shape::Matrix(rows, inner), Shape::Matrix(same, columns)) if inner == same => {
                (rows, inner, columns, Shape::Matrix(rows, columns))
            }
            (Shape::Matrix(rows, inner), Shape::Vector(same)) if inner == same => {
                (rows, inner, 1, Shape::Vector(rows))
            }
            (a, b) => {
                let help = match (a, b) {
                    (Shape::Vector(_), Shape::Vector(_)) => "write `dot(p, q)` or `cross(p, q)`",
                    (Shape::Vector(_), Shape::Matrix(..)) => "a vector is a column: write `transpose(R)*p`",
                    _ => "the left factor has as many columns as the right factor has rows",
                };
                return Err(Diagnostic::new(place, format!("cannot multiply {a} by {b}")).with_help(help));
            }
        };
        let mut entries = Vec::with_capacity(shape.entries());
        for row in 0..rows {
            for column in 0..columns {
                let a: Vec<Expr> = (0..inner).map(|k| left.entries[row * inner + k]).collect();
                let b: Vec<Expr> = (0..inner).map(|k| right.entries[k * columns + column]).collect();
                entries.push(self.sum_of_products(&a, &b));
            }
        }
        Ok(Value::Array(Array { shape, entries }))
    }

    /// Σ aᵢ bᵢ
    fn sum_of_products(&mut self, a: &[Expr], b: &[Expr]) -> Expr {
        let pool = &mut self.theory.pool;
        let products: Vec<Expr> = a.iter().zip(b).map(|(&a, &b)| pool.multiply(a, b)).collect();
        let sum = products.into_iter().reduce(|sum, product| pool.add(sum, product));
        sum.unwrap_or_else(|| pool.integer(0))
    }

    /// Evaluates an argument of a function of vectors.
    fn vector(&mut self, function: &str, argument: &ast::Expr) -> Evaluated<Vec<Expr>> {
        match self.value(argument)? {
            Value::Array(Array { shape: Shape::Vector(_), entries }) => Ok(entries),
            other => {
                let message = format!("`{function}` takes vectors, and this is {}", other.kind());
                Err(Diagnostic::new(argument.span, message))
            }
        }
    }

    /// Evaluates two vectors with the same number of entries.
    fn vectors(
        &mut self,
        function: &str,
        arguments: &[&ast::Expr],
        span: Span,
    ) -> Evaluated<(Vec<Expr>, Vec<Expr>)> {
        let [left, right] = exactly::<2>(arguments, function, span)?;
        let (a, b) = (self.vector(function, left)?, self.vector(function, right)?);
        if a.len() == b.len() {
            return Ok((a, b));
        }
        let [a, b] = [a.len(), b.len()].map(Shape::Vector);
        let message = format!("`{function}` takes vectors of one length, and these are {a} and {b}");
        Err(Diagnostic::new(right.span, message))
    }

    /// Σ pᵢ qᵢ
    pub(super) fn dot(&mut self, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        let (a, b) = self.vectors("dot", arguments, span)?;
        Ok(Value::Scalar(self.sum_of_products(&a, &b)))
    }

    /// p × q
    pub(super) fn cross(&mut self, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        let (a, b) = self.vectors("cross", arguments, span)?;
        if a.len() != 3 {
            let message = format!("`cross` takes 3-vectors, and this is {}", Shape::Vector(a.len()));
            return Err(Diagnostic::new(span, message));
        }
        let pool = &mut self.theory.pool;
        let entries = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
            let (first, second) = (pool.multiply(a[i], b[j]), pool.multiply(a[j], b[i]));
            pool.subtract(first, second)
        });
        Ok(Value::Array(Array { shape: Shape::Vector(3), entries: entries.to_vec() }))
    }

    /// √(Σ pᵢ²)
    pub(super) fn euclidean_norm(&mut self, entries: &[Expr]) -> Value {
        let squares: Vec<Expr> =
            entries.iter().map(|&entry| self.theory.pool.power(entry, Ratio::from_integer(2))).collect();
        let sum = squares.into_iter().reduce(|sum, square| self.theory.pool.add(sum, square));
        let sum = sum.unwrap_or_else(|| self.zero());
        self.require_power(sum, Ratio::new(1, 2));
        Value::Scalar(self.theory.pool.sqrt(sum))
    }

    /// Evaluates `transpose(R)`.
    pub(super) fn transpose(&mut self, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        let [argument] = exactly::<1>(arguments, "transpose", span)?;
        match self.value(argument)? {
            Value::Array(Array { shape: Shape::Matrix(rows, columns), entries }) => {
                let places = (0..columns).flat_map(|column| (0..rows).map(move |row| row * columns + column));
                let entries = places.map(|place| entries[place]).collect();
                Ok(Value::Array(Array { shape: Shape::Matrix(columns, rows), entries }))
            }
            other => {
                let message = format!("`transpose` takes a matrix, and this is {}", other.kind());
                Err(Diagnostic::new(argument.span, message))
            }
        }
    }
}
