//! Comparison of one kernel with a promise of accuracy (`within N`) with its true values.

use crate::points::Dice;
use crate::random::Term;
use astro_float::{Consts, Radix, RoundingMode};
use forms::core::accuracy::{Format, Rounded, Truth, Value};
use forms::core::check::read_theory;
use forms::core::compile::compile_kernel;
use forms::core::expression::{Rational, Symbol};
use forms::core::generation::Generated;
use forms::core::kernel::Instruction;
use forms::core::theory::{Kernel, Theory};
use forms::math::Tier;
use std::fmt;

/// Number of attempts to find a point of the domain.
const DRAWS: usize = 40;

/// Numbers of values by outcome.
#[derive(Default)]
pub(crate) struct Tally {
    /// Number of values that keep the promise.
    pub(crate) known: usize,
    /// Number of subnormal values among them.
    subnormal: usize,
    /// Number of points without a value or without a known true value.
    open: usize,
    /// Numbers of values by tier: `f64`, double-double, words.
    tiers: [usize; 3],
    /// Values that are NaN with an error, although a value exists.
    pub(crate) unknown: Vec<String>,
    /// Values that break the promise.
    pub(crate) wrong: Vec<String>,
}

impl Tally {
    pub(crate) fn add(&mut self, other: Tally) {
        self.known += other.known;
        self.subnormal += other.subnormal;
        self.open += other.open;
        for (sum, more) in self.tiers.iter_mut().zip(other.tiers) {
            *sum += more;
        }
        self.unknown.extend(other.unknown);
        self.wrong.extend(other.wrong);
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [double, two, words] = self.tiers;
        write!(
            f,
            "{} values within their promise ({double} in f64, {two} in double-double, {words} in words; {} subnormal), \
             {} NaN with an error, {} wrong, {} without a known truth",
            self.known,
            self.subnormal,
            self.unknown.len(),
            self.wrong.len(),
            self.open
        )
    }
}

/// Kernel with a promise of accuracy.
pub(crate) struct Judge {
    theory: Theory,
    kernel: Kernel,
    generated: Generated,
    within: f64,
    /// Text of the kernel's file if it is short, else the name of the kernel.
    text: String,
}

impl Judge {
    /// Returns the kernels with a promise in a text; none if the text has errors.
    pub(crate) fn of_promises(text: &str) -> Vec<Judge> {
        if !text.contains("within") {
            return Vec::new();
        }
        let (theory, errors) = read_theory(text);
        if !errors.is_empty() {
            return Vec::new();
        }
        let promised = theory.kernels.iter().filter(|kernel| kernel.within.is_some());
        promised.filter_map(|kernel| Judge::of(theory.clone(), kernel.clone(), text)).collect()
    }

    fn of(mut theory: Theory, kernel: Kernel, text: &str) -> Option<Judge> {
        let generated = compile_kernel(&mut theory.pool, &kernel).ok()?;
        let within = generated.within()?;
        let text = if text.len() < 400 { text } else { &kernel.name }.to_string();
        Some(Judge { theory, kernel, generated, within, text })
    }

    /// Whether computing a true value takes seconds, because of an integral or hundreds of
    /// instructions.
    pub(crate) fn is_long(&self) -> bool {
        let instructions = self.generated.written.instructions();
        let is_integral = |instruction: &Instruction| matches!(instruction, Instruction::Quadrature { .. });
        instructions.len() > 600 || instructions.iter().any(is_integral)
    }

    /// Returns a point of the domain, if one is found.
    fn point(&self, truth: &Truth<'_>, dice: &mut Dice) -> Option<Vec<f64>> {
        (0..DRAWS).find_map(|_| {
            let point: Vec<f64> = self.kernel.arguments.iter().map(|_| dice.argument()).collect();
            truth.admits(&self.exactly(&point)).unwrap_or(false).then_some(point)
        })
    }

    fn exactly(&self, point: &[f64]) -> Vec<(Symbol, Rational)> {
        let exact = point.iter().map(|&value| Rational::from_float(value).expect("a finite number"));
        self.kernel.arguments.iter().copied().zip(exact).collect()
    }

