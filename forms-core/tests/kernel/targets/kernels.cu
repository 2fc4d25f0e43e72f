// NaN.
__device__ inline double forms_nan() {
    return __longlong_as_double(0x7ff8000000000000LL);
}

// a b + c, rounded once.
__device__ inline double forms_multiply_add(double a, double b, double c) {
    return fma(a, b, c);
}

// a b - c d within 2 ulp, by the error of one product (Kahan).
__device__ inline double forms_difference_of_products(double a, double b, double c, double d) {
    const double product = c * d;
    const double error = fma(-c, d, product);
    return fma(a, b, -product) + (isfinite(error) ? error : 0);
}

// x^(n/d); needs x >= 0 if d > 1.
__device__ inline double forms_power(double x, double n, double d) {
    const double base = x;
    const double exponent = n / d;
    const double rest = fma(-exponent, d, n) / d;
    const double value = pow(base, exponent);
    const double power = rest == 0.0 || base == 0.0 || isinf(base) ? value : value + value * (rest * log(base));
    return (double)power;
}

// sqrt(x*x + y*y) without overflow of a square; NaN if x or y is NaN.
__device__ inline double forms_hypot(double x, double y) {
    return isnan(x) || isnan(y) ? x + y : hypot(x, y);
}

// ```text
// polynomial_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 5 multiplications.
__device__ inline double polynomial_optimised(double x) {
    const double t0 = x * x;
    const double t1 = x * t0;
    const double t2 = forms_multiply_add(3.0, t0 * t1, -(2.0 - x));
    return forms_multiply_add(-0.14285714285714285, t1, t2);
}

// `polynomial_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void polynomial_optimised_batch(
    const double *__restrict__ x,
    double *__restrict__ output,
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
__device__ inline double polynomial(double x) {
    const double t0 = 3.0 * forms_power(x, 5.0, 1.0) + -(forms_power(x, 3.0, 1.0) / 7.0);
    return t0 + x + -2.0;
}

// `polynomial` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void polynomial_batch(
    const double *__restrict__ x,
    double *__restrict__ output,
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
__device__ inline double inverse_square_optimised(double x, double y, double z) {
    const double t0 = forms_multiply_add(z, z, forms_multiply_add(y, y, x * x));
    return x / (t0 * sqrt(t0));
}

// `inverse_square_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void inverse_square_optimised_batch(
    const double *__restrict__ x,
    const double *__restrict__ y,
    const double *__restrict__ z,
    double *__restrict__ output,
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
__device__ inline double inverse_square(double x, double y, double z) {
    const double t0 = forms_power(x, 2.0, 1.0) + forms_power(y, 2.0, 1.0);
    const double t1 = forms_power(t0 + forms_power(z, 2.0, 1.0), 3.0, 2.0);
    return x / t1;
}

// `inverse_square` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void inverse_square_batch(
    const double *__restrict__ x,
    const double *__restrict__ y,
    const double *__restrict__ z,
    double *__restrict__ output,
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
__device__ inline void several_optimised(double u, double v, double *outputs) {
    const double t0 = 1.0 / forms_multiply_add(v, v, u * u);
    outputs[0] = u * t0;
    outputs[1] = v * t0;
    outputs[2] = t0;
}

// `several_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void several_optimised_batch(
    const double *__restrict__ u,
    const double *__restrict__ v,
    double *__restrict__ output0,
    double *__restrict__ output1,
    double *__restrict__ output2,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline void several(double u, double v, double *outputs) {
    const double t0 = forms_power(u, 2.0, 1.0) + forms_power(v, 2.0, 1.0);
    outputs[0] = u / t0;
    outputs[1] = v / t0;
    outputs[2] = 1.0 / t0;
}

// `several` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void several_batch(
    const double *__restrict__ u,
    const double *__restrict__ v,
    double *__restrict__ output0,
    double *__restrict__ output1,
    double *__restrict__ output2,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline double functions_optimised(double t0, double x) {
    const double tt0 = forms_multiply_add(exp(-fabs(x)), tanh(t0), atan2(sin(t0), cos(x)));
    return tt0 - log(x);
}

