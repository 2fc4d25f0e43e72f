//! `*` between forms.

forms::forms! {
    chart Plane(x, y);
    form area = dx*dy;
}

fn main() {}
