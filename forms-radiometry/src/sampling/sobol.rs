//! Sobol's sequence in many dimensions: computes the digits of jointly stratified coordinates from
//! an index.
//!
//! Source: S. Joe, F. Y. Kuo, Constructing Sobol sequences with better two-dimensional projections
//! (2008), whose direction numbers these are.

/// Number of binary digits of an index and of a coordinate.
const DIGITS: usize = 32;
/// Number of dimensions.
pub(super) const DIMENSIONS: usize = 32;

/// For each dimension except the first, the inner coefficients of a primitive polynomial and the
/// initial direction numbers, as many as its degree.
const POLYNOMIALS: [(u32, &[u32]); DIMENSIONS - 1] = [
    (0, &[1]),
    (1, &[1, 3]),
    (1, &[1, 3, 1]),
    (2, &[1, 1, 1]),
    (1, &[1, 1, 3, 3]),
    (4, &[1, 3, 5, 13]),
    (2, &[1, 1, 5, 5, 17]),
    (4, &[1, 1, 5, 5, 5]),
    (7, &[1, 1, 7, 11, 19]),
    (11, &[1, 1, 5, 1, 1]),
    (13, &[1, 1, 1, 3, 11]),
    (14, &[1, 3, 5, 5, 31]),
    (1, &[1, 3, 3, 9, 7, 49]),
    (13, &[1, 1, 1, 15, 21, 21]),
    (16, &[1, 3, 1, 13, 27, 49]),
    (19, &[1, 1, 1, 15, 7, 5]),
    (22, &[1, 3, 1, 15, 13, 25]),
    (25, &[1, 1, 5, 5, 19, 61]),
    (1, &[1, 3, 7, 11, 23, 15, 103]),
    (4, &[1, 3, 7, 13, 13, 15, 69]),
    (7, &[1, 1, 3, 13, 7, 35, 63]),
    (8, &[1, 3, 5, 9, 1, 25, 53]),
    (14, &[1, 3, 1, 13, 9, 35, 107]),
    (19, &[1, 3, 1, 5, 27, 61, 31]),
    (21, &[1, 1, 5, 11, 19, 41, 61]),
    (28, &[1, 3, 5, 3, 3, 13, 69]),
    (31, &[1, 1, 7, 13, 1, 19, 1]),
    (32, &[1, 3, 7, 5, 13, 19, 59]),
    (37, &[1, 1, 3, 9, 25, 29, 41]),
    (41, &[1, 3, 5, 13, 23, 1, 55]),
    (42, &[1, 3, 7, 3, 13, 59, 17]),
];

/// For each pair of dimensions and each digit of an index, the digits of both coordinates that it
/// flips, reversed.
static COLUMNS: [[[u32; 2]; DIGITS]; DIMENSIONS / 2] = columns();

/// Returns the digits of both coordinates of an index in a pair of dimensions, reversed: the first
/// digit is the lowest bit.
pub(super) fn reversed(pair: usize, mut index: u32) -> [u32; 2] {
    let mut sums = [0; 2];
    for column in &COLUMNS[pair] {
        if index == 0 {
            break;
        }
        let is_set = (index & 1).wrapping_neg();
        sums = [sums[0] ^ (column[0] & is_set), sums[1] ^ (column[1] & is_set)];
        index >>= 1;
    }
    sums
}

const fn columns() -> [[[u32; 2]; DIGITS]; DIMENSIONS / 2] {
    let mut all = [[[0; 2]; DIGITS]; DIMENSIONS / 2];
    let mut dimension = 0;
    while dimension < DIMENSIONS {
        let directions = directions(dimension);
        let mut digit = 0;
        while digit < DIGITS {
            all[dimension / 2][digit][dimension % 2] = directions[digit].reverse_bits();
            digit += 1;
        }
        dimension += 1;
    }
    all
}

/// Returns the direction numbers of a dimension: with the polynomial xˢ + a₁ xˢ⁻¹ + … + 1, vᵢ = a₁
/// vᵢ₋₁ ⊕ … ⊕ vᵢ₋ₛ ⊕ vᵢ₋ₛ/2ˢ.
const fn directions(dimension: usize) -> [u32; DIGITS] {
    let mut directions = [0; DIGITS];
    let mut digit = 0;
    while digit < DIGITS {
        directions[digit] = 1 << (DIGITS - 1 - digit);
        if dimension > 0 {
            let (inner, first) = POLYNOMIALS[dimension - 1];
            let degree = first.len();
            if digit < degree {
                directions[digit] *= first[digit];
            } else {
                let last = directions[digit - degree];
                directions[digit] = last ^ (last >> degree);
                let mut back = 1;
                while back < degree {
                    directions[digit] ^= directions[digit - back] * (inner >> (degree - 1 - back) & 1);
                    back += 1;
                }
            }
        }
        digit += 1;
    }
    directions
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of n points, each elementary cell of area 1/n contains one in the first pair, and at most 2ᵗ
    /// in the others.
    #[test]
    fn each_pair_of_dimensions_lies_evenly() {
        const BITS: usize = 10;
        let most = |one: usize, other: usize, columns: usize| {
            let mut counts = vec![0_u32; 1 << BITS];
            let of = |dimension: usize, index| {
                reversed(dimension / 2, index)[dimension % 2].reverse_bits() as usize
            };
            for index in 0..1 << BITS {
                let cell = |digits: usize, bits: usize| digits >> (DIGITS - 1 - bits) >> 1;
                let column = cell(of(one, index), columns);
                counts[column << (BITS - columns) | cell(of(other, index), BITS - columns)] += 1;
            }
            counts.into_iter().max().unwrap_or(0)
        };
        for columns in 0..=BITS {
            assert_eq!(most(0, 1, columns), 1, "{columns}");
            for (one, other) in (0..DIMENSIONS).flat_map(|one| (0..one).map(move |other| (one, other))) {
                assert!(most(one, other, columns) <= 1 << 5, "{one}, {other}, {columns}");
            }
        }
    }
}
