//! Integrals by antiderivatives that the certificate offers.
//!
//! ```text
//! f, u = a..b ─▶ offered F ─ F′ = f between the bounds? ─ F continuous on [a, b]? ─▶ F(b) − F(a)
//! ```
//! That F′ = f is shown by a proof like that of a statement. Continuity is seen from the parts of F: what is divided by,
//! raised or taken the logarithm of has a sign all over the closed range, whichever of a and b is larger. Only
//! conditions that hold in a whole neighbourhood are used, so that the value may be differentiated; a condition on a
//! variable that is integrated over, here or further out, says nothing of it. What the value of an integral was found
//! under has to hold all over the ranges of another one around it.

use crate::calculus::{Value, order};
use crate::certificate::Line;
use crate::expression::Operation::{Add, Divide, Function, Jet, Multiply, Number, Pi, Power, Variable};
use crate::expression::{Expr, rational};
use crate::field::Field;
use crate::interval::Interval;
use crate::proof::Proof;
use crate::sign::Seen;
use crate::theory::{Condition, Relation, Scope, Statement, Theory};
use crate::tokens::Reader;
use crate::witness::Point;
use crate::{Stop, malformed, uncovered};
use std::collections::{BTreeMap, HashMap};

/// How many boxes are looked at for one sign.
const MOST_BOXES: usize = 64;

/// For the place of each variable of a range, the antiderivatives in the order in which they are wanted, each with
/// the lines that show its derivative.
pub(crate) type Offered = HashMap<usize, Vec<(String, Vec<Line>)>>;

/// One range of an integral, and where its variable stands in the source.
#[derive(Clone)]
struct Range {
    variable: usize,
    from: Expr,
    to: Expr,
    place: usize,
}

/// What is known of the points at which an antiderivative is looked at.
struct Region<'a> {
    ranges: &'a [Range],
    conditions: Vec<Condition>,
}

impl Theory {
    /// Reads with a scope of its own, which is given back.
    pub(crate) fn apart<T>(
        &mut self,
        body: impl FnOnce(&mut Self) -> Result<T, Stop>,
    ) -> Result<(T, Scope), Stop> {
        let outer = std::mem::take(&mut self.scope);
        let value = body(self);
        let inner = std::mem::replace(&mut self.scope, outer);
        Ok((value?, inner))
    }

    /// `integral(w, u = a..b, v = c..e)` after its bracket: the innermost range is the last.
    pub(crate) fn integral(&mut self, reader: &mut Reader) -> Result<Value, Stop> {
        let ((value, ranges), inner) = self.within_ranges(reader, |theory, reader| theory.sum(reader))?;
        self.keep_outside(&inner, &ranges)?;
        let integral = self.iterated(&value, &ranges, &inner.conditions)?;
        Ok(Value::of(0, integral))
    }

    /// `boundary_integral(F, w, u = a..b, v = c..e)`: Σᵢ (−1)^(i−1) (∫ over uᵢ = bᵢ minus ∫ over uᵢ = aᵢ).
    pub(crate) fn boundary_integral(&mut self, reader: &mut Reader) -> Result<Value, Stop> {
        let (((value, source), ranges), inner) =
            self.within_ranges(reader, |theory, reader| theory.pulled_back(reader))?;
        self.keep_outside(&inner, &ranges)?;
        let mut sum = Value::default();
        for (place, fixed) in ranges.iter().enumerate() {
            for (bound, is_upper) in [(fixed.to, true), (fixed.from, false)] {
                let images = HashMap::from([(fixed.variable, bound)]);
                let mut rest = ranges.clone();
                rest.remove(place);
                for range in &mut rest {
                    range.from = self.pool.substitute(range.from, &images);
                    range.to = self.pool.substitute(range.to, &images);
                }
                let face = value.pullback(&mut self.pool, &images, &source);
                let on_face = |condition: &Condition, theory: &mut Theory| {
                    (theory.pool.substitute(condition.0, &images), condition.1)
                };
                let defined: Vec<Condition> = inner.conditions.iter().map(|c| on_face(c, self)).collect();
                let integral = self.iterated(&face, &rest, &defined)?;
                let sign = if is_upper == (place % 2 == 0) { 1 } else { -1 };
                sum = sum.add(&mut self.pool, &Value::of(0, integral), sign);
            }
        }
        Ok(sum)
    }

    /// Reads what is integrated, with the variables of the ranges behind it bound, and the ranges.
    fn within_ranges<T>(
        &mut self,
        reader: &mut Reader,
        body: impl FnOnce(&mut Self, &mut Reader) -> Result<T, Stop>,
    ) -> Result<((T, Vec<Range>), Scope), Stop> {
        let count = self.bound.len();
        for name in reader.ranged_names() {
            self.bound.push(self.variable(&name)?);
        }
        let read = self.apart(|theory| {
            let value = body(theory, reader)?;
            Ok((value, theory.ranges(reader)?))
        });
        self.bound.truncate(count);
        read
    }