    pub(crate) fn tally(&self, points: usize, seed: u64) -> Tally {
        let truth = Truth::new(&self.theory.pool, &self.kernel.outputs, &self.kernel.domain);
        let mut dice = Dice::of(seed);
        let mut tally = Tally::default();
        for _ in 0..points {
            let Some(point) = self.point(&truth, &mut dice) else { continue };
            let values = self.generated.optimised.interpret_with_tier(&point, self.within);
            let truths = truth.at(&self.exactly(&point), Format::DoubleDouble);
            for (place, (&(value, tier), truth)) in values.iter().zip(truths).enumerate() {
                self.judge((value, tier), &truth, &mut tally, || {
                    format!("{place} of {} at {point:?}: {value:e} by {tier:?}, not {truth:?}", self.text)
                });
            }
        }
        tally
    }

    fn judge(
        &self,
        (value, tier): (f64, Tier),
        truth: &Value,
        tally: &mut Tally,
        said: impl FnOnce() -> String,
    ) {
        let Value::Known(Rounded::DoubleDouble(high, low)) = *truth else {
            tally.open += 1;
            return;
        };
        if tier == Tier::Undecided {
            tally.unknown.push(said());
            return;
        }
        let subnormal = high.abs() < f64::MIN_POSITIVE;
        // For a subnormal or infinite true value the promise means correct rounding.
        let is_right =
            if subnormal || !high.is_finite() { value == high } else { self.is_within(value, high, low) };
        if is_right {
            tally.known += 1;
            tally.subnormal += usize::from(subnormal && high != 0.0);
            tally.tiers[match tier {
                Tier::Double => 0,
                Tier::DoubleDouble => 1,
                _ => 2,
            }] += 1;
        } else {
            tally.wrong.push(said());
        }
    }

    /// Whether |value − truth| ≤ N 2⁻⁵³ |truth|.
    fn is_within(&self, value: f64, high: f64, low: f64) -> bool {
        let exact = |value: f64| Rational::from_float(value);
        let (Some(value), Some(high), Some(low)) = (exact(value), exact(high), exact(low)) else {
            return false;
        };
        let truth = high + low;
        // The true value has 32 digits.
        let units =
            Rational::from_float(self.within * (1.0 + 1e-14) * f64::EPSILON / 2.0).expect("a finite number");
        let size = |value: Rational| if value < Rational::from_integer(0.into()) { -value } else { value };
        size(value - &truth) <= units * size(truth)
    }

    /// Compares true values with another library, at points where both have one; returns the number
    /// of comparisons.
    pub(crate) fn agrees_with(&self, term: &Term, seed: u64) -> usize {
        let truth = Truth::new(&self.theory.pool, &self.kernel.outputs, &self.kernel.domain);
        let mut constants = Consts::new().expect("constants fit in memory");
        let mut dice = Dice::of(seed);
        let mut agreeing = 0;
        for _ in 0..4 {
            let point = [dice.argument(), dice.argument()];
            let known = truth.at(&self.exactly(&point), Format::Double);
            let Value::Known(Rounded::Double(known)) = known[0] else { continue };
            let Some(value) = term.value(&point, &mut constants) else { continue };
            let text = value.format(Radix::Dec, RoundingMode::ToEven, &mut constants).expect("a number");
            let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            let short: String = digits.chars().take(60).collect();
            let nearest: f64 = format!("{short}e{exponent}").parse().expect("a number");
            // If the other library cancels to almost zero, the true value can be zero.
            let agrees = nearest == known || (nearest - known).abs() <= known.abs() * f64::EPSILON + 5e-324;
            let is_nothing = known == 0.0 && nearest.abs() < 1e-250;
            assert!(
                agrees || is_nothing,
                "{} at {point:?}: {known:e}, elsewhere {nearest:e}",
                term.kernel(1)
            );
            agreeing += 1;
        }
        agreeing
    }
}
