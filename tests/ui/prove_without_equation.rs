//! Declarations without an equation; an equation with a name.

forms::prove! { chart Line(x); }

forms::prove! { chart Line(x); prove named: x == x }

fn main() {}
