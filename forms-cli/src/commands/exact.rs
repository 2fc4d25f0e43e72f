//! Values of a kernel to fifty digits, at exact arguments.

use super::evaluation::{Computed, Evaluation, Unread};
use crate::decimal;
use crate::theory_file::TheoryFile;
use forms::core::accuracy::{Format, Rounded, Truth, Value};
use forms::core::expression::{Rational, Symbol};
use forms::core::theory::Kernel;

/// Number of significant digits in the output.
const DIGITS: u32 = 50;

/// Kernel whose formula is evaluated without rounding and rounded once at the end.
pub(super) struct Exact<'a> {
    kernel: &'a Kernel,
    truth: Truth<'a>,
    arguments: Vec<String>,
}

impl<'a> Exact<'a> {
    pub(super) fn new(file: &'a TheoryFile, kernel: &'a Kernel) -> Self {
        let pool = &file.theory.pool;
        let name = |&symbol: &Symbol| pool.symbol_name(symbol).to_string();
        Exact {
            kernel,
            truth: Truth::new(pool, &kernel.outputs, &kernel.domain),
            arguments: kernel.arguments.iter().map(name).collect(),
        }
    }
}

impl Evaluation for Exact<'_> {
    type Number = Rational;

    fn name(&self) -> &str {
        &self.kernel.name
    }

    fn arguments(&self) -> &[String] {
        &self.arguments
    }

    fn columns(&self) -> Vec<String> {
        self.kernel.signature.columns(&self.kernel.name)
    }

    fn read(&self, text: &str) -> Result<Rational, Unread> {
        decimal::exact(text).ok_or(Unread::NoNumber)
    }

    fn values(&self, arguments: &[Rational]) -> Vec<Computed> {
        let point: Vec<(Symbol, Rational)> =
            self.kernel.arguments.iter().copied().zip(arguments.iter().cloned()).collect();
        let values = self.truth.at(&point, Format::Digits(DIGITS));
        let output = |value: Value| {
            let is_undecided = matches!(value, Value::TooLarge | Value::Undecided);
            Computed { text: text(value), is_undecided }
        };
        values.into_iter().map(output).collect()
    }

    fn written(&self, argument: &Rational) -> String {
        text(Value::Known(Format::Digits(DIGITS).of(argument)))
    }
}

/// Formats a value: its digits; `NaN` outside the domain; `undecided` if no available precision
/// made the digits certain.
fn text(value: Value) -> String {
    match value {
        Value::Known(Rounded::Digits(digits)) => digits,
        Value::Known(_) | Value::TooLarge | Value::Undecided => "undecided".to_string(),
        Value::Undefined => "NaN".to_string(),
    }
}
