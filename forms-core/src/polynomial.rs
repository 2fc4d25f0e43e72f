//! Polynomials with integer coefficients in many variables: the engine under the normal form.
//!
//! ```text
//! terms ─ pack ─▶ sorted monomials (words) + coefficients (i64 → i128 → BigInt)
//!                    │  add · multiply · divide · gcd · square-free parts · coprime basis
//!                    ▼
//!                 sorted monomials + coefficients, on the narrowest layout and the lowest rung
//! ```
//! Layout and rung are functions of the value, so equality and hashing compare the stored data.
//! Variables are numbers from 0; terms are ordered lexicographically with variable 0 the greatest,
//! the leading term first. A term takes space for every variable up to the polynomial's last, so
//! variables are best numbered densely. Exponents reach 2³¹ − 1. Callers that expect larger
//! exponents, or more terms than fit in memory, call [`Polynomial::product_size_bound`] and
//! [`Polynomial::exponent_bound`] before they multiply.

mod arithmetic;
mod basis;
mod coefficient;
mod content;
mod division;
mod evaluation;
mod gcd;
mod growth;
mod image;
mod interpolation;
pub mod modular;
mod monomial;
mod product;
mod square_free;
mod term;
mod view;

pub use basis::coprime_basis;

use coefficient::Coefficients;
use monomial::Layout;
use num_bigint::BigInt;
use num_traits::{One, Zero};
use std::fmt;

/// A polynomial over ℤ.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Polynomial {
    layout: Layout,
    /// Packed monomials, `layout.words` words per term, in decreasing order.
    monomials: Vec<u64>,
    coefficients: Coefficients,
}

impl Polynomial {
    /// 0
    pub fn zero() -> Self {
        Polynomial {
            layout: Layout::CONSTANT,
            monomials: Vec::new(),
            coefficients: Coefficients::Small(Vec::new()),
        }
    }

    /// 1
    pub fn one() -> Self {
        Self::integer(1)
    }

    /// Returns an integer as a polynomial.
    pub fn integer(number: i64) -> Self {
        if number == 0 {
            return Self::zero();
        }
        let coefficients = Coefficients::Small(vec![number]);
        Polynomial { layout: Layout::CONSTANT, monomials: Vec::new(), coefficients }
    }

    /// Returns an integer of any size as a polynomial.
    pub fn constant(number: BigInt) -> Self {
        Self::from_terms([(Vec::new(), number)])
    }

    /// Returns the variable with this number.
    pub fn variable(index: u32) -> Self {
        Self::monomial_of(&[(index, 1)])
    }

    /// Returns ∏ xᵢ^eᵢ over different variables, with exponents above 0.
    ///
    /// # Panics
    /// If an exponent is beyond 2³¹ − 1.
    pub(crate) fn monomial_of(powers: &[(u32, u32)]) -> Self {
        let variables = powers.iter().map(|power| u64::from(power.0) + 1).max().unwrap_or(0);
        let largest = powers.iter().map(|power| u64::from(power.1)).max().unwrap_or(0);
        let layout = Layout::fitting(variables, largest);
        let mut monomials = Vec::with_capacity(layout.words);
        layout.pack(powers, &mut monomials);
        Polynomial { layout, monomials, coefficients: Coefficients::Small(vec![1]) }
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.term_count() == 0
    }

    /// Whether it is 1.
    pub fn is_one(&self) -> bool {
        self.layout.words == 0
            && matches!(&self.coefficients, Coefficients::Small(numbers) if numbers[..] == [1])
    }

    /// Whether no variable occurs.
    pub fn is_constant(&self) -> bool {
        self.layout.words == 0
    }

    /// Returns the value of a constant.
    pub fn as_constant(&self) -> Option<BigInt> {
        self.is_constant().then(|| self.leading_coefficient())
    }

    /// Returns the value of a constant other than 0 that fits in 64 bits.
    fn as_small_constant(&self) -> Option<i64> {
        match &self.coefficients {
            Coefficients::Small(numbers) if self.is_constant() => numbers.first().copied(),
            _ => None,
        }
    }

    /// Returns the number of terms.
    pub fn term_count(&self) -> usize {
        self.coefficients.len()
    }

