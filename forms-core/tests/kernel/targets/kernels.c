#include <math.h>

// a b + c, rounded once if the processor has a fused multiply-add.
static inline double forms_multiply_add(double a, double b, double c) {
#ifdef FP_FAST_FMA
    return fma(a, b, c);
#else
    return a * b + c;
#endif
}

// a b - c d within 2 ulp, by the error of one product (Kahan).
static inline double forms_difference_of_products(double a, double b, double c, double d) {
    const double product = c * d;
    const double error = fma(-c, d, product);
    const double value = fma(a, b, -product) + error;
    return isnan(value) ? a * b - product : value;
}

// x^(n/d); needs x >= 0 if d > 1.
static inline double forms_power(double x, double n, double d) {
    const double exponent = n / d;
    const double rest = fma(-exponent, d, n) / d;
    const double value = pow(x, exponent);
    return (double)(rest == 0.0 || x == 0 || isinf(x) ? value : value + value * (rest * log(x)));
}

// ```text
// polynomial_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 5 multiplications.
double polynomial_optimised(double x) {
    const double t0 = x * x;
    const double t1 = x * t0;
    const double t2 = forms_multiply_add(3.0, t0 * t1, -(2.0 - x));
    return forms_multiply_add(-0.14285714285714285, t1, t2);
}

// ```text
// polynomial
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 1 multiplication, 1 negation, 1 division, 2 function calls.
double polynomial(double x) {
    const double t0 = 3.0 * forms_power(x, 5.0, 1.0) + -(forms_power(x, 3.0, 1.0) / 7.0);
    return t0 + x + -2.0;
}

// ```text
// inverse_square_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 4 multiplications, 1 division, 1 square root.
double inverse_square_optimised(double x, double y, double z) {
    const double t0 = forms_multiply_add(z, z, forms_multiply_add(y, y, x * x));
    return x / (t0 * sqrt(t0));
}

// ```text
// inverse_square
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 division, 4 function calls.
double inverse_square(double x, double y, double z) {
    const double t0 = forms_power(x, 2.0, 1.0) + forms_power(y, 2.0, 1.0);
    const double t1 = forms_power(t0 + forms_power(z, 2.0, 1.0), 3.0, 2.0);
    return x / t1;
}

// ```text
// several_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 4 multiplications, 1 division.
void several_optimised(double u, double v, double *outputs) {
    const double t0 = 1.0 / forms_multiply_add(v, v, u * u);
    outputs[0] = u * t0;
    outputs[1] = v * t0;
    outputs[2] = t0;
}

// ```text
// several
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 3 divisions, 2 function calls.
void several(double u, double v, double *outputs) {
    const double t0 = forms_power(u, 2.0, 1.0) + forms_power(v, 2.0, 1.0);
    outputs[0] = u / t0;
    outputs[1] = v / t0;
    outputs[2] = 1.0 / t0;
}

// ```text
// functions_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 1 negation, 7 function calls.
double functions_optimised(double t0, double x) {
    const double tt0 = forms_multiply_add(exp(-fabs(x)), tanh(t0), atan2(sin(t0), cos(x)));
    return tt0 - log(x);
}

// ```text
// functions
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 2 negations, 7 function calls.
double functions(double t0, double x) {
    const double tt0 = atan2(sin(t0), cos(x)) + exp(-fabs(x)) * tanh(t0);
    return tt0 + -log(x);
}

// ```text
// constants_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 2 multiplications, 1 negation, 1 square root.
void constants_optimised(double x, double *outputs) {
    outputs[0] = -x;
    outputs[1] = 0.7853981633974483 * x;
    outputs[2] = 0.6666666666666666 - x;
    outputs[3] = -0.07957747154594767;
    outputs[4] = x * sqrt(2.0);
    outputs[5] = x - 0.1;
}

// ```text
// constants
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 3 multiplications, 1 negation, 2 divisions, 1 square root.
void constants(double x, double *outputs) {
    const double t0 = -x;
    outputs[0] = t0;
    outputs[1] = 3.141592653589793 * x / 4.0;
    outputs[2] = 0.6666666666666666 + t0;
    outputs[3] = -1.0 / (4.0 * 3.141592653589793);
    outputs[4] = sqrt(2.0) * x;
    outputs[5] = x + -0.1;
}

