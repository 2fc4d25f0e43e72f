//! Enclosure: view factors are changed so that all rows sum to 1 and A₁F₁₂ = A₂F₂₁.
//!
//! ```text
//! S = (AF + (AF)ᵀ)/2    find d > 0:  dᵢ Σⱼ Sᵢⱼ dⱼ = Aᵢ    F′ᵢⱼ = dᵢ Sᵢⱼ dⱼ/Aᵢ
//! ```
//! Balances of heat in a closed room need both laws to all digits, while computed view factors obey
//! them within their errors. A symmetric scaling of the symmetric matrix keeps zeros and the order
//! of the entries, and is the change that is nearest to the original in relative entropy.
//!
//! Source: R. Sinkhorn, P. Knopp, Concerning nonnegative matrices and doubly stochastic matrices
//! (1967).

use super::ViewFactors;

/// Largest change of a view factor by the scaling, beyond its error, in a scene that is closed.
const SLACK: f64 = 1e-9;
/// Largest residual of a row's sum, and the largest number of iterations until then.
const CLOSED: f64 = 1e-13;
const MOST: usize = 10_000;

/// What enforcing the laws of an enclosure changed.
#[derive(Clone, Copy, Debug)]
pub struct Enclosed {
    /// The largest change of a view factor.
    pub change: f64,
    /// Largest |1 − sum| of a row before.
    pub open: f64,
    /// Largest |A₁F₁₂ − A₂F₂₁| before, relative to the smaller area.
    pub residual: f64,
}

/// Reason why the laws of an enclosure cannot be enforced.
#[derive(Clone, Debug, PartialEq)]
pub enum NotEnclosed {
    /// The sum of this row differs from 1 by more than its error: light leaves the scene.
    Open {
        /// The name of the surface.
        surface: String,
        /// The sum of its row.
        sum: f64,
        /// The error of the sum.
        error: f64,
    },
    /// No scaling closes all rows.
    NoScaling,
}

impl std::fmt::Display for NotEnclosed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Open { surface, sum, error } => write!(
                f,
                "the view factors of `{surface}` sum to {sum:.6} ± {error:.1e}: light leaves the scene, \
                 so closure cannot be enforced"
            ),
            Self::NoScaling => write!(f, "no scaling of the view factors closes all rows"),
        }
    }
}

impl std::error::Error for NotEnclosed {}

impl ViewFactors {
    /// Changes the view factors so that every row sums to 1 and A₁F₁₂ = A₂F₂₁, and returns what
    /// changed. Errors grow by the changes.
    ///
    /// # Errors
    /// Light leaves the scene, or no scaling closes all rows.
    pub fn enclose(&mut self) -> Result<Enclosed, NotEnclosed> {
        let count = self.names.len();
        for surface in 0..count {
            let (sum, error) = (self.sum(surface), self.rows[surface].sum_error() + SLACK);
            if (1.0 - sum).abs() > error {
                return Err(NotEnclosed::Open { surface: self.names[surface].clone(), sum, error });
            }
        }
        let open = (0..count).map(|surface| (1.0 - self.sum(surface)).abs()).fold(0.0, f64::max);
        let residual = self.reciprocity_residual();
        let exchange = |i: usize, j: usize| self.areas[i] * self.rows[i].factors[j].value;
        let symmetric = |i: usize, j: usize| 0.5 * (exchange(i, j) + exchange(j, i));
        let matrix: Vec<Vec<f64>> =
            (0..count).map(|i| (0..count).map(|j| symmetric(i, j)).collect()).collect();
        let scales = scales(&matrix, &self.areas).ok_or(NotEnclosed::NoScaling)?;
        let mut change: f64 = 0.0;
        for (i, row) in self.rows.iter_mut().enumerate() {
            for (j, factor) in row.factors.iter_mut().enumerate() {
                let value = scales[i] * matrix[i][j] * scales[j] / self.areas[i];
                let own = (value - factor.value).abs();
                change = change.max(own);
                factor.value = value;
                factor.error += own;
            }
        }
        Ok(Enclosed { change, open, residual })
    }
}

/// Returns the scales d of rows and columns with dᵢ Σⱼ Sᵢⱼ dⱼ = Aᵢ, if the iteration
/// d ← √(d A/(S d)) converges.
fn scales(matrix: &[Vec<f64>], areas: &[f64]) -> Option<Vec<f64>> {
    let mut scales = vec![1.0; areas.len()];
    for _ in 0..MOST {
        let sum = |row: &Vec<f64>| row.iter().zip(&scales).map(|(entry, scale)| entry * scale).sum::<f64>();
        let sums: Vec<f64> = matrix.iter().map(sum).collect();
        let off = |i: usize| (scales[i] * sums[i] / areas[i] - 1.0).abs();
        if (0..areas.len()).all(|i| off(i) <= CLOSED) {
            return Some(scales);
        }
        scales = (0..areas.len()).map(|i| (scales[i] * areas[i] / sums[i]).sqrt()).collect();
        if scales.iter().any(|scale| !scale.is_finite()) {
            return None;
        }
    }
    None
}
