//! Formulas with one function each.

use forms_math::{Formula, Real};

macro_rules! functions {
    ($($formula:ident: $name:ident;)*) => { $(
        pub(crate) struct $formula;
        impl Formula<1, 1> for $formula {
            #[inline(always)]
            fn value<T: Real>([x]: [T; 1]) -> [T; 1] {
                [x.$name()]
            }
        }
    )* };
}

functions! {
    Exp: exp;
    ExpM1: exp_m1;
    Ln: ln;
    Ln1p: ln_1p;
    Sin: sin;
    Cos: cos;
    Tan: tan;
    Asin: asin;
    Acos: acos;
    Atan: atan;
    Sinh: sinh;
    Cosh: cosh;
    Tanh: tanh;
    Erf: erf;
    Clausen: clausen;
    Erfc: erfc;
    Cbrt: cbrt;
}

/// x^(N/D)
pub(crate) struct Power<const N: i64, const D: i64>;
impl<const N: i64, const D: i64> Formula<1, 1> for Power<N, D> {
    #[inline(always)]
    fn value<T: Real>([x]: [T; 1]) -> [T; 1] {
        [x.power(N, D)]
    }
}