// `functions_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void functions_optimised_batch(
    const double *__restrict__ t0,
    const double *__restrict__ x,
    double *__restrict__ output,
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
__device__ inline double functions(double t0, double x) {
    const double tt0 = atan2(sin(t0), cos(x)) + exp(-fabs(x)) * tanh(t0);
    return tt0 + -log(x);
}

// `functions` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void functions_batch(
    const double *__restrict__ t0,
    const double *__restrict__ x,
    double *__restrict__ output,
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
__device__ inline void constants_optimised(double x, double *outputs) {
    outputs[0] = -x;
    outputs[1] = 0.7853981633974483 * x;
    outputs[2] = 0.6666666666666666 - x;
    outputs[3] = -0.07957747154594767;
    outputs[4] = x * sqrt(2.0);
    outputs[5] = x - 0.1;
}

// `constants_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void constants_optimised_batch(
    const double *__restrict__ x,
    double *__restrict__ output0,
    double *__restrict__ output1,
    double *__restrict__ output2,
    double *__restrict__ output3,
    double *__restrict__ output4,
    double *__restrict__ output5,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline void constants(double x, double *outputs) {
    const double t0 = -x;
    outputs[0] = t0;
    outputs[1] = 3.141592653589793 * x / 4.0;
    outputs[2] = 0.6666666666666666 + t0;
    outputs[3] = -1.0 / (4.0 * 3.141592653589793);
    outputs[4] = sqrt(2.0) * x;
    outputs[5] = x + -0.1;
}

// `constants` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void constants_batch(
    const double *__restrict__ x,
    double *__restrict__ output0,
    double *__restrict__ output1,
    double *__restrict__ output2,
    double *__restrict__ output3,
    double *__restrict__ output4,
    double *__restrict__ output5,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline void roots_optimised(double x, double *outputs) {
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
extern "C" __global__ void roots_optimised_batch(
    const double *__restrict__ x,
    double *__restrict__ output0,
    double *__restrict__ output1,
    double *__restrict__ output2,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline void roots(double x, double *outputs) {
    const double t0 = forms_power(x, 1.0, 3.0) + forms_power(x, -2.0, 3.0);
    const double t1 = forms_power(x, 3.0, 2.0) + -forms_power(x, -5.0, 2.0);
    outputs[0] = t0;
    outputs[1] = t1;
    outputs[2] = forms_power(x, -7.0, 1.0);
}

// `roots` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void roots_batch(
    const double *__restrict__ x,
    double *__restrict__ output0,
    double *__restrict__ output1,
    double *__restrict__ output2,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline double piecewise_optimised(double x, double y) {
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
            t1 = forms_nan();
        }
        t0 = t1;
    } else {
        t0 = forms_nan();
    }
    return x + t0;
}

// `piecewise_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void piecewise_optimised_batch(
    const double *__restrict__ x,
    const double *__restrict__ y,
    double *__restrict__ output,
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
__device__ inline double piecewise(double x, double y) {
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
            t1 = forms_nan();
        }
        t0 = t1;
    } else {
        t0 = forms_nan();
    }
    return t0 + x;
}

// `piecewise` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void piecewise_batch(
    const double *__restrict__ x,
    const double *__restrict__ y,
    double *__restrict__ output,
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
__device__ inline void extrema_optimised(double x, double y, double *outputs) {
    double t0;
    if (x < y) {
        t0 = x;
    } else if (x >= y) {
        t0 = y;
    } else {
        t0 = forms_nan();
    }
    double t1;
    if (x < 0.0) {
        t1 = 0.0;
    } else if (x >= 0.0) {
        t1 = x;
    } else {
        t1 = forms_nan();
    }
    outputs[0] = t0;
    outputs[1] = 0.5 * (x * (x + y + fabs(x - y)));
    outputs[2] = t1;
}

