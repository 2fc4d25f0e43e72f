//! Products in a box of exponents: a term's place is its mixed-radix number, so places add as monomials
//! multiply.
//!
//! ```text
//! place = Σ eᵥ ∏_{w > v} radix_w = high · size + low        radixᵥ = 1 + max over k of (degᵥ aₖ + degᵥ bₖ)
//! ```
//! All products with one sum of the high parts fall into one block of `size` places, which stays in the
//! cache; blocks are filled and read out in decreasing order, so the result comes out sorted. Terms with
//! consecutive places are runs, and the inner loop adds a multiple of a run to consecutive places.

use super::{Operand, Pair, count_products};
use crate::polynomial::Polynomial;
use crate::polynomial::coefficient::Coefficient;
use crate::polynomial::monomial::Layout;

/// The most places in a block.
const BLOCK: usize = 1 << 15;
/// The most places of the box for each product of terms: below, clearing and reading costs less than hashing.
const ROOM: usize = 8;

/// The values of a run that the inner loop takes at a time.
const STEP: usize = 4;

/// The variables that occur with their radices, the first variable first, and how they part into blocks.
pub(super) struct Box {
    axes: Vec<Axis>,
    /// Places of a block.
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

/// Terms of an operand with consecutive places: the lowest place in its block, and where their numbers lie.
struct Run {
    low: usize,
    start: usize,
    end: usize,
}

/// The runs of an operand, grouped by block.
struct Image<C> {
    /// Numbers in increasing order of places.
    numbers: Vec<C>,
    runs: Vec<Run>,
    /// (high part, first run, last run + 1), in increasing order.
    groups: Vec<(usize, usize, usize)>,
}

impl<C: Coefficient> Image<C> {
    /// Pads the last run with zeros to its length.
    fn pad(&mut self, length: Option<usize>) {
        if let (Some(run), Some(length)) = (self.runs.last_mut(), length) {
            run.end = run.start + length;
            self.numbers.resize(run.end, C::zero());
        }
    }
}

impl Box {
    /// The box of all products, where it is full enough to be worth its places.
    pub(super) fn around<C: Coefficient>(layout: Layout, pairs: &[Pair<'_, C>]) -> Option<Box> {
        let limit = count_products(pairs).saturating_mul(ROOM);
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
        let mut images = Vec::with_capacity(pairs.len());
        for pair in pairs {
            images.push((
                self.image(layout, &pair.left, &pair.factor, None),
                self.image(layout, &pair.right, &C::from(1), Some(STEP)),
            ));
        }
        let mut block = vec![C::zero(); self.size + 2 * STEP];
        let mut monomials = Vec::new();
        let mut numbers = Vec::new();
        for high in (0..self.blocks).rev() {
            let mut touched = false;
            for (left, right) in &images {
                touched |= add_block(&mut block, high, left, right);
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

    /// The runs of an operand, as long as they are or else all of one length, padded with zeros.
    fn image<C: Coefficient>(
        &self,
        layout: Layout,
        operand: &Operand<'_, C>,
        factor: &C,
        length: Option<usize>,
    ) -> Image<C> {
        let count = operand.numbers.len();
        let mut image = Image { numbers: Vec::with_capacity(count), runs: Vec::new(), groups: Vec::new() };
        let mut next = usize::MAX;
        for term in (0..count).rev() {
            let monomial = &operand.monomials[term * layout.words..(term + 1) * layout.words];
            let place = self.place(monomial, layout.mask());
            let (high, low) = (place / self.size, place % self.size);
            let known = image.groups.last().is_some_and(|group| group.0 == high);
            let open = |run: &Run| length.is_none_or(|length| run.end - run.start < length);
            if known && place == next && image.runs.last().is_some_and(open) {
                image.runs.last_mut().expect("a block has runs").end += 1;
            } else {
                image.pad(length);
                if !known {
                    image.groups.push((high, image.runs.len(), image.runs.len()));
                }
                let index = image.numbers.len();
                image.runs.push(Run { low, start: index, end: index + 1 });
                image.groups.last_mut().expect("the block is known").2 += 1;
            }
            image.numbers.push(operand.numbers[term].times(factor));
            next = place + 1;
        }
        image.pad(length);
        image
    }

    /// Reads a block out from the top and clears it.
    fn read<C: Coefficient>(
        &self,
        layout: Layout,
        high: usize,
        block: &mut [C],
        monomials: &mut Vec<u64>,
        numbers: &mut Vec<C>,
    ) {
        // Along a row just the last exponent differs.
        let (row, shift, word) = match self.axes.last() {
            Some(axis) => (axis.radix, axis.shift, axis.word),
            None => (1, 0, 0),
        };
        let mut base = vec![0; layout.words];
        for first in (0..self.size).step_by(row).rev() {
            let mut known = false;
            for exponent in (0..row).rev() {
                let place = &mut block[first + exponent];
                if place.is_zero() {
                    continue;
                }
                if !known {
                    self.unplace(high * self.size + first, &mut base);
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

    /// The monomial at a place.
    fn unplace(&self, place: usize, monomial: &mut [u64]) {
        monomial.fill(0);
        let mut rest = place;
        for axis in &self.axes {
            monomial[axis.word] |= ((rest / axis.stride) as u64) << axis.shift;
            rest %= axis.stride;
        }
    }
}

/// The variables that occur, with their radices; `None` where the box has more than `limit` places.
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

/// Adds the products whose high parts sum to `high`; answers whether there are any.
fn add_block<C: Coefficient>(block: &mut [C], high: usize, left: &Image<C>, right: &Image<C>) -> bool {
    let mut touched = false;
    let mut partner = right.groups.len();
    for &(a_high, a_first, a_last) in &left.groups {
        while partner > 0 && right.groups[partner - 1].0 + a_high > high {
            partner -= 1;
        }
        if partner == 0 {
            break;
        }
        let (b_high, b_first, b_last) = right.groups[partner - 1];
        if a_high + b_high == high {
            touched = true;
            for a in &left.runs[a_first..a_last] {
                // One length in the whole inner loop keeps its branches predictable.
                let numbers = &left.numbers[a.start..a.end];
                for b in &right.runs[b_first..b_last] {
                    let (steps, _) = right.numbers[b.start..b.end].as_chunks::<STEP>();
                    add_run(&mut block[a.low + b.low..], numbers, &steps[0]);
                }
            }
        }
    }
    touched
}

/// target[i + j] += a[i]·b[j] for four values of b: their open sums slide along the target, so that each place
/// is read and written once for four products.
#[inline(always)]
fn add_run<C: Coefficient>(target: &mut [C], a: &[C], b: &[C; STEP]) {
    let target = &mut target[..a.len() + STEP - 1];
    let (mut s1, mut s2, mut s3) = (C::zero(), C::zero(), C::zero());
    let mut i = 0;
    while i < a.len() {
        s1.add_product(&a[i], &b[0]);
        target[i] = target[i].plus(&s1);
        s2.add_product(&a[i], &b[1]);
        s1 = s2;
        s3.add_product(&a[i], &b[2]);
        s2 = s3;
        s3 = a[i].times(&b[3]);
        i += 1;
    }
    target[i] = target[i].plus(&s1);
    target[i + 1] = target[i + 1].plus(&s2);
    target[i + 2] = target[i + 2].plus(&s3);
}
