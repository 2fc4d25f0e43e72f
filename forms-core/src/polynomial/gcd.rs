//! Greatest common divisors: contents first, then a cheap proof of coprimality by images, then remainders.

use super::{Polynomial, modular};
use num_integer::Integer;

impl Polynomial {
    /// The greatest common divisor over ℤ with positive leading coefficient; gcd(f, 0) = ±f.
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

    /// f without its integer content, its monomial content and its sign.
    fn without_contents(&self) -> Self {
        let primitive = self.primitive_part();
        primitive.divide_by_monomial(&primitive.monomial_content()).expect("its own content divides")
    }
}

/// The gcd of two monomials.
fn common_monomial(left: &[(u32, u32)], right: &[(u32, u32)]) -> Vec<(u32, u32)> {
    let mut common = Vec::new();
    for &(variable, exponent) in left {
        if let Some(&(_, other)) = right.iter().find(|&&(other, _)| other == variable) {
            common.push((variable, exponent.min(other)));
        }
    }
    common
}

/// The gcd of polynomials without integer or monomial content, with positive leading coefficients.
fn gcd_of_primitive(f: &Polynomial, g: &Polynomial) -> Polynomial {
    if f == g {
        return f.clone();
    }
    if f.is_constant() || g.is_constant() {
        return Polynomial::one();
    }
    // A variable of one of them only: the gcd divides every coefficient of its powers.
    let (f_variables, g_variables) = (f.variables(), g.variables());
    if let Some(&variable) = f_variables.iter().find(|variable| !g_variables.contains(variable)) {
        return gcd_with_coefficients(g, f, variable);
    }
    if let Some(&variable) = g_variables.iter().find(|variable| !f_variables.contains(variable)) {
        return gcd_with_coefficients(f, g, variable);
    }
    if are_coprime_by_images(f, g, &f_variables) {
        return Polynomial::one();
    }
    let (small, large) = if f.term_count() <= g.term_count() { (f, g) } else { (g, f) };
    if large.divide_exact(small).is_some() {
        return small.clone();
    }
    let degree = |&&variable: &&u32| f.degree(variable).min(g.degree(variable));
    let main = *f_variables.iter().min_by_key(degree).expect("it is not constant");
    gcd_by_remainders(f, g, main)
}

/// gcd(f, coefficients of g in a variable that f does not contain).
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

/// The content of f as a polynomial in one variable: the gcd of its coefficients.
pub(super) fn content_in(f: &Polynomial, variable: u32) -> Polynomial {
    let mut parts = f.coefficients_in(variable);
    parts.sort_by_key(|(_, part)| part.term_count());
    let mut content = Polynomial::zero();
    for (_, part) in parts {
        content = content.gcd(&part);
        if content.is_one() {
            break;
        }
    }
    content
}

/// Whether, for each variable, the images in that variable at a point are coprime modulo p while their
/// leading coefficients survive. Then a common factor has degree 0 in each variable: f and g are coprime.
fn are_coprime_by_images(f: &Polynomial, g: &Polynomial, variables: &[u32]) -> bool {
    variables.iter().all(|&variable| {
        let (Some(left), Some(right)) = (image(f, variable), image(g, variable)) else { return false };
        common_degree(left, right) == 0
    })
}

/// f at a fixed point modulo p but for one variable, densely from the constant term; `None` where the
/// leading coefficient vanishes.
fn image(f: &Polynomial, variable: u32) -> Option<Vec<u64>> {
    let point: Vec<u64> = (0..f.layout.fields() as u64).map(coordinate).collect();
    let mut image = vec![0; f.degree(variable) as usize + 1];
    for (exponent, coefficient) in f.coefficients_in(variable) {
        image[exponent as usize] = coefficient.evaluate_modular(&point);
    }
    (image.last() != Some(&0)).then_some(image)
}

/// A fixed, well mixed coordinate of the image point.
fn coordinate(variable: u64) -> u64 {
    let mut mixed = (variable + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    modular::reduce(mixed ^ mixed >> 31)
}

/// The degree of the gcd of polynomials modulo p, by Euclid's algorithm.
fn common_degree(mut f: Vec<u64>, mut g: Vec<u64>) -> usize {
    while !g.is_empty() {
        let inverse = modular::inverse(*g.last().expect("it is not empty")).expect("it is trimmed");
        while f.len() >= g.len() {
            let factor = modular::mul(*f.last().expect("it is not shorter"), inverse);
            let shift = f.len() - g.len();
            for (index, &coefficient) in g.iter().enumerate() {
                f[shift + index] = modular::sub(f[shift + index], modular::mul(factor, coefficient));
            }
            trim(&mut f);
        }
        std::mem::swap(&mut f, &mut g);
    }
    f.len() - 1
}

fn trim(polynomial: &mut Vec<u64>) {
    while polynomial.last() == Some(&0) {
        polynomial.pop();
    }
}

/// The primitive remainder sequence in a main variable, contents apart.
fn gcd_by_remainders(f: &Polynomial, g: &Polynomial, main: u32) -> Polynomial {
    let (f_content, g_content) = (content_in(f, main), content_in(g, main));
    let content = f_content.gcd(&g_content);
    let mut f = f.divide_exact(&f_content).expect("its own content divides");
    let mut g = g.divide_exact(&g_content).expect("its own content divides");
    if f.degree(main) < g.degree(main) {
        std::mem::swap(&mut f, &mut g);
    }
    loop {
        let remainder = pseudo_remainder(&f, &g, main);
        if remainder.is_zero() {
            return g.mul(&content).primitive_part();
        }
        if remainder.degree(main) == 0 {
            return content.primitive_part();
        }
        let remainder_content = content_in(&remainder, main);
        f = g;
        g = remainder.divide_exact(&remainder_content).expect("its own content divides");
    }
}

/// lc(g)ᵏ f mod g in the main variable.
fn pseudo_remainder(f: &Polynomial, g: &Polynomial, main: u32) -> Polynomial {
    let degree = g.degree(main);
    let leading = g.coefficients_in(main).swap_remove(0).1;
    let mut rest = f.clone();
    while !rest.is_zero() && rest.degree(main) >= degree {
        let (exponent, coefficient) = rest.coefficients_in(main).swap_remove(0);
        let shifted = coefficient.multiply_by_monomial(&[(main, exponent - degree)]);
        rest = Polynomial::sum_of_products(&[(1, &leading, &rest), (-1, &shifted, g)]);
    }
    rest
}
