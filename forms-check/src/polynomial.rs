//! Polynomials in numbered generators with rational coefficients.

use num_bigint::BigInt;
use num_rational::BigRational;
use std::collections::{BTreeMap, HashMap};

/// Maximum number of generators of one proof.
pub(crate) const MOST_GENERATORS: usize = 32;

/// Maximum number of bits of a coefficient.
pub(crate) const MOST_BITS: u64 = 1 << 15;

/// Exponent of each generator. Products respect the lexicographic order.
type Monomial = [u8; MOST_GENERATORS];

/// Polynomial Σ c m without zero coefficients; the last term is the leading term.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Polynomial(pub(crate) BTreeMap<Monomial, BigRational>);

fn zero() -> BigRational {
    BigRational::from_integer(BigInt::from(0))
}

/// Returns sum + a b; integers need no common divisor.
fn plus_product(sum: &BigRational, a: &BigRational, b: &BigRational) -> BigRational {
    if [sum, a, b].iter().all(|c| c.is_integer()) {
        return BigRational::from_integer(sum.numer() + a.numer() * b.numer());
    }
    sum + a * b
}

/// Returns the product; `None` if an exponent is too large for its type.
fn product_of(a: &Monomial, b: &Monomial) -> Option<Monomial> {
    let mut product = *a;
    for (exponent, more) in product.iter_mut().zip(b) {
        *exponent = exponent.checked_add(*more)?;
    }
    Some(product)
}

/// Whether a number is too long for further computation.
pub(crate) fn is_long(c: &BigRational) -> bool {
    c.numer().bits().max(c.denom().bits()) > MOST_BITS
}

fn quotient_of(a: &Monomial, b: &Monomial) -> Option<Monomial> {
    let mut quotient = *a;
    for (rest, exponent) in quotient.iter_mut().zip(b) {
        *rest = rest.checked_sub(*exponent)?;
    }
    Some(quotient)
}

impl Polynomial {
    pub(crate) fn constant(value: BigRational) -> Self {
        let is_zero = value == zero();
        Polynomial(if is_zero { BTreeMap::new() } else { BTreeMap::from([([0; MOST_GENERATORS], value)]) })
    }

    pub(crate) fn integer(value: i64) -> Self {
        Polynomial::constant(BigRational::from_integer(value.into()))
    }

    /// Returns gᵉ.
    pub(crate) fn generator(number: usize, exponent: u8) -> Self {
        let mut monomial = [0; MOST_GENERATORS];
        monomial[number] = exponent;
        Polynomial(BTreeMap::from([(monomial, BigRational::from_integer(1.into()))]))
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    pub(crate) fn as_constant(&self) -> Option<BigRational> {
        match self.0.last_key_value() {
            None => Some(zero()),
            Some((monomial, value)) => (*monomial == [0; MOST_GENERATORS]).then(|| value.clone()),
        }
    }

    /// Returns the largest exponent of a generator, or of all.
    pub(crate) fn degree(&self, generator: Option<usize>) -> u8 {
        let of = |m: &Monomial| generator.map_or(m.iter().max().copied(), |g| Some(m[g]));
        self.0.keys().filter_map(of).max().unwrap_or(0)
    }

    /// Returns the leading coefficient, and 1 for the zero polynomial, which has none.
    pub(crate) fn leading(&self) -> BigRational {
        self.0.last_key_value().map_or(BigRational::from_integer(1.into()), |term| term.1.clone())
    }

    pub(crate) fn add(mut self, other: &Polynomial) -> Self {
        for (monomial, value) in &other.0 {
            let sum = self.0.remove(monomial).unwrap_or_else(zero) + value;
            if sum != zero() {
                self.0.insert(*monomial, sum);
            }
        }
        self
    }

    pub(crate) fn scale(mut self, by: &BigRational) -> Self {
        self.0.values_mut().for_each(|value| *value *= by);
        self
    }

    /// Returns the product; `None` where an exponent or a coefficient would be too large.
    pub(crate) fn multiply(&self, other: &Polynomial) -> Option<Self> {
        let mut sums: HashMap<Monomial, BigRational> = HashMap::new();
        for (m, a) in &self.0 {
            for (n, b) in &other.0 {
                let sum = sums.entry(product_of(m, n)?).or_insert_with(zero);
                *sum = plus_product(sum, a, b);
            }
        }
        let product: BTreeMap<_, _> = sums.into_iter().filter(|term| term.1 != zero()).collect();
        (!product.values().any(is_long)).then_some(Polynomial(product))
    }

    /// Returns the quotient, if the division is exact and needs no exponent that is too large.
    pub(crate) fn divide(&self, by: &Polynomial) -> Option<Self> {
        let (leading, coefficient) = by.0.last_key_value()?;
        if let (Some(own), Some(least)) = (self.0.first_key_value(), by.0.first_key_value()) {
            // quick rejection: the smallest terms must divide each other too
            quotient_of(own.0, least.0)?;
        }
        let (mut rest, mut quotient) = (self.clone(), Polynomial::default());
        while let Some((monomial, value)) = rest.0.last_key_value() {
            let term = Polynomial(BTreeMap::from([(quotient_of(monomial, leading)?, -value / coefficient)]));
            rest = rest.add(&by.multiply(&term)?);
            quotient = quotient.add(&term);
        }
        Some(quotient.scale(&-BigRational::from_integer(1.into())))
    }

    /// Returns the remainder by gⁿ = value, in which gᵏ becomes value^⌊k/n⌋ g^(k mod n); `None`
    /// where it would be too large.
    pub(crate) fn reduce(&self, generator: usize, order: u8, value: &Polynomial) -> Option<Self> {
        let (mut sum, mut parts) = (Polynomial::default(), BTreeMap::<u8, Polynomial>::new());
        for (monomial, c) in &self.0 {
            let mut rest = *monomial;
            rest[generator] %= order;
            let part = if rest == *monomial {
                &mut sum
            } else {
                parts.entry(monomial[generator] / order).or_default()
            };
            part.0.insert(rest, c.clone());
        }
        let (mut power, mut reached) = (Polynomial::integer(1), 0);
        for (times, part) in parts {
            for _ in reached..times {
                power = power.multiply(value)?;
            }
            reached = times;
            sum = sum.add(&part.multiply(&power)?);
        }
        Some(sum)
    }
}
