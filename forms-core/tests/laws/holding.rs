//! Every law holds for the calculus, over structured expressions and over normal forms, and both
//! representations agree.

use super::algebra::Genuine;
use super::equality::vanish;
use super::law::{Law, MapLaw};
use super::scene::{Draft, draft};
use forms_core::expression::Expr;
use forms_core::normal::{Fraction, Normal, Tower, Trigonometry, normalise};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

const CASES: u32 = 12;

fn check(property: impl Fn(Draft) -> Result<(), TestCaseError>) {
    let config = Config { cases: CASES, ..Config::with_source_file(file!()) };
    TestRunner::new(config).run(&draft(), property).unwrap_or_else(|failure| panic!("{failure}"));
}

/// Asserts the law over structured expressions.
fn holds(law: Law) {
    check(|draft| {
        let mut world = draft.world();
        let scene = draft.scene(&mut world);
        let defects = law.defects(&mut world.ring(), &Genuine, &scene);
        prop_assert!(vanish(&world, &defects));
        Ok(())
    });
    holds_of_normal_forms(law);
}

/// Asserts the law over normal forms, where zero is recognised immediately.
fn holds_of_normal_forms(law: Law) {
    check(|draft| {
        let mut world = draft.world();
        let scene = draft.scene(&mut world);
        let mut tower = Tower::new(Trigonometry::Circle);
        let prepared = normalise(&mut tower, &world.pool, &scene.scalars()).unwrap();
        let scalars = prepared.exact(&mut tower, &world.pool).unwrap();
        let mut ring = Normal::new(&mut tower, &world.symbols);
        let scene = scene.over(&mut ring, scalars);
        let defects = law.defects(&mut ring, &Genuine, &scene);
        prop_assert_eq!(ring.obstacle(), None);
        prop_assert!(defects.iter().all(Fraction::is_zero));
        Ok(())
    });
}

fn holds_of_maps(law: MapLaw) {
    check(|draft| {
        let mut world = draft.world();
        let defects = law.defects(&mut world, &Genuine, &draft);
        prop_assert!(vanish(&world, &defects));
        Ok(())
    });
}

#[test]
fn the_derivative_squares_to_zero() {
    holds(Law::DerivativeSquaresToZero);
}

#[test]
fn the_derivative_of_a_product_follows_leibniz() {
    holds(Law::Leibniz);
}

#[test]
fn the_wedge_product_is_graded_commutative() {
    holds(Law::GradedCommutativity);
}

#[test]
fn the_wedge_product_is_associative() {
    holds(Law::Associativity);
}

#[test]
fn powers_are_repeated_products() {
    holds(Law::PowerIsTheRepeatedProduct);
}

#[test]
fn the_lie_derivative_by_components_is_that_of_cartan() {
    holds(Law::Cartan);
}

#[test]
fn lie_and_interior_commute_up_to_the_bracket() {
    holds(Law::LieAndInterior);
}

#[test]
fn the_interior_product_is_an_antiderivation() {
    holds(Law::InteriorIsAnAntiderivation);
}

#[test]
fn the_interior_product_squares_to_zero() {
    holds(Law::InteriorSquaresToZero);
}

#[test]
fn brackets_satisfy_the_jacobi_identity() {
    holds(Law::Jacobi);
}

#[test]
fn brackets_are_skew() {
    holds(Law::BracketIsSkew);
}

#[test]
fn the_lie_derivative_commutes_with_d() {
    holds(Law::LieCommutesWithDerivative);
}

#[test]
fn pairing_is_the_sum_over_permutations() {
    holds(Law::PairingIsThePermutationSum);
}

#[test]
fn the_pullback_of_a_product_is_the_product_of_pullbacks() {
    holds_of_maps(MapLaw::Products);
}

#[test]
fn the_pullback_commutes_with_d() {
    holds_of_maps(MapLaw::Derivatives);
}

#[test]
fn pulling_back_by_a_composition_is_pulling_back_twice() {
    holds_of_maps(MapLaw::Compositions);
}

/// The normal form of da is d of the normal form of a; the same holds for L_X a.
#[test]
fn normal_forms_and_derivatives_change_places() {
    check(|draft| {
        let mut world = draft.world();
        let scene = draft.scene(&mut world);
        let along = scene.coordinates.clone();
        let [x, ..] = &scene.fields;
        let structured = [
            forms_core::calculus::exterior_derivative(&mut world.ring(), &scene.a, &along),
            forms_core::calculus::lie_of_form(&mut world.ring(), x, &scene.a, &along),
        ];
        let given = scene.scalars();
        let results: Vec<Expr> =
            structured.iter().flat_map(|form| form.terms().iter().map(|t| t.1)).collect();
        let all: Vec<Expr> = given.iter().chain(&results).copied().collect();
        let mut tower = Tower::new(Trigonometry::Circle);
        let prepared = normalise(&mut tower, &world.pool, &all).unwrap();
        let mut fractions = prepared.exact(&mut tower, &world.pool).unwrap();
        let later = fractions.split_off(given.len());
        let mut ring = Normal::new(&mut tower, &world.symbols);
        let scene = scene.over(&mut ring, fractions);
        let direct = [
            forms_core::calculus::exterior_derivative(&mut ring, &scene.a, &along),
            forms_core::calculus::lie_of_form(&mut ring, &scene.fields[0], &scene.a, &along),
        ];
        prop_assert_eq!(ring.obstacle(), None);
        let mut later = later.into_iter();
        for (structured, direct) in structured.iter().zip(&direct) {
            for (blade, _) in structured.terms() {
                let expected = later.next().unwrap();
                let found = direct.coefficient(*blade).cloned().unwrap_or(Fraction::zero());
                prop_assert!(tower.subtract(&found, &expected).unwrap().is_zero());
            }
            for (blade, _) in direct.terms() {
                prop_assert!(structured.coefficient(*blade).is_some());
            }
        }
        Ok(())
    });
}
