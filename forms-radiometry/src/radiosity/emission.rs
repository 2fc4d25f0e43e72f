//! Light emitted by surfaces.

use crate::form_factor::double_double::Rounded;
use crate::scene::Surface;

/// Returns the light of a surface with this visible measure in each band. The exitance has the
/// value in the scene file; the radiance is rounded from it.
pub(super) fn emitted(measure: Rounded, surface: &Surface) -> impl Iterator<Item = Rounded> {
    let of_band = move |(band, &radiance): (usize, &f64)| match surface.exitance_of(band) {
        Some(exitance) => measure.times_datum(exitance).over_pi(),
        None => measure.times_datum(radiance),
    };
    surface.radiance.iter().enumerate().map(of_band)
}
