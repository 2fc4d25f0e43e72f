//! Radiance behind a homogeneous medium that absorbs and emits: the solution L₀ e^(−σt) + j (1 −
//! e^(−σt))/σ of dL/dt = −σL + j (Chandrasekhar, Radiative Transfer, §7). One argument reduction
//! gives both the exponential and the exponential minus one. At σt = 0 the emission term is jt.

use super::batch;
use super::vector::Vector;

/// Columns: L₀, σ, t, j.
#[inline(always)]
fn value<V: Vector>([radiance, sigma, t, emission]: [V; 4]) -> V {
    let depth = sigma * t;
    let (left, change) = (-depth).exp_and_exp_m1();
    let zero = V::splat(0.0);
    let length = V::if_less(zero, depth, -change / sigma, t);
    radiance.mul_add(left, emission * length)
}

batch::batch!(radiance, 4, super::value);
