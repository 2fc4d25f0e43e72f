//! Integrals and special functions of known answers, nearly to the precision of `f64`.

use std::f64::consts::FRAC_PI_2;

/// Returns ∫ f from a to b by the substitution x = tanh(π/2 sinh t), which tolerates singular
/// derivatives at the ends. Source: H. Takahasi, M. Mori, Double exponential formulas for numerical
/// integration (1974).
pub(crate) fn integral([a, b]: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
    const STEP: f64 = 1.0 / 16.0;
    const STEPS: i32 = 56;
    let [middle, half] = [0.5 * (a + b), 0.5 * (b - a)];
    let term = |k: i32| {
        let t = STEP * f64::from(k);
        let y = FRAC_PI_2 * t.sinh();
        let weight = FRAC_PI_2 * t.cosh() / y.cosh().powi(2);
        let x = middle + half * y.tanh();
        if weight > 0.0 && x > a && x < b { weight * f(x) } else { 0.0 }
    };
    STEP * half * (-STEPS..=STEPS).map(term).sum::<f64>()
}

/// Returns the exponential integral Eₙ(x) = ∫ μⁿ⁻² e^(−x/μ) dμ over 0 to 1, for n of 2 and more.
pub(crate) fn exponential_integral(n: i32, x: f64) -> f64 {
    integral([0.0, 1.0], |mu| mu.powi(n - 2) * (-x / mu).exp())
}

/// Returns Fresnel's reflectance for unpolarised light, from the amplitudes in their usual form: n
/// is the index behind the boundary over the index in front of it.
pub(crate) fn fresnel(n: f64, cosine: f64) -> f64 {
    let squared = 1.0 - (1.0 - cosine * cosine) / (n * n);
    if squared <= 0.0 {
        return 1.0;
    }
    let bent = squared.sqrt();
    let s = (cosine - n * bent) / (cosine + n * bent);
    let p = (n * cosine - bent) / (n * cosine + bent);
    0.5 * (s * s + p * p)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integrals_have_their_closed_forms() {
        assert!((integral([0.0, 2.0], f64::exp) - (2.0_f64.exp() - 1.0)).abs() < 1e-13);
        assert!((integral([0.0, 1.0], f64::ln) + 1.0).abs() < 1e-12);
        // 2 E₃(1): Abramowitz and Stegun, table 5.1
        assert!((2.0 * exponential_integral(3, 1.0) - 0.219_383_934_395_520_27).abs() < 1e-13);
        assert!((exponential_integral(2, 0.5) - 0.326_643_862_324_553).abs() < 1e-13);
        // the diffuse reflectance of n = 1.5: Walsh's closed form
        let diffuse = integral([0.0, 1.0], |mu| 2.0 * mu * fresnel(1.5, mu));
        assert!((diffuse - 0.091_777_959_342_351_21).abs() < 1e-12, "{diffuse}");
    }
}
