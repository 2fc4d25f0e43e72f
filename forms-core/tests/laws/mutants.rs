//! Mutants of the calculus: each differs from it in one operation, as after a programming error.

use super::algebra::{Algebra, Genuine, substitution};
use super::scene::World;
use forms_core::calculus::{Blade, Coefficients, Coordinate, Field, Form, derivative_along};
use forms_core::expression::Expr;

/// dx∧dy = dy∧dx
#[derive(Debug)]
pub(crate) struct WedgeWithoutSigns;

impl Algebra for WedgeWithoutSigns {
    fn wedge<R: Coefficients>(
        &self,
        ring: &mut R,
        a: &Form<R::Scalar>,
        b: &Form<R::Scalar>,
    ) -> Form<R::Scalar> {
        wedge_by(ring, a, b, |left, right| left.wedge(right).map(|(blade, _)| (blade, 1)))
    }
}

/// Loses the sign of moving a form past one of higher degree.
#[derive(Debug)]
pub(crate) struct WedgeLosingOneSign;

impl Algebra for WedgeLosingOneSign {
    fn wedge<R: Coefficients>(
        &self,
        ring: &mut R,
        a: &Form<R::Scalar>,
        b: &Form<R::Scalar>,
    ) -> Form<R::Scalar> {
        wedge_by(ring, a, b, |left, right| {
            let (blade, sign) = left.wedge(right)?;
            Some((blade, if left.degree() < right.degree() { 1 } else { sign }))
        })
    }
}

/// Maps dx∧dx to another basis form of its degree instead of zero.
#[derive(Debug)]
pub(crate) struct WedgeKeepingSquares;

impl Algebra for WedgeKeepingSquares {
    fn wedge<R: Coefficients>(
        &self,
        ring: &mut R,
        a: &Form<R::Scalar>,
        b: &Form<R::Scalar>,
    ) -> Form<R::Scalar> {
        wedge_by(ring, a, b, |left, right| {
            left.wedge(right).or_else(|| crowded(left, right).map(|blade| (blade, 1)))
        })
    }
}

/// γ_m(w) instead of m! γ_m(w)
#[derive(Debug)]
pub(crate) struct PowerTakingEachSetOnce;

impl Algebra for PowerTakingEachSetOnce {
    fn power<R: Coefficients>(&self, ring: &mut R, w: &Form<R::Scalar>, exponent: u32) -> Form<R::Scalar> {
        if !is_even(w) {
            return Genuine.power(ring, w, exponent);
        }
        repeated(
            ring,
            w,
            exponent,
            |left, right| {
                if first(left) < first(right) { left.wedge(right) } else { None }
            },
        )
    }
}

/// Omits sets whose blades interleave.
#[derive(Debug)]
pub(crate) struct PowerOfNeighboursAlone;

impl Algebra for PowerOfNeighboursAlone {
    fn power<R: Coefficients>(&self, ring: &mut R, w: &Form<R::Scalar>, exponent: u32) -> Form<R::Scalar> {
        if !is_even(w) {
            return Genuine.power(ring, w, exponent);
        }
        repeated(ring, w, exponent, |left, right| {
            let apart = last(left) < first(right) || last(right) < first(left);
            if apart { left.wedge(right) } else { None }
        })
    }
}

/// Assumes that the terms of a form of odd degree commute.
#[derive(Debug)]
pub(crate) struct PowerOfOddFormsAsOfEvenOnes;

impl Algebra for PowerOfOddFormsAsOfEvenOnes {
    fn power<R: Coefficients>(&self, ring: &mut R, w: &Form<R::Scalar>, exponent: u32) -> Form<R::Scalar> {
        if w.degree() % 2 == 0 {
            return Genuine.power(ring, w, exponent);
        }
        repeated(ring, w, exponent, |left, right| left.wedge(right).map(|(blade, _)| (blade, 1)))
    }
}

/// Omits the derivative by the last coordinate.
#[derive(Debug)]
pub(crate) struct DerivativeSkippingACoordinate;

impl Algebra for DerivativeSkippingACoordinate {
    fn d<R: Coefficients>(&self, ring: &mut R, w: &Form<R::Scalar>, along: &[Coordinate]) -> Form<R::Scalar> {
        Genuine.d(ring, w, &along[..along.len() - 1])
    }
}

/// Adds ∂ᵢw_I to the coefficient of dx_I∪i without a sign.
#[derive(Debug)]
pub(crate) struct DerivativeWithoutSigns;

impl Algebra for DerivativeWithoutSigns {
    fn d<R: Coefficients>(&self, ring: &mut R, w: &Form<R::Scalar>, along: &[Coordinate]) -> Form<R::Scalar> {
        let mut sum = Form::zero(w.degree() + 1);
        for (blade, value) in w.terms() {
            for &coordinate in along {
                if let Some((raised, _)) = Blade::of(coordinate).wedge(*blade) {
                    let partial = ring.derivative(value, coordinate);
                    let term = Form::monomial(ring, raised, partial);
                    sum = sum.add(ring, &term);
                }
            }
        }
        sum
    }
}

/// Inserts the field into the last slot.
#[derive(Debug)]
pub(crate) struct InteriorIntoTheLastSlot;

impl Algebra for InteriorIntoTheLastSlot {
    fn interior<R: Coefficients>(
        &self,
        ring: &mut R,
        x: &Field<R::Scalar>,
        w: &Form<R::Scalar>,
    ) -> Form<R::Scalar> {
        let first = Genuine.interior(ring, x, w);
        if w.degree() % 2 == 0 { first.negate(ring) } else { first }
    }
}

/// Gives every slot the sign of the first.
#[derive(Debug)]
pub(crate) struct InteriorWithoutSigns;

