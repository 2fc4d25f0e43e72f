//! A false equation, at item and at statement position.

forms::prove! { chart Line(x); x + x == x**2 }

fn main() {
    forms::prove!(param n; (n + 1)**2 == n**2 + 1);
}
