//! Shells: scenes of concentric spheres, whose light is the same at all points of a side, so that
//! the Neumann series of all reflections has a closed form.
//!
//! ```text
//! spheres, by radius ─▶ gaps between them ─ two equations ─▶ radiance of both sides of a gap
//! receiver ─ its gap ─▶ the radiance of the inner sphere where it is seen, of the outer one elsewhere
//! ```
//! Between an outer side b and an inner side a with the radii R > r, the part q = r²/R² of the
//! light from b arrives at a, and the rest at b again; all light from a arrives at b:
//! ```text
//! Lₐ = Lₑₐ + ρₐ L_b        L_b = Lₑ_b + ρ_b (q Lₐ + (1 − q) L_b)
//! ```
//! The first sphere has nothing inside, and around the last one are the surroundings.

use super::measure::Measure;
use super::reflectance;
use crate::answer::{Answer, ErrorKind, ErrorParts, Moment, Quantity, Simulation};
use crate::effects::{Hiding, SimulatedEffects};
use crate::form_factor::double_double::{Rounded, SeenWhole};
use crate::geometry::{Sphere, Vector};
use crate::progress::Progress;
use crate::radiosity::driver::ROUNDING;
use crate::scene::{Effect, MaterialKind, Receiver, ReceiverKind, Scene, Shape, SurfaceSide};
use crate::used_kernel::UsedKernel;
use forms::math::Real;
use forms_kernels::{form_factor_point_sphere, solid_angle_sphere};
use std::f64::consts::PI;

/// Rounding error of a few products, and of radiances after all reflections.
const OF_PRODUCT: f64 = 4.0 * f64::EPSILON;
const REFLECTED: f64 = 16.0 * f64::EPSILON;

/// Concentric spheres, from the smallest on, and the light between them.
#[derive(Clone, Debug)]
pub(crate) struct Shells {
    spheres: Vec<(usize, Sphere)>,
    /// The gap inside the first sphere, those between spheres, and the space around the last one.
    gaps: Vec<Gap>,
    /// Rounding error of the radiances, relative to them.
    of_radiances: f64,
}

/// What holds for the inner and the outer side of a gap, in each band.
#[derive(Clone, Debug)]
struct Gap {
    /// The radiance that points of the gap receive.
    radiance: [Vec<f64>; 2],
    irradiance: [Vec<f64>; 2],
    /// The radiance that a ray sees: the reflection by the side itself is not one of the orders.
    seen: [Vec<f64>; 2],
}

/// A side of a gap in one band: what it emits, and what part it reflects.
#[derive(Clone, Copy, Default)]
struct Side {
    emitted: f64,
    reflectance: f64,
}

impl Shells {
    /// Returns the shells of a scene of diffuse surfaces in a vacuum, if it consists of nothing else
    /// and its receivers are surfaces, points that are not on a sphere, and rays.
    pub(crate) fn of(scene: &Scene, effects: &SimulatedEffects) -> Option<Self> {
        let is_hidden = effects.hiding != Hiding::LeftOut;
        let diffuse = |kind: &MaterialKind| matches!(kind, MaterialKind::Diffuse { .. });
        let are_diffuse = scene.surfaces.iter().all(|one| diffuse(&scene.materials[one.material].kind));
        if !is_hidden || !are_diffuse || !scene.lights.is_empty() {
            return None;
        }
        let spheres = concentric(scene)?;
        let reflects =
            (0..scene.surfaces.len()).any(|index| reflectance(scene, index).iter().any(|&part| part > 0.0));
        let of_radiances = if reflects { REFLECTED } else { 0.0 };
        let mut shells = Self { spheres, gaps: Vec::new(), of_radiances };
        shells.gaps = (0..=shells.spheres.len()).map(|gap| shells.solved(scene, effects, gap)).collect();
        let are_answered = scene.receivers.iter().all(|receiver| shells.values(scene, receiver).is_some());
        are_answered.then_some(shells)
    }

