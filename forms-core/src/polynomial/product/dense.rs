//! Dense products in a box of exponents: a term's place is its mixed-radix number, so places are
//! added where monomials are multiplied.
//!
//! ```text
//! place = Σ eᵥ ∏_{w > v} radix_w = high · size + low        radixᵥ = 1 + max over k of (degᵥ aₖ + degᵥ bₖ)
//! ```
//! All products with the same sum of the high parts fall into one block of `size` places, which
//! stays in the cache. Blocks are filled and read out in decreasing order, so the result is sorted.
//! Terms with consecutive places form runs, and the inner loop adds a multiple of a run to
//! consecutive places.

use super::lanes::{self, Padded, Scattered};
use super::reach::Reach;
use super::{Operand, Pair};
use crate::polynomial::Polynomial;
use crate::polynomial::coefficient::Coefficient;
use crate::polynomial::monomial::Layout;
use std::ops::Range;

/// Largest number of places in a block: 32 KiB of 64-bit numbers, the size of the nearest cache.
const BLOCK: usize = 1 << 12;
/// Largest number of places of the box per product of terms: up to it, clearing and reading cost
/// less than hashing.
const ROOM: usize = 8;

/// Largest number of values of a run that the inner loop processes at a time.
const STEP: usize = 8;

/// Whether a box may be full enough, judged by the number of variables: each variable at least
/// doubles the box.
pub(super) fn may_fit(reach: &Reach, products: usize) -> bool {
    let variables = reach.operands.unpack(&reach.bounds).len();
    products.saturating_mul(ROOM).checked_shr(variables as u32).is_some_and(|room| room > 0)
}

/// The variables that occur, with their radices, the first variable first, and their division into
/// blocks.
pub(super) struct Box {
    axes: Vec<Axis>,
    /// Number of places of a block.
    size: usize,
    /// Number of blocks.
    blocks: usize,
}

struct Axis {
    word: usize,
    shift: u32,
    stride: usize,
    radix: usize,
}

/// Terms of an operand with consecutive places: the lowest place in its block, and the range of
/// their numbers.
pub(super) struct Run {
    pub(super) low: usize,
    pub(super) start: usize,
    pub(super) end: usize,
}

/// The runs of an operand, grouped by block.
pub(super) struct Image<C> {
    /// Numbers in increasing order of places.
    pub(super) numbers: Vec<C>,
    pub(super) runs: Vec<Run>,
    /// Groups in increasing order of the high part.
    pub(super) groups: Vec<Group>,
}

/// The terms of an operand with one high part.
pub(super) struct Group {
    high: usize,
    pub(super) runs: Range<usize>,
    pub(super) terms: Range<usize>,
}

/// One product sₖ aₖ bₖ arranged by places, with the factor in the left operand.
struct Images<C> {
    left: Image<C>,
    right: Image<C>,
    /// The operands arranged for multiplications four at a time, if these apply.
    lanes: Option<(Scattered, Padded)>,
}

impl<C: Coefficient> Image<C> {
    /// Sorts the runs of each group by their lengths.
    fn sort_by_length(&mut self) {
        for group in &self.groups {
            self.runs[group.runs.clone()].sort_by_key(|run| std::cmp::Reverse(run.end - run.start));
        }
    }
}

