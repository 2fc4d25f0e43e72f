//! Exterior calculus on coefficients of scalars, forms, fields and quadratic forms: d, ∧, interior
//! products, Lie derivatives, pullbacks.

use crate::expression::{Expr, Operation, Pool, rational};
use std::collections::{BTreeMap, HashMap};

/// Set of differentials in ascending order; bit v stands for dv. A scalar has none.
pub(crate) type Blade = u128;

/// Type of a value, which determines its coefficients' keys: blades for a scalar or form,
/// coordinates for a field. A quadratic form in the differentials has one coordinate as the key of
/// a square, and two as the key of twice an off-diagonal entry.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Kind {
    #[default]
    Form,
    Field,
    Quadratic,
}

impl Kind {
    /// Returns the kind of a sum, or of a product in which one factor is a scalar.
    fn with(self, other: Kind) -> Kind {
        if self == Kind::Form { other } else { self }
    }
}

/// Scalar, form, field or quadratic form; without terms it is the zero of any type.
#[derive(Clone, Debug, Default)]
pub(crate) struct Value {
    pub(crate) kind: Kind,
    pub(crate) terms: BTreeMap<Blade, Expr>,
}

/// Returns the coordinates of a blade in order.
pub(crate) fn coordinates(blade: Blade) -> impl Iterator<Item = usize> {
    (0..128).filter(move |v| blade >> v & 1 == 1)
}

/// Returns the sign of the permutation that sorts a followed by b; `None` if they share a
/// differential.
pub(crate) fn order(a: Blade, b: Blade) -> Option<i64> {
    let swaps: u32 = coordinates(b).map(|v| (a >> v).count_ones()).sum();
    (a & b == 0).then_some(if swaps.is_multiple_of(2) { 1 } else { -1 })
}

impl Value {
    pub(crate) fn of(blade: Blade, coefficient: Expr) -> Self {
        Value { kind: Kind::Form, terms: BTreeMap::from([(blade, coefficient)]) }
    }

    /// Returns dv.
    pub(crate) fn differential(pool: &mut Pool, v: usize) -> Self {
        Value::of(1 << v, pool.number(rational(1, 1)))
    }

    /// Returns the coefficient of a scalar; `None` for any other value.
    pub(crate) fn as_scalar(&self, pool: &mut Pool) -> Option<Expr> {
        let is_scalar = self.kind == Kind::Form && self.terms.keys().all(|blade| *blade == 0);
        is_scalar.then(|| self.terms.get(&0).copied().unwrap_or_else(|| pool.number(rational(0, 1))))
    }

    /// Whether both are scalars, forms of one degree, fields or quadratic forms, or one of them has
    /// no term.
    pub(crate) fn is_alike(&self, other: &Value) -> bool {
        let degree = |value: &Value| value.terms.keys().next().map(|blade| blade.count_ones());
        match (degree(self), degree(other)) {
            (Some(a), Some(b)) => self.kind == other.kind && (self.kind != Kind::Form || a == b),
            _ => true,
        }
    }

    pub(crate) fn accumulate(&mut self, pool: &mut Pool, blade: Blade, sign: i64, c: Expr) {
        let term = if sign < 0 { pool.negate(c) } else { c };
        let sum = self.terms.get(&blade).map_or(term, |known| pool.make(Operation::Add, vec![*known, term]));
        self.terms.insert(blade, sum);
    }

    /// Returns a + b or a − b.
    pub(crate) fn add(&self, pool: &mut Pool, other: &Value, sign: i64) -> Self {
        let mut sum = Value { kind: self.kind.with(other.kind), terms: self.terms.clone() };
        other.terms.iter().for_each(|(blade, c)| sum.accumulate(pool, *blade, sign, *c));
        sum
    }

    /// Returns a ∧ b, which is the product if one factor is a scalar.
    pub(crate) fn wedge(&self, pool: &mut Pool, other: &Value) -> Self {
        let mut product = Value { kind: self.kind.with(other.kind), ..Value::default() };
        for (a, x) in &self.terms {
            for (b, y) in &other.terms {
                if let Some(sign) = order(*a, *b).filter(|_| !pool.is_full()) {
                    let c = pool.make(Operation::Multiply, vec![*x, *y]);
                    product.accumulate(pool, a | b, sign, c);
                }
            }
        }
        product
    }

    /// Returns the symmetric product a b of two 1-forms.
    pub(crate) fn symmetric(&self, pool: &mut Pool, other: &Value) -> Self {
        let mut product = Value { kind: Kind::Quadratic, ..Value::default() };
        for (a, x) in &self.terms {
            for (b, y) in &other.terms {
                let c = pool.make(Operation::Multiply, vec![*x, *y]);
                product.accumulate(pool, a | b, 1, c);
            }
        }
        product
    }

    /// Returns the exterior derivative Σ ∂c/∂v dv ∧ blade along some coordinates.
    pub(crate) fn exterior(&self, pool: &mut Pool, along: &[usize]) -> Self {
        let mut result = Value::default();
        for (blade, c) in &self.terms {
            for v in along {
                let slope = pool.derivative(*c, *v);
                if let Some(sign) = order(1 << v, *blade).filter(|_| !pool.is(slope, 0)) {
                    result.accumulate(pool, 1 << v | blade, sign, slope);
                }
            }
        }
        result
    }

    /// Returns the interior product, with the field in the first slot; zero for a scalar.
    pub(crate) fn interior(&self, pool: &mut Pool, field: &Value) -> Self {
        let mut result = Value::default();
        for (blade, c) in &self.terms {
            for (v, component) in field.terms.iter().filter(|entry| blade & entry.0 != 0) {
                let sign = order(*v, blade & !v).unwrap_or(1);
                let product = pool.make(Operation::Multiply, vec![*component, *c]);
                result.accumulate(pool, blade & !v, sign, product);
            }
        }
        result
    }

    /// Returns the Lie derivative, L_X w = i_X dw + d i_X w (Cartan); for a field, the bracket [X,
    /// Y]ᵛ = X(Yᵛ) − Y(Xᵛ).
    pub(crate) fn lie(&self, pool: &mut Pool, field: &Value, along: &[usize]) -> Self {
        if self.kind != Kind::Field {
            let second = self.interior(pool, field).exterior(pool, along);
            return self.exterior(pool, along).interior(pool, field).add(pool, &second, 1);
        }
        let mut result = Value { kind: Kind::Field, ..Value::default() };
        for (x, y, sign) in [(field, self, 1), (self, field, -1)] {
            for (v, component) in &y.terms {
                let slope = Value::of(0, *component).exterior(pool, along).interior(pool, x);
                slope.terms.values().for_each(|c| result.accumulate(pool, *v, sign, *c));
            }
        }
        result
    }

    /// Returns the pullback: coefficients are composed with the map, and differentials of target
    /// coordinates become differentials of components.
    pub(crate) fn pullback(&self, pool: &mut Pool, images: &HashMap<usize, Expr>, source: &[usize]) -> Self {
        let mut result = Value::default();
        for (blade, c) in &self.terms {
            let mut product = Value::of(0, pool.substitute(*c, images));
            for v in coordinates(*blade) {
                let kept = Value::differential(pool, v);
                let image = images.get(&v).map(|component| Value::of(0, *component).exterior(pool, source));
                product = product.wedge(pool, &image.unwrap_or(kept));
            }
            result = result.add(pool, &product, 1);
        }
        result
    }
}
