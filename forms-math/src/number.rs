//! Numbers of a formula, exactly.

/// ± n/d · πᵏ other than zero, of any length, with the first two words of its value.
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
    /// n/d · πᵏ with the least significant words of n and d first, the sign that of the first word: the nearest `f64`,
    /// and the nearest of what that leaves.
    pub const fn new(
        words: [f64; 2],
        numerator: &'a [u64],
        denominator: &'a [u64],
        pi_exponent: i32,
    ) -> Self {
        Self { words, numerator, denominator, pi_exponent }
    }

    /// The nearest `f64`, and the nearest of what that leaves.
    pub fn words(&self) -> &[f64; 2] {
        &self.words
    }

    /// True below zero.
    pub(crate) fn is_negative(&self) -> bool {
        self.words[0] < 0.0
    }

    /// n, the least significant word first.
    pub(crate) fn numerator(&self) -> &'a [u64] {
        self.numerator
    }

    /// d, the least significant word first.
    pub(crate) fn denominator(&self) -> &'a [u64] {
        self.denominator
    }

    /// k
    pub(crate) fn pi_exponent(&self) -> i32 {
        self.pi_exponent
    }
}