    /// Returns the sphere on a side of a gap, and whether the side is its inside.
    fn sphere(&self, gap: usize, is_outer: bool) -> Option<&(usize, Sphere)> {
        if is_outer { self.spheres.get(gap) } else { self.spheres.get(gap.checked_sub(1)?) }
    }

    /// Returns a side of a gap.
    fn side(&self, scene: &Scene, (gap, is_outer): (usize, bool), band: usize) -> Side {
        let Some(&(index, sphere)) = self.sphere(gap, is_outer) else {
            let emitted = if is_outer { scene.ambient.radiance[band] } else { 0.0 };
            return Side { emitted, reflectance: 0.0 };
        };
        let surface = &scene.surfaces[index];
        if sphere.inward == is_outer || surface.two_sided {
            Side { emitted: surface.radiance[band], reflectance: reflectance(scene, index)[band] }
        } else {
            Side::default()
        }
    }

    /// Returns the light in a gap after the orders of reflection that are simulated. Without direct
    /// light, that of a point is reflected at least once, R = ρ T L with one order less in L; and a ray
    /// sees what its side reflects.
    fn solved(&self, scene: &Scene, effects: &SimulatedEffects, gap: usize) -> Gap {
        let to_inner_and_outer = self.shares(gap);
        let of_band = |band: usize| {
            let sides = [false, true].map(|is_outer| self.side(scene, (gap, is_outer), band));
            let arriving = |[a, b]: [f64; 2]| {
                let [to_inner, to_outer] = to_inner_and_outer;
                [b, to_inner * a + to_outer * b]
            };
            let sent = |orders: Option<u32>| match orders {
                None => all_orders(sides, to_inner_and_outer),
                Some(orders) => reflected(sides, orders, arriving),
            };
            let again = |light: [f64; 2]| [0, 1].map(|side| sides[side].reflectance * arriving(light)[side]);
            let reflected = again(sent(effects.orders));
            if effects.has(Effect::Direct) {
                let radiance = sent(effects.orders);
                let seen = [0, 1].map(|side| sides[side].emitted + reflected[side]);
                return [radiance, arriving(radiance).map(|value| PI * value), seen];
            }
            let radiance = match effects.orders {
                None => reflected,
                Some(0) => [0.0; 2],
                Some(orders) => again(sent(Some(orders - 1))),
            };
            [radiance, arriving(radiance).map(|value| PI * value), reflected]
        };
        let bands: Vec<[[f64; 2]; 3]> = (0..scene.band_count()).map(of_band).collect();
        let [radiance, irradiance, seen] = [0, 1, 2]
            .map(|quantity| [0, 1].map(|side| bands.iter().map(|band| band[quantity][side]).collect()));
        Gap { radiance, irradiance, seen }
    }

    /// Returns q and 1 − q of a gap: the parts of what leaves its outer side that arrive at its inner
    /// and at its outer side.
    fn shares(&self, gap: usize) -> [f64; 2] {
        let radius = |is_outer: bool| self.sphere(gap, is_outer).map(|(_, sphere)| sphere.radius);
        match [radius(false), radius(true)] {
            [Some(inner), Some(outer)] => {
                [(inner / outer).powi(2), (outer - inner) / outer * ((outer + inner) / outer)]
            }
            [None, Some(_)] => [0.0, 1.0],
            [_, None] => [0.0; 2],
        }
    }

    /// Returns the index of the gap around a point; `None` for a point on a sphere, up to rounding.
    fn gap(&self, point: Vector) -> Option<usize> {
        let away = self.spheres.first().map(|(_, sphere)| (point - sphere.center).length())?;
        let is_on = |sphere: &Sphere| (away - sphere.radius).abs() <= ROUNDING * away;
        let is_clear = !self.spheres.iter().any(|(_, sphere)| is_on(sphere));
        is_clear.then(|| self.spheres.iter().filter(|(_, sphere)| sphere.radius < away).count())
    }

