//! Operations that occur in the laws, as a trait, so that each law can be applied to the calculus
//! and to its mutants.

use super::scene::World;
use forms_core::calculus::{self, Coefficients, Coordinate, Field, Form, Pullback};
use forms_core::expression::{Expr, Substitution};

/// Exterior calculus on one patch.
pub(crate) trait Algebra {
    fn wedge<R: Coefficients>(
        &self,
        ring: &mut R,
        a: &Form<R::Scalar>,
        b: &Form<R::Scalar>,
    ) -> Form<R::Scalar> {
        calculus::wedge(ring, a, b)
    }

    fn power<R: Coefficients>(&self, ring: &mut R, w: &Form<R::Scalar>, exponent: u32) -> Form<R::Scalar> {
        calculus::power(ring, w, exponent)
    }

    fn d<R: Coefficients>(&self, ring: &mut R, w: &Form<R::Scalar>, along: &[Coordinate]) -> Form<R::Scalar> {
        calculus::exterior_derivative(ring, w, along)
    }

    fn interior<R: Coefficients>(
        &self,
        ring: &mut R,
        x: &Field<R::Scalar>,
        w: &Form<R::Scalar>,
    ) -> Form<R::Scalar> {
        calculus::interior(ring, x, w)
    }

    fn lie<R: Coefficients>(
        &self,
        ring: &mut R,
        x: &Field<R::Scalar>,
        w: &Form<R::Scalar>,
        along: &[Coordinate],
    ) -> Form<R::Scalar> {
        calculus::lie_of_form(ring, x, w, along)
    }

    fn bracket<R: Coefficients>(
        &self,
        ring: &mut R,
        x: &Field<R::Scalar>,
        y: &Field<R::Scalar>,
    ) -> Field<R::Scalar> {
        calculus::bracket(ring, x, y)
    }

    /// Returns φ*w for a map of the patch to itself.
    fn pullback(&self, world: &mut World, map: &[Expr], w: &Form<Expr>) -> Form<Expr> {
        let values = substitution(world, map);
        let coordinates = world.coordinates();
        let components: Vec<(Coordinate, Expr)> =
            coordinates.iter().copied().zip(map.iter().copied()).collect();
        let mut ring = world.ring();
        let prepared = Pullback::new(&mut ring, &components, &coordinates);
        calculus::pullback(&mut ring, &prepared, w, |ring, value| ring.pool.substitute(*value, &values))
    }

    /// Returns φ∘ψ.
    fn compose(&self, world: &mut World, outer: &[Expr], inner: &[Expr]) -> Vec<Expr> {
        let values = substitution(world, inner);
        world.pool.substitute_all(outer, &values)
    }
}

pub(crate) fn substitution(world: &World, map: &[Expr]) -> Substitution {
    world.symbols.iter().copied().zip(map.iter().copied()).collect()
}

/// The calculus itself.
pub(crate) struct Genuine;

impl Algebra for Genuine {}
