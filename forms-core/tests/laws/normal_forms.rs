//! Wrong normal forms, and the identities and non-identities that reject each of them.

use super::equality::{vanish_exactly, vanish_numerically};
use super::scene::World;
use forms_core::expression::{Expr, Node, Operation, SymbolKind};
use num_rational::Ratio;
use std::collections::HashMap;

/// Error of a wrong normal form, applied to an expression before the comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Slip {
    /// The last term of the sum is lost.
    DroppedTerm,
    /// √(q²) is q.
    RootOfSquareIsBase,
    /// sin and cos of one angle are independent.
    CircleForgotten,
    /// exp(2u) is independent of exp(u).
    PowersOfExponentialForgotten,
    /// Mixed partial derivatives in different order are different.
    PartialsDoNotCommute,
}

impl Slip {
    fn rewrite(self, world: &mut World, expression: Expr) -> Expr {
        if let (Slip::DroppedTerm, Node::Add(a, _)) = (self, world.pool.node(expression)) {
            return *a;
        }
        let mut images: HashMap<Expr, Expr> = HashMap::new();
        for part in world.pool.reachable(&[expression]) {
            let image = self.image(world, part, &images);
            images.insert(part, image);
        }
        images[&expression]
    }

    fn image(self, world: &mut World, part: Expr, images: &HashMap<Expr, Expr>) -> Expr {
        let pool = &mut world.pool;
        match pool.node(part).clone() {
            Node::Add(a, b) => pool.add(images[&a], images[&b]),
            Node::Negate(a) => pool.negate(images[&a]),
            Node::Multiply(a, b) => pool.multiply(images[&a], images[&b]),
            Node::Divide(a, b) => pool.divide(images[&a], images[&b]),
            Node::Power(a, half) if self == Slip::RootOfSquareIsBase && half == Ratio::new(1, 2) => {
                match pool.node(images[&a]).clone() {
                    Node::Power(base, two) if two == Ratio::from_integer(2) => base,
                    _ => pool.power(images[&a], half),
                }
            }
            Node::Power(a, exponent) => pool.power(images[&a], exponent),
            Node::Apply(operation, arguments) => {
                let forgotten = match self {
                    Slip::CircleForgotten => matches!(operation, Operation::Sin | Operation::Cos),
                    Slip::PowersOfExponentialForgotten => operation == Operation::Exp,
                    _ => false,
                };
                if forgotten { self.fresh(world, part) } else { pool.apply(operation, &arguments) }
            }
            Node::Jet { .. } if self == Slip::PartialsDoNotCommute => self.fresh(world, part),
            _ => part,
        }
    }

    /// Returns a variable without known properties.
    fn fresh(self, world: &mut World, part: Expr) -> Expr {
        let symbol = world.pool.declare_symbol(format!("{part:?}"), SymbolKind::Local);
        world.pool.symbol(symbol)
    }
}

/// Returns sin²x + cos²x − 1 and other expressions that are zero.
fn zeros(world: &mut World) -> Vec<(&'static str, Expr)> {
    let (x, y) = (world.variable(0), world.variable(1));
    let pool = &mut world.pool;
    let one = pool.integer(1);
    let (sine, cosine) = (pool.apply(Operation::Sin, &[x]), pool.apply(Operation::Cos, &[x]));
    let (s2, c2) = (pool.power(sine, 2.into()), pool.power(cosine, 2.into()));
    let circle = pool.add(s2, c2);
    let circle = pool.subtract(circle, one);
    let twice = pool.add(x, x);
    let (e, e2) = (pool.apply(Operation::Exp, &[x]), pool.apply(Operation::Exp, &[twice]));
    let square = pool.power(e, 2.into());
    let exponential = pool.subtract(square, e2);
    let sum = pool.add(x, y);
    let expanded = pool.power(sum, 2.into());
    let (x2, y2, xy) = (pool.power(x, 2.into()), pool.power(y, 2.into()), pool.multiply(twice, y));
    let parts = [x2, xy, y2].map(|part| pool.negate(part));
    let binomial = parts.iter().fold(expanded, |total, &part| pool.add(total, part));
    vec![("circle", circle), ("exponential", exponential), ("binomial", binomial)]
}

/// Returns √(x²) − x and other expressions that are not zero.
fn nonzeros(world: &mut World) -> Vec<(&'static str, Expr)> {
    let (x, y) = (world.variable(0), world.variable(1));
    let pool = &mut world.pool;
    let square = pool.power(x, 2.into());
    let root = pool.power(square, Ratio::new(1, 2));
    let root = pool.add(root, x);
    let small = pool.multiply(x, y);
    let zero_and_more = pool.subtract(x, x);
    let zero_and_more = pool.add(zero_and_more, small);
    vec![("root", root), ("product", zero_and_more)]
}

#[test]
fn the_normal_form_knows_its_zeros_and_only_those() {
    let mut world = World::new(2);
    for (name, zero) in zeros(&mut world) {
        assert_eq!(vanish_exactly(&world, &[zero]), Some(true), "{name}");
        assert_eq!(vanish_numerically(&world, &[zero]), Some(true), "{name}");
    }
    for (name, other) in nonzeros(&mut world) {
        assert_eq!(vanish_exactly(&world, &[other]), Some(false), "{name}");
        assert_eq!(vanish_numerically(&world, &[other]), Some(false), "{name}");
    }
}

#[test]
fn a_normal_form_that_drops_a_term_or_forgets_a_relation_misses_a_zero() {
    let table = [
        (Slip::CircleForgotten, "circle"),
        (Slip::PowersOfExponentialForgotten, "exponential"),
        (Slip::DroppedTerm, "binomial"),
        (Slip::DroppedTerm, "circle"),
    ];
    for (slip, name) in table {
        let mut world = World::new(2);
        let (_, zero) = zeros(&mut world).into_iter().find(|entry| entry.0 == name).unwrap();
        let wrong = slip.rewrite(&mut world, zero);
        assert_eq!(vanish_exactly(&world, &[wrong]), Some(false), "{slip:?} is not seen by {name}");
    }
}

#[test]
fn a_normal_form_that_takes_the_root_of_a_square_for_its_base_finds_a_false_zero() {
    let mut world = World::new(2);
    let x = world.variable(0);
    let square = world.pool.power(x, 2.into());
    let root = world.pool.power(square, Ratio::new(1, 2));
    let statement = world.pool.subtract(root, x);
    let wrong = Slip::RootOfSquareIsBase.rewrite(&mut world, statement);
    assert_eq!(vanish_exactly(&world, &[wrong]), Some(true));
    assert_eq!(vanish_numerically(&world, &[statement]), Some(false));
}

#[test]
fn a_normal_form_whose_partials_do_not_commute_misses_that_d_squares_to_zero() {
    let mut world = World::new(2);
    let f = world.unknown(true);
    let [x, y] = [world.symbols[0], world.symbols[1]];
    let (fx, fy) = (world.pool.derivative(f, x), world.pool.derivative(f, y));
    let (fxy, fyx) = (world.pool.derivative(fx, y), world.pool.derivative(fy, x));
    assert_eq!(fxy, fyx, "mixed partials are one node");
    let defect = world.pool.subtract(fxy, fx);
    let wrong = Slip::PartialsDoNotCommute.rewrite(&mut world, defect);
    assert_eq!(vanish_exactly(&world, &[wrong]), Some(false));
}
