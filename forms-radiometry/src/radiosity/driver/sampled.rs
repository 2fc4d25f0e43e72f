//! Sampled answers: readings become probes. Probes that are not accurate enough get more rays and
//! paths, until all are, or none is allowed more.

use super::estimate::{Estimate, Found};
use super::grid::Grid;
use super::readings::Reading;
use super::{ROUNDING, Work};
use crate::answer::{DARK, ErrorKind, ErrorParts, Map, Moment};
use crate::progress::Outlook;
use crate::radiosity::{FinalGathering, GoalKind, Measure, Probe};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// Part of the tolerance that the tessellation of curved shapes leaves for rays.
const BESIDE_SHAPE: f64 = 0.5;

/// Part of the mean of all cells that becomes the scale of a map, where this mean is less than the
/// watched cells indicated.
const BELOW: f64 = 0.97;

/// Part of the largest number of rays after which the required number is predicted.
const SEEN: f64 = 0.02;

/// A reading, and its probe if anything has to be sampled for it.
struct Sampled {
    probe: Option<Probe>,
    /// Index of the reading whose probe it uses: its own, or for a flux that of the mean irradiance
    /// before it.
    of: usize,
    /// For each band, the offset and the factor that turn the value of the probe into the reading.
    made_of: Vec<[f64; 2]>,
    /// Seconds that it took in the last loop.
    seconds: f64,
}

