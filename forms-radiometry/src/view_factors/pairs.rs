//! Rows by pairs: exchange areas of all pairs of faces, each pair once.
//!
//! ```text
//! A₁F₁₂ = A₂F₂₁: what one row finds, the rows after it know
//! ```

use super::{Row, ViewFactor, least};
use crate::answer::ErrorKind;
use crate::faces::{faces, is_bright};
use crate::form_factor::{Changes, Exchange, FirstLook, exchange_with, first_look};
use crate::scene::Scene;
use crate::visibility::{Between, Face, Screens};
use crate::watch::Watch;
use rayon::prelude::*;

/// Cost of the exchange of two faces in rays: of a pair that faces away, and of one that nothing
/// hides.
const TURNED: f64 = 0.05;
const FREE: f64 = 4.0;
/// Cost of the exchange of two faces that others partly hide, alone to a tolerance of 10⁻³, with the
/// power by which it falls with the tolerance, and in a sum of many; and the number of occluders that
/// doubles it.
const HIDDEN: f64 = 50.0 * 16.0;
const POWER: f64 = 0.4;
const ROUGH: f64 = 10.0 * 16.0;
const CROWD: f64 = 8.0;
/// Part of its goal that the error of a sum may have: it is a sum of changes.
const CAUTION: f64 = 0.5;
/// Number of pairs that are refined at once.
const AT_ONCE: usize = 64;
/// Number of pairs of faces that the cost of a row is predicted from.
const ASKED: usize = 64;

/// The faces of a scene, and the exchange areas that are known.
pub(super) struct Pairs {
    sides: Vec<Face>,
    screens: Screens,
    /// The indices of the sides of each surface.
    of_surfaces: Vec<Vec<usize>>,
    areas: Vec<f64>,
    /// For each surface, exchange areas that earlier rows have found, with the other surface.
    known: Vec<Vec<(usize, Exchange)>>,
}

/// A pair of faces after a first look.
struct Rough {
    pair: (usize, usize),
    area: f64,
    change: f64,
    doubt: f64,
}

impl Pairs {
    /// Prepares the faces of this tessellation level of disks and spheres.
    pub(super) fn of(scene: &Scene, fineness: usize) -> Self {
        let all = faces(scene, fineness);
        let screens = Screens::of(&all);
        let sides: Vec<Face> = all.into_iter().filter(|face| is_bright(scene, face)).collect();
        let count = scene.surfaces.len();
        let (mut of_surfaces, mut areas) = (vec![Vec::new(); count], vec![0.0; count]);
        for (index, side) in sides.iter().enumerate() {
            of_surfaces[side.surface].push(index);
            areas[side.surface] += side.area;
        }
        Self { sides, screens, of_surfaces, areas, known: vec![Vec::new(); count] }
    }

    /// Returns the area from which a surface sends light.
    pub(super) fn area(&self, surface: usize) -> f64 {
        self.areas[surface]
    }

    /// Predicts the cost of a row to a tolerance, in rays, from some of its pairs.
    pub(super) fn expected_cost(&self, surface: usize, tolerance: f64) -> f64 {
        let own = &self.of_surfaces[surface];
        let pairs = own.len() * self.sides.len();
        let mut between = Vec::new();
        let hidden = if own.len() > 1 { ROUGH } else { HIDDEN * (1e-3 / tolerance).powf(POWER) };
        let mut of_pair = |place: usize| {
            // strides through both lists that visit all parts of them
            let from = &self.sides[own[place * own.len() / ASKED.min(pairs)]];
            let to = &self.sides[place * 37 % self.sides.len()];
            let screens = &self.screens;
            if !screens.face_each_other(&from.vertices, Some(from.normal), &to.vertices, to.normal) {
                return TURNED;
            }
            let normal = Some(from.normal);
            match screens.between(&from.vertices, normal, &to.vertices, to.normal, &mut between) {
                Between::All => TURNED,
                Between::Nothing => FREE,
                Between::Some => hidden * (1.0 + between.len() as f64 / CROWD),
            }
        };
        let asked = ASKED.min(pairs);
        let some: f64 = (0..asked).map(&mut of_pair).sum();
        // half of the pairs are those of another row
        0.5 * pairs as f64 * some / asked.max(1) as f64
    }

