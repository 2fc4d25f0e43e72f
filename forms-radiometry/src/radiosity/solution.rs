//! Solution of E = D + G E: by the Neumann series, order by order, or for all orders at once by
//! GMRES.
//!
//! ```text
//! E = Σ Gⁿ D        ‖E − Eₙ‖ ≤ k/(1 − k) ‖Eₙ − Eₙ₋₁‖,  k = ‖G‖ < 1
//! ```
//! For all orders the residual is minimised in the Krylov space, which the powers of G span (GMRES:
//! Saad and Schultz 1986). It takes a few steps where the series would take thousands.

use super::operator::Operator;
use crate::watch::Watch;

/// Maximum dimension of the Krylov space before a restart.
const POWERS: usize = 60;
/// Maximum number of restarts.
const RESTARTS: usize = 20;
/// Residual at which the iteration ends, relative to D.
const RESIDUAL: f64 = 1e-14;

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
    /// Largest estimated norm of the operator.
    pub(super) contraction: f64,
}

/// Returns the solution for each band, with at most this number of reflections if one is given; a
/// rough solution if the work is stopped. `reflectances` are those of the elements.
pub(super) fn of_bands(
    operator: &Operator,
    reflectances: &[Vec<f64>],
    direct: &[Vec<f64>],
    orders: Option<u32>,
    watch: &dyn Watch,
) -> Solved {
    let (irradiance, reflected, tail) = (Vec::new(), Vec::new(), Vec::new());
    let mut solved = Solved { irradiance, reflected, tail, contraction: 0.0 };
    for (reflectances, direct) in reflectances.iter().zip(direct) {
        let contraction = operator.contraction(reflectances);
        let (irradiance, reflected, residual) = match orders {
            Some(orders) => {
                let [all, but_one] = neumann(operator, reflectances, direct, orders, watch);
                (all, but_one, 0.0)
            }
            None => {
                let (all, residual) = all_orders(operator, reflectances, direct, watch);
                (all.clone(), all, residual)
            }
        };
        solved.irradiance.push(irradiance);
        solved.reflected.push(reflected);
        solved.tail.push(residual / (1.0 - contraction).max(f64::EPSILON));
        solved.contraction = solved.contraction.max(contraction);
    }
    solved
}

/// Returns the irradiance after at most this many reflections, and after one less.
pub(super) fn neumann(
    operator: &Operator,
    reflectances: &[f64],
    direct: &[f64],
    orders: u32,
    watch: &dyn Watch,
) -> [Vec<f64>; 2] {
    let (mut sum, mut last) = (direct.to_vec(), direct.to_vec());
    let mut before = sum.clone();
    for _ in 0..orders {
        last = operator.apply(reflectances, &last);
        before.clone_from(&sum);
        if watch.is_stopped() || last.iter().all(|&value| value == 0.0) {
            break;
        }
        sum.iter_mut().zip(&last).for_each(|(sum, last)| *sum += last);
    }
    [sum, before]
}

/// Returns the irradiance after all reflections, and the largest remaining residual |D + G E − E|.
pub(super) fn all_orders(
    operator: &Operator,
    reflectances: &[f64],
    direct: &[f64],
    watch: &dyn Watch,
) -> (Vec<f64>, f64) {
    let residual = |e: &[f64]| -> Vec<f64> {
        let reflected = operator.apply(reflectances, e);
        direct.iter().zip(reflected).zip(e).map(|((d, g), e)| d + g - e).collect()
    };
    let largest = |values: &[f64]| values.iter().fold(0.0, |m: f64, value| m.max(value.abs()));
    let mut found = direct.to_vec();
    let mut left = residual(&found);
    for _ in 0..RESTARTS {
        if watch.is_stopped() || largest(&left) <= RESIDUAL * largest(direct) {
            break;
        }
        let step = minimal_residual(operator, reflectances, &left, RESIDUAL * norm(direct), watch);
        let next: Vec<f64> = found.iter().zip(step).map(|(found, step)| found + step).collect();
        let left_next = residual(&next);
        if norm(&left_next) >= norm(&left) {
            break;
        }
        (found, left) = (next, left_next);
    }
    let left = largest(&left);
    (found, left)
}

/// Returns the x in the Krylov space of G and b that minimises |b − (1 − G) x|.
fn minimal_residual(
    operator: &Operator,
    reflectances: &[f64],
    b: &[f64],
    enough: f64,
    watch: &dyn Watch,
) -> Vec<f64> {
    let scale = norm(b);
    let mut powers = vec![b.iter().map(|value| value / scale).collect::<Vec<f64>>()];
    // the columns of the upper triangular matrix, made by Givens rotations, and the rotated
    // right-hand side
    let (mut columns, mut rotations, mut right) =
        (Vec::<Vec<f64>>::new(), Vec::<[f64; 2]>::new(), vec![scale]);
    for step in 0..POWERS.min(b.len()) {
        let last = &powers[step];
        let reflected = operator.apply(reflectances, last);
        let mut next: Vec<f64> = last.iter().zip(reflected).map(|(x, g)| x - g).collect();
        let mut column = Vec::with_capacity(step + 2);
        for power in &powers {
            let along = dot(&next, power);
            next.iter_mut().zip(power).for_each(|(x, p)| *x -= along * p);
            column.push(along);
        }
        let rest = norm(&next);
        column.push(rest);
        for (i, [c, s]) in rotations.iter().enumerate() {
            (column[i], column[i + 1]) =
                (c * column[i] + s * column[i + 1], c * column[i + 1] - s * column[i]);
        }
        let length = column[step].hypot(rest);
        if length == 0.0 {
            break;
        }
        let [c, s] = [column[step] / length, rest / length];
        column.truncate(step);
        column.push(length);
        columns.push(column);
        rotations.push([c, s]);
        let turned = right[step];
        right[step] = c * turned;
        right.push(-s * turned);
        if watch.is_stopped() || right[step + 1].abs() <= enough || rest <= f64::EPSILON * length {
            break;
        }
        powers.push(next.iter().map(|x| x / rest).collect());
    }
    combine(&powers, &columns, &right)
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

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Returns the Euclidean norm, whose square can be beyond the range of `f64`.
fn norm(a: &[f64]) -> f64 {
    let length = dot(a, a).sqrt();
    if length.is_normal() {
        return length;
    }
    let largest = a.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    largest * a.iter().map(|value| (value / largest).powi(2)).sum::<f64>().sqrt()
}
