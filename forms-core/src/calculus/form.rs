//! Differential forms of one degree: coefficients by basis form.

use super::blade::{Blade, Coordinate};
use super::coefficient::{Coefficients, Product};
use std::collections::BTreeMap;

/// Signed products of coefficients, grouped by basis form.
pub(super) type Products<'a, S> = BTreeMap<Blade, Vec<Product<'a, S>>>;

/// A k-form Σ w_I dx_I, its blades in ascending order. The zero form keeps its degree.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Form<S> {
    degree: u32,
    terms: Vec<(Blade, S)>,
}

impl<S: Clone> Form<S> {
    /// Returns the zero form of a degree.
    pub fn zero(degree: u32) -> Self {
        Form { degree, terms: Vec::new() }
    }

    /// Returns a scalar as a 0-form.
    pub fn scalar(ring: &impl Coefficients<Scalar = S>, value: S) -> Self {
        Self::monomial(ring, Blade::SCALAR, value)
    }

    /// Returns one coefficient times one basis form.
    pub fn monomial(ring: &impl Coefficients<Scalar = S>, blade: Blade, value: S) -> Self {
        let terms = if ring.is_zero(&value) { vec![] } else { vec![(blade, value)] };
        Form { degree: blade.degree(), terms }
    }

    /// dx
    pub fn differential(ring: &mut impl Coefficients<Scalar = S>, coordinate: Coordinate) -> Self {
        let one = ring.one();
        Form { degree: 1, terms: vec![(Blade::of(coordinate), one)] }
    }

    /// Creates a form from its coefficients; all blades must have the given degree.
    pub fn from_terms(degree: u32, terms: impl IntoIterator<Item = (Blade, S)>) -> Self {
        let ordered: BTreeMap<Blade, S> = terms.into_iter().collect();
        debug_assert!(ordered.keys().all(|blade| blade.degree() == degree));
        Form { degree, terms: ordered.into_iter().collect() }
    }

    /// Creates a form whose coefficients are sums of products; coefficients that vanish are
    /// omitted.
    pub(super) fn from_products<R: Coefficients<Scalar = S>>(
        ring: &mut R,
        degree: u32,
        products: Products<S>,
    ) -> Self {
        let (blades, groups): (Vec<Blade>, Vec<_>) = products.into_iter().unzip();
        let mut terms: Vec<(Blade, S)> = blades.into_iter().zip(ring.sums_of_products(&groups)).collect();
        terms.retain(|term| !ring.is_zero(&term.1));
        Form { degree, terms }
    }

    /// p dx_I ∧ q dx_J
    pub(super) fn product_of_terms<R: Coefficients<Scalar = S>>(
        ring: &mut R,
        (left, p): (Blade, &S),
        (right, q): (Blade, &S),
    ) -> Self {
        let Some((blade, sign)) = left.wedge(right) else {
            return Form::zero(left.degree() + right.degree());
        };
        let product = ring.multiply(p, q);
        let signed = if sign < 0 { ring.negate(&product) } else { product };
        Form::monomial(ring, blade, signed)
    }

    /// Returns the degree k of a k-form.
    pub fn degree(&self) -> u32 {
        self.degree
    }

    /// Returns the coefficients that are not known to vanish.
    pub fn terms(&self) -> &[(Blade, S)] {
        &self.terms
    }

    /// Returns the coefficient of one basis form, if any.
    pub fn coefficient(&self, blade: Blade) -> Option<&S> {
        self.terms.binary_search_by_key(&blade, |term| term.0).ok().map(|place| &self.terms[place].1)
    }

    /// Whether the form has no coefficients.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Returns the form with every coefficient replaced; coefficients that vanish are dropped.
    pub fn map<T: Clone, R: Coefficients<Scalar = T>>(
        &self,
        ring: &mut R,
        mut change: impl FnMut(&mut R, &S) -> T,
    ) -> Form<T> {
        let mut terms = Vec::with_capacity(self.terms.len());
        for (blade, value) in &self.terms {
            let changed = change(ring, value);
            if !ring.is_zero(&changed) {
                terms.push((*blade, changed));
            }
        }
        Form { degree: self.degree, terms }
    }

    /// Returns the sum of two forms of the same degree.
    pub fn add(&self, ring: &mut impl Coefficients<Scalar = S>, other: &Form<S>) -> Form<S> {
        debug_assert_eq!(self.degree, other.degree);
        let mut terms = Vec::with_capacity(self.terms.len() + other.terms.len());
        let mut rest = self.terms.iter().peekable();
        for (blade, value) in &other.terms {
            while let Some(term) = rest.next_if(|term| term.0 < *blade) {
                terms.push(term.clone());
            }
            let sum = match rest.next_if(|term| term.0 == *blade) {
                Some((_, present)) => ring.add(present, value),
                None => value.clone(),
            };
            if !ring.is_zero(&sum) {
                terms.push((*blade, sum));
            }
        }
        terms.extend(rest.cloned());
        Form { degree: self.degree, terms }
    }

    /// −w
    pub fn negate(&self, ring: &mut impl Coefficients<Scalar = S>) -> Form<S> {
        self.map(ring, |ring, value| ring.negate(value))
    }

    /// f w
    pub fn scale(&self, ring: &mut impl Coefficients<Scalar = S>, factor: &S) -> Form<S> {
        self.map(ring, |ring, value| ring.multiply(factor, value))
    }
}
