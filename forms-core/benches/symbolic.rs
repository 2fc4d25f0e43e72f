//! The symbolic core at work: closed forms, d², a pullback, powers of a 2-form, one large product. Times are of
//! the work named; what it works on is built beforehand.

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use forms_core::calculus::{
    Blade, Coordinate, Form, Pullback, Structured, exterior_derivative, power, pullback,
};
use forms_core::decide::decide;
use forms_core::expression::{Expr, Pool, Substitution, Symbol, SymbolKind};
use forms_core::normal::{Fraction, Normal, Tower, Trigonometry, normalise};
use forms_core::polynomial::Polynomial;
use forms_core::resolve::resolve;
use forms_core::syntax::read;
use num_rational::Ratio;
use std::hint::black_box;

/// Coordinates with their pool.
struct Patch {
    pool: Pool,
    symbols: Vec<Symbol>,
    coordinates: Vec<Coordinate>,
}

impl Patch {
    fn new(dimension: u8) -> Self {
        let mut pool = Pool::new();
        let symbols =
            (0..dimension).map(|i| pool.declare_symbol(format!("x{i}"), SymbolKind::Coordinate)).collect();
        Patch { pool, symbols, coordinates: (0..dimension).map(Coordinate).collect() }
    }

    fn variable(&mut self, place: usize) -> Expr {
        self.pool.symbol(self.symbols[place])
    }

    /// c + Σ xᵢ²
    fn norm(&mut self, constant: i64) -> Expr {
        let mut sum = self.pool.integer(constant);
        for place in 0..self.symbols.len() {
            let x = self.variable(place);
            let square = self.pool.power(x, 2.into());
            sum = self.pool.add(sum, square);
        }
        sum
    }

    /// The basis form of all coordinates but one.
    fn all_but(&self, omitted: usize) -> Blade {
        let others = self.coordinates.iter().enumerate().filter(|(place, _)| *place != omitted);
        others.fold(Blade::SCALAR, |blade, (_, &c)| blade.wedge(Blade::of(c)).expect("distinct").0)
    }

    /// The form with normal forms as coefficients, and their tower.
    fn normal(&self, form: &Form<Expr>) -> (Tower, Form<Fraction>) {
        let mut tower = Tower::new(Trigonometry::Circle);
        let values: Vec<Expr> = form.terms().iter().map(|term| term.1).collect();
        let prepared = normalise(&mut tower, &self.pool, &values).expect("rational and radical coefficients");
        let fractions = prepared.exact(&mut tower, &self.pool).expect("small coefficients");
        let terms = form.terms().iter().map(|term| term.0).zip(fractions);
        (tower, Form::from_terms(form.degree(), terms))
    }
}

/// Σ (−1)ⁱ xᵢ/rⁿ dx₁∧…(without dxᵢ)…∧dxₙ
fn solid_angle(patch: &mut Patch) -> Form<Expr> {
    let n = patch.symbols.len();
    let norm = patch.norm(0);
    let power = patch.pool.power(norm, Ratio::new(n as i64, 2));
    let mut terms = Vec::new();
    for place in 0..n {
        let x = patch.variable(place);
        let value = patch.pool.divide(x, power);
        let value = if place % 2 == 1 { patch.pool.negate(value) } else { value };
        terms.push((patch.all_but(place), value));
    }
    Form::from_terms(n as u32 - 1, terms)
}

fn solid_angle_text(n: usize) -> String {
    let names: Vec<String> = (0..n).map(|i| format!("x{i}")).collect();
    let squares: Vec<String> = names.iter().map(|name| format!("{name}**2")).collect();
    let terms: Vec<String> = (0..n)
        .map(|place| {
            let others: Vec<String> = (0..n).filter(|i| *i != place).map(|i| format!("dx{i}")).collect();
            format!("{} x{place}*{}", if place % 2 == 0 { "+" } else { "-" }, others.join("^"))
        })
        .collect();
    let sum = terms.join(" ").trim_start_matches("+ ").to_string();
    format!(
        "chart R({}) where {squares} > 0; prove closed: d(({sum})/sqrt({squares})**{n}) == 0;",
        names.join(", "),
        squares = squares.join(" + ")
    )
}

fn closed_forms(criterion: &mut Criterion) {
    for n in 3..=8 {
        let mut patch = Patch::new(n);
        let form = solid_angle(&mut patch);
        let (mut tower, form) = patch.normal(&form);
        let mut derivative = || {
            let mut ring = Normal::new(&mut tower, &patch.symbols);
            exterior_derivative(&mut ring, black_box(&form), &patch.coordinates)
        };
        assert!(derivative().is_zero());
        criterion.bench_function(&format!("(i) d of the solid angle in R{n}, built"), |bencher| {
            bencher.iter(|| assert!(derivative().is_zero()));
        });
        let text = solid_angle_text(n as usize);
        criterion.bench_function(&format!("(i) d of the solid angle in R{n}, text"), |bencher| {
            bencher.iter(|| {
                let (file, _) = read(black_box(&text));
                let (mut theory, _) = resolve(&file);
                let statement = theory.statements[0].clone();
                assert_eq!(decide(&mut theory, &statement).name(), "proved");
            });
        });
    }
}

/// Σ pᵢ/(1 + |x|²) dxᵢ with pᵢ of degree 4 with few terms, the same in every run.
fn random_one_form(patch: &mut Patch) -> Form<Expr> {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let mut random = move |bound: u64| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 33) % bound
    };
    let below = patch.norm(1);
    let n = patch.symbols.len();
    let mut terms = Vec::new();
    for place in 0..n {
        let mut numerator = patch.pool.integer(0);
        for _ in 0..4 {
            let mut term = patch.pool.integer(random(9) as i64 + 1);
            for _ in 0..4 {
                let x = patch.variable(random(n as u64) as usize);
                term = patch.pool.multiply(term, x);
            }
            numerator = patch.pool.add(numerator, term);
        }
        let value = patch.pool.divide(numerator, below);
        terms.push((Blade::of(patch.coordinates[place]), value));
    }
    Form::from_terms(1, terms)
}

