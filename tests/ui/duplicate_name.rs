//! Two declarations of one name; two statements of one name.

forms::forms! {
    chart Plane(x, y);
    let r = x + y;
    let r = x - y;
    let dx = 1;
    prove same: x == x;
    prove same: y == y;
}

fn main() {}
