//! Luminaires: what emits light becomes directions in which light comes straight from it.
//!
//! ```text
//! triangle   uniform over its solid angle            disk   uniform over its area
//! sphere     uniform over the cone that it fills, seen from outside; uniform over its area from inside
//! point, distant light: the one direction that there is
//! ```
//! Which luminaire is taken is a [choice](super::choice) by what each may bring; of points and distant lights all are where they are few. Densities
//! are of solid angle, and are what a direction has that was found in another way.
//!
//! A luminaire that is [`near`](super::near) is found by chance, and is not looked for: its density is zero there.

use super::choice::{Choice, Sought, Weight};
use super::near::Near;
use super::optics::largest;
use super::warps::{
    spherical_triangle_pdf, spherical_triangle_sample, uniform_cone_pdf, uniform_cone_sample,
    uniform_disk_sample, uniform_sphere_sample, uniform_triangle_sample,
};
use super::world::Sheet;
use crate::geometry::{Disk, Met, Sphere, Vector, Wall};
use crate::kernels::{measure_area_to_solid_angle, measure_solid_angle_to_area};
use crate::sampling::{Frame, Samples, chosen};
use crate::scene::{LightKind, Scene};
use std::f64::consts::PI;
use std::ops::Range;

/// So many points and distant lights are all looked for; of more one is chosen.
const FEW_BEAMS: usize = 16;

/// All luminaires of a scene.
pub(super) struct Luminaires {
    /// Those that are walls.
    walls: Vec<Luminaire>,
    choice_of_walls: Choice,
    /// Those that are points or far away.
    beams: Vec<Luminaire>,
    choice_of_beams: Choice,
    /// The part of the power of each of all these and of those before it.
    powers: Vec<f64>,
    /// The luminaires of each wall.
    of_walls: Vec<Range<usize>>,
    /// By wall the points from which its luminaires are not looked for.
    near: Vec<Option<Near>>,
    /// What is known of all together.
    all: Weight,
}

/// Something that emits light.
pub(super) struct Luminaire {
    pub(super) source: Source,
    form: Form,
}

/// Where the optical numbers of a luminaire are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Source {
    /// A wall of this index, of this surface.
    Wall { wall: usize, surface: usize },
    /// A light of this index.
    Beam(usize),
}

#[derive(Clone, Copy, Debug)]
enum Form {
    Triangle([Vector; 3]),
    Disk(Disk),
    Sphere(Sphere),
    Point(Vector),
    /// The unit vector along which the light travels.
    Distant(Vector),
}

/// A direction to a luminaire.
#[derive(Clone, Copy, Debug)]
pub(super) struct Towards {
    pub(super) source: Source,
    pub(super) direction: Vector,
    /// How far it is, if it is a point; without end else.
    pub(super) reach: f64,
    /// The density of the direction, of which the choice of the luminaire is part; of a beam the reciprocal of what its intensity or
    /// irradiance is multiplied by.
    pub(super) density: f64,
    /// How likely the luminaire was chosen.
    pub(super) chance: f64,
}

