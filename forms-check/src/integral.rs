//! Integrals by antiderivatives that the certificate offers.
//!
//! ```text
//! f, u = a..b ─▶ offered F ─ F′ = f between the bounds? ─ F continuous on [a, b]? ─▶ F(b) − F(a)
//! ```
//! F′ = f is shown by a proof like that of a statement. Continuity is shown from the operations of
//! F: every divisor, every base of a power and every argument of a logarithm has a sign over the
//! whole closed range, whichever of a and b is larger. Only conditions that hold in a whole
//! neighbourhood are used, so that the value can be differentiated. A condition on a variable of
//! integration, of this integral or an outer one, is not used. The conditions under which an inner
//! integral was found must hold over the whole ranges of the outer integral.

use crate::calculus::{Value, order};
use crate::continuity::Range;
use crate::continuity::Region;
use crate::expression::Operation::{Add, Function, Multiply, Variable};
use crate::expression::{Expr, rational};
use crate::field::{Field, Kind};
use crate::line::{Line, Offered};
use crate::proof::{self, Subject};
use crate::sign::Seen;
use crate::theory::{Condition, Relation, Scope, Statement, Theory};
use crate::tokens::Reader;
use crate::{Stop, malformed, uncovered};
use std::collections::{BTreeMap, HashMap};

impl Theory {
    /// Reads in a new scope, and returns that scope with the value.
    pub(crate) fn apart<T>(
        &mut self,
        body: impl FnOnce(&mut Self) -> Result<T, Stop>,
    ) -> Result<(T, Scope), Stop> {
        let outer = std::mem::take(&mut self.scope);
        let value = body(self);
        let inner = std::mem::replace(&mut self.scope, outer);
        Ok((value?, inner))
    }

    /// Reads `integral(w, u = a..b, v = c..e)` after its opening bracket; the last range is the
    /// innermost.
    pub(crate) fn integral(&mut self, reader: &mut Reader) -> Result<Value, Stop> {
        let ((value, ranges), inner) = self.within_ranges(reader, |theory, reader| theory.sum(reader))?;
        self.keep_outside(&inner, &ranges)?;
        let integral = self.iterated(&value, &ranges, &inner.conditions)?;
        Ok(Value::of(0, integral))
    }

    /// Reads `boundary_integral(F, w, u = a..b, v = c..e)`: Σᵢ (−1)^(i−1) (∫ over uᵢ = bᵢ minus ∫
    /// over uᵢ = aᵢ).
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

    /// Reads an integrand, with the variables of the ranges that follow it bound, and then the
    /// ranges.
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

