//! Functions of the operation table that WGSL lacks, defined in WGSL.
//!
//! *Leaves*: text of functions of `f32` that use no compensated operation, so that it does not matter
//! in which direction a device rounds. The relative error of each but the cube root is bounded, as the comment above
//! it and `Arithmetic::SHADER` state, if every operation has the error that the specification of
//! WGSL allows. The coefficients are those of the lanes of `forms-math`.

use crate::expression::Operation;
use crate::kernel::{Instruction, Program};

const EXPM1: &str = "\
// exp(x) - 1 = 2^k exp(r) - 1 with 3/4 <= exp(r) < 3/2, so that k = 0 where the value is small.
// Its relative error is at most 14 * 2^-24.
fn forms_expm1(x: f32) -> f32 {
    if x < -18.0f {
        return -1.0f;
    }
    if x > 88.8f {
        return x * 3.4028235e38f;
    }
    let k = floor(x * 1.442695f + 0.4150375f);
    let r = (x - k * 0.69314575f) - k * 1.4286068e-6f;
    let q = 0.04166641f + r * (0.008332683f + r * (0.0013938746f + r * 0.00020345004f));
    let p = r + (r * r) * (0.5f + r * (0.16666669f + r * q));
    let half = bitcast<f32>(u32(i32(k) + 126i) << 23u);
    return 2.0f * (half * p + (half - 0.5f));
}
";

const LOG1P: &str = "\
// log(1 + x), near 0 by 2 artanh(x/(2 + x)). Its relative error is at most 32 * 2^-24.
fn forms_log1p(x: f32) -> f32 {
    if x > -0.29f && x < 0.41f {
        let s = x / (2.0f + x);
        let q = s * s;
        return s * (2.0f + q * (0.6666667f + q * (0.40000123f + q * (0.28550813f + q * 0.23330697f))));
    }
    return log(1.0f + x);
}
";

const ERF: &str = "\
// erf(x), from 1 on by 1 - exp(log(erfc(x))). Its relative error is at most 10 * 2^-24.
fn forms_erf(x: f32) -> f32 {
    let a = abs(x);
    if a >= 1.0f {
        let t = min(a, 4.0f) - 1.0f;
        let u = -0.041503053f + t * (0.009895253f + t * (-0.0018296357f + t * 0.00018655171f));
        return sign(x) * (1.0f - exp(-1.8496056f + t * (-2.6389668f + t * (-0.8431178f + t * u))));
    }
    let s = x * x;
    let u = 0.005222611f + s * (-0.0008508545f + s * (0.00011451737f + s * -1.0216748e-5f));
    return x * (1.1283792f + s * (-0.37612638f + s * (0.1128379f + s * (-0.026865946f + s * u))));
}
";

const HYPOT: &str = "\
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
";

const CBRT: &str = "\
// The real cube root. WGSL states no usable bound for the error of a power, which a step of Newton's method reduces.
fn forms_cbrt(x: f32) -> f32 {
    let a = abs(x);
    if a == 0.0f || a > 3.4028234e38f {
        return x;
    }
    let y = pow(a, 0.33333334f);
    return sign(x) * (y - (y * y * y - a) / (3.0f * y * y));
}
";

/// Definition of a function.
pub(super) struct Definition {
    operation: Operation,
    pub(super) name: &'static str,
    pub(super) text: &'static str,
}

/// Every definition.
pub(super) const DEFINITIONS: [Definition; 5] = [
    Definition { operation: Operation::Expm1, name: "forms_expm1", text: EXPM1 },
    Definition { operation: Operation::Log1p, name: "forms_log1p", text: LOG1P },
    Definition { operation: Operation::Erf, name: "forms_erf", text: ERF },
    Definition { operation: Operation::Hypot, name: "forms_hypot", text: HYPOT },
    Definition { operation: Operation::Cbrt, name: "forms_cbrt", text: CBRT },
];

/// Returns the definition of a function, if there is one.
pub(super) fn definition(operation: Operation) -> Option<&'static Definition> {
    DEFINITIONS.iter().find(|definition| definition.operation == operation)
}

impl Definition {
    /// Whether a program calls the function.
    pub(super) fn is_called(&self, program: &Program) -> bool {
        let calls = |i: &Instruction| matches!(i, Instruction::Call(called, _) if *called == self.operation);
        program.instructions.iter().any(calls)
    }
}
