//! Independent implementation of the wedge product and the derivative by permutation sums on
//! antisymmetric tensors: slow, and sharing nothing with the calculus except the coefficients.

use super::equality::vanish;
use super::scene::{World, blades, draft};
use forms_core::calculus::{Blade, Coordinate, Form, exterior_derivative, power, wedge};
use forms_core::expression::{Expr, SymbolKind};
use proptest::prelude::*;
use std::collections::HashMap;

/// Every component T_{i₁…iₖ}, the indices in any order.
type Tensor = HashMap<Vec<usize>, Expr>;

/// Returns all permutations of k elements, each with its sign.
fn permutations(k: usize) -> Vec<(i64, Vec<usize>)> {
    if k == 0 {
        return vec![(1, vec![])];
    }
    let mut all = Vec::new();
    for (sign, shorter) in permutations(k - 1) {
        for place in 0..k {
            let mut order = shorter.clone();
            order.insert(place, k - 1);
            let swaps = k - 1 - place;
            all.push((if swaps.is_multiple_of(2) { sign } else { -sign }, order));
        }
    }
    all
}

fn indices(dimension: usize, k: usize) -> Vec<Vec<usize>> {
    (0..k).fold(vec![vec![]], |all, _| {
        all.iter().flat_map(|start| (0..dimension).map(move |i| [start.clone(), vec![i]].concat())).collect()
    })
}

fn tensor(world: &mut World, form: &Form<Expr>) -> Tensor {
    let mut tensor = Tensor::new();
    for (blade, value) in form.terms() {
        let places: Vec<usize> = blade.coordinates().map(|coordinate| coordinate.0 as usize).collect();
        for (sign, order) in permutations(places.len()) {
            let component = if sign < 0 { world.pool.negate(*value) } else { *value };
            tensor.insert(order.iter().map(|&i| places[i]).collect(), component);
        }
    }
    tensor
}

/// Returns (a∧b)_{i₁…i_{p+q}} = 1/(p! q!) Σ_σ sgn σ a_{i_σ(1)…i_σ(p)} b_{i_σ(p+1)…}.
fn slow_wedge(world: &mut World, (a, p): (&Tensor, usize), (b, q): (&Tensor, usize)) -> Tensor {
    let factorial = |n: usize| (1..=n as i64).product::<i64>();
    let share = world.pool.ratio(1, factorial(p) * factorial(q));
    let mut product = Tensor::new();
    for index in indices(world.symbols.len(), p + q) {
        let mut sum = world.pool.integer(0);
        for (sign, order) in permutations(p + q) {
            let moved: Vec<usize> = order.iter().map(|&place| index[place]).collect();
            let (Some(&left), Some(&right)) = (a.get(&moved[..p]), b.get(&moved[p..])) else { continue };
            let term = world.pool.multiply(left, right);
            let term = if sign < 0 { world.pool.negate(term) } else { term };
            sum = world.pool.add(sum, term);
        }
        let value = world.pool.multiply(share, sum);
        product.insert(index, value);
    }
    product
}

/// Returns (dw)_{i₀…iₖ} = Σⱼ (−1)ʲ ∂_{iⱼ} w_{i₀…îⱼ…iₖ}.
fn slow_derivative(world: &mut World, (w, k): (&Tensor, usize)) -> Tensor {
    let mut derivative = Tensor::new();
    for index in indices(world.symbols.len(), k + 1) {
        let mut sum = world.pool.integer(0);
        for place in 0..=k {
            let rest: Vec<usize> = [&index[..place], &index[place + 1..]].concat();
            let Some(&component) = w.get(&rest) else { continue };
            let term = world.pool.derivative(component, world.symbols[index[place]]);
            let term = if place % 2 == 1 { world.pool.negate(term) } else { term };
            sum = world.pool.add(sum, term);
        }
        derivative.insert(index, sum);
    }
    derivative
}

/// Returns the nonzero differences of a form and a tensor, at every index in every order.
fn differences(world: &mut World, form: &Form<Expr>, slow: &Tensor) -> Vec<Expr> {
    let fast = tensor(world, form);
    let zero = world.pool.integer(0);
    slow.iter()
        .map(|(index, &value)| world.pool.subtract(fast.get(index).copied().unwrap_or(zero), value))
        .filter(|&difference| difference != zero)
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 16, ..ProptestConfig::with_source_file(file!()) })]

    #[test]
    fn the_wedge_product_is_the_permutation_sum(draft in draft()) {
        let mut world = draft.world();
        let scene = draft.scene(&mut world);
        let fast = wedge(&mut world.ring(), &scene.a, &scene.b);
        let (a, b) = (tensor(&mut world, &scene.a), tensor(&mut world, &scene.b));
        let slow = slow_wedge(
            &mut world,
            (&a, scene.a.degree() as usize),
            (&b, scene.b.degree() as usize),
        );
        let defects = differences(&mut world, &fast, &slow);
        prop_assert!(vanish(&world, &defects));
    }

    #[test]
    fn the_derivative_is_the_alternating_sum(draft in draft()) {
        let mut world = draft.world();
        let scene = draft.scene(&mut world);
        let fast = exterior_derivative(&mut world.ring(), &scene.b, &scene.coordinates);
        let b = tensor(&mut world, &scene.b);
        let slow = slow_derivative(&mut world, (&b, scene.b.degree() as usize));
        let defects = differences(&mut world, &fast, &slow);
        prop_assert!(vanish(&world, &defects));
    }
}

