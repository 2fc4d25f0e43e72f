//! Solution of E = D + G E: by the Neumann series, order by order, or for all orders at once by
//! GMRES.
//!
//! ```text
//! E = Σ Gⁿ D        ‖E − Eₙ‖ ≤ k/(1 − k) ‖Eₙ − Eₙ₋₁‖,  k = ‖G‖ < 1
//! ```
//! For all orders the residual is minimised in the Krylov space, which the powers of G span (GMRES:
//! Saad and Schultz 1986). It takes a few steps where the series would take thousands.

use super::operator::{Band, Operator, largest};
use crate::watch::Watch;

/// Maximum dimension of the Krylov space before a restart.
const POWERS: usize = 60;
/// Maximum number of restarts.
const RESTARTS: usize = 20;
/// Norm up to which it bounds the sum of all orders well.
const CONTRACTING: f64 = 0.9;
/// Residual of the solution that bounds this sum otherwise.
const ROUGH: f64 = 1e-3;
/// Residual at which the iteration ends, relative to D.
pub(super) const RESIDUAL: f64 = 1e-14;

/// Returns the number of orders that reach this relative tolerance if each is at most k times the
/// one before: the least n with kⁿ ≤ tolerance.
pub(crate) fn orders(contraction: f64, tolerance: f64) -> Option<u32> {
    if contraction <= 0.0 {
        return Some(0);
    }
    if contraction >= 1.0 {
        return None;
    }
    let mut order = (tolerance.ln() / contraction.ln()).ceil().max(0.0);
    // the quotient of the logarithms can be off by a rounding error
    while order > 0.0 && contraction.powf(order - 1.0) <= tolerance {
        order -= 1.0;
    }
    while contraction.powf(order) > tolerance {
        order += 1.0;
    }
    Some(order as u32)
}

/// Solution for each band.
pub(super) struct Solved {
    /// The irradiance of each node.
    pub(super) irradiance: Vec<Vec<f64>>,
    /// The irradiance that is reflected once more: all but the highest order.
    pub(super) reflected: Vec<Vec<f64>>,
    /// Largest error that the solution of the equations leaves.
    pub(super) tail: Vec<f64>,
}

/// The operator, and for each band the reflectances of the elements.
pub(super) struct Reflection {
    pub(super) operator: Operator,
    pub(super) reflectances: Vec<Vec<f64>>,
    /// Norm in each band.
    norms: Vec<f64>,
}

impl Reflection {
    pub(super) fn new(operator: Operator, reflectances: Vec<Vec<f64>>) -> Self {
        let norms = operator.norms(&reflectances);
        Self { operator, reflectances, norms }
    }

    /// Returns the solution for each band of direct light, with at most this number of reflections
    /// if one is given, otherwise to this residual relative to the direct light; a rough solution
    /// if the work is stopped.
    pub(super) fn solve(
        &self,
        direct: &[Vec<f64>],
        orders: Option<u32>,
        residual: f64,
        watch: &dyn Watch,
    ) -> Solved {
        if let Some(orders) = orders {
            let [irradiance, reflected] = self.neumann(direct, orders, watch);
            return Solved { irradiance, reflected, tail: vec![0.0; direct.len()] };
        }
        let (irradiance, residuals) = self.all_orders(direct, residual, watch);
        let growths = self.growths(watch);
        let tail = |(residual, growth): (f64, f64)| if residual == 0.0 { 0.0 } else { residual * growth };
        let tail = residuals.into_iter().zip(growths).map(tail).collect();
        Solved { reflected: irradiance.clone(), irradiance, tail }
    }

    /// Returns for each band the largest irradiance that a unit of residual causes: ‖(1 − G)⁻¹‖ ≤
    /// 1/(1 − ‖G‖). Where faces hide nothing from each other, ‖G‖ can be above 1 although light dies
    /// out. Then w = 1 + G w − r with w > 0 and |r| ≤ ε < 1 bounds it, since G ≥ 0: by max w/(1 − ε).
    pub(super) fn growths(&self, watch: &dyn Watch) -> Vec<f64> {
        if self.norms.iter().all(|&norm| norm < CONTRACTING) {
            return self.norms.iter().map(|norm| 1.0 / (1.0 - norm)).collect();
        }
        let unit = vec![vec![1.0; self.operator.size()]; self.norms.len()];
        let (found, residuals) = self.all_orders(&unit, ROUGH, watch);
        let of_band = |(w, residual): (Vec<f64>, f64)| {
            let is_positive = w.iter().all(|&value| value > 0.0);
            if is_positive && residual < 1.0 { largest(&w) / (1.0 - residual) } else { f64::INFINITY }
        };
        found.into_iter().zip(residuals).map(of_band).collect()
    }

