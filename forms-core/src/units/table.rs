//! Table of units: base units of the SI, derived units with their definitions, and decimal
//! prefixes.
//!
//! Photometric units are based on the lumen rather than the candela, cd = lm/sr, so that the
//! steradian of an intensity stays visible. Source: BIPM, *The International System of Units*, 9th
//! edition, tables 2, 4, 7 and 8.

use num_rational::BigRational;

/// Factor of a unit: a base unit or a prime number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Base {
    /// kilogram
    Kilogram,
    /// metre
    Metre,
    /// second
    Second,
    /// ampere
    Ampere,
    /// kelvin
    Kelvin,
    /// mole
    Mole,
    /// lumen
    Lumen,
    /// radian
    Radian,
    /// steradian
    Steradian,
    /// Prime factor of a unit's size.
    Prime(u64),
}

/// The name of the radian.
pub(super) const RADIAN: &str = "rad";
/// The name of the steradian.
pub(super) const STERADIAN: &str = "sr";

/// Unit in terms of the base units: its numeric factor n·10ᵉ and the exponents of the base units.
struct Row {
    name: &'static str,
    /// Whether it takes prefixes.
    prefixed: bool,
    size: (u64, i32),
    bases: &'static [(Base, i32)],
}

const fn si(name: &'static str, bases: &'static [(Base, i32)]) -> Row {
    Row { name, prefixed: true, size: (1, 0), bases }
}

const fn plain(name: &'static str, size: (u64, i32), bases: &'static [(Base, i32)]) -> Row {
    Row { name, prefixed: false, size, bases }
}

use Base::{Ampere, Kelvin, Kilogram, Lumen, Metre, Mole, Radian, Second, Steradian};

const TABLE: &[Row] = &[
    si("m", &[(Metre, 1)]),
    si("s", &[(Second, 1)]),
    Row { name: "g", prefixed: true, size: (1, -3), bases: &[(Kilogram, 1)] },
    si("A", &[(Ampere, 1)]),
    si("K", &[(Kelvin, 1)]),
    si("mol", &[(Mole, 1)]),
    si("cd", &[(Lumen, 1), (Steradian, -1)]),
    plain(RADIAN, (1, 0), &[(Radian, 1)]),
    plain(STERADIAN, (1, 0), &[(Steradian, 1)]),
    si("Hz", &[(Second, -1)]),
    si("N", &[(Kilogram, 1), (Metre, 1), (Second, -2)]),
    si("Pa", &[(Kilogram, 1), (Metre, -1), (Second, -2)]),
    si("J", &[(Kilogram, 1), (Metre, 2), (Second, -2)]),
    si("W", &[(Kilogram, 1), (Metre, 2), (Second, -3)]),
    si("C", &[(Ampere, 1), (Second, 1)]),
    si("V", &[(Kilogram, 1), (Metre, 2), (Second, -3), (Ampere, -1)]),
    si("F", &[(Kilogram, -1), (Metre, -2), (Second, 4), (Ampere, 2)]),
    si("ohm", &[(Kilogram, 1), (Metre, 2), (Second, -3), (Ampere, -2)]),
    si("S", &[(Kilogram, -1), (Metre, -2), (Second, 3), (Ampere, 2)]),
    si("Wb", &[(Kilogram, 1), (Metre, 2), (Second, -2), (Ampere, -1)]),
    si("T", &[(Kilogram, 1), (Second, -2), (Ampere, -1)]),
    si("H", &[(Kilogram, 1), (Metre, 2), (Second, -2), (Ampere, -2)]),
    si("lm", &[(Lumen, 1)]),
    si("lx", &[(Lumen, 1), (Metre, -2)]),
    Row {
        name: "eV",
        prefixed: true,
        size: (1_602_176_634, -28),
        bases: &[(Kilogram, 1), (Metre, 2), (Second, -2)],
    },
    Row { name: "L", prefixed: true, size: (1, -3), bases: &[(Metre, 3)] },
    plain("min", (60, 0), &[(Second, 1)]),
    plain("h", (3600, 0), &[(Second, 1)]),
];

