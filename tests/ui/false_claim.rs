//! False claims, each with a witness.

forms::forms! {
    chart Plane(x, y);
    prove closed: d(x**2*y*dy) == 0;
    prove root: sqrt(x**2) == x;
    refute twice: d(d(x*y)) == 0;
}

fn main() {}
