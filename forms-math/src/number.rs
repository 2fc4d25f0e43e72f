//! Exact numbers of a formula.

/// Non-zero number ± n/d · πᵏ with n and d of any length, and the first two words of its value.
///
/// ```
/// use forms_math::{Number, Real, Wide};
/// // 1/π, in `f64` and to seventy digits
/// let number = Number::new([std::f64::consts::FRAC_1_PI, -1.967_867_667_518_248_6e-17], &[1], &[1], -1);
/// assert_eq!(<f64 as Real>::number(number), std::f64::consts::FRAC_1_PI);
/// let product = Wide::<4>::number(number) * Wide::number(Number::new([3.0, 0.0], &[3], &[1], 1));
/// assert!((product - Wide::from_f64(3.0)).abs().to_f64() < 1e-70);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Number<'a> {
    words: [f64; 2],
    numerator: &'a [u64],
    denominator: &'a [u64],
    pi_exponent: i32,
}

impl<'a> Number<'a> {
    /// Creates n/d · πᵏ from the first two words of its value (the nearest `f64`, and the `f64`
    /// nearest to the remainder) and the words of n and d, the least significant first. The sign is
    /// that of the first word.
    pub const fn new(
        words: [f64; 2],
        numerator: &'a [u64],
        denominator: &'a [u64],
        pi_exponent: i32,
    ) -> Self {
        Self { words, numerator, denominator, pi_exponent }
    }

    /// Returns the nearest `f64`, and the `f64` nearest to the remainder.
    pub fn words(&self) -> &[f64; 2] {
        &self.words
    }

    /// Whether the number is negative.
    pub(crate) fn is_negative(&self) -> bool {
        self.words[0] < 0.0
    }

    /// Returns n, the least significant word first.
    pub(crate) fn numerator(&self) -> &'a [u64] {
        self.numerator
    }

    /// Returns d, the least significant word first.
    pub(crate) fn denominator(&self) -> &'a [u64] {
        self.denominator
    }

    /// Returns k.
    pub(crate) fn pi_exponent(&self) -> i32 {
        self.pi_exponent
    }
}
