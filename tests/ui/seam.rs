//! Pieces that do not agree at the boundary of their condition.

forms::forms! {
    chart UV(u, v);
    let height = u - v;

    pub kernel hat(u, v) = if height > 0 { 1 - height } else { 1 + height };
    pub kernel cap(u, v) = if height > 1 { height } else { 0 };
    pub kernel step(u, v) = if jump height > 1 { height } else { 0 };
    pub kernel sign(u) = if u != 0 { abs(u)/u } else { 1 };
}

fn main() {
    println!("{} {}", hat(1.0, 2.0), step(1.0, 2.0));
}