    /// Returns G E of some bands.
    fn apply(&self, bands: &[usize], irradiance: &[&[f64]]) -> Vec<Vec<f64>> {
        let bands = bands.iter().zip(irradiance);
        let bands: Vec<Band> =
            bands.map(|(&band, &irradiance)| [&self.reflectances[band][..], irradiance]).collect();
        self.operator.apply(&bands)
    }

    /// Returns the irradiance after at most this many reflections, and after one less.
    pub(super) fn neumann(&self, direct: &[Vec<f64>], orders: u32, watch: &dyn Watch) -> [Vec<Vec<f64>>; 2] {
        let bands: Vec<usize> = (0..direct.len()).collect();
        let (mut sum, mut last) = (direct.to_vec(), direct.to_vec());
        let mut before = sum.clone();
        for _ in 0..orders {
            last = self.apply(&bands, &slices(&last));
            before.clone_from(&sum);
            if watch.is_stopped() || last.iter().flatten().all(|&value| value == 0.0) {
                break;
            }
            let values = sum.iter_mut().flatten().zip(last.iter().flatten());
            values.for_each(|(sum, last)| *sum += last);
        }
        [sum, before]
    }

    /// Returns the irradiance after all reflections, and for each band the largest remaining
    /// residual |D + G E − E|.
    pub(super) fn all_orders(
        &self,
        direct: &[Vec<f64>],
        enough: f64,
        watch: &dyn Watch,
    ) -> (Vec<Vec<f64>>, Vec<f64>) {
        let mut found = direct.to_vec();
        let mut open: Vec<usize> = (0..direct.len()).collect();
        let mut left = self.residuals(direct, &open, &found);
        for _ in 0..RESTARTS {
            open.retain(|&band| largest(&left[band]) > enough * largest(&direct[band]));
            if watch.is_stopped() || open.is_empty() {
                break;
            }
            let steps = self.minimal_residuals(&open, &left, |band| enough * norm(&direct[band]), watch);
            let mut next = found.clone();
            for (&band, step) in open.iter().zip(steps) {
                next[band].iter_mut().zip(step).for_each(|(found, step)| *found += step);
            }
            let left_next = self.residuals(direct, &open, &next);
            open = open
                .iter()
                .zip(left_next)
                .filter_map(|(&band, left_next)| {
                    let is_nearer = norm(&left_next) < norm(&left[band]);
                    is_nearer.then(|| {
                        found[band].clone_from(&next[band]);
                        left[band] = left_next;
                        band
                    })
                })
                .collect();
        }
        (found, left.iter().map(|left| largest(left)).collect())
    }

    /// Returns D + G E − E of some bands.
    fn residuals(&self, direct: &[Vec<f64>], bands: &[usize], irradiance: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let arriving: Vec<&[f64]> = bands.iter().map(|&band| &irradiance[band][..]).collect();
        let of_band = |(&band, reflected): (&usize, Vec<f64>)| {
            let terms = direct[band].iter().zip(reflected).zip(&irradiance[band]);
            terms.map(|((d, g), e)| d + g - e).collect()
        };
        bands.iter().zip(self.apply(bands, &arriving)).map(of_band).collect()
    }

