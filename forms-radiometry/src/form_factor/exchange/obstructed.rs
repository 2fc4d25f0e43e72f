//! Exchange area with occluders: the form factor from points of the smaller polygon to the visible
//! part of the other, integrated over the smaller one.
//!
//! ```text
//! A₁F₁₂ = A₂F₂₁ = ∫ F(x) dA,   F(x) Lambert's sum over the part of the other polygon seen from x
//! ```
//! F is exact at each point, for any occluders. It has kinks where the boundary of a shadow reaches
//! a vertex of the other polygon: seen from the smaller polygon, shadows move little, and most of
//! them reach no vertex at all. A patch is quartered where the rule on the whole and on its
//! quarters disagree, the worst patch first.

use super::areas::{Patch, gauss, patches};
use super::changes::Changes;
use super::{Exchange, exchange_of};
use crate::geometry::{Polygon, Vector, scale};
use crate::visibility::{Between, Borders, Face, Looking, Screens, Workspace};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Number of points of the rule along each side of a patch.
const ORDER: usize = 3;

/// Number of parts that share a change.
const QUARTERS: f64 = 4.0;

/// Part of the goal within which few points have to agree.
const FEW: f64 = 0.25;

/// The largest number of patches. If it is reached, the remaining error is reported.
const MOST_PATCHES: usize = 200_000;

/// Rounding error of a form factor at a point, in units of 2⁻⁵².
const ROUNDING: f64 = 16.0;

/// Computes the exchange area of the fronts of two polygons among others, to a relative tolerance
/// or until the limit on patches is reached.
///
/// Where nothing can occlude the polygons, the result is [`exchange`](super::exchange). The error
/// is the sum of the changes by the last refinement of each patch.
pub fn visible_exchange<'a>(
    here: &'a Polygon,
    there: &'a Polygon,
    others: impl Iterator<Item = &'a Polygon>,
    tolerance: f64,
) -> Exchange {
    let polygons: Vec<&Polygon> = others.chain([here, there]).collect();
    let factor = scale::factor(scale::of_all(polygons.iter().map(|polygon| polygon.lengths())));
    let fronts = |polygon: &Polygon| -> Vec<Face> {
        Face::of(0, &polygon.scaled(factor)).filter(|face| !face.is_back).collect()
    };
    let all: Vec<Face> = polygons.into_iter().flat_map(fronts).collect();
    let screens = Screens::of(&all);
    let mut sum = Exchange::default();
    for from in fronts(here) {
        for to in fronts(there) {
            sum += exchange_with(&from, &to, &screens, [tolerance, 0.0], || false);
        }
    }
    Exchange { area: sum.area / factor / factor, error: sum.error / factor / factor }
}

/// Computes the exchange area of two faces among occluders. The tolerance is relative to the result
/// or to the area `least`, whichever is larger. If the computation is stopped, returns the result
/// so far.
pub(crate) fn exchange_with(
    here: &Face,
    there: &Face,
    screens: &Screens,
    [tolerance, least]: [f64; 2],
    is_stopped: impl Fn() -> bool,
) -> Exchange {
    let mut found = Vec::new();
    match sight(here, there, screens, &mut found) {
        Sight::Nothing => Exchange::default(),
        Sight::Whole => exchange_of(here, there, [tolerance; 2]),
        Sight::Parts { outline, view } => view.integral(outline, [tolerance, least], is_stopped),
    }
}

/// Exchange area of two faces at a first look.
#[derive(Clone, Copy, Debug)]
pub(crate) enum FirstLook {
    /// Nothing can hide a part, or hides all: as accurate as the relative tolerance.
    Certain(Exchange),
    /// A few points see this area, and with it fewer points see this much less.
    Rough { area: f64, change: f64 },
}

/// Returns the exchange area of two faces among occluders at a first look.
pub(crate) fn first_look(here: &Face, there: &Face, screens: &Screens, tolerance: f64) -> FirstLook {
    let mut found = Vec::new();
    match sight(here, there, screens, &mut found) {
        Sight::Nothing => FirstLook::Certain(Exchange::default()),
        Sight::Whole => FirstLook::Certain(exchange_of(here, there, [tolerance; 2])),
        Sight::Parts { outline, view } => {
            let (sum, _) = view.by_few_points(outline, &mut Work::default());
            FirstLook::Rough { area: sum.area, change: sum.change() }
        }
    }
}

/// What two faces see of each other.
enum Sight<'s> {
    Nothing,
    Whole,
    /// A part can be hidden from some points of this outline.
    Parts {
        outline: &'s [Vector],
        view: View<'s>,
    },
}

/// Returns what two faces see of each other, from the smaller one.
fn sight<'s>(here: &'s Face, there: &'s Face, screens: &'s Screens, found: &'s mut Vec<u32>) -> Sight<'s> {
    let [here, there] = if there.area < here.area { [there, here] } else { [here, there] };
    let (outline, normal) = (&here.vertices, Some(here.normal));
    if !screens.face_each_other(outline, normal, &there.vertices, there.normal) {
        return Sight::Nothing;
    }
    match screens.between(outline, normal, &there.vertices, there.normal, found) {
        Between::All => Sight::Nothing,
        Between::Nothing => Sight::Whole,
        Between::Some => {
            Sight::Parts { outline, view: View { screens, between: found, there, normal: here.normal } }
        }
    }
}

