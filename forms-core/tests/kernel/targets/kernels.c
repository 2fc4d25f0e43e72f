#ifndef FORMS_KERNELS_F64_H
#define FORMS_KERNELS_F64_H

#include <math.h>
#include <stddef.h>

#ifndef FORMS_RESTRICT
#ifdef __cplusplus
#define FORMS_RESTRICT __restrict
#else
#define FORMS_RESTRICT restrict
#endif
#endif

#ifndef FORMS_FLATTEN
#ifdef __GNUC__
#define FORMS_FLATTEN __attribute__((flatten))
#else
#define FORMS_FLATTEN
#endif
#endif

// With FORMS_VECTOR_LIBRARY, loops over arrays call the vector functions of glibc (2.35 or newer), which are
// within 4 ulp. For GCC with -fno-math-errno -fno-builtin-sin -fno-builtin-cos.
#if defined(FORMS_VECTOR_LIBRARY) && defined(__GNUC__) && !defined(__clang__) && !defined(__cplusplus)
__attribute__((simd("notinbranch"), const)) double atan2(double, double);
__attribute__((simd("notinbranch"), const)) double cbrt(double);
__attribute__((simd("notinbranch"), const)) double cos(double);
__attribute__((simd("notinbranch"), const)) double exp(double);
__attribute__((simd("notinbranch"), const)) double hypot(double, double);
__attribute__((simd("notinbranch"), const)) double log(double);
__attribute__((simd("notinbranch"), const)) double pow(double, double);
__attribute__((simd("notinbranch"), const)) double sin(double);
__attribute__((simd("notinbranch"), const)) double tanh(double);
#endif

#ifndef FORMS_MULTIPLY_ADD
#define FORMS_MULTIPLY_ADD
// a b + c, rounded once if the processor has a fused multiply-add.
static inline double forms_multiply_add(double a, double b, double c) {
#ifdef FP_FAST_FMA
    return fma(a, b, c);
#else
    return a * b + c;
#endif
}
#endif

#ifndef FORMS_DIFFERENCE_OF_PRODUCTS
#define FORMS_DIFFERENCE_OF_PRODUCTS
// a b - c d within 2 ulp, by the error of one product (Kahan).
static inline double forms_difference_of_products(double a, double b, double c, double d) {
    const double product = c * d;
    const double error = fma(-c, d, product);
    return fma(a, b, -product) + (isfinite(error) ? error : 0);
}
#endif

#ifndef FORMS_POWER
#define FORMS_POWER
// x^(n/d); needs x >= 0 if d > 1.
static inline double forms_power(double x, double n, double d) {
    const double base = x;
    const double exponent = n / d;
    const double rest = fma(-exponent, d, n) / d;
    const double value = pow(base, exponent);
    const double power = rest == 0.0 || base == 0.0 || isinf(base) ? value : value + value * (rest * log(base));
    return (double)power;
}
#endif

#ifndef FORMS_HYPOT
#define FORMS_HYPOT
// sqrt(x*x + y*y) without overflow of a square; NaN if x or y is NaN.
static inline double forms_hypot(double x, double y) {
    return isnan(x) || isnan(y) ? x + y : hypot(x, y);
}
#endif

// ```text
// polynomial_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 5 multiplications.
static inline double polynomial_optimised(double x) {
    const double t0 = x * x;
    const double t1 = x * t0;
    const double t2 = forms_multiply_add(3.0, t0 * t1, -(2.0 - x));
    return forms_multiply_add(-0.14285714285714285, t1, t2);
}

// `polynomial_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void polynomial_optimised_batch(
    const double *FORMS_RESTRICT x,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = polynomial_optimised(x[i]);
    }
}

// ```text
// polynomial
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 1 multiplication, 1 negation, 1 division, 2 function calls.
static inline double polynomial(double x) {
    const double t0 = 3.0 * forms_power(x, 5.0, 1.0) + -(forms_power(x, 3.0, 1.0) / 7.0);
    return t0 + x + -2.0;
}

// `polynomial` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void polynomial_batch(
    const double *FORMS_RESTRICT x,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = polynomial(x[i]);
    }
}

// ```text
// inverse_square_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 4 multiplications, 1 division, 1 square root.
static inline double inverse_square_optimised(double x, double y, double z) {
    const double t0 = forms_multiply_add(z, z, forms_multiply_add(y, y, x * x));
    return x / (t0 * sqrt(t0));
}

// `inverse_square_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void inverse_square_optimised_batch(
    const double *FORMS_RESTRICT x,
    const double *FORMS_RESTRICT y,
    const double *FORMS_RESTRICT z,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = inverse_square_optimised(x[i], y[i], z[i]);
    }
}

