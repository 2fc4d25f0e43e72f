//! The polynomials and constants of the functions of lanes; computed by `coefficients/lane.py`.
#![allow(clippy::approx_constant, reason = "coefficients are as the search found them")]

use crate::special::error_function;

/// The numbers of one floating-point format; polynomials have their constant term first.
pub(crate) struct Coefficients<W: 'static> {
    /// From here on erf x rounds to 1
    pub(crate) erf_is_one: W,
    /// 1/ln 2
    pub(crate) log2_e: W,
    /// ln 2, the first part times any exponent being exact
    pub(crate) ln_2: &'static [W],
    /// 2/pi
    pub(crate) two_over_pi: W,
    /// pi/2, all parts but the last times any multiple in reach being exact
    pub(crate) half_pi: &'static [W],
    /// pi/4, pi/2, 3 pi/4 and pi, each with what its rounding leaves
    pub(crate) quarters_pi: &'static [W],
    /// 2/sqrt pi with what its rounding leaves
    pub(crate) two_over_root_pi: &'static [W],
    /// 2/3 with what its rounding leaves
    pub(crate) two_thirds: &'static [W],
    /// (e^r - 1 - r)/r^2 of -(ln 2)/2 <= r <= ln(3/2)
    pub(crate) exp: &'static [W],
    /// (sinh r - r)/r^3 in r^2, of |r| <= (ln 2)/2
    pub(crate) sinh: &'static [W],
    /// (cosh r - 1 - r^2/2)/r^4 in r^2, of |r| <= (ln 2)/2
    pub(crate) cosh: &'static [W],
    /// (2 artanh s - 2 s)/s^3 in s^2, of |s| <= (sqrt 2 - 1)/(sqrt 2 + 1)
    pub(crate) ln: &'static [W],
    /// (2 artanh s - 2 s - 2 s^3/3)/s^5 in s^2, on the same interval
    pub(crate) ln_tail: &'static [W],
    /// (sin r - r)/r^3 in r^2, of |r| <= pi/4
    pub(crate) sin: &'static [W],
    /// (cos r - 1 + r^2/2)/r^4 in r^2, of |r| <= pi/4
    pub(crate) cos: &'static [W],
    /// Up to here angles are taken from an axis, beyond from the diagonal: the tangent of a little over 1/2
    pub(crate) atan_limit: W,
    /// (atan t - t)/t^3 in t^2, of |t| to that limit
    pub(crate) atan: &'static [W],
    /// (asin t - t)/t^3 in t^2, of |t| <= 1/2
    pub(crate) asin: &'static [W],
    /// (erf x - 2 x/sqrt pi)/x^3 in x^2, of |x| <= 1
    pub(crate) erf: &'static [W],
    /// ln erfc(1 + t) of t >= 0, to where erf rounds to 1
    pub(crate) ln_erfc: &'static [W],
    /// From here on erfc x rounds to 0
    pub(crate) erfc_is_zero: W,
    /// (x + 2) e^(x^2) erfc x in (x - 2)/(x + 2), of x >= 0, to where erfc rounds to 0
    pub(crate) erfc: &'static [W],
}

