//! Laws of exterior calculus, each given by the coefficients that must vanish.

use super::algebra::Algebra;
use super::scene::{Draft, Scene, World};
use forms_core::calculus::{Coefficients, Coordinate, Field, Form};
use forms_core::expression::Expr;

/// Law over any ring of coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Law {
    /// d d a = 0
    DerivativeSquaresToZero,
    /// d(a∧b) = da∧b + (−1)^|a| a∧db
    Leibniz,
    /// a∧b = (−1)^(|a||b|) b∧a
    GradedCommutativity,
    /// (a∧b)∧c = a∧(b∧c)
    Associativity,
    /// wᵐ = w∧…∧w
    PowerIsTheRepeatedProduct,
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

/// Returns the terms of left − right.
fn difference<R: Coefficients>(
    ring: &mut R,
    left: &Form<R::Scalar>,
    right: &Form<R::Scalar>,
) -> Vec<R::Scalar> {
    let negated = right.negate(ring);
    coefficients(&left.add(ring, &negated))
}

/// Returns (−1)ⁿ w.
fn signed<R: Coefficients>(ring: &mut R, n: u32, w: Form<R::Scalar>) -> Form<R::Scalar> {
    if n % 2 == 1 { w.negate(ring) } else { w }
}

/// Returns all coefficients of a form.
fn coefficients<S: Clone>(form: &Form<S>) -> Vec<S> {
    form.terms().iter().map(|term| term.1.clone()).collect()
}

fn components<S: Clone>(field: &Field<S>) -> Vec<S> {
    field.components().map(|component| component.1.clone()).collect()
}

impl Law {
    /// Returns the coefficients that vanish if the law holds.
    pub(crate) fn defects<R: Coefficients>(
        self,
        ring: &mut R,
        algebra: &impl Algebra,
        scene: &Scene<R::Scalar>,
    ) -> Vec<R::Scalar> {
        match self {
            Law::DerivativeSquaresToZero => derivative_squared(ring, algebra, scene),
            Law::Leibniz => leibniz(ring, algebra, scene),
            Law::GradedCommutativity => commutativity(ring, algebra, scene),
            Law::Associativity => associativity(ring, algebra, scene),
            Law::PowerIsTheRepeatedProduct => powers(ring, algebra, scene),
            Law::Cartan => cartan(ring, algebra, scene),
            Law::LieAndInterior => lie_and_interior(ring, algebra, scene),
            Law::InteriorIsAnAntiderivation => antiderivation(ring, algebra, scene),
            Law::InteriorSquaresToZero => interior_squared(ring, algebra, scene),
            Law::Jacobi => jacobi(ring, algebra, scene),
            Law::LieCommutesWithDerivative => lie_and_derivative(ring, algebra, scene),
            Law::BracketIsSkew => skewness(ring, algebra, scene),
            Law::PairingIsThePermutationSum => {
                let [x, y, _] = &scene.fields;
                pairing_defect(ring, algebra, &scene.b, [x, y])
            }
        }
    }
}

fn derivative_squared<R: Coefficients>(
    ring: &mut R,
    algebra: &impl Algebra,
    scene: &Scene<R::Scalar>,
) -> Vec<R::Scalar> {
    let da = algebra.d(ring, &scene.a, &scene.coordinates);
    coefficients(&algebra.d(ring, &da, &scene.coordinates))
}

fn leibniz<R: Coefficients>(
    ring: &mut R,
    algebra: &impl Algebra,
    scene: &Scene<R::Scalar>,
) -> Vec<R::Scalar> {
    let Scene { coordinates: along, a, b, .. } = scene;
    let product = algebra.wedge(ring, a, b);
    let left = algebra.d(ring, &product, along);
    let (da, db) = (algebra.d(ring, a, along), algebra.d(ring, b, along));
    let (first, second) = (algebra.wedge(ring, &da, b), algebra.wedge(ring, a, &db));
    let second = signed(ring, a.degree(), second);
    let right = first.add(ring, &second);
    difference(ring, &left, &right)
}

fn commutativity<R: Coefficients>(
    ring: &mut R,
    algebra: &impl Algebra,
    scene: &Scene<R::Scalar>,
) -> Vec<R::Scalar> {
    let Scene { a, b, .. } = scene;
    let (left, right) = (algebra.wedge(ring, a, b), algebra.wedge(ring, b, a));
    let right = signed(ring, a.degree() * b.degree(), right);
    difference(ring, &left, &right)
}

fn associativity<R: Coefficients>(
    ring: &mut R,
    algebra: &impl Algebra,
    scene: &Scene<R::Scalar>,
) -> Vec<R::Scalar> {
    let Scene { a, b, c, .. } = scene;
    let (ab, bc) = (algebra.wedge(ring, a, b), algebra.wedge(ring, b, c));
    let (left, right) = (algebra.wedge(ring, &ab, c), algebra.wedge(ring, a, &bc));
    difference(ring, &left, &right)
}

/// Returns the defects for the forms of the scene and for dc, in which more terms coincide.
fn powers<R: Coefficients>(ring: &mut R, algebra: &impl Algebra, scene: &Scene<R::Scalar>) -> Vec<R::Scalar> {
    let dc = algebra.d(ring, &scene.c, &scene.coordinates);
    let mut defects = Vec::new();
    for w in [&scene.a, &scene.b, &dc] {
        let mut product = w.clone();
        for exponent in 2..=3 {
            product = algebra.wedge(ring, &product, w);
            let power = algebra.power(ring, w, exponent);
            defects.extend(difference(ring, &power, &product));
        }
    }
    defects
}

