//! The rest of a long division: sums in a hash table, and the monomials on a heap with the greatest
//! on top.

use super::sparse::Table;
use crate::polynomial::coefficient::Coefficient;
use crate::polynomial::monomial::{Layout, compare};

/// The rest of a dividend.
pub(in crate::polynomial) struct Rest<C> {
    table: Table<C>,
    /// A binary heap with the first word and the position in the table of each monomial that was
    /// not popped.
    heap: Vec<(u64, u32)>,
    /// Guards of the fields, to detect an exponent that leaves the layout.
    guards: u64,
    leading: Vec<u64>,
}

impl<C: Coefficient> Rest<C> {
    /// Creates the rest from the dividend, whose terms are in decreasing order and therefore form a
    /// heap.
    pub(in crate::polynomial) fn new(layout: Layout, monomials: &[u64], numbers: &[C]) -> Self {
        let table = Table::of_terms(layout, monomials, numbers);
        let mut heap = Vec::with_capacity(numbers.len());
        for position in 0..numbers.len() {
            heap.push((first_word(&table, position), position as u32));
        }
        Rest { table, heap, guards: layout.guards(), leading: vec![0; layout.words] }
    }

    /// Removes the leading term: returns its number and keeps its monomial.
    pub(in crate::polynomial) fn pop(&mut self) -> Option<C> {
        while let Some(&(_, position)) = self.heap.first() {
            let last = self.heap.pop()?;
            if !self.heap.is_empty() {
                self.sink(last);
            }
            let number = self.table.take(position as usize);
            if !number.is_zero() {
                self.leading.copy_from_slice(self.table.monomial(position as usize));
                return Some(number);
            }
        }
        None
    }

    /// Returns the monomial popped last.
    pub(in crate::polynomial) fn leading(&self) -> &[u64] {
        &self.leading
    }

    /// Subtracts c·m·g except for its leading term; returns whether all exponents stayed in the
    /// layout.
    pub(in crate::polynomial) fn subtract(
        &mut self,
        m: &[u64],
        c: &C,
        monomials: &[u64],
        numbers: &[C],
    ) -> bool {
        let words = m.len();
        let factor = c.negated();
        for term in 1..numbers.len() {
            let n = &monomials[term * words..(term + 1) * words];
            for word in 0..words {
                if (m[word] + n[word]) & self.guards != 0 {
                    return false;
                }
            }
            if let Some(position) = self.table.add_term(m, n, &factor, &numbers[term]) {
                self.heap.push((first_word(&self.table, position), position as u32));
                self.rise();
            }
        }
        true
    }

    fn is_above(&self, left: (u64, u32), right: (u64, u32)) -> bool {
        if left.0 != right.0 {
            return left.0 > right.0;
        }
        compare(self.table.monomial(left.1 as usize), self.table.monomial(right.1 as usize)).is_gt()
    }

    /// Moves the last entry up to its place.
    fn rise(&mut self) {
        let mut place = self.heap.len() - 1;
        while place > 0 && self.is_above(self.heap[place], self.heap[(place - 1) / 2]) {
            self.heap.swap(place, (place - 1) / 2);
            place = (place - 1) / 2;
        }
    }

    /// Puts an entry on top and moves it down to its place.
    fn sink(&mut self, entry: (u64, u32)) {
        let mut place = 0;
        loop {
            let mut child = 2 * place + 1;
            if child >= self.heap.len() {
                break;
            }
            if child + 1 < self.heap.len() && self.is_above(self.heap[child + 1], self.heap[child]) {
                child += 1;
            }
            if !self.is_above(self.heap[child], entry) {
                break;
            }
            self.heap[place] = self.heap[child];
            place = child;
        }
        self.heap[place] = entry;
    }
}

fn first_word<C: Coefficient>(table: &Table<C>, position: usize) -> u64 {
    table.monomial(position).first().copied().unwrap_or(0)
}
