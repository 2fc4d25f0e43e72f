//! Pixels whose deviation from the truth exceeds their errors, where every pixel is known.

use forms_radiometry::simulation::Simulation;

/// Deviation, in units of its error, above which a pixel is an outlier.
const FAR: f64 = 5.0;
/// Deviation attributed to rounding, relative to the value.
const ROUNDING: f64 = 1e-12;

/// Returns the deviation of a value from the truth, in units of its error.
fn deviations(value: f64, error: f64, known: f64) -> f64 {
    let off = (value - known).abs();
    if off <= ROUNDING * known { 0.0 } else { off / error }
}

/// Returns remarks on images whose pixels all have one known value. The script reports the same for
/// other programs.
pub(crate) fn told(simulations: &[Simulation], known: f64) -> String {
    let pixels = || {
        let maps = simulations.iter().flat_map(|simulation| &simulation.maps);
        maps.flat_map(|map| map.values[0].iter().zip(&map.errors[0]).map(|(&value, &error)| (value, error)))
    };
    let all: Vec<f64> = pixels().map(|(value, error)| deviations(value, error, known)).collect();
    let far = all.iter().filter(|&&deviations| deviations > FAR).count();
    let most = all.iter().copied().fold(0.0, f64::max);
    let brightest = pixels().map(|(value, _)| value / known).fold(0.0, f64::max);
    let means = simulations.iter().flat_map(|simulation| &simulation.answers);
    let means: Vec<String> =
        means.map(|answer| format!("{:.1}", deviations(answer.value, answer.error, known))).collect();
    format!(
        "{far} of {} pixels beyond {FAR} σ, largest deviation {most:.1} σ, \
         brightest pixel {brightest:.2} times the true value; means deviate by {} σ",
        all.len(),
        means.join(", "),
    )
}
