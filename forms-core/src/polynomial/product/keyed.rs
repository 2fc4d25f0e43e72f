//! Products by hashing on keys. A key packs the exponents of the variables that occur into one or
//! two words, each exponent as narrow as the sum allows.
//!
//! ```text
//! Σ sₖ aₖ bₖ ─ fields ─▶ keys of aₖ, bₖ ─ add ─▶ table of keys and sums ─ sort ─▶ unpack
//! ```
//! No field carries into the next, and earlier variables have higher fields, so keys are added and
//! compared as monomials are. A sum over products of many linear forms takes one bit per variable,
//! where the layouts of its operands differ and take several words.

use super::reach::Reach;
use super::{Term, count_products};
use crate::polynomial::Polynomial;
use crate::polynomial::coefficient::Coefficient;
use crate::polynomial::monomial::Layout;

/// Largest number of bits of a key.
const LONGEST: u32 = u128::BITS;

/// Largest initial number of places; beyond it, the table grows as terms arrive.
const FIRST_PLACES: usize = 1 << 14;

/// A packed monomial.
pub(super) trait Key: Copy + Ord {
    const ONE: Self;
    /// Returns exponent · 2^shift.
    fn field(exponent: u64, shift: u32) -> Self;
    fn plus(self, other: Self) -> Self;
    /// Returns the lowest bit that is set, if any.
    fn lowest(self) -> Option<u32>;
    /// Returns the exponent in a field.
    fn exponent(self, field: &Field) -> u64;
    /// Returns the key with a field cleared.
    fn without(self, field: &Field) -> Self;
    /// Returns a hash that is well mixed in the upper bits.
    fn hash(self) -> u64;
}

macro_rules! key {
    ($word:ty, $hash:expr) => {
        impl Key for $word {
            const ONE: Self = 0;
            #[inline(always)]
            fn field(exponent: u64, shift: u32) -> Self {
                (exponent as $word) << shift
            }
            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self + other
            }
            #[inline(always)]
            fn lowest(self) -> Option<u32> {
                (self != 0).then(|| self.trailing_zeros())
            }
            #[inline(always)]
            fn exponent(self, field: &Field) -> u64 {
                (self >> field.shift) as u64 & field.mask
            }
            #[inline(always)]
            fn without(self, field: &Field) -> Self {
                self & !((field.mask as $word) << field.shift)
            }
            #[inline(always)]
            fn hash(self) -> u64 {
                let hash: fn($word) -> u64 = $hash;
                hash(self)
            }
        }
    };
}

const FIRST_MULTIPLIER: u64 = 0x9e37_79b9_7f4a_7c15;
const SECOND_MULTIPLIER: u64 = 0xd6e8_feb8_6659_fd93;

key!(u64, |key| key.wrapping_mul(FIRST_MULTIPLIER));
key!(u128, |key| (key as u64)
    .wrapping_mul(FIRST_MULTIPLIER)
    .wrapping_add(((key >> 64) as u64).wrapping_mul(SECOND_MULTIPLIER)));

/// A variable's place in keys.
#[derive(Clone, Copy)]
pub(super) struct Field {
    variable: u32,
    shift: u32,
    mask: u64,
}

/// The fields of keys.
pub(super) struct Fields {
    /// Fields in increasing order of shifts.
    fields: Vec<Field>,
    /// The shift of each variable's field.
    shifts: Vec<u32>,
    bits: u32,
}

impl Fields {
    /// Creates fields as wide as the exponents require; `None` if keys would be too long.
    pub(super) fn holding(reach: &Reach) -> Option<Fields> {
        let exponents = reach.operands.unpack(&reach.bounds);
        let mut fields = Fields { fields: Vec::new(), shifts: vec![0; reach.operands.fields()], bits: 0 };
        for &(variable, exponent) in exponents.iter().rev() {
            let width = exponent.ilog2() + 1;
            if fields.bits + width > LONGEST {
                return None;
            }
            fields.shifts[variable as usize] = fields.bits;
            fields.fields.push(Field { variable, shift: fields.bits, mask: (1 << width) - 1 });
            fields.bits += width;
        }
        Some(fields)
    }