impl Luminaires {
    pub(super) fn of(scene: &Scene, shapes: &[Wall], sheets: &[Sheet]) -> Self {
        let (mut walls, mut weights, mut powers, mut of_walls) =
            (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut near = Vec::with_capacity(shapes.len());
        for (wall, (shape, sheet)) in shapes.iter().zip(sheets).enumerate() {
            let first = walls.len();
            let surface = &scene.surfaces[sheet.surface];
            let radiance = largest(&surface.radiance);
            if radiance > 0.0 {
                let sides = if surface.two_sided { 2.0 } else { 1.0 };
                let source = Source::Wall { wall, surface: sheet.surface };
                for form in forms(shape) {
                    powers.push(sides * PI * radiance * form.area());
                    let before = shape.plane().filter(|_| !surface.two_sided);
                    weights.push(Weight { before, ..form.weight(radiance) });
                    walls.push(Luminaire { source, form });
                }
            }
            of_walls.push(first..walls.len());
            near.push((radiance > 0.0).then(|| Near::of(shape)));
        }
        let extent = extent(shapes);
        let (mut beams, mut weights_of_beams) = (Vec::new(), Vec::new());
        for (index, light) in scene.lights.iter().enumerate() {
            let (form, value) = match &light.kind {
                LightKind::Point { position, intensity } => (Form::Point(*position), largest(intensity)),
                LightKind::Distant { direction, irradiance } => {
                    (Form::Distant(*direction), largest(irradiance))
                }
            };
            let solid = if let Form::Point(_) = form { 4.0 } else { extent * extent };
            powers.push(PI * solid * value);
            weights_of_beams.push(form.weight(value));
            beams.push(Luminaire { source: Source::Beam(index), form });
        }
        let whole: f64 = powers.iter().sum();
        let mut sum = 0.0;
        for power in &mut powers {
            sum += *power / whole;
            *power = sum;
        }
        let all = Weight::together(weights.iter().chain(&weights_of_beams));
        let [choice_of_walls, choice_of_beams] = [weights, weights_of_beams].map(Choice::among);
        Self { walls, choice_of_walls, beams, choice_of_beams, powers, of_walls, near, all }
    }

    /// Whether a ray can meet any.
    pub(super) fn are_met(&self) -> bool {
        !self.walls.is_empty()
    }

    /// Where luminaires are looked for along a segment: as far as any is abreast of it.
    pub(super) fn sought_along(&self, from: Vector, direction: Vector, length: f64) -> Sought {
        let farthest = (from - self.all.middle).length() + self.all.radius;
        Sought::along(from, from + length.min(farthest) * direction)
    }

    /// A wall that is looked for, if any is, and how likely it was chosen.
    pub(super) fn wall(&self, sought: Sought, samples: &mut Samples) -> Option<(&Luminaire, f64)> {
        if self.walls.is_empty() {
            return None;
        }
        let (place, chance) = self.choice_of_walls.choose(sought, samples.one())?;
        let luminaire = &self.walls[place];
        let is_near =
            matches!(luminaire.source, Source::Wall { wall, .. } if self.is_near(wall, sought.from));
        (!is_near).then_some((luminaire, chance))
    }

    /// The beams that are looked for, each with how likely it was chosen: all where they are few.
    pub(super) fn beams<'l>(
        &'l self,
        sought: Sought,
        samples: &mut Samples,
    ) -> impl Iterator<Item = (&'l Luminaire, f64)> + use<'l> {
        let are_few = self.beams.len() <= FEW_BEAMS;
        let one = if are_few { None } else { self.choice_of_beams.choose(sought, samples.one()) };
        let all = if are_few { &self.beams[..] } else { &[] };
        all.iter().map(|beam| (beam, 1.0)).chain(one.map(|(place, chance)| (&self.beams[place], chance)))
    }

    /// Whether the luminaires of a wall are not looked for from a point.
    fn is_near(&self, wall: usize, from: Vector) -> bool {
        self.near[wall].as_ref().is_some_and(|near| near.holds(from))
    }

    /// The surface of a luminaire by a number from 0 to 1, each as likely as its part of the power; none where that is a beam.
    pub(super) fn emitting(&self, number: f64) -> Option<usize> {
        match self.walls.get(chosen(&self.powers, number)?)?.source {
            Source::Wall { surface, .. } => Some(surface),
            Source::Beam(_) => None,
        }
    }

    /// The density that a direction from a point to the wall that it meets has among those that [`wall`](Self::wall) and
    /// [`towards`](Luminaire::towards) take.
    pub(super) fn density(&self, sought: Sought, from: Vector, direction: Vector, met: &Met) -> f64 {
        if self.is_near(met.wall, sought.from) {
            return 0.0;
        }
        let density = |place: usize| {
            let density = self.walls[place].form.density(from, direction, met);
            if density > 0.0 { self.choice_of_walls.chance(sought, place) * density } else { 0.0 }
        };
        self.of_walls[met.wall].clone().map(density).sum()
    }
}

impl Luminaire {
    /// A direction from a point, by a point of the unit square, where the luminaire was chosen with this chance. None where it cannot be
    /// seen from there.
    pub(super) fn towards(&self, from: Vector, square: [f64; 2], chance: f64) -> Option<Towards> {
        let (direction, reach, density) = self.form.towards(from, square)?;
        let is_found = density > 0.0 && density.is_finite();
        let density = chance * density;
        is_found.then_some(Towards { source: self.source, direction, reach, density, chance })
    }

