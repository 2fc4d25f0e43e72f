//! Divergences in normal form: a Laplacian over one denominator equals the sum of second
//! derivatives as the calculus writes it, and the ring's derivative of its derivative; and a frame
//! changes no derivative.

use super::equality::{vanish_exactly, vanish_numerically};
use super::scene::World;
use forms_core::calculus::{Coefficients, Coordinate};
use forms_core::expression::{Expr, Operation, Pool, Substitution, Symbol, SymbolKind};
use forms_core::normal::{Drift, Fraction, Normal, Tower, Trigonometry, normalise};
use num_rational::Ratio;
use proptest::prelude::*;

/// (c₀ + c₁ x₀ ρ + c₂ x₁ x₂) ρ^k / (7 + x₂ ρ + c₃ σ)^l with ρ² = 1 + x₀² + x₁², σ² = 2 + (x₁ − x₂)²
#[derive(Clone, Debug)]
struct Shape {
    numbers: [i64; 4],
    root: i64,
    quotient: i64,
}

fn shape() -> impl Strategy<Value = Shape> {
    (prop::array::uniform4(1i64..=3), -1i64..=1, 0i64..=1).prop_map(|(numbers, root, quotient)| Shape {
        numbers,
        root,
        quotient,
    })
}

impl Shape {
    fn at(&self, pool: &mut Pool, symbols: &[Symbol]) -> Expr {
        let [x, y, z] = [0, 1, 2].map(|place| pool.symbol(symbols[place]));
        let half = Ratio::new(1, 2);
        let (x2, y2) = (pool.power(x, 2.into()), pool.power(y, 2.into()));
        let (squares, apart) = (pool.add(x2, y2), pool.subtract(y, z));
        let apart = pool.power(apart, 2.into());
        let [one, two, seven] = [1, 2, 7].map(|number| pool.integer(number));
        let (rho, sigma) = (pool.add(one, squares), pool.add(two, apart));
        let (rho, sigma) = (pool.power(rho, half), pool.power(sigma, half));
        let numbers = self.numbers.map(|number| pool.integer(number));
        let (xr, yz, zr) = (pool.multiply(x, rho), pool.multiply(y, z), pool.multiply(z, rho));
        let (a, b) = (pool.multiply(numbers[1], xr), pool.multiply(numbers[2], yz));
        let above = [a, b].iter().fold(numbers[0], |sum, &part| pool.add(sum, part));
        let last = pool.multiply(numbers[3], sigma);
        let below = [zr, last].iter().fold(seven, |sum, &part| pool.add(sum, part));
        let powers = [pool.power(rho, self.root.into()), pool.power(below, (-self.quotient).into())];
        powers.iter().fold(above, |product, &power| pool.multiply(product, power))
    }
}

fn sum(pool: &mut Pool, parts: &[Expr]) -> Expr {
    let zero = pool.integer(0);
    parts.iter().fold(zero, |sum, &part| pool.add(sum, part))
}

fn laplacian(pool: &mut Pool, f: Expr, symbols: &[Symbol]) -> Expr {
    let mut parts = Vec::new();
    for &x in symbols {
        let first = pool.derivative(f, x);
        parts.push(pool.derivative(first, x));
    }
    sum(pool, &parts)
}

/// Returns Σ ∂fᵢ/∂xᵢ.
fn divergence(pool: &mut Pool, field: &[Expr], symbols: &[Symbol]) -> Expr {
    let parts: Vec<Expr> = field.iter().zip(symbols).map(|(&f, &x)| pool.derivative(f, x)).collect();
    sum(pool, &parts)
}

/// Returns Δ(fg) − fΔg − c ∇f·∇g − gΔf.
fn product_rule(world: &mut World, shapes: &[Shape; 2], c: i64) -> Expr {
    let symbols = world.symbols.clone();
    let pool = &mut world.pool;
    let [f, g] = [0, 1].map(|place| shapes[place].at(pool, &symbols));
    let fg = pool.multiply(f, g);
    let [whole, of_f, of_g] = [fg, f, g].map(|part| laplacian(pool, part, &symbols));
    let (left, right) = (pool.multiply(f, of_g), pool.multiply(g, of_f));
    let mut parts = vec![whole, pool.negate(left), pool.negate(right)];
    let c = pool.integer(-c);
    for &x in &symbols {
        let (df, dg) = (pool.derivative(f, x), pool.derivative(g, x));
        let product = pool.multiply(df, dg);
        parts.push(pool.multiply(c, product));
    }
    sum(pool, &parts)
}

