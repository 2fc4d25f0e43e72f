//! Construction of sums, products and powers in canonical form.

use super::super::constant::Constant;
use super::{Coefficient, Exponent, Factor, Form, Graph, Node, Scaled, Term};
use num_rational::Ratio;

impl Graph {
    pub(in crate::kernel) fn one(&mut self) -> Scaled {
        self.plain(Form::One)
    }

    /// Returns the unique node of a form.
    pub(in crate::kernel) fn plain(&mut self, form: Form) -> Scaled {
        Scaled { coefficient: Coefficient::ONE, node: self.intern(form) }
    }

    /// Builds a number: a coefficient if it is small, or else a node of its own.
    pub(in crate::kernel) fn number(&mut self, constant: &Constant) -> Scaled {
        match Coefficient::of(constant) {
            Some(coefficient) => Scaled { coefficient, ..self.one() },
            None => self.plain(Form::Number(constant.clone())),
        }
    }

    /// c · (d n)
    pub(in crate::kernel) fn scale(&mut self, coefficient: Coefficient, scaled: Scaled) -> Scaled {
        if let Some(product) = coefficient.times(scaled.coefficient) {
            return if product.is_zero() {
                Scaled { coefficient: product, ..self.one() }
            } else {
                Scaled { coefficient: product, node: scaled.node }
            };
        }
        let number = self.intern(Form::Number(coefficient.constant()));
        let product = self.product_of(vec![(number, Exponent::ONE), (scaled.node, Exponent::ONE)]);
        Scaled { coefficient: scaled.coefficient, node: product }
    }

    /// Σ cᵢ nᵢ
    pub(in crate::kernel) fn sum(&mut self, terms: &[Scaled]) -> Scaled {
        let terms = collected(terms.iter().map(|term| (term.coefficient, term.node)).collect());
        match terms[..] {
            [] => Scaled { coefficient: Coefficient::ZERO, ..self.one() },
            [(coefficient, node)] => Scaled { coefficient, node },
            _ => match divided(&terms, content(&terms)) {
                Some(primitive) => {
                    Scaled { coefficient: content(&terms), node: self.intern(Form::Sum(primitive.into())) }
                }
                None => self.plain(Form::Sum(terms.into())),
            },
        }
    }

    /// Π fᵢ^eᵢ. Powers of one base merge, except that a positive and a negative one never cancel.
    pub(in crate::kernel) fn product(&mut self, factors: &[(Scaled, Exponent)]) -> Scaled {
        let opened: Vec<(Scaled, Exponent, bool)> = factors.iter().map(|&(f, e)| (f, e, true)).collect();
        self.product_with(&opened)
    }

    /// Builds a product in which each factor says whether it is flattened if it is a product
    /// itself.
    pub(in crate::kernel) fn product_with(&mut self, factors: &[(Scaled, Exponent, bool)]) -> Scaled {
        let mut coefficient = Coefficient::ONE;
        let mut flat: Vec<Factor> = Vec::with_capacity(factors.len());
        for &(factor, exponent, is_opened) in factors {
            let power = if is_opened { self.power_of(factor, exponent) } else { self.kept(factor, exponent) };
            match coefficient.times(power.coefficient) {
                Some(product) => coefficient = product,
                None => flat.push((self.intern(Form::Number(power.coefficient.constant())), Exponent::ONE)),
            }
            match self.form(power.node) {
                Form::One => {}
                Form::Product(inner) if is_opened => flat.extend(inner.iter().copied()),
                _ if !is_opened => flat.push((power.node, exponent)),
                _ => flat.push((power.node, Exponent::ONE)),
            }
        }
        if coefficient.is_zero() {
            return Scaled { coefficient, ..self.one() };
        }
        Scaled { coefficient, node: self.product_of(flat) }
    }

    /// Returns a factor that is not flattened: its node as it is, its coefficient raised to the
    /// exponent.
    fn kept(&mut self, factor: Scaled, exponent: Exponent) -> Scaled {
        match exponent.integer().and_then(|whole| factor.coefficient.power(whole)) {
            Some(coefficient) => Scaled { coefficient, node: factor.node },
            None if factor.coefficient == Coefficient::ONE => factor,
            None => Scaled { coefficient: Coefficient::ONE, node: self.unfactored(factor) },
        }
    }

    /// Builds the product of flattened factors.
    pub(in crate::kernel) fn product_of(&mut self, factors: Vec<Factor>) -> Node {
        let factors = joined(factors);
        match factors[..] {
            [] => self.one().node,
            [(base, Exponent::ONE)] => base,
            _ => self.intern(Form::Product(factors.into())),
        }
    }

