//! Forms that a search has found, and the one to use.

use crate::accuracy::Regime;
use crate::expression::{Expr, Rational};

/// One way to compute a kernel.
#[derive(Clone, Debug, PartialEq)]
pub struct Form {
    /// Expression that computes each output.
    pub outputs: Vec<Expr>,
    /// Largest relative error before rounding, if the form is an approximation.
    pub approximation: Option<Rational>,
    /// Mean loss in bits in `f64`, with equal weight for every regime.
    pub loss: f64,
    /// Mean loss in each regime.
    pub regimes: Vec<(Regime, f64)>,
    /// Cost in units of an addition.
    pub cost: u32,
    /// Largest loss at a sample.
    pub worst: f64,
    /// Largest loss at a sample of a value that is a normal number, also among samples that the search
    /// has not seen.
    pub worst_of_normal: f64,
    /// Error bound in units of 2⁻⁵³ that the arithmetic with bounds shows in `f64` for most typical
    /// arguments.
    pub bound: f64,
    /// Share of the samples, with equal weight for every regime, for which it shows no bound of 16
    /// units.
    pub unsettled: f64,
}

/// Maximum mean loss in bits over all regimes. If the best form loses more, no form is good enough,
/// and the kernel is computed with as much precision as its arguments require.
const MOST_LOSS: f64 = 0.9;

/// Maximum mean loss in bits in one regime, with the same consequence.
const MOST_LOSS_OF_A_REGIME: f64 = 2.0;

/// Maximum loss in bits at one sample, with the same consequence: a loss of 16 units.
const MOST_LOSS_OF_A_SAMPLE: f64 = 4.0;

/// Error bounds, in units of 2⁻⁵³, of which such a kernel promises the least that most of its values
/// keep without more precision.
const PROMISES: [f64; 4] = [2.0, 4.0, 8.0, MOST_UNITS];

/// Largest error bound, in units of 2⁻⁵³, that is promised for a kernel without an accurate form.
pub(super) const MOST_UNITS: f64 = 16.0;

impl Form {
    /// Whether it is not accurate enough.
    fn is_open(&self) -> bool {
        self.loss > MOST_LOSS
            || self.worst_of_normal > MOST_LOSS_OF_A_SAMPLE
            || self.regimes.iter().any(|(_, loss)| *loss > MOST_LOSS_OF_A_REGIME)
    }

    /// Returns the error bound to promise if it is not accurate enough, in units of 2⁻⁵³.
    fn promised(&self) -> f64 {
        PROMISES.into_iter().find(|&units| self.bound <= units).unwrap_or(MOST_UNITS)
    }
}

/// Difference of the mean losses, in bits, up to which a cheaper form is preferred to a more
/// accurate one.
const WORTH: f64 = 0.25;

/// Result of a search.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Formula as written.
    pub written: Form,
    /// Pareto front of the forms proved equal to the formula: none is both cheaper and more
    /// accurate than another. The most accurate comes first.
    pub forms: Vec<Form>,
    /// Pareto front of the proved forms that have no value, or a worse one, in `f64` at some arguments
    /// at which the formula has one: they serve where such values get more precision.
    pub incomplete: Vec<Form>,
}

impl Found {
    /// Returns the form to compute by, and the error bound to promise in units of 2⁻⁵³ where no form is
    /// accurate enough.
    pub fn chosen(&self) -> (&Form, Option<f64>) {
        let cheapest = self.cheapest();
        let form = if cheapest.loss > self.written.loss { &self.written } else { cheapest };
        if !form.is_open() {
            return (form, None);
        }
        let form = self.most_settled();
        (form, form.is_open().then(|| form.promised()))
    }

    /// Returns the cheapest of the forms whose loss is close to the smallest, and among these to the
    /// smallest at the sample where it is largest.
    fn cheapest(&self) -> &Form {
        let best = self.forms.first().unwrap_or(&self.written);
        let good = || self.forms.iter().filter(|form| form.loss <= best.loss + WORTH);
        let least = good().map(|form| form.worst).fold(f64::INFINITY, f64::min);
        good().filter(|form| form.worst <= least + SAMPLE_STEP).min_by_key(|form| form.cost).unwrap_or(best)
    }

    /// Returns the form whose `f64` values have a known bound most often: the one to compute with
    /// where other values need more precision.
    fn most_settled(&self) -> &Form {
        let forms = self.forms.iter().chain(&self.incomplete).chain([&self.written]);
        // where few values have a bound, the more accurate form needs less precision
        let key = |form: &&Form| {
            ((form.unsettled.min(0.5) * 20.0).round() as u32, (form.loss * 8.0) as u32, form.cost)
        };
        forms.min_by_key(key).unwrap_or(&self.written)
    }
}

/// Minimum gain in bits for which a form is kept in addition to a cheaper one.
pub(super) const PARETO_STEP: f64 = 0.02;

/// The same at the sample with the largest loss; a cheaper form must not fail where another does not.
pub(super) const SAMPLE_STEP: f64 = 2.0;

/// Returns the forms of which none is both cheaper and more accurate than another, in the mean and at
/// the worst sample; the most accurate first.
pub(super) fn front(mut forms: Vec<Form>) -> Vec<Form> {
    forms.sort_by(|a, b| a.loss.total_cmp(&b.loss).then(a.cost.cmp(&b.cost)));
    let mut front: Vec<Form> = Vec::new();
    for form in forms {
        let beats = |other: &Form| {
            other.cost <= form.cost
                && other.loss <= form.loss + PARETO_STEP
                && other.worst <= form.worst + SAMPLE_STEP
        };
        let is_beaten = front.iter().any(beats);
        // a more expensive form whose gain is too small for its cost is removed
        if let Some(last) = front.last()
            && form.loss <= last.loss + PARETO_STEP
            && form.worst <= last.worst + SAMPLE_STEP
            && form.cost < last.cost
        {
            front.pop();
        }
        if !is_beaten {
            front.push(form);
        }
    }
    front
}
