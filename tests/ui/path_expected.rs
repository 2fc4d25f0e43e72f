//! Something that is no path.

forms::include_forms!(sphere.forms);

fn main() {}
