// NaN.
__device__ inline float forms_nanf() {
    return __int_as_float(0x7fc00000);
}

// a b + c, rounded once.
__device__ inline float forms_multiply_addf(float a, float b, float c) {
    return fmaf(a, b, c);
}

// a b - c d within 2 ulp, by the error of one product (Kahan).
__device__ inline float forms_difference_of_productsf(float a, float b, float c, float d) {
    const float product = c * d;
    const float error = fmaf(-c, d, product);
    return fmaf(a, b, -product) + (isfinite(error) ? error : 0);
}

// x^(n/d); needs x >= 0 if d > 1.
__device__ inline float forms_powerf(float x, double n, double d) {
    const double base = x;
    const double exponent = n / d;
    const double rest = fma(-exponent, d, n) / d;
    const double value = pow(base, exponent);
    const double power = rest == 0.0 || base == 0.0 || isinf(base) ? value : value + value * (rest * log(base));
    return (float)power;
}

// sqrt(x*x + y*y) without overflow of a square; NaN if x or y is NaN.
__device__ inline float forms_hypotf(float x, float y) {
    return isnan(x) || isnan(y) ? x + y : hypotf(x, y);
}

// ```text
// polynomial_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 5 multiplications.
__device__ inline float polynomial_optimised(float x) {
    const float t0 = x * x;
    const float t1 = x * t0;
    const float t2 = forms_multiply_addf(3.0f, t0 * t1, -(2.0f - x));
    return forms_multiply_addf(-0.14285715f, t1, t2);
}

// `polynomial_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void polynomial_optimised_batch(
    const float *__restrict__ x,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = polynomial_optimised(x[i]);
    }
}

// ```text
// polynomial
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 1 multiplication, 1 negation, 1 division, 2 function calls.
__device__ inline float polynomial(float x) {
    const float t0 = 3.0f * forms_powerf(x, 5.0, 1.0) + -(forms_powerf(x, 3.0, 1.0) / 7.0f);
    return t0 + x + -2.0f;
}

// `polynomial` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void polynomial_batch(
    const float *__restrict__ x,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = polynomial(x[i]);
    }
}

// ```text
// inverse_square_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 4 multiplications, 1 division, 1 square root.
__device__ inline float inverse_square_optimised(float x, float y, float z) {
    const float t0 = forms_multiply_addf(z, z, forms_multiply_addf(y, y, x * x));
    return x / (t0 * sqrtf(t0));
}

// `inverse_square_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void inverse_square_optimised_batch(
    const float *__restrict__ x,
    const float *__restrict__ y,
    const float *__restrict__ z,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = inverse_square_optimised(x[i], y[i], z[i]);
    }
}

// ```text
// inverse_square
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 division, 4 function calls.
__device__ inline float inverse_square(float x, float y, float z) {
    const float t0 = forms_powerf(x, 2.0, 1.0) + forms_powerf(y, 2.0, 1.0);
    const float t1 = forms_powerf(t0 + forms_powerf(z, 2.0, 1.0), 3.0, 2.0);
    return x / t1;
}

// `inverse_square` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void inverse_square_batch(
    const float *__restrict__ x,
    const float *__restrict__ y,
    const float *__restrict__ z,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = inverse_square(x[i], y[i], z[i]);
    }
}

// ```text
// several_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 4 multiplications, 1 division.
__device__ inline void several_optimised(float u, float v, float *outputs) {
    const float t0 = 1.0f / forms_multiply_addf(v, v, u * u);
    outputs[0] = u * t0;
    outputs[1] = v * t0;
    outputs[2] = t0;
}

// `several_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void several_optimised_batch(
    const float *__restrict__ u,
    const float *__restrict__ v,
    float *__restrict__ output0,
    float *__restrict__ output1,
    float *__restrict__ output2,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline void several(float u, float v, float *outputs) {
    const float t0 = forms_powerf(u, 2.0, 1.0) + forms_powerf(v, 2.0, 1.0);
    outputs[0] = u / t0;
    outputs[1] = v / t0;
    outputs[2] = 1.0f / t0;
}

// `several` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void several_batch(
    const float *__restrict__ u,
    const float *__restrict__ v,
    float *__restrict__ output0,
    float *__restrict__ output1,
    float *__restrict__ output2,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline float functions_optimised(float t0, float x) {
    const float tt0 = forms_multiply_addf(expf(-fabsf(x)), tanhf(t0), atan2f(sinf(t0), cosf(x)));
    return tt0 - logf(x);
}

// `functions_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void functions_optimised_batch(
    const float *__restrict__ t0,
    const float *__restrict__ x,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = functions_optimised(t0[i], x[i]);
    }
}

