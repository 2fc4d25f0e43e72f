//! Readings: a receiver becomes the numbers that it asks for. Each is a measure at a point, a mean
//! over a surface, or the radiance of the surface that a ray meets.

use crate::answer::Quantity;
use crate::faces::is_bright;
use crate::geometry::Vector;
use crate::radiosity::{GoalKind, Group, Measure, Radiosity, Scratch, Straight, Transport, reflectance};
use crate::scene::{Receiver, ReceiverKind, Scene};
use crate::visibility::{Face, ReceivingArea};
use std::collections::HashMap;
use std::f64::consts::PI;

/// Relative rounding error of a few products and quotients of numbers of the scene.
pub(crate) const OF_PRODUCT: f64 = 4.0 * f64::EPSILON;

/// One requested number, in each band.
#[derive(Clone, Debug)]
pub(crate) struct Reading {
    /// Index of the receiver.
    pub(crate) receiver: usize,
    pub(crate) quantity: Quantity,
    what: What,
}

/// Place where light arrives.
pub(crate) struct Place {
    pub(crate) outline: Vec<Vector>,
    /// Direction that it faces; `None` if it receives light from all sides.
    pub(crate) normal: Option<Vector>,
}

impl Place {
    /// Returns the place that is all of a face.
    pub(crate) fn of_face(face: &Face) -> Self {
        Self { outline: face.vertices.to_vec(), normal: Some(face.normal) }
    }
}

#[derive(Clone, Copy, Debug)]
enum What {
    At { position: Vector, measure: Measure },
    Mean { area: ReceivingArea, is_flux: bool },
    Ray { origin: Vector, direction: Vector },
}

/// Returns the group of each reading, named by the first reading in it. The components of vector
/// irradiance and the fluence rate of one receiver are a group, and so are the points, faces or
/// watched cells of one map. Any other reading is alone.
pub(crate) fn groups(readings: &[Reading], answers: usize) -> Vec<usize> {
    let mut first = HashMap::new();
    let group = |(index, reading): (usize, &Reading)| {
        let is_vector = matches!(reading.quantity, Quantity::VectorIrradiance(_) | Quantity::FluenceRate);
        if is_vector || index >= answers { *first.entry(reading.receiver).or_insert(index) } else { index }
    };
    readings.iter().enumerate().map(group).collect()
}

impl Reading {
    /// Returns the readings that a receiver asks for, in the order of its answers.
    pub(crate) fn of(index: usize, receiver: &Receiver) -> Vec<Self> {
        let reading = |quantity, what| Self { receiver: index, quantity, what };
        match receiver.kind {
            ReceiverKind::Point { position, normal } => {
                vec![Self::irradiance(index, position, normal)]
            }
            ReceiverKind::Surface { .. } | ReceiverKind::Faces { .. } => {
                let mean = |(area, (quantity, is_flux))| reading(quantity, What::Mean { area, is_flux });
                let both = [(Quantity::Irradiance, false), (Quantity::Flux, true)];
                receiver.kind.side().into_iter().flat_map(|side| both.map(|of| mean((side, of)))).collect()
            }
            ReceiverKind::Ray { origin, direction } => {
                vec![reading(Quantity::Radiance, What::Ray { origin, direction })]
            }
            ReceiverKind::Sphere { position } => Self::all_around(index, position).collect(),
            ReceiverKind::Points(_) | ReceiverKind::Camera(_) => Vec::new(),
        }
    }

    /// Returns all readings that the receivers of a scene ask for, and the number of those that are
    /// answers; the others are of listed points and faces.
    pub(crate) fn requested(scene: &Scene) -> (Vec<Self>, usize) {
        let receivers = || scene.receivers.iter().enumerate();
        let mut readings: Vec<Self> =
            receivers().flat_map(|(index, receiver)| Self::of(index, receiver)).collect();
        let answers = readings.len();
        readings.extend(receivers().flat_map(|(index, receiver)| Self::cells(index, receiver, scene)));
        (readings, answers)
    }

