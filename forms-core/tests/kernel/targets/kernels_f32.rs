/// ```text
/// polynomial_optimised
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 3 additions, 5 multiplications.
pub fn polynomial_optimised(x: f32) -> f32 {
    let t0 = x * x;
    let t1 = x * t0;
    3.0 * (t0 * t1) - (2.0 - x) - 0.14285715 * t1
}

/// ```text
/// polynomial
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 3 additions, 1 multiplication, 1 negation, 1 division, 2 function calls.
pub fn polynomial(x: f32) -> f32 {
    let t0 = 3.0 * x.powf(5.0) + -(x.powf(3.0) / 7.0);
    t0 + x + -2.0
}

/// ```text
/// inverse_square_optimised
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 2 additions, 4 multiplications, 1 division, 1 square root.
pub fn inverse_square_optimised(x: f32, y: f32, z: f32) -> f32 {
    let t0 = x * x + y * y + z * z;
    x / (t0 * t0.sqrt())
}

/// ```text
/// inverse_square
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 2 additions, 1 division, 4 function calls.
pub fn inverse_square(x: f32, y: f32, z: f32) -> f32 {
    let t0 = x.powf(2.0) + y.powf(2.0) + z.powf(2.0);
    let t1 = <f32 as forms_math::Real>::power(t0, 3, 2);
    x / t1
}

/// ```text
/// several_optimised
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 1 addition, 4 multiplications, 1 division.
pub fn several_optimised(u: f32, v: f32) -> [f32; 3] {
    let t0 = 1.0 / (u * u + v * v);
    [u * t0, v * t0, t0]
}

/// ```text
/// several
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 1 addition, 3 divisions, 2 function calls.
pub fn several(u: f32, v: f32) -> [f32; 3] {
    let t0 = u.powf(2.0) + v.powf(2.0);
    [u / t0, v / t0, 1.0 / t0]
}

/// ```text
/// functions_optimised
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 2 additions, 1 multiplication, 1 negation, 7 function calls.
pub fn functions_optimised(t0: f32, x: f32) -> f32 {
    let tt0 = t0.sin().atan2(x.cos()) + (-x.abs()).exp() * t0.tanh();
    tt0 - x.ln()
}

/// ```text
/// functions
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 2 additions, 1 multiplication, 2 negations, 7 function calls.
pub fn functions(t0: f32, x: f32) -> f32 {
    let tt0 = t0.sin().atan2(x.cos()) + (-x.abs()).exp() * t0.tanh();
    tt0 + -x.ln()
}

/// ```text
/// constants_optimised
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 2 additions, 2 multiplications, 1 negation, 1 square root.
pub fn constants_optimised(x: f32) -> [f32; 6] {
    [
        -x,
        ::core::f32::consts::FRAC_PI_4 * x,
        0.6666667 - x,
        -0.07957747,
        x * 2.0_f32.sqrt(),
        x - 0.1,
    ]
}

/// ```text
/// constants
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 2 additions, 3 multiplications, 1 negation, 2 divisions, 1 square root.
pub fn constants(x: f32) -> [f32; 6] {
    let t0 = -x;
    let t1 = -1.0 / (4.0 * ::core::f32::consts::PI);
    [
        t0,
        ::core::f32::consts::PI * x / 4.0,
        0.6666667 + t0,
        t1,
        2.0_f32.sqrt() * x,
        x + -0.1,
    ]
}

/// ```text
/// roots_optimised
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 2 additions, 11 multiplications, 1 division, 1 function call.
pub fn roots_optimised(x: f32) -> [f32; 3] {
    let t0 = <f32 as forms_math::Real>::power(x, 1, 6);
    let t1 = t0 * t0;
    let t2 = 1.0 / t0;
    let t3 = t2 * t2;
    let t4 = t3 * t3;
    let t5 = t2 * t4;
    let t6 = t5 * t5;
    let t7 = t5 * t6;
    [t1 + t4, t0 * (x * t1) - t7, t3 * (t6 * (t7 * t7))]
}

/// ```text
/// roots
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 2 additions, 1 negation, 5 function calls.
pub fn roots(x: f32) -> [f32; 3] {
    let t0 = <f32 as forms_math::Real>::power(x, 1, 3);
    let t1 = <f32 as forms_math::Real>::power(x, -2, 3);
    let t2 = <f32 as forms_math::Real>::power(x, 3, 2);
    let t3 = <f32 as forms_math::Real>::power(x, -5, 2);
    [t0 + t1, t2 + -t3, x.powf(-7.0)]
}

/// ```text
/// piecewise_optimised
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 2 additions, 1 square root, 1 function call, 2 conditionals.
pub fn piecewise_optimised(x: f32, y: f32) -> f32 {
    let t0 = if x < y {
        (y - x).sqrt()
    } else if x >= y {
        if y <= 0.0 {
            x
        } else if y > 0.0 {
            y.ln()
        } else {
            f32::NAN
        }
    } else {
        f32::NAN
    };
    x + t0
}

