// Buffers of the entry points: column j of the arguments starts at j * forms_count, and so does
// column j of the outputs.
@group(0) @binding(0) var<storage, read> forms_arguments: array<f32>;
@group(0) @binding(1) var<storage, read_write> forms_outputs: array<f32>;
@group(0) @binding(2) var<uniform> forms_count: u32;

fn forms_nan() -> f32 {
    var bits = 0x7fc00000u;
    return bitcast<f32>(bits);
}

// a b - c d, corrected by the rounding error of one product (Kahan); assumes that fma rounds once.
fn forms_difference_of_products(a: f32, b: f32, c: f32, d: f32) -> f32 {
    let product = c * d;
    let error = fma(-c, d, product);
    return fma(a, b, -product) + error;
}

// sqrt(x*x + y*y) without overflow of a square. Its relative error is at most 24 * 2^-24.
fn forms_hypot(x: f32, y: f32) -> f32 {
    let swaps = abs(x) < abs(y);
    let a = select(abs(x), abs(y), swaps);
    let b = select(abs(y), abs(x), swaps);
    if a == 0.0f {
        return b;
    }
    if a > 3.4028234e38f {
        return a + b;
    }
    let r = b / a;
    return a * sqrt(1.0f + r * r);
}

// The real cube root. WGSL states no usable bound for the error of a power, which a step of Newton's method reduces.
fn forms_cbrt(x: f32) -> f32 {
    let a = abs(x);
    if a == 0.0f || a > 3.4028234e38f {
        return x;
    }
    let y = pow(a, 0.33333334f);
    return sign(x) * (y - (y * y * y - a) / (3.0f * y * y));
}

// ```text
// polynomial_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 5 multiplications.
fn polynomial_optimised(x: f32) -> f32 {
    let t0 = x * x;
    let t1 = x * t0;
    return fma(-0.14285715f, t1, fma(3.0f, t0 * t1, -(2.0f - x)));
}

// `polynomial_optimised` for each i < forms_count, of the columns `x`.
@compute @workgroup_size(64)
fn polynomial_optimised_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = polynomial_optimised(forms_arguments[i]);
}

// ```text
// polynomial
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 1 multiplication, 1 negation, 1 division, 2 function calls.
fn polynomial(x: f32) -> f32 {
    let t0 = -(sign(x) * pow(abs(x), 3.0f) / 7.0f);
    let t1 = 3.0f * (sign(x) * pow(abs(x), 5.0f)) + t0;
    return t1 + x + -2.0f;
}

// `polynomial` for each i < forms_count, of the columns `x`.
@compute @workgroup_size(64)
fn polynomial_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = polynomial(forms_arguments[i]);
}

// ```text
// inverse_square_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 4 multiplications, 1 division, 1 square root.
fn inverse_square_optimised(x: f32, y: f32, z: f32) -> f32 {
    let t0 = fma(z, z, fma(y, y, x * x));
    return x / (t0 * sqrt(t0));
}

// `inverse_square_optimised` for each i < forms_count, of the columns `x`, `y`, `z`.
@compute @workgroup_size(64)
fn inverse_square_optimised_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = inverse_square_optimised(forms_arguments[i], forms_arguments[forms_count + i], forms_arguments[2u * forms_count + i]);
}

// ```text
// inverse_square
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 division, 4 function calls.
fn inverse_square(x: f32, y: f32, z: f32) -> f32 {
    let t0 = pow(abs(x), 2.0f) + pow(abs(y), 2.0f);
    let t1 = pow(t0 + pow(abs(z), 2.0f), 3.0f / 2.0f);
    return x / t1;
}

// `inverse_square` for each i < forms_count, of the columns `x`, `y`, `z`.
@compute @workgroup_size(64)
fn inverse_square_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = inverse_square(forms_arguments[i], forms_arguments[forms_count + i], forms_arguments[2u * forms_count + i]);
}

// ```text
// several_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 4 multiplications, 1 division.
fn several_optimised(u: f32, v: f32) -> array<f32, 3> {
    let t0 = 1.0f / fma(v, v, u * u);
    return array<f32, 3>(u * t0, v * t0, t0);
}

// `several_optimised` for each i < forms_count, of the columns `u`, `v`.
@compute @workgroup_size(64)
fn several_optimised_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    let value = several_optimised(forms_arguments[i], forms_arguments[forms_count + i]);
    forms_outputs[i] = value[0];
    forms_outputs[forms_count + i] = value[1];
    forms_outputs[2u * forms_count + i] = value[2];
}

