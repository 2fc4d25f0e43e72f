//! Greatest common divisors: contents first, then a cheap proof of coprimality by images, then
//! interpolation, then remainder sequences as long as they stay small.

use super::Polynomial;
use super::content::content_in;
use super::image::{self, coordinate};
use super::interpolation::gcd_by_interpolation;
use crate::steps;
use num_integer::Integer;

/// Limit on the products of terms, weighted by the words of their coefficients, in a remainder
/// sequence.
const REMAINDER_WORK: u64 = 1 << 20;

/// The largest product of the degrees of two images whose gcd is computed.
const LONGEST_IMAGES: u64 = 1 << 24;

impl Polynomial {
    /// Returns the greatest common divisor over ℤ with positive leading coefficient; gcd(f, 0) =
    /// ±f.
    ///
    /// If this takes too much work (large dense inputs whose gcd is not found from images), or no
    /// steps remain, the result is a common divisor that need not be the greatest.
    pub fn gcd(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            let rest = if self.is_zero() { other } else { self };
            return if rest.is_negative() { rest.neg() } else { rest.clone() };
        }
        let content = self.content().gcd(&other.content());
        let monomials = common_monomial(&self.monomial_content(), &other.monomial_content());
        let common = gcd_of_primitive(&self.without_contents(), &other.without_contents());
        common.multiply_by_monomial(&monomials).scale(&content)
    }

    /// Returns f without its integer content, its monomial content and its sign.
    fn without_contents(&self) -> Self {
        let primitive = self.primitive_part();
        primitive.divide_by_monomial(&primitive.monomial_content()).expect("its own content divides")
    }
}

/// Returns the gcd of two monomials.
fn common_monomial(left: &[(u32, u32)], right: &[(u32, u32)]) -> Vec<(u32, u32)> {
    let mut common = Vec::new();
    for &(variable, exponent) in left {
        if let Some(&(_, other)) = right.iter().find(|&&(other, _)| other == variable) {
            common.push((variable, exponent.min(other)));
        }
    }
    common
}

/// Returns the gcd of polynomials without integer or monomial content, with positive leading
/// coefficients.
fn gcd_of_primitive(f: &Polynomial, g: &Polynomial) -> Polynomial {
    if f == g {
        return f.clone();
    }
    if f.is_constant() || g.is_constant() || steps::are_spent() {
        return Polynomial::one();
    }
    // A variable that occurs in only one of them: the gcd divides every coefficient of its powers.
    let (f_variables, g_variables) = (f.variables(), g.variables());
    if let Some(&variable) = f_variables.iter().find(|variable| !g_variables.contains(variable)) {
        return gcd_with_coefficients(g, f, variable);
    }
    if let Some(&variable) = g_variables.iter().find(|variable| !f_variables.contains(variable)) {
        return gcd_with_coefficients(f, g, variable);
    }
    if !images_are_short(f, g, &f_variables) {
        return Polynomial::one();
    }
    let Some(degrees) = common_degrees(f, g, &f_variables) else { return gcd_by_remainders(f, g) };
    if degrees.iter().all(|&degree| degree == 0) {
        return Polynomial::one();
    }
    if let Some(index) = degrees.iter().position(|&degree| degree == 0) {
        // The gcd does not contain this variable, so it divides every coefficient of its powers.
        return gcd_with_coefficients(&content_in(f, f_variables[index]), g, f_variables[index]);
    }
    let (small, large) = if f.term_count() <= g.term_count() { (f, g) } else { (g, f) };
    if large.divide_exact(small).is_some() {
        return small.clone();
    }
    gcd_by_interpolation(f, g, &f_variables, &degrees).unwrap_or_else(|| gcd_by_remainders(f, g))
}

/// Returns gcd(f, coefficients of g in a variable that f does not contain).
fn gcd_with_coefficients(f: &Polynomial, g: &Polynomial, variable: u32) -> Polynomial {
    let mut common = f.clone();
    let mut parts = g.coefficients_in(variable);
    parts.sort_by_key(|(_, part)| part.term_count());
    for (_, part) in parts {
        common = common.gcd(&part);
        if common.is_constant() {
            return Polynomial::one();
        }
    }
    common
}

/// Returns for each variable a bound on the gcd's degree: the degree of the gcd of images at a
/// point modulo p, which the gcd's image divides. `None` if the leading coefficient vanishes in
/// both images.
fn common_degrees(f: &Polynomial, g: &Polynomial, variables: &[u32]) -> Option<Vec<u32>> {
    let mut degrees = Vec::with_capacity(variables.len());
    for &variable in variables {
        let value = |other| coordinate(u64::from(other));
        let (left, right) = (f.image(variable, value), g.image(variable, value));
        // If one leading coefficient does not vanish, every factor keeps its degree.
        let survives = |image: &image::Image, full: u32| image.len() == full as usize + 1;
        if !survives(&left, f.degree(variable)) && !survives(&right, g.degree(variable)) {
            return None;
        }
        degrees.push(image::gcd(left, right).len() as u32 - 1);
    }
    Some(degrees)
}

