//! Expansion: small products of sums are multiplied out, so that another arrangement of the same
//! polynomial can be found. (1−u)a + u b and a + u(b−a) both expand to a − u a + u b.
//!
//! Only polynomials that stay small are expanded: a long sum, or one used in several places, is a
//! variable to the polynomials around it. Nothing is expanded if terms cancel, because the product
//! is then the accurate form: (1−g)(1+g) near g = 1, where 1 − g² has lost its digits, or
//! (1−g)² + 2g(1−c) near g = c = 1.

use super::graph::{Coefficient, Exponent, Factor, Form, Graph, Node, Scaled, joined};
use std::rc::Rc;

/// Limits of expansion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Limits {
    /// A product with more terms than this stays a product.
    pub(super) product: usize,
    /// A sum with more terms than this keeps the terms it has.
    pub(super) sum: usize,
    /// A sum with more terms than this that is used several times is a variable to its users.
    pub(super) shared: usize,
}

/// Highest power of a sum that is multiplied out.
const HIGHEST_POWER: i32 = 4;

/// c Π nᵢ^eᵢ
type Monomial = (Coefficient, Vec<Factor>);

/// Returns the graph with small products multiplied out.
pub(super) fn expand(graph: &Graph, limits: Limits) -> Graph {
    let uses = graph.uses();
    let mut polynomials: Vec<Option<Rc<Vec<Monomial>>>> = vec![None; graph.len()];
    graph.rebuild(|new, node, images| {
        let operands = Operands { polynomials: &polynomials, images };
        let expanded = match graph.form(node) {
            Form::Sum(terms) => operands.sum(new, terms, limits),
            Form::Product(factors) => operands.product(new, factors, limits),
            _ => None,
        }?;
        let image = materialised(new, &expanded);
        if uses[node.place()] <= 1 || expanded.len() <= limits.shared {
            polynomials[node.place()] = Some(Rc::new(expanded));
        }
        Some(image)
    })
}

/// Operands of a node: their images, and their terms if they can be expanded.
struct Operands<'a> {
    polynomials: &'a [Option<Rc<Vec<Monomial>>>],
    images: &'a [Scaled],
}

impl Operands<'_> {
    /// Returns the terms of an operand; a single term if the operand is not expanded.
    fn terms(&self, new: &Graph, node: Node) -> Rc<Vec<Monomial>> {
        match &self.polynomials[node.place()] {
            Some(polynomial) => polynomial.clone(),
            None => Rc::new(vec![monomial(new, self.images[node.place()])]),
        }
    }

    fn sum(&self, new: &mut Graph, terms: &[(Coefficient, Node)], limits: Limits) -> Option<Vec<Monomial>> {
        let mut sum: Vec<Monomial> = Vec::new();
        for &(coefficient, node) in terms {
            for (inner, factors) in self.terms(new, node).iter() {
                add(&mut sum, (coefficient.times(*inner)?, factors.clone()))?;
            }
            if sum.len() > limits.sum {
                return None;
            }
        }
        Some(sum)
    }

    fn product(&self, new: &mut Graph, factors: &[Factor], limits: Limits) -> Option<Vec<Monomial>> {
        let mut size = 1usize;
        let mut opened = Vec::new();
        let mut closed = Vec::new();
        for &(base, exponent) in factors {
            let terms = self.terms(new, base);
            match exponent.integer() {
                Some(power @ 1..=HIGHEST_POWER) if terms.len() > 1 => {
                    size = size.saturating_mul(terms.len().saturating_pow(power as u32));
                    opened.extend(std::iter::repeat_n(terms, power as usize));
                }
                _ => closed.push((self.images[base.place()], exponent)),
            }
        }
        if size > limits.product {
            return None;
        }
        let rest = new.product(&closed);
        let mut product = vec![monomial(new, rest)];
        for terms in opened {
            let mut next = Vec::with_capacity(product.len() * terms.len());
            for (c, left) in &product {
                for (d, right) in terms.iter() {
                    add(&mut next, (c.times(*d)?, joined([left.as_slice(), right].concat())))?;
                }
            }
            product = next;
        }
        Some(product)
    }
}

fn monomial(graph: &Graph, scaled: Scaled) -> Monomial {
    let factors = match graph.form(scaled.node) {
        Form::One => vec![],
        Form::Product(factors) => factors.to_vec(),
        _ => vec![(scaled.node, Exponent::ONE)],
    };
    (scaled.coefficient, factors)
}

/// Adds a term to its like term. `None` if the two cancel, even in part.
fn add(sum: &mut Vec<Monomial>, (coefficient, factors): Monomial) -> Option<()> {
    match sum.iter_mut().find(|(_, known)| *known == factors) {
        Some((total, _)) if total.is_negative() == coefficient.is_negative() => {
            *total = total.plus(coefficient)?;
        }
        Some(_) => return None,
        None => sum.push((coefficient, factors)),
    }
    Some(())
}

fn materialised(graph: &mut Graph, polynomial: &[Monomial]) -> Scaled {
    let terms: Vec<Scaled> = polynomial
        .iter()
        .map(|(coefficient, factors)| Scaled {
            coefficient: *coefficient,
            node: graph.product_of(factors.clone()),
        })
        .collect();
    graph.sum(&terms)
}

#[cfg(test)]
mod tests {
    use crate::kernel::formula::program;

    #[test]
    fn products_whose_expansion_cancels_are_kept() {
        for formula in ["(1 - g)*(1 + g)", "(1 - g)**2 + 2*g*(1 - c)", "(g - 1)*(g**2 + g + 1)"] {
            let program = program("g c", &[formula]);
            let at = [1.0 - 1e-9, 1.0 - 1e-15];
            let (written, optimised) = (program.interpret(&at)[0], program.optimise().interpret(&at)[0]);
            assert!(
                (optimised / written - 1.0).abs() < 1e-15,
                "{formula}: {optimised}, as written {written}"
            );
        }
    }
}