// ```text
// roots_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 11 multiplications, 1 division, 1 function call.
void roots_optimised(double x, double *outputs) {
    const double t0 = forms_power(x, 1.0, 6.0);
    const double t1 = t0 * t0;
    const double t2 = 1.0 / t0;
    const double t3 = t2 * t2;
    const double t4 = t3 * t3;
    const double t5 = t2 * t4;
    const double t6 = t5 * t5;
    const double t7 = t5 * t6;
    outputs[0] = t1 + t4;
    outputs[1] = forms_multiply_add(t0, x * t1, -t7);
    outputs[2] = t3 * (t6 * (t7 * t7));
}

// ```text
// roots
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 negation, 5 function calls.
void roots(double x, double *outputs) {
    const double t0 = forms_power(x, 1.0, 3.0) + forms_power(x, -2.0, 3.0);
    const double t1 = forms_power(x, 3.0, 2.0) + -forms_power(x, -5.0, 2.0);
    outputs[0] = t0;
    outputs[1] = t1;
    outputs[2] = forms_power(x, -7.0, 1.0);
}

// ```text
// piecewise_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 square root, 1 function call, 2 conditionals.
double piecewise_optimised(double x, double y) {
    double t0;
    if (x < y) {
        t0 = sqrt(y - x);
    } else if (x >= y) {
        double t1;
        if (y <= 0.0) {
            t1 = x;
        } else if (y > 0.0) {
            t1 = log(y);
        } else {
            t1 = NAN;
        }
        t0 = t1;
    } else {
        t0 = NAN;
    }
    return x + t0;
}

// ```text
// piecewise
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 negation, 1 square root, 1 function call, 2 conditionals.
double piecewise(double x, double y) {
    double t0;
    if (x < y) {
        t0 = sqrt(y + -x);
    } else if (x >= y) {
        double t1;
        if (y <= 0.0) {
            t1 = x;
        } else if (y > 0.0) {
            t1 = log(y);
        } else {
            t1 = NAN;
        }
        t0 = t1;
    } else {
        t0 = NAN;
    }
    return t0 + x;
}

// ```text
// unused_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition.
double unused_optimised(double x, double y) {
    (void)x;
    return y + 1.0;
}

// ```text
// unused
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition.
double unused(double x, double y) {
    (void)x;
    return y + 1.0;
}

// ```text
// many_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 4 multiplications.
double many_optimised(
    double a,
    double b,
    double c,
    double d,
    double e,
    double f,
    double g,
    double H) {
    return forms_multiply_add(c, d, a * b) - forms_multiply_add(-g, H, e * f);
}

// ```text
// many
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 4 multiplications, 2 negations.
double many(double a, double b, double c, double d, double e, double f, double g, double H) {
    return a * b + c * d + -(e * f + -(g * H));
}

// ```text
// products
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 2 multiplications.
double products(double a, double b, double c, double d) {
    return forms_difference_of_products(a, b, c, d);
}

// ```text
// inside
// ```
//
// Its value is NaN outside its domain and where an argument it depends on is NaN.
// Cost: 1 addition, 1 division, 1 square root.
double inside(double x, double y) {
    if (!(0.0 < x)) {
        return NAN;
    }
    if (!(x + y <= 5.0)) {
        return NAN;
    }
    if (!(y < 0.0 || y > 0.0)) {
        return NAN;
    }
    return sqrt(x) / y;
}

// ```text
// both_inside
// ```
//
// Its value is NaN outside its domain and where an argument it depends on is NaN.
// Cost: 1 addition, 1 division, 1 square root.
void both_inside(double x, double y, double *outputs) {
    const double t0 = x + y;
    if (!(0.0 < x)) {
        outputs[0] = NAN;
        outputs[1] = NAN;
        return;
    }
    if (!(t0 <= 5.0)) {
        outputs[0] = NAN;
        outputs[1] = NAN;
        return;
    }
    if (!(y < 0.0 || y > 0.0)) {
        outputs[0] = NAN;
        outputs[1] = NAN;
        return;
    }
    outputs[0] = sqrt(x) / y;
    outputs[1] = t0;
}
