//! The interior product, which fills the first slot, and the value of a form on fields.

use super::blade::Blade;
use super::coefficient::Coefficients;
use super::field::Field;
use super::form::{Form, Products};

/// i_X w: i_X(dx₁∧…∧dxₖ) = Σⱼ (−1)^(j−1) Xʲ dx₁∧…(without dxⱼ)…∧dxₖ; it is 0 for a function.
pub fn interior<R: Coefficients>(ring: &mut R, x: &Field<R::Scalar>, w: &Form<R::Scalar>) -> Form<R::Scalar> {
    let mut products: Products<R::Scalar> = Products::new();
    for (blade, value) in w.terms() {
        for (coordinate, component) in x.components() {
            if let Some((rest, sign)) = blade.without(coordinate) {
                products.entry(rest).or_default().push((sign, component, value));
            }
        }
    }
    Form::from_products(ring, w.degree().saturating_sub(1), products)
}

/// w(X₁, …, Xₖ) = i_Xₖ … i_X₁ w, with one field for each degree of the form.
pub fn pairing<R: Coefficients>(
    ring: &mut R,
    w: &Form<R::Scalar>,
    fields: &[&Field<R::Scalar>],
) -> R::Scalar {
    debug_assert_eq!(fields.len(), w.degree() as usize);
    let mut rest = w.clone();
    for field in fields {
        rest = interior(ring, field, &rest);
    }
    match rest.coefficient(Blade::SCALAR) {
        Some(value) => value.clone(),
        None => ring.zero(),
    }
}