// ```text
// several
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 3 divisions, 2 function calls.
fn several(u: f32, v: f32) -> array<f32, 3> {
    let t0 = pow(abs(u), 2.0f) + pow(abs(v), 2.0f);
    return array<f32, 3>(u / t0, v / t0, 1.0f / t0);
}

// `several` for each i < forms_count, of the columns `u`, `v`.
@compute @workgroup_size(64)
fn several_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    let value = several(forms_arguments[i], forms_arguments[forms_count + i]);
    forms_outputs[i] = value[0];
    forms_outputs[forms_count + i] = value[1];
    forms_outputs[2u * forms_count + i] = value[2];
}

// ```text
// functions_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 1 negation, 7 function calls.
fn functions_optimised(t0: f32, x: f32) -> f32 {
    let tt0 = fma(exp(-abs(x)), tanh(t0), atan2(sin(t0), cos(x)));
    return tt0 - log(x);
}

// `functions_optimised` for each i < forms_count, of the columns `t0`, `x`.
@compute @workgroup_size(64)
fn functions_optimised_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = functions_optimised(forms_arguments[i], forms_arguments[forms_count + i]);
}

// ```text
// functions
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 2 negations, 7 function calls.
fn functions(t0: f32, x: f32) -> f32 {
    let tt0 = atan2(sin(t0), cos(x)) + exp(-abs(x)) * tanh(t0);
    return tt0 + -log(x);
}

// `functions` for each i < forms_count, of the columns `t0`, `x`.
@compute @workgroup_size(64)
fn functions_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = functions(forms_arguments[i], forms_arguments[forms_count + i]);
}

// ```text
// constants_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 2 multiplications, 1 negation, 1 square root.
fn constants_optimised(x: f32) -> array<f32, 6> {
    return array<f32, 6>(-x, 0.7853982f * x, 0.6666667f - x, -0.07957747f, x * sqrt(2.0f), x - 0.1f);
}

// `constants_optimised` for each i < forms_count, of the columns `x`.
@compute @workgroup_size(64)
fn constants_optimised_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    let value = constants_optimised(forms_arguments[i]);
    forms_outputs[i] = value[0];
    forms_outputs[forms_count + i] = value[1];
    forms_outputs[2u * forms_count + i] = value[2];
    forms_outputs[3u * forms_count + i] = value[3];
    forms_outputs[4u * forms_count + i] = value[4];
    forms_outputs[5u * forms_count + i] = value[5];
}

// ```text
// constants
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 3 multiplications, 1 negation, 2 divisions, 1 square root.
fn constants(x: f32) -> array<f32, 6> {
    let t0 = -x;
    return array<f32, 6>(t0, 3.1415927f * x / 4.0f, 0.6666667f + t0, -1.0f / (4.0f * 3.1415927f), sqrt(2.0f) * x, x + -0.1f);
}

// `constants` for each i < forms_count, of the columns `x`.
@compute @workgroup_size(64)
fn constants_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    let value = constants(forms_arguments[i]);
    forms_outputs[i] = value[0];
    forms_outputs[forms_count + i] = value[1];
    forms_outputs[2u * forms_count + i] = value[2];
    forms_outputs[3u * forms_count + i] = value[3];
    forms_outputs[4u * forms_count + i] = value[4];
    forms_outputs[5u * forms_count + i] = value[5];
}

// ```text
// roots_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 11 multiplications, 1 division, 1 function call.
fn roots_optimised(x: f32) -> array<f32, 3> {
    let t0 = pow(x, 1.0f / 6.0f);
    let t1 = t0 * t0;
    let t2 = 1.0f / t0;
    let t3 = t2 * t2;
    let t4 = t3 * t3;
    let t5 = t2 * t4;
    let t6 = t5 * t5;
    let t7 = t5 * t6;
    return array<f32, 3>(t1 + t4, fma(t0, x * t1, -t7), t3 * (t6 * (t7 * t7)));
}

// `roots_optimised` for each i < forms_count, of the columns `x`.
@compute @workgroup_size(64)
fn roots_optimised_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    let value = roots_optimised(forms_arguments[i]);
    forms_outputs[i] = value[0];
    forms_outputs[forms_count + i] = value[1];
    forms_outputs[2u * forms_count + i] = value[2];
}

// ```text
// roots
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 negation, 5 function calls.
fn roots(x: f32) -> array<f32, 3> {
    let t0 = pow(x, 1.0f / 3.0f) + pow(x, -2.0f / 3.0f);
    let t1 = pow(x, 3.0f / 2.0f) + -pow(x, -5.0f / 2.0f);
    return array<f32, 3>(t0, t1, sign(x) * pow(abs(x), -7.0f));
}