    /// Returns the row of a surface to a tolerance; an incomplete one if the work is stopped.
    pub(super) fn row(&mut self, surface: usize, tolerance: f64, watch: &dyn Watch) -> Row {
        let count = self.of_surfaces.len();
        let mut row = vec![Exchange::default(); count];
        let mut is_known = vec![false; count];
        for (other, exchange) in std::mem::take(&mut self.known[surface]) {
            (row[other], is_known[other]) = (exchange, true);
        }
        let missing: Vec<usize> = (0..count).filter(|&other| !is_known[other]).collect();
        let found: Vec<Exchange> =
            missing.par_iter().map(|&other| self.exchange(surface, other, tolerance, watch)).collect();
        for (other, exchange) in missing.into_iter().zip(found) {
            row[other] = exchange;
            if other > surface {
                self.known[other].push((surface, exchange));
            }
        }
        self.factors(surface, row)
    }

    /// Returns the row of a surface, all of it computed again to another tolerance. The other rows
    /// learn nothing from it: they are the same in shards that compute this row or do not.
    pub(super) fn row_again(&self, surface: usize, tolerance: f64, watch: &dyn Watch) -> Row {
        let all = (0..self.of_surfaces.len()).into_par_iter();
        self.factors(surface, all.map(|other| self.exchange(surface, other, tolerance, watch)).collect())
    }

    fn factors(&self, surface: usize, exchanges: Vec<Exchange>) -> Row {
        let area = self.areas[surface];
        let factor =
            |Exchange { area: exchanged, error }| ViewFactor { value: exchanged / area, error: error / area };
        Row { factors: exchanges.into_iter().map(factor).collect(), kind: ErrorKind::Estimate }
    }

    /// Returns the exchange area of two surfaces, which may be the same: the same bits for both
    /// orders.
    fn exchange(&self, one: usize, two: usize, tolerance: f64, watch: &dyn Watch) -> Exchange {
        let (surface, other) = (one.min(two), one.max(two));
        let least = least(self.of_surfaces.len());
        let [own, others] = [surface, other].map(|surface| &self.of_surfaces[surface]);
        if let ([from], [to]) = (&own[..], &others[..]) {
            let [from, to] = [&self.sides[*from], &self.sides[*to]];
            let tolerances = [tolerance, least * from.area.min(to.area)];
            return exchange_with(from, to, &self.screens, tolerances, || watch.is_stopped());
        }
        // the faces of one surface exchange light both ways
        let times = if other == surface { 2.0 } else { 1.0 };
        let is_first = |from: usize, to: usize| other != surface || from < to;
        let pairs = own.iter().flat_map(|&from| others.iter().map(move |&to| (from, to)));
        let pairs = pairs.filter(|&(from, to)| is_first(from, to)).collect();
        let goal =
            |area: f64| tolerance * area.max(least * self.areas[surface].min(self.areas[other]) / times);
        let sum = self.sum(pairs, tolerance, goal, watch);
        Exchange { area: times * sum.area, error: times * sum.error }
    }

    /// Returns the sum over pairs of faces: all pairs by a few points, then those that matter most,
    /// until the sum meets its goal.
    fn sum(
        &self,
        pairs: Vec<(usize, usize)>,
        tolerance: f64,
        goal: impl Fn(f64) -> f64,
        watch: &dyn Watch,
    ) -> Exchange {
        let look = |&(from, to): &(usize, usize)| match watch.is_stopped() {
            true => FirstLook::Certain(Exchange::default()),
            false => first_look(&self.sides[from], &self.sides[to], &self.screens, tolerance),
        };
        let looks: Vec<FirstLook> = pairs.par_iter().map(look).collect();
        let mut sum = Changes::default();
        let mut rough: Vec<Rough> = Vec::new();
        for (pair, look) in pairs.iter().zip(looks) {
            match look {
                FirstLook::Certain(exchange) => sum.add_certain(exchange),
                FirstLook::Rough { area, change, doubt } => {
                    sum.add(area, [change, doubt], 1.0);
                    rough.push(Rough { pair: *pair, area, change, doubt });
                }
            }
        }
        rough.sort_by(|a, b| b.doubt.total_cmp(&a.doubt));
        let finest = [tolerance, goal(sum.area) / tolerance / rough.len().max(1) as f64];
        let finer = |&Rough { pair: (from, to), .. }: &Rough| {
            let [from, to] = [&self.sides[from], &self.sides[to]];
            exchange_with(from, to, &self.screens, finest, || watch.is_stopped())
        };
        for some in rough.chunks(AT_ONCE) {
            if sum.error() <= CAUTION * goal(sum.area) || watch.is_stopped() {
                break;
            }
            let found: Vec<Exchange> = some.par_iter().map(finer).collect();
            for (&Rough { area, change, doubt, .. }, found) in some.iter().zip(found) {
                sum.remove(area, [change, doubt], 1.0);
                sum.add_certain(found);
            }
        }
        Exchange { area: sum.area, error: sum.error() }
    }
}