impl Algebra for InteriorWithoutSigns {
    fn interior<R: Coefficients>(
        &self,
        ring: &mut R,
        x: &Field<R::Scalar>,
        w: &Form<R::Scalar>,
    ) -> Form<R::Scalar> {
        let mut sum = Form::zero(w.degree().saturating_sub(1));
        for (blade, value) in w.terms() {
            for (coordinate, component) in x.components() {
                if let Some((rest, _)) = blade.without(coordinate) {
                    let product = ring.multiply(component, value);
                    let term = Form::monomial(ring, rest, product);
                    sum = sum.add(ring, &term);
                }
            }
        }
        sum
    }
}

/// X(w_I) dx_I alone
#[derive(Debug)]
pub(crate) struct LieWithoutItsSecondTerm;

impl Algebra for LieWithoutItsSecondTerm {
    fn lie<R: Coefficients>(
        &self,
        ring: &mut R,
        x: &Field<R::Scalar>,
        w: &Form<R::Scalar>,
        _along: &[Coordinate],
    ) -> Form<R::Scalar> {
        w.map(ring, |ring, value| derivative_along(ring, x, value))
    }
}

/// X(Y) + Y(X)
#[derive(Debug)]
pub(crate) struct BracketWithASignLost;

impl Algebra for BracketWithASignLost {
    fn bracket<R: Coefficients>(
        &self,
        ring: &mut R,
        x: &Field<R::Scalar>,
        y: &Field<R::Scalar>,
    ) -> Field<R::Scalar> {
        let (forward, backward) = (field_along(ring, x, y), field_along(ring, y, x));
        forward.add(ring, &backward)
    }
}

/// X(Y) alone
#[derive(Debug)]
pub(crate) struct BracketWithoutItsSecondTerm;

impl Algebra for BracketWithoutItsSecondTerm {
    fn bracket<R: Coefficients>(
        &self,
        ring: &mut R,
        x: &Field<R::Scalar>,
        y: &Field<R::Scalar>,
    ) -> Field<R::Scalar> {
        field_along(ring, x, y)
    }
}

/// (w∘F) dx_I
#[derive(Debug)]
pub(crate) struct PullbackWithoutJacobian;

impl Algebra for PullbackWithoutJacobian {
    fn pullback(&self, world: &mut World, map: &[Expr], w: &Form<Expr>) -> Form<Expr> {
        let values = substitution(world, map);
        w.map(&mut world.ring(), |ring, value| ring.pool.substitute(*value, &values))
    }
}

/// ψ∘φ instead of φ∘ψ
#[derive(Debug)]
pub(crate) struct CompositionInTheWrongOrder;

impl Algebra for CompositionInTheWrongOrder {
    fn compose(&self, world: &mut World, outer: &[Expr], inner: &[Expr]) -> Vec<Expr> {
        Genuine.compose(world, inner, outer)
    }
}

/// Replaces coordinates one after the other.
#[derive(Debug)]
pub(crate) struct SubstitutionOneAfterTheOther;

impl Algebra for SubstitutionOneAfterTheOther {
    fn compose(&self, world: &mut World, outer: &[Expr], inner: &[Expr]) -> Vec<Expr> {
        let mut composed = outer.to_vec();
        for (symbol, value) in world.symbols.clone().into_iter().zip(inner) {
            let single = [(symbol, *value)].into_iter().collect();
            composed = world.pool.substitute_all(&composed, &single);
        }
        composed
    }
}

/// Multiplies two forms; a rule gives the blade and the sign of each product of terms.
fn wedge_by<R: Coefficients>(
    ring: &mut R,
    a: &Form<R::Scalar>,
    b: &Form<R::Scalar>,
    rule: impl Fn(Blade, Blade) -> Option<(Blade, i8)>,
) -> Form<R::Scalar> {
    let mut sum = Form::zero(a.degree() + b.degree());
    for (left, p) in a.terms() {
        for (right, q) in b.terms() {
            let Some((blade, sign)) = rule(*left, *right) else { continue };
            let product = ring.multiply(p, q);
            let product = if sign < 0 { ring.negate(&product) } else { product };
            let term = Form::monomial(ring, blade, product);
            sum = sum.add(ring, &term);
        }
    }
    sum
}

/// Returns a basis form of the expected degree of the product, made from the union and the first
/// coordinates outside it.
fn crowded(left: Blade, right: Blade) -> Option<Blade> {
    let degree = left.degree() + right.degree();
    let mut union = left;
    for coordinate in right.coordinates().chain((0..4).map(Coordinate)) {
        if union.degree() < degree && !union.contains(coordinate) {
            union = union.wedge(Blade::of(coordinate))?.0;
        }
    }
    (union.degree() == degree).then_some(union)
}

/// Returns X(Y), component by component.
fn field_along<R: Coefficients>(
    ring: &mut R,
    x: &Field<R::Scalar>,
    y: &Field<R::Scalar>,
) -> Field<R::Scalar> {
    y.map(ring, |ring, component| derivative_along(ring, x, component))
}

/// Returns w·(w·(…)), where a rule gives the blade and the sign of each product of terms.
fn repeated<R: Coefficients>(
    ring: &mut R,
    w: &Form<R::Scalar>,
    exponent: u32,
    rule: impl Fn(Blade, Blade) -> Option<(Blade, i8)>,
) -> Form<R::Scalar> {
    (1..exponent).fold(w.clone(), |product, _| wedge_by(ring, w, &product, &rule))
}

fn is_even<S: Clone>(w: &Form<S>) -> bool {
    w.degree() > 0 && w.degree().is_multiple_of(2)
}

fn first(blade: Blade) -> Option<Coordinate> {
    blade.coordinates().next()
}

fn last(blade: Blade) -> Option<Coordinate> {
    blade.coordinates().last()
}
