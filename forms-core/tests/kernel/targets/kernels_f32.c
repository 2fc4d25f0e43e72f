#ifndef FORMS_KERNELS_F32_H
#define FORMS_KERNELS_F32_H

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
__attribute__((simd("notinbranch"), const)) float atan2f(float, float);
__attribute__((simd("notinbranch"), const)) float cbrtf(float);
__attribute__((simd("notinbranch"), const)) float cosf(float);
__attribute__((simd("notinbranch"), const)) float expf(float);
__attribute__((simd("notinbranch"), const)) float hypotf(float, float);
__attribute__((simd("notinbranch"), const)) float logf(float);
__attribute__((simd("notinbranch"), const)) float powf(float, float);
__attribute__((simd("notinbranch"), const)) float sinf(float);
__attribute__((simd("notinbranch"), const)) float tanhf(float);
#endif

#ifndef FORMS_MULTIPLY_ADDF
#define FORMS_MULTIPLY_ADDF
// a b + c, rounded once if the processor has a fused multiply-add.
static inline float forms_multiply_addf(float a, float b, float c) {
#ifdef FP_FAST_FMAF
    return fmaf(a, b, c);
#else
    return a * b + c;
#endif
}
#endif

#ifndef FORMS_DIFFERENCE_OF_PRODUCTSF
#define FORMS_DIFFERENCE_OF_PRODUCTSF
// a b - c d within 2 ulp, by the error of one product (Kahan).
static inline float forms_difference_of_productsf(float a, float b, float c, float d) {
    const float product = c * d;
    const float error = fmaf(-c, d, product);
    return fmaf(a, b, -product) + (isfinite(error) ? error : 0);
}
#endif

#ifndef FORMS_POWERF
#define FORMS_POWERF
// x^(n/d); needs x >= 0 if d > 1.
static inline float forms_powerf(float x, double n, double d) {
    const double base = x;
    const double exponent = n / d;
    const double rest = fma(-exponent, d, n) / d;
    const double value = pow(base, exponent);
    const double power = rest == 0.0 || base == 0.0 || isinf(base) ? value : value + value * (rest * log(base));
    return (float)power;
}
#endif

#ifndef FORMS_HYPOTF
#define FORMS_HYPOTF
// sqrt(x*x + y*y) without overflow of a square; NaN if x or y is NaN.
static inline float forms_hypotf(float x, float y) {
    return isnan(x) || isnan(y) ? x + y : hypotf(x, y);
}
#endif

// ```text
// polynomial_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 5 multiplications.
static inline float polynomial_optimised(float x) {
    const float t0 = x * x;
    const float t1 = x * t0;
    const float t2 = forms_multiply_addf(3.0f, t0 * t1, -(2.0f - x));
    return forms_multiply_addf(-0.14285715f, t1, t2);
}

// `polynomial_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void polynomial_optimised_batch(
    const float *FORMS_RESTRICT x,
    float *FORMS_RESTRICT output,
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
static inline float polynomial(float x) {
    const float t0 = 3.0f * forms_powerf(x, 5.0, 1.0) + -(forms_powerf(x, 3.0, 1.0) / 7.0f);
    return t0 + x + -2.0f;
}

// `polynomial` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void polynomial_batch(
    const float *FORMS_RESTRICT x,
    float *FORMS_RESTRICT output,
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
static inline float inverse_square_optimised(float x, float y, float z) {
    const float t0 = forms_multiply_addf(z, z, forms_multiply_addf(y, y, x * x));
    return x / (t0 * sqrtf(t0));
}

// `inverse_square_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void inverse_square_optimised_batch(
    const float *FORMS_RESTRICT x,
    const float *FORMS_RESTRICT y,
    const float *FORMS_RESTRICT z,
    float *FORMS_RESTRICT output,
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
static inline float inverse_square(float x, float y, float z) {
    const float t0 = forms_powerf(x, 2.0, 1.0) + forms_powerf(y, 2.0, 1.0);
    const float t1 = forms_powerf(t0 + forms_powerf(z, 2.0, 1.0), 3.0, 2.0);
    return x / t1;
}