    fn ranges(&mut self, reader: &mut Reader) -> Result<Vec<Range>, Stop> {
        let mut ranges: Vec<Range> = Vec::new();
        while reader.take(",") {
            let place = reader.offset();
            let variable = self.variable(&reader.name()?)?;
            reader.expect("=")?;
            let from = self.scalar(reader)?;
            reader.expect("..")?;
            ranges.push(Range { variable, from, to: self.scalar(reader)?, place });
        }
        for (number, range) in ranges.iter().enumerate() {
            let mut mentioned = self.pool.variables(range.from);
            mentioned.extend(self.pool.variables(range.to));
            if ranges[number..].iter().any(|inner| mentioned.contains(&inner.variable)) {
                return Err(malformed("a bound mentions a variable that has no value there"));
            }
        }
        Ok(ranges)
    }

    /// What was needed inside, as far as it does not speak of the variables of the ranges. Where it does, and an
    /// integral was found under it, it has to hold all over them.
    fn keep_outside(&mut self, inner: &Scope, ranges: &[Range]) -> Result<(), Stop> {
        let is_bound = |v: &usize| ranges.iter().any(|range| range.variable == *v);
        for (expr, relation) in &inner.conditions {
            if !self.pool.variables(*expr).iter().any(is_bound) {
                self.require(*expr, *relation);
            }
        }
        self.scope.used.extend(inner.used.iter().filter(|v| !is_bound(v)));
        self.scope.integrates = true;
        if inner.integrates {
            let region = Region { ranges, conditions: self.conditions_of(ranges)? };
            for (expr, relation) in &inner.conditions {
                let speaks_of_them = self.pool.variables(*expr).iter().any(is_bound);
                if speaks_of_them && !self.holds(*expr, *relation, &region)? {
                    return uncovered(
                        "an integral of an integral that is not seen to hold all over the range",
                    );
                }
            }
        }
        Ok(())
    }

    /// Integrates a scalar, or the coefficient of a form in the order of the ranges.
    fn iterated(&mut self, w: &Value, ranges: &[Range], defined: &[Condition]) -> Result<Expr, Stop> {
        let (mut blade, mut sign) = (0, 1);
        for range in ranges {
            sign *=
                order(blade, 1 << range.variable).ok_or_else(|| malformed("two ranges of one variable"))?;
            blade |= 1 << range.variable;
        }
        let zero = self.pool.number(rational(0, 1));
        let mut integral = match w.as_scalar(&mut self.pool) {
            Some(scalar) => scalar,
            None => {
                let c = w.terms.get(&blade).copied().unwrap_or(zero);
                if sign < 0 { self.pool.negate(c) } else { c }
            }
        };
        self.require_domains(integral, ranges);
        for count in (1..=ranges.len()).rev() {
            integral = self.over(integral, &ranges[..count], defined)?;
        }
        Ok(integral)
    }

    /// The domains of charts bind what uses their coordinates, as far as they speak of free ones only.
    fn require_domains(&mut self, integrand: Expr, ranges: &[Range]) {
        let mut free = self.pool.variables(integrand);
        ranges.iter().for_each(|range| {
            free.extend(self.pool.variables(range.from));
            free.extend(self.pool.variables(range.to));
        });
        free.retain(|v| !self.bound.contains(v) && !ranges.iter().any(|range| range.variable == *v));
        for (expr, relation) in self.charts.iter().flat_map(|chart| chart.1.clone()).collect::<Vec<_>>() {
            let mentioned = self.pool.variables(expr);
            let is_free = |v: &usize| !self.variables[*v].1 || free.contains(v);
            if mentioned.iter().any(|v| free.contains(v)) && mentioned.iter().all(is_free) {
                self.require(expr, relation);
            }
        }
    }

    /// The integral over the last range.
    fn over(&mut self, f: Expr, ranges: &[Range], defined: &[Condition]) -> Result<Expr, Stop> {
        let Some(Range { variable, from, to, place }) = ranges.last().cloned() else { return Ok(f) };
        let turn = self.integrated.entry(place).or_default();
        *turn += 1;
        let offer = self.offered.get(&place).and_then(|all| all.get(*turn - 1)).cloned();
        let Some((text, lines)) = offer.filter(|offer| !self.is_sealed && !offer.0.is_empty()) else {
            return uncovered("`integral`");
        };
        let region = Region { ranges, conditions: self.conditions_of(ranges)? };
        let mut conditions = region.conditions.clone();
        for (expr, relation) in defined {
            // where the integrand is defined, as far as it is seen
            if *relation != Relation::NotZero && self.holds(*expr, Relation::NotNegative, &region)? {
                conditions.push((*expr, Relation::NotNegative));
            }
        }
        let (antiderivative, _) = self.apart(|theory| {
            let antiderivative = theory.expression(&text)?;
            let slope = theory.pool.derivative(antiderivative, variable);
            let components = BTreeMap::from([(format!("of the integral over {text}"), [slope, f])]);
            let statement = Statement { components, conditions };
            let mut proof = Proof { theory, statement: &statement, lines: lines.iter(), is_defined: false };
            proof.check(&[], 0)?;
            if proof.lines.next().is_some() {
                return Err(malformed("lines after a proof"));
            }
            Ok(antiderivative)
        })?;
        self.check_continuous(antiderivative, &region)?;
        let upper = self.pool.substitute(antiderivative, &HashMap::from([(variable, to)]));
        let lower = self.pool.substitute(antiderivative, &HashMap::from([(variable, from)]));
        let negated = self.pool.negate(lower);
        Ok(self.pool.make(Add, vec![upper, negated]))
    }

