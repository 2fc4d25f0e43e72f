#include <math.h>

// a b + c, rounded once if the processor has a fused multiply-add.
static inline float forms_multiply_add(float a, float b, float c) {
#ifdef FP_FAST_FMAF
    return fmaf(a, b, c);
#else
    return a * b + c;
#endif
}

// a b - c d within 2 ulp, by the error of one product (Kahan).
static inline float forms_difference_of_products(float a, float b, float c, float d) {
    const float product = c * d;
    const float error = fmaf(-c, d, product);
    const float value = fmaf(a, b, -product) + error;
    return isnan(value) ? a * b - product : value;
}

// x^(n/d); needs x >= 0 if d > 1.
static inline float forms_power(float x, double n, double d) {
    const double exponent = n / d;
    const double rest = fma(-exponent, d, n) / d;
    const double value = pow(x, exponent);
    return (float)(rest == 0.0 || x == 0 || isinf(x) ? value : value + value * (rest * log(x)));
}

// ```text
// polynomial_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 5 multiplications.
float polynomial_optimised(float x) {
    const float t0 = x * x;
    const float t1 = x * t0;
    const float t2 = forms_multiply_add(3.0f, t0 * t1, -(2.0f - x));
    return forms_multiply_add(-0.14285715f, t1, t2);
}

// ```text
// polynomial
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 1 multiplication, 1 negation, 1 division, 2 function calls.
float polynomial(float x) {
    const float t0 = 3.0f * forms_power(x, 5.0, 1.0) + -(forms_power(x, 3.0, 1.0) / 7.0f);
    return t0 + x + -2.0f;
}

// ```text
// inverse_square_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 4 multiplications, 1 division, 1 square root.
float inverse_square_optimised(float x, float y, float z) {
    const float t0 = forms_multiply_add(z, z, forms_multiply_add(y, y, x * x));
    return x / (t0 * sqrtf(t0));
}

// ```text
// inverse_square
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 division, 4 function calls.
float inverse_square(float x, float y, float z) {
    const float t0 = forms_power(x, 2.0, 1.0) + forms_power(y, 2.0, 1.0);
    const float t1 = forms_power(t0 + forms_power(z, 2.0, 1.0), 3.0, 2.0);
    return x / t1;
}

// ```text
// several_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 4 multiplications, 1 division.
void several_optimised(float u, float v, float *outputs) {
    const float t0 = 1.0f / forms_multiply_add(v, v, u * u);
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
void several(float u, float v, float *outputs) {
    const float t0 = forms_power(u, 2.0, 1.0) + forms_power(v, 2.0, 1.0);
    outputs[0] = u / t0;
    outputs[1] = v / t0;
    outputs[2] = 1.0f / t0;
}

// ```text
// functions_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 1 negation, 7 function calls.
float functions_optimised(float t0, float x) {
    const float tt0 = forms_multiply_add(expf(-fabsf(x)), tanhf(t0), atan2f(sinf(t0), cosf(x)));
    return tt0 - logf(x);
}

// ```text
// functions
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 2 negations, 7 function calls.
float functions(float t0, float x) {
    const float tt0 = atan2f(sinf(t0), cosf(x)) + expf(-fabsf(x)) * tanhf(t0);
    return tt0 + -logf(x);
}

// ```text
// constants_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 2 multiplications, 1 negation, 1 square root.
void constants_optimised(float x, float *outputs) {
    outputs[0] = -x;
    outputs[1] = 0.7853982f * x;
    outputs[2] = 0.6666667f - x;
    outputs[3] = -0.07957747f;
    outputs[4] = x * sqrtf(2.0f);
    outputs[5] = x - 0.1f;
}

// ```text
// constants
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 3 multiplications, 1 negation, 2 divisions, 1 square root.
void constants(float x, float *outputs) {
    const float t0 = -x;
    outputs[0] = t0;
    outputs[1] = 3.1415927f * x / 4.0f;
    outputs[2] = 0.6666667f + t0;
    outputs[3] = -1.0f / (4.0f * 3.1415927f);
    outputs[4] = sqrtf(2.0f) * x;
    outputs[5] = x + -0.1f;
}

// ```text
// roots_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 11 multiplications, 1 division, 1 function call.
void roots_optimised(float x, float *outputs) {
    const float t0 = forms_power(x, 1.0, 6.0);
    const float t1 = t0 * t0;
    const float t2 = 1.0f / t0;
    const float t3 = t2 * t2;
    const float t4 = t3 * t3;
    const float t5 = t2 * t4;
    const float t6 = t5 * t5;
    const float t7 = t5 * t6;
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
void roots(float x, float *outputs) {
    const float t0 = forms_power(x, 1.0, 3.0) + forms_power(x, -2.0, 3.0);
    const float t1 = forms_power(x, 3.0, 2.0) + -forms_power(x, -5.0, 2.0);
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
float piecewise_optimised(float x, float y) {
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

// ```text
// piecewise
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 negation, 1 square root, 1 function call, 2 conditionals.
float piecewise(float x, float y) {
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

// ```text
// unused_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition.
float unused_optimised(float x, float y) {
    (void)x;
    return y + 1.0f;
}

// ```text
// unused
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition.
float unused(float x, float y) {
    (void)x;
    return y + 1.0f;
}

// ```text
// many_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 4 multiplications.
float many_optimised(float a, float b, float c, float d, float e, float f, float g, float H) {
    return forms_multiply_add(c, d, a * b) - forms_multiply_add(-g, H, e * f);
}

// ```text
// many
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 4 multiplications, 2 negations.
float many(float a, float b, float c, float d, float e, float f, float g, float H) {
    return a * b + c * d + -(e * f + -(g * H));
}

// ```text
// products
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 2 multiplications.
float products(float a, float b, float c, float d) {
    return forms_difference_of_products(a, b, c, d);
}

// ```text
// inside
// ```
//
// Its value is NaN outside its domain and where an argument it depends on is NaN.
// Cost: 1 addition, 1 division, 1 square root.
float inside(float x, float y) {
    if (!(0.0f < x)) {
        return NAN;
    }
    if (!(x + y <= 5.0f)) {
        return NAN;
    }
    if (!(y < 0.0f || y > 0.0f)) {
        return NAN;
    }
    return sqrtf(x) / y;
}

// ```text
// both_inside
// ```
//
// Its value is NaN outside its domain and where an argument it depends on is NaN.
// Cost: 1 addition, 1 division, 1 square root.
void both_inside(float x, float y, float *outputs) {
    const float t0 = x + y;
    if (!(0.0f < x)) {
        outputs[0] = NAN;
        outputs[1] = NAN;
        return;
    }
    if (!(t0 <= 5.0f)) {
        outputs[0] = NAN;
        outputs[1] = NAN;
        return;
    }
    if (!(y < 0.0f || y > 0.0f)) {
        outputs[0] = NAN;
        outputs[1] = NAN;
        return;
    }
    outputs[0] = sqrtf(x) / y;
    outputs[1] = t0;
}