// ```text
// inverse_square
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 division, 4 function calls.
static inline double inverse_square(double x, double y, double z) {
    const double t0 = forms_power(x, 2.0, 1.0) + forms_power(y, 2.0, 1.0);
    const double t1 = forms_power(t0 + forms_power(z, 2.0, 1.0), 3.0, 2.0);
    return x / t1;
}

// `inverse_square` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void inverse_square_batch(
    const double *FORMS_RESTRICT x,
    const double *FORMS_RESTRICT y,
    const double *FORMS_RESTRICT z,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = inverse_square(x[i], y[i], z[i]);
    }
}

// ```text
// several_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 4 multiplications, 1 division.
static inline void several_optimised(double u, double v, double *outputs) {
    const double t0 = 1.0 / forms_multiply_add(v, v, u * u);
    outputs[0] = u * t0;
    outputs[1] = v * t0;
    outputs[2] = t0;
}

// `several_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void several_optimised_batch(
    const double *FORMS_RESTRICT u,
    const double *FORMS_RESTRICT v,
    double *FORMS_RESTRICT output0,
    double *FORMS_RESTRICT output1,
    double *FORMS_RESTRICT output2,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        double values[3];
        several_optimised(u[i], v[i], values);
        output0[i] = values[0];
        output1[i] = values[1];
        output2[i] = values[2];
    }
}

// ```text
// several
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 3 divisions, 2 function calls.
static inline void several(double u, double v, double *outputs) {
    const double t0 = forms_power(u, 2.0, 1.0) + forms_power(v, 2.0, 1.0);
    outputs[0] = u / t0;
    outputs[1] = v / t0;
    outputs[2] = 1.0 / t0;
}

// `several` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void several_batch(
    const double *FORMS_RESTRICT u,
    const double *FORMS_RESTRICT v,
    double *FORMS_RESTRICT output0,
    double *FORMS_RESTRICT output1,
    double *FORMS_RESTRICT output2,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        double values[3];
        several(u[i], v[i], values);
        output0[i] = values[0];
        output1[i] = values[1];
        output2[i] = values[2];
    }
}

// ```text
// functions_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 1 negation, 7 function calls.
static inline double functions_optimised(double t0, double x) {
    const double tt0 = forms_multiply_add(exp(-fabs(x)), tanh(t0), atan2(sin(t0), cos(x)));
    return tt0 - log(x);
}

// `functions_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void functions_optimised_batch(
    const double *FORMS_RESTRICT t0,
    const double *FORMS_RESTRICT x,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = functions_optimised(t0[i], x[i]);
    }
}

// ```text
// functions
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 2 negations, 7 function calls.
static inline double functions(double t0, double x) {
    const double tt0 = atan2(sin(t0), cos(x)) + exp(-fabs(x)) * tanh(t0);
    return tt0 + -log(x);
}

// `functions` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void functions_batch(
    const double *FORMS_RESTRICT t0,
    const double *FORMS_RESTRICT x,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = functions(t0[i], x[i]);
    }
}

// ```text
// constants_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 2 multiplications, 1 negation, 1 square root.
static inline void constants_optimised(double x, double *outputs) {
    outputs[0] = -x;
    outputs[1] = 0.7853981633974483 * x;
    outputs[2] = 0.6666666666666666 - x;
    outputs[3] = -0.07957747154594767;
    outputs[4] = x * sqrt(2.0);
    outputs[5] = x - 0.1;
}

// `constants_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void constants_optimised_batch(
    const double *FORMS_RESTRICT x,
    double *FORMS_RESTRICT output0,
    double *FORMS_RESTRICT output1,
    double *FORMS_RESTRICT output2,
    double *FORMS_RESTRICT output3,
    double *FORMS_RESTRICT output4,
    double *FORMS_RESTRICT output5,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        double values[6];
        constants_optimised(x[i], values);
        output0[i] = values[0];
        output1[i] = values[1];
        output2[i] = values[2];
        output3[i] = values[3];
        output4[i] = values[4];
        output5[i] = values[5];
    }
}

// ```text
// constants
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 3 multiplications, 1 negation, 2 divisions, 1 square root.
static inline void constants(double x, double *outputs) {
    const double t0 = -x;
    outputs[0] = t0;
    outputs[1] = 3.141592653589793 * x / 4.0;
    outputs[2] = 0.6666666666666666 + t0;
    outputs[3] = -1.0 / (4.0 * 3.141592653589793);
    outputs[4] = sqrt(2.0) * x;
    outputs[5] = x + -0.1;
}