    /// Returns the number of 64-bit words of its coefficients, at least one for each term.
    pub(crate) fn word_count(&self) -> u64 {
        self.coefficients.word_count()
    }

    /// Returns the coefficient of the leading term; 0 for 0.
    pub fn leading_coefficient(&self) -> BigInt {
        if self.is_zero() { BigInt::zero() } else { self.coefficients.get(0) }
    }

    /// Whether the leading coefficient is negative.
    pub fn is_negative(&self) -> bool {
        !self.is_zero() && self.coefficients.is_negative(0)
    }

    /// Returns the greatest exponent of a variable; 0 for 0.
    pub fn degree(&self, variable: u32) -> u32 {
        let Some((word, shift)) = self.layout.field(variable) else { return 0 };
        let mask = self.layout.mask();
        let exponents = (0..self.term_count()).map(|term| self.monomial(term)[word] >> shift & mask);
        exponents.max().unwrap_or(0) as u32
    }

    /// Returns the greatest sum of a term's exponents; 0 for 0, and `u32::MAX` if it is larger.
    pub fn total_degree(&self) -> u32 {
        let degrees = (0..self.term_count()).map(|term| {
            let exponents = self.layout.unpack(self.monomial(term));
            exponents.iter().map(|&(_, exponent)| u64::from(exponent)).sum::<u64>()
        });
        u32::try_from(degrees.max().unwrap_or(0)).unwrap_or(u32::MAX)
    }

    /// Returns a bound on every exponent, which is exact from 2¹⁵ on and costs nothing below.
    pub fn exponent_bound(&self) -> u32 {
        if self.layout.bits < 32 {
            return (1 << (self.layout.bits - 1)) - 1;
        }
        self.degrees().into_iter().max().unwrap_or(0)
    }

    /// Returns the number of 64-bit words of the longest coefficient, at least 1.
    pub fn coefficient_words(&self) -> u64 {
        self.coefficients.words()
    }

    /// Returns the variables that occur, in increasing order.
    pub fn variables(&self) -> Vec<u32> {
        let mut union = vec![0; self.layout.words];
        for term in 0..self.term_count() {
            for (all, word) in union.iter_mut().zip(self.monomial(term)) {
                *all |= word;
            }
        }
        self.layout.unpack(&union).into_iter().map(|(variable, _)| variable).collect()
    }

    /// Whether a variable occurs.
    pub fn contains(&self, variable: u32) -> bool {
        self.degree(variable) != 0
    }

    /// Returns the packed monomial of a term.
    #[inline(always)]
    fn monomial(&self, term: usize) -> &[u64] {
        &self.monomials[term * self.layout.words..(term + 1) * self.layout.words]
    }

    /// Returns the greatest exponent of each field of the layout.
    fn degrees(&self) -> Vec<u32> {
        let mut degrees = vec![0; self.layout.fields()];
        let (bits, mask) = (self.layout.bits, self.layout.mask());
        for term in 0..self.term_count() {
            for (word, fields) in self.monomial(term).iter().zip(degrees.chunks_mut(self.layout.per_word())) {
                let mut rest = *word;
                while rest != 0 {
                    let field = rest.leading_zeros() / bits;
                    let shift = 64 - bits * (field + 1);
                    let degree: &mut u32 = &mut fields[field as usize];
                    *degree = (*degree).max((rest >> shift & mask) as u32);
                    rest &= !(mask << shift);
                }
            }
        }
        degrees
    }
}

/// Writes `3*x0^2*x1 - x2 + 1`.
impl fmt::Display for Polynomial {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return formatter.write_str("0");
        }
        for (index, (monomial, coefficient)) in self.terms().enumerate() {
            let negative = coefficient < BigInt::zero();
            formatter.write_str(match (index, negative) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            })?;
            let size = coefficient.magnitude();
            let mut separator = "";
            if monomial.is_empty() || !size.is_one() {
                write!(formatter, "{size}")?;
                separator = "*";
            }
            for (variable, exponent) in monomial {
                write!(formatter, "{separator}x{variable}")?;
                if exponent > 1 {
                    write!(formatter, "^{exponent}")?;
                }
                separator = "*";
            }
        }
        Ok(())
    }
}

impl fmt::Debug for Polynomial {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, formatter)
    }
}
