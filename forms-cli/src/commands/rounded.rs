//! Values of a kernel in one of its generated precisions, or in the precision that its promised
//! accuracy requires.

use super::evaluation::{Computed, Evaluation, Unread};
use crate::decimal;
use forms::core::accuracy::{Format, Rounded as Text};
use forms::core::kernel::{Constant, Program};
use forms::math::{DoubleDouble, Real, Tier};
use num_rational::BigRational;

/// Number of significant digits of a double-double: more than its 106 bits, so that the digits
/// distinguish any two of them.
const DOUBLE_DOUBLE_DIGITS: u32 = 36;

/// Number type in which rows are read, computed and written.
pub(super) trait Number: Real {
    /// Name of the type in messages.
    const NAME: &'static str;
    /// Parses a text and rounds its value to the nearest number of this type.
    fn read(text: &str) -> Option<Self>;
    /// Formats the number with enough significant digits to distinguish any two numbers, at least
    /// seventeen.
    fn digits(self) -> String;
}

impl Number for f32 {
    const NAME: &'static str = "f32";

    fn read(text: &str) -> Option<Self> {
        if text.contains('/') {
            return Some(Constant::rational(decimal::exact(text)?).to_f32());
        }
        decimal::nearest(text)?;
        text.parse().ok()
    }

    fn digits(self) -> String {
        f64::from(self).digits()
    }
}

impl Number for f64 {
    const NAME: &'static str = "f64";

    fn read(text: &str) -> Option<Self> {
        decimal::nearest(text)
    }

    fn digits(self) -> String {
        if self.is_finite() { format!("{self:.16e}") } else { self.to_string() }
    }
}

impl Number for DoubleDouble {
    const NAME: &'static str = "double-double";

    fn read(text: &str) -> Option<Self> {
        let nearest = decimal::nearest(text)?;
        // Beyond the exact powers of ten only zero and infinity remain.
        let Some(exact) = decimal::exact(text) else { return Some(Self::from_f64(nearest)) };
        let words = Constant::rational(exact).words(2);
        Some(Self::constant(&words))
    }

    fn digits(self) -> String {
        let exact = |word: f64| BigRational::from_float(word);
        match exact(self.high()).zip(exact(self.low())) {
            Some((high, low)) => match Format::Digits(DOUBLE_DOUBLE_DIGITS).of(&(high + low)) {
                Text::Digits(digits) => digits,
                _ => self.high().digits(),
            },
            None => self.high().digits(),
        }
    }
}

/// Function from arguments to outputs; each output has a flag that is set if no precision was
/// sufficient.
type Compute<'a, T> = Box<dyn Fn(&[T]) -> Vec<(T, bool)> + 'a>;

/// Program whose numbers are read and written in one precision, and computed in this precision or a
/// higher one.
pub(super) struct Rounded<'a, T> {
    program: &'a Program,
    compute: Compute<'a, T>,
}

impl<'a, T: Number + 'a> Rounded<'a, T> {
    /// Creates a program that computes in this precision.
    pub(super) fn new(program: &'a Program) -> Self {
        let interpreter = program.interpreter();
        let compute = move |arguments: &[T]| {
            interpreter.values(arguments).into_iter().map(|value| (value, false)).collect()
        };
        Rounded { program, compute: Box::new(compute) }
    }
}

impl<'a> Rounded<'a, f64> {
    /// Creates a program whose values have the promised error bound, in units of 2⁻⁵³.
    pub(super) fn within(program: &'a Program, within: f64) -> Self {
        let compute = move |arguments: &[f64]| decided(program.interpret_with_tier(arguments, within));
        Rounded { program, compute: Box::new(compute) }
    }
}

impl<'a> Rounded<'a, DoubleDouble> {
    /// Creates a program whose values have at least 29 digits.
    pub(super) fn to_29_digits(program: &'a Program) -> Self {
        Rounded {
            program,
            compute: Box::new(|arguments| decided(program.interpret_double_double(arguments))),
        }
    }
}

/// Returns the outputs, each with a flag that is set if no precision was sufficient.
fn decided<T>(outputs: Vec<(T, Tier)>) -> Vec<(T, bool)> {
    outputs.into_iter().map(|(value, tier)| (value, tier == Tier::Undecided)).collect()
}

impl<T: Number> Evaluation for Rounded<'_, T> {
    type Number = T;

    fn name(&self) -> &str {
        self.program.name()
    }

    fn arguments(&self) -> &[String] {
        self.program.arguments()
    }

    fn columns(&self) -> Vec<String> {
        self.program.signature().columns(self.program.name())
    }

    fn read(&self, text: &str) -> Result<T, Unread> {
        let number = T::read(text).ok_or(Unread::NoNumber)?;
        if number.to_f64().is_finite() { Ok(number) } else { Err(Unread::TooLarge(T::NAME)) }
    }

    fn values(&self, arguments: &[T]) -> Vec<Computed> {
        let outputs = (self.compute)(arguments).into_iter();
        outputs.map(|(value, is_undecided)| Computed { text: value.digits(), is_undecided }).collect()
    }

    fn written(&self, argument: &T) -> String {
        argument.digits()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seventeen_digits_give_the_same_number_back() {
        for value in [0.1, 1.0 / 3.0, 5e-324, f64::MAX, -0.0] {
            assert_eq!(value.digits().parse::<f64>().map(f64::to_bits), Ok(value.to_bits()));
        }
        assert_eq!((f64::NAN.digits(), 0.5.digits()), ("NaN".into(), "5.0000000000000000e-1".into()));
        assert_eq!(f32::read("0.1").map(f32::digits), Some("1.0000000149011612e-1".to_string()));
    }

    #[test]
    fn a_double_double_is_read_and_written_in_thirty_six_digits() {
        for text in ["1/3", "3.33333333333333333333333333333333333e-1"] {
            let written = DoubleDouble::read(text).expect("a number").digits();
            assert!(
                written.starts_with("3.3333333333333333333333333333333") && written.len() == 40,
                "{written}"
            );
        }
        let value = DoubleDouble::new(0.7, 1e-18);
        assert_eq!(
            DoubleDouble::read(&value.digits()).map(|read| (read.high(), read.low())),
            Some((0.7, value.low()))
        );
        assert!(DoubleDouble::nan().digits() == "NaN" && DoubleDouble::read("x").is_none());
    }
}