/// Whether an expression over the world's symbols has the normal form of the Laplacian that the
/// ring computes by two derivatives of the normal form of f.
fn is_laplacian_of_the_ring(world: &World, f: Expr, laplacian: Expr) -> bool {
    let mut tower = Tower::new(Trigonometry::Circle);
    let prepared = normalise(&mut tower, &world.pool, &[f, laplacian]).unwrap();
    let fractions = prepared.exact(&mut tower, &world.pool).unwrap();
    let mut ring = Normal::new(&mut tower, &world.symbols);
    let mut found = Fraction::zero();
    for place in 0..world.symbols.len() {
        let along = Coordinate(place as u8);
        let first = ring.derivative(&fractions[0], along);
        let second = ring.derivative(&first, along);
        found = ring.add(&found, &second);
    }
    assert_eq!(ring.obstacle(), None);
    tower.subtract(&found, &fractions[1]).unwrap().is_zero()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::with_source_file(file!()) })]

    #[test]
    fn the_laplacian_of_a_product_has_twice_the_product_of_gradients(shapes in [shape(), shape()]) {
        let mut world = World::new(3);
        let rule = product_rule(&mut world, &shapes, 2);
        prop_assert!(vanish_exactly(&world, &[rule]) != Some(false));
        prop_assert!(vanish_numerically(&world, &[rule]) != Some(false));
    }

    #[test]
    fn a_laplacian_over_one_denominator_is_the_sum_of_second_derivatives(shape in shape()) {
        let mut world = World::new(3);
        let symbols = world.symbols.clone();
        let f = shape.at(&mut world.pool, &symbols);
        let direct = laplacian(&mut world.pool, f, &symbols);
        prop_assert!(is_laplacian_of_the_ring(&world, f, direct));
    }

    /// An expression that is differentiated in other variables and then renamed is not recognised
    /// as a known derivative.
    #[test]
    fn a_laplacian_summed_quotient_by_quotient_is_that_of_the_ring(shape in shape()) {
        let mut world = World::new(3);
        let symbols = world.symbols.clone();
        let others: Vec<Symbol> =
            (0..3).map(|i| world.pool.declare_symbol(format!("s{i}"), SymbolKind::Local)).collect();
        let elsewhere = shape.at(&mut world.pool, &others);
        let written = laplacian(&mut world.pool, elsewhere, &others);
        let mut names = Substitution::default();
        for (&other, &symbol) in others.iter().zip(&symbols) {
            names.insert(other, world.pool.symbol(symbol));
        }
        let [f, written] = [elsewhere, written].map(|part| world.pool.substitute(part, &names));
        prop_assert!(is_laplacian_of_the_ring(&world, f, written));
    }

    /// The same holds for the divergence of a field whose coefficients contain no derivatives.
    #[test]
    fn a_divergence_of_a_field_is_that_of_the_ring_however_it_is_written(shapes in prop::array::uniform3(shape())) {
        let mut world = World::new(3);
        let symbols = world.symbols.clone();
        let others: Vec<Symbol> =
            (0..3).map(|i| world.pool.declare_symbol(format!("s{i}"), SymbolKind::Local)).collect();
        let pool = &mut world.pool;
        let field = [0, 1, 2].map(|place| shapes[place].at(pool, &symbols));
        let direct = divergence(pool, &field, &symbols);
        let elsewhere = [0, 1, 2].map(|place| shapes[place].at(pool, &others));
        let written = divergence(pool, &elsewhere, &others);
        let names: Substitution =
            others.iter().zip(&symbols).map(|(&other, &symbol)| (other, pool.symbol(symbol))).collect();
        let written = pool.substitute(written, &names);
        let mut tower = Tower::new(Trigonometry::Circle);
        let all = [field[0], field[1], field[2], direct, written];
        let prepared = normalise(&mut tower, &world.pool, &all).unwrap();
        let fractions = prepared.exact(&mut tower, &world.pool).unwrap();
        let mut ring = Normal::new(&mut tower, &world.symbols);
        let mut found = Fraction::zero();
        for (place, component) in fractions[..3].iter().enumerate() {
            let derivative = ring.derivative(component, Coordinate(place as u8));
            found = ring.add(&found, &derivative);
        }
        assert_eq!(ring.obstacle(), None);
        for way in &fractions[3..] {
            prop_assert!(tower.subtract(&found, way).unwrap().is_zero());
        }
    }

    #[test]
    fn derivatives_in_a_frame_are_those_of_the_same_functions(shape in shape(), speeds in [-2i64..=2, 1i64..=2]) {
        let mut world = World::new(3);
        let [x, y, z] = [world.symbols[0], world.symbols[1], world.symbols[2]];
        let f = shape.at(&mut world.pool, &[x, y, z]);
        let drifts = vec![
            Drift { moved: x, with: z, speed: speeds[0] },
            Drift { moved: y, with: z, speed: speeds[1] },
        ];
        let mut tower = Tower::new(Trigonometry::Circle).in_frame(drifts);
        let prepared = normalise(&mut tower, &world.pool, &[f]).unwrap();
        let fraction = prepared.exact(&mut tower, &world.pool).unwrap().remove(0);
        for (place, &symbol) in world.symbols.clone().iter().enumerate() {
            let mut ring = Normal::new(&mut tower, &world.symbols);
            let derivative = ring.derivative(&fraction, Coordinate(place as u8));
            let raised = tower.raise(&mut world.pool, &derivative);
            let written = world.pool.derivative(f, symbol);
            let difference = world.pool.subtract(raised, written);
            prop_assert!(vanish_exactly(&world, &[difference]) == Some(true));
        }
    }
}