    /// Returns the readings at the points of a receiver, point by point, or on its faces.
    pub(crate) fn cells(index: usize, receiver: &Receiver, scene: &Scene) -> impl Iterator<Item = Self> {
        let mean = move |area| Self {
            receiver: index,
            quantity: Quantity::Irradiance,
            what: What::Mean { area, is_flux: false },
        };
        let points =
            if let ReceiverKind::Points(points) = &receiver.kind { Some(points.iter()) } else { None };
        let at = move |(position, normal): (Vector, Option<Vector>)| {
            let plane = normal.map(|normal| Self::irradiance(index, position, normal));
            let around = normal.is_none().then(|| Self::all_around(index, position));
            plane.into_iter().chain(around.into_iter().flatten())
        };
        points.into_iter().flatten().flat_map(at).chain(receiver.kind.faces(scene).map(mean))
    }

    /// Returns the fluence rate and the components of the vector irradiance at a point.
    fn all_around(receiver: usize, position: Vector) -> impl Iterator<Item = Self> {
        let quantities = Quantity::ALL_AROUND.into_iter().zip(Measure::ALL_SIDES);
        quantities.map(move |(quantity, measure)| Self {
            receiver,
            quantity,
            what: What::At { position, measure },
        })
    }

    /// Returns the irradiance at a point.
    pub(crate) fn irradiance(receiver: usize, position: Vector, normal: Vector) -> Self {
        let what = What::At { position, measure: Measure::Plane(normal) };
        Self { receiver, quantity: Quantity::Irradiance, what }
    }

    /// Returns the radiance that arrives along a ray.
    pub(crate) fn radiance(receiver: usize, origin: Vector, direction: Vector) -> Self {
        Self { receiver, quantity: Quantity::Radiance, what: What::Ray { origin, direction } }
    }

    /// Returns the error of direct light by quadrature, and by rounding where it is a closed form;
    /// `None` where it is summed over nodes.
    pub(crate) fn straight_error(&self, radiosity: &Radiosity, band: usize) -> Option<[f64; 2]> {
        let What::Mean { area, is_flux } = self.what else { return Some([0.0; 2]) };
        let errors = radiosity.straight_error(area, band)?;
        let unit = if is_flux { 1.0 } else { radiosity.transport().size_of(area) };
        Some(errors.map(|error| error / unit))
    }

    /// Returns its value in each band.
    pub(crate) fn value(&self, scene: &Scene, radiosity: &Radiosity, scratch: &mut Scratch) -> Vec<f64> {
        match self.what {
            What::At { position, measure } => at(position, measure, radiosity, scratch),
            What::Mean { area, is_flux } => {
                let (mean, size) = radiosity.mean(area);
                let unit = if is_flux { size } else { 1.0 };
                mean.into_iter().map(|value| unit * value).collect()
            }
            What::Ray { origin, direction } => along(scene, [origin, direction], radiosity, scratch),
        }
    }

    /// Whether it is a mean over a surface, or a mean times the area of the surface.
    pub(crate) fn is_mean(&self) -> bool {
        matches!(self.what, What::Mean { .. })
    }

    /// Returns the point at which it is a measure, if it is one, and its value under a radiance of
    /// 1 from everywhere.
    pub(crate) fn at_point(&self) -> Option<(Vector, f64)> {
        let What::At { position, measure } = self.what else { return None };
        Some((position, PI * measure.whole().max(1.0)))
    }

    /// Returns the direct light in double-double; `None` where it is summed over nodes, or arrives
    /// along a ray. A `watched` reading represents others, so shapes are seen as from those others.
    pub(crate) fn precise(
        &self,
        is_watched: bool,
        radiosity: &Radiosity,
        scratch: &mut Scratch,
    ) -> Option<Straight> {
        let counts_direct = radiosity.counts_direct() || matches!(self.what, What::Ray { .. });
        if !counts_direct {
            let nothing = vec![[0.0; 2]; radiosity.band_count()];
            return Some(Straight { bands: nothing, has_pieces: false });
        }
        match self.what {
            What::At { position, measure } => {
                let transport = radiosity.transport();
                Some(radiosity.lights().precisely((position, measure), !is_watched, transport, scratch))
            }
            What::Mean { area, is_flux } => {
                let bands = radiosity.precise_mean(area, is_flux)?;
                Some(Straight { bands, has_pieces: true })
            }
            What::Ray { .. } => None,
        }
    }

