//! A true equation outside the decidable class.

forms::forms! {
    chart Line(x);
    prove third: 3*sin(asin(x**3)/3) - 4*sin(asin(x**3)/3)**3 == x**3;
}

fn main() {}