// `inverse_square` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void inverse_square_batch(
    const float *FORMS_RESTRICT x,
    const float *FORMS_RESTRICT y,
    const float *FORMS_RESTRICT z,
    float *FORMS_RESTRICT output,
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
static inline void several_optimised(float u, float v, float *outputs) {
    const float t0 = 1.0f / forms_multiply_addf(v, v, u * u);
    outputs[0] = u * t0;
    outputs[1] = v * t0;
    outputs[2] = t0;
}

// `several_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void several_optimised_batch(
    const float *FORMS_RESTRICT u,
    const float *FORMS_RESTRICT v,
    float *FORMS_RESTRICT output0,
    float *FORMS_RESTRICT output1,
    float *FORMS_RESTRICT output2,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        float values[3];
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
static inline void several(float u, float v, float *outputs) {
    const float t0 = forms_powerf(u, 2.0, 1.0) + forms_powerf(v, 2.0, 1.0);
    outputs[0] = u / t0;
    outputs[1] = v / t0;
    outputs[2] = 1.0f / t0;
}

// `several` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void several_batch(
    const float *FORMS_RESTRICT u,
    const float *FORMS_RESTRICT v,
    float *FORMS_RESTRICT output0,
    float *FORMS_RESTRICT output1,
    float *FORMS_RESTRICT output2,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        float values[3];
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
static inline float functions_optimised(float t0, float x) {
    const float tt0 = forms_multiply_addf(expf(-fabsf(x)), tanhf(t0), atan2f(sinf(t0), cosf(x)));
    return tt0 - logf(x);
}

// `functions_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void functions_optimised_batch(
    const float *FORMS_RESTRICT t0,
    const float *FORMS_RESTRICT x,
    float *FORMS_RESTRICT output,
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
static inline float functions(float t0, float x) {
    const float tt0 = atan2f(sinf(t0), cosf(x)) + expf(-fabsf(x)) * tanhf(t0);
    return tt0 + -logf(x);
}

// `functions` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void functions_batch(
    const float *FORMS_RESTRICT t0,
    const float *FORMS_RESTRICT x,
    float *FORMS_RESTRICT output,
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
static inline void constants_optimised(float x, float *outputs) {
    outputs[0] = -x;
    outputs[1] = 0.7853982f * x;
    outputs[2] = 0.6666667f - x;
    outputs[3] = -0.07957747f;
    outputs[4] = x * sqrtf(2.0f);
    outputs[5] = x - 0.1f;
}

// `constants_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void constants_optimised_batch(
    const float *FORMS_RESTRICT x,
    float *FORMS_RESTRICT output0,
    float *FORMS_RESTRICT output1,
    float *FORMS_RESTRICT output2,
    float *FORMS_RESTRICT output3,
    float *FORMS_RESTRICT output4,
    float *FORMS_RESTRICT output5,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        float values[6];
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
static inline void constants(float x, float *outputs) {
    const float t0 = -x;
    outputs[0] = t0;
    outputs[1] = 3.1415927f * x / 4.0f;
    outputs[2] = 0.6666667f + t0;
    outputs[3] = -1.0f / (4.0f * 3.1415927f);
    outputs[4] = sqrtf(2.0f) * x;
    outputs[5] = x + -0.1f;
}

// `constants` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void constants_batch(
    const float *FORMS_RESTRICT x,
    float *FORMS_RESTRICT output0,
    float *FORMS_RESTRICT output1,
    float *FORMS_RESTRICT output2,
    float *FORMS_RESTRICT output3,
    float *FORMS_RESTRICT output4,
    float *FORMS_RESTRICT output5,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        float values[6];
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
static inline void roots_optimised(float x, float *outputs) {
    const float t0 = forms_powerf(x, 1.0, 6.0);
    const float t1 = t0 * t0;
    const float t2 = 1.0f / t0;
    const float t3 = t2 * t2;
    const float t4 = t3 * t3;
    const float t5 = t2 * t4;
    const float t6 = t5 * t5;
    const float t7 = t5 * t6;
    outputs[0] = t1 + t4;
    outputs[1] = forms_multiply_addf(t0, x * t1, -t7);
    outputs[2] = t3 * (t6 * (t7 * t7));
}

