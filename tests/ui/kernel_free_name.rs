//! A kernel that depends on more than its arguments.

forms::forms! {
    chart Plane(x, y);
    pub kernel product(x) = x*y;
}

fn main() {
    product(1.0);
}
