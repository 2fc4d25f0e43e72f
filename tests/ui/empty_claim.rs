//! A vacuous statement.

forms::forms! {
    chart Line(x);
    prove nowhere: log(-x**2) == 5;
}

fn main() {}