#[test]
fn a_product_rule_with_a_lost_gradient_fails() {
    let shapes = [
        Shape { numbers: [1, 2, 1, 3], root: 1, quotient: 1 },
        Shape { numbers: [2, 1, 3, 1], root: -1, quotient: 1 },
    ];
    for wrong in [0, 1, 3] {
        let mut world = World::new(3);
        let rule = product_rule(&mut world, &shapes, wrong);
        assert_ne!(vanish_exactly(&world, &[rule]), Some(true));
        assert_eq!(vanish_numerically(&world, &[rule]), Some(false));
    }
}

#[test]
fn a_derivative_that_forgets_that_a_variable_moves_is_another() {
    let mut world = World::new(3);
    let symbols = world.symbols.clone();
    let shape = Shape { numbers: [1, 2, 1, 3], root: 1, quotient: 1 };
    let f = shape.at(&mut world.pool, &symbols);
    let [x, z] = [0, 2].map(|place| world.pool.symbol(symbols[place]));
    let (forth, back) = (world.pool.add(x, z), world.pool.subtract(x, z));
    let forth = [(symbols[0], forth)].into_iter().collect();
    let back = [(symbols[0], back)].into_iter().collect();
    let in_frame = world.pool.substitute(f, &forth);
    let forgetful = world.pool.derivative(in_frame, symbols[2]);
    let forgetful = world.pool.substitute(forgetful, &back);
    let written = world.pool.derivative(f, symbols[2]);
    let difference = world.pool.subtract(forgetful, written);
    assert_eq!(vanish_exactly(&world, &[difference]), Some(false));
}

/// sin x₀/(2 + cos x₀), in the generators of the circle or in the half-angle tangent, and
/// (2 + ρ)^(k/2) x₁ with ρ² = 1 + x₀², a root whose radicand contains a root.
#[test]
fn derivatives_of_half_angles_and_of_roots_over_roots_are_those_of_the_calculus() {
    let mut world = World::new(2);
    let symbols = world.symbols.clone();
    let pool = &mut world.pool;
    let [x, y] = [0, 1].map(|place| pool.symbol(symbols[place]));
    let [one, two] = [1, 2].map(|number| pool.integer(number));
    let (sine, cosine) = (pool.apply(Operation::Sin, &[x]), pool.apply(Operation::Cos, &[x]));
    let below = pool.add(two, cosine);
    let wave = pool.divide(sine, below);
    let square = pool.power(x, 2.into());
    let radicand = pool.add(one, square);
    let rho = pool.power(radicand, Ratio::new(1, 2));
    let sum = pool.add(two, rho);
    let mut functions = vec![wave];
    for half in [-3, -1, 1] {
        let power = pool.power(sum, Ratio::new(half, 2));
        functions.push(pool.multiply(power, y));
    }
    for f in functions {
        for trigonometry in [Trigonometry::Circle, Trigonometry::HalfAngle] {
            let mut tower = Tower::new(trigonometry);
            let prepared = normalise(&mut tower, &world.pool, &[f]).unwrap();
            let fraction = prepared.exact(&mut tower, &world.pool).unwrap().remove(0);
            let derivative = tower.derivative(&fraction, symbols[0]).unwrap();
            let raised = tower.raise(&mut world.pool, &derivative);
            let written = world.pool.derivative(f, symbols[0]);
            let difference = world.pool.subtract(raised, written);
            assert_eq!(vanish_numerically(&world, &[difference]), Some(true), "{}", world.pool.text(written));
        }
    }
}