// `roots_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void roots_optimised_batch(
    const float *FORMS_RESTRICT x,
    float *FORMS_RESTRICT output0,
    float *FORMS_RESTRICT output1,
    float *FORMS_RESTRICT output2,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        float values[3];
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
static inline void roots(float x, float *outputs) {
    const float t0 = forms_powerf(x, 1.0, 3.0) + forms_powerf(x, -2.0, 3.0);
    const float t1 = forms_powerf(x, 3.0, 2.0) + -forms_powerf(x, -5.0, 2.0);
    outputs[0] = t0;
    outputs[1] = t1;
    outputs[2] = forms_powerf(x, -7.0, 1.0);
}

// `roots` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void roots_batch(
    const float *FORMS_RESTRICT x,
    float *FORMS_RESTRICT output0,
    float *FORMS_RESTRICT output1,
    float *FORMS_RESTRICT output2,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        float values[3];
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
static inline float piecewise_optimised(float x, float y) {
    float t0;
    if (x < y) {
        t0 = sqrtf(y - x);
    } else if (x >= y) {
        float t1;
        if (y <= 0.0f) {
            t1 = x;
        } else if (y > 0.0f) {
            t1 = logf(y);
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
    const float *FORMS_RESTRICT x,
    const float *FORMS_RESTRICT y,
    float *FORMS_RESTRICT output,
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
static inline float piecewise(float x, float y) {
    float t0;
    if (x < y) {
        t0 = sqrtf(y + -x);
    } else if (x >= y) {
        float t1;
        if (y <= 0.0f) {
            t1 = x;
        } else if (y > 0.0f) {
            t1 = logf(y);
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
    const float *FORMS_RESTRICT x,
    const float *FORMS_RESTRICT y,
    float *FORMS_RESTRICT output,
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
static inline void extrema_optimised(float x, float y, float *outputs) {
    float t0;
    if (x < y) {
        t0 = x;
    } else if (x >= y) {
        t0 = y;
    } else {
        t0 = NAN;
    }
    float t1;
    if (x < 0.0f) {
        t1 = 0.0f;
    } else if (x >= 0.0f) {
        t1 = x;
    } else {
        t1 = NAN;
    }
    outputs[0] = t0;
    outputs[1] = 0.5f * (x * (x + y + fabsf(x - y)));
    outputs[2] = t1;
}

// `extrema_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void extrema_optimised_batch(
    const float *FORMS_RESTRICT x,
    const float *FORMS_RESTRICT y,
    float *FORMS_RESTRICT output0,
    float *FORMS_RESTRICT output1,
    float *FORMS_RESTRICT output2,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        float values[3];
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
static inline void extrema(float x, float y, float *outputs) {
    float t0;
    if (x < y) {
        t0 = x;
    } else if (x >= y) {
        t0 = y;
    } else {
        t0 = NAN;
    }
    float t1;
    if (x < 0.0f) {
        t1 = 0.0f;
    } else if (x >= 0.0f) {
        t1 = x;
    } else {
        t1 = NAN;
    }
    outputs[0] = t0;
    outputs[1] = x * (x + y + fabsf(x + -y)) / 2.0f;
    outputs[2] = t1;
}

// `extrema` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void extrema_batch(
    const float *FORMS_RESTRICT x,
    const float *FORMS_RESTRICT y,
    float *FORMS_RESTRICT output0,
    float *FORMS_RESTRICT output1,
    float *FORMS_RESTRICT output2,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        float values[3];
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
static inline float lengths_optimised(float x, float y) {
    return forms_hypotf(x, 3.0f * y) + cbrtf(x - y);
}

// `lengths_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void lengths_optimised_batch(
    const float *FORMS_RESTRICT x,
    const float *FORMS_RESTRICT y,
    float *FORMS_RESTRICT output,
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
static inline float lengths(float x, float y) {
    return forms_hypotf(x, 3.0f * y) + cbrtf(x + -y);
}

// `lengths` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void lengths_batch(
    const float *FORMS_RESTRICT x,
    const float *FORMS_RESTRICT y,
    float *FORMS_RESTRICT output,
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
static inline float unused_optimised(float x, float y) {
    (void)x;
    return y + 1.0f;
}

// `unused_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void unused_optimised_batch(
    const float *FORMS_RESTRICT x,
    const float *FORMS_RESTRICT y,
    float *FORMS_RESTRICT output,
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
static inline float unused(float x, float y) {
    (void)x;
    return y + 1.0f;
}

// `unused` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void unused_batch(
    const float *FORMS_RESTRICT x,
    const float *FORMS_RESTRICT y,
    float *FORMS_RESTRICT output,
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
static inline float many_optimised(
    float a,
    float b,
    float c,
    float d,
    float e,
    float f,
    float g,
    float H) {
    return forms_multiply_addf(c, d, a * b) - forms_multiply_addf(-g, H, e * f);
}

// `many_optimised` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void many_optimised_batch(
    const float *FORMS_RESTRICT a,
    const float *FORMS_RESTRICT b,
    const float *FORMS_RESTRICT c,
    const float *FORMS_RESTRICT d,
    const float *FORMS_RESTRICT e,
    const float *FORMS_RESTRICT f,
    const float *FORMS_RESTRICT g,
    const float *FORMS_RESTRICT H,
    float *FORMS_RESTRICT output,
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
static inline float many(float a, float b, float c, float d, float e, float f, float g, float H) {
    return a * b + c * d + -(e * f + -(g * H));
}

// `many` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void many_batch(
    const float *FORMS_RESTRICT a,
    const float *FORMS_RESTRICT b,
    const float *FORMS_RESTRICT c,
    const float *FORMS_RESTRICT d,
    const float *FORMS_RESTRICT e,
    const float *FORMS_RESTRICT f,
    const float *FORMS_RESTRICT g,
    const float *FORMS_RESTRICT H,
    float *FORMS_RESTRICT output,
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
static inline float products(float a, float b, float c, float d) {
    return forms_difference_of_productsf(a, b, c, d);
}

// `products` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void products_batch(
    const float *FORMS_RESTRICT a,
    const float *FORMS_RESTRICT b,
    const float *FORMS_RESTRICT c,
    const float *FORMS_RESTRICT d,
    float *FORMS_RESTRICT output,
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
static inline float inside(float x, float y) {
    const int t0 = (0.0f < x) & (x + y <= 5.0f) & (y < 0.0f || y > 0.0f);
    return t0 ? sqrtf(x) / y : NAN;
}

// `inside` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void inside_batch(
    const float *FORMS_RESTRICT x,
    const float *FORMS_RESTRICT y,
    float *FORMS_RESTRICT output,
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
static inline void both_inside(float x, float y, float *outputs) {
    const float t0 = x + y;
    const float t1 = (0.0f < x) & (t0 <= 5.0f) & (y < 0.0f || y > 0.0f) ? 1.0f : NAN;
    outputs[0] = t1 * (sqrtf(x) / y);
    outputs[1] = t1 * t0;
}

// `both_inside` for each i < count. Outputs must not overlap other arrays.
FORMS_FLATTEN static inline void both_inside_batch(
    const float *FORMS_RESTRICT x,
    const float *FORMS_RESTRICT y,
    float *FORMS_RESTRICT output0,
    float *FORMS_RESTRICT output1,
    size_t count) {
    for (size_t i = 0; i < count; i++) {
        float values[2];
        both_inside(x[i], y[i], values);
        output0[i] = values[0];
        output1[i] = values[1];
    }
}

#endif