// `roots` for each i < forms_count, of the columns `x`.
@compute @workgroup_size(64)
fn roots_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    let value = roots(forms_arguments[i]);
    forms_outputs[i] = value[0];
    forms_outputs[forms_count + i] = value[1];
    forms_outputs[2u * forms_count + i] = value[2];
}

// ```text
// piecewise_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 square root, 1 function call, 2 conditionals.
fn piecewise_optimised(x: f32, y: f32) -> f32 {
    var t0: f32;
    if x < y {
        t0 = sqrt(y - x);
    } else if x >= y {
        var t1: f32;
        if y <= 0.0f {
            t1 = x;
        } else if y > 0.0f {
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

// `piecewise_optimised` for each i < forms_count, of the columns `x`, `y`.
@compute @workgroup_size(64)
fn piecewise_optimised_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = piecewise_optimised(forms_arguments[i], forms_arguments[forms_count + i]);
}

// ```text
// piecewise
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 negation, 1 square root, 1 function call, 2 conditionals.
fn piecewise(x: f32, y: f32) -> f32 {
    var t0: f32;
    if x < y {
        t0 = sqrt(y + -x);
    } else if x >= y {
        var t1: f32;
        if y <= 0.0f {
            t1 = x;
        } else if y > 0.0f {
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

// `piecewise` for each i < forms_count, of the columns `x`, `y`.
@compute @workgroup_size(64)
fn piecewise_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = piecewise(forms_arguments[i], forms_arguments[forms_count + i]);
}

// ```text
// extrema_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 2 multiplications, 1 function call, 2 conditionals.
fn extrema_optimised(x: f32, y: f32) -> array<f32, 3> {
    var t0: f32;
    if x < y {
        t0 = x;
    } else if x >= y {
        t0 = y;
    } else {
        t0 = forms_nan();
    }
    var t1: f32;
    if x < 0.0f {
        t1 = 0.0f;
    } else if x >= 0.0f {
        t1 = x;
    } else {
        t1 = forms_nan();
    }
    return array<f32, 3>(t0, 0.5f * (x * (x + y + abs(x - y))), t1);
}

// `extrema_optimised` for each i < forms_count, of the columns `x`, `y`.
@compute @workgroup_size(64)
fn extrema_optimised_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    let value = extrema_optimised(forms_arguments[i], forms_arguments[forms_count + i]);
    forms_outputs[i] = value[0];
    forms_outputs[forms_count + i] = value[1];
    forms_outputs[2u * forms_count + i] = value[2];
}

// ```text
// extrema
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 1 multiplication, 1 negation, 1 division, 1 function call, 2 conditionals.
fn extrema(x: f32, y: f32) -> array<f32, 3> {
    var t0: f32;
    if x < y {
        t0 = x;
    } else if x >= y {
        t0 = y;
    } else {
        t0 = forms_nan();
    }
    var t1: f32;
    if x < 0.0f {
        t1 = 0.0f;
    } else if x >= 0.0f {
        t1 = x;
    } else {
        t1 = forms_nan();
    }
    return array<f32, 3>(t0, x * (x + y + abs(x + -y)) / 2.0f, t1);
}

// `extrema` for each i < forms_count, of the columns `x`, `y`.
@compute @workgroup_size(64)
fn extrema_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    let value = extrema(forms_arguments[i], forms_arguments[forms_count + i]);
    forms_outputs[i] = value[0];
    forms_outputs[forms_count + i] = value[1];
    forms_outputs[2u * forms_count + i] = value[2];
}

// ```text
// lengths_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 2 function calls.
fn lengths_optimised(x: f32, y: f32) -> f32 {
    return forms_hypot(x, 3.0f * y) + forms_cbrt(x - y);
}

// `lengths_optimised` for each i < forms_count, of the columns `x`, `y`.
@compute @workgroup_size(64)
fn lengths_optimised_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = lengths_optimised(forms_arguments[i], forms_arguments[forms_count + i]);
}

// ```text
// lengths
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 1 multiplication, 1 negation, 2 function calls.
fn lengths(x: f32, y: f32) -> f32 {
    return forms_hypot(x, 3.0f * y) + forms_cbrt(x + -y);
}

// `lengths` for each i < forms_count, of the columns `x`, `y`.
@compute @workgroup_size(64)
fn lengths_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = lengths(forms_arguments[i], forms_arguments[forms_count + i]);
}