    /// The strict conditions outside, and that each variable lies between its bounds.
    fn conditions_of(&mut self, ranges: &[Range]) -> Result<Vec<Condition>, Stop> {
        let is_bound = |v: &usize| self.bound.contains(v) || ranges.iter().any(|range| range.variable == *v);
        let outside =
            |c: &&Condition| c.1 != Relation::NotNegative && !self.pool.variables(c.0).iter().any(is_bound);
        let mut known: Vec<Condition> =
            self.scope.conditions.iter().chain(&self.given).filter(outside).copied().collect();
        for range in ranges {
            let u = self.pool.make(Variable(range.variable), vec![]);
            let mut bounds = [range.from, range.to];
            let mut is_ordered = false;
            for _ in 0..2 {
                let width = self.difference(bounds[1], bounds[0]);
                is_ordered = is_ordered || self.seen(width, &known)? >= Seen::NotNegative;
                if !is_ordered {
                    bounds.reverse();
                }
            }
            let (above, below) = (self.difference(u, bounds[0]), self.difference(bounds[1], u));
            if !is_ordered {
                known.push((self.pool.make(Multiply, vec![above, below]), Relation::NotNegative));
                continue;
            }
            // u itself has the sign of the lower bound if that is not negative, of the upper one if not positive
            let minus = [self.pool.negate(bounds[1]), self.pool.negate(u)];
            for (bound, side) in [(bounds[0], u), (minus[0], minus[1])] {
                match self.seen(bound, &known)? {
                    Seen::Nothing => {}
                    Seen::NotNegative => known.push((side, Relation::NotNegative)),
                    Seen::Positive => known.push((side, Relation::Positive)),
                }
            }
            known.extend([(above, Relation::NotNegative), (below, Relation::NotNegative)]);
        }
        Ok(known)
    }

    fn difference(&mut self, a: Expr, b: Expr) -> Expr {
        let negated = self.pool.negate(b);
        self.pool.make(Add, vec![a, negated])
    }

    fn seen(&mut self, q: Expr, conditions: &[Condition]) -> Result<Seen, Stop> {
        Field::default().seen(&mut self.pool, q, conditions)
    }

    /// That every part of an antiderivative is continuous over the closed ranges.
    fn check_continuous(&mut self, antiderivative: Expr, region: &Region) -> Result<(), Stop> {
        for part in self.pool.parts(&[antiderivative]) {
            let (operation, a) = (self.pool.node(part).0.clone(), self.pool.node(part).1.to_vec());
            let needed = match operation {
                Divide => Some((a[1], Relation::NotZero)),
                Power(p, 1) => (p < 0).then(|| (a[0], Relation::NotZero)),
                Power(p, _) => Some((a[0], if p < 0 { Relation::Positive } else { Relation::NotNegative })),
                Function("tan") => Some((self.pool.make(Function("cos"), a), Relation::NotZero)),
                Function("log") => match self.pool.node(a[0]) {
                    (Function("abs"), inner) => Some((inner[0], Relation::NotZero)),
                    _ => Some((a[0], Relation::Positive)),
                },
                Function("asin") => {
                    let (one, square) =
                        (self.pool.number(rational(1, 1)), self.pool.make(Power(2, 1), vec![a[0]]));
                    Some((self.difference(one, square), Relation::NotNegative))
                }
                // smooth where it is declared, which may not be everywhere
                Jet(f, _) if !self.functions[f].1.is_empty() => {
                    return uncovered("the integral of a function with a condition");
                }
                Function(_) | Jet(..) | Number(_) | Pi | Variable(_) | Add | Multiply => None,
            };
            if let Some((q, relation)) = needed
                && !self.holds(q, relation, region)?
            {
                return uncovered("an antiderivative that is not seen to be continuous");
            }
        }
        Ok(())
    }