    /// Returns Σ sₖ aₖ bₖ on a layout that holds every product.
    pub(super) fn sum<C: Coefficient>(&self, layout: Layout, terms: &[Term<'_>]) -> Polynomial {
        if self.bits <= u64::BITS {
            Table::<u64, C>::sum(self, terms).into_polynomial(self, layout)
        } else {
            Table::<u128, C>::sum(self, terms).into_polynomial(self, layout)
        }
    }

    /// Whether Σ sₖ aₖ bₖ = 0.
    pub(super) fn sum_is_zero<C: Coefficient>(&self, terms: &[Term<'_>]) -> bool {
        if self.bits <= u64::BITS {
            Table::<u64, C>::sum(self, terms).is_zero()
        } else {
            Table::<u128, C>::sum(self, terms).is_zero()
        }
    }

    /// Writes the keys of a polynomial's monomials.
    fn pack<K: Key>(&self, polynomial: &Polynomial, keys: &mut Vec<K>) {
        let layout = polynomial.layout;
        let (bits, per_word, mask) = (layout.bits, layout.per_word(), layout.mask());
        let division = bits.trailing_zeros();
        keys.clear();
        if layout.words == 0 {
            keys.resize(polynomial.term_count(), K::ONE);
            return;
        }
        keys.reserve(polynomial.term_count());
        for monomial in polynomial.monomials.chunks_exact(layout.words) {
            let mut key = K::ONE;
            for (&word, shifts) in monomial.iter().zip(self.shifts.chunks_exact(per_word)) {
                let mut rest = word;
                while rest != 0 {
                    // Fields are counted from the low end, where the last variable of a word lies.
                    let place = rest.trailing_zeros() >> division;
                    let exponent = rest >> (place << division) & mask;
                    rest ^= exponent << (place << division);
                    key = key.plus(K::field(exponent, shifts[per_word - 1 - place as usize]));
                }
            }
            keys.push(key);
        }
    }

    /// Returns for each bit of a key its field and the field's word and shift in a layout.
    fn owners(&self, layout: Layout) -> Vec<(Field, usize, u32)> {
        let mut owners = Vec::with_capacity(self.bits as usize);
        for field in &self.fields {
            let (word, shift) = layout.field(field.variable).expect("the layout holds every product");
            owners.resize((field.shift + field.mask.count_ones()) as usize, (*field, word, shift));
        }
        owners
    }
}

/// Keys with their sums, in the order of arrival.
struct Table<K, C> {
    entries: Vec<(K, C)>,
    /// Position + 1 of a key at the first free place after its hash; 0 is free.
    places: Vec<u32>,
    /// The number of bits of a hash below the bits that give the place.
    shift: u32,
}

impl<K: Key, C: Coefficient> Table<K, C> {
    fn sum(fields: &Fields, terms: &[Term<'_>]) -> Self {
        let places = (2 * count_products(terms).min(FIRST_PLACES)).next_power_of_two().max(2);
        let mut table = Table {
            entries: Vec::with_capacity(places / 2),
            places: vec![0; places],
            shift: u64::BITS - places.trailing_zeros(),
        };
        let (mut left, mut right) = (Vec::new(), Vec::new());
        for &(factor, f, g) in terms {
            // The short operand is in the outer loop: its coefficient is scaled once for each pass
            // through the long one.
            let (f, g) = if f.term_count() <= g.term_count() { (f, g) } else { (g, f) };
            fields.pack(f, &mut left);
            fields.pack(g, &mut right);
            let (a, b) = (C::view(&f.coefficients), C::view(&g.coefficients));
            table.add_pair(&C::from(factor), (&left, &a), (&right, &b));
        }
        table
    }

    /// Adds s·a·b.
    fn add_pair(&mut self, factor: &C, (left, a): (&[K], &[C]), (right, b): (&[K], &[C])) {
        for (&m, number) in left.iter().zip(a) {
            let scaled = number.times(factor);
            for (&n, number) in right.iter().zip(b) {
                self.add(m.plus(n), &scaled, number);
            }
        }
    }

    /// Adds a·b at a key.
    #[inline(always)]
    fn add(&mut self, key: K, a: &C, b: &C) {
        let places = &mut self.places[..];
        let mask = places.len() - 1;
        let mut place = (key.hash() >> self.shift) as usize;
        loop {
            let position = places[place & mask] as usize;
            match self.entries.get_mut(position.wrapping_sub(1)) {
                None => break,
                Some(entry) if entry.0 == key => return entry.1.add_product(a, b),
                Some(_) => place += 1,
            }
        }
        self.entries.push((key, a.times(b)));
        places[place & mask] = self.entries.len() as u32;
        if 2 * self.entries.len() > mask {
            self.grow();
        }
    }

    /// Doubles the number of places.
    #[cold]
    fn grow(&mut self) {
        let mask = 2 * self.places.len() - 1;
        self.places = vec![0; mask + 1];
        self.shift -= 1;
        for (position, (key, _)) in self.entries.iter().enumerate() {
            let mut place = (key.hash() >> self.shift) as usize;
            while self.places[place & mask] != 0 {
                place += 1;
            }
            self.places[place & mask] = position as u32 + 1;
        }
    }

    fn is_zero(&self) -> bool {
        self.entries.iter().all(|(_, number)| number.is_zero())
    }

    /// Returns the nonzero sums, sorted.
    fn into_polynomial(mut self, fields: &Fields, layout: Layout) -> Polynomial {
        self.entries.retain(|(_, number)| !number.is_zero());
        self.entries.sort_unstable_by_key(|&(key, _)| std::cmp::Reverse(key));
        let owners = fields.owners(layout);
        let mut monomials = vec![0; self.entries.len() * layout.words];
        let mut numbers = Vec::with_capacity(self.entries.len());
        for (term, (key, number)) in self.entries.into_iter().enumerate() {
            let monomial = &mut monomials[term * layout.words..(term + 1) * layout.words];
            let mut rest = key;
            while let Some(bit) = rest.lowest() {
                let (field, word, shift) = &owners[bit as usize];
                monomial[*word] |= rest.exponent(field) << shift;
                rest = rest.without(field);
            }
            numbers.push(number);
        }
        Polynomial::settle(layout, monomials, numbers)
    }
}