fn derivative_of_derivative(criterion: &mut Criterion) {
    let mut patch = Patch::new(6);
    let form = random_one_form(&mut patch);
    let (mut tower, form) = patch.normal(&form);
    let mut twice = || {
        let mut ring = Normal::new(&mut tower, &patch.symbols);
        let once = exterior_derivative(&mut ring, black_box(&form), &patch.coordinates);
        let twice = exterior_derivative(&mut ring, &once, &patch.coordinates);
        (once, twice)
    };
    let (once, zero) = twice();
    assert!(zero.is_zero());
    let terms: usize = once.terms().iter().map(|term| term.1.numerator().term_count()).sum();
    println!("d(dω) = 0: ω has 24 terms over 1+|x|², dω has {terms}");
    criterion
        .bench_function("(ii) d(dω) = 0, n = 6", |bencher| bencher.iter(|| assert!(twice().1.is_zero())));
}

/// u, v ↦ (2u, 2v, u² + v² − 1)/(1 + u² + v²)
fn inverse_stereographic(pool: &mut Pool, u: Expr, v: Expr) -> [Expr; 3] {
    let (one, two) = (pool.integer(1), pool.integer(2));
    let (u2, v2) = (pool.power(u, 2.into()), pool.power(v, 2.into()));
    let square = pool.add(u2, v2);
    let below = pool.add(one, square);
    let above = [pool.multiply(two, u), pool.multiply(two, v), pool.subtract(square, one)];
    above.map(|numerator| pool.divide(numerator, below))
}

fn stereographic_pullback(criterion: &mut Criterion) {
    let mut patch = Patch::new(3);
    let beta = solid_angle(&mut patch);
    let source = [Coordinate(3), Coordinate(4)];
    for name in ["u", "v"] {
        patch.symbols.push(patch.pool.declare_symbol(name, SymbolKind::Coordinate));
    }
    let (u, v) = (patch.variable(3), patch.variable(4));
    let map = inverse_stereographic(&mut patch.pool, u, v);
    let values: Substitution = patch.symbols.iter().copied().zip(map).collect();
    let components: Vec<(Coordinate, Expr)> = patch.coordinates.iter().copied().zip(map).collect();
    let symbols = &patch.symbols;
    let pulled = |mut pool: Pool| {
        let mut ring = Structured { pool: &mut pool, coordinates: symbols };
        let prepared = Pullback::new(&mut ring, &components, &source);
        let form = pullback(&mut ring, &prepared, black_box(&beta), |ring, value| {
            ring.pool.substitute(*value, &values)
        });
        let mut tower = Tower::new(Trigonometry::Circle);
        let value = form.terms()[0].1;
        let prepared = normalise(&mut tower, &pool, &[value]).expect("rational");
        let fraction = prepared.exact(&mut tower, &pool).expect("small").remove(0);
        (pool, tower, fraction)
    };
    let (mut pool, tower, fraction) = pulled(patch.pool.clone());
    let simplified = tower.raise(&mut pool, &fraction);
    println!("pullback of β: {} du^dv", pool.text(simplified));
    criterion.bench_function("(iii) pullback of β by the inverse stereographic map", |bencher| {
        bencher.iter_batched(|| patch.pool.clone(), pulled, BatchSize::SmallInput);
    });
}

/// Σ aᵢⱼ dxᵢ∧dxⱼ in R^2m
fn generic_two_form(m: u8) -> (Patch, Tower, Form<Fraction>) {
    let mut patch = Patch::new(2 * m);
    let mut terms = Vec::new();
    for i in 0..2 * m {
        for j in i + 1..2 * m {
            let symbol = patch.pool.declare_symbol(format!("a{i}_{j}"), SymbolKind::Parameter);
            let blade = Blade::of(Coordinate(i)).wedge(Blade::of(Coordinate(j))).expect("distinct").0;
            terms.push((blade, patch.pool.symbol(symbol)));
        }
    }
    let (tower, form) = patch.normal(&Form::from_terms(2, terms));
    (patch, tower, form)
}

fn powers_of_two_forms(criterion: &mut Criterion) {
    for m in 3..=6 {
        let (patch, mut tower, form) = generic_two_form(m);
        criterion.bench_function(&format!("(iv) ω^{m} in R^{}", 2 * m), |bencher| {
            bencher.iter(|| power(&mut Normal::new(&mut tower, &patch.symbols), black_box(&form), m.into()));
        });
    }
}

fn large_product(criterion: &mut Criterion) {
    let sum = (0..4).fold(Polynomial::one(), |sum, index| sum.add(&Polynomial::variable(index)));
    let f = sum.pow(15);
    let g = f.add(&Polynomial::one());
    criterion
        .bench_function("(v) f(f+1), f = (1+x+y+z+t)^15", |bencher| bencher.iter(|| black_box(&f).mul(&g)));
}

fn processor(_: &mut Criterion) {
    let information = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = information.lines().find_map(|line| line.strip_prefix("model name")).unwrap_or(": unknown");
    println!("processor{}", name.trim_start_matches(['\t', ' ']));
}

criterion_group! {
    name = symbolic;
    config = Criterion::default()
        .sample_size(20)
        .measurement_time(std::time::Duration::from_secs(1))
        .warm_up_time(std::time::Duration::from_millis(300));
    targets = processor, closed_forms, derivative_of_derivative, stereographic_pullback, powers_of_two_forms, large_product
}
criterion_main!(symbolic);
