//! The laws of exterior calculus, each as the coefficients that it says vanish.

use super::algebra::Algebra;
use super::scene::{Draft, Scene, World};
use forms_core::calculus::{Coefficients, Coordinate, Field, Form};
use forms_core::expression::Expr;

/// A law over any ring of coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// d d a = 0
    DerivativeSquaresToZero,
    /// d(a∧b) = da∧b + (−1)^|a| a∧db
    Leibniz,
    /// a∧b = (−1)^(|a||b|) b∧a
    GradedCommutativity,
    /// (a∧b)∧c = a∧(b∧c)
    Associativity,
    /// L_X a = d i_X a + i_X da
    Cartan,
    /// L_X i_Y a − i_Y L_X a = i_[X,Y] a
    LieAndInterior,
    /// i_X(a∧b) = i_X a∧b + (−1)^|a| a∧i_X b
    InteriorIsAnAntiderivation,
    /// i_X i_X a = 0
    InteriorSquaresToZero,
    /// [X,[Y,Z]] + [Y,[Z,X]] + [Z,[X,Y]] = 0
    Jacobi,
    /// L_X da = d L_X a
    LieCommutesWithDerivative,
    /// [X, Y] = −[Y, X]
    BracketIsSkew,
    /// a(X₁, …) = Σ_σ sgn σ Π X_i^σ(i)
    PairingIsThePermutationSum,
}

/// The terms of left − right.
fn difference<R: Coefficients>(
    ring: &mut R,
    left: &Form<R::Scalar>,
    right: &Form<R::Scalar>,
) -> Vec<R::Scalar> {
    let negated = right.negate(ring);
    left.add(ring, &negated).terms().iter().map(|term| term.1.clone()).collect()
}

/// (−1)ⁿ w
fn signed<R: Coefficients>(ring: &mut R, n: u32, w: Form<R::Scalar>) -> Form<R::Scalar> {
    if n % 2 == 1 { w.negate(ring) } else { w }
}

impl Law {
    /// What vanishes if the law holds.
    pub fn defects<R: Coefficients>(
        self,
        ring: &mut R,
        algebra: &impl Algebra,
        scene: &Scene<R::Scalar>,
    ) -> Vec<R::Scalar> {
        let Scene { coordinates: along, a, b, c, fields: [x, y, z] } = scene;
        match self {
            Law::DerivativeSquaresToZero => {
                let da = algebra.d(ring, a, along);
                let dda = algebra.d(ring, &da, along);
                dda.terms().iter().map(|term| term.1.clone()).collect()
            }
            Law::Leibniz => {
                let product = algebra.wedge(ring, a, b);
                let left = algebra.d(ring, &product, along);
                let (da, db) = (algebra.d(ring, a, along), algebra.d(ring, b, along));
                let (first, second) = (algebra.wedge(ring, &da, b), algebra.wedge(ring, a, &db));
                let second = signed(ring, a.degree(), second);
                let right = first.add(ring, &second);
                difference(ring, &left, &right)
            }
            Law::GradedCommutativity => {
                let (left, right) = (algebra.wedge(ring, a, b), algebra.wedge(ring, b, a));
                let right = signed(ring, a.degree() * b.degree(), right);
                difference(ring, &left, &right)
            }
            Law::Associativity => {
                let (ab, bc) = (algebra.wedge(ring, a, b), algebra.wedge(ring, b, c));
                let (left, right) = (algebra.wedge(ring, &ab, c), algebra.wedge(ring, a, &bc));
                difference(ring, &left, &right)
            }
            Law::Cartan => {
                let left = algebra.lie(ring, x, a, along);
                let (ia, da) = (algebra.interior(ring, x, a), algebra.d(ring, a, along));
                let mut right = algebra.interior(ring, x, &da);
                if a.degree() > 0 {
                    let outer = algebra.d(ring, &ia, along);
                    right = outer.add(ring, &right);
                }
                difference(ring, &left, &right)
            }
            Law::LieAndInterior => {
                let (ia, la) = (algebra.interior(ring, y, b), algebra.lie(ring, x, b, along));
                let (first, second) = (algebra.lie(ring, x, &ia, along), algebra.interior(ring, y, &la));
                let second = second.negate(ring);
                let left = first.add(ring, &second);
                let xy = algebra.bracket(ring, x, y);
                let right = algebra.interior(ring, &xy, b);
                difference(ring, &left, &right)
            }
            Law::InteriorIsAnAntiderivation => {
                let product = algebra.wedge(ring, a, b);
                let left = algebra.interior(ring, x, &product);
                let ib = algebra.interior(ring, x, b);
                let second = algebra.wedge(ring, a, &ib);
                let mut right = signed(ring, a.degree(), second);
                if a.degree() > 0 {
                    let ia = algebra.interior(ring, x, a);
                    let first = algebra.wedge(ring, &ia, b);
                    right = first.add(ring, &right);
                }
                difference(ring, &left, &right)
            }
            Law::InteriorSquaresToZero => {
                let once = algebra.interior(ring, x, b);
                let twice = algebra.interior(ring, x, &once);
                let terms = twice.terms().iter().map(|term| term.1.clone());
                if b.degree() < 2 { vec![] } else { terms.collect() }
            }
            Law::Jacobi => {
                let (yz, zx, xy) =
                    (algebra.bracket(ring, y, z), algebra.bracket(ring, z, x), algebra.bracket(ring, x, y));
                let first = algebra.bracket(ring, x, &yz);
                let (second, third) = (algebra.bracket(ring, y, &zx), algebra.bracket(ring, z, &xy));
                let sum = first.add(ring, &second).add(ring, &third);
                sum.components().map(|component| component.1.clone()).collect()
            }
            Law::LieCommutesWithDerivative => {
                let (da, la) = (algebra.d(ring, a, along), algebra.lie(ring, x, a, along));
                let (left, right) = (algebra.lie(ring, x, &da, along), algebra.d(ring, &la, along));
                difference(ring, &left, &right)
            }
            Law::BracketIsSkew => {
                let (xy, yx) = (algebra.bracket(ring, x, y), algebra.bracket(ring, y, x));
                xy.add(ring, &yx).components().map(|component| component.1.clone()).collect()
            }
            Law::PairingIsThePermutationSum => pairing_defect(ring, algebra, b, [x, y]),
        }
    }
}

