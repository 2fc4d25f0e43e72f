//! A kernel of an unknown function.

forms::forms! {
    chart Plane(x, y);
    fn L(x, y);
    kernel radiance(x, y) = 2*L;
}

fn main() {}
