//! Writer of proofs as lines: each step lists the bases and units it uses, each after its
//! constituents.

use super::entry::Uncovered;
use super::reason::reason;
use crate::assume::Facts;
use crate::decide::Observer;
use crate::expression::{Expr, Pool};
use crate::normal::{Fraction, Generator, Sign, Tower, Unit};
use crate::polynomial::Polynomial;
use rustc_hash::{FxHashMap, FxHashSet};
use std::fmt::Write;

/// Writes the observed proof as lines.
pub(super) struct Writer {
    pool: Pool,
    lines: String,
    /// Part of the proof that could not be written.
    gap: Option<Uncovered>,
    /// Signs of bases with their reasons, for the cases that enclose the present place.
    reasons: Reasons,
    splits: Vec<Split>,
}

/// Signs of bases with their reasons.
type Reasons = FxHashMap<usize, (Sign, String)>;

/// A split that encloses the present place.
struct Split {
    /// Whether the split is omitted because its only case is certain.
    left_out: bool,
    /// Reasons known before the split, and reasons known in each of its cases.
    outer: Reasons,
    inner: Reasons,
}

/// Declarations of one step of the proof.
#[derive(Default)]
struct Declared {
    bases: Vec<usize>,
    seen: FxHashSet<u32>,
    /// Bases whose roots do not occur.
    rootless: FxHashSet<usize>,
    /// Bases whose logarithms occur.
    logarithmic: FxHashSet<usize>,
}

impl Writer {
    /// Creates a writer with the expressions of the theory.
    pub(super) fn new(pool: Pool) -> Self {
        let (lines, reasons) = (String::new(), FxHashMap::default());
        Writer { pool, lines, gap: None, reasons, splits: Vec::new() }
    }

    /// Returns the lines, or the part of the proof that could not be written.
    pub(super) fn finish(self) -> Result<String, Uncovered> {
        self.gap.map_or(Ok(self.lines), Err)
    }

    fn line(&mut self, keyword: &str, rest: &str) {
        let depth = 2 * self.splits.iter().filter(|split| !split.left_out).count();
        let end = if rest.is_empty() { String::new() } else { format!(" {rest}") };
        let _ = writeln!(self.lines, "{:depth$}{keyword}{end}", "");
    }

    fn text(&mut self, tower: &Tower, fraction: &Fraction) -> String {
        let raised = tower.raise(&mut self.pool, fraction);
        let text = self.pool.full_text(raised);
        if text.is_none() {
            self.gap = Some(Uncovered::LongPart);
        }
        text.unwrap_or_default()
    }

    fn polynomial(&mut self, tower: &Tower, polynomial: &Polynomial) -> String {
        self.text(tower, &Fraction::from(polynomial.clone()))
    }

    fn declare_fraction(&mut self, tower: &Tower, fraction: &Fraction, declared: &mut Declared) {
        for variable in tower.variables_of(fraction) {
            self.declare(tower, variable, declared);
        }
    }

    /// Declares a generator, after the generators in its definition.
    fn declare(&mut self, tower: &Tower, variable: u32, declared: &mut Declared) {
        if !declared.seen.insert(variable) {
            return;
        }
        match tower.generator(variable).clone() {
            Generator::Variable(_) | Generator::Pi => {}
            Generator::Jet { arguments, .. } | Generator::Opaque { arguments, .. } => {
                arguments.iter().for_each(|argument| self.declare_fraction(tower, argument, declared));
            }
            Generator::Cosine(unit) | Generator::Sine(unit) => {
                let both = [Generator::Cosine(unit.clone()), Generator::Sine(unit.clone())];
                let known = (0..tower.generator_count()).filter(|v| both.contains(tower.generator(*v)));
                declared.seen.extend(known);
                self.unit(tower, "circle", &unit, declared);
            }
            Generator::HalfTangent(unit) => self.unit(tower, "tangent", &unit, declared),
            Generator::Exponential(unit) => self.unit(tower, "exponent", &unit, declared),
            Generator::Root { base, .. } => self.base(tower, base, declared),
            Generator::Chord { .. } => {
                self.gap = Some(Uncovered::Chord);
            }
            Generator::Logarithm { base } => self.base(tower, base, declared),
        }
    }

    fn unit(&mut self, tower: &Tower, keyword: &str, unit: &Unit, declared: &mut Declared) {
        let value = tower.unit_value(unit);
        self.declare_fraction(tower, &value, declared);
        let text = self.text(tower, &value);
        self.line(keyword, &text);
    }

