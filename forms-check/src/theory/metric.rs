//! Metrics and the operations defined by them: Hodge stars, codifferentials, Laplacians, lowered
//! and raised indices, inner products.
//!
//! Everything is computed from minors of g. By Jacobi's formula the product ⟨dx_I, dx_J⟩, the
//! determinant of the gⁱʲ with i in I and j in J, is σ_I σ_J det g[Jᶜ, Iᶜ]/det g, where σ_I is the
//! sign of dx_I ∧ dx_Iᶜ. So the star is
//!
//! ```text
//! ⋆dx_J = √|det g|/det g · σ_J Σ_K det g[Jᶜ, K] dx_K
//! ```
//! up to the orientation. With s = det g/|det g|, s⋆ has the factor 1/√|det g| instead; the factor
//! 1/det g gives the products themselves.

use crate::calculus::{Blade, Kind, Value, coordinates, order};
use crate::expression::Operation::{Add, Divide, Function, Multiply, Power};
use crate::expression::{Expr, Pool, rational};
use crate::theory::{Named, Relation, Theory};
use crate::tokens::Reader;
use crate::{Stop, malformed, uncovered};
use std::collections::{BTreeMap, HashMap};

/// Entries gᵢⱼ for i ≤ j, and the determinant. The coordinates are in ascending order; where
/// `orientation` is −1, the chart's order is an odd permutation of it.
#[derive(Clone, Debug)]
pub(crate) struct Metric {
    coordinates: Vec<usize>,
    orientation: i64,
    entries: BTreeMap<(usize, usize), Expr>,
    determinant: Expr,
}

/// Maximum number of coordinates: a star has as many terms as there are sets of coordinates.
const MOST_COORDINATES: usize = 10;

/// Variant of the star: ⋆, s⋆, or the star without √|det g|.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Star {
    Plain,
    Signed,
    Bare,
}

impl Metric {
    fn new(pool: &mut Pool, chart: &[usize], quadratic: &Value) -> Self {
        let half = pool.number(rational(1, 2));
        let mut entries = BTreeMap::new();
        for (blade, c) in &quadratic.terms {
            let places: Vec<usize> = coordinates(*blade).collect();
            match places.as_slice() {
                [i] => entries.insert((*i, *i), *c),
                [i, j, ..] => entries.insert((*i, *j), pool.make(Multiply, vec![half, *c])),
                [] => None,
            };
        }
        let (mut sorted, mut orientation, mut before) = (chart.to_vec(), 1, 0);
        sorted.sort_unstable();
        for v in chart {
            orientation *= order(before, 1 << v).unwrap_or(1);
            before |= 1 << v;
        }
        let determinant = pool.number(rational(0, 1));
        let mut metric = Metric { coordinates: sorted, orientation, entries, determinant };
        metric.determinant = metric.minor(pool, before, before, &mut HashMap::new());
        metric
    }

    fn top(&self) -> Blade {
        self.coordinates.iter().fold(0, |top, v| top | 1 << v)
    }

    fn entry(&self, i: usize, j: usize) -> Option<Expr> {
        self.entries.get(&(i.min(j), i.max(j))).copied()
    }

    /// Returns the quadratic form, which can be used in the declaration of other metrics.
    pub(crate) fn quadratic(&self, pool: &mut Pool) -> Value {
        let mut quadratic = Value { kind: Kind::Quadratic, ..Value::default() };
        for ((i, j), c) in &self.entries {
            let twice = pool.number(rational(if i == j { 1 } else { 2 }, 1));
            quadratic.terms.insert(1 << i | 1 << j, pool.make(Multiply, vec![twice, *c]));
        }
        quadratic
    }

    /// Returns the determinant of some rows and columns by expansion along its first row.
    fn minor(
        &self,
        pool: &mut Pool,
        rows: Blade,
        columns: Blade,
        known: &mut HashMap<(Blade, Blade), Expr>,
    ) -> Expr {
        let Some(i) = coordinates(rows).next() else { return pool.number(rational(1, 1)) };
        if let Some(minor) = known.get(&(rows, columns)) {
            return *minor;
        }
        let mut sum = pool.number(rational(0, 1));
        for j in coordinates(columns) {
            let Some(entry) = self.entry(i, j).filter(|_| !pool.is_full()) else { continue };
            let rest = columns & !(1 << j);
            let minor = self.minor(pool, rows & !(1 << i), rest, known);
            let product = pool.make(Multiply, vec![entry, minor]);
            let signed = if order(1 << j, rest) == Some(-1) { pool.negate(product) } else { product };
            sum = pool.make(Add, vec![sum, signed]);
        }
        known.insert((rows, columns), sum);
        sum
    }

