//! Multiple importance sampling (Veach and Guibas 1995).

/// Returns the MIS weight (power heuristic, β = 2) of a technique with density `own` against one
/// with density `other`.
pub(super) fn mis_weight(own: f64, other: f64) -> f64 {
    if own.is_infinite() {
        return 1.0;
    }
    let ratio = other / own;
    1.0 / (1.0 + ratio * ratio)
}
