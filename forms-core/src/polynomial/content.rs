//! Content of a polynomial in one variable.

use super::Polynomial;

/// Returns the content of f as a polynomial in one variable: the gcd of its coefficients.
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
