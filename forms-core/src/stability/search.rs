//! Best-first search from the formula as written, bounded by the number of expanded forms.

use super::bounds::Bounds;
use super::budget::Budget;
use super::form::{Form, Found, PARETO_STEP, SAMPLE_STEP, front};
use super::locate::lossy;
use super::proof::{provable, proved, proved_close};
use super::regimes::{cuts, joined, mean};
use super::rules::{Rewriting, tolerance};
use super::validation::{Validation, has_normal_values};
use crate::accuracy::{Regime, Sample, Samples, Width, bits_lost, ranges, sample};
use crate::expression::{Expr, Node, Pool};
use crate::kernel::{KernelSource, Program, lower};
use crate::theory::Kernel;
use rustc_hash::{FxHashMap, FxHashSet};

/// Maximum number of samples, chosen among those with a loss, for locating the lossy operations of
/// a form.
const LOCATED: usize = 24;

/// Mean loss in bits below which a form is good enough, so that the search stops early.
const GOOD: f64 = 0.15;

/// Number of expansions after which the search stops if a good form is known.
const EXPANSIONS_IF_GOOD: usize = 8;

/// Maximum number of nodes of a form for which every operation is rewritten.
const SMALL: usize = 16;

/// Minimum gain in bits, in the mean and in a regime, for which another form is proved that costs as
/// much as a proved one.
const WORTH_A_PROOF: f64 = 0.05;
const REGIME_STEP: f64 = 0.25;

/// Maximum size of a form, as a multiple of the formula's size.
const LARGEST_GROWTH: usize = 6;

/// Form with its loss at each sample.
struct Candidate {
    outputs: Vec<Expr>,
    losses: Vec<f64>,
    loss: f64,
    cost: u32,
    /// Whether it contains a series, which is only close to what it replaces.
    is_close: bool,
    expanded: bool,
}

impl Candidate {
    /// Returns the largest loss at a sample.
    fn worst(&self) -> f64 {
        self.losses.iter().copied().fold(0.0, f64::max)
    }
}

/// Searches for forms of a kernel that lose fewer bits. The pool is the kernel's; forms are added
/// to it.
pub fn search(pool: &mut Pool, kernel: &Kernel, budget: Budget) -> Option<Found> {
    let samples = sample(pool, kernel, Width::Double, &Regime::ALL, budget.samples, 0);
    let mut search = Search::new(pool, kernel, &samples, budget)?;
    search.add(kernel.outputs.clone(), false);
    for _ in 0..budget.expansions {
        let Some(next) = search.next() else { break };
        search.expand(next);
    }
    search.finish()
}

struct Search<'a> {
    pool: &'a mut Pool,
    kernel: &'a Kernel,
    samples: &'a [Samples],
    budget: Budget,
    /// Samples of all regimes in sequence, and the weight of each in the mean.
    points: Vec<&'a Sample>,
    weights: Vec<f64>,
    candidates: Vec<Candidate>,
    seen: FxHashSet<Vec<Expr>>,
    /// Whether forms lose no more than the formula at other arguments, where that is known.
    valid: FxHashMap<Vec<Expr>, bool>,
    /// Proposals of the rules for an expression, found once: equal expressions, and close ones.
    proposals: FxHashMap<Expr, [Vec<Expr>; 2]>,
    /// Parts of the formula as written, for which approximations are tried.
    parts: FxHashSet<Expr>,
    largest: usize,
}

impl<'a> Search<'a> {
    fn new(pool: &'a mut Pool, kernel: &'a Kernel, samples: &'a [Samples], budget: Budget) -> Option<Self> {
        let points: Vec<&Sample> = samples.iter().flat_map(|regime| &regime.samples).collect();
        if points.is_empty() {
            return None;
        }
        let share = |regime: &Samples| 1.0 / (samples.len() * regime.samples.len()) as f64;
        let weights = samples
            .iter()
            .flat_map(|regime| std::iter::repeat_n(share(regime), regime.samples.len()))
            .collect();
        let parts: FxHashSet<Expr> = pool.reachable(&kernel.outputs).into_iter().collect();
        let largest = LARGEST_GROWTH * parts.len().max(8);
        Some(Search {
            pool,
            kernel,
            samples,
            budget,
            points,
            weights,
            candidates: Vec::new(),
            seen: FxHashSet::default(),
            valid: FxHashMap::default(),
            proposals: FxHashMap::default(),
            parts,
            largest,
        })
    }

