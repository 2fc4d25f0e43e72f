//! A misspelt name, with the nearest known one.

forms::forms! {
    chart Plane(radius, angle);
    let area = raduis**2*angle/2;
    form w = dangel;
}

fn main() {}