// ```text
// functions
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 2 negations, 7 function calls.
__device__ inline float functions(float t0, float x) {
    const float tt0 = atan2f(sinf(t0), cosf(x)) + expf(-fabsf(x)) * tanhf(t0);
    return tt0 + -logf(x);
}

// `functions` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void functions_batch(
    const float *__restrict__ t0,
    const float *__restrict__ x,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = functions(t0[i], x[i]);
    }
}

// ```text
// constants_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 2 multiplications, 1 negation, 1 square root.
__device__ inline void constants_optimised(float x, float *outputs) {
    outputs[0] = -x;
    outputs[1] = 0.7853982f * x;
    outputs[2] = 0.6666667f - x;
    outputs[3] = -0.07957747f;
    outputs[4] = x * sqrtf(2.0f);
    outputs[5] = x - 0.1f;
}

// `constants_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void constants_optimised_batch(
    const float *__restrict__ x,
    float *__restrict__ output0,
    float *__restrict__ output1,
    float *__restrict__ output2,
    float *__restrict__ output3,
    float *__restrict__ output4,
    float *__restrict__ output5,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline void constants(float x, float *outputs) {
    const float t0 = -x;
    outputs[0] = t0;
    outputs[1] = 3.1415927f * x / 4.0f;
    outputs[2] = 0.6666667f + t0;
    outputs[3] = -1.0f / (4.0f * 3.1415927f);
    outputs[4] = sqrtf(2.0f) * x;
    outputs[5] = x + -0.1f;
}

// `constants` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void constants_batch(
    const float *__restrict__ x,
    float *__restrict__ output0,
    float *__restrict__ output1,
    float *__restrict__ output2,
    float *__restrict__ output3,
    float *__restrict__ output4,
    float *__restrict__ output5,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline void roots_optimised(float x, float *outputs) {
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
extern "C" __global__ void roots_optimised_batch(
    const float *__restrict__ x,
    float *__restrict__ output0,
    float *__restrict__ output1,
    float *__restrict__ output2,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline void roots(float x, float *outputs) {
    const float t0 = forms_powerf(x, 1.0, 3.0) + forms_powerf(x, -2.0, 3.0);
    const float t1 = forms_powerf(x, 3.0, 2.0) + -forms_powerf(x, -5.0, 2.0);
    outputs[0] = t0;
    outputs[1] = t1;
    outputs[2] = forms_powerf(x, -7.0, 1.0);
}

// `roots` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void roots_batch(
    const float *__restrict__ x,
    float *__restrict__ output0,
    float *__restrict__ output1,
    float *__restrict__ output2,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline float piecewise_optimised(float x, float y) {
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
            t1 = forms_nanf();
        }
        t0 = t1;
    } else {
        t0 = forms_nanf();
    }
    return x + t0;
}

// `piecewise_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void piecewise_optimised_batch(
    const float *__restrict__ x,
    const float *__restrict__ y,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = piecewise_optimised(x[i], y[i]);
    }
}

// ```text
// piecewise
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 negation, 1 square root, 1 function call, 2 conditionals.
__device__ inline float piecewise(float x, float y) {
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
            t1 = forms_nanf();
        }
        t0 = t1;
    } else {
        t0 = forms_nanf();
    }
    return t0 + x;
}

// `piecewise` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void piecewise_batch(
    const float *__restrict__ x,
    const float *__restrict__ y,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = piecewise(x[i], y[i]);
    }
}

// ```text
// extrema_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 2 multiplications, 1 function call, 2 conditionals.
__device__ inline void extrema_optimised(float x, float y, float *outputs) {
    float t0;
    if (x < y) {
        t0 = x;
    } else if (x >= y) {
        t0 = y;
    } else {
        t0 = forms_nanf();
    }
    float t1;
    if (x < 0.0f) {
        t1 = 0.0f;
    } else if (x >= 0.0f) {
        t1 = x;
    } else {
        t1 = forms_nanf();
    }
    outputs[0] = t0;
    outputs[1] = 0.5f * (x * (x + y + fabsf(x - y)));
    outputs[2] = t1;
}

// `extrema_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void extrema_optimised_batch(
    const float *__restrict__ x,
    const float *__restrict__ y,
    float *__restrict__ output0,
    float *__restrict__ output1,
    float *__restrict__ output2,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline void extrema(float x, float y, float *outputs) {
    float t0;
    if (x < y) {
        t0 = x;
    } else if (x >= y) {
        t0 = y;
    } else {
        t0 = forms_nanf();
    }
    float t1;
    if (x < 0.0f) {
        t1 = 0.0f;
    } else if (x >= 0.0f) {
        t1 = x;
    } else {
        t1 = forms_nanf();
    }
    outputs[0] = t0;
    outputs[1] = x * (x + y + fabsf(x + -y)) / 2.0f;
    outputs[2] = t1;
}