// `extrema_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void extrema_optimised_batch(
    const double *__restrict__ x,
    const double *__restrict__ y,
    double *__restrict__ output0,
    double *__restrict__ output1,
    double *__restrict__ output2,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline void extrema(double x, double y, double *outputs) {
    double t0;
    if (x < y) {
        t0 = x;
    } else if (x >= y) {
        t0 = y;
    } else {
        t0 = forms_nan();
    }
    double t1;
    if (x < 0.0) {
        t1 = 0.0;
    } else if (x >= 0.0) {
        t1 = x;
    } else {
        t1 = forms_nan();
    }
    outputs[0] = t0;
    outputs[1] = x * (x + y + fabs(x + -y)) / 2.0;
    outputs[2] = t1;
}

// `extrema` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void extrema_batch(
    const double *__restrict__ x,
    const double *__restrict__ y,
    double *__restrict__ output0,
    double *__restrict__ output1,
    double *__restrict__ output2,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
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
__device__ inline double lengths_optimised(double x, double y) {
    return forms_hypot(x, 3.0 * y) + cbrt(x - y);
}

// `lengths_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void lengths_optimised_batch(
    const double *__restrict__ x,
    const double *__restrict__ y,
    double *__restrict__ output,
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
__device__ inline double lengths(double x, double y) {
    return forms_hypot(x, 3.0 * y) + cbrt(x + -y);
}

// `lengths` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void lengths_batch(
    const double *__restrict__ x,
    const double *__restrict__ y,
    double *__restrict__ output,
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
__device__ inline double unused_optimised(double x, double y) {
    (void)x;
    return y + 1.0;
}

// `unused_optimised` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void unused_optimised_batch(
    const double *__restrict__ x,
    const double *__restrict__ y,
    double *__restrict__ output,
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
__device__ inline double unused(double x, double y) {
    (void)x;
    return y + 1.0;
}

// `unused` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void unused_batch(
    const double *__restrict__ x,
    const double *__restrict__ y,
    double *__restrict__ output,
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
__device__ inline double many_optimised(
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
extern "C" __global__ void many_optimised_batch(
    const double *__restrict__ a,
    const double *__restrict__ b,
    const double *__restrict__ c,
    const double *__restrict__ d,
    const double *__restrict__ e,
    const double *__restrict__ f,
    const double *__restrict__ g,
    const double *__restrict__ H,
    double *__restrict__ output,
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
__device__ inline double many(
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
extern "C" __global__ void many_batch(
    const double *__restrict__ a,
    const double *__restrict__ b,
    const double *__restrict__ c,
    const double *__restrict__ d,
    const double *__restrict__ e,
    const double *__restrict__ f,
    const double *__restrict__ g,
    const double *__restrict__ H,
    double *__restrict__ output,
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
__device__ inline double products(double a, double b, double c, double d) {
    return forms_difference_of_products(a, b, c, d);
}

// `products` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void products_batch(
    const double *__restrict__ a,
    const double *__restrict__ b,
    const double *__restrict__ c,
    const double *__restrict__ d,
    double *__restrict__ output,
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
__device__ inline double inside(double x, double y) {
    const int t0 = (0.0 < x) & (x + y <= 5.0) & (y < 0.0 || y > 0.0);
    return t0 ? sqrt(x) / y : forms_nan();
}

// `inside` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void inside_batch(
    const double *__restrict__ x,
    const double *__restrict__ y,
    double *__restrict__ output,
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
__device__ inline void both_inside(double x, double y, double *outputs) {
    const double t0 = x + y;
    const double t1 = (0.0 < x) & (t0 <= 5.0) & (y < 0.0 || y > 0.0) ? 1.0 : forms_nan();
    outputs[0] = t1 * (sqrt(x) / y);
    outputs[1] = t1 * t0;
}

// `both_inside` for each i < count. Outputs must not overlap other arrays.
extern "C" __global__ void both_inside_batch(
    const double *__restrict__ x,
    const double *__restrict__ y,
    double *__restrict__ output0,
    double *__restrict__ output1,
    unsigned long long count) {
    const unsigned long long stride = (unsigned long long)gridDim.x * blockDim.x;
    for (unsigned long long i = (unsigned long long)blockIdx.x * blockDim.x + threadIdx.x; i < count; i += stride) {
        double values[2];
        both_inside(x[i], y[i], values);
        output0[i] = values[0];
        output1[i] = values[1];
    }
}
