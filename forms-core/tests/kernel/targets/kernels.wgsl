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

// ```text
// constants_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 2 additions, 2 multiplications, 1 negation, 1 square root.
fn constants_optimised(x: f32) -> array<f32, 6> {
    return array<f32, 6>(-x, 0.7853982f * x, 0.6666667f - x, -0.07957747f, x * sqrt(2.0f), x - 0.1f);
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

// ```text
// unused_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition.
fn unused_optimised(x: f32, y: f32) -> f32 {
    return y + 1.0f;
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

// ```text
// many_optimised
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 3 additions, 4 multiplications.
fn many_optimised(a: f32, b: f32, c: f32, d: f32, e: f32, f: f32, g: f32, H: f32) -> f32 {
    return fma(c, d, a * b) - fma(-g, H, e * f);
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

// ```text
// products
// ```
//
// Its value is NaN where an argument it depends on is NaN.
// Cost: 1 addition, 2 multiplications.
fn products(a: f32, b: f32, c: f32, d: f32) -> f32 {
    return forms_difference_of_products(a, b, c, d);
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