/// ```text
/// piecewise
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 2 additions, 1 negation, 1 square root, 1 function call, 2 conditionals.
pub fn piecewise(x: f32, y: f32) -> f32 {
    let t0 = if x < y {
        (y + -x).sqrt()
    } else if x >= y {
        if y <= 0.0 {
            x
        } else if y > 0.0 {
            y.ln()
        } else {
            f32::NAN
        }
    } else {
        f32::NAN
    };
    t0 + x
}

/// ```text
/// extrema_optimised
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 3 additions, 2 multiplications, 1 function call, 2 conditionals.
pub fn extrema_optimised(x: f32, y: f32) -> [f32; 3] {
    let t0 = if x < y {
        x
    } else if x >= y {
        y
    } else {
        f32::NAN
    };
    let t1 = if x < 0.0 {
        0.0
    } else if x >= 0.0 {
        x
    } else {
        f32::NAN
    };
    [t0, 0.5 * (x * (x + y + (x - y).abs())), t1]
}

/// ```text
/// extrema
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 3 additions, 1 multiplication, 1 negation, 1 division, 1 function call, 2 conditionals.
pub fn extrema(x: f32, y: f32) -> [f32; 3] {
    let t0 = if x < y {
        x
    } else if x >= y {
        y
    } else {
        f32::NAN
    };
    let t1 = if x < 0.0 {
        0.0
    } else if x >= 0.0 {
        x
    } else {
        f32::NAN
    };
    [t0, x * (x + y + (x + -y).abs()) / 2.0, t1]
}

/// ```text
/// lengths_optimised
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 2 additions, 1 multiplication, 2 function calls.
pub fn lengths_optimised(x: f32, y: f32) -> f32 {
    let t0 = <f32 as forms_math::Real>::hypot(x, 3.0 * y);
    t0 + (x - y).cbrt()
}

/// ```text
/// lengths
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 2 additions, 1 multiplication, 1 negation, 2 function calls.
pub fn lengths(x: f32, y: f32) -> f32 {
    let t0 = <f32 as forms_math::Real>::hypot(x, 3.0 * y);
    t0 + (x + -y).cbrt()
}

/// ```text
/// unused_optimised
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 1 addition.
pub fn unused_optimised(_x: f32, y: f32) -> f32 {
    y + 1.0
}

/// ```text
/// unused
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 1 addition.
pub fn unused(_x: f32, y: f32) -> f32 {
    y + 1.0
}

/// ```text
/// many_optimised
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 3 additions, 4 multiplications.
#[allow(clippy::too_many_arguments, reason = "one for each variable")]
#[allow(non_snake_case, reason = "the names of the formula")]
pub fn many_optimised(a: f32, b: f32, c: f32, d: f32, e: f32, f: f32, g: f32, H: f32) -> f32 {
    a * b + c * d - (e * f - g * H)
}

/// ```text
/// many
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 3 additions, 4 multiplications, 2 negations.
#[allow(clippy::too_many_arguments, reason = "one for each variable")]
#[allow(non_snake_case, reason = "the names of the formula")]
pub fn many(a: f32, b: f32, c: f32, d: f32, e: f32, f: f32, g: f32, H: f32) -> f32 {
    a * b + c * d + -(e * f + -(g * H))
}

/// ```text
/// products
/// ```
///
/// Its value is NaN where an argument it depends on is NaN.
/// Cost: 1 addition, 2 multiplications.
pub fn products(a: f32, b: f32, c: f32, d: f32) -> f32 {
    <f32 as forms_math::Real>::difference_of_products(a, b, c, d)
}

/// ```text
/// inside
/// ```
///
/// Its value is NaN outside its domain and where an argument it depends on is NaN.
/// Cost: 1 addition, 1 division, 1 square root.
pub fn inside(x: f32, y: f32) -> f32 {
    let inside = 0.0 < x;
    if !inside {
        return f32::NAN;
    }
    let inside = x + y <= 5.0;
    if !inside {
        return f32::NAN;
    }
    let inside = y.partial_cmp(&0.0).is_some_and(::core::cmp::Ordering::is_ne);
    if !inside {
        return f32::NAN;
    }
    x.sqrt() / y
}

/// ```text
/// both_inside
/// ```
///
/// Its value is NaN outside its domain and where an argument it depends on is NaN.
/// Cost: 1 addition, 1 division, 1 square root.
pub fn both_inside(x: f32, y: f32) -> [f32; 2] {
    let t0 = x + y;
    let inside = 0.0 < x;
    if !inside {
        return [f32::NAN; 2];
    }
    let inside = t0 <= 5.0;
    if !inside {
        return [f32::NAN; 2];
    }
    let inside = y.partial_cmp(&0.0).is_some_and(::core::cmp::Ordering::is_ne);
    if !inside {
        return [f32::NAN; 2];
    }
    [x.sqrt() / y, t0]
}
