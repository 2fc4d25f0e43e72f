//! Importance: for each element, the change of the goals by a uniform irradiance of the element,
//! over all reflections (adjoint solution).
//!
//! ```text
//! z = w + Gᵀ z        w the direct contributions of the nodes to the goals
//! ```

use super::measure::Measure;
use super::solution::Reflection;
use super::system::Radiosity;
use super::transport::{Group, Scratch};
use crate::geometry::Vector;
use crate::visibility::{Face, ReceivingArea};
use rayon::prelude::*;

/// Number of reflections over which importance is propagated.
const MOST_REFLECTIONS: usize = 24;

/// Part of the importance below which a reflection ends it, unless it reaches more nodes: it only
/// says which elements are split next.
const ENOUGH: f64 = 1e-2;

/// Number of parts that the goals are divided into for parallel evaluation.
const PARTS: usize = 32;

/// A number requested from the solution, and the weight of its error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Goal {
    pub(crate) what: GoalKind,
    pub(crate) weight: f64,
}

/// Kinds of goals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum GoalKind {
    /// Light at a point.
    At { position: Vector, measure: Measure },
    /// Integral of the irradiance over an area.
    Mean { area: ReceivingArea },
}

impl Radiosity<'_> {
    /// Returns the change of the goals by a uniform irradiance of each element, over all
    /// reflections; only part of it if the work is stopped.
    pub(super) fn importance(&self, goals: &[Goal]) -> Vec<f64> {
        self.importance_and_sums(goals, &vec![[0.0; 2]; self.elements.len()]).0
    }

    /// Returns the importance of each element. Also returns for each goal the sums over elements of
    /// pairs of numbers, each times the direct contribution of the element to the goal.
    pub(super) fn importance_and_sums(
        &self,
        goals: &[Goal],
        of_elements: &[[f64; 2]],
    ) -> (Vec<f64>, Vec<[f64; 2]>) {
        let bands = 0..self.scene.band_count();
        let of = |element| bands.clone().map(|band| self.reflectance(element, band)).fold(0.0, f64::max);
        let strongest: Vec<f64> = self.elements.iter().map(of).collect();
        // the sums are over the same goals in the same order, whatever the number of threads
        let of_some = |goals: &[Goal]| {
            let (mut scratch, mut straight) = (Scratch::default(), vec![0.0; self.size()]);
            let mut sums = |goal: &Goal| {
                let mut sums = [0.0; 2];
                self.each_straight(goal, &strongest, &mut scratch, |source, weights| {
                    let mut whole = 0.0;
                    for (node, weight) in straight[self.first[source]..].iter_mut().zip(weights) {
                        *node += weight;
                        whole += weight;
                    }
                    sums.iter_mut().zip(of_elements[source]).for_each(|(sum, number)| *sum += whole * number);
                });
                sums
            };
            let sums: Vec<[f64; 2]> = goals.iter().map(&mut sums).collect();
            (straight, sums)
        };
        let parts = goals.par_chunks(goals.len().div_ceil(PARTS).max(1)).map(of_some);
        let (parts, sums): (Vec<Vec<f64>>, Vec<Vec<[f64; 2]>>) = parts.unzip();
        let mut straight = vec![0.0; self.size()];
        for part in parts {
            straight.iter_mut().zip(part).for_each(|(sum, value)| *sum += value);
        }
        let orders = self.question.orders.map_or(MOST_REFLECTIONS, |orders| orders as usize);
        let reflections = orders.min(MOST_REFLECTIONS);
        let (mut sum, mut last) = (straight.clone(), straight);
        if let Some(Reflection { operator, .. }) = &self.reflection {
            for _ in 0..reflections {
                if self.watch.is_stopped() {
                    break;
                }
                last = operator.apply_transposed(&strongest, &last);
                let is_reached_first = sum.iter().zip(&last).any(|(&sum, &last)| sum == 0.0 && last > 0.0);
                sum.iter_mut().zip(&last).for_each(|(sum, last)| *sum += last);
                if !is_reached_first && whole(&last) <= ENOUGH * whole(&sum) {
                    break;
                }
            }
        }
        let importance = self.first.windows(2).map(|nodes| sum[nodes[0]..nodes[1]].iter().sum()).collect();
        (importance, sums.concat())
    }

    /// Whether any element contributes light to a goal. This is exact for a point. On a surface it
    /// is judged by the nodes; with occlusion, points between them can see more.
    pub(crate) fn reaches(&self, what: GoalKind) -> bool {
        let goals = [Goal { what, weight: 1.0 }];
        let is_hidden = self.transport.occlusion && matches!(what, GoalKind::Mean { .. });
        is_hidden || self.importance(&goals).iter().any(|&importance| importance > 0.0)
    }

    /// Whether no light can reach any element, wherever between its nodes: there is no light but that
    /// of faces, and none of these faces and an element have points in front of each other.
    pub(crate) fn is_unlit(&self) -> bool {
        let (faces, kinds) = (&self.transport.faces, self.lights.kinds());
        let is_before = |one: &Face, other: &Face| {
            one.vertices.iter().any(|&corner| other.normal.dot(corner - other.vertices[0]) > 0.0)
        };
        let reaches = |from: usize, to: usize| {
            is_before(&faces[from], &faces[to]) && is_before(&faces[to], &faces[from])
        };
        let mut lit = self.elements.iter().map(|element| element.face);
        !kinds.surroundings
            && !kinds.beams
            && !lit.any(|to| self.lights.faces().iter().any(|&from| reaches(from, to)))
    }

    /// Calls `each` with the direct contributions of the nodes of each element to a goal.
    fn each_straight(
        &self,
        goal: &Goal,
        strongest: &[f64],
        scratch: &mut Scratch,
        mut each: impl FnMut(usize, &mut dyn Iterator<Item = f64>),
    ) {
        match goal.what {
            GoalKind::At { position, measure } => {
                let points = [position];
                let group = Group { points: &points, outline: &points, measure };
                self.weigh(group, scratch, |source, _, weights| {
                    each(
                        source,
                        &mut weights.iter().map(|weight| goal.weight * strongest[source] * weight.abs()),
                    );
                });
            }
            GoalKind::Mean { area } => {
                for (index, element) in self.elements.iter().enumerate() {
                    if area.contains(&self.transport.faces[element.face]) {
                        each(index, &mut element.areas().map(|area| goal.weight * area));
                    }
                }
            }
        }
    }
}

fn whole(values: &[f64]) -> f64 {
    values.iter().sum()
}
