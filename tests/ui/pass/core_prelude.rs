//! Names in the expansion do not resolve to the user's names.

#![no_implicit_prelude]

mod core {}
mod std {}

::forms::forms! {
    pub kernel double(x) = 2*x;
    prove same: 1 == 1;
}

fn main() {
    let _ = double(1.0);
    let _ = ::forms::form! { chart Line(x); dx };
}