    /// Returns for some bands the x in the Krylov space of G and b that minimises |b − (1 − G) x|,
    /// where `b` has all bands. A band ends at the residual `enough`.
    fn minimal_residuals(
        &self,
        bands: &[usize],
        b: &[Vec<f64>],
        enough: impl Fn(usize) -> f64,
        watch: &dyn Watch,
    ) -> Vec<Vec<f64>> {
        let mut spaces: Vec<Krylov> = bands.iter().map(|&band| Krylov::of(&b[band])).collect();
        let mut open: Vec<usize> = (0..bands.len()).collect();
        for _ in 0..POWERS.min(self.operator.size()) {
            let those: Vec<usize> = open.iter().map(|&index| bands[index]).collect();
            let last: Vec<&[f64]> = open.iter().map(|&index| spaces[index].last()).collect();
            let reflected = self.apply(&those, &last);
            let is_open = |&(index, ref reflected): &(usize, Vec<f64>)| {
                spaces[index].extend(reflected, enough(bands[index])) && !watch.is_stopped()
            };
            open = open.into_iter().zip(reflected).filter(is_open).map(|(index, _)| index).collect();
            if open.is_empty() {
                break;
            }
        }
        spaces.iter().map(Krylov::minimum).collect()
    }
}

/// The Krylov space of G and b, with an orthonormal basis.
struct Krylov {
    powers: Vec<Vec<f64>>,
    /// The columns of the upper triangular matrix, made by Givens rotations.
    columns: Vec<Vec<f64>>,
    rotations: Vec<[f64; 2]>,
    /// The rotated right-hand side.
    right: Vec<f64>,
}

impl Krylov {
    fn of(b: &[f64]) -> Self {
        let scale = norm(b);
        let powers = vec![b.iter().map(|value| value / scale).collect::<Vec<f64>>()];
        Self { powers, columns: Vec::new(), rotations: Vec::new(), right: vec![scale] }
    }

    /// Returns the last vector of the basis.
    fn last(&self) -> &[f64] {
        &self.powers[self.powers.len() - 1]
    }

    /// Adds a dimension by G of the last vector. Returns whether another one is needed for the
    /// residual `enough`.
    fn extend(&mut self, reflected: &[f64], enough: f64) -> bool {
        let step = self.columns.len();
        let mut next: Vec<f64> = self.last().iter().zip(reflected).map(|(x, g)| x - g).collect();
        let mut column = Vec::with_capacity(step + 2);
        for power in &self.powers {
            let along = dot(&next, power);
            next.iter_mut().zip(power).for_each(|(x, p)| *x -= along * p);
            column.push(along);
        }
        let rest = norm(&next);
        column.push(rest);
        for (i, [c, s]) in self.rotations.iter().enumerate() {
            (column[i], column[i + 1]) =
                (c * column[i] + s * column[i + 1], c * column[i + 1] - s * column[i]);
        }
        let length = column[step].hypot(rest);
        if length == 0.0 {
            return false;
        }
        let [c, s] = [column[step] / length, rest / length];
        column.truncate(step);
        column.push(length);
        self.columns.push(column);
        self.rotations.push([c, s]);
        let turned = self.right[step];
        self.right[step] = c * turned;
        self.right.push(-s * turned);
        if self.right[step + 1].abs() <= enough || rest <= f64::EPSILON * length {
            return false;
        }
        self.powers.push(next.iter().map(|x| x / rest).collect());
        true
    }

    /// Returns the x that minimises the residual.
    fn minimum(&self) -> Vec<f64> {
        combine(&self.powers, &self.columns, &self.right)
    }
}

/// Returns the combination of the basis vectors whose coefficients solve the upper triangular
/// system.
fn combine(powers: &[Vec<f64>], columns: &[Vec<f64>], right: &[f64]) -> Vec<f64> {
    let mut coefficients = right[..columns.len()].to_vec();
    for i in (0..columns.len()).rev() {
        coefficients[i] /= columns[i][i];
        let value = coefficients[i];
        for (j, coefficient) in coefficients.iter_mut().enumerate().take(i) {
            *coefficient -= columns[i][j] * value;
        }
    }
    let mut sum = vec![0.0; powers[0].len()];
    for (coefficient, power) in coefficients.iter().zip(powers) {
        sum.iter_mut().zip(power).for_each(|(sum, p)| *sum += coefficient * p);
    }
    sum
}

fn slices(values: &[Vec<f64>]) -> Vec<&[f64]> {
    values.iter().map(Vec::as_slice).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Returns the Euclidean norm, whose square can be beyond the range of `f64`.
fn norm(a: &[f64]) -> f64 {
    let length = dot(a, a).sqrt();
    if length.is_normal() {
        return length;
    }
    let largest = largest(a);
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    largest * a.iter().map(|value| (value / largest).powi(2)).sum::<f64>().sqrt()
}
