//! Names that other languages have and this one has not, each with its notation here.

/// Names in other languages, and the same in this one.
const NAMES: &[(&[&str], &str)] = &[
    (&["pow", "powf", "powi", "power"], "write `x**y` for a power"),
    (&["sqr", "square"], "write `x**2` for a square"),
    (&["rsqrt", "inversesqrt"], "write `1/sqrt(x)`"),
    (&["fmax", "maximum"], "write `max(a, b)`"),
    (&["fmin", "minimum"], "write `min(a, b)`"),
    (&["clamp", "saturate"], "write `min(max(x, a), b)`"),
    (&["sign", "sgn", "signum"], "write `if x < 0 { -1 } else { 1 }`"),
    (&["mix", "lerp"], "write `a + t*(b - a)`"),
    (&["fma", "mad"], "write `a*b + c`: it is rounded once where the target can do that"),
    (&["ln"], "the natural logarithm is `log`"),
    (&["log2"], "write `log(x)/log(2)`"),
    (&["log10"], "write `log(x)/log(10)`"),
    (&["exp2"], "write `2**x`"),
    (&["e", "E"], "write `exp(x)` for a power of e, and `exp(1)` for e itself"),
    (&["M_PI", "tau", "TAU"], "write `pi`, and `2*pi` for the whole angle"),
    (&["asinh", "arcsinh", "arsinh"], "write `log(x + sqrt(x**2 + 1))`"),
    (&["acosh", "arccosh", "arcosh"], "write `log(x + sqrt(x**2 - 1))`"),
    (&["atanh", "arctanh", "artanh"], "write `log1p(2*x/(1 - x))/2`"),
    (&["length"], "write `norm(p)` for an array, or `sqrt(x**2 + y**2 + z**2)`"),
    (&["normalize", "normalise"], "write `p/norm(p)`"),
    (
        &["floor", "ceil", "round", "trunc", "fmod", "mod"],
        "functions here are smooth or in pieces: `if x < 1 { a } else { b }`",
    ),
    (&["prod"], "write `product(q, k = 0..3)`"),
];

/// Returns the notation here for a name of another language.
pub(super) fn meaning(name: &str) -> Option<&'static str> {
    NAMES.iter().find(|(names, _)| names.contains(&name)).map(|(_, here)| *here)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::words::is_function;

    #[test]
    fn a_name_stands_once_and_is_not_one_of_this_language() {
        let all: Vec<&str> = NAMES.iter().flat_map(|(names, _)| *names).copied().collect();
        for (place, name) in all.iter().enumerate() {
            assert!(!all[..place].contains(name) && !is_function(name), "{name}");
        }
    }
}
