//! A Greek letter, a percent sign and a number in Rust's notation.

#![allow(mixed_script_confusables, reason = "the Greek letter is the mistake")]

forms::forms! {
    chart Sphere(θ, phi);
    let a = 1_000*phi;
    let b = 5 % phi;
}

fn main() {}
