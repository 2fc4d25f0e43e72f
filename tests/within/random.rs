//! Random kernels: terms of two arguments, as text and as values of another library.

use crate::points::Dice;
use astro_float::{BigFloat, Consts, RoundingMode};

/// Functions available in kernels and in the other library.
const FUNCTIONS: [&str; 14] = [
    "sqrt", "exp", "log", "sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "abs", "expm1", "log1p",
    "asin",
];

/// Precision of the other library, in bits.
const BITS: usize = 4608;
const ROUNDING: RoundingMode = RoundingMode::None;

/// Term of a formula.
pub(crate) enum Term {
    Argument(usize),
    Number(u64, u64),
    Pi,
    Binary(char, Box<[Term; 2]>),
    Power(Box<Term>, i64),
    Function(&'static str, Box<Term>),
}

impl Term {
    pub(crate) fn random(number: u64) -> Term {
        let mut dice = Dice::of(0x5eed_0000 + number);
        let depth = 2 + dice.below(3);
        Self::of_depth(&mut dice, depth)
    }

    fn of_depth(dice: &mut Dice, depth: u64) -> Term {
        if depth == 0 {
            return match dice.below(6) {
                0 => Term::Number(1 + dice.below(9), 1 + dice.below(9)),
                1 if dice.below(3) == 0 => Term::Pi,
                k => Term::Argument(usize::from(k > 3)),
            };
        }
        let depth = depth - 1;
        match dice.below(10) {
            0..6 => {
                let operation = ['+', '-', '-', '*', '/'][dice.below(5) as usize];
                Term::Binary(operation, Box::new([(); 2].map(|()| Self::of_depth(dice, depth))))
            }
            6 => Term::Power(Box::new(Self::of_depth(dice, depth)), dice.below(7) as i64 - 3),
            _ => {
                let name = FUNCTIONS[dice.below(FUNCTIONS.len() as u64) as usize];
                Term::Function(name, Box::new(Self::of_depth(dice, depth)))
            }
        }
    }

    /// Returns the text of a kernel with a promise.
    pub(crate) fn kernel(&self, within: usize) -> String {
        format!("kernel k(x, y) = {} within {within};", self.text())
    }

    fn text(&self) -> String {
        match self {
            Term::Argument(place) => ["x", "y"][*place].to_string(),
            Term::Number(p, q) => format!("({p}/{q})"),
            Term::Pi => "pi".to_string(),
            Term::Binary(operation, sides) => {
                format!("({} {operation} {})", sides[0].text(), sides[1].text())
            }
            Term::Power(base, exponent) => format!("({})**({exponent})", base.text()),
            Term::Function(name, argument) => format!("{name}({})", argument.text()),
        }
    }

    /// Computes the value with the other library; `None` where it is undefined or exceeds the range
    /// of exponents.
    pub(crate) fn value(&self, arguments: &[f64; 2], constants: &mut Consts) -> Option<BigFloat> {
        let (p, rm) = (BITS, ROUNDING);
        let one = BigFloat::from_i64(1, p);
        let value = match self {
            Term::Argument(place) => exactly(arguments[*place]),
            Term::Number(above, below) => {
                BigFloat::from_u64(*above, p).div(&BigFloat::from_u64(*below, p), p, rm)
            }
            Term::Pi => constants.pi(p, rm),
            Term::Binary(operation, sides) => {
                let [a, b] = [sides[0].value(arguments, constants)?, sides[1].value(arguments, constants)?];
                match operation {
                    '+' => a.add(&b, p, rm),
                    '-' => a.sub(&b, p, rm),
                    '*' => a.mul(&b, p, rm),
                    _ => a.div(&b, p, rm),
                }
            }
            Term::Power(base, exponent) => {
                let power = base.value(arguments, constants)?.powi(exponent.unsigned_abs() as usize, p, rm);
                if *exponent < 0 { one.div(&power, p, rm) } else { power }
            }
            Term::Function(name, argument) => {
                let x = argument.value(arguments, constants)?;
                match *name {
                    "sqrt" => x.sqrt(p, rm),
                    "exp" => x.exp(p, rm, constants),
                    "expm1" => x.exp(p, rm, constants).sub(&one, p, rm),
                    "log" => x.ln(p, rm, constants),
                    "log1p" => x.add(&one, p, rm).ln(p, rm, constants),
                    "sin" => x.sin(p, rm, constants),
                    "cos" => x.cos(p, rm, constants),
                    "tan" => x.sin(p, rm, constants).div(&x.cos(p, rm, constants), p, rm),
                    "atan" => x.atan(p, rm, constants),
                    "asin" => x.asin(p, rm, constants),
                    "sinh" => x.sinh(p, rm, constants),
                    "cosh" => x.cosh(p, rm, constants),
                    "tanh" => x.tanh(p, rm, constants),
                    _ => x.abs(),
                }
            }
        };
        (!value.is_nan() && !value.is_inf()).then_some(value)
    }
}

/// Converts a number for the other library, which does not read subnormal numbers correctly: those
/// are scaled first.
fn exactly(value: f64) -> BigFloat {
    let scale = if value.abs() < 1e-290 { 512 } else { 0 };
    let scaled = BigFloat::from_f64(value * 2.0_f64.powi(scale), BITS);
    scaled.mul(&BigFloat::from_f64(0.5, BITS).powi(scale as usize, BITS, ROUNDING), BITS, ROUNDING)
}
