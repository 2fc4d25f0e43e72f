//! The Lie derivative, from its definition by components and not from Cartan's formula, so that
//! this formula is a law that tests both.

use super::blade::{Blade, Coordinate};
use super::coefficient::Coefficients;
use super::field::{Field, derivative_along};
use super::form::Form;
use super::wedge::wedge;

/// L_X f = X(f)
pub fn lie_of_scalar<R: Coefficients>(ring: &mut R, x: &Field<R::Scalar>, f: &R::Scalar) -> R::Scalar {
    derivative_along(ring, x, f)
}

/// L_X w as a derivation of the wedge product with L_X dxⁱ = dXⁱ: L_X(w dx_I) = X(w) dx_I + w Σⱼ
/// dx_i₁∧…∧dX^iⱼ∧…∧dx_iₖ.
pub fn lie_of_form<R: Coefficients>(
    ring: &mut R,
    x: &Field<R::Scalar>,
    w: &Form<R::Scalar>,
    coordinates: &[Coordinate],
) -> Form<R::Scalar> {
    let mut sum = w.map(ring, |ring, value| derivative_along(ring, x, value));
    for (blade, value) in w.terms() {
        for (coordinate, component) in x.components() {
            if let Some((rest, sign)) = blade.without(coordinate) {
                let term = dragged(ring, (rest, sign), component, value, coordinates);
                sum = sum.add(ring, &term);
            }
        }
    }
    sum
}

/// ±w dXⁱ∧dx_rest, where ±dxⁱ∧dx_rest is the blade itself.
fn dragged<R: Coefficients>(
    ring: &mut R,
    (rest, sign): (Blade, i8),
    component: &R::Scalar,
    value: &R::Scalar,
    coordinates: &[Coordinate],
) -> Form<R::Scalar> {
    let differential = super::exterior_derivative(ring, &Form::scalar(ring, component.clone()), coordinates);
    let signed = if sign < 0 { ring.negate(value) } else { value.clone() };
    let tail = Form::monomial(ring, rest, signed);
    wedge(ring, &differential, &tail)
}
