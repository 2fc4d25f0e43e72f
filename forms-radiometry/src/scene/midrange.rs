//! The middle of the values of several bands.

/// Returns the midrange: halfway between the smallest and the largest value.
pub(crate) fn middle(values: &[f64]) -> f64 {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    0.5 * least + 0.5 * largest
}
