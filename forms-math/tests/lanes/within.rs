//! Batches within a promised accuracy, compared with values of 256 bits and more: formulas that
//! cancel, choose and overflow, at arguments of all sizes and near hard points.

use crate::arguments::arguments;
use forms_math::{Formula, Instructions, Real, Wide, batch_within_by};

macro_rules! formulas {
    ($($name:ident: |$x:ident| $body:expr;)*) => { $(
        struct $name;
        impl Formula<1, 1> for $name {
            #[inline(always)]
            fn value<T: Real>([$x]: [T; 1]) -> [T; 1] {
                [$body]
            }
        }
    )* };
}

formulas! {
    Versine: |x| (T::from_f64(1.0) - x.cos()) / (x * x);
    Emission: |x| x.exp_m1() / x;
    Circular: |x| x.sin() * x.sin() + x.cos() * x.tan() - x.atan2(T::from_f64(2.0));
    Inverse: |x| (x.asin() + x.acos()).atan() - T::from_f64(1.0);
    Roots: |x| (x + T::from_f64(1.0)).sqrt() - x.sqrt() + x.power(1, 3) - x.power(-3, 2);
    Hyperbolic: |x| (x.sinh() - x.cosh() * x.tanh()) + x.cosh() - x.erf();
    Logarithms: |x| x.ln() * x.ln_1p() - x.exp().ln();
    Products: |x| T::difference_of_products(x, x + T::from_f64(1.0), x + x, x / T::from_f64(3.0));
    Chosen: |x| T::if_less(x.sin(), x.cos(), x.exp(), (x + T::from_f64(1.0)).abs().sqrt());
    Tails: |x| x.erfc() * (x * x).exp() - (x + T::from_f64(1.0)).erfc();
    Exchange: |x| x.expint3() * x.exp();
}

/// Asserts that the worst error is within the allowed one.
fn assert_within<F: Formula<1, 1>, const LIMBS: usize>(name: &str, from: f64, to: f64) {
    let x = arguments(from, to, 120, 5);
    let mut values = vec![0.0; x.len()];
    for (within, instructions) in
        [2.0, 5.0, 40.0].into_iter().zip(Instructions::available().into_iter().cycle())
    {
        batch_within_by::<F, 1, 1>(instructions, [&x], [&mut values], within)
            .expect("columns have one length");
        for (&x, &value) in x.iter().zip(&values) {
            let exact = F::value([Wide::<LIMBS>::from_f64(x)])[0];
            let difference = (Wide::from_f64(value) - exact).to_f64().abs();
            let allowed = exact.to_f64().abs().max(f64::MIN_POSITIVE) * within * 2f64.powi(-53);
            let undefined = exact.to_f64().is_nan() && value.is_nan();
            let too_large = exact.to_f64().is_infinite() && value == exact.to_f64();
            assert!(
                difference <= allowed || undefined || too_large,
                "{name} at {x:e} within {within}: {value:e}"
            );
        }
    }
}

#[test]
fn batches_keep_their_promise() {
    assert_within::<Versine, 16>("versine", 1e-100, 1e5);
    assert_within::<Emission, 8>("emission", -700.0, 700.0);
    assert_within::<Circular, 8>("circular", -1e5, 1e5);
    assert_within::<Tails, 8>("tails", -20.0, 20.0);
    assert_within::<Inverse, 8>("inverse", -1.0, 1.0);
    assert_within::<Roots, 16>("roots", 1e-200, 1e200);
    assert_within::<Hyperbolic, 8>("hyperbolic", -300.0, 300.0);
    assert_within::<Logarithms, 16>("logarithms", 1e-200, 700.0);
    assert_within::<Products, 8>("products", -1e150, 1e150);
    assert_within::<Chosen, 8>("chosen", -30.0, 30.0);
}

#[test]
fn special_functions_are_escalated() {
    assert_within::<Exchange, 4>("exchange", 0.1, 20.0);
}
