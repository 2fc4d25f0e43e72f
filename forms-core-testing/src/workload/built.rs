//! Workloads of the calculus on forms that are built beforehand.

use super::Work;
use super::patch::Patch;
use forms_core::calculus::{Coordinate, Form, Pullback, Structured, exterior_derivative, power, pullback};
use forms_core::expression::{Expr, Pool, Substitution, SymbolKind};
use forms_core::normal::{Fraction, Normal, Tower, Trigonometry, normalise};
use forms_core::polynomial::Polynomial;
use std::hint::black_box;

/// d of the solid-angle form of Rⁿ.
pub fn closed(n: u8) -> Work {
    let mut patch = Patch::new(n);
    let form = patch.solid_angle();
    let (mut tower, form) = patch.normal(&form);
    Work::new(format!("d of the solid angle in R{n}, built"), "10 µs", move || {
        let mut ring = Normal::new(&mut tower, &patch.symbols);
        assert!(exterior_derivative(&mut ring, black_box(&form), &patch.coordinates).is_zero());
    })
}

/// d(dω) = 0 for a 1-form of six coordinates with `terms_each` terms in each numerator.
pub fn derivative_twice(terms_each: usize) -> Work {
    let mut patch = Patch::new(6);
    let form = patch.random_one_form(terms_each);
    let (mut tower, form) = patch.normal(&form);
    let goal = if terms_each == 4 { "0.5 ms" } else { "" };
    Work::new(format!("d(dω) = 0, n = 6, {} terms", 6 * terms_each), goal, move || {
        let mut ring = Normal::new(&mut tower, &patch.symbols);
        let once = exterior_derivative(&mut ring, black_box(&form), &patch.coordinates);
        assert!(!once.is_zero());
        assert!(exterior_derivative(&mut ring, &once, &patch.coordinates).is_zero());
    })
}

/// Returns u, v ↦ (2u, 2v, u² + v² − 1)/(1 + u² + v²).
fn inverse_stereographic(pool: &mut Pool, u: Expr, v: Expr) -> [Expr; 3] {
    let (one, two) = (pool.integer(1), pool.integer(2));
    let (u2, v2) = (pool.power(u, 2.into()), pool.power(v, 2.into()));
    let square = pool.add(u2, v2);
    let below = pool.add(one, square);
    let above = [pool.multiply(two, u), pool.multiply(two, v), pool.subtract(square, one)];
    above.map(|numerator| pool.divide(numerator, below))
}

/// The solid-angle form pulled back to −4/(1 + u² + v²)² du∧dv: the map reverses the orientation.
pub fn stereographic_pullback() -> Work {
    let mut patch = Patch::new(3);
    let beta = patch.solid_angle();
    for name in ["u", "v"] {
        patch.symbols.push(patch.pool.declare_symbol(name, SymbolKind::Coordinate));
    }
    let (u, v) = (patch.variable(3), patch.variable(4));
    let map = inverse_stereographic(&mut patch.pool, u, v);
    let values: Substitution = patch.symbols.iter().copied().zip(map).collect();
    let components: Vec<(Coordinate, Expr)> = patch.coordinates.iter().copied().zip(map).collect();
    Work::new("pullback of β by the inverse stereographic map", "1 ms", move || {
        let mut pool = patch.pool.clone();
        let mut ring = Structured { pool: &mut pool, coordinates: &patch.symbols };
        let prepared = Pullback::new(&mut ring, &components, &[Coordinate(3), Coordinate(4)]);
        let form = pullback(&mut ring, &prepared, black_box(&beta), |ring, value| {
            ring.pool.substitute(*value, &values)
        });
        let mut tower = Tower::new(Trigonometry::Circle);
        let prepared = normalise(&mut tower, &pool, &[form.terms()[0].1]).expect("rational");
        let fraction = prepared.exact(&mut tower, &pool).expect("small").remove(0);
        let simplified = tower.raise(&mut pool, &fraction);
        assert_eq!(pool.text(simplified), "-4/(u**2 + v**2 + 1)**2");
    })
}

/// ωᵐ of the generic 2-form in R²ᵐ: m! times a Pfaffian of (2m − 1)!! terms.
pub fn power_of_two_form(m: u8) -> Work {
    let mut patch = Patch::new(2 * m);
    let form = patch.generic_two_form();
    let (mut tower, form): (Tower, Form<Fraction>) = patch.normal(&form);
    let pfaffian: usize = (1..=usize::from(m)).map(|k| 2 * k - 1).product();
    let goal = match m {
        5 => "1 ms",
        6 => "8 ms",
        _ => "",
    };
    Work::new(format!("ω^{m} in R{}, {pfaffian} terms", 2 * m), goal, move || {
        let mut ring = Normal::new(&mut tower, &patch.symbols);
        let power = power(&mut ring, black_box(&form), m.into());
        assert_eq!(power.terms()[0].1.numerator().term_count(), pfaffian);
    })
}

/// Returns the number of terms of f(f+1) with f = (1+x+y+z+t)ⁿ: the number of monomials of degree
/// at most 2n.
pub fn product_terms(n: u32) -> usize {
    (1..=4).fold(1, |value, k| value * (2 * n as usize + k) / k)
}

/// f(f+1) with f = (1+x+y+z+t)ⁿ.
pub fn product(n: u32) -> Work {
    let f = (0..4).fold(Polynomial::one(), |sum, index| sum.add(&Polynomial::variable(index))).pow(n);
    let g = f.add(&Polynomial::one());
    let goal = if n == 15 { "8 ms" } else { "" };
    Work::new(format!("f(f+1), f = (1+x+y+z+t)^{n}"), goal, move || {
        assert_eq!(black_box(&f).mul(&g).term_count(), product_terms(n));
    })
}