// ```text
// unused_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition.
fn unused_optimised(x: f32, y: f32) -> f32 {
    return y + 1.0f;
}

// `unused_optimised` for each i < forms_count, of the columns `x`, `y`.
@compute @workgroup_size(64)
fn unused_optimised_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = unused_optimised(forms_arguments[i], forms_arguments[forms_count + i]);
}

// ```text
// unused
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition.
fn unused(x: f32, y: f32) -> f32 {
    return y + 1.0f;
}

// `unused` for each i < forms_count, of the columns `x`, `y`.
@compute @workgroup_size(64)
fn unused_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = unused(forms_arguments[i], forms_arguments[forms_count + i]);
}

// ```text
// many_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 4 multiplications.
fn many_optimised(a: f32, b: f32, c: f32, d: f32, e: f32, f: f32, g: f32, H: f32) -> f32 {
    return fma(c, d, a * b) - fma(-g, H, e * f);
}

// `many_optimised` for each i < forms_count, of the columns `a`, `b`, `c`, `d`, `e`, `f`, `g`, `H`.
@compute @workgroup_size(64)
fn many_optimised_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = many_optimised(forms_arguments[i], forms_arguments[forms_count + i], forms_arguments[2u * forms_count + i], forms_arguments[3u * forms_count + i], forms_arguments[4u * forms_count + i], forms_arguments[5u * forms_count + i], forms_arguments[6u * forms_count + i], forms_arguments[7u * forms_count + i]);
}

// ```text
// many
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 4 multiplications, 2 negations.
fn many(a: f32, b: f32, c: f32, d: f32, e: f32, f: f32, g: f32, H: f32) -> f32 {
    return a * b + c * d + -(e * f + -(g * H));
}

// `many` for each i < forms_count, of the columns `a`, `b`, `c`, `d`, `e`, `f`, `g`, `H`.
@compute @workgroup_size(64)
fn many_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = many(forms_arguments[i], forms_arguments[forms_count + i], forms_arguments[2u * forms_count + i], forms_arguments[3u * forms_count + i], forms_arguments[4u * forms_count + i], forms_arguments[5u * forms_count + i], forms_arguments[6u * forms_count + i], forms_arguments[7u * forms_count + i]);
}

// ```text
// products
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 2 multiplications.
fn products(a: f32, b: f32, c: f32, d: f32) -> f32 {
    return forms_difference_of_products(a, b, c, d);
}

// `products` for each i < forms_count, of the columns `a`, `b`, `c`, `d`.
@compute @workgroup_size(64)
fn products_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = products(forms_arguments[i], forms_arguments[forms_count + i], forms_arguments[2u * forms_count + i], forms_arguments[3u * forms_count + i]);
}

// ```text
// inside
// ```
//
// Its value is NaN outside its domain and where an argument it depends on is NaN.
// Cost: 1 addition, 1 division, 1 square root.
fn inside(x: f32, y: f32) -> f32 {
    if !(0.0f < x) {
        return forms_nan();
    }
    if !(x + y <= 5.0f) {
        return forms_nan();
    }
    if !(y < 0.0f || y > 0.0f) {
        return forms_nan();
    }
    return sqrt(x) / y;
}

// `inside` for each i < forms_count, of the columns `x`, `y`.
@compute @workgroup_size(64)
fn inside_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    forms_outputs[i] = inside(forms_arguments[i], forms_arguments[forms_count + i]);
}

// ```text
// both_inside
// ```
//
// Its value is NaN outside its domain and where an argument it depends on is NaN.
// Cost: 1 addition, 1 division, 1 square root.
fn both_inside(x: f32, y: f32) -> array<f32, 2> {
    let t0 = x + y;
    if !(0.0f < x) {
        return array<f32, 2>(forms_nan(), forms_nan());
    }
    if !(t0 <= 5.0f) {
        return array<f32, 2>(forms_nan(), forms_nan());
    }
    if !(y < 0.0f || y > 0.0f) {
        return array<f32, 2>(forms_nan(), forms_nan());
    }
    return array<f32, 2>(sqrt(x) / y, t0);
}

// `both_inside` for each i < forms_count, of the columns `x`, `y`.
@compute @workgroup_size(64)
fn both_inside_batch(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let i = id.x + 64u * groups.x * id.y;
    if i >= forms_count {
        return;
    }
    let value = both_inside(forms_arguments[i], forms_arguments[forms_count + i]);
    forms_outputs[i] = value[0];
    forms_outputs[forms_count + i] = value[1];
}