// `constants` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void constants_batch(
    const double *FORMS_RESTRICT x,
    double *FORMS_RESTRICT output0,
    double *FORMS_RESTRICT output1,
    double *FORMS_RESTRICT output2,
    double *FORMS_RESTRICT output3,
    double *FORMS_RESTRICT output4,
    double *FORMS_RESTRICT output5,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        double values[6];
        constants(x[i], values);
        output0[i] = values[0];
        output1[i] = values[1];
        output2[i] = values[2];
        output3[i] = values[3];
        output4[i] = values[4];
        output5[i] = values[5];
    }
}

// ```text
// roots_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 11 multiplications, 1 division, 1 function call.
static inline void roots_optimised(double x, double *outputs) {
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

// `roots_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void roots_optimised_batch(
    const double *FORMS_RESTRICT x,
    double *FORMS_RESTRICT output0,
    double *FORMS_RESTRICT output1,
    double *FORMS_RESTRICT output2,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        double values[3];
        roots_optimised(x[i], values);
        output0[i] = values[0];
        output1[i] = values[1];
        output2[i] = values[2];
    }
}

// ```text
// roots
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 negation, 5 function calls.
static inline void roots(double x, double *outputs) {
    const double t0 = forms_power(x, 1.0, 3.0) + forms_power(x, -2.0, 3.0);
    const double t1 = forms_power(x, 3.0, 2.0) + -forms_power(x, -5.0, 2.0);
    outputs[0] = t0;
    outputs[1] = t1;
    outputs[2] = forms_power(x, -7.0, 1.0);
}

// `roots` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void roots_batch(
    const double *FORMS_RESTRICT x,
    double *FORMS_RESTRICT output0,
    double *FORMS_RESTRICT output1,
    double *FORMS_RESTRICT output2,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        double values[3];
        roots(x[i], values);
        output0[i] = values[0];
        output1[i] = values[1];
        output2[i] = values[2];
    }
}

// ```text
// piecewise_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 square root, 1 function call, 2 conditionals.
static inline double piecewise_optimised(double x, double y) {
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

// `piecewise_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void piecewise_optimised_batch(
    const double *FORMS_RESTRICT x,
    const double *FORMS_RESTRICT y,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = piecewise_optimised(x[i], y[i]);
    }
}

// ```text
// piecewise
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 negation, 1 square root, 1 function call, 2 conditionals.
static inline double piecewise(double x, double y) {
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

// `piecewise` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void piecewise_batch(
    const double *FORMS_RESTRICT x,
    const double *FORMS_RESTRICT y,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = piecewise(x[i], y[i]);
    }
}

// ```text
// extrema_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 2 multiplications, 1 function call, 2 conditionals.
static inline void extrema_optimised(double x, double y, double *outputs) {
    double t0;
    if (x < y) {
        t0 = x;
    } else if (x >= y) {
        t0 = y;
    } else {
        t0 = NAN;
    }
    double t1;
    if (x < 0.0) {
        t1 = 0.0;
    } else if (x >= 0.0) {
        t1 = x;
    } else {
        t1 = NAN;
    }
    outputs[0] = t0;
    outputs[1] = 0.5 * (x * (x + y + fabs(x - y)));
    outputs[2] = t1;
}

// `extrema_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void extrema_optimised_batch(
    const double *FORMS_RESTRICT x,
    const double *FORMS_RESTRICT y,
    double *FORMS_RESTRICT output0,
    double *FORMS_RESTRICT output1,
    double *FORMS_RESTRICT output2,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        double values[3];
        extrema_optimised(x[i], y[i], values);
        output0[i] = values[0];
        output1[i] = values[1];
        output2[i] = values[2];
    }
}

// ```text
// extrema
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 1 multiplication, 1 negation, 1 division, 1 function call, 2 conditionals.
static inline void extrema(double x, double y, double *outputs) {
    double t0;
    if (x < y) {
        t0 = x;
    } else if (x >= y) {
        t0 = y;
    } else {
        t0 = NAN;
    }
    double t1;
    if (x < 0.0) {
        t1 = 0.0;
    } else if (x >= 0.0) {
        t1 = x;
    } else {
        t1 = NAN;
    }
    outputs[0] = t0;
    outputs[1] = x * (x + y + fabs(x + -y)) / 2.0;
    outputs[2] = t1;
}

// `extrema` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void extrema_batch(
    const double *FORMS_RESTRICT x,
    const double *FORMS_RESTRICT y,
    double *FORMS_RESTRICT output0,
    double *FORMS_RESTRICT output1,
    double *FORMS_RESTRICT output2,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        double values[3];
        extrema(x[i], y[i], values);
        output0[i] = values[0];
        output1[i] = values[1];
        output2[i] = values[2];
    }
}

