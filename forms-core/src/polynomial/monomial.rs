//! Monomials packed into words: ∏ xᵢ^eᵢ is the concatenation of e₀, e₁, …, the first variable on
//! top.
//!
//! ```text
//! word 0  │0 e₀│0 e₁│ … │0 e₁₅│      bits = 4: 16 variables per word, exponents to 7
//! word 1  │0 e₁₆│ …                  the top bit of each field is a guard and stays 0
//! ```
//! Adding words multiplies monomials, and comparing words compares them lexicographically, with
//! x₀ > x₁ > …. A difference borrows into a guard bit exactly if the division is not possible. A
//! wider layout appends words or doubles the fields; neither changes the order of terms.

use std::cmp::Ordering;

/// Layout of exponents in words: the bits of a field and the words of a monomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Layout {
    /// Bits of a field, including its guard: 4, 8, 16 or 32.
    pub(super) bits: u32,
    /// Words of a monomial; 0 for constants.
    pub(super) words: usize,
}

/// The largest exponent that any layout holds.
pub(super) const LARGEST_EXPONENT: u32 = (1 << 31) - 1;

impl Layout {
    /// The layout of constants.
    pub(super) const CONSTANT: Layout = Layout { bits: 4, words: 0 };

    /// Returns the narrowest layout for variables below `variables` and exponents up to `exponent`.
    ///
    /// # Panics
    /// If the exponent is beyond 2³¹ − 1.
    pub(super) fn fitting(variables: u64, exponent: u64) -> Layout {
        assert!(exponent <= u64::from(LARGEST_EXPONENT), "an exponent is beyond 2^31 - 1");
        let mut bits = 4;
        while exponent >> (bits - 1) != 0 {
            bits *= 2;
        }
        Layout { bits, words: (variables as usize).div_ceil(64 / bits as usize) }
    }

    /// Returns the narrowest layout to which monomials of both layouts can be widened.
    pub(super) fn join(self, other: Layout) -> Layout {
        let bits = self.bits.max(other.bits);
        Layout { bits, words: self.words_at(bits).max(other.words_at(bits)) }
    }

    /// Returns the number of words that this layout's monomials take if fields have `bits` bits.
    pub(super) fn words_at(self, bits: u32) -> usize {
        self.words * (bits / self.bits) as usize
    }

    /// Returns the number of fields in a word.
    pub(super) fn per_word(self) -> usize {
        64 / self.bits as usize
    }

    /// Returns the number of variables that have a field.
    pub(super) fn fields(self) -> usize {
        self.words * self.per_word()
    }

    /// Returns the word and the shift of a variable's field, if it has one.
    pub(super) fn field(self, variable: u32) -> Option<(usize, u32)> {
        let per_word = self.per_word();
        let word = variable as usize / per_word;
        let place = (variable as usize % per_word) as u32;
        (word < self.words).then_some((word, 64 - self.bits * (place + 1)))
    }

    /// Returns the mask of a field that is shifted to the bottom.
    pub(super) fn mask(self) -> u64 {
        (1 << self.bits) - 1
    }

    /// Returns the exponent of `variable` in a packed monomial.
    pub(super) fn exponent(self, monomial: &[u64], variable: u32) -> u32 {
        match self.field(variable) {
            Some((word, shift)) => (monomial[word] >> shift & self.mask()) as u32,
            None => 0,
        }
    }

    /// Returns the guard bits of all fields of a word.
    pub(super) fn guards(self) -> u64 {
        // 0x…0101 with ones `bits` apart, moved to the top of each field.
        (u64::MAX / self.mask()) << (self.bits - 1)
    }

    /// Appends a monomial to packed ones; exponents of a repeated variable are added.
    pub(super) fn pack(self, exponents: &[(u32, u32)], packed: &mut Vec<u64>) {
        let start = packed.len();
        packed.resize(start + self.words, 0);
        for &(variable, exponent) in exponents {
            if let Some((word, shift)) = self.field(variable) {
                packed[start + word] += u64::from(exponent) << shift;
            }
        }
    }

    /// Returns the variables of a packed monomial with their exponents, in increasing order.
    pub(super) fn unpack(self, monomial: &[u64]) -> Vec<(u32, u32)> {
        let mut exponents = Vec::new();
        for (index, &word) in monomial.iter().enumerate() {
            let mut rest = word;
            while rest != 0 {
                let place = rest.leading_zeros() / self.bits;
                let shift = 64 - self.bits * (place + 1);
                let variable = (index * self.per_word()) as u32 + place;
                exponents.push((variable, (rest >> shift) as u32));
                rest &= !(self.mask() << shift);
            }
        }
        exponents
    }

