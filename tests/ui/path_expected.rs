//! An argument that is not a path.

forms::include_forms!(sphere.forms);

fn main() {}
