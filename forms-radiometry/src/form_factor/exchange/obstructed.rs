//! Exchange area with occluders: the form factor from points of the smaller polygon to the visible
//! part of the other, integrated over the smaller one.
//!
//! ```text
//! A₁F₁₂ = A₂F₂₁ = ∫ F(x) dA,   F(x) Lambert's sum over the part of the other polygon seen from x
//! ```
//! F is exact at each point, for any occluders. It has kinks where the boundary of a shadow reaches
//! a vertex of the other polygon: seen from the smaller polygon, shadows move little, and most of
//! them reach no vertex at all. A patch is quartered where the rule on the whole and on its
//! quarters disagree, or where kinks can hide from both; the patch most in doubt is the first.

use super::areas::{Patch, gauss, patches};
use super::changes::Changes;
use super::doubt::{self, ORDER, POINTS, QUARTERS};
use super::{Exchange, exchange_of, in_front};
use crate::geometry::{Polygon, Vector, scale};
use crate::visibility::{Aspects, Between, Borders, Face, Looking, Screens, Workspace};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// The largest number of patches. If it is reached, the remaining error is reported.
const MOST_PATCHES: usize = 200_000;

/// Rounding error of a form factor at a point, in units of 2⁻⁵².
const ROUNDING: f64 = 16.0;

/// Computes the exchange area of the fronts of two polygons among others, to a relative tolerance
/// or until the limit on patches is reached.
///
/// Where nothing can occlude the polygons, the result is [`exchange`](super::exchange). The error
/// is an estimate, from the last refinement of each patch.
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
        Sight::Parts(view) => view.integral([tolerance, least], is_stopped),
    }
}

/// Exchange area of two faces at a first look.
#[derive(Clone, Copy, Debug)]
pub(crate) enum FirstLook {
    /// Nothing can hide a part, or hides all: as accurate as the relative tolerance.
    Certain(Exchange),
    /// A few points see this area, fewer of them see this much less, and are in doubt by so much.
    Rough { area: f64, change: f64, doubt: f64 },
}

/// Returns the exchange area of two faces among occluders at a first look.
pub(crate) fn first_look(here: &Face, there: &Face, screens: &Screens, tolerance: f64) -> FirstLook {
    let mut found = Vec::new();
    match sight(here, there, screens, &mut found) {
        Sight::Nothing => FirstLook::Certain(Exchange::default()),
        Sight::Whole => FirstLook::Certain(exchange_of(here, there, [tolerance; 2])),
        Sight::Parts(view) => {
            let few = view.by_few_points(&mut Work::default());
            FirstLook::Rough { area: few.area(), change: few.change(), doubt: few.doubt() }
        }
    }
}

/// What two faces see of each other.
enum Sight<'s> {
    Nothing,
    Whole,
    Parts(View<'s>),
}

/// Returns what two faces see of each other, from the smaller one.
fn sight<'s>(here: &'s Face, there: &'s Face, screens: &'s Screens, found: &'s mut Vec<u32>) -> Sight<'s> {
    let [here, there] = if there.area < here.area { [there, here] } else { [here, there] };
    let (outline, normal) = (&here.vertices, Some(here.normal));
    if !screens.face_each_other(outline, normal, &there.vertices, there.normal) {
        return Sight::Nothing;
    }
    match screens.between(outline, normal, &there.vertices, there.normal, found) {
        Between::All => return Sight::Nothing,
        Between::Nothing => return Sight::Whole,
        Between::Some => {}
    }
    let part = |face: &Face, other: &Face| in_front(face.vertices.to_vec(), other.vertices[0], other.normal);
    let (Some((outline, moved)), Some((luminaire, also_moved))) = (part(here, there), part(there, here))
    else {
        return Sight::Nothing;
    };
    let [normal, of_luminaire] = [here.normal, there.normal];
    let (between, error) = (&found[..], moved + also_moved);
    Sight::Parts(View { screens, between, outline, luminaire: (luminaire, of_luminaire), normal, error })
}

/// The visible part of a face from points on one side of a plane, with these occluders.
struct View<'s> {
    screens: &'s Screens,
    between: &'s [u32],
    /// The part of the points' face in front of the other one, and its normal.
    outline: Vec<Vector>,
    normal: Vector,
    /// The part of the other face in front of that one, and its normal.
    luminaire: (Vec<Vector>, Vector),
    /// The relative error of both cuts.
    error: f64,
}

/// A patch with the integral over it.
struct Part {
    patch: Patch,
    area: f64,
    /// Its share of the change when it was split off its parent patch, and of the doubt about it.
    change: f64,
    doubt: f64,
}