    /// A point of it, by a point of the unit square; none if it is far away.
    pub(super) fn point(&self, square: [f64; 2]) -> Option<Vector> {
        match self.form {
            Form::Point(position) => Some(position),
            Form::Distant(_) => None,
            shape => Some(shape.point(square).0),
        }
    }
}

impl Form {
    /// Its weight where its radiance, intensity or irradiance is this.
    fn weight(&self, value: f64) -> Weight {
        let near = |area: f64, middle: Vector, radius: f64| Weight {
            strength: value * area,
            middle,
            radius,
            far: 0.0,
            direction: None,
            before: None,
        };
        match *self {
            Self::Triangle(corners) => {
                let middle = Vector::mean(&corners);
                let radius = corners.iter().map(|&corner| (corner - middle).length()).fold(0.0, f64::max);
                near(self.area(), middle, radius)
            }
            Self::Disk(disk) => near(self.area(), disk.center, disk.radius),
            Self::Sphere(sphere) => near(PI * sphere.radius * sphere.radius, sphere.center, sphere.radius),
            Self::Point(position) => near(1.0, position, 0.0),
            Self::Distant(direction) => {
                Weight { far: value, direction: Some(-direction), ..near(0.0, Vector::default(), 0.0) }
            }
        }
    }

    fn area(&self) -> f64 {
        match self {
            Self::Triangle([a, b, c]) => 0.5 * (*b - *a).cross(*c - *a).length(),
            Self::Disk(disk) => PI * disk.radius * disk.radius,
            Self::Sphere(sphere) => 4.0 * PI * sphere.radius * sphere.radius,
            Self::Point(_) | Self::Distant(_) => 0.0,
        }
    }

    /// A point that is uniform over the area, and the normal there.
    fn point(&self, [u, v]: [f64; 2]) -> (Vector, Vector) {
        match *self {
            Self::Triangle([a, b, c]) => {
                let [p, q] = uniform_triangle_sample(u, v);
                (a + p * (b - a) + q * (c - a), Vector::default())
            }
            Self::Disk(disk) => {
                let [x, y] = uniform_disk_sample(u, v);
                (disk.center + disk.radius * Frame::about(disk.normal).place([x, y, 0.0]), disk.normal)
            }
            Self::Sphere(sphere) => {
                let [x, y, z] = uniform_sphere_sample(u, v);
                let outward = Vector::new(x, y, z);
                (sphere.center + sphere.radius * outward, outward)
            }
            Self::Point(position) => (position, Vector::default()),
            Self::Distant(direction) => (direction, Vector::default()),
        }
    }

    /// A direction to it, how far it is if it is a point, and the density.
    fn towards(&self, from: Vector, square: [f64; 2]) -> Option<(Vector, f64, f64)> {
        match *self {
            Self::Point(position) => {
                let way = position - from;
                let direction = way.unit()?;
                Some((direction, way.length(), way.dot(way)))
            }
            Self::Distant(direction) => Some((-direction, f64::INFINITY, 1.0)),
            Self::Triangle(corners) => {
                let [a, b, c] = corners.map(|corner| corner - from);
                let [u, v] = square;
                let [x, y, z] = spherical_triangle_sample(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, u, v);
                let direction = Vector::new(x, y, z).unit()?;
                Some((direction, f64::INFINITY, triangle_density([a, b, c], direction)))
            }
            Self::Sphere(sphere) if outside(&sphere, from).is_some() => {
                let (axis, height) = outside(&sphere, from)?;
                let direction = Frame::about(axis).place(uniform_cone_sample(height, square[0], square[1]));
                Some((direction, f64::INFINITY, cone_density(height)))
            }
            Self::Disk(_) | Self::Sphere(_) => {
                let (point, normal) = self.point(square);
                let way = point - from;
                let direction = way.unit()?;
                let density = self.density_of_area(way.dot(way), normal.dot(direction).abs());
                Some((direction, f64::INFINITY, density))
            }
        }
    }

