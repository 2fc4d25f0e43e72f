//! Polynomials in numbered generators with rational coefficients.

use num_bigint::BigInt;
use num_rational::BigRational;
use std::collections::{BTreeMap, HashMap};

/// The exponents by generator, without zeros at the end: compared lexicographically, which products respect.
type Monomial = Vec<u16>;

/// Σ c m without zero coefficients; the last term leads.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) struct Polynomial(pub(crate) BTreeMap<Monomial, BigRational>);

fn zero() -> BigRational {
    BigRational::from_integer(BigInt::from(0))
}

fn trimmed(mut monomial: Monomial) -> Monomial {
    while monomial.last() == Some(&0) {
        monomial.pop();
    }
    monomial
}

fn product_of(a: &[u16], b: &[u16]) -> Monomial {
    let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
    let mut product = long.to_vec();
    product.iter_mut().zip(short).for_each(|(sum, exponent)| *sum += exponent);
    product
}

fn quotient_of(a: &[u16], b: &[u16]) -> Option<Monomial> {
    let mut quotient = a.to_vec();
    for (rest, exponent) in quotient.iter_mut().zip(b) {
        *rest = rest.checked_sub(*exponent)?;
    }
    (b.len() <= a.len()).then(|| trimmed(quotient))
}

impl Polynomial {
    pub(crate) fn constant(value: BigRational) -> Self {
        Polynomial(if value == zero() { BTreeMap::new() } else { BTreeMap::from([(vec![], value)]) })
    }

    pub(crate) fn integer(value: i64) -> Self {
        Polynomial::constant(BigRational::from_integer(value.into()))
    }

    /// gᵉ
    pub(crate) fn generator(number: usize, exponent: u16) -> Self {
        let mut monomial = vec![0; number + 1];
        monomial[number] = exponent;
        Polynomial(BTreeMap::from([(trimmed(monomial), BigRational::from_integer(1.into()))]))
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    pub(crate) fn as_constant(&self) -> Option<BigRational> {
        match self.0.iter().next() {
            None => Some(zero()),
            Some((monomial, value)) => (self.0.len() == 1 && monomial.is_empty()).then(|| value.clone()),
        }
    }

    /// The largest exponent of a generator, or of all.
    pub(crate) fn degree(&self, generator: Option<usize>) -> u16 {
        let of = |m: &Monomial| generator.map_or(m.iter().max(), |g| m.get(g)).copied();
        self.0.keys().filter_map(of).max().unwrap_or(0)
    }

    /// The leading coefficient; zero has none but 1 serves.
    pub(crate) fn leading(&self) -> BigRational {
        self.0.last_key_value().map_or(BigRational::from_integer(1.into()), |term| term.1.clone())
    }

    pub(crate) fn add(mut self, other: &Polynomial) -> Self {
        for (monomial, value) in &other.0 {
            let sum = self.0.remove(monomial).unwrap_or_else(zero) + value;
            if sum != zero() {
                self.0.insert(monomial.clone(), sum);
            }
        }
        self
    }

    pub(crate) fn scale(mut self, by: &BigRational) -> Self {
        self.0.values_mut().for_each(|value| *value *= by);
        self
    }

    pub(crate) fn multiply(&self, other: &Polynomial) -> Self {
        let mut sums: HashMap<Monomial, BigRational> = HashMap::new();
        for (m, a) in &self.0 {
            for (n, b) in &other.0 {
                *sums.entry(product_of(m, n)).or_insert_with(zero) += a * b;
            }
        }
        Polynomial(sums.into_iter().filter(|term| term.1 != zero()).collect())
    }

    /// The quotient, if the division leaves no rest.
    pub(crate) fn divide(&self, by: &Polynomial) -> Option<Self> {
        let (leading, coefficient) = by.0.last_key_value()?;
        if let (Some(own), Some(least)) = (self.0.first_key_value(), by.0.first_key_value()) {
            // the last terms divide each other too, which is quickly seen
            quotient_of(own.0, least.0)?;
        }
        let (mut rest, mut quotient) = (self.clone(), Polynomial::default());
        while let Some((monomial, value)) = rest.0.last_key_value() {
            let term = Polynomial(BTreeMap::from([(quotient_of(monomial, leading)?, -value / coefficient)]));
            rest = rest.add(&by.multiply(&term));
            quotient = quotient.add(&term);
        }
        Some(quotient.scale(&-BigRational::from_integer(1.into())))
    }

    /// The terms by their power of one generator, that power taken out.
    pub(crate) fn by_power(&self, generator: usize) -> BTreeMap<u16, Polynomial> {
        let mut parts: BTreeMap<u16, Polynomial> = BTreeMap::new();
        for (monomial, value) in &self.0 {
            let mut rest = monomial.clone();
            let exponent = rest.get_mut(generator).map_or(0, std::mem::take);
            parts.entry(exponent).or_default().0.insert(trimmed(rest), value.clone());
        }
        parts
    }

    /// The remainder by gⁿ = value: aₖ gᵏ becomes aₖ value^⌊k/n⌋ g^(k mod n).
    pub(crate) fn reduce(&self, generator: usize, order: u16, value: &Polynomial) -> Self {
        let mut sum = Polynomial::default();
        let mut powers = vec![Polynomial::integer(1)];
        for (exponent, part) in self.by_power(generator) {
            while powers.len() <= (exponent / order) as usize {
                powers.push(powers[powers.len() - 1].multiply(value));
            }
            let rest = Polynomial::generator(generator, exponent % order);
            sum = sum.add(&part.multiply(&powers[(exponent / order) as usize]).multiply(&rest));
        }
        sum
    }
}
