//! Ordinals of floating-point numbers, which count the numbers between two of them.

/// Floating-point format of arguments and of the comparison of results.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Width {
    /// `f32`
    Single,
    /// `f64`
    Double,
}

impl Width {
    /// Returns the number of bits of a number, which is the loss of a result that is not a number.
    pub fn bits(self) -> f64 {
        match self {
            Width::Single => 32.0,
            Width::Double => 64.0,
        }
    }

    /// Returns the number of digits of the mantissa.
    pub(super) fn mantissa(self) -> i32 {
        match self {
            Width::Single => f32::MANTISSA_DIGITS as i32,
            Width::Double => f64::MANTISSA_DIGITS as i32,
        }
    }

    /// Returns n such that powers of two from −n to n are normal numbers.
    pub(super) fn largest_exponent(self) -> i32 {
        match self {
            Width::Single => f32::MAX_EXP - 2,
            Width::Double => f64::MAX_EXP - 2,
        }
    }

    /// Returns the nearest number of this width.
    pub fn round(self, value: f64) -> f64 {
        match self {
            Width::Single => f64::from(value as f32),
            Width::Double => value,
        }
    }

    /// Returns the position of a number in the order of all numbers, with 0 at zero.
    pub(crate) fn ordinal(self, value: f64) -> i64 {
        let magnitude = match self {
            Width::Single => i64::from((value as f32).abs().to_bits()),
            Width::Double => value.abs().to_bits() as i64,
        };
        if value.is_sign_negative() { -magnitude } else { magnitude }
    }

    /// Returns the number at a position.
    pub(crate) fn at(self, ordinal: i64) -> f64 {
        let magnitude = match self {
            Width::Single => f64::from(f32::from_bits(ordinal.unsigned_abs() as u32)),
            Width::Double => f64::from_bits(ordinal.unsigned_abs()),
        };
        if ordinal < 0 { -magnitude } else { magnitude }
    }

    /// Returns the largest finite number.
    pub(super) fn largest(self) -> f64 {
        match self {
            Width::Single => f64::from(f32::MAX),
            Width::Double => f64::MAX,
        }
    }

    /// Returns the distance between neighbours at a value: the unit in the last place (ulp).
    pub(super) fn unit(self, value: f64) -> f64 {
        let rounded = self.round(value.abs()).min(self.largest());
        let next = self.ordinal(rounded) + 1;
        if next > self.ordinal(self.largest()) {
            rounded - self.at(next - 2)
        } else {
            self.at(next) - rounded
        }
    }

    /// Returns log₂(1 + the number of steps from one number to the other); all bits if the computed
    /// one is not a number.
    pub fn bits_between(self, computed: f64, exact: f64) -> f64 {
        if computed.is_nan() {
            return self.bits();
        }
        let steps = self.ordinal(computed).abs_diff(self.ordinal(exact));
        (1.0 + steps as f64).log2()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_are_one_bit_apart() {
        for width in [Width::Single, Width::Double] {
            for value in [0.0, 1.0, -1.0, 1e-30, -3.5e20, width.largest()] {
                let value = width.round(value);
                let below = width.at(width.ordinal(value) - 1);
                assert!(below < value);
                assert_eq!(width.bits_between(below, value), 1.0, "{value}");
                assert_eq!(width.bits_between(value, value), 0.0);
            }
            assert_eq!(width.bits_between(-0.0, 0.0), 0.0);
            assert_eq!(width.bits_between(f64::NAN, 1.0), width.bits());
        }
        assert_eq!(Width::Double.unit(1.0), f64::EPSILON);
        assert_eq!(Width::Single.unit(-1.5), f64::from(f32::EPSILON));
    }

    #[test]
    fn an_infinite_result_is_as_far_as_the_numbers_between() {
        let bits = Width::Double.bits_between(f64::INFINITY, 1.0);
        assert!((61.9..62.1).contains(&bits), "{bits}");
    }
}
