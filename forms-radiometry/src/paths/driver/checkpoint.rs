//! Checkpoints of the path driver: sums and numbers of samples, from which the work continues as if
//! it had never stopped.

use super::Work;
use super::analytic::Computed;
use super::neighbours::Spread;
use super::request::{Division, Request};
use super::scale::Scales;
use crate::answer::Moment;
use crate::checkpoint::{Content, Kind, Misfit};
use crate::job::Share;
use crate::paths::{KeptSums, WrittenSums};
use serde::{Deserialize, Serialize};
use std::io::{self, Write};

/// State that was written before.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct OfPaths {
    is_done: bool,
    scales: Option<Scales>,
    history: Vec<[f64; 2]>,
    seconds: f64,
    requests: Vec<KeptRequest>,
}

#[derive(Clone, Debug, Deserialize)]
struct KeptRequest {
    target: u32,
    samples: u32,
    spreads: Vec<Spread>,
    seconds: f64,
    computed: Option<Vec<Computed>>,
    sums: KeptSums,
}

/// Serialised form of an [`OfPaths`].
#[derive(Serialize)]
struct WrittenOfPaths<'w> {
    is_done: bool,
    scales: &'w Option<Scales>,
    history: Vec<[f64; 2]>,
    seconds: f64,
    requests: Vec<WrittenRequest<'w>>,
}

#[derive(Serialize)]
struct WrittenRequest<'w> {
    target: u32,
    samples: u32,
    spreads: &'w [Spread],
    seconds: f64,
    computed: Option<&'w [Computed]>,
    sums: WrittenSums<'w>,
}

impl Content for Work<'_> {
    fn is_done(&self) -> bool {
        self.is_done
    }

    fn units(&self) -> [usize; 2] {
        self.division.units(self.requests.len())
    }

    fn write(&self, output: &mut dyn Write) -> io::Result<()> {
        Kind::<_, ()>::Paths(self.written()).write(output)
    }
}

impl Work<'_> {
    /// Returns the state, to be written.
    fn written<'s>(&'s self) -> WrittenOfPaths<'s> {
        let division = self.division;
        let request = |(estimand, request): (usize, &'s Request)| {
            // once the work is done, nobody needs the pilot's results for other shards
            let is_kept = !self.is_done || division.has(estimand);
            let is_meant = |replicate| division.has_replicate(estimand, replicate);
            WrittenRequest {
                target: if is_kept { request.target } else { 0 },
                samples: if is_kept { request.replicates.samples } else { 0 },
                spreads: if is_kept { &request.spreads } else { &[] },
                seconds: request.seconds,
                computed: request.computed.as_deref().filter(|_| is_kept),
                sums: if is_kept { request.replicates.kept(is_meant) } else { Vec::new() },
            }
        };
        let history = self.history.iter().map(|moment| [moment.seconds, moment.error]);
        WrittenOfPaths {
            is_done: self.is_done,
            scales: &self.scales,
            history: history.collect(),
            seconds: self.progress.seconds(),
            requests: self.requests.iter().enumerate().map(request).collect(),
        }
    }
}

impl OfPaths {
    /// Whether all work is done.
    pub(crate) fn is_done(&self) -> bool {
        self.is_done
    }

    /// Whether two states are equal, except for times.
    pub(crate) fn is_same_as(&self, other: &Self) -> bool {
        let is_same = |(a, b): (&KeptRequest, &KeptRequest)| {
            (a.target, a.samples) == (b.target, b.samples) && a.computed == b.computed && a.sums == b.sums
        };
        (self.is_done, &self.scales) == (other.is_done, &other.scales)
            && self.requests.len() == other.requests.len()
            && self.requests.iter().zip(&other.requests).all(is_same)
    }
}

impl Work<'_> {
    /// Continues from a state.
    pub(crate) fn restore(&mut self, state: OfPaths) -> Result<(), Misfit> {
        if state.requests.len() != self.requests.len() {
            return Err(Misfit);
        }
        for (estimand, (request, kept)) in self.requests.iter_mut().zip(state.requests).enumerate() {
            (request.target, request.spreads, request.seconds) = (kept.target, kept.spreads, kept.seconds);
            if kept.computed.is_some() {
                request.computed = kept.computed;
            }
            let is_meant = |replicate| self.division.has_replicate(estimand, replicate);
            if !request.replicates.restore(kept.samples, kept.sums, is_meant) {
                return Err(Misfit);
            }
        }
        self.scales = state.scales;
        let moment = |[seconds, error]: [f64; 2]| Moment { seconds, error };
        self.history = state.history.into_iter().map(moment).collect();
        self.progress.resume(state.seconds);
        Ok(())
    }

    /// Takes the part that belongs to a shard from its final state.
    pub(crate) fn take(&mut self, share: Share, state: OfPaths) -> Result<(), Misfit> {
        if state.requests.len() != self.requests.len() || !state.is_done {
            return Err(Misfit);
        }
        let division = Division { share, ..self.division };
        for (estimand, (request, kept)) in self.requests.iter_mut().zip(state.requests).enumerate() {
            request.seconds += kept.seconds;
            if division.has(estimand) {
                (request.computed, request.spreads) = (kept.computed, kept.spreads);
            }
            let is_meant = |replicate| division.has_replicate(estimand, replicate);
            if division.has(estimand) && !request.replicates.restore(kept.samples, kept.sums, is_meant) {
                return Err(Misfit);
            }
        }
        // every share repeats the pilot, and finds the same
        self.scales = state.scales;
        self.progress.resume(state.seconds);
        Ok(())
    }
}
