//! A true equation outside the class that is decided.

forms::forms! {
    chart Line(x);
    prove reciprocal: atan(x) + atan(1/x) == pi/2 where x > 0;
}

fn main() {}
