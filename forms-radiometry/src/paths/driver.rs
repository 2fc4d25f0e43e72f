//! Path driver: receivers become estimands, and these get more samples until their errors meet the
//! tolerance.
//!
//! ```text
//! receivers ─▶ estimands ─▶ pilot: scales ─▶ replicates ─▶ answers, maps, images
//!                                            │  samples are doubled where the error is too large
//!                                            └─▶ checkpoints, from which the work continues,
//!                                                and shards, which are merged
//! ```
//! An estimand that is computed without samples has its answer from the beginning. The tolerance
//! applies to one standard error, relative to the answer. For the components of a vector and the
//! bins of a time, it is relative to the largest of them. For the cells of a map and the pixels of
//! an image, it is relative to their own value, or to the mean that a pilot found if that is
//! larger. After the pilot, the number of samples of an estimand depends on that estimand alone:
//! not on threads, on pauses, or on the other estimands of the run.

pub(crate) mod analytic;
mod checkpoint;
mod darkness;
mod foresight;
mod neighbours;
mod pixels;
mod prediction;
mod radiances;
pub(crate) mod request;
mod results;
mod scale;

use super::{Limits, PathSampler, World, path_samplers};
use crate::answer::{Moment, Simulation};
use crate::checkpoint::{Keeper, Misfit, Snapshot};
use crate::effects::{EffectSet, SimulatedEffects};
use crate::job::{MOST_SAMPLES, Share};
use crate::progress::Progress;
use crate::radiosity::FirstFaces;
use crate::scene::Scene;
use crate::watch::Watch;
pub(crate) use analytic::Computable;
use analytic::Computing;
pub(crate) use checkpoint::OfPaths;
use neighbours::spreads;
pub(crate) use prediction::{ExpectedRays, expected_rays};
use rayon::prelude::*;
pub(crate) use request::{Division, all_estimands};
use request::{Request, divide_time, requests};
use scale::{Scales, known, of_request, settled};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// World of a scene in working units, the simulated effects, the kinds of receivers that need no
/// samples, and the working unit of length in metres.
#[derive(Clone, Copy)]
pub(crate) struct Task<'s> {
    pub(crate) world: &'s World,
    pub(crate) effects: &'s SimulatedEffects,
    pub(crate) computable: Computable,
    pub(crate) first_faces: &'s FirstFaces,
    pub(crate) metres: f64,
}

/// Simulates a scene, or a part of the work on it, by path tracing.
///
/// # Errors
/// The state does not belong to this scene.
pub(crate) fn simulate(
    task: Task<'_>,
    division: Division,
    (state, keeper): (Option<OfPaths>, Option<&dyn Keeper>),
    progress: &Progress<'_>,
) -> Result<Simulation, Misfit> {
    let Task { world, .. } = task;
    let limits = Limits::of(task.effects);
    let samplers = samplers(task, limits);
    let computing = Computing::of(&world.scene, (task.computable, &limits), task.first_faces, &samplers);
    let mut work = Work::new(task, (division, keeper), &computing, progress);
    if let Some(state) = state {
        work.restore(state)?;
    }
    work.run(&samplers);
    Ok(work.simulation())
}

/// Returns the path tracers of a task, with these limits. Effects that the file turns on are part
/// of the specialised tracer, even where the scene contains none of them.
fn samplers(task: Task<'_>, limits: Limits) -> Vec<Box<dyn PathSampler + '_>> {
    let contained = EffectSet::of_scene(&task.world.scene);
    path_samplers(task.world, contained | task.effects.on, limits)
}

/// Merges the final states of all shards of a scene into its answers.
pub(crate) fn merge(
    task: Task<'_>,
    division: Division,
    parts: Vec<(Share, OfPaths)>,
    progress: &Progress<'_>,
) -> Result<Simulation, Misfit> {
    let mut work = Work::new(task, (division, None), &Computing::nothing(), progress);
    parts.into_iter().try_for_each(|(share, state)| work.take(share, state))?;
    if !work.requests.iter().all(Request::is_answered) {
        return Err(Misfit);
    }
    work.is_done = true;
    work.note();
    Ok(work.simulation())
}

/// State of the path driver.
pub(crate) struct Work<'w> {
    scene: &'w Scene,
    division: Division,
    requests: Vec<Request>,
    /// Scales of the cells, once the pilot has found them.
    scales: Option<Scales>,
    keeper: Option<&'w dyn Keeper>,
    progress: &'w Progress<'w>,
    history: Vec<Moment>,
    is_done: bool,
}

