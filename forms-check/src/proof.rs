//! A proof replayed: declarations of bases and units, then zero, or cases of signs with a proof each.

use crate::certificate::Line;
use crate::expression::{Expr, rational};
use crate::field::{Base, Field, Kind, Unit};
use crate::polynomial::Polynomial;
use crate::sign::Seen;
use crate::theory::{Condition, Relation, Statement, Theory};
use crate::{Stop, malformed, rejected};

/// Cases within cases.
const DEEPEST: usize = 16;

/// The lines of one proof, and what it is about.
pub(crate) struct Proof<'a> {
    pub(crate) theory: &'a mut Theory,
    pub(crate) statement: &'a Statement,
    pub(crate) lines: std::slice::Iter<'a, Line>,
    /// Whether it speaks only of points at which both sides are defined.
    pub(crate) is_defined: bool,
}

impl Proof<'_> {
    /// Checks that both sides agree wherever the conditions hold and the given expressions are not negative.
    pub(crate) fn check(&mut self, given: &[Condition], depth: usize) -> Result<(), Stop> {
        let mut field = Field::default();
        let mut bases: Vec<Expr> = Vec::new();
        let conditions = [&self.statement.conditions[..], given].concat();
        while let Some((keyword, rest)) = self.lines.next() {
            // what was opaque may be known by the next declaration
            field.elements.clear();
            match keyword.as_str() {
                "base" => {
                    bases.push(self.theory.expression(rest)?);
                    self.base(&mut field, bases[bases.len() - 1])?;
                }
                "root" => {
                    let order = rest.parse().ok().filter(|n| (1..=64).contains(n));
                    let order = order.ok_or_else(|| malformed(format!("the order `{rest}`")))?;
                    field.bases.last_mut().ok_or_else(|| malformed("a root without a base"))?.order = order;
                }
                "logarithm" => {
                    let logarithm = Some(field.new_generator(None)?);
                    let base =
                        field.bases.last_mut().ok_or_else(|| malformed("a logarithm without a base"))?;
                    base.logarithm = logarithm;
                }
                "positive" | "negative" => self.sign(&mut field, keyword == "positive", rest, &conditions)?,
                "circle" => self.unit(&mut field, Kind::Circle, rest)?,
                "tangent" => self.unit(&mut field, Kind::Tangent, rest)?,
                "exponent" => self.unit(&mut field, Kind::Exponent, rest)?,
                "split" if depth < DEEPEST => {
                    return self.split(&mut field, &bases, rest, (given, &conditions), depth);
                }
                "undefined" if self.is_defined => return self.undefined(&mut field),
                "zero" => return self.zero(&mut field),
                other => return Err(malformed(format!("`{other}` in a proof"))),
            }
        }
        Err(malformed("a proof without an end"))
    }

    fn base(&mut self, field: &mut Field, expr: Expr) -> Result<(), Stop> {
        let element = field.element(&self.theory.pool, expr)?;
        let element = field.expanded(&element)?;
        let constant = element.numerator.as_constant();
        if !element.factors.is_empty()
            || constant.as_ref().is_some_and(|c| *c <= rational(1, 1) || !c.is_integer())
        {
            return rejected("a base is no polynomial, nor an integer above 1");
        }
        let sign = constant.map(|_| 1);
        field.bases.push(Base {
            polynomial: element.numerator,
            order: 1,
            used: 0,
            sign,
            root: None,
            logarithm: None,
        });
        Ok(())
    }

    /// The reason is the base, or minus the base, written so that it is visibly not negative.
    fn sign(
        &mut self,
        field: &mut Field,
        positive: bool,
        reason: &str,
        known: &[Condition],
    ) -> Result<(), Stop> {
        let expr = self.theory.expression(reason)?;
        let element = field.element(&self.theory.pool, expr)?;
        let sign = if positive { 1 } else { -1 };
        let Some(base) = field.bases.last() else { return Err(malformed("a sign without a base")) };
        let signed = base.polynomial.clone().scale(&rational(sign, 1)).into();
        if !field.equal(&element, &signed)? {
            return rejected("the reason for a sign is not the base");
        }
        if field.seen(&mut self.theory.pool, expr, known)? == Seen::Nothing {
            return rejected("the reason for a sign does not show it");
        }
        field.bases.last_mut().into_iter().for_each(|base| base.sign = Some(sign));
        Ok(())
    }

    fn unit(&mut self, field: &mut Field, kind: Kind, text: &str) -> Result<(), Stop> {
        let expr = self.theory.expression(text)?;
        let value = field.element(&self.theory.pool, expr)?;
        let value = field.expanded(&value)?;
        if value.numerator.0.len() != 1 {
            return rejected("a unit is no number times a quantity");
        }
        let generator = field.new_generator(None)?;
        if kind == Kind::Circle {
            let sine = field.new_generator(None)?;
            let square = Polynomial::generator(generator, 2).scale(&rational(-1, 1));
            field.bind(sine, 2, square.add(&Polynomial::constant(rational(1, 1))));
        }
        field.units.push(Unit { kind, value, generator, used: 0 });
        Ok(())
    }

    fn zero(&mut self, field: &mut Field) -> Result<(), Stop> {
        for (component, [left, right]) in
            self.statement.components.iter().filter(|sides| sides.1[0] != sides.1[1])
        {
            let left = field.element(&self.theory.pool, *left)?;
            let right = field.element(&self.theory.pool, *right)?;
            if !field.equal(&left, &right)? {
                return rejected(format!("the sides differ in the component `{component}`"));
            }
        }
        let idle_base = field.bases.iter().position(|base| base.order != base.used);
        let idle_unit = field.units.iter().position(|unit| unit.used == 0);
        match (idle_base, idle_unit) {
            (Some(number), _) => {
                rejected(format!("base {} is not used, or has a root of another order", number + 1))
            }
            (_, Some(number)) => rejected(format!("unit {} is not used", number + 1)),
            _ => Ok(()),
        }
    }

    /// In this case a side divides by zero everywhere.
    fn undefined(&mut self, field: &mut Field) -> Result<(), Stop> {
        for expr in self.statement.components.values().flatten() {
            match field.element(&self.theory.pool, *expr) {
                Err(Stop::Undefined) => return Ok(()),
                other => other?,
            };
        }
        rejected("both sides are defined")
    }

    fn split(
        &mut self,
        field: &mut Field,
        bases: &[Expr],
        text: &str,
        (given, conditions): (&[Condition], &[Condition]),
        depth: usize,
    ) -> Result<(), Stop> {
        let numbers: Option<Vec<usize>> = text.split_whitespace().map(|word| word.parse().ok()).collect();
        let numbers = numbers.filter(|numbers| numbers.iter().all(|n| (1..=bases.len()).contains(n)));
        let numbers = numbers.ok_or_else(|| malformed(format!("the bases `{text}`")))?;
        let split: Vec<usize> = numbers.iter().map(|number| number - 1).collect();
        let mut cases: Vec<Vec<i64>> = Vec::new();
        loop {
            match self.lines.next() {
                Some((keyword, signs)) if keyword == "case" => {
                    let signs: Vec<i64> = signs.chars().map(|c| if c == '-' { -1 } else { 1 }).collect();
                    let length = cases.first().map_or(signs.len(), Vec::len);
                    if signs.len() != length || length > split.len() || cases.contains(&signs) {
                        return Err(malformed(
                            "cases have as many signs, for the first bases, and stand once",
                        ));
                    }
                    let mut known = given.to_vec();
                    for (sign, base) in signs.iter().zip(&split) {
                        let (factor, pool) = (rational(*sign, 1), &mut self.theory.pool);
                        let factor = pool.number(factor);
                        let signed =
                            pool.make(crate::expression::Operation::Multiply, vec![factor, bases[*base]]);
                        known.push((signed, Relation::NotNegative));
                    }
                    self.check(&known, depth + 1)?;
                    cases.push(signs);
                }
                Some((keyword, _)) if keyword == "end" => break,
                _ => return Err(malformed("cases without an end")),
            }
        }
        field.check_cover(&self.theory.pool, conditions, &split, &cases)
    }
}
