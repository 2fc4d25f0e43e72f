//! Univariate images modulo p = 2⁶¹ − 1: all variables but one are evaluated at a point. A negative
//! answer from images is certain; a positive one must be proved.

use super::{Polynomial, modular};
use crate::steps;

/// Steps to map a term, or one word of a long coefficient, to its image.
const STEPS_OF_WORD: u64 = 16;

/// A polynomial in one variable modulo p, starting with the constant term, without leading zeros.
pub(super) type Image = Vec<u64>;

/// Returns a fixed, well-mixed coordinate for each variable.
pub(super) fn coordinate(variable: u64) -> u64 {
    let mut mixed = (variable + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    modular::reduce(mixed ^ mixed >> 31)
}

impl Polynomial {
    /// Returns the image in one variable where every other variable v has the value `value(v)`.
    pub(super) fn image(&self, variable: u32, value: impl Fn(u32) -> u64) -> Image {
        steps::spend(STEPS_OF_WORD * self.word_count());
        let mut image = Vec::new();
        for term in 0..self.term_count() {
            let monomial = self.monomial(term);
            let mut product = self.residue(term);
            let mut power = 0;
            for (index, &word) in monomial.iter().enumerate() {
                let mut rest = word;
                while rest != 0 {
                    let place = rest.leading_zeros() / self.layout.bits;
                    let shift = 64 - self.layout.bits * (place + 1);
                    let exponent = rest >> shift;
                    rest &= !(self.layout.mask() << shift);
                    let other = (index * self.layout.per_word()) as u32 + place;
                    if other == variable {
                        power = exponent as usize;
                    } else {
                        product = modular::mul(product, modular::pow(value(other), exponent));
                    }
                }
            }
            if power >= image.len() {
                image.resize(power + 1, 0);
            }
            image[power] = modular::add(image[power], product);
        }
        trim(&mut image);
        image
    }
}

/// Removes leading zeros.
fn trim(image: &mut Image) {
    while image.last() == Some(&0) {
        image.pop();
    }
}

/// Replaces f by f mod g, for g ≠ 0.
fn reduce_by(f: &mut Image, g: &Image) {
    let Some(inverse) = g.last().and_then(|&leading| modular::inverse(leading)) else { return };
    while f.len() >= g.len() {
        let factor = modular::mul(f[f.len() - 1], inverse);
        let shift = f.len() - g.len();
        for index in 0..g.len() {
            f[shift + index] = modular::sub(f[shift + index], modular::mul(factor, g[index]));
        }
        trim(f);
    }
}

/// Whether g divides f modulo p; everything divides 0.
pub(super) fn divides(g: &Image, mut f: Image) -> bool {
    if g.is_empty() {
        return f.is_empty();
    }
    reduce_by(&mut f, g);
    f.is_empty()
}

/// Returns the monic gcd by Euclid's algorithm.
pub(super) fn gcd(mut f: Image, mut g: Image) -> Image {
    while !g.is_empty() {
        reduce_by(&mut f, &g);
        std::mem::swap(&mut f, &mut g);
    }
    if let Some(inverse) = f.last().and_then(|&leading| modular::inverse(leading)) {
        for coefficient in &mut f {
            *coefficient = modular::mul(*coefficient, inverse);
        }
    }
    f
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gcd_of_images_is_the_monic_common_factor() {
        // (x + 1)(x + 2) and (x + 1)(2x + 10)
        assert_eq!(gcd(vec![2, 3, 1], vec![10, 12, 2]), vec![1, 1]);
        assert!(divides(&vec![1, 1], vec![2, 3, 1]));
        assert!(!divides(&vec![5, 1], vec![2, 3, 1]));
    }
}
