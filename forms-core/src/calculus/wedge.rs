//! The wedge product: a∧b = Σ a_I b_J dx_I∧dx_J.

use super::blade::Blade;
use super::coefficient::Coefficients;
use super::form::Form;
use std::collections::BTreeMap;

/// a∧b, normalised so that (a∧b)(X, Y) = a(X) b(Y) − a(Y) b(X) for 1-forms.
///
/// Products are grouped by their blade first, so that each coefficient is one sum of products.
pub fn wedge<R: Coefficients>(ring: &mut R, a: &Form<R::Scalar>, b: &Form<R::Scalar>) -> Form<R::Scalar> {
    let mut products: BTreeMap<Blade, Vec<(i8, &R::Scalar, &R::Scalar)>> = BTreeMap::new();
    for (left, p) in a.terms() {
        for (right, q) in b.terms() {
            if let Some((blade, sign)) = left.wedge(*right) {
                products.entry(blade).or_default().push((sign, p, q));
            }
        }
    }
    let mut terms = Vec::with_capacity(products.len());
    for (blade, group) in products {
        let value = ring.sum_of_products(&group);
        if !ring.is_zero(&value) {
            terms.push((blade, value));
        }
    }
    Form::from_terms(a.degree() + b.degree(), terms)
}