    /// Scores a form and adds it to the candidates, unless it is known or too large.
    fn add(&mut self, outputs: Vec<Expr>, is_close: bool) {
        if !self.seen.insert(outputs.clone()) || !self.is_writable(&outputs) {
            return;
        }
        let Some(program) = program(self.pool, self.kernel, &outputs) else { return };
        let interpreter = program.interpreter::<f64>();
        let losses: Vec<f64> = self
            .points
            .iter()
            .map(|sample| bits_lost(Width::Double, sample, &interpreter.values(&sample.arguments)))
            .collect();
        let loss = mean(&losses, &self.weights);
        let cost = program.cost();
        self.candidates.push(Candidate { outputs, losses, loss, cost, is_close, expanded: false });
    }

    /// Whether a form is not too large and applies no function that has the name of the kernel, which
    /// would stand for the kernel in its text.
    fn is_writable(&self, outputs: &[Expr]) -> bool {
        let parts = self.pool.reachable(outputs);
        let is_own_name = |part: &Expr| match self.pool.node(*part) {
            Node::Apply(operation, _) => operation.row().name == self.kernel.name,
            _ => false,
        };
        parts.len() <= self.largest && !parts.iter().any(is_own_name)
    }

    /// Returns the form to expand next: the best of those not yet expanded, judged in turn over all
    /// samples, at its worst sample and in each regime.
    fn next(&self) -> Option<usize> {
        let best = self.candidates.iter().map(|form| form.loss).fold(f64::INFINITY, f64::min);
        let done = self.candidates.iter().filter(|form| form.expanded).count();
        if best < GOOD && done > EXPANSIONS_IF_GOOD {
            return None;
        }
        let open = (0..self.candidates.len()).filter(|&place| !self.candidates[place].expanded);
        let turn = done % (self.samples.len() + 3);
        let key = |place: &usize| {
            let form = &self.candidates[*place];
            let loss = match turn {
                0 | 1 => form.loss,
                2 => self.worst_of_normal(form),
                _ => self.regime_loss(form, turn - 3),
            };
            (loss * 16.0).round() + f64::from(form.cost) / 1000.0 + form.loss / 1e3
        };
        open.min_by(|a, b| key(a).total_cmp(&key(b)))
    }

    fn regime_loss(&self, form: &Candidate, regime: usize) -> f64 {
        let start: usize = self.samples[..regime].iter().map(|samples| samples.samples.len()).sum();
        let count = self.samples[regime].samples.len();
        form.losses[start..start + count].iter().sum::<f64>() / count as f64
    }

    /// Returns the largest loss of a form at a sample of a value that is a normal number.
    fn worst_of_normal(&self, form: &Candidate) -> f64 {
        let losses = self.points.iter().zip(&form.losses).filter(|(sample, _)| has_normal_values(sample));
        losses.map(|(_, loss)| *loss).fold(0.0, f64::max)
    }

    /// Expands a form: adds the forms that the rules produce from its lossy operations.
    fn expand(&mut self, place: usize) {
        self.candidates[place].expanded = true;
        let (outputs, is_close) = (self.candidates[place].outputs.clone(), self.candidates[place].is_close);
        let losses = &self.candidates[place].losses;
        let mut worst: Vec<usize> = (0..losses.len()).filter(|&at| losses[at] > 0.5).collect();
        worst.sort_by(|&a, &b| losses[b].total_cmp(&losses[a]));
        // samples from the whole spectrum of losses, so that one singularity does not hide another
        let step = worst.len().div_ceil(LOCATED).max(1);
        let hard: Vec<&Sample> = worst.into_iter().step_by(step).map(|at| self.points[at]).collect();
        let nodes = self.pool.reachable(&outputs);
        let targets = if nodes.len() <= SMALL {
            nodes
        } else {
            lossy(self.pool, &self.kernel.arguments, &outputs, &hard, self.budget.places)
        };
        let mut rewriting = Rewriting::new(self.pool, &self.kernel.domain);
        let known = &mut self.proposals;
        let mut proposals: Vec<(Expr, Expr, bool)> = Vec::new();
        for target in targets {
            let is_part = self.parts.contains(&target);
            let found = |rewriting: &mut Rewriting| {
                let close = if is_part { rewriting.approximations(target) } else { Vec::new() };
                [rewriting.alternatives(target), close]
            };
            let [equal, close] = known.entry(target).or_insert_with(|| found(&mut rewriting));
            proposals.extend(equal.iter().map(|&image| (target, image, is_close)));
            proposals.extend(close.iter().map(|&image| (target, image, true)));
        }
        for (target, image, is_close) in proposals {
            let parts: FxHashMap<Expr, Expr> = [(target, image)].into_iter().collect();
            let form = outputs.iter().map(|&output| self.pool.replace(output, &parts)).collect();
            self.add(form, is_close);
        }
    }

