//! A map with one component too few, and one that uses a foreign coordinate.

forms::forms! {
    chart UV(u, v);
    chart Space(x, y, z);
    map plane: UV -> Space = (u, v);
    map other: UV -> Space = (u, v, x);
}

fn main() {}