/// Whether Euclid's algorithm on the images in every variable is short.
fn images_are_short(f: &Polynomial, g: &Polynomial, variables: &[u32]) -> bool {
    variables.iter().all(|&variable| {
        u64::from(f.degree(variable)).saturating_mul(u64::from(g.degree(variable))) <= LONGEST_IMAGES
    })
}

/// Computes the primitive remainder sequence in the variable of least degree, with contents
/// separate. If remainders grow beyond the limit, only the contents are compared.
///
/// The last remainder divides both polynomials by Gauss's lemma if it is primitive. Its content is a
/// gcd, which need not be the greatest, so the division is tried.
fn gcd_by_remainders(f: &Polynomial, g: &Polynomial) -> Polynomial {
    let variables = f.variables();
    let degree = |&&variable: &&u32| f.degree(variable).min(g.degree(variable));
    let Some(&main) = variables.iter().min_by_key(degree) else { return Polynomial::one() };
    let (f_content, g_content) = (content_in(f, main), content_in(g, main));
    let content = f_content.gcd(&g_content);
    let primitive = [(f, &f_content), (g, &g_content)]
        .map(|(f, content)| f.divide_exact(content).expect("its own content divides"));
    let [mut f, mut g] = primitive.clone();
    if f.degree(main) < g.degree(main) {
        std::mem::swap(&mut f, &mut g);
    }
    let mut work = REMAINDER_WORK;
    loop {
        let Some(remainder) = pseudo_remainder(&f, &g, main, &mut work) else {
            return content.primitive_part();
        };
        if remainder.is_zero() {
            let is_common = primitive.iter().all(|f| f.divide_exact(&g).is_some());
            return if is_common { g.mul(&content).primitive_part() } else { content.primitive_part() };
        }
        if remainder.degree(main) == 0 {
            return content.primitive_part();
        }
        let remainder_content = content_in(&remainder, main);
        f = g;
        g = remainder.divide_exact(&remainder_content).expect("its own content divides");
    }
}

/// Returns lc(g)ᵏ f mod g in the main variable; `None` if it takes more than the remaining work.
fn pseudo_remainder(f: &Polynomial, g: &Polynomial, main: u32, work: &mut u64) -> Option<Polynomial> {
    let degree = g.degree(main);
    let leading = g.coefficients_in(main).swap_remove(0).1;
    let mut rest = f.clone();
    while !rest.is_zero() && rest.degree(main) >= degree {
        let (exponent, coefficient) = rest.coefficients_in(main).swap_remove(0);
        let shifted = coefficient.multiply_by_monomial(&[(main, exponent - degree)]);
        for (a, b) in [(&leading, &rest), (&shifted, g)] {
            let terms = a.term_count() as u64 * b.term_count() as u64;
            let words = a.coefficient_words() * b.coefficient_words();
            *work = work.checked_sub(terms.saturating_mul(words))?;
        }
        rest = Polynomial::sum_of_products(&[(1, &leading, &rest), (-1, &shifted, g)]);
    }
    Some(rest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::SplitMix;
    use num_bigint::BigInt;

    /// Returns a dense polynomial of these degrees with pseudorandom coefficients.
    fn dense(random: &mut SplitMix, degrees: [u32; 3], largest: u64) -> Polynomial {
        let mut terms = Vec::new();
        for exponents in (0..=degrees[0]).flat_map(|i| (0..=degrees[1]).map(move |j| [i, j])) {
            for k in 0..=degrees[2] {
                let monomial = vec![(0, exponents[0]), (1, exponents[1]), (2, k)];
                terms.push((monomial, BigInt::from(random.next() % largest) + 1));
            }
        }
        Polynomial::from_terms(terms)
    }

    /// Large coefficients of the gcd leave interpolation modulo p without a result.
    #[test]
    fn a_gcd_divides_whatever_the_steps() {
        let mut random = SplitMix(1);
        for _ in 0..12 {
            let common = dense(&mut random, [1, 1, 1], u64::MAX >> 2);
            let [a, b] = [9, 9].map(|largest| dense(&mut random, [2, 2, 1], largest));
            let (f, g) = (common.mul(&a), common.mul(&b));
            for power in 0..60 {
                let steps = (1.5f64.powi(power) * 10.0) as u64;
                let found = steps::limited(steps, || f.gcd(&g));
                assert!(
                    f.divide_exact(&found).is_some() && g.divide_exact(&found).is_some(),
                    "{steps} steps"
                );
            }
        }
    }
}