    /// Returns a bound on the rounding error of its values where they are direct light.
    pub(crate) fn rounding(&self, values: &[f64], scene: &Scene, radiosity: &Radiosity) -> Vec<f64> {
        let transport = radiosity.transport();
        let at = |position, measure, on| radiosity.lights().rounding((position, measure), on, transport);
        let of_values = values.iter().map(|value| OF_PRODUCT * value.abs());
        match self.what {
            What::At { position, measure } => at(position, measure, None),
            What::Mean { .. } => of_values.collect(),
            What::Ray { origin, direction } => match met_bright(scene, [origin, direction], transport) {
                None => of_values.collect(),
                Some(Met { surface, face, position, .. }) => {
                    let arriving = at(position, Measure::Plane(face.normal), Some(face)).into_iter();
                    let reflected =
                        arriving.zip(reflectance(scene, surface)).map(|(error, rho)| rho / PI * error);
                    of_values.zip(reflected).map(|(own, reflected)| own + reflected).collect()
                }
            },
        }
    }

    /// Returns the goal that it sets for a solution, if any.
    pub(crate) fn goal(&self, scene: &Scene, transport: &Transport) -> Option<GoalKind> {
        match self.what {
            What::At { position, measure } => Some(GoalKind::At { position, measure }),
            What::Mean { area, .. } => Some(GoalKind::Mean { area }),
            What::Ray { origin, direction } => {
                let met = met_bright(scene, [origin, direction], transport)?;
                Some(GoalKind::At { position: met.position, measure: Measure::Plane(met.face.normal) })
            }
        }
    }

    /// Returns the factor of its goal: a mean is an integral over a surface, divided by its area.
    pub(crate) fn of_goal(&self, transport: &Transport) -> f64 {
        match self.what {
            What::Mean { area, is_flux: false } => 1.0 / transport.size_of(area),
            What::Mean { .. } | What::At { .. } | What::Ray { .. } => 1.0,
        }
    }

    /// Returns, for each band, the offset and the factor that turn the number of its goal into its
    /// value.
    pub(crate) fn made_of(&self, scene: &Scene, transport: &Transport) -> Vec<[f64; 2]> {
        let unchanged = |factor| vec![[0.0, factor]; scene.band_count()];
        match self.what {
            What::At { .. } | What::Mean { is_flux: false, .. } => unchanged(1.0),
            What::Mean { area, is_flux: true } => unchanged(transport.size_of(area)),
            What::Ray { origin, direction } => match met(scene, [origin, direction], transport) {
                None => scene.ambient.radiance.iter().map(|&outside| [outside, 0.0]).collect(),
                Some(Met { is_bright: false, .. }) => unchanged(0.0),
                Some(Met { surface, .. }) => {
                    let bands = scene.surfaces[surface].radiance.iter().zip(reflectance(scene, surface));
                    bands.map(|(&emitted, rho)| [emitted, rho / PI]).collect()
                }
            },
        }
    }

    /// Returns, for each band, its possible error because of the shadow boundaries of point and
    /// distant lights on elements, and because of the light that their nodes miss.
    pub(crate) fn doubts(&self, scene: &Scene, radiosity: &Radiosity, scratch: &mut Scratch) -> Vec<f64> {
        let transport = radiosity.transport();
        let mut doubts = match self.goal(scene, transport) {
            Some(goal) if radiosity.is_doubtful() => radiosity.doubt(goal, scratch),
            _ => return vec![0.0; scene.band_count()],
        };
        if self.is_mean() {
            doubts.iter_mut().for_each(|doubt| *doubt *= self.of_goal(transport));
        } else {
            let made_of = self.made_of(scene, transport);
            doubts.iter_mut().zip(made_of).for_each(|(doubt, [_, factor])| *doubt *= factor);
        }
        doubts
    }