fn cartan<R: Coefficients>(ring: &mut R, algebra: &impl Algebra, scene: &Scene<R::Scalar>) -> Vec<R::Scalar> {
    let Scene { coordinates: along, a, fields: [x, ..], .. } = scene;
    let left = algebra.lie(ring, x, a, along);
    let da = algebra.d(ring, a, along);
    let mut right = algebra.interior(ring, x, &da);
    if a.degree() > 0 {
        let inner = algebra.interior(ring, x, a);
        right = algebra.d(ring, &inner, along).add(ring, &right);
    }
    difference(ring, &left, &right)
}

fn lie_and_interior<R: Coefficients>(
    ring: &mut R,
    algebra: &impl Algebra,
    scene: &Scene<R::Scalar>,
) -> Vec<R::Scalar> {
    let Scene { coordinates: along, b, fields: [x, y, _], .. } = scene;
    let (inner, dragged) = (algebra.interior(ring, y, b), algebra.lie(ring, x, b, along));
    let first = algebra.lie(ring, x, &inner, along);
    let second = algebra.interior(ring, y, &dragged).negate(ring);
    let left = first.add(ring, &second);
    let bracket = algebra.bracket(ring, x, y);
    let right = algebra.interior(ring, &bracket, b);
    difference(ring, &left, &right)
}

fn antiderivation<R: Coefficients>(
    ring: &mut R,
    algebra: &impl Algebra,
    scene: &Scene<R::Scalar>,
) -> Vec<R::Scalar> {
    let Scene { a, b, fields: [x, ..], .. } = scene;
    let product = algebra.wedge(ring, a, b);
    let left = algebra.interior(ring, x, &product);
    let inner = algebra.interior(ring, x, b);
    let second = algebra.wedge(ring, a, &inner);
    let mut right = signed(ring, a.degree(), second);
    if a.degree() > 0 {
        let inner = algebra.interior(ring, x, a);
        right = algebra.wedge(ring, &inner, b).add(ring, &right);
    }
    difference(ring, &left, &right)
}

fn interior_squared<R: Coefficients>(
    ring: &mut R,
    algebra: &impl Algebra,
    scene: &Scene<R::Scalar>,
) -> Vec<R::Scalar> {
    let Scene { b, fields: [x, ..], .. } = scene;
    if b.degree() < 2 {
        return vec![];
    }
    let once = algebra.interior(ring, x, b);
    coefficients(&algebra.interior(ring, x, &once))
}

fn jacobi<R: Coefficients>(ring: &mut R, algebra: &impl Algebra, scene: &Scene<R::Scalar>) -> Vec<R::Scalar> {
    let [x, y, z] = &scene.fields;
    let mut sum = Field::zero();
    for (first, second, third) in [(x, y, z), (y, z, x), (z, x, y)] {
        let inner = algebra.bracket(ring, second, third);
        let outer = algebra.bracket(ring, first, &inner);
        sum = sum.add(ring, &outer);
    }
    components(&sum)
}

fn lie_and_derivative<R: Coefficients>(
    ring: &mut R,
    algebra: &impl Algebra,
    scene: &Scene<R::Scalar>,
) -> Vec<R::Scalar> {
    let Scene { coordinates: along, a, fields: [x, ..], .. } = scene;
    let (da, la) = (algebra.d(ring, a, along), algebra.lie(ring, x, a, along));
    let (left, right) = (algebra.lie(ring, x, &da, along), algebra.d(ring, &la, along));
    difference(ring, &left, &right)
}

fn skewness<R: Coefficients>(
    ring: &mut R,
    algebra: &impl Algebra,
    scene: &Scene<R::Scalar>,
) -> Vec<R::Scalar> {
    let [x, y, _] = &scene.fields;
    let (forward, backward) = (algebra.bracket(ring, x, y), algebra.bracket(ring, y, x));
    components(&forward.add(ring, &backward))
}

/// Returns i_Y i_X w − Σ w_ij (XⁱYʲ − XʲYⁱ) for a 2-form, i_X w − Σ w_i Xⁱ for a 1-form.
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

/// Law about maps, which needs coefficients that can be composed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MapLaw {
    /// φ*(a∧b) = φ*a∧φ*b
    Products,
    /// φ*da = dφ*a
    Derivatives,
    /// (φ∘ψ)*a = ψ*φ*a
    Compositions,
}

impl MapLaw {
    pub(crate) fn defects(self, world: &mut World, algebra: &impl Algebra, draft: &Draft) -> Vec<Expr> {
        let scene = draft.scene(world);
        let [phi, psi] = draft.maps(world);
        let Scene { coordinates: along, a, b, c, .. } = &scene;
        let (left, right) = match self {
            MapLaw::Products => {
                let product = algebra.wedge(&mut world.ring(), b, c);
                let left = algebra.pullback(world, &phi, &product);
                let (pb, pc) = (algebra.pullback(world, &phi, b), algebra.pullback(world, &phi, c));
                (left, algebra.wedge(&mut world.ring(), &pb, &pc))
            }
            MapLaw::Derivatives => {
                let da = algebra.d(&mut world.ring(), a, along);
                let left = algebra.pullback(world, &phi, &da);
                let pulled = algebra.pullback(world, &phi, a);
                (left, algebra.d(&mut world.ring(), &pulled, along))
            }
            MapLaw::Compositions => {
                let both = algebra.compose(world, &phi, &psi);
                let left = algebra.pullback(world, &both, c);
                let inner = algebra.pullback(world, &phi, c);
                (left, algebra.pullback(world, &psi, &inner))
            }
        };
        difference(&mut world.ring(), &left, &right)
    }
}