/// i_Y i_X w − Σ w_ij (XⁱYʲ − XʲYⁱ) for a 2-form, i_X w − Σ w_i Xⁱ for a 1-form
fn pairing_defect<R: Coefficients>(
    ring: &mut R,
    algebra: &impl Algebra,
    w: &Form<R::Scalar>,
    fields: [&Field<R::Scalar>; 2],
) -> Vec<R::Scalar> {
    let degree = w.degree() as usize;
    let mut value = w.clone();
    for field in &fields[..degree] {
        value = algebra.interior(ring, field, &value);
    }
    let mut sum = ring.zero();
    for (blade, coefficient) in w.terms() {
        let places: Vec<Coordinate> = blade.coordinates().collect();
        let orders: &[(i8, &[usize])] =
            if degree == 1 { &[(1, &[0])] } else { &[(1, &[0, 1]), (-1, &[1, 0])] };
        for (sign, order) in orders {
            let mut product = coefficient.clone();
            for (field, place) in fields.iter().zip(*order) {
                let zero = ring.zero();
                let component = field.component(places[*place]).cloned().unwrap_or(zero);
                product = ring.multiply(&product, &component);
            }
            let product = if *sign < 0 { ring.negate(&product) } else { product };
            sum = ring.add(&sum, &product);
        }
    }
    let sum = Form::scalar(ring, sum);
    difference(ring, &value, &sum)
}

/// A law about maps, which need coefficients that can be composed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapLaw {
    /// φ*(a∧b) = φ*a∧φ*b
    PullbackOfAProduct,
    /// φ*da = dφ*a
    PullbackCommutesWithDerivative,
    /// (φ∘ψ)*a = ψ*φ*a
    PullbackOfAComposition,
}

impl MapLaw {
    pub fn defects(self, world: &mut World, algebra: &impl Algebra, draft: &Draft) -> Vec<Expr> {
        let scene = draft.scene(world);
        let [phi, psi] = draft.maps(world);
        let Scene { coordinates: along, a, b, c, .. } = &scene;
        let (left, right) = match self {
            MapLaw::PullbackOfAProduct => {
                let product = algebra.wedge(&mut world.ring(), b, c);
                let left = algebra.pullback(world, &phi, &product);
                let (pb, pc) = (algebra.pullback(world, &phi, b), algebra.pullback(world, &phi, c));
                (left, algebra.wedge(&mut world.ring(), &pb, &pc))
            }
            MapLaw::PullbackCommutesWithDerivative => {
                let da = algebra.d(&mut world.ring(), a, along);
                let left = algebra.pullback(world, &phi, &da);
                let pulled = algebra.pullback(world, &phi, a);
                (left, algebra.d(&mut world.ring(), &pulled, along))
            }
            MapLaw::PullbackOfAComposition => {
                let both = algebra.compose(world, &phi, &psi);
                let left = algebra.pullback(world, &both, c);
                let inner = algebra.pullback(world, &phi, c);
                (left, algebra.pullback(world, &psi, &inner))
            }
        };
        difference(&mut world.ring(), &left, &right)
    }
}