// ```text
// lengths_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 2 function calls.
static inline double lengths_optimised(double x, double y) {
    return forms_hypot(x, 3.0 * y) + cbrt(x - y);
}

// `lengths_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void lengths_optimised_batch(
    const double *FORMS_RESTRICT x,
    const double *FORMS_RESTRICT y,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = lengths_optimised(x[i], y[i]);
    }
}

// ```text
// lengths
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 1 negation, 2 function calls.
static inline double lengths(double x, double y) {
    return forms_hypot(x, 3.0 * y) + cbrt(x + -y);
}

// `lengths` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void lengths_batch(
    const double *FORMS_RESTRICT x,
    const double *FORMS_RESTRICT y,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = lengths(x[i], y[i]);
    }
}

// ```text
// unused_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition.
static inline double unused_optimised(double x, double y) {
    (void)x;
    return y + 1.0;
}

// `unused_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void unused_optimised_batch(
    const double *FORMS_RESTRICT x,
    const double *FORMS_RESTRICT y,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = unused_optimised(x[i], y[i]);
    }
}

// ```text
// unused
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition.
static inline double unused(double x, double y) {
    (void)x;
    return y + 1.0;
}

// `unused` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void unused_batch(
    const double *FORMS_RESTRICT x,
    const double *FORMS_RESTRICT y,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = unused(x[i], y[i]);
    }
}

// ```text
// many_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 4 multiplications.
static inline double many_optimised(
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

// `many_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void many_optimised_batch(
    const double *FORMS_RESTRICT a,
    const double *FORMS_RESTRICT b,
    const double *FORMS_RESTRICT c,
    const double *FORMS_RESTRICT d,
    const double *FORMS_RESTRICT e,
    const double *FORMS_RESTRICT f,
    const double *FORMS_RESTRICT g,
    const double *FORMS_RESTRICT H,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = many_optimised(a[i], b[i], c[i], d[i], e[i], f[i], g[i], H[i]);
    }
}

// ```text
// many
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 4 multiplications, 2 negations.
static inline double many(
    double a,
    double b,
    double c,
    double d,
    double e,
    double f,
    double g,
    double H) {
    return a * b + c * d + -(e * f + -(g * H));
}

// `many` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void many_batch(
    const double *FORMS_RESTRICT a,
    const double *FORMS_RESTRICT b,
    const double *FORMS_RESTRICT c,
    const double *FORMS_RESTRICT d,
    const double *FORMS_RESTRICT e,
    const double *FORMS_RESTRICT f,
    const double *FORMS_RESTRICT g,
    const double *FORMS_RESTRICT H,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = many(a[i], b[i], c[i], d[i], e[i], f[i], g[i], H[i]);
    }
}

// ```text
// products
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 2 multiplications.
static inline double products(double a, double b, double c, double d) {
    return forms_difference_of_products(a, b, c, d);
}

// `products` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void products_batch(
    const double *FORMS_RESTRICT a,
    const double *FORMS_RESTRICT b,
    const double *FORMS_RESTRICT c,
    const double *FORMS_RESTRICT d,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = products(a[i], b[i], c[i], d[i]);
    }
}

// ```text
// inside
// ```
//
// Its value is NaN outside its domain and where an argument it depends on is NaN.
// Cost: 1 addition, 1 division, 1 square root.
static inline double inside(double x, double y) {
    const int t0 = (0.0 < x) & (x + y <= 5.0) & (y < 0.0 || y > 0.0);
    return t0 ? sqrt(x) / y : NAN;
}

// `inside` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void inside_batch(
    const double *FORMS_RESTRICT x,
    const double *FORMS_RESTRICT y,
    double *FORMS_RESTRICT output,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        output[i] = inside(x[i], y[i]);
    }
}

// ```text
// both_inside
// ```
//
// Its value is NaN outside its domain and where an argument it depends on is NaN.
// Cost: 1 addition, 1 division, 1 square root.
static inline void both_inside(double x, double y, double *outputs) {
    const double t0 = x + y;
    const double t1 = (0.0 < x) & (t0 <= 5.0) & (y < 0.0 || y > 0.0) ? 1.0 : NAN;
    outputs[0] = t1 * (sqrt(x) / y);
    outputs[1] = t1 * t0;
}

// `both_inside` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void both_inside_batch(
    const double *FORMS_RESTRICT x,
    const double *FORMS_RESTRICT y,
    double *FORMS_RESTRICT output0,
    double *FORMS_RESTRICT output1,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        double values[2];
        both_inside(x[i], y[i], values);
        output0[i] = values[0];
        output1[i] = values[1];
    }
}

#endif
