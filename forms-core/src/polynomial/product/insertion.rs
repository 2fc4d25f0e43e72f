//! Products of a few terms: each one is inserted directly at its place in the result.

use super::Pair;
use crate::polynomial::Polynomial;
use crate::polynomial::coefficient::Coefficient;
use crate::polynomial::monomial::{Layout, compare};
use std::cmp::Ordering;

/// Largest number of products of terms for which shifting the result's tail is faster than hashing
/// and sorting.
pub(super) const FEW: usize = 48;

/// Σ sₖ aₖ bₖ
pub(super) fn sum<C: Coefficient>(layout: Layout, pairs: &[Pair<'_, C>], products: usize) -> Polynomial {
    let mut sorted = Sorted {
        monomials: Vec::with_capacity(products * layout.words),
        numbers: Vec::with_capacity(products),
        product: vec![0; layout.words],
    };
    for pair in pairs {
        match layout.words {
            1 => sorted.add_pair::<1>(pair, 1),
            2 => sorted.add_pair::<2>(pair, 2),
            words => sorted.add_pair::<0>(pair, words),
        }
    }
    let Sorted { monomials, numbers, .. } = sorted;
    if numbers.iter().any(C::is_zero) {
        return Polynomial::from_unsorted(layout, &monomials, &numbers);
    }
    Polynomial::settle(layout, monomials, numbers)
}

/// Terms in decreasing order; sums that became zero are kept.
struct Sorted<C> {
    monomials: Vec<u64>,
    numbers: Vec<C>,
    /// Buffer for the current monomial.
    product: Vec<u64>,
}

impl<C: Coefficient> Sorted<C> {
    /// Adds s·a·b; a width of 0 stands for any width.
    fn add_pair<const WIDTH: usize>(&mut self, pair: &Pair<'_, C>, words: usize) {
        let words = if WIDTH == 0 { words } else { WIDTH };
        // Few long rows: the products of a row decrease, so the search continues where the last one
        // ended.
        let swap = pair.left.numbers.len() > pair.right.numbers.len();
        let (a, b) = if swap { (&pair.right, &pair.left) } else { (&pair.left, &pair.right) };
        for i in 0..a.numbers.len() {
            let scaled = a.numbers[i].times(&pair.factor);
            let m = &a.monomials[i * words..(i + 1) * words];
            let mut place = 0;
            for j in 0..b.numbers.len() {
                let n = &b.monomials[j * words..(j + 1) * words];
                place = self.add_term::<WIDTH>(place, m, n, scaled.times(&b.numbers[j]), words) + 1;
            }
        }
    }

    /// Adds c·m·n at its place, searched from `place` on, and returns the place.
    #[inline(always)]
    fn add_term<const WIDTH: usize>(
        &mut self,
        mut place: usize,
        m: &[u64],
        n: &[u64],
        number: C,
        words: usize,
    ) -> usize {
        let words = if WIDTH == 0 { words } else { WIDTH };
        let count = self.numbers.len();
        let product = &mut self.product[..words];
        for word in 0..words {
            product[word] = m[word] + n[word];
        }
        while place < count {
            match compare(&self.monomials[place * words..(place + 1) * words], product) {
                Ordering::Greater => place += 1,
                Ordering::Equal => {
                    self.numbers[place] = self.numbers[place].plus(&number);
                    return place;
                }
                Ordering::Less => break,
            }
        }
        if place == count {
            self.monomials.extend_from_slice(product);
            self.numbers.push(number);
        } else {
            self.monomials.resize((count + 1) * words, 0);
            self.monomials.copy_within(place * words..count * words, (place + 1) * words);
            self.monomials[place * words..(place + 1) * words].copy_from_slice(product);
            self.numbers.insert(place, number);
        }
        place
    }
}
