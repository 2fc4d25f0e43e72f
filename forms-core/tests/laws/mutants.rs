//! Wrong algebras: each differs from the calculus in one place, as a slip in its code would.

use super::algebra::{Algebra, Genuine, substitution};
use super::scene::World;
use forms_core::calculus::{Blade, Coefficients, Coordinate, Field, Form, derivative_along};
use forms_core::expression::Expr;

/// What is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mutant {
    /// dx∧dy = dy∧dx
    WedgeWithoutSigns,
    /// The sign of moving a form past one of higher degree is lost.
    WedgeLosingOneSign,
    /// dx∧dx is not zero; it stands at another basis form of its degree.
    WedgeKeepingSquares,
    /// γ_m(w) for m! γ_m(w)
    PowerTakingEachSetOnce,
    /// Sets whose blades interleave are left out.
    PowerOfNeighboursAlone,
    /// The terms of a form of odd degree are taken to commute.
    PowerOfOddFormsAsOfEvenOnes,
    /// The last coordinate is not differentiated by.
    DerivativeSkippingACoordinate,
    /// ∂ᵢw_I goes to dx_I∪i without a sign.
    DerivativeWithoutSigns,
    /// The field goes into the last slot.
    InteriorIntoTheLastSlot,
    /// Every slot gets the sign of the first.
    InteriorWithoutSigns,
    /// X(w_I) dx_I alone.
    LieWithoutItsSecondTerm,
    /// X(Y) + Y(X)
    BracketWithASignLost,
    /// X(Y) alone
    BracketWithoutItsSecondTerm,
    /// (w∘F) dx_I
    PullbackWithoutJacobian,
    /// ψ∘φ for φ∘ψ
    CompositionInTheWrongOrder,
    /// Coordinates are replaced one after the other.
    SubstitutionOneAfterTheOther,
}

/// Puts a product at the blade that a rule gives, with the sign it gives.
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

/// A basis form of the degree that the product ought to have, made from the union and the first coordinates
/// outside it.
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

impl Algebra for Mutant {
    fn wedge<R: Coefficients>(
        &self,
        ring: &mut R,
        a: &Form<R::Scalar>,
        b: &Form<R::Scalar>,
    ) -> Form<R::Scalar> {
        match self {
            Mutant::WedgeWithoutSigns => {
                wedge_by(ring, a, b, |left, right| left.wedge(right).map(|(blade, _)| (blade, 1)))
            }
            Mutant::WedgeLosingOneSign => wedge_by(ring, a, b, |left, right| {
                let (blade, sign) = left.wedge(right)?;
                Some((blade, if left.degree() < right.degree() { 1 } else { sign }))
            }),
            Mutant::WedgeKeepingSquares => wedge_by(ring, a, b, |left, right| {
                left.wedge(right).or_else(|| crowded(left, right).map(|blade| (blade, 1)))
            }),
            _ => Genuine.wedge(ring, a, b),
        }
    }

    fn power<R: Coefficients>(&self, ring: &mut R, w: &Form<R::Scalar>, exponent: u32) -> Form<R::Scalar> {
        let first = |blade: Blade| blade.coordinates().next();
        let last = |blade: Blade| blade.coordinates().last();
        let even = w.degree() > 0 && w.degree() % 2 == 0;
        let repeated = |ring: &mut R, rule: &dyn Fn(Blade, Blade) -> Option<(Blade, i8)>| {
            (1..exponent).fold(w.clone(), |product, _| wedge_by(ring, w, &product, rule))
        };
        match self {
            Mutant::PowerTakingEachSetOnce if even => repeated(ring, &|left, right| {
                if first(left) < first(right) { left.wedge(right) } else { None }
            }),
            Mutant::PowerOfNeighboursAlone if even => repeated(ring, &|left, right| {
                let apart = last(left) < first(right) || last(right) < first(left);
                if apart { left.wedge(right) } else { None }
            }),
            Mutant::PowerOfOddFormsAsOfEvenOnes if w.degree() % 2 == 1 => {
                repeated(ring, &|left, right| left.wedge(right).map(|(blade, _)| (blade, 1)))
            }
            _ => Genuine.power(ring, w, exponent),
        }
    }

    fn d<R: Coefficients>(&self, ring: &mut R, w: &Form<R::Scalar>, along: &[Coordinate]) -> Form<R::Scalar> {
        match self {
            Mutant::DerivativeSkippingACoordinate => Genuine.d(ring, w, &along[..along.len() - 1]),
            Mutant::DerivativeWithoutSigns => {
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
            _ => Genuine.d(ring, w, along),
        }
    }

    fn interior<R: Coefficients>(
        &self,
        ring: &mut R,
        x: &Field<R::Scalar>,
        w: &Form<R::Scalar>,
    ) -> Form<R::Scalar> {
        match self {
            Mutant::InteriorIntoTheLastSlot if w.degree() % 2 == 0 => {
                Genuine.interior(ring, x, w).negate(ring)
            }
            Mutant::InteriorWithoutSigns => {
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
            _ => Genuine.interior(ring, x, w),
        }
    }

    fn lie<R: Coefficients>(
        &self,
        ring: &mut R,
        x: &Field<R::Scalar>,
        w: &Form<R::Scalar>,
        along: &[Coordinate],
    ) -> Form<R::Scalar> {
        match self {
            Mutant::LieWithoutItsSecondTerm => w.map(ring, |ring, value| derivative_along(ring, x, value)),
            _ => Genuine.lie(ring, x, w, along),
        }
    }

    fn bracket<R: Coefficients>(
        &self,
        ring: &mut R,
        x: &Field<R::Scalar>,
        y: &Field<R::Scalar>,
    ) -> Field<R::Scalar> {
        let along = |ring: &mut R, x: &Field<R::Scalar>, y: &Field<R::Scalar>| {
            y.map(ring, |ring, component| derivative_along(ring, x, component))
        };
        match self {
            Mutant::BracketWithASignLost => {
                let (forward, backward) = (along(ring, x, y), along(ring, y, x));
                forward.add(ring, &backward)
            }
            Mutant::BracketWithoutItsSecondTerm => along(ring, x, y),
            _ => Genuine.bracket(ring, x, y),
        }
    }

    fn pullback(&self, world: &mut World, map: &[Expr], w: &Form<Expr>) -> Form<Expr> {
        match self {
            Mutant::PullbackWithoutJacobian => {
                let values = substitution(world, map);
                w.map(&mut world.ring(), |ring, value| ring.pool.substitute(*value, &values))
            }
            _ => Genuine.pullback(world, map, w),
        }
    }

    fn compose(&self, world: &mut World, outer: &[Expr], inner: &[Expr]) -> Vec<Expr> {
        match self {
            Mutant::CompositionInTheWrongOrder => Genuine.compose(world, inner, outer),
            Mutant::SubstitutionOneAfterTheOther => {
                let mut composed = outer.to_vec();
                for (symbol, value) in world.symbols.clone().into_iter().zip(inner) {
                    let single = [(symbol, *value)].into_iter().collect();
                    composed = world.pool.substitute_all(&composed, &single);
                }
                composed
            }
            _ => Genuine.compose(world, outer, inner),
        }
    }
}
