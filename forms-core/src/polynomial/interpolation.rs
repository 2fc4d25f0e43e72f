//! Gcds from images: univariate gcds modulo p = 2⁶¹ − 1 on a grid of points, interpolated along
//! each axis, lifted to ℤ and proved by division.
//!
//! With x the main variable and γ = gcd(lcₓ f, lcₓ g), each image is made monic and multiplied by
//! the value of γ. The results are the images of one polynomial H = (γ/lcₓ G)·G, and the gcd G is
//! the primitive part of H.

use super::content::content_in;
use super::image::{self, Image, coordinate};
use super::{Polynomial, modular};
use crate::steps;
use num_bigint::BigInt;

/// Limit on the points of a grid.
const MOST_POINTS: usize = 1 << 14;

/// Returns the gcd of f and g, whose degrees in the variables are at most `degrees`; `None` if the
/// grid is too large, a point is unlucky or a coefficient of H is beyond p/2. The result divides f
/// and g and has the greatest degree in x that a common factor can have, so it is their gcd up to a
/// content, which the primitive parts lack.
pub(super) fn gcd_by_interpolation(
    f: &Polynomial,
    g: &Polynomial,
    variables: &[u32],
    degrees: &[u32],
) -> Option<Polynomial> {
    let main = main_variable(f, g, variables);
    let (f_content, g_content) = (content_in(f, main), content_in(g, main));
    let (f, g) = (f.divide_exact(&f_content)?, g.divide_exact(&g_content)?);
    let leading = |polynomial: &Polynomial| polynomial.coefficients_in(main).swap_remove(0).1;
    let gamma = leading(&f).gcd(&leading(&g));
    let mut grid = Grid { axes: Vec::new(), points: 1, height: 0 };
    for (&variable, &degree) in variables.iter().zip(degrees) {
        if variable == main {
            grid.height = degree as usize + 1;
        } else {
            let count = degree as usize + gamma.degree(variable) as usize + 1;
            grid.points = grid.points.checked_mul(count).filter(|&points| points <= MOST_POINTS)?;
            grid.axes.push((variable, count));
        }
    }
    let mut values = grid.sample(&f, &g, &gamma, main)?;
    grid.interpolate(&mut values);
    let lifted = grid.lift(&values, main);
    let primitive = lifted.divide_exact(&content_in(&lifted, main))?.primitive_part();
    if primitive.degree(main) as usize + 1 != grid.height {
        return None;
    }
    f.divide_exact(&primitive)?;
    g.divide_exact(&primitive)?;
    Some(primitive.mul(&f_content.gcd(&g_content)).primitive_part())
}

/// Returns the variable whose leading coefficients have the fewest terms, since γ enters every
/// image.
fn main_variable(f: &Polynomial, g: &Polynomial, variables: &[u32]) -> u32 {
    let mut best = (usize::MAX, 0);
    for &variable in variables {
        let terms = |polynomial: &Polynomial| polynomial.coefficients_in(variable)[0].1.term_count();
        best = best.min((terms(f).min(terms(g)), variable));
    }
    best.1
}

/// A grid of points (c₁ + i₁, c₂ + i₂, …), with an axis for each variable except x. Values are
/// stored with the last axis fastest, and with `height` numbers, the coefficients of powers of x,
/// at each point.
struct Grid {
    axes: Vec<(u32, usize)>,
    points: usize,
    height: usize,
}

impl Grid {
    /// Returns the value of a variable at a number along its axis.
    fn value(variable: u32, number: usize) -> u64 {
        modular::add(coordinate(u64::from(variable) + (1 << 32)), number as u64)
    }

    /// Returns γ times the monic gcd of the images at each point.
    fn sample(&self, f: &Polynomial, g: &Polynomial, gamma: &Polynomial, main: u32) -> Option<Vec<u64>> {
        let last = self.axes.iter().map(|axis| axis.0).chain([main]).max()?;
        let mut point = vec![0; last as usize + 1];
        let mut values = Vec::with_capacity(self.points * self.height);
        for number in 0..self.points {
            if steps::are_spent() {
                return None;
            }
            let mut rest = number;
            for &(variable, count) in self.axes.iter().rev() {
                point[variable as usize] = Self::value(variable, rest % count);
                rest /= count;
            }
            let value = |variable: u32| point[variable as usize];
            let common: Image = image::gcd(f.image(main, value), g.image(main, value));
            if common.len() != self.height {
                return None;
            }
            let factor = gamma.evaluate_modular(&point);
            values.extend(common.iter().map(|&coefficient| modular::mul(coefficient, factor)));
        }
        Some(values)
    }

    /// Converts values into coefficients, axis by axis.
    fn interpolate(&self, values: &mut [u64]) {
        let mut stride = self.height;
        for &(variable, count) in self.axes.iter().rev() {
            let mut line = vec![0; count];
            for start in 0..values.len() {
                if !(start / stride).is_multiple_of(count) {
                    continue;
                }
                for number in 0..count {
                    line[number] = values[start + number * stride];
                }
                newton(Self::value(variable, 0), &mut line);
                for number in 0..count {
                    values[start + number * stride] = line[number];
                }
            }
            stride *= count;
        }
    }

    /// Returns the polynomial with these coefficients, each lifted to the residue of least absolute
    /// value.
    fn lift(&self, values: &[u64], main: u32) -> Polynomial {
        let mut terms = Vec::new();
        for (index, &value) in values.iter().enumerate().filter(|&(_, &value)| value != 0) {
            let mut monomial = vec![(main, (index % self.height) as u32)];
            let mut rest = index / self.height;
            for &(variable, count) in self.axes.iter().rev() {
                monomial.push((variable, (rest % count) as u32));
                rest /= count;
            }
            let number =
                if value > modular::PRIME / 2 { value as i64 - modular::PRIME as i64 } else { value as i64 };
            terms.push((monomial, BigInt::from(number)));
        }
        Polynomial::from_terms(terms)
    }
}

/// Converts values at c, c + 1, c + 2, … into coefficients: divided differences, then Horner's rule
/// on a₀ + (x − c)(a₁ + (x − c − 1)(a₂ + …)).
fn newton(first: u64, line: &mut [u64]) {
    let count = line.len();
    for order in 1..count {
        let inverse = modular::inverse(order as u64).unwrap_or(0);
        for index in (order..count).rev() {
            line[index] = modular::mul(modular::sub(line[index], line[index - 1]), inverse);
        }
    }
    for index in (0..count.saturating_sub(1)).rev() {
        let node = modular::add(first, index as u64);
        for power in index..count - 1 {
            line[power] = modular::sub(line[power], modular::mul(node, line[power + 1]));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn interpolation_finds_the_coefficients() {
        let coefficients = [7, 0, 3, 1];
        let value =
            |x: u64| coefficients.iter().rev().fold(0, |sum, &c| modular::add(modular::mul(sum, x), c));
        let mut line: Vec<u64> = (0..4).map(|number| value(100 + number)).collect();
        newton(100, &mut line);
        assert_eq!(line, coefficients);
    }
}