    fn base(&mut self, tower: &Tower, number: usize, declared: &mut Declared) {
        if declared.bases.contains(&number) {
            return;
        }
        let base = tower.base(number).clone();
        self.declare_fraction(tower, &base.polynomial.clone().into(), declared);
        declared.bases.push(number);
        let text = self.polynomial(tower, &base.polynomial);
        self.line("base", &text);
        if base.order() > 1 && !declared.rootless.contains(&number) {
            self.line("root", &base.order().to_string());
        }
        if declared.logarithmic.contains(&number) {
            self.line("logarithm", "");
        }
        if base.polynomial.as_constant().is_some() {
            return;
        }
        let agrees = |known: &&(Sign, String)| base.sign.is_none_or(|sign| sign == known.0);
        let known = self.reasons.get(&number).filter(agrees).cloned();
        let manifest = tower.is_manifestly_not_negative(&base.polynomial).then_some(Sign::Positive);
        let given = base.sign.or(manifest);
        let given = given.map(|sign| (sign, self.polynomial(tower, &signed(&base.polynomial, sign))));
        match known.or(given) {
            Some((Sign::Positive, reason)) => self.line("positive", &reason),
            Some((Sign::Negative, reason)) => self.line("negative", &reason),
            None => {}
        }
    }

    /// Records the reasons for the known signs of bases.
    fn find_reasons(&mut self, tower: &Tower, factors: &[usize], facts: &Facts) {
        for &number in factors {
            let polynomial = tower.base(number).polynomial.clone();
            for sign in [Sign::Positive, Sign::Negative] {
                let side = signed(&polynomial, sign);
                let names: FxHashMap<u32, String> = side
                    .variables()
                    .into_iter()
                    .map(|v| (v, self.polynomial(tower, &Polynomial::variable(v))))
                    .collect();
                if let Some(reason) = reason(&side, facts, &|v| names[&v].clone()) {
                    self.reasons.insert(number, (sign, reason));
                }
            }
        }
    }
}

fn signed(polynomial: &Polynomial, sign: Sign) -> Polynomial {
    if sign == Sign::Positive { polynomial.clone() } else { polynomial.neg() }
}

impl Observer for Writer {
    fn zero(&mut self, pool: &Pool, tower: &Tower, differences: &[Expr]) {
        let mut declared = Declared::default();
        let parts = pool.reachable(differences);
        let elements: Vec<&Fraction> = parts.iter().filter_map(|part| tower.element_of(*part)).collect();
        declared.logarithmic = tower.logarithmic_bases();
        let occurring: FxHashSet<u32> =
            elements.iter().flat_map(|element| tower.variables_of(element)).collect();
        let roots = occurring.iter().filter_map(|variable| match tower.generator(*variable) {
            Generator::Root { base, .. } => Some(*base),
            _ => None,
        });
        let rooted: FxHashSet<usize> = roots.collect();
        declared.rootless.extend(tower.bases().map(|base| base.0).filter(|base| !rooted.contains(base)));
        for element in elements {
            self.declare_fraction(tower, element, &mut declared);
        }
        for number in tower.bases_of(&parts) {
            self.base(tower, number, &mut declared);
        }
        self.line("zero", "");
    }

    fn undefined(&mut self) {
        self.line("undefined", "");
    }

    fn split(&mut self, tower: &Tower, factors: &[usize], facts: &Facts, cases: &[Vec<(usize, Sign)>]) {
        let outer = self.reasons.clone();
        self.find_reasons(tower, factors, facts);
        let is_certain =
            |(base, sign): &(usize, Sign)| self.reasons.get(base).is_some_and(|known| known.0 == *sign);
        let certain = cases.len() == 1 && cases[0].iter().all(is_certain);
        if !certain {
            let mut declared = Declared::default();
            for &number in factors {
                self.base(tower, number, &mut declared);
            }
            let place = |number: &usize| declared.bases.iter().position(|base| base == number);
            let numbers: Vec<String> =
                factors.iter().filter_map(place).map(|place| (place + 1).to_string()).collect();
            self.line("split", &numbers.join(" "));
        }
        self.splits.push(Split { left_out: certain, outer, inner: self.reasons.clone() });
    }

    fn case(&mut self, signs: &[(usize, Sign)]) {
        let Some(split) = self.splits.last() else { return };
        self.reasons = split.inner.clone();
        if !split.left_out {
            let sign = |entry: &(usize, Sign)| if entry.1 == Sign::Positive { '+' } else { '-' };
            let signs: String = signs.iter().map(sign).collect();
            self.line("case", &signs);
        }
    }

    fn end(&mut self) {
        if let Some(split) = self.splits.pop() {
            self.reasons = split.outer;
            if !split.left_out {
                self.line("end", "");
            }
        }
    }
}
