//! The wedge product: a∧b = Σ a_I b_J dx_I∧dx_J.

use super::coefficient::Coefficients;
use super::form::{Form, Products};

/// a∧b, normalised so that (a∧b)(X, Y) = a(X) b(Y) − a(Y) b(X) for 1-forms.
///
/// Products are grouped by their blade first, so that each coefficient is one sum of products.
pub fn wedge<R: Coefficients>(ring: &mut R, a: &Form<R::Scalar>, b: &Form<R::Scalar>) -> Form<R::Scalar> {
    if let ([(left, p)], [(right, q)]) = (a.terms(), b.terms()) {
        return Form::product_of_terms(ring, (*left, p), (*right, q));
    }
    let mut products: Products<R::Scalar> = Products::new();
    for (left, p) in a.terms() {
        for (right, q) in b.terms() {
            if let Some((blade, sign)) = left.wedge(*right) {
                products.entry(blade).or_default().push((sign, p, q));
            }
        }
    }
    Form::from_products(ring, a.degree() + b.degree(), products)
}
