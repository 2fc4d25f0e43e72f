//! Numbers of a simulation, compared with means of paths.

use crate::sequence::Sampler;
use crate::tracer::Tracer;
use crate::world::{Kind, LIGHT, World};
use forms_radiometry::scene::read_with_files;
use forms_radiometry::simulation::{ErrorKind, Quantity, Unwatched, plan, simulate};
use rayon::prelude::*;
use std::fmt;

/// Number of random shifts of the sequence.
const SHIFTS: u64 = 16;
/// Smallest and largest number of paths of a shift.
const FEWEST: usize = 1 << 6;
const MOST: usize = if cfg!(debug_assertions) { 1 << 9 } else { 1 << 14 };
/// Standard error of paths that is small enough, relative to the error that is judged.
const EXACT: f64 = 0.1;
/// Allowed deviation, in standard errors of paths.
const SURE: f64 = 4.0;
/// An event that n paths have never met is rarer than this over n.
const UNSEEN: f64 = 9.2;

/// Result of one comparison.
pub(crate) struct Judged {
    pub(crate) kind: ErrorKind,
    /// Lower bound on its deviation, in units of its error.
    times: f64,
    pub(crate) what: String,
}

impl Judged {
    /// Whether it is off by more than its error.
    pub(crate) fn is_outside(&self) -> bool {
        self.times > 1.0
    }
}

/// Number of the simulation.
pub(crate) struct Number {
    pub(crate) receiver: usize,
    pub(crate) quantity: Quantity,
    pub(crate) cell: Option<[usize; 2]>,
    pub(crate) bin: Option<usize>,
    pub(crate) value: f64,
    pub(crate) error: f64,
    pub(crate) kind: ErrorKind,
}

/// Compares numbers with paths.
pub(crate) fn judge(world: &World, numbers: &[Number], seed: u64) -> Vec<Judged> {
    let tracer = Tracer::new(world);
    numbers.iter().map(|number| compared(world, &tracer, number, seed)).collect()
}

/// Returns the numbers that a world asks for.
pub(crate) fn numbers(world: &World, tolerance: f64) -> Vec<Number> {
    let (text, files) = world.text(tolerance);
    let file = |name: &str| Ok(files[name].clone().into_bytes());
    let scene =
        read_with_files(&text, "scene.toml", &file).unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]));
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]));
    let found = simulate(&plan, &Unwatched);
    let index = |name: &str| name.parse::<usize>().expect("the number of a receiver");
    let of_answers =
        found.answers.iter().filter(|answer| answer.quantity != Quantity::Flux).map(|answer| Number {
            receiver: index(&answer.receiver),
            quantity: answer.quantity,
            cell: None,
            bin: answer.bin,
            value: answer.value,
            error: answer.error,
            kind: answer.kind,
        });
    let is_image = |receiver: &usize| matches!(world.receivers[*receiver].kind, Kind::Camera { .. });
    let of_maps = found.maps.iter().flat_map(|map| {
        (0..map.values[0].len()).map(move |cell| Number {
            receiver: index(&map.receiver),
            quantity: map.quantity,
            cell: Some([cell % map.size[0], cell / map.size[0]]),
            bin: None,
            value: map.values[0][cell],
            error: map.errors[0][cell],
            kind: map.kind,
        })
    });
    of_answers.filter(|number| !is_image(&number.receiver)).chain(of_maps).collect()
}

