//! Products by hashing where keys would be too long: packed monomials in the order of their
//! arrival, found by a table of positions and sorted once at the end.

use super::{Operand, Pair};
use crate::polynomial::Polynomial;
use crate::polynomial::coefficient::Coefficient;
use crate::polynomial::monomial::{Layout, compare};

/// Monomials with their sums. The last `words` words of `monomials` are a buffer for the next one.
pub(super) struct Table<C> {
    words: usize,
    monomials: Vec<u64>,
    numbers: Vec<C>,
    /// Position + 1 of a monomial at the first free place after its hash; 0 is free. The length is
    /// a power of two.
    places: Vec<u32>,
    /// Buffer for the hashes of an operand.
    hashes: Vec<u64>,
}

/// Largest initial number of places; beyond it, the table grows as terms arrive.
const FIRST_PLACES: usize = 1 << 14;

impl<C: Coefficient> Table<C> {
    /// Σ sₖ aₖ bₖ
    pub(super) fn sum(layout: Layout, pairs: &[Pair<'_, C>]) -> Self {
        let mut products = 0usize;
        for pair in pairs {
            let pair = pair.left.numbers.len().saturating_mul(pair.right.numbers.len());
            products = products.saturating_add(pair);
        }
        let places = (2 * products.min(FIRST_PLACES)).next_power_of_two();
        let mut table = Table {
            words: layout.words,
            monomials: Vec::with_capacity((places / 2 + 1) * layout.words),
            numbers: Vec::with_capacity(places / 2),
            places: vec![0; places],
            hashes: Vec::new(),
        };
        table.monomials.resize(layout.words, 0);
        for pair in pairs {
            // The short operand is in the outer loop: its coefficient is scaled once for each pass
            // through the long one.
            let swap = pair.left.numbers.len() > pair.right.numbers.len();
            let (a, b) = if swap { (&pair.right, &pair.left) } else { (&pair.left, &pair.right) };
            table.add_pair(&pair.factor, a, b);
        }
        table
    }

    /// Adds s·a·b.
    fn add_pair(&mut self, factor: &C, a: &Operand<'_, C>, b: &Operand<'_, C>) {
        let words = self.words;
        let (left, right) = (&*a.monomials, &*b.monomials);
        let (a, b) = (&*a.numbers, &*b.numbers);
        self.hash_terms(right, b.len());
        let mut mask = self.places.len() - 1;
        for i in 0..a.len() {
            let scaled = a[i].times(factor);
            let m = &left[i * words..(i + 1) * words];
            let hash = linear_hash(m);
            for j in 0..b.len() {
                let n = &right[j * words..(j + 1) * words];
                let next = self.numbers.len();
                let (known, room) = self.monomials.split_at_mut(next * words);
                let room = &mut room[..words];
                for word in 0..words {
                    room[word] = m[word] + n[word];
                }
                let mut place = mix(hash.wrapping_add(self.hashes[j])) as usize & mask;
                loop {
                    let position = self.places[place] as usize;
                    if position == 0 {
                        self.places[place] = next as u32 + 1;
                        self.numbers.push(scaled.times(&b[j]));
                        self.monomials.resize((next + 2) * words, 0);
                        if 2 * next > mask {
                            self.grow();
                            mask = self.places.len() - 1;
                        }
                        break;
                    }
                    if compare(&known[(position - 1) * words..position * words], room).is_eq() {
                        self.numbers[position - 1].add_product(&scaled, &b[j]);
                        break;
                    }
                    place = (place + 1) & mask;
                }
            }
        }
    }

    /// Hashes the monomials of an operand.
    fn hash_terms(&mut self, monomials: &[u64], terms: usize) {
        self.hashes.clear();
        for term in 0..terms {
            self.hashes.push(linear_hash(&monomials[term * self.words..(term + 1) * self.words]));
        }
    }

    /// Creates the sum of terms with different monomials, at positions in their order.
    pub(super) fn of_terms(layout: Layout, monomials: &[u64], numbers: &[C]) -> Self {
        let places = (4 * numbers.len() + 16).next_power_of_two();
        let mut table = Table {
            words: layout.words,
            monomials: monomials.to_vec(),
            numbers: numbers.to_vec(),
            places: vec![0; places / 2],
            hashes: Vec::new(),
        };
        table.monomials.resize((numbers.len() + 1) * layout.words, 0);
        table.grow();
        table
    }

    /// Adds a·b·m·n and returns the position if the monomial is new.
    pub(super) fn add_term(&mut self, m: &[u64], n: &[u64], a: &C, b: &C) -> Option<usize> {
        let words = self.words;
        let next = self.numbers.len();
        for word in 0..words {
            self.monomials[next * words + word] = m[word] + n[word];
        }
        let (known, product) = self.monomials.split_at(next * words);
        let mask = self.places.len() - 1;
        let mut place = mix(linear_hash(&product[..words])) as usize & mask;
        while self.places[place] != 0 {
            let position = self.places[place] as usize - 1;
            if compare(&known[position * words..(position + 1) * words], product).is_eq() {
                self.numbers[position].add_product(a, b);
                return None;
            }
            place = (place + 1) & mask;
        }
        self.places[place] = next as u32 + 1;
        self.numbers.push(a.times(b));
        self.monomials.resize((next + 2) * words, 0);
        if 2 * next > mask {
            self.grow();
        }
        Some(next)
    }

    /// Returns the monomial at a position.
    pub(super) fn monomial(&self, position: usize) -> &[u64] {
        &self.monomials[position * self.words..(position + 1) * self.words]
    }

    /// Returns the sum at a position and sets it to zero.
    pub(super) fn take(&mut self, position: usize) -> C {
        std::mem::replace(&mut self.numbers[position], C::zero())
    }

    /// Doubles the number of places.
    #[cold]
    fn grow(&mut self) {
        let mask = 2 * self.places.len() - 1;
        let mut places = vec![0u32; mask + 1];
        for position in 0..self.numbers.len() {
            let monomial = &self.monomials[position * self.words..(position + 1) * self.words];
            let mut place = mix(linear_hash(monomial)) as usize & mask;
            while places[place] != 0 {
                place = (place + 1) & mask;
            }
            places[place] = position as u32 + 1;
        }
        self.places = places;
    }

    /// Whether every sum is zero.
    pub(super) fn is_zero(&self) -> bool {
        self.numbers.iter().all(C::is_zero)
    }

    /// Returns the nonzero sums, sorted.
    pub(super) fn into_polynomial(self, layout: Layout) -> Polynomial {
        let words = self.words;
        let mut order: Vec<(u64, u32)> = Vec::with_capacity(self.numbers.len());
        for (position, number) in self.numbers.iter().enumerate() {
            if !number.is_zero() {
                let first = if words == 0 { 0 } else { self.monomials[position * words] };
                order.push((first, position as u32));
            }
        }
        let rest =
            |position: u32| &self.monomials[position as usize * words..(position as usize + 1) * words];
        if words <= 1 {
            order.sort_unstable_by_key(|&(first, _)| std::cmp::Reverse(first));
        } else {
            order.sort_unstable_by(|left, right| {
                right.0.cmp(&left.0).then_with(|| compare(rest(right.1), rest(left.1)))
            });
        }
        let mut monomials = Vec::with_capacity(order.len() * words);
        let mut numbers = Vec::with_capacity(order.len());
        for &(_, position) in &order {
            monomials.extend_from_slice(rest(position));
            numbers.push(self.numbers[position as usize].clone());
        }
        Polynomial::settle(layout, monomials, numbers)
    }
}

/// Σ wordₖ·Kᵏ⁺¹ modulo 2⁶⁴ with K odd. It is linear, so the hash of a product of monomials is the
/// sum of their hashes.
#[inline(always)]
fn linear_hash(monomial: &[u64]) -> u64 {
    let mut hash = 0u64;
    for &word in monomial.iter().rev() {
        hash = hash.wrapping_add(word).wrapping_mul(0xd6e8_feb8_6659_fd93);
    }
    hash
}

/// Folds the double-width product with an odd constant, so that every bit of the word reaches the
/// low bits.
#[inline(always)]
fn mix(word: u64) -> u64 {
    let product = u128::from(word) * 0x9e37_79b9_7f4a_7c15;
    product as u64 ^ (product >> 64) as u64
}
