//! The exponents that products reach: a bitwise bound on each exponent, and the layout that holds
//! them.

use super::Term;
use crate::polynomial::Polynomial;
use crate::polynomial::monomial::{LARGEST_EXPONENT, Layout};

/// Space that the monomials of Σ sₖ aₖ bₖ need.
pub(super) struct Reach {
    /// The narrowest layout on which no product carries from one field into the next.
    pub(super) layout: Layout,
    /// The layout of the operands and of `bounds`: as wide, or half as wide.
    pub(super) operands: Layout,
    /// The union of the bounds on the products' exponents, in each field.
    pub(super) bounds: Vec<u64>,
}

impl Reach {
    /// # Panics
    /// If an exponent of a product is beyond 2³¹ − 1.
    pub(super) fn of(terms: &[Term<'_>]) -> Reach {
        let mut operands = Layout::CONSTANT;
        for (_, a, b) in terms {
            operands = operands.join(a.layout).join(b.layout);
        }
        let mut bounds = vec![0; operands.words];
        for (_, a, b) in terms {
            // Both bounds are below the guards, so their sum does not carry into the next field.
            if a.layout.bits == operands.bits && b.layout.bits == operands.bits {
                for (word, bound) in bounds.iter_mut().enumerate() {
                    *bound |= a.union_of_word(word) + b.union_of_word(word);
                }
            } else {
                let (left, right) = (a.union_on(operands), b.union_on(operands));
                for (word, bound) in bounds.iter_mut().enumerate() {
                    *bound |= left[word] + right[word];
                }
            }
        }
        let reaches_guards = bounds.iter().any(|bound| bound & operands.guards() != 0);
        let mut layout = operands;
        if reaches_guards && operands.bits == 32 {
            let fit = terms.iter().all(|(_, a, b)| exponents_fit(a, b));
            assert!(fit, "an exponent of a product is beyond 2^31 - 1");
        } else if reaches_guards {
            let bits = operands.bits * 2;
            layout = Layout { bits, words: operands.words_at(bits) };
        }
        Reach { layout, operands, bounds }
    }
}

fn exponents_fit(a: &Polynomial, b: &Polynomial) -> bool {
    let (left, right) = (a.degrees(), b.degrees());
    left.iter().zip(&right).all(|(&left, &right)| left <= LARGEST_EXPONENT - right)
}