/// Returns Σ w_I dx_I over all basis forms of a degree, with a separate parameter for each
/// coefficient.
fn generic_form(world: &mut World, degree: u32) -> Form<Expr> {
    let blades = blades(&world.coordinates(), degree);
    let terms = blades.into_iter().enumerate().map(|(number, blade)| {
        let symbol = world.pool.declare_symbol(format!("w{number}"), SymbolKind::Parameter);
        (blade, world.pool.symbol(symbol))
    });
    Form::from_terms(degree, terms.collect::<Vec<_>>())
}

/// Returns (wᵐ)_{1…n} = 1/(p!)ᵐ Σ_σ sgn σ w_{σ(1)…σ(p)} ⋯ w_{σ(n−p+1)…σ(n)} for a p-form w, where
/// n = m p.
fn slow_top_power(world: &mut World, w: &Form<Expr>) -> Expr {
    let degree = w.degree() as usize;
    let dimension = world.symbols.len();
    let components = tensor(world, w);
    let mut sum = world.pool.integer(0);
    for (sign, order) in permutations(dimension) {
        let mut term = world.pool.integer(sign);
        for part in order.chunks(degree) {
            term = world.pool.multiply(term, components[part]);
        }
        sum = world.pool.add(sum, term);
    }
    let orders = (1..=degree as i64).product::<i64>().pow((dimension / degree) as u32);
    let share = world.pool.ratio(1, orders);
    world.pool.multiply(share, sum)
}

#[test]
fn top_powers_of_generic_forms_are_their_permutation_sums() {
    for (dimension, degree) in [(2, 1), (4, 2), (6, 2), (3, 1), (6, 3)] {
        let mut world = World::new(dimension);
        let w = generic_form(&mut world, degree);
        let exponent = u32::from(dimension) / degree;
        let fast = power(&mut world.ring(), &w, exponent);
        let zero = world.pool.integer(0);
        let top = fast.terms().first().map_or(zero, |term| term.1);
        let slow = slow_top_power(&mut world, &w);
        let defect = world.pool.subtract(top, slow);
        assert!(fast.terms().len() <= 1 && vanish(&world, &[defect]), "R^{dimension}, degree {degree}");
    }
}

#[test]
fn powers_of_generic_forms_are_repeated_products() {
    for (dimension, degree, largest) in [(3, 0, 5), (5, 1, 3), (6, 2, 4), (7, 2, 3), (8, 4, 3), (9, 4, 2)] {
        let mut world = World::new(dimension);
        let w = generic_form(&mut world, degree);
        let mut product = w.clone();
        for exponent in 2..=largest {
            product = wedge(&mut world.ring(), &product, &w);
            let fast = power(&mut world.ring(), &w, exponent);
            assert_eq!(fast.degree(), product.degree());
            let negated = product.negate(&mut world.ring());
            let defects = fast.add(&mut world.ring(), &negated);
            let defects: Vec<Expr> = defects.terms().iter().map(|term| term.1).collect();
            assert!(vanish(&world, &defects), "R^{dimension}, degree {degree}, exponent {exponent}");
        }
    }
}

#[test]
fn the_power_0_is_1_and_powers_beyond_the_dimension_are_0() {
    let mut world = World::new(4);
    let w = generic_form(&mut world, 2);
    let one = world.pool.integer(1);
    assert_eq!(power(&mut world.ring(), &w, 0), Form::scalar(&world.ring(), one));
    assert_eq!(power(&mut world.ring(), &w, 1), w);
    assert_eq!(power(&mut world.ring(), &w, 3), Form::zero(6));
    assert!(power(&mut world.ring(), &w, u32::MAX).is_zero());
}

#[test]
fn the_permutations_of_three_things_have_their_signs() {
    let mut all = permutations(3);
    all.sort_by(|a, b| a.1.cmp(&b.1));
    let expected = [
        (1, vec![0, 1, 2]),
        (-1, vec![0, 2, 1]),
        (-1, vec![1, 0, 2]),
        (1, vec![1, 2, 0]),
        (1, vec![2, 0, 1]),
        (-1, vec![2, 1, 0]),
    ];
    assert_eq!(all, expected);
}

#[test]
fn a_blade_is_its_antisymmetric_tensor() {
    let mut world = World::new(3);
    let one = world.pool.integer(1);
    let blade = Blade::of(Coordinate(0)).wedge(Blade::of(Coordinate(2))).unwrap().0;
    let form = Form::monomial(&world.ring(), blade, one);
    let minus = world.pool.negate(one);
    assert_eq!(tensor(&mut world, &form), HashMap::from([(vec![0, 2], one), (vec![2, 0], minus)]));
}