// `extrema` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void extrema_batch(
    const float *__restrict__ x,
    const float *__restrict__ y,
    float *__restrict__ output0,
    float *__restrict__ output1,
    float *__restrict__ output2,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline float lengths_optimised(float x, float y) {
    return forms_hypotf(x, 3.0f * y) + cbrtf(x - y);
}

// `lengths_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void lengths_optimised_batch(
    const float *__restrict__ x,
    const float *__restrict__ y,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = lengths_optimised(x[i], y[i]);
    }
}

// ```text
// lengths
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 1 negation, 2 function calls.
__device__ inline float lengths(float x, float y) {
    return forms_hypotf(x, 3.0f * y) + cbrtf(x + -y);
}

// `lengths` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void lengths_batch(
    const float *__restrict__ x,
    const float *__restrict__ y,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = lengths(x[i], y[i]);
    }
}

// ```text
// unused_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition.
__device__ inline float unused_optimised(float x, float y) {
    (void)x;
    return y + 1.0f;
}

// `unused_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void unused_optimised_batch(
    const float *__restrict__ x,
    const float *__restrict__ y,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = unused_optimised(x[i], y[i]);
    }
}

// ```text
// unused
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition.
__device__ inline float unused(float x, float y) {
    (void)x;
    return y + 1.0f;
}

// `unused` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void unused_batch(
    const float *__restrict__ x,
    const float *__restrict__ y,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = unused(x[i], y[i]);
    }
}

// ```text
// many_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 4 multiplications.
__device__ inline float many_optimised(
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
extern "C" __global__ void many_optimised_batch(
    const float *__restrict__ a,
    const float *__restrict__ b,
    const float *__restrict__ c,
    const float *__restrict__ d,
    const float *__restrict__ e,
    const float *__restrict__ f,
    const float *__restrict__ g,
    const float *__restrict__ H,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = many_optimised(a[i], b[i], c[i], d[i], e[i], f[i], g[i], H[i]);
    }
}

// ```text
// many
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 4 multiplications, 2 negations.
__device__ inline float many(float a, float b, float c, float d, float e, float f, float g, float H) {
    return a * b + c * d + -(e * f + -(g * H));
}

// `many` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void many_batch(
    const float *__restrict__ a,
    const float *__restrict__ b,
    const float *__restrict__ c,
    const float *__restrict__ d,
    const float *__restrict__ e,
    const float *__restrict__ f,
    const float *__restrict__ g,
    const float *__restrict__ H,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = many(a[i], b[i], c[i], d[i], e[i], f[i], g[i], H[i]);
    }
}

// ```text
// products
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 2 multiplications.
__device__ inline float products(float a, float b, float c, float d) {
    return forms_difference_of_productsf(a, b, c, d);
}

// `products` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void products_batch(
    const float *__restrict__ a,
    const float *__restrict__ b,
    const float *__restrict__ c,
    const float *__restrict__ d,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = products(a[i], b[i], c[i], d[i]);
    }
}

// ```text
// inside
// ```
//
// Its value is NaN outside its domain and where an argument it depends on is NaN.
// Cost: 1 addition, 1 division, 1 square root.
__device__ inline float inside(float x, float y) {
    const int t0 = (0.0f < x) & (x + y <= 5.0f) & (y < 0.0f || y > 0.0f);
    return t0 ? sqrtf(x) / y : forms_nanf();
}

// `inside` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void inside_batch(
    const float *__restrict__ x,
    const float *__restrict__ y,
    float *__restrict__ output,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        output[i] = inside(x[i], y[i]);
    }
}

// ```text
// both_inside
// ```
//
// Its value is NaN outside its domain and where an argument it depends on is NaN.
// Cost: 1 addition, 1 division, 1 square root.
__device__ inline void both_inside(float x, float y, float *outputs) {
    const float t0 = x + y;
    const float t1 = (0.0f < x) & (t0 <= 5.0f) & (y < 0.0f || y > 0.0f) ? 1.0f : forms_nanf();
    outputs[0] = t1 * (sqrtf(x) / y);
    outputs[1] = t1 * t0;
}

// `both_inside` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void both_inside_batch(
    const float *__restrict__ x,
    const float *__restrict__ y,
    float *__restrict__ output0,
    float *__restrict__ output1,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        float values[2];
        both_inside(x[i], y[i], values);
        output0[i] = values[0];
        output1[i] = values[1];
    }
}
