//! Maps of a simulation: receivers with a grid become cells, of which some are watched while
//! elements are refined, and these become maps. The error of a cell is the largest error of the
//! watched cells, each relative to its scale (see [`scales`](super::scales)).

use super::Work;
use super::estimate::Found;
use super::grid::Grid;
use super::readings::{OF_PRODUCT, Reading, groups};
use super::scales::{Watched, mean_scale};
use crate::answer::{ErrorKind, Map, Quantity};
use crate::parallelism::Parallelism;
use crate::progress::times::timed;
use crate::radiosity::{Group, Lights, Radiosity, Scratch, Transport};
use crate::scene::ReceiverKind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// One in this many cells of a map is watched while elements are refined, but at least this many
/// cells.
const WATCHED: [usize; 2] = [36, 25];
/// Allowed error of interpolated cells, as a part of the error that a cell has anyway.
const INTERPOLATED: f64 = 0.1;

impl Work<'_> {
    /// Returns the requested maps: the index of the receiver, and its cells.
    pub(crate) fn grids(&self, transport: &Transport) -> Vec<(usize, Grid)> {
        let receivers = self.scene.receivers.iter().enumerate();
        let grid = |(index, receiver): (usize, &crate::scene::Receiver)| {
            let ReceiverKind::Surface { surface, grid: Some(size), .. } = receiver.kind else { return None };
            let (side, shape) = (receiver.kind.side()?, &self.scene.surfaces[surface].shape);
            Grid::over(transport, (side, shape), size).map(|grid| (index, grid))
        };
        receivers.filter_map(grid).collect()
    }

    /// Adds readings in some cells of each of these maps and in some pixels of each image. Elements
    /// are refined until these are accurate enough, and maps get their errors from them.
    pub(crate) fn watch_some(&mut self, grids: &[(usize, Grid)], sight: &Transport) {
        for (index, grid) in grids {
            let reading = |cell| Reading::irradiance(*index, cell, grid.normal());
            self.readings.extend(grid.some(WATCHED).map(reading));
        }
        self.emitted = vec![Vec::new(); self.readings.len() - self.requested];
        let pixels = self.watched_pixels();
        let seen = self.question().seen_part();
        let emitted = |reading: &Reading| {
            let of_band = |[emitted, _]: [f64; 2]| seen * emitted;
            reading.made_of(self.scene, sight).into_iter().map(of_band).collect()
        };
        self.emitted.extend(pixels.iter().map(emitted).collect::<Vec<_>>());
        self.readings.extend(pixels);
        self.groups = groups(&self.readings, self.answers);
    }

    /// Gathers direct light in the cells of each map, cell by cell and band by band; NaN where the
    /// work was stopped before. The cells of all maps are processed in one loop: between small
    /// loops threads would wait.
    pub(crate) fn straight(
        &self,
        grids: &[(usize, Grid)],
        lights: &Lights,
        transport: &Transport,
    ) -> Vec<Vec<f64>> {
        let bands = self.scene.band_count();
        let is_asked = self.question().direct;
        let each = |scratch: &mut Scratch, (receiver, (group, values)): (usize, (Group, &mut [f64]))| {
            let begin = Instant::now();
            if is_asked && !self.watch.is_stopped() && !group.points.is_empty() {
                lights.gather(group, transport, scratch, values);
            }
            if self.watch.is_stopped() {
                values.fill(f64::NAN);
            }
            (receiver, begin.elapsed().as_secs_f64())
        };
        let mut gathered: Vec<Vec<f64>> =
            grids.iter().map(|(_, grid)| vec![0.0; bands * grid.count()]).collect();
        let mut parts = Vec::new();
        for ((receiver, grid), gathered) in grids.iter().zip(&mut gathered) {
            parts.extend(grid.parts(bands, gathered).into_iter().map(|part| (*receiver, part)));
        }
        let cells = grids.iter().map(|(_, grid)| grid.count()).sum();
        let begin = Instant::now();
        let seconds = Parallelism::of(lights.operations(cells, transport)).map(parts, each);
        self.times.add(begin, seconds.into_iter());
        grids.iter().zip(gathered).map(|((_, grid), gathered)| grid.all_cells(bands, &gathered)).collect()
    }

    /// Returns the maps with the indices of their receivers, given the direct light of their cells.
    pub(crate) fn maps(
        &self,
        radiosity: &Radiosity,
        (grids, straight): (&[(usize, Grid)], Vec<Vec<f64>>),
        found: &[Found],
    ) -> Vec<(usize, Map)> {
        let cells: usize = grids.iter().map(|(_, grid)| grid.count()).sum();
        let done = AtomicUsize::new(0);
        let note = |computed: usize| {
            let part = done.fetch_add(computed, Ordering::Relaxed) as f64 / cells as f64;
            self.watch.progress("maps", part);
        };
        let map = |_: &mut (), (&(receiver, ref grid), straight): (&(usize, Grid), Vec<f64>)| {
            timed(|| (receiver, self.map(radiosity, (receiver, grid, straight), found, &note)))
        };
        let parallelism = if radiosity.is_reflected() { Parallelism::Shared } else { Parallelism::Alone };
        let begin = Instant::now();
        let maps = parallelism.map(grids.iter().zip(straight).collect::<Vec<_>>(), map);
        self.times.add(begin, maps.iter().map(|((receiver, _), seconds)| (*receiver, *seconds)));
        maps.into_iter().map(|(map, _)| map).collect()
    }

    /// Computes the map of a receiver, cell by cell.
    fn map(
        &self,
        radiosity: &Radiosity,
        (receiver, grid, straight): (usize, &Grid, Vec<f64>),
        found: &[Found],
        note: &(dyn Fn(usize) + Sync),
    ) -> Map {
        let watched = self.watched(receiver, found);
        let interpolated = |watched: &Watched| INTERPOLATED * watched.error(0.0);
        let nothing = || vec![0.0; self.scene.band_count()];
        let allowed = watched.as_ref().map_or_else(nothing, |bands| bands.iter().map(interpolated).collect());
        let values = grid.irradiance(radiosity, (straight, &allowed), self.watch, note);
        let rounding = radiosity.lights().rounding_within(grid.ball(), radiosity.transport());
        let errors = |(band, values): (usize, &Vec<f64>)| {
            // where no cell is watched, closed forms leave only rounding
            let brightest = values.iter().fold(0.0, |m: f64, value| m.max(value.abs()));
            let of_closed_forms = OF_PRODUCT * brightest + rounding[band];
            let error = |&value: &f64| {
                let of_elements = watched.as_ref().map(|bands| bands[band].error(value) + allowed[band]);
                if value.is_nan() { f64::NAN } else { of_elements.unwrap_or(of_closed_forms) }
            };
            values.iter().map(error).collect()
        };
        let errors = values.iter().enumerate().map(errors).collect();
        let kind = if watched.is_some() { ErrorKind::Estimate } else { ErrorKind::Bound };
        // an emitter is visible in no cell
        let scale =
            |values: &Vec<f64>| mean_scale(values.iter().filter(|v| !v.is_nan()).map(|&v| (v, false)));
        let scales = values.iter().map(scale).collect();
        Map::of_cells(&self.scene.receivers[receiver], Quantity::Irradiance, (values, errors, scales), kind)
    }
}
