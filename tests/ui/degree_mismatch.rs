//! Sums of different degree, and a declared degree that differs from the degree of the form.

forms::forms! {
    chart Plane(x, y);
    form mixed = dx + dx^dy;
    form area: 1 = dx^dy;
    prove compared: dx == dx^dy;
}

fn main() {}
