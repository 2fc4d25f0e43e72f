//! Bodies assembled by another macro.

macro_rules! power_rule {
    ($variable:ident, $exponent:literal, $derivative:expr) => {
        forms::prove! { chart Line($variable); diff($variable**$exponent, $variable) == $exponent*$derivative }
    };
}

power_rule!(t, 2, t + 0);
power_rule!(s, 1, s - s + 1);

fn main() {}
