//! Which law rejects which mutant. A law that no mutant breaks, or a mutant that no law catches,
//! proves nothing.

use super::algebra::{Algebra, Genuine};
use super::equality::vanish_numerically;
use super::law::{Law, MapLaw};
use super::mutants;
use super::scene::{Draft, draft};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use std::fmt::Debug;

/// Maximum number of scenes for each mutant, and the number of scenes on which the calculus is
/// tried for comparison.
const SCENES: usize = 200;
const SCENES_OF_THE_CALCULUS: usize = 20;

/// Returns the same scenes in every run.
fn scenes() -> Vec<Draft> {
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let mut runner = TestRunner::new_with_rng(Config::default(), random);
    (0..SCENES).map(|_| draft().new_tree(&mut runner).unwrap().current()).collect()
}

/// Whether the law fails in some scene.
fn rejects(law: Law, algebra: &impl Algebra, scenes: &[Draft]) -> bool {
    scenes.iter().any(|draft| {
        let mut world = draft.world();
        let scene = draft.scene(&mut world);
        let defects = law.defects(&mut world.ring(), algebra, &scene);
        vanish_numerically(&world, &defects) == Some(false)
    })
}

fn rejects_map(law: MapLaw, algebra: &impl Algebra, scenes: &[Draft]) -> bool {
    scenes.iter().any(|draft| {
        let mut world = draft.world();
        let defects = law.defects(&mut world, algebra, draft);
        vanish_numerically(&world, &defects) == Some(false)
    })
}

/// Asserts that every given law rejects the mutant, and that none rejects the calculus.
fn assert_broken(mutant: &(impl Algebra + Debug), laws: &[Law], map_laws: &[MapLaw]) {
    let scenes = scenes();
    for &law in laws {
        assert!(rejects(law, mutant, &scenes), "{law:?} does not see {mutant:?}");
        assert!(!rejects(law, &Genuine, &scenes[..SCENES_OF_THE_CALCULUS]), "{law:?} rejects the calculus");
    }
    for &law in map_laws {
        assert!(rejects_map(law, mutant, &scenes), "{law:?} does not see {mutant:?}");
        assert!(
            !rejects_map(law, &Genuine, &scenes[..SCENES_OF_THE_CALCULUS]),
            "{law:?} rejects the calculus"
        );
    }
}

#[test]
fn a_wedge_without_signs_breaks_commutativity_leibniz_and_the_antiderivation() {
    let laws = [Law::GradedCommutativity, Law::Leibniz, Law::InteriorIsAnAntiderivation];
    assert_broken(&mutants::WedgeWithoutSigns, &laws, &[MapLaw::Products]);
}

#[test]
fn a_wedge_with_a_lost_sign_breaks_associativity_and_commutativity() {
    assert_broken(&mutants::WedgeLosingOneSign, &[Law::Associativity, Law::GradedCommutativity], &[]);
}

#[test]
fn a_wedge_that_keeps_squares_breaks_commutativity_and_the_antiderivation() {
    let laws = [Law::GradedCommutativity, Law::InteriorIsAnAntiderivation, Law::Leibniz];
    assert_broken(&mutants::WedgeKeepingSquares, &laws, &[MapLaw::Products]);
}

#[test]
fn powers_that_miss_orders_or_signs_are_no_repeated_products() {
    let laws = [Law::PowerIsTheRepeatedProduct];
    assert_broken(&mutants::PowerTakingEachSetOnce, &laws, &[]);
    assert_broken(&mutants::PowerOfNeighboursAlone, &laws, &[]);
    assert_broken(&mutants::PowerOfOddFormsAsOfEvenOnes, &laws, &[]);
}

#[test]
fn a_derivative_that_skips_a_coordinate_breaks_cartan_and_naturality() {
    let laws = [Law::Cartan, Law::LieCommutesWithDerivative];
    let map_laws = [MapLaw::Derivatives];
    assert_broken(&mutants::DerivativeSkippingACoordinate, &laws, &map_laws);
}

#[test]
fn a_derivative_without_signs_does_not_square_to_zero() {
    let laws = [Law::DerivativeSquaresToZero, Law::Leibniz, Law::Cartan];
    assert_broken(&mutants::DerivativeWithoutSigns, &laws, &[MapLaw::Derivatives]);
}

#[test]
fn an_interior_product_into_the_last_slot_is_no_antiderivation() {
    let laws = [Law::InteriorIsAnAntiderivation, Law::Cartan, Law::PairingIsThePermutationSum];
    assert_broken(&mutants::InteriorIntoTheLastSlot, &laws, &[]);
}

#[test]
fn an_interior_product_without_signs_does_not_square_to_zero() {
    let laws = [Law::InteriorSquaresToZero, Law::InteriorIsAnAntiderivation, Law::PairingIsThePermutationSum];
    assert_broken(&mutants::InteriorWithoutSigns, &laws, &[]);
}

#[test]
fn a_lie_derivative_without_its_second_term_breaks_cartan() {
    let laws = [Law::Cartan, Law::LieAndInterior, Law::LieCommutesWithDerivative];
    assert_broken(&mutants::LieWithoutItsSecondTerm, &laws, &[]);
}

#[test]
fn a_bracket_with_a_sign_lost_breaks_jacobi_and_the_commutator() {
    let laws = [Law::Jacobi, Law::LieAndInterior, Law::BracketIsSkew];
    assert_broken(&mutants::BracketWithASignLost, &laws, &[]);
    assert_broken(&mutants::BracketWithoutItsSecondTerm, &laws, &[]);
}

#[test]
fn a_pullback_without_jacobian_does_not_commute_with_d() {
    assert_broken(&mutants::PullbackWithoutJacobian, &[], &[MapLaw::Derivatives]);
}

#[test]
fn a_composition_in_the_wrong_order_is_not_pulled_back_twice() {
    assert_broken(&mutants::CompositionInTheWrongOrder, &[], &[MapLaw::Compositions]);
    assert_broken(&mutants::SubstitutionOneAfterTheOther, &[], &[MapLaw::Compositions]);
}
