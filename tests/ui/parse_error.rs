//! A missing operator and a missing `;`: both are reported, and nothing else.

forms::forms! {
    chart Plane(x, y);
    let p = 2 x;
    let q = p + x
    prove fine: q - p == x;
}

fn main() {}