/// The visible part of a face from points on one side of a plane, with these occluders.
struct View<'s> {
    screens: &'s Screens,
    between: &'s [u32],
    there: &'s Face,
    normal: Vector,
}

/// A patch with the integral over it, and its share of the change when it was split off its parent
/// patch: a quarter.
struct Part {
    patch: Patch,
    area: f64,
    change: f64,
}

impl Changes {
    fn with(mut self, part: &Part) -> Self {
        self.add(part.area, part.change, QUARTERS);
        self
    }

    fn without(mut self, part: &Part) -> Self {
        self.remove(part.area, part.change, QUARTERS);
        self
    }
}

/// Buffers that are reused from patch to patch.
#[derive(Default)]
struct Work {
    points: Vec<Vector>,
    areas: Vec<f64>,
    factors: Vec<f64>,
    view: Workspace,
    borders: Borders,
}

impl View<'_> {
    fn integral(
        &self,
        outline: &[Vector],
        [tolerance, least]: [f64; 2],
        is_stopped: impl Fn() -> bool,
    ) -> Exchange {
        let mut work = Work::default();
        let goal = |area: f64| tolerance * area.abs().max(least);
        let (few, see_all) = self.by_few_points(outline, &mut work);
        // where some points see nothing, a part may be seen from between them
        if see_all && few.error() <= FEW * goal(few.area) {
            return Exchange { area: few.area, error: few.error() };
        }
        let mut queue: BinaryHeap<Part> = BinaryHeap::new();
        for patch in patches(outline) {
            let [quarters @ .., whole] = self.over(with_quarters(&patch), &patch, ORDER, &mut work);
            queue.extend(parts(quarters, whole.1));
        }
        let sum_of = |queue: &BinaryHeap<Part>| queue.iter().fold(Changes::default(), Changes::with);
        let mut sum = sum_of(&queue);
        while sum.error() > goal(sum.area) && queue.len() < MOST_PATCHES && !is_stopped() {
            let Some(worst) = queue.pop() else { break };
            let quarters =
                parts(self.over(worst.patch.quarters(), &worst.patch, ORDER, &mut work), worst.area);
            sum = quarters.iter().fold(sum.without(&worst), Changes::with);
            queue.extend(quarters);
        }
        // the running sums have accumulated rounding errors
        let sum = sum_of(&queue);
        let (area, error) = (sum.area, sum.error());
        let size: f64 = queue.iter().map(|part| part.patch.area()).sum();
        Exchange { area, error: error + ROUNDING * f64::EPSILON * size }
    }

    /// Integrates by the middles of patches and of their quarters, with the difference as the error.
    /// Returns also whether all points see something.
    fn by_few_points(&self, outline: &[Vector], work: &mut Work) -> (Changes, bool) {
        let (mut sum, mut see_all) = (Changes::default(), true);
        for patch in patches(outline) {
            let [quarters @ .., whole] = self.over(with_quarters(&patch), &patch, 1, work);
            see_all &= quarters.iter().all(|(_, area)| *area > 0.0);
            let area: f64 = quarters.iter().map(|(_, area)| area).sum();
            sum.add(area, area - whole.1, 1.0);
        }
        (sum, see_all)
    }

    /// Integrates by the rule with this number of points along each side, over patches that lie
    /// within one patch.
    fn over<const N: usize>(
        &self,
        patches: [Patch; N],
        within: &Patch,
        order: usize,
        work: &mut Work,
    ) -> [(Patch, f64); N] {
        let Work { points, areas, factors, view, borders } = work;
        points.clear();
        areas.clear();
        for patch in &patches {
            patch.by_rule(gauss(order), |point, area| {
                points.push(point);
                areas.push(area);
            });
        }
        let Face { vertices, normal, .. } = self.there;
        let looking = Looking {
            points,
            outline: within.corners(),
            horizon: Some(self.normal),
            luminaire: (vertices, *normal),
            screens: self.between,
        };
        factors.clear();
        factors.resize(points.len(), 0.0);
        self.screens.add_form_factors(looking, (self.normal, 1.0), (view, borders), factors);
        let mut values = areas.iter().zip(factors).map(|(area, factor)| area * *factor);
        patches.map(|patch| (patch, values.by_ref().take(order * order).sum()))
    }
}

/// Returns the quarters of a patch, followed by the patch itself.
fn with_quarters(patch: &Patch) -> [Patch; 5] {
    let [a, b, c, d] = patch.quarters();
    [a, b, c, d, *patch]
}

/// Returns the quarters of a patch whose integral is `whole`, each with a quarter of the change.
fn parts(quarters: [(Patch, f64); 4], whole: f64) -> [Part; 4] {
    let change = quarters.iter().map(|(_, area)| area).sum::<f64>() - whole;
    quarters.map(|(patch, area)| Part { patch, area, change: 0.25 * change })
}

impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}
impl Eq for Part {}
impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Part {
    fn cmp(&self, other: &Self) -> Ordering {
        self.change.abs().total_cmp(&other.change.abs())
    }
}