impl Work<'_> {
    /// Returns the readings, as accurate as requested or as possible; less accurate if that would
    /// take more than `most` rays.
    pub(crate) fn sampled(
        &self,
        paths: &FinalGathering,
        is_round: bool,
        most: f64,
        history: &mut Vec<Moment>,
    ) -> Vec<Found> {
        let tolerance = self.scene.solve.tolerance * if is_round { BESIDE_SHAPE } else { 1.0 };
        let transport = paths.transport();
        let goals: Vec<Option<GoalKind>> =
            self.readings.iter().map(|reading| reading.goal(self.scene, transport)).collect();
        let first = |(index, reading): (usize, &Reading)| {
            let begin = Instant::now();
            let is_shared = index > 0
                && self.readings[index - 1].receiver == reading.receiver
                && goals[index - 1] == goals[index]
                && index < self.answers;
            let goal = goals[index].filter(|_| !is_shared);
            let probe = goal.map(|what| paths.probe(what, index as u64));
            let made_of = reading.made_of(self.scene, transport);
            Sampled {
                probe,
                of: index - usize::from(is_shared),
                made_of,
                seconds: begin.elapsed().as_secs_f64(),
            }
        };
        // maps, or finer faces, may follow
        let has_more = is_round || self.readings.len() > self.answers;
        self.progress.begin(if has_more { Outlook::Stages(2) } else { Outlook::Doubtful });
        let begin = Instant::now();
        let mut sampled: Vec<Sampled> = self.readings.par_iter().enumerate().map(first).collect();
        self.took(begin, &mut sampled);
        loop {
            let found = self.found(&sampled);
            let error = self.relative_errors(&found).fold(0.0, f64::max);
            history.push(Moment { seconds: self.progress.seconds(), error });
            if self.watch.is_stopped() {
                return found;
            }
            let [spent, foreseen] = self.rays(&sampled, &found);
            self.watch.progress("receivers", spent / foreseen);
            if error <= tolerance
                || spent > most
                || (spent > SEEN * most && foreseen > most)
                || !self.improve(paths, &mut sampled, &found, tolerance)
            {
                return found;
            }
        }
    }

    /// Returns the number of rays so far, and the predicted number at the end: errors fall as the
    /// inverse square root of that number.
    fn rays(&self, sampled: &[Sampled], found: &[Found]) -> [f64; 2] {
        let spent = |sampled: &Sampled| sampled.probe.as_ref().map_or(0.0, Probe::spent);
        let all: f64 = sampled.iter().map(spent).sum();
        let needed = |((sampled, found), scales): ((&Sampled, &Found), Vec<f64>)| {
            let relative = found.bands.iter().zip(scales).map(|(e, scale)| e.error() / scale);
            let worst = relative.fold(0.0, f64::max) / self.scene.solve.tolerance;
            spent(sampled) * worst.powi(2).max(1.0)
        };
        [all, sampled.iter().zip(found).zip(self.targets(found)).map(needed).sum()]
    }

    /// Adds to the times of receivers a loop over their readings that began at this time.
    fn took(&self, begin: Instant, sampled: &mut [Sampled]) {
        let receivers = self.readings.iter().map(|reading| reading.receiver);
        self.times.add(begin, receivers.zip(sampled.iter().map(|sampled| sampled.seconds)));
        sampled.iter_mut().for_each(|sampled| sampled.seconds = 0.0);
    }

    /// Adds rays to the readings that are not accurate enough. Returns whether any is
    /// allowed more.
    fn improve(
        &self,
        paths: &FinalGathering,
        sampled: &mut [Sampled],
        found: &[Found],
        tolerance: f64,
    ) -> bool {
        let scales = self.targets(found);
        let one = |((sampled, found), scales): ((&mut Sampled, &Found), Vec<f64>)| {
            let is_enough = found.bands.iter().zip(&scales).all(|(e, scale)| e.error() <= tolerance * scale);
            let Some(probe) = sampled.probe.as_mut().filter(|_| !is_enough) else { return false };
            let begin = Instant::now();
            let of_probe: Vec<f64> =
                scales.iter().zip(&sampled.made_of).map(|(scale, [_, factor])| scale / factor).collect();
            let improved = paths.improve(probe, &of_probe);
            sampled.seconds = begin.elapsed().as_secs_f64();
            improved
        };
        let begin = Instant::now();
        let readings = sampled.par_iter_mut().zip(found).zip(scales);
        let is_improved = readings.map(one).reduce(|| false, |a, b| a || b);
        self.took(begin, sampled);
        is_improved
    }

    fn found(&self, sampled: &[Sampled]) -> Vec<Found> {
        let one = |Sampled { of, made_of, .. }: &Sampled| {
            let probe = &sampled[*of].probe;
            let of_band = |(band, [offset, factor]): (usize, &[f64; 2])| {
                let value = offset + factor * probe.as_ref().map_or(0.0, |probe| probe.value(band));
                let rounding = ROUNDING * value.abs();
                let of_probe = |[sampling, orders]: [f64; 2]| ErrorParts {
                    rounding,
                    orders: factor * orders,
                    sampling: factor * sampling,
                    ..ErrorParts::default()
                };
                Estimate::exact(value, of_probe(probe.as_ref().map_or([0.0; 2], |probe| probe.errors(band))))
            };
            let bands = made_of.iter().enumerate().map(of_band).collect();
            Found { bands, has_pieces: true }
        };
        sampled.iter().map(one).collect()
    }

    /// Returns the maps. Each cell is sampled until it is accurate enough relative to the mean of
    /// the watched cells, or relative to the mean of all cells where that is less.
    pub(crate) fn sampled_maps(
        &self,
        paths: &FinalGathering,
        grids: &[(usize, Grid)],
        found: &[Found],
    ) -> Vec<(usize, Map)> {
        let dark = DARK * self.scales(found).into_iter().flatten().fold(0.0, f64::max);
        let map = |&(receiver, ref grid): &(usize, Grid)| {
            let begin = Instant::now();
            let map = self.scaled_map(paths, (receiver, grid), found, dark);
            self.times.add_since(begin, receiver);
            (receiver, map)
        };
        grids.iter().map(map).collect()
    }

    /// Returns the map of a receiver. Scales below `dark` are raised to it.
    fn scaled_map(
        &self,
        paths: &FinalGathering,
        (receiver, grid): (usize, &Grid),
        found: &[Found],
        dark: f64,
    ) -> Map {
        let told = self.watched(receiver, found).into_iter().flatten().map(|watched| watched.scale);
        let mut scales: Vec<f64> = told.collect();
        scales.resize(self.scene.band_count(), 0.0);
        scales.iter_mut().for_each(|scale| *scale = scale.max(dark));
        let mut cells = self.sampled_cells(paths, receiver, grid);
        loop {
            self.improve_cells(paths, &mut cells, &scales);
            let map = self.sampled_map(receiver, grid, &cells);
            let is_kept = |(own, all): (&f64, &f64)| *own <= all.max(dark);
            if self.watch.is_stopped() || scales.iter().zip(&map.scales).all(is_kept) {
                return map;
            }
            let both = scales.iter_mut().zip(&map.scales);
            both.for_each(|(own, all)| *own = own.min((BELOW * all).max(dark)));
        }
    }

    /// Returns the probes of all cells of a map.
    fn sampled_cells(&self, paths: &FinalGathering, receiver: usize, grid: &Grid) -> Vec<Option<Probe>> {
        let cell = |(index, position): (usize, &Option<crate::geometry::Vector>)| {
            let position = position.filter(|_| !self.watch.is_stopped())?;
            let what = GoalKind::At { position, measure: Measure::Plane(grid.normal()) };
            Some(paths.probe(what, ((receiver as u64 + 1) << 32) + index as u64))
        };
        grid.cells().par_iter().enumerate().map(cell).collect()
    }

    /// Adds rays to the cells that are not accurate enough relative to the scales of their map.
    /// Cells that are still not accurate enough when the work is stopped become unknown.
    fn improve_cells(&self, paths: &FinalGathering, cells: &mut [Option<Probe>], of_map: &[f64]) {
        let tolerance = self.scene.solve.tolerance;
        let (count, done) = (cells.len(), AtomicUsize::new(0));
        let improve = |cell: &mut Option<Probe>| {
            let Some(probe) = cell else { return };
            let scales = |probe: &Probe| -> Vec<f64> {
                let of_band = |(band, scale): (usize, &f64)| scale.max(probe.value(band).abs());
                of_map.iter().enumerate().map(of_band).collect()
            };
            let is_enough = |probe: &Probe| {
                let of_band = |(band, scale): (usize, f64)| probe.found(band)[1] <= tolerance * scale;
                scales(probe).into_iter().enumerate().all(of_band)
            };
            while !is_enough(probe) && paths.improve(probe, &scales(probe)) {}
            if self.watch.is_stopped() && !is_enough(probe) {
                *cell = None;
                return;
            }
            let done = done.fetch_add(1, Ordering::Relaxed);
            self.watch.progress("maps", done as f64 / count as f64);
        };
        cells.par_iter_mut().for_each(improve);
    }

    fn sampled_map(&self, receiver: usize, grid: &Grid, cells: &[Option<Probe>]) -> Map {
        let of_band = |band: usize, part: usize| {
            let of_cell =
                |cell: &Option<Probe>| cell.as_ref().map_or(f64::NAN, |probe| probe.found(band)[part]);
            cells.iter().map(of_cell).collect()
        };
        let all = |part: usize| (0..self.scene.band_count()).map(|band| of_band(band, part)).collect();
        self.finished_map(receiver, (grid, all(0), all(1)), ErrorKind::Confidence)
    }
}