impl Box {
    /// Returns the box of all products, if it is full enough to be worth its places.
    pub(super) fn around<C: Coefficient>(
        layout: Layout,
        pairs: &[Pair<'_, C>],
        products: usize,
    ) -> Option<Box> {
        let limit = products.saturating_mul(ROOM);
        let axes = axes_of(layout, pairs, limit)?;
        let mut container = Box { axes, size: 1, blocks: 1 };
        for axis in container.axes.iter_mut().rev() {
            axis.stride = container.size * container.blocks;
            let within =
                container.blocks == 1 && (container.size == 1 || container.size * axis.radix <= BLOCK);
            let grown = if within { &mut container.size } else { &mut container.blocks };
            *grown = grown.checked_mul(axis.radix)?;
            if container.size.checked_mul(container.blocks)? > limit {
                return None;
            }
        }
        Some(container)
    }

    /// Σ sₖ aₖ bₖ
    pub(super) fn sum<C: Coefficient>(&self, layout: Layout, pairs: &[Pair<'_, C>]) -> Polynomial {
        let images: Vec<Images<C>> = pairs.iter().map(|pair| self.images(layout, pair)).collect();
        // Vectors reach beyond the last place, with zeros.
        let mut block = vec![C::zero(); self.size + lanes::LONGEST];
        let mut monomials = Vec::new();
        let mut numbers = Vec::new();
        for high in (0..self.blocks).rev() {
            let mut touched = false;
            for images in &images {
                touched |= images.add_block(&mut block, high);
            }
            if touched {
                self.read(layout, high, &mut block, &mut monomials, &mut numbers);
            }
        }
        Polynomial::settle(layout, monomials, numbers)
    }

    fn place(&self, monomial: &[u64], mask: u64) -> usize {
        let mut place = 0;
        for axis in &self.axes {
            place += (monomial[axis.word] >> axis.shift & mask) as usize * axis.stride;
        }
        place
    }

    fn images<C: Coefficient>(&self, layout: Layout, pair: &Pair<'_, C>) -> Images<C> {
        let left = self.image(layout, &pair.left, &pair.factor, usize::MAX);
        if lanes::available()
            && let Some(scattered) = Scattered::of(&left)
        {
            let right = self.image(layout, &pair.right, &C::from(1), lanes::LONGEST);
            if let Some(padded) = Padded::of(&right) {
                return Images { left, right, lanes: Some((scattered, padded)) };
            }
        }
        Images { left, right: self.image(layout, &pair.right, &C::from(1), STEP), lanes: None }
    }

    /// Returns the runs of an operand, cut at a length, with the longest of each group first.
    fn image<C: Coefficient>(
        &self,
        layout: Layout,
        operand: &Operand<'_, C>,
        factor: &C,
        longest: usize,
    ) -> Image<C> {
        let count = operand.numbers.len();
        let mut image = Image { numbers: Vec::with_capacity(count), runs: Vec::new(), groups: Vec::new() };
        let mut next = usize::MAX;
        for term in (0..count).rev() {
            let monomial = &operand.monomials[term * layout.words..(term + 1) * layout.words];
            let place = self.place(monomial, layout.mask());
            let (high, low) = (place / self.size, place % self.size);
            let known = image.groups.last().is_some_and(|group| group.high == high);
            let index = image.numbers.len();
            let open = |run: &Run| run.end - run.start < longest;
            if known && place == next && image.runs.last().is_some_and(open) {
                image.runs.last_mut().expect("a block has runs").end += 1;
            } else {
                if !known {
                    let runs = image.runs.len()..image.runs.len();
                    image.groups.push(Group { high, runs, terms: index..index });
                }
                image.runs.push(Run { low, start: index, end: index + 1 });
            }
            let group = image.groups.last_mut().expect("the block is known");
            (group.runs.end, group.terms.end) = (image.runs.len(), index + 1);
            image.numbers.push(operand.numbers[term].times(factor));
            next = place + 1;
        }
        image.sort_by_length();
        image
    }

    /// Reads out a block from the top and clears it.
    fn read<C: Coefficient>(
        &self,
        layout: Layout,
        high: usize,
        block: &mut [C],
        monomials: &mut Vec<u64>,
        numbers: &mut Vec<C>,
    ) {
        // Only the last exponent differs along a row.
        let (row, shift, word) = match self.axes.last() {
            Some(axis) => (axis.radix, axis.shift, axis.word),
            None => (1, 0, 0),
        };
        let mut base = vec![0; layout.words];
        for (index, places) in block[..self.size].chunks_exact_mut(row).enumerate().rev() {
            let mut known = false;
            for (exponent, place) in places.iter_mut().enumerate().rev() {
                if place.is_zero() {
                    continue;
                }
                if !known {
                    self.unplace(high * self.size + index * row, &mut base);
                    known = true;
                }
                numbers.push(std::mem::replace(place, C::zero()));
                let start = monomials.len();
                monomials.extend_from_slice(&base);
                if layout.words > 0 {
                    monomials[start + word] |= (exponent as u64) << shift;
                }
            }
        }
    }

    /// Writes the monomial at a place.
    fn unplace(&self, place: usize, monomial: &mut [u64]) {
        monomial.fill(0);
        let mut rest = place;
        for axis in &self.axes {
            monomial[axis.word] |= ((rest / axis.stride) as u64) << axis.shift;
            rest %= axis.stride;
        }
    }
}

/// Returns the variables that occur, with their radices; `None` if the box has more than `limit`
/// places.
fn axes_of<C: Coefficient>(layout: Layout, pairs: &[Pair<'_, C>], limit: usize) -> Option<Vec<Axis>> {
    let mut axes = Vec::new();
    let mut size = 1usize;
    for word in 0..layout.words {
        let mut union = 0;
        for pair in pairs {
            union |= union_of_word(layout, word, &pair.left) | union_of_word(layout, word, &pair.right);
        }
        while union != 0 {
            let place = union.leading_zeros() / layout.bits;
            let shift = 64 - layout.bits * (place + 1);
            union &= !(layout.mask() << shift);
            // Each variable at least doubles the box: too many of them end the search early.
            size = size.checked_mul(2)?;
            if size > limit {
                return None;
            }
            axes.push(Axis { word, shift, stride: 0, radix: 0 });
        }
    }
    for axis in &mut axes {
        for pair in pairs {
            let degree = degree(layout, axis, &pair.left) + degree(layout, axis, &pair.right);
            axis.radix = axis.radix.max(degree + 1);
        }
    }
    Some(axes)
}

fn union_of_word<C: Coefficient>(layout: Layout, word: usize, operand: &Operand<'_, C>) -> u64 {
    let mut union = 0;
    let mut index = word;
    while index < operand.monomials.len() {
        union |= operand.monomials[index];
        index += layout.words;
    }
    union
}

fn degree<C: Coefficient>(layout: Layout, axis: &Axis, operand: &Operand<'_, C>) -> usize {
    let mut degree = 0;
    let mut index = axis.word;
    while index < operand.monomials.len() {
        degree = degree.max(operand.monomials[index] >> axis.shift & layout.mask());
        index += layout.words;
    }
    degree as usize
}

impl<C: Coefficient> Images<C> {
    /// Adds the products whose high parts sum to `high`; returns whether there are any.
    fn add_block(&self, block: &mut [C], high: usize) -> bool {
        let mut touched = false;
        let (left, right) = (&self.left.groups, &self.right.groups);
        // The side with fewer groups is iterated and its partners are looked up: a factor of two
        // terms has two groups, the other one thousands.
        let from_left = left.len() <= right.len();
        let (few, many) = if from_left { (left, right) } else { (right, left) };
        for group in few.iter().take_while(|group| group.high <= high) {
            if let Ok(partner) = many.binary_search_by_key(&(high - group.high), |group| group.high) {
                let (a, b) = if from_left { (group, &many[partner]) } else { (&many[partner], group) };
                self.add_groups(block, a, b);
                touched = true;
            }
        }
        touched
    }

    fn add_groups(&self, block: &mut [C], a: &Group, b: &Group) {
        if let Some((scattered, padded)) = &self.lanes
            && let Some(block) = C::words_mut(block)
        {
            return lanes::add(block, (scattered, a.terms.clone()), (padded, b.runs.clone()));
        }
        for a in &self.left.runs[a.runs.clone()] {
            let numbers = &self.left.numbers[a.start..a.end];
            for b in &self.right.runs[b.runs.clone()] {
                let target = &mut block[a.low + b.low..];
                let factors = &self.right.numbers[b.start..b.end];
                // Runs are sorted by length, which keeps the branch predictable.
                match factors.len() {
                    1 => add_run::<1, C>(target, numbers, factors),
                    2 => add_run::<2, C>(target, numbers, factors),
                    3 => add_run::<3, C>(target, numbers, factors),
                    4 => add_run::<4, C>(target, numbers, factors),
                    5 => add_run::<5, C>(target, numbers, factors),
                    6 => add_run::<6, C>(target, numbers, factors),
                    7 => add_run::<7, C>(target, numbers, factors),
                    _ => add_run::<STEP, C>(target, numbers, factors),
                }
            }
        }
    }
}

/// target[i + j] += a[i]·b[j] for the N values of b: their partial sums slide along the target, so
/// that each place is read and written once for all values of b.
#[inline(always)]
fn add_run<const N: usize, C: Coefficient>(target: &mut [C], a: &[C], b: &[C]) {
    let Some(b) = b.first_chunk::<N>() else { return };
    let (target, rest) = target[..a.len() + N - 1].split_at_mut(a.len());
    let mut open: [C; N] = std::array::from_fn(|_| C::zero());
    for (a, target) in a.iter().zip(target) {
        for j in 0..N {
            open[j].add_product(a, &b[j]);
        }
        *target = target.plus(&open[0]);
        for j in 1..N {
            open.swap(j - 1, j);
        }
        open[N - 1] = C::zero();
    }
    for (target, open) in rest.iter_mut().zip(&open) {
        *target = target.plus(open);
    }
}