/// Of `f64`.
pub(crate) const F64: Coefficients<f64> = Coefficients {
    erf_is_one: error_function::ERF_IS_ONE,
    log2_e: 1.4426950408889634,
    ln_2: &[0.6931471805598903, 5.497923018708371e-14],
    two_over_pi: 0.6366197723675814,
    half_pi: &[1.5707963267341256, 6.077100506303966e-11, 2.0222662487111665e-21, 8.4784276603689e-32],
    quarters_pi: &[
        0.7853981633974483,
        3.061616997868383e-17,
        1.5707963267948966,
        6.123233995736766e-17,
        2.356194490192345,
        9.184850993605148e-17,
        3.141592653589793,
        1.2246467991473532e-16,
    ],
    two_over_root_pi: &error_function::TWO_OVER_ROOT_PI,
    two_thirds: &[0.6666666666666666, 3.700743415417188e-17],
    exp: &[
        0.5,
        0.16666666666666674,
        0.04166666666666779,
        0.00833333333332382,
        0.001388888888813156,
        0.00019841269881086534,
        2.480158906891578e-5,
        2.755724925118096e-6,
        2.75556370521794e-7,
        2.5107194896698344e-8,
        2.144996279113605e-9,
    ],
    sinh: &[
        0.16666666666666669,
        0.008333333333330039,
        0.00019841269863171557,
        2.7557268276905696e-6,
        2.5100472505694996e-8,
    ],
    cosh: &[
        0.041666666666666664,
        0.0013888888888886537,
        2.4801587317228724e-5,
        2.7557282838800484e-7,
        2.09112987659402e-9,
    ],
    ln: &[
        0.6666666666666666,
        0.4000000000000088,
        0.2857142857080285,
        0.22222222391887064,
        0.18181795621632782,
        0.15386240708969665,
        0.13268746195596595,
        0.13086907887965027,
    ],
    ln_tail: &[
        0.4,
        0.2857142857142937,
        0.2222222222165554,
        0.1818181833547124,
        0.15384594954137945,
        0.13334805149611875,
        0.11706224135460942,
        0.11723306234080849,
    ],
    sin: &[
        -0.16666666666666666,
        0.008333333333333331,
        -0.0001984126984126506,
        2.7557319219335453e-6,
        -2.5052106231157904e-8,
        1.605853141458901e-10,
        -7.586685070091267e-13,
    ],
    cos: &[
        0.041666666666666664,
        -0.0013888888888887395,
        2.4801587298763433e-5,
        -2.7557317270560326e-7,
        2.0876146024689747e-9,
        -1.1382614868556325e-11,
    ],
    atan_limit: 0.5464,
    atan: &[
        -0.3333333333333333,
        0.19999999999996626,
        -0.14285714285079068,
        0.11111111063952855,
        -0.09090907264830352,
        0.07692265409952283,
        -0.0666603429769302,
        0.05875959697021711,
        -0.052183319491048666,
        0.04541505328697895,
        -0.03588435573458297,
        0.021842181871589934,
        -0.007206364144420144,
    ],
    asin: &[
        0.16666666666666669,
        0.07499999999998433,
        0.04464285714635543,
        0.030381944138531247,
        0.02237217294214989,
        0.017352392720869973,
        0.013971212973552933,
        0.011479177415184906,
        0.01032281435018578,
        0.005457506718640358,
        0.01740087944269402,
        -0.014851887071247204,
        0.028757851367421566,
    ],
    erf: &error_function::ERF,
    ln_erfc: &error_function::LN_ERFC,
    erfc_is_zero: error_function::ERFC_IS_ZERO,
    erfc: &error_function::ERFC,
};

/// Of `f32`.
pub(crate) const F32: Coefficients<f32> = Coefficients {
    erf_is_one: 4.0,
    log2_e: 1.442695,
    ln_2: &[0.69314575, 1.4286068e-6],
    two_over_pi: 0.63661975,
    half_pi: &[1.5708008, -4.4535846e-6, -8.706138e-10, 6.2228e-14, 5.721189e-18],
    quarters_pi: &[
        0.7853982,
        -2.1855694e-8,
        1.5707964,
        -4.371139e-8,
        2.3561945,
        -5.9624403e-9,
        3.1415927,
        -8.742278e-8,
    ],
    two_over_root_pi: &[1.1283792, -5.8635383e-8],
    two_thirds: &[0.6666667, -1.9868216e-8],
    exp: &[0.5, 0.16666669, 0.04166641, 0.008332683, 0.0013938746, 0.00020345004],
    sinh: &[0.16666667, 0.0083333105, 0.0001989108],
    cosh: &[0.041666668, 0.0013888866, 2.4851388e-5],
    ln: &[0.6666667, 0.40000123, 0.28550813, 0.23330697],
    ln_tail: &[0.4, 0.2857153, 0.22204758, 0.19120552],
    sin: &[-0.16666667, 0.008333332, -0.00019840086, 2.7249864e-6],
    cos: &[0.041666664, -0.0013888302, 2.4547891e-5],
    atan_limit: 0.5464,
    atan: &[-0.3333333, 0.19999728, -0.14274873, 0.109501354, -0.07971687, 0.03799918],
    asin: &[0.16666666, 0.07500094, 0.044599403, 0.031100662, 0.017149238, 0.033690847],
    erf: &[-0.37612638, 0.1128379, -0.026865946, 0.005222611, -0.0008508545, 0.00011451737, -1.0216748e-5],
    ln_erfc: &[-1.8496056, -2.6389668, -0.8431178, -0.041503053, 0.009895253, -0.0018296357, 0.00018655171],
    erfc_is_zero: 10.5,
    erfc: &[
        1.0215827,
        -0.6871607,
        0.2794721,
        -0.036442112,
        -0.021510689,
        0.0064777588,
        0.003089432,
        -0.0008308853,
        -0.00065368705,
        2.4343437e-5,
        0.00011966578,
        3.1111336e-5,
    ],
};