    /// Returns the places whose arriving light it measures.
    pub(crate) fn places(&self, scene: &Scene, transport: &Transport) -> Vec<Place> {
        match self.what {
            What::At { position, measure } => {
                let normal = if let Measure::Plane(normal) = measure { Some(normal) } else { None };
                vec![Place { outline: vec![position], normal }]
            }
            What::Mean { area, .. } => transport.faces_in(area).map(Place::of_face).collect(),
            What::Ray { origin, direction } => {
                let met = met_bright(scene, [origin, direction], transport).into_iter();
                met.map(|met| Place { outline: vec![met.position], normal: Some(met.face.normal) }).collect()
            }
        }
    }

    /// Returns its largest value under an irradiance of 1 at these places.
    pub(crate) fn of_irradiance(&self, scene: &Scene, transport: &Transport) -> f64 {
        match self.what {
            What::At { .. } | What::Mean { is_flux: false, .. } => 1.0,
            What::Mean { area, is_flux: true } => transport.size_of(area),
            What::Ray { origin, direction } => {
                let met = met_bright(scene, [origin, direction], transport);
                let reflectances = met.iter().flat_map(|met| reflectance(scene, met.surface));
                reflectances.copied().fold(0.0, f64::max) / PI
            }
        }
    }

    /// Returns its largest value under an incident radiance of 1 from everywhere.
    pub(crate) fn largest(&self, transport: &Transport) -> f64 {
        match self.what {
            What::At { measure: Measure::Sphere, .. } => 4.0 * PI,
            What::At { .. } | What::Mean { is_flux: false, .. } => PI,
            What::Mean { area, is_flux: true } => PI * transport.size_of(area),
            What::Ray { .. } => 1.0,
        }
    }
}

fn at(position: Vector, measure: Measure, radiosity: &Radiosity, scratch: &mut Scratch) -> Vec<f64> {
    let points = [position];
    let group = Group { points: &points, outline: &points, measure };
    radiosity.reaching(group, scratch).swap_remove(0)
}

/// Returns the radiance along a ray: L = Lₑ + ρ E/π on a face that it sees from its front, zero on
/// a black back, and the light from outside where it meets nothing. Lₑ and the light from outside
/// are direct light: they are zero where that is left out.
fn along(scene: &Scene, ray: [Vector; 2], radiosity: &Radiosity, scratch: &mut Scratch) -> Vec<f64> {
    let seen = radiosity.question.seen_part();
    let Some(met) = met(scene, ray, radiosity.transport()) else {
        return scene.ambient.radiance.iter().map(|outside| seen * outside).collect();
    };
    let Met { surface: index, face, position, is_bright } = met;
    if !is_bright {
        return vec![0.0; scene.band_count()];
    }
    let surface = &scene.surfaces[index];
    let points = [position];
    let group = Group { points: &points, outline: &points, measure: Measure::Plane(face.normal) };
    let mut arriving = vec![0.0; scene.band_count()];
    radiosity.gather_seen(group, scratch, &mut arriving);
    let bands = surface.radiance.iter().zip(reflectance(scene, index)).zip(arriving);
    // E/π is the radiance of a surface that sends E equally in all directions
    bands.map(|((emitted, rho), arriving)| seen * emitted + rho * arriving / PI).collect()
}

/// First surface along a ray.
struct Met<'t> {
    surface: usize,
    /// The face on the side that the ray sees.
    face: &'t Face,
    position: Vector,
    /// Whether that side sends light at all.
    is_bright: bool,
}

/// Returns the first surface along a ray, if it sends light to the ray's origin.
fn met_bright<'t>(scene: &Scene, ray: [Vector; 2], transport: &'t Transport) -> Option<Met<'t>> {
    met(scene, ray, transport).filter(|met| met.is_bright)
}

fn met<'t>(scene: &Scene, [origin, direction]: [Vector; 2], transport: &'t Transport) -> Option<Met<'t>> {
    let hit = transport.screens.first(origin, direction)?;
    let face = &transport.faces[hit.face];
    let position = origin + hit.distance * direction;
    Some(Met { surface: face.surface, face, position, is_bright: is_bright(scene, face) })
}