    /// Returns what a receiver asks for, each with its values in all bands and a bound on their
    /// error; `None` if that has no closed form.
    fn values(&self, scene: &Scene, receiver: &Receiver) -> Option<Vec<(Quantity, Vec<[f64; 2]>)>> {
        if receiver.time.is_some() {
            return None;
        }
        match receiver.kind {
            ReceiverKind::Surface { surface, side, grid: None } => self.at_surface(surface, side),
            ReceiverKind::Point { position, normal } => {
                Some(vec![(Quantity::Irradiance, self.at(scene, position, Measure::Plane(normal))?)])
            }
            ReceiverKind::Sphere { position } => {
                let measured = Quantity::ALL_AROUND.into_iter().zip(Measure::ALL_SIDES);
                measured
                    .map(|(quantity, measure)| Some((quantity, self.at(scene, position, measure)?)))
                    .collect()
            }
            ReceiverKind::Ray { origin, direction } => {
                let gap = &self.gaps[self.gap(origin)?];
                let is_outer = !self.meets_inner(origin, direction)?;
                let radiance = gap.seen[usize::from(is_outer)].iter();
                Some(vec![(
                    Quantity::Radiance,
                    radiance.map(|&value| [value, (OF_PRODUCT + self.of_radiances) * value]).collect(),
                )])
            }
            ReceiverKind::Surface { .. }
            | ReceiverKind::Faces { .. }
            | ReceiverKind::Points(_)
            | ReceiverKind::Camera(_) => None,
        }
    }

    /// Returns irradiance and flux of a side of a surface.
    fn at_surface(&self, surface: usize, side: SurfaceSide) -> Option<Vec<(Quantity, Vec<[f64; 2]>)>> {
        let place = self.spheres.iter().position(|(index, _)| *index == surface)?;
        let sphere = self.spheres[place].1;
        // the inside of a sphere is the outer side of the gap within it
        let is_inside = sphere.inward == (side == SurfaceSide::Front);
        let values =
            if is_inside { &self.gaps[place].irradiance[1] } else { &self.gaps[place + 1].irradiance[0] };
        let scaled = |factor: f64| {
            values
                .iter()
                .map(|&value| factor * value)
                .map(|value| [value, (OF_PRODUCT + self.of_radiances) * value])
                .collect()
        };
        Some(vec![(Quantity::Irradiance, scaled(1.0)), (Quantity::Flux, scaled(sphere.area()))])
    }

    /// Returns a measure at a point: that of the inner sphere, and that of all directions without it.
    fn at(&self, scene: &Scene, point: Vector, measure: Measure) -> Option<Vec<[f64; 2]>> {
        let index = self.gap(point)?;
        let of_inner = match self.sphere(index, false) {
            Some((_, sphere)) => {
                let seen: &dyn SeenWhole = sphere;
                measure.of_whole(point, seen)?
            }
            None => Rounded::exactly(0.0),
        };
        let all = match measure {
            Measure::Plane(_) => 1.0,
            Measure::Sphere => 4.0,
            Measure::Flow(_) => 0.0,
        };
        let of_outer = Rounded::exactly(all) + of_inner.times(-1.0);
        let radiance = &self.gaps[index].radiance;
        let value = |band: usize| {
            let [inner, outer] =
                [of_inner.times_datum(radiance[0][band]), of_outer.times_datum(radiance[1][band])];
            let size = PI * (inner.value.to_f64().abs() + outer.value.to_f64().abs());
            let [value, error] = (inner + outer).times_pi().nearest();
            [value, error + self.of_radiances * size]
        };
        Some((0..scene.band_count()).map(value).collect())
    }

    /// Whether a ray meets the inner sphere of its gap; `None` if it grazes it, up to rounding.
    fn meets_inner(&self, origin: Vector, direction: Vector) -> Option<bool> {
        let Some((_, sphere)) = self.sphere(self.gap(origin)?, false) else { return Some(false) };
        let way = sphere.center - origin;
        let along = way.dot(direction);
        let beside = (way - along * direction).length() - sphere.radius;
        let grazes = beside.abs() <= ROUNDING * way.length();
        (!grazes).then_some(along > 0.0 && beside < 0.0)
    }

