//! The program `forms`.

fn main() {}