    /// (c n)^r for any rational r.
    pub(in crate::kernel) fn power(&mut self, base: Scaled, exponent: Ratio<i64>) -> Scaled {
        let is_zero = base.coefficient.is_zero();
        match Exponent::of(exponent) {
            Some(exponent) if !is_zero => self.power_of(base, exponent),
            _ => self.plain(Form::Power(base, exponent)),
        }
    }

    /// (c n)^e: integer powers are taken factor by factor, roots of the whole.
    fn power_of(&mut self, base: Scaled, exponent: Exponent) -> Scaled {
        if exponent == Exponent::ONE {
            return base;
        }
        let Some(whole) = exponent.integer() else { return self.root(base, exponent) };
        let Some(coefficient) = base.coefficient.power(whole) else {
            return self.plain(Form::Power(base, exponent.ratio()));
        };
        let factors: Option<Vec<Factor>> = match self.form(base.node) {
            Form::One => Some(vec![]),
            Form::Product(factors) => factors.iter().map(|&(n, e)| Some((n, e.times(whole)?))).collect(),
            _ => None,
        };
        let factors = factors.unwrap_or_else(|| vec![(base.node, exponent)]);
        Scaled { coefficient, node: self.product_of(factors) }
    }

    /// A fractional power. √(x²) is not x, so only roots of roots merge.
    fn root(&mut self, base: Scaled, exponent: Exponent) -> Scaled {
        let unscaled = if base.coefficient == Coefficient::ONE { base.node } else { self.unfactored(base) };
        let joined = match self.form(unscaled) {
            Form::Product(factors) => match factors[..] {
                [(inner, e)] if e.integer().is_none() => {
                    Exponent::of(e.ratio() * exponent.ratio()).map(|e| (inner, e))
                }
                _ => None,
            },
            _ => None,
        };
        let factor = joined.unwrap_or((unscaled, exponent));
        Scaled { coefficient: Coefficient::ONE, node: self.product_of(vec![factor]) }
    }

    /// c n as a node, with its coefficient multiplied in.
    fn unfactored(&mut self, scaled: Scaled) -> Node {
        let terms: Option<Vec<Term>> = match self.form(scaled.node) {
            Form::Sum(terms) => {
                terms.iter().map(|&(c, node)| Some((c.times(scaled.coefficient)?, node))).collect()
            }
            _ => None,
        };
        let terms = terms.unwrap_or_else(|| vec![(scaled.coefficient, scaled.node)]);
        self.intern(Form::Sum(terms.into()))
    }
}

/// Adds like terms and drops zeros; the result is in the order of the nodes.
fn collected(mut terms: Vec<Term>) -> Vec<Term> {
    terms.sort_by_key(|&(_, node)| node);
    let mut sum: Vec<Term> = Vec::with_capacity(terms.len());
    for (coefficient, node) in terms {
        if let Some(last) = sum.last_mut()
            && last.1 == node
            && let Some(total) = last.0.plus(coefficient)
        {
            last.0 = total;
        } else {
            sum.push((coefficient, node));
        }
    }
    sum.retain(|(coefficient, _)| !coefficient.is_zero());
    sum
}

/// Returns the content of a sum: the sign of the first term, and the least coefficient if it
/// divides the others.
fn content(terms: &[Term]) -> Coefficient {
    let least = terms.iter().map(|(c, _)| c.magnitude()).min().unwrap_or(Coefficient::ONE);
    let divides = terms.iter().all(|(c, _)| c.over(least).is_some_and(Coefficient::is_integer));
    let size = if divides && !terms.iter().any(|(c, _)| c.is_unit()) { least } else { Coefficient::ONE };
    if terms.first().is_some_and(|(c, _)| c.is_negative()) { size.negated() } else { size }
}

fn divided(terms: &[Term], by: Coefficient) -> Option<Vec<Term>> {
    terms.iter().map(|&(coefficient, node)| Some((coefficient.over(by)?, node))).collect()
}

/// Merges powers of one base: positive with positive, negative with negative, and both if the
/// result is still a divisor, so that a product that is undefined at 0 stays undefined.
pub(in crate::kernel) fn joined(mut factors: Vec<Factor>) -> Vec<Factor> {
    factors.sort();
    let mut product: Vec<Factor> = Vec::with_capacity(factors.len());
    for (base, exponent) in factors {
        if let Some(last) = product.last_mut()
            && last.0 == base
            && let Some(total) = last.1.plus(exponent)
            && (last.1.is_negative() == exponent.is_negative() || total.is_negative())
        {
            last.1 = total;
        } else {
            product.push((base, exponent));
        }
    }
    product
}