    /// Returns the kernels that its answers run.
    pub(crate) fn kernels(scene: &Scene) -> Vec<UsedKernel> {
        let asks = |is: fn(&ReceiverKind) -> bool| scene.receivers.iter().any(|receiver| is(&receiver.kind));
        let points = asks(|kind| matches!(kind, ReceiverKind::Point { .. }));
        let spheres = asks(|kind| matches!(kind, ReceiverKind::Sphere { .. }));
        let of_point = points.then(|| {
            let operations = form_factor_point_sphere::OPERATIONS;
            UsedKernel::whole("form_factor_point_sphere", operations, "form factor of a whole sphere")
        });
        let of_sphere = spheres.then(|| {
            UsedKernel::whole(
                "solid_angle_sphere",
                solid_angle_sphere::OPERATIONS,
                "solid angle of a whole sphere",
            )
        });
        of_point.into_iter().chain(of_sphere).collect()
    }

    /// Returns the results.
    pub(crate) fn simulation(&self, scene: &Scene, progress: &Progress<'_>) -> Simulation {
        let mut answers = Vec::new();
        for receiver in &scene.receivers {
            for (quantity, values) in self.values(scene, receiver).into_iter().flatten() {
                let count = values.len();
                answers.extend(values.into_iter().enumerate().map(|(band, [value, error])| Answer {
                    receiver: receiver.name.clone(),
                    quantity,
                    band: (count > 1).then_some(band),
                    bin: None,
                    value,
                    error,
                    parts: ErrorParts { rounding: error, ..ErrorParts::default() },
                    kind: ErrorKind::Bound,
                    seconds: 0.0,
                }));
            }
        }
        let relative =
            |answer: &Answer| if answer.error > 0.0 { answer.error / answer.value.abs() } else { 0.0 };
        let error = answers.iter().map(relative).filter(|error| error.is_finite()).fold(0.0, f64::max);
        let seconds = progress.seconds();
        Simulation { answers, history: vec![Moment { seconds, error }], seconds, ..Simulation::default() }
    }
}

/// Returns the spheres of a scene of nothing else, each with its index, from the smallest on, if they
/// have one centre and no two have one radius.
fn concentric(scene: &Scene) -> Option<Vec<(usize, Sphere)>> {
    let sphere = |(index, surface): (usize, &crate::scene::Surface)| match surface.shape {
        Shape::Sphere(sphere) => Some((index, sphere)),
        _ => None,
    };
    let mut spheres = scene.surfaces.iter().enumerate().map(sphere).collect::<Option<Vec<_>>>()?;
    spheres.sort_by(|(_, a), (_, b)| a.radius.total_cmp(&b.radius));
    let center = spheres.first()?.1.center;
    let are_distinct = spheres.windows(2).all(|pair| pair[0].1.radius < pair[1].1.radius);
    (are_distinct && spheres.iter().all(|(_, sphere)| sphere.center == center)).then_some(spheres)
}

/// Returns the radiance of the inner and of the outer side after all reflections.
fn all_orders([inner, outer]: [Side; 2], [q, _]: [f64; 2]) -> [f64; 2] {
    let [a, b] = [inner.reflectance, outer.reflectance];
    let sent = outer.emitted + b * q * inner.emitted;
    let radiance = if sent > 0.0 { sent / ((1.0 - b) + b * q * (1.0 - a)) } else { 0.0 };
    [inner.emitted + a * radiance, radiance]
}

/// Returns the same after up to this many reflections.
fn reflected([inner, outer]: [Side; 2], orders: u32, arriving: impl Fn([f64; 2]) -> [f64; 2]) -> [f64; 2] {
    let mut radiance = [inner.emitted, outer.emitted];
    for _ in 0..orders {
        let [a, b] = arriving(radiance);
        let next = [inner.emitted + inner.reflectance * a, outer.emitted + outer.reflectance * b];
        if std::mem::replace(&mut radiance, next) == next {
            break;
        }
    }
    radiance
}

#[cfg(test)]
mod tests;