    /// Returns the Pareto front of the proved forms and of their combination by regimes.
    fn finish(mut self) -> Option<Found> {
        let formula = program(self.pool, self.kernel, &self.kernel.outputs)?;
        let validation = Validation::new(self.pool, self.kernel, &formula);
        let written = self.form(&self.candidates.first()?.outputs.clone(), false, &validation)?;
        let proved = self.proved(&validation);
        let mut forms: Vec<Form> = Vec::new();
        let is_close = proved.iter().any(|&place| self.candidates[place].is_close);
        if let Some(outputs) = self.joined(&proved) {
            let is_proved = if is_close {
                proved_close(self.pool, self.kernel, &outputs, &tolerance())
            } else {
                self::proved(self.pool, self.kernel, &outputs)
            };
            forms.extend(is_proved.then(|| self.form(&outputs, is_close, &validation)).flatten());
        }
        for place in proved {
            let Candidate { outputs, is_close, .. } = &self.candidates[place];
            forms.extend(self.form(&outputs.clone(), *is_close, &validation));
        }
        let is_valid = |form: &Form| self.is_valid(&form.outputs, &validation);
        let (valid, incomplete): (Vec<Form>, Vec<Form>) = forms.into_iter().partition(is_valid);
        Some(Found { written, forms: front(valid), incomplete: front(incomplete) })
    }

    /// Proves finalists, unless one that is proved makes the proof pointless: by being valid too, or where
    /// the other is not.
    fn proved(&mut self, validation: &Validation) -> Vec<usize> {
        let (mut proved, mut valid, mut failed) = (Vec::new(), Vec::new(), 0);
        for place in self.finalists() {
            let Candidate { outputs, is_close, .. } = &self.candidates[place];
            let (outputs, is_close) = (outputs.clone(), *is_close);
            let is_pointless = self.is_no_better_than_any(place, &valid)
                || self.is_no_better_than_any(place, &proved) && !self.is_valid(&outputs, validation);
            if is_pointless || failed == self.budget.failures && place != 0 {
                continue;
            }
            let form = if place == 0 {
                Some(outputs)
            } else if is_close {
                proved_close(self.pool, self.kernel, &outputs, &tolerance()).then_some(outputs)
            } else {
                provable(self.pool, self.kernel, &outputs)
            };
            let Some(place) = form.and_then(|form| self.place_of(form, is_close)) else {
                failed += 1;
                continue;
            };
            if !proved.contains(&place) {
                proved.push(place);
                let outputs = self.candidates[place].outputs.clone();
                valid.extend(self.is_valid(&outputs, validation).then_some(place));
            }
        }
        proved
    }

    /// Whether a form loses no more than the formula at arguments that the search has not seen.
    fn is_valid(&mut self, outputs: &[Expr], validation: &Validation) -> bool {
        if outputs == self.kernel.outputs {
            return true;
        }
        if let Some(known) = self.valid.get(outputs) {
            return *known;
        }
        let form = program(self.pool, self.kernel, outputs);
        let is_valid = form.is_some_and(|form| validation.loses_no_more(&form));
        self.valid.insert(outputs.to_vec(), is_valid);
        is_valid
    }

    fn is_no_better_than_any(&self, place: usize, proved: &[usize]) -> bool {
        proved.iter().any(|&known| self.is_no_better(place, known))
    }

    /// Whether a form costs at least as much as a proved one and loses no fewer bits, in the mean, in
    /// each regime and at the worst sample.
    fn is_no_better(&self, place: usize, proved: usize) -> bool {
        let [form, proved] = [place, proved].map(|place| &self.candidates[place]);
        let loses_more =
            |regime| self.regime_loss(form, regime) + REGIME_STEP >= self.regime_loss(proved, regime);
        form.cost >= proved.cost
            && form.loss + WORTH_A_PROOF >= proved.loss
            && form.worst() + SAMPLE_STEP >= proved.worst()
            && (0..self.samples.len()).all(loses_more)
    }