    /// Keeps the conditions and variables of an inner scope that do not involve the variables of
    /// the ranges. If an inner integral was found under a condition that does, the condition must
    /// hold over the whole ranges.
    fn keep_outside(&mut self, inner: &Scope, ranges: &[Range]) -> Result<(), Stop> {
        let is_bound = |v: &usize| ranges.iter().any(|range| range.variable == *v);
        for (expr, relation) in &inner.conditions {
            if !self.pool.variables(*expr).iter().any(is_bound) {
                self.require(*expr, *relation);
            }
        }
        self.scope.used.extend(inner.used.iter().filter(|v| !is_bound(v)));
        self.scope.integrates = true;
        self.scope.is_narrowed |= inner.is_narrowed;
        if inner.integrates {
            let region = Region { ranges, conditions: self.conditions_of(ranges)? };
            for (expr, relation) in &inner.conditions {
                let speaks_of_them = self.pool.variables(*expr).iter().any(is_bound);
                if speaks_of_them && !self.holds(*expr, *relation, &region)? {
                    return uncovered(
                        "a nested integral whose inner value was not shown to be valid on the whole range",
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
            integral = self.over(integral, ranges.split_at(count), defined)?;
        }
        Ok(integral)
    }

    /// Requires the chart domains whose coordinates all occur free in the integrand or the bounds.
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

    /// Integrates over the last range of `ranges`; the integrals over the later ranges are already
    /// computed.
    fn over(
        &mut self,
        f: Expr,
        (ranges, later): (&[Range], &[Range]),
        defined: &[Condition],
    ) -> Result<Expr, Stop> {
        let Some(Range { variable, from, to, place }) = ranges.last().cloned() else { return Ok(f) };
        let is_innermost = later.is_empty();
        let turn = self.integrated.entry(place).or_default();
        *turn += 1;
        let offer = self.offered.get(&place).and_then(|all| all.get(*turn - 1)).cloned();
        let Some((text, lines)) = offer.filter(|offer| !self.is_sealed && !offer.0.is_empty()) else {
            return uncovered("`integral`");
        };
        let region = Region { ranges, conditions: self.conditions_of(ranges)? };
        let mut conditions = region.conditions.clone();
        // conditions of the integrand and the inner bounds; the value of an inner integral is
        // defined wherever it is used
        let mut needs: Vec<Condition> = defined.to_vec();
        if is_innermost {
            for part in self.pool.parts(&[f]) {
                needs.extend(self.need(part)?);
            }
        }
        needs.retain(|need| {
            let is_later = |range: &Range| self.pool.variables(need.0).contains(&range.variable);
            !later.iter().any(is_later)
        });
        for (expr, relation) in &needs {
            if *relation != Relation::NotZero && self.holds(*expr, Relation::NotNegative, &region)? {
                conditions.push((*expr, Relation::NotNegative));
            }
        }
        let (antiderivative, _) = self.apart(|theory| {
            let antiderivative = theory.expression(&text)?;
            let slope = theory.pool.derivative(antiderivative, variable);
            let components = BTreeMap::from([(format!("of the integral over {text}"), [slope, f])]);
            let statement = Statement::new(&theory.pool, components, conditions);
            proof::check(theory, &statement, &lines, Subject::AlmostEverywhere(variable))?;
            Ok(antiderivative)
        })?;
        self.check_continuous(antiderivative, &region)?;
        self.check_almost_everywhere(&needs, antiderivative, &region)?;
        let upper = self.pool.substitute(antiderivative, &HashMap::from([(variable, to)]));
        let lower = self.pool.substitute(antiderivative, &HashMap::from([(variable, from)]));
        let negated = self.pool.negate(lower);
        Ok(self.pool.make(Add, vec![upper, negated]))
    }

    /// Returns the strict conditions on other variables, and the conditions that each variable of
    /// the ranges lies between its bounds.
    fn conditions_of(&mut self, ranges: &[Range]) -> Result<Vec<Condition>, Stop> {
        let mut known: Vec<Condition> = Vec::new();
        for condition in [&self.scope.conditions[..], &self.given].concat() {
            let is_bound =
                |v: &usize| self.bound.contains(v) || ranges.iter().any(|range| range.variable == *v);
            if !self.pool.variables(condition.0).iter().any(is_bound) && self.is_open(condition)? {
                known.push(condition);
            }
        }
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
            // u has the sign of the lower bound if that is not negative, and of the upper bound if
            // that is not positive
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

    pub(crate) fn difference(&mut self, a: Expr, b: Expr) -> Expr {
        let negated = self.pool.negate(b);
        self.pool.make(Add, vec![a, negated])
    }

    pub(crate) fn seen(&mut self, q: Expr, conditions: &[Condition]) -> Result<Seen, Stop> {
        let mut field = Field::default();
        for part in self.pool.parts(&[q]) {
            if let (Function("sin" | "cos"), [angle]) = self.pool.node(part) {
                field.elements.clear();
                let angle = field.element(&self.pool, *angle)?;
                if !field.has_unit(&angle)? {
                    // an angle of several terms is not declared as a unit
                    let _ = field.declare(Kind::Circle, &angle);
                }
            }
        }
        field.elements.clear();
        field.seen(&mut self.pool, q, conditions)
    }
}

/// Reads the entry `integral PLACE F` and the lines below it.
pub(crate) fn offer(offered: &mut Offered, rest: &str, lines: &[Line]) -> Result<(), Stop> {
    let (place, text) = rest.split_once(' ').unwrap_or((rest, ""));
    let place = place.parse().map_err(|_| malformed(format!("invalid place `{place}` of an integral")))?;
    offered.entry(place).or_default().push((text.to_string(), lines.to_vec()));
    Ok(())
}