    /// Returns √|det g|.
    fn density(&self, pool: &mut Pool) -> Expr {
        let magnitude = pool.make(Function("abs"), vec![self.determinant]);
        pool.make(Power(1, 2), vec![magnitude])
    }

    fn volume(&self, pool: &mut Pool) -> Value {
        let mut volume = Value::default();
        let density = self.density(pool);
        volume.accumulate(pool, self.top(), self.orientation, density);
        volume
    }

    /// Returns a star of a form, whose differentials must belong to the chart.
    fn star(&self, pool: &mut Pool, w: &Value, star: Star) -> Result<Value, Stop> {
        let (one, density, top) = (pool.number(rational(1, 1)), self.density(pool), self.top());
        let weight = match star {
            Star::Plain => pool.make(Divide, vec![density, self.determinant]),
            Star::Signed => pool.make(Divide, vec![one, density]),
            Star::Bare => pool.make(Divide, vec![one, self.determinant]),
        };
        let (mut result, mut known) = (Value::default(), HashMap::new());
        if self.coordinates.len() > MOST_COORDINATES {
            return uncovered("metrics with this many coordinates");
        }
        for (blade, c) in &w.terms {
            let rest = top & !blade;
            let sign = order(*blade, rest).filter(|_| blade & !top == 0 && w.kind == Kind::Form);
            let sign = sign.ok_or_else(|| malformed("a form that is not on the chart of the metric"))?;
            let factor = pool.make(Multiply, vec![weight, *c]);
            for columns in subsets(top, rest.count_ones()) {
                let minor = self.minor(pool, rest, columns, &mut known);
                let coefficient = pool.make(Multiply, vec![factor, minor]);
                if !pool.is(coefficient, 0) {
                    result.accumulate(pool, columns, sign * self.orientation, coefficient);
                }
            }
        }
        Ok(result)
    }

    /// Returns the codifferential: (−1)ᵏ times the inverse star of d of the star is s
    /// (−1)^(n(k+1)+1) ⋆d⋆.
    fn codifferential(&self, pool: &mut Pool, w: &Value) -> Result<Value, Stop> {
        let star = self.star(pool, w, Star::Plain)?.exterior(pool, &self.coordinates);
        let degree = w.terms.keys().next().map_or(0, |blade| blade.count_ones()) as usize;
        let sign = if (self.coordinates.len() * (degree + 1)).is_multiple_of(2) { -1 } else { 1 };
        let result = self.star(pool, &star, Star::Signed)?;
        Ok(Value::default().add(pool, &result, sign))
    }

    /// Returns Σ gᵢⱼ Xⁱ dxʲ.
    fn flat(&self, pool: &mut Pool, field: &Value) -> Result<Value, Stop> {
        let mut result = Value::default();
        for (v, c) in &field.terms {
            if v & !self.top() != 0 || field.kind != Kind::Field {
                return Err(malformed("a field that is not on the chart of the metric"));
            }
            for j in &self.coordinates {
                if let Some(entry) = self.entry(v.trailing_zeros() as usize, *j) {
                    let product = pool.make(Multiply, vec![entry, *c]);
                    result.accumulate(pool, 1 << j, 1, product);
                }
            }
        }
        Ok(result)
    }

    /// Returns the field X with i_X volume = ⋆w.
    fn sharp(&self, pool: &mut Pool, w: &Value) -> Result<Value, Stop> {
        let mut field = Value { kind: Kind::Field, ..Value::default() };
        for (blade, c) in self.star(pool, w, Star::Bare)?.terms {
            let v = self.top() & !blade;
            let sign = order(v, blade).filter(|_| v.count_ones() == 1);
            let sign = sign.ok_or_else(|| malformed("`sharp` takes a 1-form"))?;
            field.accumulate(pool, v, sign * self.orientation, c);
        }
        Ok(field)
    }

    /// Returns inner(a, b), where a ∧ ⋆b = inner(a, b) volume.
    fn inner(&self, pool: &mut Pool, a: &Value, b: &Value) -> Result<Value, Stop> {
        if a.kind == Kind::Field || b.kind == Kind::Field {
            return Ok(self.flat(pool, b)?.interior(pool, a));
        }
        let star = self.star(pool, b, Star::Bare)?;
        let top = a.wedge(pool, &star).terms.remove(&self.top());
        let mut product = Value::default();
        top.into_iter().for_each(|c| product.accumulate(pool, 0, self.orientation, c));
        Ok(product)
    }