const PREFIXES: &[(&str, i32)] = &[
    ("f", -15),
    ("p", -12),
    ("n", -9),
    ("u", -6),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
];

/// Returns the unit with this name in base units and primes; `None` if there is none.
pub(super) fn row(name: &str) -> Option<Vec<(Base, BigRational)>> {
    if let Some(row) = TABLE.iter().find(|row| row.name == name) {
        return Some(meaning(row, 0));
    }
    PREFIXES.iter().find_map(|&(prefix, exponent)| {
        let rest = name.strip_prefix(prefix)?;
        let row = TABLE.iter().find(|row| row.prefixed && row.name == rest)?;
        Some(meaning(row, exponent))
    })
}

/// Returns a row multiplied by a power of ten.
fn meaning(row: &Row, exponent: i32) -> Vec<(Base, BigRational)> {
    let (number, ten) = (row.size.0, row.size.1 + exponent);
    let tens = [2, 5].map(|prime| (Base::Prime(prime), ten)).into_iter().filter(|factor| factor.1 != 0);
    let primes = prime_factors(number).into_iter().map(|prime| (Base::Prime(prime), 1));
    let all = row.bases.iter().copied().chain(tens).chain(primes);
    all.map(|(base, power)| (base, BigRational::from_integer(power.into()))).collect()
}

/// Returns the prime factors of a number with their multiplicity.
fn prime_factors(mut number: u64) -> Vec<u64> {
    let mut factors = Vec::new();
    let mut candidate = 2;
    while candidate * candidate <= number {
        while number.is_multiple_of(candidate) {
            factors.push(candidate);
            number /= candidate;
        }
        candidate += 1;
    }
    factors.extend((number > 1).then_some(number));
    factors
}

/// Suggests a unit for a word that is not one: the same letters in another case, or the unit's full
/// name.
pub(super) fn suggestion(word: &str) -> Option<&'static str> {
    const WORDS: &[(&str, &str)] = &[
        ("ampere", "A"),
        ("candela", "cd"),
        ("deg", "rad"),
        ("degree", "rad"),
        ("gram", "g"),
        ("hertz", "Hz"),
        ("hour", "h"),
        ("joule", "J"),
        ("kelvin", "K"),
        ("kilogram", "kg"),
        ("lumen", "lm"),
        ("lux", "lx"),
        ("meter", "m"),
        ("metre", "m"),
        ("micron", "um"),
        ("minute", "min"),
        ("mole", "mol"),
        ("newton", "N"),
        ("pascal", "Pa"),
        ("radian", "rad"),
        ("sec", "s"),
        ("second", "s"),
        ("steradian", "sr"),
        ("volt", "V"),
        ("watt", "W"),
    ];
    let lower = word.to_ascii_lowercase();
    let singular = lower.strip_suffix('s').unwrap_or(&lower);
    let named = WORDS.iter().find(|(name, _)| *name == lower || *name == singular).map(|entry| entry.1);
    named.or_else(|| TABLE.iter().map(|row| row.name).find(|name| name.eq_ignore_ascii_case(word)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_one_unit_only() {
        let mut names: Vec<String> = TABLE.iter().map(|row| row.name.to_owned()).collect();
        for row in TABLE.iter().filter(|row| row.prefixed) {
            names.extend(PREFIXES.iter().map(|(prefix, _)| format!("{prefix}{}", row.name)));
        }
        names.sort();
        let doubled: Vec<&str> =
            names.windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0].as_str()).collect();
        assert!(doubled.is_empty(), "{doubled:?}");
    }

    #[test]
    fn the_factors_of_a_number_are_prime_and_multiply_to_it() {
        for number in (1..500).chain([1_602_176_634]) {
            let factors = prime_factors(number);
            assert_eq!(factors.iter().product::<u64>(), number);
            assert!(
                factors.iter().all(|&p| (2..p).take_while(|q| q * q <= p).all(|q| p % q != 0)),
                "{number}"
            );
        }
    }
}