    /// Whether something has a sign all over the closed ranges.
    fn holds(&mut self, q: Expr, relation: Relation, region: &Region) -> Result<bool, Stop> {
        if relation == Relation::NotZero {
            let negated = self.pool.negate(q);
            return Ok(self.holds(q, Relation::Positive, region)?
                || self.holds(negated, Relation::Positive, region)?);
        }
        let least = if relation == Relation::Positive { Seen::Positive } else { Seen::NotNegative };
        Ok(self.seen(q, &region.conditions)? >= least
            || self.is_between(q, relation, region)?
            || self.is_enclosed(q, relation, region))
    }

    /// Of q of degree 2 in u: Σ cₖ Bₖ with c₀ = q(a), c₁ = q(a) + q′(a)(b − a)/2, c₂ = q(b), and what keeps above no
    /// negative cₖ and is not zero at either end has no zero between.
    fn is_between(&mut self, q: Expr, relation: Relation, region: &Region) -> Result<bool, Stop> {
        let Some((range, outer)) = region.ranges.split_last() else { return Ok(false) };
        let u = range.variable;
        if !self.pool.variables(q).contains(&u) || !self.is_polynomial(q, u) {
            return Ok(false);
        }
        let first = self.pool.derivative(q, u);
        let second = self.pool.derivative(first, u);
        let third = self.pool.derivative(second, u);
        if !Field::default().element(&self.pool, third)?.numerator.is_zero() {
            return Ok(false);
        }
        let images = [range.from, range.to].map(|bound| HashMap::from([(u, bound)]));
        let [lower, upper] = images.each_ref().map(|images| self.pool.substitute(q, images));
        let slope = self.pool.substitute(first, &images[0]);
        let width = self.difference(range.to, range.from);
        let half = self.pool.number(rational(1, 2));
        let rise = self.pool.make(Multiply, vec![slope, width]);
        let rise = self.pool.make(Multiply, vec![half, rise]);
        let middle = self.pool.make(Add, vec![lower, rise]);
        let is_outer = |c: &&Condition| !self.pool.variables(c.0).contains(&u);
        let conditions = region.conditions.iter().filter(is_outer).copied().collect();
        let outer = Region { ranges: outer, conditions };
        Ok(self.holds(lower, relation, &outer)?
            && self.holds(upper, relation, &outer)?
            && self.holds(middle, Relation::NotNegative, &outer)?)
    }

    /// Whether an expression is polynomial in a variable, as it is written.
    fn is_polynomial(&self, q: Expr, u: usize) -> bool {
        self.pool.parts(&[q]).into_iter().all(|part| {
            let (operation, a) = self.pool.node(part);
            let varies = |expr: Expr| self.pool.variables(expr).contains(&u);
            match operation {
                Add | Multiply | Variable(_) => true,
                Divide => !varies(a[1]),
                Power(p, 1) if *p >= 0 => true,
                _ => !varies(part),
            }
        })
    }

    /// The same by enclosures on boxes, where all variables run between numbers.
    fn is_enclosed(&self, q: Expr, relation: Relation, region: &Region) -> bool {
        let mut start: HashMap<usize, Interval> = HashMap::new();
        for v in self.pool.variables(q) {
            let Some(range) = region.ranges.iter().find(|range| range.variable == v) else { return false };
            let ends = [range.from, range.to].map(|bound| Point::default().value(&self.pool, bound));
            let [Ok(a), Ok(b)] = ends else { return false };
            start.insert(v, Interval { low: a.low.min(b.low), high: a.high.max(b.high) });
        }
        let (mut open, mut boxes) = (vec![start], 0);
        while let Some(next) = open.pop() {
            boxes += 1;
            let value = Point::within(next.clone()).value(&self.pool, q);
            let zero = rational(0, 1);
            let holds = |value: Interval| {
                value.low > zero || (relation == Relation::NotNegative && value.low == zero)
            };
            if value.is_ok_and(holds) {
                continue;
            }
            let widest = next.iter().max_by_key(|(v, side)| (&side.high - &side.low, **v));
            let Some((v, side)) = widest.filter(|_| boxes < MOST_BOXES) else { return false };
            let middle = (&side.low + &side.high) / rational(2, 1);
            for half in [
                Interval { low: side.low.clone(), high: middle.clone() },
                Interval { low: middle.clone(), high: side.high.clone() },
            ] {
                let mut part = next.clone();
                part.insert(*v, half);
                open.push(part);
            }
        }
        true
    }
}

/// The entry `integral PLACE F` and the lines below it.
pub(crate) fn offer(offered: &mut Offered, rest: &str, lines: &[Line]) -> Result<(), Stop> {
    let (place, text) = rest.split_once(' ').unwrap_or((rest, ""));
    let place = place.parse().map_err(|_| malformed(format!("the place `{place}` of an integral")))?;
    offered.entry(place).or_default().push((text.to_string(), lines.to_vec()));
    Ok(())
}
