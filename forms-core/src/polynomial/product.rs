//! Products: Σ sₖ aₖ bₖ in one accumulator.
//!
//! ```text
//! operands ─ bounds: rung, layout, box of exponents ─▶ one term times many: shifted, in order already
//!                                                    ─▶ a few products: inserted one by one
//!                                                    ─▶ a full box: dense, block by block
//!                                                    ─▶ else: hash table of keys, sorted once
//!                                                    ─▶ keys too long: hash table of packed monomials
//! ```

mod dense;
mod groups;
mod insertion;
mod keyed;
mod lanes;
mod reach;
mod rest;
mod sparse;

pub(super) use rest::Rest;

use super::Polynomial;
use super::coefficient::{Coefficient, Norms, Rung, on_rung};
use super::monomial::{Layout, compare};
use crate::steps;
use keyed::Fields;
use reach::Reach;
use std::borrow::Cow;
use std::cmp::Ordering;

/// Total number of words of two numbers up to which their product needs no allocation.
const MOST_WORDS_IN_PLACE: u64 = 2;
/// Steps of a product that needs an allocation, including its place in the sum.
const STEPS_OF_ALLOCATION: u64 = 12;

/// One product sₖ aₖ bₖ as callers supply it.
type Term<'a> = (i64, &'a Polynomial, &'a Polynomial);

/// Packed terms on the layout and the rung of the result.
struct Operand<'a, C: Coefficient> {
    monomials: Cow<'a, [u64]>,
    numbers: Cow<'a, [C]>,
}

/// One product sₖ aₖ bₖ on the layout and the rung of the result.
struct Pair<'a, C: Coefficient> {
    factor: C,
    left: Operand<'a, C>,
    right: Operand<'a, C>,
}

impl<'a, C: Coefficient> Pair<'a, C> {
    fn new(&(factor, left, right): &Term<'a>, layout: Layout) -> Self {
        let operand = |polynomial: &'a Polynomial| Operand {
            monomials: polynomial.monomials_on(layout),
            numbers: C::view(&polynomial.coefficients),
        };
        Pair { factor: C::from(factor), left: operand(left), right: operand(right) }
    }
}

impl Polynomial {
    /// f·g
    ///
    /// # Panics
    /// If an exponent of the product is beyond 2³¹ − 1.
    pub fn mul(&self, other: &Self) -> Self {
        match (self.as_small_constant(), other.as_small_constant()) {
            (Some(number), _) => other.scale_small(number),
            (_, Some(number)) => self.scale_small(number),
            _ => Self::sum_of_products(&[(1, self, other)]),
        }
    }

    /// f²
    ///
    /// # Panics
    /// If an exponent of the square is beyond 2³¹ − 1.
    pub fn square(&self) -> Self {
        self.mul(self)
    }

    /// fⁿ by repeated squaring, with f⁰ = 1.
    ///
    /// # Panics
    /// If an exponent of the power is beyond 2³¹ − 1.
    pub fn pow(&self, n: u32) -> Self {
        if n == 0 {
            return Self::one();
        }
        let mut result = self.clone();
        for bit in (0..n.ilog2()).rev() {
            result = result.square();
            if n >> bit & 1 == 1 {
                result = result.mul(self);
            }
        }
        result
    }

    /// Returns a bound on the number of terms of f·g: the lesser of the number of pairs of terms
    /// and the size of the box of exponents ∏ (1 + degᵢ f + degᵢ g).
    pub fn product_size_bound(&self, other: &Self) -> usize {
        let pairs = self.term_count().saturating_mul(other.term_count());
        let (left, right) = (self.degrees(), other.degrees());
        let mut size = 1usize;
        for variable in 0..left.len().max(right.len()) {
            let degree = |degrees: &[u32]| degrees.get(variable).map_or(0, |&degree| degree as usize);
            size = size.saturating_mul(1 + degree(&left) + degree(&right));
        }
        pairs.min(size)
    }

    /// Returns the steps of f·g. Each pair of terms takes one step or, if numbers have to be
    /// allocated, one step for each pair of their words and [`STEPS_OF_ALLOCATION`] steps. Each
    /// word of the monomials, which are read first, takes one step.
    pub(crate) fn steps_of_product(&self, other: &Self) -> u64 {
        let (terms, other_terms) = (self.term_count() as u64, other.term_count() as u64);
        let read = (terms + other_terms).saturating_mul(self.layout.words.max(other.layout.words) as u64);
        let pairs = terms.saturating_mul(other_terms);
        let (words, other_words) = (self.coefficient_words(), other.coefficient_words());
        if words + other_words <= MOST_WORDS_IN_PLACE {
            return pairs.saturating_add(read);
        }
        let each = words.saturating_mul(other_words).saturating_add(STEPS_OF_ALLOCATION);
        pairs.saturating_mul(each).saturating_add(read)
    }

    /// Returns Σ sₖ aₖ bₖ, collected in one accumulator.
    ///
    /// # Panics
    /// If an exponent of a product is beyond 2³¹ − 1.
    pub fn sum_of_products(terms: &[(i64, &Polynomial, &Polynomial)]) -> Self {
        spend_on(terms);
        let reach = Reach::of(terms);
        on_rung!(product_rung(terms), C => accumulate::<C>(&reach, terms))
    }

