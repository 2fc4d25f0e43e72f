//! Denominators that turn out to be products: an element P/Gᵏ with G = ±Fᵉ H keeps its value when
//! it is added to one over F, and is represented over F and H from then on. Wrong refinements give
//! elements with other values.

use super::equality::{vanish, vanish_numerically};
use super::scene::World;
use forms_core::expression::Expr;
use forms_core::normal::{Tower, Trigonometry, normalise};
use num_rational::Ratio;
use proptest::prelude::*;

/// G = ±Fᵉ H and Gᵏ
#[derive(Clone, Debug)]
struct Denominator {
    negative: bool,
    numbers: [i64; 4],
    /// Selects F = c₀ + c₁ x₀ + ρ and H = c₂ + x₁ − 3ρ with ρ² = 1 + 20 x₀² + x₁², so that
    /// reduction changes the sign of the leading term of F H; otherwise
    /// F = c₀ + c₁ x₀ + x₁² and H = c₂ + x₁ + c₃ x₀ x₁.
    has_root: bool,
    e: i64,
    k: i64,
}

fn denominator() -> impl Strategy<Value = Denominator> {
    let numbers = prop::array::uniform4(1i64..=4);
    (any::<bool>(), numbers, any::<bool>(), 1..=2i64, 1..=2i64)
        .prop_map(|(negative, numbers, has_root, e, k)| Denominator { negative, numbers, has_root, e, k })
}

/// Representation of P/Gᵏ over F and H.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Refinement {
    /// P (±1)ᵏ/(Fᵉᵏ Hᵏ)
    Genuine,
    /// P/(Fᵉᵏ Hᵏ)
    SignLost,
    /// P (±1)ᵏ/(Fᵏ Hᵏ)
    MultiplicityLost,
    /// P (±1)ᵏ/(Fᵉ Hᵏ)
    ExponentLost,
    /// P (±1)ᵏ/Fᵉᵏ
    CofactorLost,
}

impl Denominator {
    fn factors(&self, world: &mut World) -> [Expr; 2] {
        let (x, y) = (world.variable(0), world.variable(1));
        let pool = &mut world.pool;
        let [c0, c1, c2, c3] = self.numbers.map(|number| pool.integer(number));
        let (xx, yy) = (pool.power(x, 2.into()), pool.power(y, 2.into()));
        let product = pool.multiply(x, y);
        let (of_f, of_h) = if self.has_root {
            let (one, twenty, minus_three) = (pool.integer(1), pool.integer(20), pool.integer(-3));
            let steep = pool.multiply(twenty, xx);
            let squares = pool.add(steep, yy);
            let radicand = pool.add(one, squares);
            let root = pool.power(radicand, Ratio::new(1, 2));
            (root, pool.multiply(minus_three, root))
        } else {
            (yy, pool.multiply(c3, product))
        };
        let linear = pool.multiply(c1, x);
        let (sum, shift) = (pool.add(c0, linear), pool.add(c2, y));
        [pool.add(sum, of_f), pool.add(shift, of_h)]
    }

    /// Returns ±F⋯F H as a plain product, so that its factors are not marked.
    fn product(&self, world: &mut World) -> Expr {
        let [f, h] = self.factors(world);
        let product = (0..self.e).fold(h, |product, _| world.pool.multiply(product, f));
        if self.negative { world.pool.negate(product) } else { product }
    }

    fn element(&self, world: &mut World) -> Expr {
        let (above, product) = (world.variable(1), self.product(world));
        (0..self.k).fold(above, |quotient, _| world.pool.divide(quotient, product))
    }

    fn refined(&self, world: &mut World, refinement: Refinement) -> Expr {
        let [f, h] = self.factors(world);
        let above = world.variable(1);
        let Denominator { e, k, .. } = *self;
        let of_f = match refinement {
            Refinement::MultiplicityLost => k,
            Refinement::ExponentLost => e,
            _ => e * k,
        };
        let of_h = if refinement == Refinement::CofactorLost { 0 } else { k };
        let negative = refinement != Refinement::SignLost && self.negative && k % 2 == 1;
        let (f, h) = (world.pool.power(f, of_f.into()), world.pool.power(h, of_h.into()));
        let below = world.pool.multiply(f, h);
        let element = world.pool.divide(above, below);
        if negative { world.pool.negate(element) } else { element }
    }

    /// Returns P/Gᵏ + 1/F − (refined P/Gᵏ + 1/F).
    fn defect(&self, world: &mut World, refinement: Refinement) -> Expr {
        let sum = self.sum(world, |world| self.element(world));
        let other = self.sum(world, |world| self.refined(world, refinement));
        world.pool.subtract(sum, other)
    }

    fn sum(&self, world: &mut World, element: impl Fn(&mut World) -> Expr) -> Expr {
        let first = element(world);
        let [f, _] = self.factors(world);
        let one = world.pool.integer(1);
        let second = world.pool.divide(one, f);
        world.pool.add(first, second)
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, ..ProptestConfig::with_source_file(file!()) })]

    #[test]
    fn a_denominator_that_turns_out_to_be_a_product_is_that_product(denominator in denominator()) {
        let mut world = World::new(2);
        let defect = denominator.defect(&mut world, Refinement::Genuine);
        prop_assert!(vanish(&world, &[defect]));
    }

    /// The sum in normal form, read back, has the value of the sum as written, and a sum with it
    /// finds the factors of the denominator.
    #[test]
    fn a_sum_over_finer_factors_keeps_its_value(denominator in denominator()) {
        let mut world = World::new(2);
        let sum = denominator.sum(&mut world, |world| denominator.element(world));
        let mut tower = Tower::new(Trigonometry::Circle);
        let prepared = normalise(&mut tower, &world.pool, &[sum]).unwrap();
        let normal = prepared.exact(&mut tower, &world.pool).unwrap().remove(0);
        let read_back = tower.raise(&mut world.pool, &normal);
        let difference = world.pool.subtract(read_back, sum);
        prop_assert_eq!(vanish_numerically(&world, &[difference]), Some(true));
    }
}

#[test]
fn a_refinement_that_loses_a_sign_an_exponent_or_a_cofactor_changes_the_value() {
    let scene = Denominator { negative: true, numbers: [1, 2, 3, 1], has_root: true, e: 2, k: 1 };
    let raised = Denominator { negative: false, k: 2, ..scene.clone() };
    for (refinement, scene) in [
        (Refinement::SignLost, &scene),
        (Refinement::MultiplicityLost, &scene),
        (Refinement::ExponentLost, &raised),
        (Refinement::CofactorLost, &scene),
    ] {
        let mut world = World::new(2);
        let defect = scene.defect(&mut world, refinement);
        assert_eq!(vanish_numerically(&world, &[defect]), Some(false), "{refinement:?}");
    }
}
