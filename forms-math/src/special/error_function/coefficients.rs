//! The polynomials and constants of erf in `f64`, with the constant term first; computed by `coefficients/lane.py`.
#![allow(clippy::approx_constant, reason = "coefficients are as the search found them")]

/// From here on erf x rounds to 1
pub(crate) const ERF_IS_ONE: f64 = 6.0;
/// 2/sqrt pi with what its rounding leaves
pub(crate) const TWO_OVER_ROOT_PI: [f64; 2] = [1.1283791670955126, 1.533545961316588e-17];
/// (erf x - 2 x/sqrt pi)/x^3 in x^2, of |x| <= 1
pub(crate) const ERF: [f64; 12] = [
    -0.37612638903183754,
    0.11283791670955111,
    -0.026866170645123838,
    0.005223977625303518,
    -0.0008548327010033328,
    0.00012055332214716276,
    -1.4925622504489842e-5,
    1.6461446656928561e-6,
    -1.6355118610877705e-7,
    1.4692484859133263e-8,
    -1.1500357159785296e-9,
    6.174097221305255e-11,
];
/// ln erfc(1 + t) of t >= 0, to where erf rounds to 1
pub(crate) const LN_ERFC: [f64; 19] = [
    -1.8496055099332482,
    -2.638967514234788,
    -0.8431072563586866,
    -0.04156109804159179,
    0.010033825371928505,
    -0.0019779025510959767,
    0.0002373224078962554,
    2.6278094448532506e-5,
    -2.715957480596495e-5,
    9.60960724352212e-6,
    -2.0605669406249576e-6,
    1.4353832208517946e-7,
    9.713692640519622e-8,
    -5.185047792207241e-8,
    1.4849384331745716e-8,
    -2.849581657658107e-9,
    3.660080614374357e-10,
    -2.8608882469579202e-11,
    1.0305267765735484e-12,
];
