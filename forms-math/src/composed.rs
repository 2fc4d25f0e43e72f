//! Functions that a number type composes from `elementary`, `special` and `quadrature`.

/// Special functions but erf and erfc with this number of bits, computed in a type of at least this precision.
macro_rules! special_functions {
    (@one $type:ty, $bits:expr, $name:ident, |$x:ident| $value:expr) => {
        fn $name(self) -> Self {
            let $x = $crate::composed::Widen::<$type>::widened(self);
            $crate::composed::Widen::<$type>::narrowed($value)
        }
    };
    ($type:ty, $bits:expr) => {
        $crate::composed::special_functions!(@one $type, $bits, expint1, |x| crate::special::exponential_integral(1, x, $bits));
        $crate::composed::special_functions!(@one $type, $bits, expint2, |x| crate::special::exponential_integral(2, x, $bits));
        $crate::composed::special_functions!(@one $type, $bits, expint3, |x| crate::special::exponential_integral(3, x, $bits));
        $crate::composed::special_functions!(@one $type, $bits, dilog, |x| crate::special::dilogarithm(x, $bits));
        $crate::composed::special_functions!(@one $type, $bits, clausen, |x| crate::special::clausen(x, $bits));
    };
}
pub(crate) use special_functions;

/// Conversion to a type with more bits, and back.
pub(crate) trait Widen<Wider>: Sized {
    /// Converts the number exactly.
    fn widened(self) -> Wider;
    /// Rounds to the nearest number.
    fn narrowed(wider: Wider) -> Self;
}

impl<T> Widen<T> for T {
    fn widened(self) -> T {
        self
    }
    fn narrowed(wider: T) -> T {
        wider
    }
}

/// Functions that a type of higher precision takes from `elementary` and `special`, its quadrature,
/// and its choices.
macro_rules! composed_functions {
    () => {
        fn power(self, numerator: i64, denominator: i64) -> Self {
            crate::elementary::rational_power(self, numerator, denominator)
        }
        $crate::scalar::choices!();
        fn sin(self) -> Self {
            self.sine_and_cosine().0
        }
        fn cos(self) -> Self {
            self.sine_and_cosine().1
        }
        fn tan(self) -> Self {
            let (sine, cosine) = self.sine_and_cosine();
            sine / cosine
        }
        fn asin(self) -> Self {
            crate::elementary::arc_sine(self)
        }
        fn acos(self) -> Self {
            crate::elementary::arc_cosine(self)
        }
        fn atan(self) -> Self {
            crate::elementary::arc_tangent(self)
        }
        fn atan2(self, x: Self) -> Self {
            crate::elementary::angle(self, x)
        }
        fn ln(self) -> Self {
            crate::elementary::logarithm(self)
        }
        fn ln_1p(self) -> Self {
            crate::elementary::logarithm_of_one_plus(self)
        }
        fn sinh(self) -> Self {
            crate::elementary::hyperbolic_sine(self)
        }
        fn cosh(self) -> Self {
            crate::elementary::hyperbolic_cosine(self)
        }
        fn tanh(self) -> Self {
            crate::elementary::hyperbolic_tangent(self)
        }
        $crate::composed::special_functions!(Self, Self::PRECISION);
        fn hypot(self, y: Self) -> Self {
            crate::elementary::hypotenuse(self, y)
        }
        fn quadrature(from: Self, to: Self, integrand: impl Fn(Self) -> Self) -> Self {
            let kind = crate::quadrature::Kind {
                of: |node| node,
                number: |value: Self| value,
                bits: Self::PRECISION,
            };
            crate::quadrature::double_exponential(from, to, integrand, &kind).0
        }
    };
}
pub(crate) use composed_functions;
