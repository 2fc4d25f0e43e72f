//! Values of the language: scalars, forms, fields, arrays of scalars, and the literal zero of any
//! type.

use crate::calculus::{Blade, Field, Form};
use crate::expression::{Expr, Shape};

/// Value of an expression of the language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// Literal `0`, the zero of any type and degree.
    Zero,
    /// Scalar.
    Scalar(Expr),
    /// Form of degree 1 or more.
    Form(Form<Expr>),
    /// Vector field.
    Field(Field<Expr>),
    /// Vector or matrix of scalars.
    Array(Array),
}

/// Vector or matrix of scalars.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Array {
    /// Its shape, not that of a number.
    pub shape: Shape,
    /// Its entries by rows, as many as the shape has.
    pub entries: Vec<Expr>,
}

impl Array {
    /// Returns an array, or the scalar for the shape of a number.
    pub(crate) fn value(shape: Shape, entries: Vec<Expr>) -> Value {
        match (shape, entries.as_slice()) {
            (Shape::Number, [scalar]) => Value::Scalar(*scalar),
            _ => Value::Array(Array { shape, entries }),
        }
    }
}

impl Value {
    /// Converts a form to a value; a form of degree 0 becomes a scalar.
    pub(crate) fn from_form(form: Form<Expr>, zero: Expr) -> Self {
        if form.degree() > 0 {
            return Value::Form(form);
        }
        Value::Scalar(form.coefficient(Blade::SCALAR).copied().unwrap_or(zero))
    }

    /// Describes its type in words.
    pub fn kind(&self) -> String {
        match self {
            Value::Zero => "0".into(),
            Value::Scalar(_) => "a scalar".into(),
            Value::Form(form) => format!("a {}-form", form.degree()),
            Value::Field(_) => "a vector field".into(),
            Value::Array(array) => array.shape.to_string(),
        }
    }

    /// Returns every scalar it consists of.
    pub fn scalars(&self) -> Vec<Expr> {
        match self {
            Value::Zero => vec![],
            Value::Scalar(value) => vec![*value],
            Value::Form(form) => form.terms().iter().map(|term| term.1).collect(),
            Value::Field(field) => field.components().map(|component| *component.1).collect(),
            Value::Array(array) => array.entries.clone(),
        }
    }
}