    /// Returns div X, where div X volume = d i_X volume.
    fn divergence(&self, pool: &mut Pool, field: &Value) -> Result<Value, Stop> {
        self.flat(pool, field)?;
        let flux = self.volume(pool).interior(pool, field).exterior(pool, &self.coordinates);
        self.star(pool, &flux, Star::Signed)
    }
}

/// Returns all subsets of a blade with `size` coordinates.
fn subsets(top: Blade, size: u32) -> Vec<Blade> {
    let mut sets = vec![0];
    for v in coordinates(top) {
        let longer: Vec<Blade> =
            sets.iter().filter(|set: &&Blade| set.count_ones() < size).map(|set| set | 1 << v).collect();
        sets.extend(longer);
    }
    sets.retain(|set| set.count_ones() == size);
    sets
}

impl Theory {
    /// Reads `metric g on C = …;` after its name. Statements that use it require a nonzero
    /// determinant.
    pub(crate) fn metric(&mut self, reader: &mut Reader) -> Result<Named, Stop> {
        let chart = if reader.word("on") { Some(self.chart_named(&reader.name()?)?.0) } else { None };
        reader.expect("=")?;
        self.in_metric = true;
        let quadratic = self.sum(reader);
        self.in_metric = false;
        let quadratic = quadratic?;
        if quadratic.kind != Kind::Quadratic {
            return Err(malformed("a metric is a quadratic form"));
        }
        let occurring = quadratic.terms.keys().fold(0, |all, blade| all | blade);
        let is_all = |own: &&Vec<usize>| own.iter().fold(0, |all, v| all | 1 << v) == occurring;
        let fitting = || self.charts.iter().map(|chart| &chart.0).find(is_all).cloned();
        let chart = chart.or_else(fitting).ok_or_else(|| malformed("no chart fits the metric"))?;
        if chart.iter().fold(0, |all: Blade, v| all | 1 << v) & occurring != occurring {
            return Err(malformed("a metric that is not on its chart"));
        }
        let metric = Metric::new(&mut self.pool, &chart, &quadratic);
        self.require(metric.determinant, Relation::NotZero);
        Ok(Named::Metric(metric, std::mem::take(&mut self.scope)))
    }

    /// Reads `hodge[g](w)` and the other operations with a metric, after the opening bracket.
    pub(crate) fn with_metric(&mut self, name: &str, reader: &mut Reader) -> Result<Value, Stop> {
        let metric = match self.names.get(&reader.name()?).cloned() {
            Some(Named::Metric(metric, scope)) => {
                self.require_all(&scope);
                metric
            }
            Some(Named::Uncovered(what)) => return crate::uncovered(what),
            _ => return Err(malformed(format!("`{name}` needs a metric"))),
        };
        reader.expect("]")?;
        if name == "volume" {
            return Ok(metric.volume(&mut self.pool));
        }
        reader.expect("(")?;
        let outer = std::mem::take(&mut self.in_metric);
        let values = self.values(reader);
        self.in_metric = outer;
        let values = values?;
        reader.expect(")")?;
        let pool = &mut self.pool;
        match (name, values.as_slice()) {
            ("hodge", [w]) => metric.star(pool, w, Star::Plain),
            ("codiff", [w]) => metric.codifferential(pool, w),
            ("laplace", [w]) => {
                let along = &metric.coordinates;
                let first = metric.codifferential(pool, w)?.exterior(pool, along);
                let slope = w.exterior(pool, along);
                let second = metric.codifferential(pool, &slope)?;
                Ok(first.add(pool, &second, 1))
            }
            ("flat", [x]) => metric.flat(pool, x),
            ("sharp", [w]) => metric.sharp(pool, w),
            ("inner", [a, b]) => metric.inner(pool, a, b),
            ("norm", [x]) => {
                let square = metric.inner(pool, x, x)?;
                let square = self.as_scalar(&square)?;
                self.require(square, Relation::NotNegative);
                Ok(Value::of(0, self.pool.make(Power(1, 2), vec![square])))
            }
            ("grad", [f]) => {
                let slope = f.exterior(pool, &metric.coordinates);
                metric.sharp(pool, &slope)
            }
            ("curl", [x]) if metric.coordinates.len() == 3 => {
                let turning = metric.flat(pool, x)?.exterior(pool, &metric.coordinates);
                let axis = metric.star(pool, &turning, Star::Plain)?;
                metric.sharp(pool, &axis)
            }
            ("div", [x]) => metric.divergence(pool, x),
            _ => Err(malformed(format!("no metric operation `{name}` with this number of arguments"))),
        }
    }
}