    /// The density of directions that are uniform over the area.
    fn density_of_area(&self, squared: f64, cosine: f64) -> f64 {
        measure_solid_angle_to_area(squared, cosine) / self.area()
    }

    fn density(&self, from: Vector, direction: Vector, met: &Met) -> f64 {
        match *self {
            Self::Triangle(corners) => triangle_density(corners.map(|corner| corner - from), direction),
            Self::Sphere(sphere) if outside(&sphere, from).is_some() => {
                outside(&sphere, from).map_or(0.0, |(_, height)| cone_density(height))
            }
            Self::Disk(_) | Self::Sphere(_) => {
                let way = met.position - from;
                let covered = measure_area_to_solid_angle(way.dot(way), met.normal.dot(direction).abs());
                1.0 / (covered * self.area())
            }
            Self::Point(_) | Self::Distant(_) => 0.0,
        }
    }
}

/// The front of a surface, of which points are taken that are uniform over its area.
pub(super) struct Front {
    /// The wall, the form and the unit normal if it is flat.
    pieces: Vec<(usize, Form, Option<Vector>)>,
    /// The area of each piece and of all before it.
    areas: Vec<f64>,
}

impl Front {
    pub(super) fn of<'w>(walls: impl Iterator<Item = (usize, &'w Wall)>) -> Self {
        let (mut pieces, mut areas, mut sum) = (Vec::new(), Vec::new(), 0.0);
        for (index, wall) in walls {
            let normal = match wall {
                Wall::Polygon { normal, .. } => Some(*normal),
                Wall::Disk(disk) => Some(disk.normal),
                Wall::Sphere(_) => None,
            };
            for form in forms(wall) {
                sum += form.area();
                areas.push(sum);
                pieces.push((index, form, normal));
            }
        }
        Self { pieces, areas }
    }

    /// A point: the wall, the place, and the unit normal there.
    pub(super) fn point(&self, samples: &mut Samples) -> Option<(usize, Vector, Vector)> {
        let along = samples.one() * self.areas.last()?;
        let (wall, form, normal) = &self.pieces[chosen(&self.areas, along)?];
        let (position, outward) = form.point(samples.pair());
        let normal = normal.unwrap_or(match form {
            Form::Sphere(sphere) if sphere.inward => -outward,
            _ => outward,
        });
        Some((*wall, position, normal))
    }
}

/// The forms of a wall: a polygon is a fan of triangles.
fn forms(wall: &Wall) -> Vec<Form> {
    match wall {
        Wall::Polygon { vertices, .. } => {
            let fan = vertices[1..].windows(2).map(|pair| Form::Triangle([vertices[0], pair[0], pair[1]]));
            fan.filter(|triangle| triangle.area() > 0.0).collect()
        }
        Wall::Disk(disk) => vec![Form::Disk(*disk)],
        Wall::Sphere(sphere) => vec![Form::Sphere(*sphere)],
    }
}

fn triangle_density([a, b, c]: [Vector; 3], direction: Vector) -> f64 {
    let Vector { x, y, z } = direction;
    spherical_triangle_pdf(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, x, y, z)
}

/// From outside of a sphere the direction to its centre, and what the cosine of its limb lacks of 1: with s = R/d, s²/(1 + √(1 − s²)).
fn outside(sphere: &Sphere, from: Vector) -> Option<(Vector, f64)> {
    let way = sphere.center - from;
    let distance = way.length();
    let sine = sphere.radius / distance;
    let squared = sine * sine;
    (sine < 1.0).then(|| way.unit().map(|axis| (axis, squared / (1.0 + (1.0 - squared).sqrt())))).flatten()
}

/// The density in a cone does not depend on the direction.
fn cone_density(height: f64) -> f64 {
    uniform_cone_pdf(height, 0.0, 0.0, 1.0)
}

/// A length that the scene extends over.
pub(super) fn extent(walls: &[Wall]) -> f64 {
    let corners: Vec<Vector> = walls.iter().flat_map(Wall::corners).collect();
    let Some(&first) = corners.first() else { return 1.0 };
    corners.iter().map(|&corner| (corner - first).length()).fold(0.0, f64::max)
}
