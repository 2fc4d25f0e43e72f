//! Rules of integration on patches of elements, with more points near receivers.

use crate::form_factor::{Patch, gauss};
use crate::geometry::Vector;

/// Maximum number of points of a rule along one side; patches that would need more are cut.
const MOST_POINTS: usize = 4;
/// Maximum number of times that a patch is halved. A millionth of its area is left then.
const DEEPEST: u32 = 20;
/// Pieces whose radius is below this fraction of their distance are measured by the rule alone: in
/// the closed form, the sum over the edges would cancel.
pub(super) const SMALL: f64 = 1e-3;

/// Calls `each` with the points of a rule on a patch, and the area of each; `nearest` is the
/// distance of a point from the nearest receiver.
pub(super) fn rule(
    patch: &Patch,
    nearest: &impl Fn(Vector) -> f64,
    accuracy: f64,
    depth: u32,
    each: &mut impl FnMut(Vector, f64),
) {
    let (centre, _) = patch.at(0.5, 0.5);
    let ratio = nearest(centre) / patch.radius(centre);
    let points = if ratio > 1.0 {
        let ellipse = ratio + (ratio * ratio - 1.0).sqrt();
        (-0.5 * accuracy.ln() / ellipse.ln()).ceil()
    } else {
        f64::INFINITY
    };
    if points <= MOST_POINTS as f64 || depth >= DEEPEST {
        let points = gauss((points.min(MOST_POINTS as f64) as usize).max(1));
        patch.by_rule(points, each);
    } else if let Some(halves) = patch.halves() {
        halves.iter().for_each(|half| rule(half, nearest, accuracy, depth + 1, each));
    } else {
        patch.quarters().iter().for_each(|quarter| rule(quarter, nearest, accuracy, depth + 2, each));
    }
}
