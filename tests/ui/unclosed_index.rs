//! Values in the wrong brackets.

forms::forms! {
    chart Plane(x, y);
    prove degree: d[Plane, x](x) == dx;
}

fn main() {}