/// Compares a number with paths: as many as are needed to decide whether it is right.
fn compared(world: &World, tracer: &Tracer, number: &Number, seed: u64) -> Judged {
    let Number { value, error, kind, .. } = *number;
    let mut samplers: Vec<Sampler> = (0..SHIFTS).map(|shift| Sampler::new(seed * SHIFTS + shift)).collect();
    let mut sums = vec![0.0; samplers.len()];
    let mut paths = 0;
    let mut more = FEWEST;
    loop {
        samplers.par_iter_mut().zip(&mut sums).for_each(|(sampler, sum)| {
            for _ in 0..more {
                *sum += sample(world, tracer, number, sampler);
                sampler.advance();
            }
        });
        paths += more;
        let means: Vec<f64> = sums.iter().map(|sum| sum / paths as f64).collect();
        let mean = means.iter().sum::<f64>() / SHIFTS as f64;
        let squares: f64 = means.iter().map(|one| (one - mean).powi(2)).sum();
        let sigma = (squares / (SHIFTS * (SHIFTS - 1)) as f64).sqrt();
        let off = (value - mean).abs();
        // rounding of both sums
        let noise = SURE * sigma + 1e-12 * mean.abs();
        let is_clear = off + noise <= error || sigma <= EXACT * error;
        if is_clear || paths >= MOST {
            // light that no path has met is rare, and may be bright
            let unseen = UNSEEN * world.brightest() / (SHIFTS as f64 * paths as f64);
            let (allowed, sure) = match kind {
                ErrorKind::Sigma => ((error * error + sigma * sigma).sqrt(), unseen),
                _ => (error, noise + unseen),
            };
            let times = match off - sure {
                _ if value.is_nan() || error.is_nan() || mean.is_nan() => f64::INFINITY,
                beyond if beyond > 0.0 => beyond / allowed,
                _ => 0.0,
            };
            let what = format!(
                "receiver {} {:?} {:?} {:?}: {value} ± {error:.3e} {kind:?}, paths say {mean} ± {sigma:.3e}: {times:.2} errors",
                number.receiver, number.quantity, number.cell, number.bin
            );
            return Judged { kind, times, what };
        }
        more = paths;
    }
}

fn sample(world: &World, tracer: &Tracer, number: &Number, sampler: &mut Sampler) -> f64 {
    let receiver = &world.receivers[number.receiver];
    let mut sum = 0.0;
    tracer.sample(&receiver.kind, number.cell, sampler, &mut |way, length, value| {
        let along = match number.quantity {
            Quantity::VectorIrradiance(axis) => -[way.x, way.y, way.z][axis],
            _ => 1.0,
        };
        let is_then = receiver.time.is_none_or(|bins| {
            let bin = length / LIGHT / bins.width;
            bin.is_finite() && Some(bin as usize) == number.bin
        });
        if is_then {
            sum += along * value;
        }
    });
    sum
}

/// Returns the promises of a kind of error: for a number of errors, the part of numbers that may be
/// off by more.
fn promises(kind: ErrorKind) -> &'static [(f64, f64)] {
    match kind {
        ErrorKind::Bound => &[(1.0, 0.0)],
        ErrorKind::Estimate => &[(1.0, 0.02), (3.0, 0.0)],
        // 68.27 % of a normal distribution lie within one standard error; light found by few of the
        // paths, as through mirrors, makes the tail longer
        ErrorKind::Sigma => &[(1.0, 0.3173), (3.0, 0.05)],
    }
}

/// For each kind of error, the deviations of its numbers in units of their errors.
#[derive(Default)]
pub(crate) struct Tally(Vec<(ErrorKind, Vec<f64>)>);

impl Tally {
    pub(crate) fn add(&mut self, judged: &Judged) {
        match self.0.iter_mut().find(|(kind, _)| *kind == judged.kind) {
            Some((_, all)) => all.push(judged.times),
            None => {
                self.0.push((judged.kind, vec![judged.times]));
                self.0.sort_by_key(|(kind, _)| *kind);
            }
        }
    }

    /// Returns the kinds that are off more often, or by more, than they promise. Three standard
    /// deviations of a binomial distribution are attributed to chance.
    pub(crate) fn broken(&self) -> Vec<ErrorKind> {
        let is_broken = |&&(kind, ref all): &&(ErrorKind, Vec<f64>)| {
            promises(kind).iter().any(|&(times, part)| {
                let expected = part * all.len() as f64;
                beyond(all, times) as f64 > expected + 3.0 * (expected * (1.0 - part)).sqrt()
            })
        };
        self.0.iter().filter(is_broken).map(|(kind, _)| *kind).collect()
    }
}

/// Counts the numbers that are off by more errors than this.
fn beyond(all: &[f64], times: f64) -> usize {
    all.iter().filter(|&&one| one > times).count()
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (kind, all) in &self.0 {
            let most = all.iter().copied().fold(0.0, f64::max);
            let [outside, far] = [1.0, 3.0].map(|times| beyond(all, times));
            writeln!(
                f,
                "{}: of {} numbers {outside} outside, {far} by more than 3 errors, one by {most:.2}",
                kind.name(),
                all.len()
            )?;
        }
        Ok(())
    }
}
