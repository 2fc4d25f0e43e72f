//! Replay of a proof: declarations of bases and units, followed by `zero`, or by cases of signs
//! with a proof each.
//!
//! Every expression in the certificate must be defined wherever the statement to be proved is
//! defined: it is made of nodes of the statement, or the conditions of its operations are shown.

use crate::expression::Operation::{Function, Multiply, Pi, Variable};
use crate::expression::{Expr, rational};
use crate::field::{Base, Field, Fraction, Kind};
use crate::line::Line;
use crate::polynomial::Polynomial;
use crate::theory::{Condition, Relation, Statement, Theory};
use crate::{Stop, malformed, rejected};
use std::collections::BTreeSet;

/// Maximum nesting of cases.
const DEEPEST: usize = 16;

/// Largest order of a base's root.
const LARGEST_ORDER: i64 = 64;

/// Subject of a proof.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Subject {
    /// Both sides agree wherever they are defined and the conditions hold.
    Statement,
    /// Both sides agree there except for countably many values of a variable.
    AlmostEverywhere(usize),
}

/// Lines of one proof, with its subject.
pub(crate) struct Proof<'a> {
    theory: &'a mut Theory,
    statement: &'a Statement,
    lines: &'a [Line],
    subject: Subject,
    /// Units represented by the tangents of their halves.
    half_angles: Vec<Expr>,
}

/// Sign conditions of the cases around a step, and the nodes of their expressions.
#[derive(Clone, Default)]
struct Cases {
    given: Vec<Condition>,
    parts: BTreeSet<Expr>,
}

/// Checks that both sides of a statement agree in every component.
pub(crate) fn check(
    theory: &mut Theory,
    statement: &Statement,
    lines: &[Line],
    subject: Subject,
) -> Result<(), Stop> {
    let mut proof = Proof { theory, statement, lines, subject, half_angles: Vec::new() };
    proof.step(&Cases::default(), 0)?;
    if !proof.lines.is_empty() {
        return Err(malformed("lines after a proof"));
    }
    let half_angles = std::mem::take(&mut proof.half_angles);
    if half_angles.is_empty() || subject != Subject::Statement {
        return Ok(());
    }
    theory.check_dense(statement, &half_angles)
}

/// State of a step while it is read.
struct Step<'a> {
    field: Field,
    bases: Vec<Expr>,
    cases: &'a Cases,
    /// Conditions of the statement and of the cases.
    conditions: Vec<Condition>,
    depth: usize,
}

impl<'a> Proof<'a> {
    fn next(&mut self) -> Option<(&'a str, &'a str)> {
        let ((keyword, rest), after) = self.lines.split_first()?;
        self.lines = after;
        Some((keyword, rest))
    }

    /// Takes the next line if it begins with one of these keywords.
    fn next_if(&mut self, wanted: &[&str]) -> Option<(&'a str, &'a str)> {
        let (keyword, _) = self.lines.first()?;
        if wanted.contains(&keyword.as_str()) { self.next() } else { None }
    }

    /// Checks one step: both sides agree in the given cases.
    fn step(&mut self, cases: &Cases, depth: usize) -> Result<(), Stop> {
        let conditions = [&self.statement.conditions[..], &cases.given].concat();
        let mut step = Step { field: Field::default(), bases: Vec::new(), cases, conditions, depth };
        while let Some((keyword, rest)) = self.next() {
            // the next declaration can determine functions that were opaque before
            step.field.elements.clear();
            match keyword {
                "base" => self.base(&mut step, rest)?,
                "circle" => self.unit(&mut step, Kind::Circle, rest)?,
                "tangent" => self.unit(&mut step, Kind::Tangent, rest)?,
                "exponent" => self.unit(&mut step, Kind::Exponent, rest)?,
                "split" if depth < DEEPEST => return self.split(&mut step, rest),
                "undefined" if self.subject == Subject::Statement => return self.undefined(&mut step.field),
                "zero" => return self.zero(&mut step.field),
                other => return Err(malformed(format!("unexpected `{other}` in a proof"))),
            }
        }
        Err(malformed("the proof does not end with `zero`, `split` or `undefined`"))
    }

    /// Reads an expression of the certificate, checks that it is defined, and returns it with its
    /// element.
    fn declared(&mut self, step: &mut Step, text: &str) -> Result<(Expr, Fraction), Stop> {
        let expr = self.theory.expression(text)?;
        for part in self.theory.pool.parts(&[expr]) {
            if self.statement.nodes.contains(&part)
                || step.cases.parts.contains(&part)
                || self.is_half_angle(step, part)?
            {
                continue;
            }
            if let Some(need) = self.theory.need(part)?
                && !step.field.shows(&mut self.theory.pool, need, &step.conditions)?
            {
                return rejected(format!("`{text}` was not shown to be defined wherever the statement is"));
            }
        }
        let element = step.field.element(&self.theory.pool, expr)?;
        Ok((expr, element))
    }

    /// Whether a node is the tangent of half a declared unit, which is defined at the points under
    /// consideration.
    fn is_half_angle(&mut self, step: &mut Step, part: Expr) -> Result<bool, Stop> {
        let (Function("tan"), [angle]) = self.theory.pool.node(part) else { return Ok(false) };
        let angle = step.field.element(&self.theory.pool, *angle)?;
        Ok(step.field.half_unit(&angle)?.is_some())
    }

