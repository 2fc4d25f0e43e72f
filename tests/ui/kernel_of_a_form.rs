//! A kernel whose value is a form.

forms::kernel! { chart Plane(x, y); area(x, y) = x*dx^dy }

fn main() {}
