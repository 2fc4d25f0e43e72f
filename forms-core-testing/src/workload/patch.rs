//! Coordinates, and forms on them as expressions and as normal forms.

use super::random::Random;
use forms_core::calculus::{Blade, Coordinate, Form};
use forms_core::expression::{Expr, Pool, Symbol, SymbolKind};
use forms_core::normal::{Fraction, Tower, Trigonometry, normalise};
use num_rational::Ratio;

/// Coordinates with their pool.
pub(crate) struct Patch {
    pub pool: Pool,
    pub symbols: Vec<Symbol>,
    pub coordinates: Vec<Coordinate>,
}

impl Patch {
    pub(crate) fn new(dimension: u8) -> Self {
        let mut pool = Pool::new();
        let symbols =
            (0..dimension).map(|i| pool.declare_symbol(format!("x{i}"), SymbolKind::Coordinate)).collect();
        Patch { pool, symbols, coordinates: (0..dimension).map(Coordinate).collect() }
    }

    pub(crate) fn variable(&mut self, place: usize) -> Expr {
        self.pool.symbol(self.symbols[place])
    }

    /// Returns c + Σ xᵢ².
    fn norm(&mut self, constant: i64) -> Expr {
        let mut sum = self.pool.integer(constant);
        for place in 0..self.symbols.len() {
            let x = self.variable(place);
            let square = self.pool.power(x, 2.into());
            sum = self.pool.add(sum, square);
        }
        sum
    }

    /// Returns the basis form of all coordinates but one.
    fn all_but(&self, omitted: usize) -> Blade {
        let others = self.coordinates.iter().enumerate().filter(|(place, _)| *place != omitted);
        others.fold(Blade::SCALAR, |blade, (_, &c)| blade.wedge(Blade::of(c)).expect("distinct").0)
    }

    /// Returns the form with normal forms as coefficients, and their tower of extensions.
    pub(crate) fn normal(&self, form: &Form<Expr>) -> (Tower, Form<Fraction>) {
        let mut tower = Tower::new(Trigonometry::Circle);
        let values: Vec<Expr> = form.terms().iter().map(|term| term.1).collect();
        let prepared = normalise(&mut tower, &self.pool, &values).expect("rational and radical coefficients");
        let fractions = prepared.exact(&mut tower, &self.pool).expect("small coefficients");
        let terms = form.terms().iter().map(|term| term.0).zip(fractions);
        (tower, Form::from_terms(form.degree(), terms))
    }

    /// Returns Σ (−1)ⁱ xᵢ/rⁿ dx₁∧…(without dxᵢ)…∧dxₙ.
    pub(crate) fn solid_angle(&mut self) -> Form<Expr> {
        let n = self.symbols.len();
        let norm = self.norm(0);
        let power = self.pool.power(norm, Ratio::new(n as i64, 2));
        let mut terms = Vec::new();
        for place in 0..n {
            let x = self.variable(place);
            let value = self.pool.divide(x, power);
            let value = if place % 2 == 1 { self.pool.negate(value) } else { value };
            terms.push((self.all_but(place), value));
        }
        Form::from_terms(n as u32 - 1, terms)
    }

    /// Returns Σ pᵢ/(1 + |x|²) dxᵢ with pᵢ of degree 4 with `terms_each` terms.
    pub(crate) fn random_one_form(&mut self, terms_each: usize) -> Form<Expr> {
        let mut random = Random::new(0);
        let below = self.norm(1);
        let n = self.symbols.len();
        let mut terms = Vec::new();
        for place in 0..n {
            let mut numerator = self.pool.integer(0);
            for _ in 0..terms_each {
                let mut term = self.pool.integer(random.below(9) as i64 + 1);
                for _ in 0..4 {
                    let x = self.variable(random.below(n));
                    term = self.pool.multiply(term, x);
                }
                numerator = self.pool.add(numerator, term);
            }
            let value = self.pool.divide(numerator, below);
            terms.push((Blade::of(self.coordinates[place]), value));
        }
        Form::from_terms(1, terms)
    }

    /// Returns Σ aᵢⱼ dxᵢ∧dxⱼ with a symbol for each entry.
    pub(crate) fn generic_two_form(&mut self) -> Form<Expr> {
        let n = self.coordinates.len() as u8;
        let mut terms = Vec::new();
        for i in 0..n {
            for j in i + 1..n {
                let symbol = self.pool.declare_symbol(format!("a{i}_{j}"), SymbolKind::Parameter);
                let blade = Blade::of(Coordinate(i)).wedge(Blade::of(Coordinate(j))).expect("distinct").0;
                terms.push((blade, self.pool.symbol(symbol)));
            }
        }
        Form::from_terms(2, terms)
    }
}