    /// Returns packed monomials of this layout, repacked into `wider`.
    pub(super) fn widen(self, monomials: &[u64], terms: usize, wider: Layout) -> Vec<u64> {
        let mut result = Vec::with_capacity(terms * wider.words);
        let copies = (wider.bits / self.bits) as usize;
        for term in 0..terms {
            let start = result.len();
            for &word in &monomials[term * self.words..(term + 1) * self.words] {
                for part in 0..copies {
                    if result.len() - start < wider.words {
                        result.push(spread(word, self.bits, wider.bits, part));
                    }
                }
            }
            result.resize(start + wider.words, 0);
        }
        result
    }

    /// Returns packed monomials of this layout, each cut to `words` words.
    pub(super) fn crop(self, monomials: &[u64], terms: usize, words: usize) -> Vec<u64> {
        let mut result = Vec::with_capacity(terms * words);
        for term in 0..terms {
            result.extend_from_slice(&monomials[term * self.words..term * self.words + words]);
        }
        result
    }

    /// Returns packed monomials of this layout, repacked into fields of half the size and cut to
    /// `words` words.
    pub(super) fn halve(self, monomials: &[u64], terms: usize, words: usize) -> Vec<u64> {
        let mut result = Vec::with_capacity(terms * words);
        for term in 0..terms {
            let monomial = &monomials[term * self.words..(term + 1) * self.words];
            for word in 0..words {
                let upper = monomial.get(2 * word).copied().unwrap_or(0);
                let lower = monomial.get(2 * word + 1).copied().unwrap_or(0);
                result.push(gather(upper, self.bits) << 32 | gather(lower, self.bits));
            }
        }
        result
    }
}

/// Returns the fields of a word from number `part`·(64/wider) on, each widened from `bits` to
/// `wider` bits.
fn spread(word: u64, bits: u32, wider: u32, part: usize) -> u64 {
    let mut bits = bits;
    let mut word = word;
    let mut part = part as u32;
    // Each round doubles the fields of the half that contains the requested part.
    while bits < wider {
        let copies = wider / bits;
        let upper = part < copies / 2;
        let half = if upper { word >> 32 } else { word & 0xffff_ffff };
        if !upper {
            part -= copies / 2;
        }
        word = double_fields(half, bits);
        bits *= 2;
    }
    word
}

/// Moves the 32/bits fields of the lower half apart, so that each has twice the bits.
fn double_fields(half: u64, bits: u32) -> u64 {
    let mut word = half;
    let mut stride = 16;
    while stride >= bits {
        word = (word | word << stride) & (u64::MAX / ((1 << stride) + 1));
        stride /= 2;
    }
    word
}

/// Moves fields of `bits` bits together into the lower half, so that each has half the bits.
fn gather(word: u64, bits: u32) -> u64 {
    let mut word = word;
    let mut stride = bits / 2;
    while stride <= 16 {
        word = (word | word >> stride) & (u64::MAX / ((1 << (2 * stride)) + 1));
        stride *= 2;
    }
    word
}

/// Compares packed monomials of one layout.
#[inline(always)]
pub(super) fn compare(left: &[u64], right: &[u64]) -> Ordering {
    let mut word = 0;
    while word < left.len() && word < right.len() {
        if left[word] != right[word] {
            return if left[word] < right[word] { Ordering::Less } else { Ordering::Greater };
        }
        word += 1;
    }
    Ordering::Equal
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packing_is_undone_by_unpacking_in_every_layout() {
        for (variables, exponent) in
            [(3u32, 7), (20, 7), (20, 8), (9, 127), (9, 128), (7, 32768), (200, 10_000)]
        {
            let layout = Layout::fitting(u64::from(variables), exponent);
            let monomial = [(0, exponent as u32), (1, 1), (variables - 1, exponent as u32)];
            let mut packed = Vec::new();
            layout.pack(&monomial, &mut packed);
            assert_eq!(layout.unpack(&packed), monomial);
        }
    }

    #[test]
    fn widening_keeps_exponents_and_halving_undoes_it() {
        let monomial = [(0, 7), (1, 2), (7, 3), (8, 1), (15, 7), (16, 5), (31, 6)];
        let narrow = Layout::fitting(32, 7);
        let mut packed = Vec::new();
        narrow.pack(&monomial, &mut packed);
        for exponent in [8, 128, 32768] {
            let wide = narrow.join(Layout::fitting(1, exponent));
            let mut widened = narrow.widen(&packed, 1, wide);
            assert_eq!(wide.unpack(&widened), monomial);
            let mut layout = wide;
            while layout.bits > narrow.bits {
                let half = Layout { bits: layout.bits / 2, words: layout.words.div_ceil(2) };
                widened = layout.halve(&widened, 1, half.words);
                layout = half;
            }
            assert_eq!(widened, packed);
        }
    }

    #[test]
    fn guards_are_the_top_bits_of_fields() {
        assert_eq!(Layout::fitting(1, 1).guards(), 0x8888_8888_8888_8888);
        assert_eq!(Layout::fitting(1, 100).guards(), 0x8080_8080_8080_8080);
        assert_eq!(Layout::fitting(1, 40_000).guards(), 0x8000_0000_8000_0000);
    }
}