/// The patches of an outline by a few points of each.
struct Few {
    /// The patches, each with the differences between its points as change and doubt.
    parts: Vec<Part>,
    /// Whether the form factor is an analytic function of the point in each patch.
    is_one_aspect: bool,
}

impl Few {
    fn area(&self) -> f64 {
        self.parts.iter().map(|part| part.area).sum()
    }

    fn change(&self) -> f64 {
        self.parts.iter().map(|part| part.change).sum()
    }

    fn doubt(&self) -> f64 {
        self.parts.iter().map(|part| part.doubt).sum()
    }
}

impl Part {
    /// The integral over a patch by form factors times areas at its points.
    fn of(patch: Patch, values: &[f64; POINTS]) -> Self {
        Self { patch, area: values.iter().sum(), change: 0.0, doubt: 0.0 }
    }
}

impl Changes {
    fn with(mut self, part: &Part) -> Self {
        self.add(part.area, [part.change, part.doubt], QUARTERS as f64);
        self
    }

    fn without(mut self, part: &Part) -> Self {
        self.remove(part.area, [part.change, part.doubt], QUARTERS as f64);
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
    fn integral(&self, [tolerance, least]: [f64; 2], is_stopped: impl Fn() -> bool) -> Exchange {
        let mut work = Work::default();
        let goal = |area: f64| tolerance * area.abs().max(least);
        let few = self.by_few_points(&mut work);
        let [area, error] = [few.area(), few.doubt()];
        // between a few points, other things can be seen
        if few.is_one_aspect && error <= goal(area) {
            return Exchange { area, error: error + self.error * area };
        }
        let mut queue: BinaryHeap<Part> = BinaryHeap::new();
        queue.extend(few.parts.iter().flat_map(|whole| self.quarters(whole, &mut work)));
        let sum_of = |queue: &BinaryHeap<Part>| queue.iter().fold(Changes::default(), Changes::with);
        let mut sum = sum_of(&queue);
        while sum.error() > goal(sum.area) && queue.len() < MOST_PATCHES && !is_stopped() {
            let Some(worst) = queue.pop() else { break };
            let quarters = self.quarters(&worst, &mut work);
            sum = quarters.iter().fold(sum.without(&worst), Changes::with);
            queue.extend(quarters);
        }
        // the running sums have accumulated rounding errors
        let sum = sum_of(&queue);
        let (area, error) = (sum.area, sum.error());
        let size: f64 = queue.iter().map(|part| part.patch.area()).sum();
        Exchange { area, error: error + self.error * area + ROUNDING * f64::EPSILON * size }
    }

    /// Integrates by a few points of each patch.
    fn by_few_points(&self, work: &mut Work) -> Few {
        let mut few = Few { is_one_aspect: true, parts: Vec::new() };
        for patch in patches(&self.outline) {
            self.evaluate(&[patch], &patch, work);
            let values: &[f64; POINTS] = work.factors[..].try_into().expect("one rule");
            few.is_one_aspect &= work.borders.aspects() == Aspects::One;
            let [change, doubt] = doubt::of_few(values);
            few.parts.push(Part { change, doubt, ..Part::of(patch, values) });
        }
        few
    }

    /// Integrates over the quarters of a patch.
    fn quarters(&self, whole: &Part, work: &mut Work) -> [Part; QUARTERS] {
        let patches = whole.patch.quarters();
        self.evaluate(&patches, &whole.patch, work);
        let (values, _) = work.factors.as_chunks::<POINTS>();
        let mut parts: [Part; QUARTERS] =
            std::array::from_fn(|index| Part::of(patches[index], &values[index]));
        let change = parts.iter().map(|part| part.area).sum::<f64>() - whole.area;
        let doubt = doubt::of_kinks(values, work.borders.aspects()).max(change.abs());
        let share = 1.0 / QUARTERS as f64;
        parts.iter_mut().for_each(|part| (part.change, part.doubt) = (share * change, share * doubt));
        parts
    }

    /// Evaluates form factors times areas at the points of patches that lie within one patch.
    fn evaluate(&self, patches: &[Patch], within: &Patch, work: &mut Work) {
        let Work { points, areas, factors, view, borders } = work;
        points.clear();
        areas.clear();
        for patch in patches {
            patch.by_rule(gauss(ORDER), |point, area| {
                points.push(point);
                areas.push(area);
            });
        }
        let (vertices, normal) = &self.luminaire;
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
        factors.iter_mut().zip(areas).for_each(|(factor, area)| *factor *= *area);
    }
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
        self.doubt.total_cmp(&other.doubt)
    }
}