    /// Whether Σ sₖ aₖ bₖ = 0. The leading and the last terms, which need no other products, decide
    /// in most cases; otherwise everything is accumulated but nothing is sorted.
    ///
    /// # Panics
    /// If an exponent of a product is beyond 2³¹ − 1.
    pub fn sum_of_products_is_zero(terms: &[(i64, &Polynomial, &Polynomial)]) -> bool {
        spend_on(terms);
        let reach = Reach::of(terms);
        let layout = reach.layout;
        on_rung!(product_rung(terms), C => {
            let pairs = pairs::<C>(terms, layout);
            outermost_cancels(layout, &pairs, false)
                && outermost_cancels(layout, &pairs, true)
                && match Fields::holding(&reach) {
                    Some(fields) => fields.sum_is_zero::<C>(terms),
                    None => sparse::Table::sum(layout, &pairs).is_zero(),
                }
        })
    }
}

/// Spends the steps of a sum of products.
fn spend_on(terms: &[Term]) {
    steps::spend(terms.iter().map(|(_, a, b)| a.steps_of_product(b)).fold(0, u64::saturating_add));
}

fn pairs<'a, C: Coefficient>(terms: &[Term<'a>], layout: Layout) -> Vec<Pair<'a, C>> {
    let mut pairs = Vec::with_capacity(terms.len());
    for term in terms {
        if term.0 != 0 && !term.1.is_zero() && !term.2.is_zero() {
            pairs.push(Pair::new(term, layout));
        }
    }
    pairs
}

fn accumulate<C: Coefficient>(reach: &Reach, terms: &[Term<'_>]) -> Polynomial {
    let layout = reach.layout;
    let products = count_products(terms);
    if let &[term] = terms {
        if term.0 == 0 || products == 0 {
            return Polynomial::zero();
        }
        let pair = Pair::new(&term, layout);
        if term.1.term_count() == 1 {
            return shifted::<C>(layout, &pair.factor, &pair.left, &pair.right);
        }
        if term.2.term_count() == 1 {
            return shifted::<C>(layout, &pair.factor, &pair.right, &pair.left);
        }
        if products <= insertion::FEW {
            return insertion::sum(layout, &[pair], products);
        }
    } else if products <= insertion::FEW {
        return insertion::sum::<C>(layout, &pairs(terms, layout), products);
    }
    if dense::may_fit(reach, products) {
        let pairs = pairs::<C>(terms, layout);
        if let Some(container) = dense::Box::around(layout, &pairs, products) {
            return container.sum(layout, &pairs);
        }
    }
    match Fields::holding(reach) {
        Some(fields) => fields.sum::<C>(layout, terms),
        None => sparse::Table::<C>::sum(layout, &pairs(terms, layout)).into_polynomial(layout),
    }
}

/// Returns the number of products of terms.
fn count_products(terms: &[Term<'_>]) -> usize {
    let mut products = 0usize;
    for &(_, a, b) in terms {
        products = products.saturating_add(a.term_count().saturating_mul(b.term_count()));
    }
    products
}

/// Returns c·m·f for a single term c·m; the order of terms stays the same.
fn shifted<C: Coefficient>(
    layout: Layout,
    factor: &C,
    term: &Operand<'_, C>,
    f: &Operand<'_, C>,
) -> Polynomial {
    let words = layout.words;
    let factor = factor.times(&term.numbers[0]);
    let mut monomials = Vec::with_capacity(f.monomials.len());
    let mut numbers = Vec::with_capacity(f.numbers.len());
    for index in 0..f.numbers.len() {
        for word in 0..words {
            monomials.push(f.monomials[index * words + word] + term.monomials[word]);
        }
        numbers.push(f.numbers[index].times(&factor));
    }
    Polynomial::settle(layout, monomials, numbers)
}

/// Whether the leading terms (or the last ones) of the products cancel: no other product of terms
/// reaches the greatest (least) monomial among them.
fn outermost_cancels<C: Coefficient>(layout: Layout, pairs: &[Pair<'_, C>], last: bool) -> bool {
    let words = layout.words;
    let mut outermost: Vec<u64> = Vec::new();
    let mut sum = C::zero();
    let mut product = vec![0; words];
    for (index, pair) in pairs.iter().enumerate() {
        let i = if last { pair.left.numbers.len() - 1 } else { 0 };
        let j = if last { pair.right.numbers.len() - 1 } else { 0 };
        for (word, sum) in product.iter_mut().enumerate() {
            *sum = pair.left.monomials[i * words + word] + pair.right.monomials[j * words + word];
        }
        let further = if last { Ordering::Less } else { Ordering::Greater };
        let order = if index == 0 { further } else { compare(&product, &outermost) };
        if order == further {
            outermost.clone_from(&product);
            sum = C::zero();
        }
        if order == further || order == Ordering::Equal {
            sum.add_product(&pair.factor.times(&pair.left.numbers[i]), &pair.right.numbers[j]);
        }
    }
    sum.is_zero()
}

/// Returns the lowest rung that holds every coefficient of the sum: Σ |sₖ| min(max|aₖ|·‖bₖ‖₁,
/// max|bₖ|·‖aₖ‖₁).
fn product_rung(terms: &[Term<'_>]) -> Rung {
    let mut bound = Some(0u128);
    for &(factor, a, b) in terms {
        let product = Norms::of_product(a.coefficients.norms(), b.coefficients.norms());
        let scaled = product.and_then(|product| product.checked_mul(u128::from(factor.unsigned_abs())));
        bound = bound.zip(scaled).and_then(|(bound, scaled)| bound.checked_add(scaled));
    }
    Rung::for_bound(bound)
}