    /// Returns the forms to prove: those of which none is both cheaper and more accurate, the best
    /// over all samples, then the best of each regime, and the formula.
    fn finalists(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.candidates.len()).collect();
        order.sort_by_key(|&place| self.candidates[place].cost);
        let mut least = f64::INFINITY;
        let mut chosen: Vec<usize> = order
            .iter()
            .copied()
            .filter(|&place| {
                let is_better = self.candidates[place].loss < least - PARETO_STEP;
                least = least.min(self.candidates[place].loss);
                is_better
            })
            .collect();
        chosen.reverse();
        let key = |&place: &usize| (self.candidates[place].loss * 50.0).round() as u64;
        order.sort_by_key(|place| (key(place), self.candidates[*place].cost));
        chosen.truncate(self.budget.proofs);
        chosen.extend(order.into_iter().take(self.budget.proofs));
        for regime in 0..self.samples.len() {
            let best = (0..self.candidates.len()).min_by(|&a, &b| {
                let loss = |place: usize| self.regime_loss(&self.candidates[place], regime);
                loss(a).total_cmp(&loss(b)).then(self.candidates[a].loss.total_cmp(&self.candidates[b].loss))
            });
            chosen.extend(best);
        }
        chosen.push(0);
        let mut seen = FxHashSet::default();
        chosen.retain(|&place| seen.insert(place));
        chosen
    }

    /// Joins the proved forms, each where it is best, at numbers where their error bounds cross, if
    /// that is better than the best single form.
    fn joined(&mut self, proved: &[usize]) -> Option<Vec<Expr>> {
        let points: Vec<&[f64]> = self.points.iter().map(|sample| &sample.arguments[..]).collect();
        let losses: Vec<&[f64]> = proved.iter().map(|&place| &self.candidates[place].losses[..]).collect();
        let forms: Vec<Vec<Expr>> =
            proved.iter().map(|&place| self.candidates[place].outputs.clone()).collect();
        let programs: Vec<Program> =
            forms.iter().filter_map(|form| program(self.pool, self.kernel, form)).collect();
        let programs: Vec<&Program> = programs.iter().collect();
        if programs.len() < forms.len() {
            return None;
        }
        let ranges = ranges(self.pool, self.kernel);
        let cut = cuts(&points, &self.weights, &losses).into_iter().find_map(|cut| {
            let (lower, upper) = ranges[cut.argument];
            let range = (lower.unwrap_or(f64::MIN), upper.unwrap_or(f64::MAX));
            cut.at_crossings(&points, &programs, range)
        })?;
        let forms: Vec<&[Expr]> = forms.iter().map(|form| &form[..]).collect();
        Some(joined(self.pool, self.kernel.arguments[cut.argument], &forms, &cut))
    }

    /// Returns the index of a form among the candidates; the form is added if it is missing.
    fn place_of(&mut self, outputs: Vec<Expr>, is_close: bool) -> Option<usize> {
        let known = self.candidates.iter().position(|known| known.outputs == outputs);
        known.or_else(|| {
            self.largest = usize::MAX;
            self.add(outputs.clone(), is_close);
            self.candidates.iter().position(|known| known.outputs == outputs)
        })
    }

    fn form(&mut self, outputs: &[Expr], is_close: bool, validation: &Validation) -> Option<Form> {
        let place = self.place_of(outputs.to_vec(), is_close)?;
        let known = &self.candidates[place];
        let regimes = self.samples.iter().enumerate();
        let regimes = regimes.map(|(place, regime)| (regime.regime, self.regime_loss(known, place)));
        let program = program(self.pool, self.kernel, &known.outputs)?;
        let Bounds { typical: bound, unsettled } =
            Bounds::of(&program, &self.points, &self.weights, self.samples[0].samples.len());
        Some(Form {
            worst: known.worst(),
            worst_of_normal: validation.most_lost(&program).max(self.worst_of_normal(known)),
            bound,
            unsettled,
            approximation: known.is_close.then(tolerance),
            outputs: known.outputs.clone(),
            loss: known.loss,
            regimes: regimes.collect(),
            cost: known.cost,
        })
    }
}

/// Lowers a form to a program, with sums and products in the order written.
fn program(pool: &Pool, kernel: &Kernel, outputs: &[Expr]) -> Option<Program> {
    let source = KernelSource {
        arguments: kernel.arguments.clone(),
        outputs: outputs.to_vec(),
        ..KernelSource::default()
    };
    Some(lower(pool, &source).ok()?.in_order())
}