impl<'w> Work<'w> {
    fn new(
        task: Task<'w>,
        (division, keeper): (Division, Option<&'w dyn Keeper>),
        computing: &Computing<'_>,
        progress: &'w Progress<'w>,
    ) -> Self {
        Self {
            scene: &task.world.scene,
            division,
            requests: requests(task, computing),
            scales: None,
            keeper,
            progress,
            history: Vec::new(),
            is_done: false,
        }
    }

    /// Runs rounds of samples until every error meets the tolerance, nothing can be gained, or the
    /// work is stopped.
    fn run(&mut self, samplers: &[Box<dyn PathSampler + '_>]) {
        self.keep_if(true);
        let mut is_noted = true;
        while !self.is_done && self.reach(samplers) {
            // a pilot has many short rounds
            is_noted = self.scales.is_some() || self.division.budget.is_some() || self.history.is_empty();
            if is_noted {
                self.note();
            }
            self.is_done = !self.aim();
        }
        if !(self.is_done && is_noted) {
            self.note();
        }
        self.keep_if(true);
    }

    /// Adds samples to all estimands up to their targets. Returns whether the targets were reached
    /// before the work was stopped.
    fn reach(&mut self, samplers: &[Box<dyn PathSampler + '_>]) -> bool {
        let (division, progress, keeper) = (self.division, self.progress, self.keeper);
        let samples = self.foreseen();
        while self.requests.iter().any(|request| !request.is_there()) {
            // the first estimand runs in any case, so that the work advances under constant pauses
            let has_begun = AtomicBool::new(false);
            let is_stopped = || progress.is_stopped();
            let is_paused = || is_stopped() || keeper.is_some_and(Keeper::is_due);
            let begin = Instant::now();
            let estimands =
                self.requests.par_iter_mut().enumerate().filter(|(_, request)| !request.is_there());
            estimands.for_each(|(estimand, request)| {
                if !(has_begun.swap(true, Ordering::Relaxed) && is_paused()) {
                    let is_meant = |replicate| division.has_replicate(estimand, replicate);
                    let pauses = (is_paused, &is_stopped as &(dyn Fn() -> bool + Sync));
                    request.reach(samplers, is_meant, pauses, |count| samples.add(count, progress));
                }
            });
            divide_time(&mut self.requests, begin);
            if progress.is_stopped() {
                return false;
            }
            self.keep_if(keeper.is_some_and(Keeper::is_due));
        }
        true
    }

    /// Sets new targets: those of the pilot until it has found the scales, then twice as many
    /// samples where the error is too large. Returns whether there are any.
    fn aim(&mut self) -> bool {
        if self.division.budget.is_none() && self.scales.is_none() {
            return self.begin() || self.pilot() || self.refine();
        }
        self.refine()
    }

    /// Sets the first targets, for all cells and for the units of the shard. Returns whether there
    /// are any.
    fn begin(&mut self) -> bool {
        let division = self.division;
        let mut has_begun = false;
        for (estimand, request) in self.requests.iter_mut().enumerate() {
            if request.target == 0
                && request.computed.is_none()
                && (request.cell.is_some() || division.has(estimand))
            {
                request.aim(MOST_SAMPLES);
                has_begun = true;
            }
        }
        has_begun
    }

    /// Requests more samples where these determine the scales; otherwise stores the scales.
    fn pilot(&mut self) -> bool {
        match settled(&self.requests, self.scene.receivers.len(), self.scene.band_count()) {
            Ok(scales) => {
                let spreads = spreads(&self.requests, self.scene);
                self.requests
                    .iter_mut()
                    .zip(spreads)
                    .for_each(|(request, spreads)| request.spreads = spreads);
                self.scales = Some(scales);
                false
            }
            Err(open) => {
                open.into_iter().for_each(|estimand| self.requests[estimand].aim(MOST_SAMPLES));
                true
            }
        }
    }

    /// Requests twice as many samples where the budget is not spent or the error is too large.
    fn refine(&mut self) -> bool {
        let is_open = |&estimand: &usize| {
            let request = &self.requests[estimand];
            match self.division.budget {
                _ if request.computed.is_some() => false,
                Some(budget) => request.replicates.samples < budget.of_replicate(),
                None => {
                    let error = request.error(&self.scales_of(request, self.scales.as_ref()));
                    error > self.scene.solve.tolerance && request.may_go_on()
                }
            }
        };
        let own = (0..self.requests.len()).into_par_iter().filter(|&estimand| self.division.has(estimand));
        let open: Vec<usize> = own.filter(is_open).collect();
        let most = self.division.budget.map_or(MOST_SAMPLES, |budget| budget.of_replicate());
        open.iter().for_each(|&estimand| self.requests[estimand].aim(most));
        !open.is_empty()
    }

    /// Returns the scale of an estimand's tolerance in each band, given these scales of cells.
    fn scales_of(&self, request: &Request, scales: Option<&Scales>) -> Vec<f64> {
        of_request(request, scales, self.scene.band_count())
    }

    fn keep_if(&self, is_time: bool) {
        if let Some(keeper) = self.keeper.filter(|_| is_time) {
            keeper.keep(&Snapshot(self));
        }
    }

    /// Records the present accuracy of the units of the shard.
    fn note(&mut self) {
        let Division { share, budget } = self.division;
        let own = || self.requests.iter().enumerate().filter(|(estimand, _)| self.division.has(*estimand));
        let answered: Vec<&Request> =
            own().map(|(_, request)| request).filter(|request| request.is_answered()).collect();
        let is_told = (budget.is_none() || share.is_whole()) && !answered.is_empty();
        let error = is_told.then(|| {
            let cells = self.scales_of_cells();
            let scales = |request: &Request| self.scales_of(request, Some(&cells));
            answered.par_iter().map(|request| request.error(&scales(request))).reduce(|| 0.0, f64::max)
        });
        let seconds = self.progress.seconds();
        self.history.extend(error.map(|error| Moment { seconds, error }));
    }

    /// Returns the scales of cells: those of the pilot, or an estimate from all samples so far.
    fn scales_of_cells(&self) -> Scales {
        let all = || known(&self.requests, self.scene.receivers.len(), self.scene.band_count());
        self.scales.clone().unwrap_or_else(all)
    }

    fn simulation(self) -> Simulation {
        Simulation {
            answers: self.answers(),
            maps: self.maps(),
            stopped: !self.is_done,
            seconds: self.progress.seconds(),
            history: self.history,
            ..Simulation::default()
        }
    }
}
