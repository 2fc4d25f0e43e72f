//! Declarations without a kernel.

forms::kernel! { chart Line(x); let p = x**2; }

fn main() {}