    /// Reads `base g` with the lines that belong to it: its root, its logarithm, its sign.
    fn base(&mut self, step: &mut Step, text: &str) -> Result<(), Stop> {
        let (expr, element) = self.declared(step, text)?;
        let element = step.field.expanded(&element)?;
        let constant = element.numerator.as_constant();
        let is_usable = |c: &num_rational::BigRational| *c > rational(1, 1) && c.is_integer();
        if !element.factors.is_empty() || constant.as_ref().is_some_and(|c| !is_usable(c)) {
            return rejected("a base must be a polynomial or an integer above 1");
        }
        let order = match self.next_if(&["root"]) {
            Some((_, order)) => {
                let order = order.parse().ok().filter(|n| (2..=LARGEST_ORDER).contains(n));
                order.ok_or_else(|| malformed("the order of a root is between 2 and 64"))?
            }
            None => 1,
        };
        let has_logarithm = self.next_if(&["logarithm"]).is_some();
        let sign = match self.next_if(&["positive", "negative"]) {
            Some((keyword, reason)) => {
                Some(self.sign(step, &element.numerator, (keyword == "positive", reason))?)
            }
            None => constant.map(|_| 1),
        };
        let logarithm = if has_logarithm { Some(step.field.new_generator(None)?) } else { None };
        let polynomial = element.numerator;
        step.field.bases.push(Base { polynomial, order, used: 0, sign, root: None, logarithm });
        step.bases.push(expr);
        Ok(())
    }

    /// Checks the sign of a base. The reason is the base, or minus the base, in a form that is
    /// visibly not negative.
    fn sign(
        &mut self,
        step: &mut Step,
        base: &Polynomial,
        (is_positive, reason): (bool, &str),
    ) -> Result<i64, Stop> {
        let (expr, element) = self.declared(step, reason)?;
        let sign = if is_positive { 1 } else { -1 };
        let signed = base.clone().scale(&rational(sign, 1)).into();
        if !step.field.equal(&element, &signed)? {
            return rejected("the reason for a sign is not the base");
        }
        if !step.field.shows(&mut self.theory.pool, (expr, Relation::NotNegative), &step.conditions)? {
            return rejected("the reason for a sign does not show it");
        }
        Ok(sign)
    }

    fn unit(&mut self, step: &mut Step, kind: Kind, text: &str) -> Result<(), Stop> {
        let (expr, value) = self.declared(step, text)?;
        let value = step.field.declare(kind, &value)?;
        if kind != Kind::Tangent {
            return Ok(());
        }
        // where the half angle has no tangent, the variables are perturbed
        let (mut is_product, mut moves) = (value.factors.is_empty(), false);
        for g in step.field.generators_of(&value.numerator) {
            match step.field.generators[g] {
                Some((Pi, _)) => {}
                Some((Variable(v), _)) => {
                    moves |=
                        self.subject == Subject::Statement || self.subject == Subject::AlmostEverywhere(v);
                }
                _ => is_product = false,
            }
        }
        if !is_product || !moves {
            return rejected(
                "the unit of a half angle must be a number times powers of variables that can be perturbed",
            );
        }
        self.half_angles.push(expr);
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

    /// Checks that a side divides by zero everywhere in this case.
    fn undefined(&mut self, field: &mut Field) -> Result<(), Stop> {
        for expr in self.statement.components.values().flatten() {
            match field.element(&self.theory.pool, *expr) {
                Err(Stop::Undefined) => return Ok(()),
                other => other?,
            };
        }
        rejected("both sides are defined")
    }

    fn split(&mut self, step: &mut Step, text: &str) -> Result<(), Stop> {
        let number = |word: &str| word.parse().ok().filter(|n| (1..=step.bases.len()).contains(n));
        let split: Option<Vec<usize>> =
            text.split_whitespace().map(|word| number(word).map(|n| n - 1)).collect();
        let split = split.ok_or_else(|| malformed(format!("invalid list of bases `{text}`")))?;
        let mut cases: Vec<Vec<i64>> = Vec::new();
        while let Some((_, signs)) = self.next_if(&["case"]) {
            let sign = |c: char| match c {
                '+' => Some(1),
                '-' => Some(-1),
                _ => None,
            };
            let signs: Vec<i64> = signs.chars().map(sign).collect::<Option<_>>().unwrap_or_default();
            let length = cases.first().map_or(signs.len(), Vec::len);
            if signs.is_empty() || signs.len() != length || length > split.len() || cases.contains(&signs) {
                return Err(malformed(
                    "every case must give the signs of the same first bases of the split, and occur once",
                ));
            }
            let mut inner = step.cases.clone();
            for (sign, base) in signs.iter().zip(&split) {
                let base = step.bases[*base];
                let factor = self.theory.pool.number(rational(*sign, 1));
                let signed = self.theory.pool.make(Multiply, vec![factor, base]);
                inner.given.push((signed, Relation::NotNegative));
                inner.parts.extend(self.theory.pool.parts(&[signed]));
            }
            self.step(&inner, step.depth + 1)?;
            cases.push(signs);
        }
        if self.next_if(&["end"]).is_none() {
            return Err(malformed("the list of cases has no `end`"));
        }
        step.field.check_cover(&self.theory.pool, &step.conditions, &split, &cases)
    }
}
