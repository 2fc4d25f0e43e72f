//! Random scenes of the kinds that people make: furnished rooms, windows, rows of panels, streets,
//! spheres, meshes, mirrors, vessels.

use crate::world::{Bins, Kind, LIGHT, Light, Receiver, Shape, Surface, World};
use forms_radiometry::geometry::Vector;
use forms_testing::SplitMix;
use std::f64::consts::PI;

/// Function that makes a scene of a kind.
type Family = fn(&mut Maker);

/// Kinds of scenes.
pub(crate) const FAMILIES: [(&str, Family); 8] = [
    ("furnished room", furnished_room),
    ("window", window),
    ("panels", panels),
    ("street", street),
    ("spheres", spheres),
    ("mesh", mesh),
    ("mirror", mirror),
    ("vessels", vessels),
];

/// Maker of a random world.
pub(crate) struct Maker {
    random: SplitMix,
    pub(crate) world: World,
}

fn vector(x: f64, y: f64, z: f64) -> Vector {
    Vector::new(x, y, z)
}

const UP: Vector = Vector { x: 0.0, y: 0.0, z: 1.0 };

/// Returns the world of a kind and a number.
pub(crate) fn world(family: Family, number: u64) -> World {
    let mut maker = Maker { random: SplitMix(number), world: World::default() };
    family(&mut maker);
    maker.world
}

impl Maker {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.random.unit()
    }

    fn happens(&mut self, probability: f64) -> bool {
        self.random.unit() < probability
    }

    /// Returns a point of a box.
    fn within(&mut self, low: [f64; 3], high: [f64; 3]) -> Vector {
        let [x, y, z] = std::array::from_fn(|axis| self.between(low[axis], high[axis]));
        vector(x, y, z)
    }

    fn direction(&mut self) -> Vector {
        let [z, turn] = [self.between(-1.0, 1.0), self.between(0.0, 2.0 * PI)];
        let across = (1.0 - z * z).sqrt();
        vector(across * turn.cos(), across * turn.sin(), z)
    }

    fn add(&mut self, shape: Shape, reflectance: f64) -> &mut Surface {
        let name = format!("surface {}", self.world.surfaces.len());
        self.world.surfaces.push(Surface::new(name, shape, reflectance));
        self.world.surfaces.last_mut().expect("the surface that was added")
    }

    fn rectangle(&mut self, corner: Vector, along: Vector, across: Vector, reflectance: f64) -> &mut Surface {
        self.add(Shape::Rectangle([corner, along, across]), reflectance)
    }

    /// Adds the faces of a box that is rotated about the vertical, facing outwards; with a bottom
    /// where the box floats.
    fn block(&mut self, middle: Vector, size: [f64; 3], turn: f64, reflectance: f64) {
        let (sin, cos) = turn.sin_cos();
        let a = size[0] * vector(cos, sin, 0.0);
        let b = size[1] * vector(-sin, cos, 0.0);
        let c = size[2] * UP;
        let corner = middle - 0.5 * a - 0.5 * b;
        let far = corner + a + b + c;
        let none = -1.0;
        self.rectangle(corner, a, c, reflectance);
        self.rectangle(corner, c, b, reflectance);
        self.rectangle(far, none * c, none * a, reflectance);
        self.rectangle(far, none * b, none * c, reflectance);
        self.rectangle(corner + c, a, b, reflectance);
        if middle.z > 0.0 {
            self.rectangle(corner, b, a, reflectance);
        }
    }

    /// Adds the six sides of a room from the origin, facing inwards; if requested, with a hole in
    /// the side y = 0 from one corner to another.
    fn room(&mut self, [w, d, h]: [f64; 3], hole: Option<[[f64; 2]; 2]>) {
        let [x, y, z] = [vector(w, 0.0, 0.0), vector(0.0, d, 0.0), vector(0.0, 0.0, h)];
        let zero = vector(0.0, 0.0, 0.0);
        let reflectances: Vec<f64> = (0..6).map(|_| self.between(0.1, 0.8)).collect();
        self.rectangle(zero, x, y, reflectances[0]);
        self.rectangle(z, y, x, reflectances[1]);
        self.rectangle(zero, y, z, reflectances[2]);
        self.rectangle(x, z, y, reflectances[3]);
        self.rectangle(y, x, z, reflectances[4]);
        let Some([[left, low], [right, high]]) = hole else {
            self.rectangle(zero, z, x, reflectances[5]);
            return;
        };
        let parts = [[0.0, w, 0.0, low], [0.0, w, high, h], [0.0, left, low, high], [right, w, low, high]];
        for [from, to, bottom, top] in parts {
            let corner = vector(from, 0.0, bottom);
            self.rectangle(corner, (top - bottom) * UP, vector(to - from, 0.0, 0.0), reflectances[5]);
        }
    }

    fn sun(&mut self, way: Vector) {
        let light = Light::Sun { direction: way.unit().expect("a direction"), irradiance: 1000.0 };
        self.world.lights.push(light);
    }

    /// Adds a square that shines downwards.
    fn panel_lamp(&mut self, middle: Vector, side: f64, radiance: f64) {
        let half = 0.5 * side;
        let corner = middle - vector(half, half, 0.0);
        let lamp = self.rectangle(corner, vector(0.0, side, 0.0), vector(side, 0.0, 0.0), 0.0);
        lamp.radiance = radiance;
    }

    fn ask(&mut self, kind: Kind) {
        self.world.receivers.push(Receiver { kind, time: None });
    }

    /// Adds a receiver of any kind in an otherwise empty box, and one on a surface.
    fn ask_anything(&mut self, [low, high]: [[f64; 3]; 2], surface: usize) {
        let position = self.within(low, high);
        let direction = self.direction();
        let kind = match self.random.below(4) {
            0 => Kind::Point { position, normal: direction },
            1 => Kind::Sphere { position },
            2 => Kind::Ray { origin: position, direction },
            _ => {
                let direction = vector(direction.x, direction.y, 0.6 * direction.z);
                let resolution = [3, 2];
                Kind::Camera { origin: position, target: position + direction, fov: 60.0, resolution }
            }
        };
        self.ask(kind);
        let is_flat = matches!(self.world.surfaces[surface].shape, Shape::Rectangle(_));
        let grid = (is_flat && self.happens(0.3)).then_some([3, 2]);
        self.ask(Kind::Surface { surface, grid });
    }

    /// Resolves the first receiver in time. The bins have the width that light takes to travel this
    /// distance.
    fn ask_for_time(&mut self, size: f64) {
        if matches!(self.world.receivers[0].kind, Kind::Point { .. } | Kind::Sphere { .. } | Kind::Ray { .. })
        {
            self.world.receivers[0].time = Some(Bins { width: size / LIGHT, count: 4 });
            self.world.receivers.truncate(1);
        }
    }
}

fn furnished_room(maker: &mut Maker) {
    let size = [maker.between(3.0, 6.0), maker.between(3.0, 5.0), maker.between(2.4, 3.2)];
    maker.room(size, None);
    for place in 0..1 + maker.random.below(3) {
        let middle = vector(size[0] * (0.2 + 0.3 * place as f64), maker.between(0.8, size[1] - 0.8), 0.0);
        let block = [maker.between(0.2, 0.7), maker.between(0.2, 0.7), maker.between(0.3, 1.2)];
        let [turn, reflectance] = [maker.between(0.0, 3.0), maker.between(0.0, 0.8)];
        maker.block(middle, block, turn, reflectance);
    }
    if maker.happens(0.5) {
        // a shelf that floats in front of a wall
        let corner = vector(0.02, 0.5, 1.5);
        let shelf = maker.rectangle(corner, vector(0.3, 0.0, 0.0), vector(0.0, 1.5, 0.0), 0.6);
        shelf.is_two_sided = true;
    }
    if maker.happens(0.8) {
        let [side, gap] = [maker.between(0.1, 1.0), maker.between(0.02, 0.5)];
        let middle =
            vector(maker.between(0.8, size[0] - 0.8), maker.between(0.8, size[1] - 0.8), size[2] - gap);
        maker.panel_lamp(middle, side, 100.0);
    } else {
        let position = vector(0.5 * size[0], maker.between(0.5, size[1] - 0.5), size[2] - 0.4);
        maker.world.lights.push(Light::Lamp { position, intensity: 100.0 });
    }
    if maker.happens(0.1) {
        let mirror = vector(1.0, size[1] - 0.03, 1.0);
        let surface = maker.rectangle(mirror, vector(0.8, 0.0, 0.0), vector(0.0, 0.0, 0.9), 0.9);
        surface.is_mirror = true;
    }
    if maker.happens(0.1) {
        maker.world.absorption = maker.between(0.05, 0.5);
    }
    let free = [[0.2, 0.2, 1.3], [size[0] - 0.2, size[1] - 0.2, size[2] - 0.6]];
    let surface = maker.random.below(5);
    maker.ask_anything(free, surface);
    if maker.happens(0.1) {
        maker.ask_for_time(6.0);
    }
}

fn window(maker: &mut Maker) {
    let size = [4.0, 3.0, 3.0];
    let [left, low] = [maker.between(0.2, 3.0), maker.between(0.2, 2.0)];
    let [width, height] = [(); 2].map(|()| 0.9 * 10.0_f64.powf(maker.between(-1.5, 0.0)));
    maker.room(size, Some([[left, low], [left + width, low + height]]));
    if maker.happens(0.7) {
        let way = vector(maker.between(-0.8, 0.8), maker.between(0.2, 2.0), -1.0);
        maker.sun(way);
    }
    if maker.world.lights.is_empty() || maker.happens(0.7) {
        maker.world.sky = maker.between(10.0, 200.0);
        let sky = maker.world.sky;
        let (up, right) = (vector(0.0, 0.0, height), vector(width, 0.0, 0.0));
        let hole = maker.rectangle(vector(left, 0.0, low), up, right, 0.0);
        (hole.radiance, hole.is_hole) = (sky, true);
    }
    if maker.happens(0.5) {
        let [x, turn] = [maker.between(0.8, 3.2), maker.between(0.0, 3.0)];
        maker.block(vector(x, 1.5, 0.0), [0.8, 0.5, 0.7], turn, 0.5);
    }
    let surface = maker.random.below(5);
    maker.ask_anything([[0.2, 0.2, 0.8], [3.8, 2.8, 2.8]], surface);
}

fn panels(maker: &mut Maker) {
    let reflectance = maker.between(0.0, 0.6);
    maker.rectangle(vector(-8.0, -8.0, 0.0), vector(16.0, 0.0, 0.0), vector(0.0, 16.0, 0.0), reflectance);
    let rows = 2 + maker.random.below(3);
    let [tilt, height, length] = [maker.between(0.2, 1.2), maker.between(0.2, 0.8), maker.between(1.0, 6.0)];
    let [pitch, depth] = [maker.between(1.0, 3.0), maker.between(0.5, 1.5)];
    for row in 0..rows {
        let corner = vector(-0.5 * length, pitch * (row as f64 - 1.0), height);
        let across = depth * vector(0.0, tilt.cos(), tilt.sin());
        maker.rectangle(corner, vector(length, 0.0, 0.0), across, 0.1).is_two_sided = true;
    }
    let way = vector(maker.between(-0.9, 0.9), maker.between(-0.2, 1.5), -1.0);
    maker.sun(way);
    if maker.happens(0.7) {
        maker.world.sky = maker.between(10.0, 100.0);
    }
    let surface = maker.random.below(rows + 1);
    maker.ask_anything([[-4.0, -4.0, 0.05], [4.0, 4.0, 0.18]], surface);
}

fn street(maker: &mut Maker) {
    let reflectance = maker.between(0.1, 0.5);
    maker.rectangle(vector(-12.0, -5.0, 0.0), vector(24.0, 0.0, 0.0), vector(0.0, 10.0, 0.0), reflectance);
    for side in [-1.0, 1.0] {
        let mut x = -11.0;
        for _ in 0..1 + maker.random.below(3) {
            let [width, height, gap] =
                [maker.between(3.0, 6.0), maker.between(3.0, 12.0), maker.between(0.3, 2.0)];
            let reflectance = maker.between(0.1, 0.7);
            maker.block(vector(x + 0.5 * width, side * 3.5, 0.0), [width, 1.6, height], 0.0, reflectance);
            x += width + gap;
        }
    }
    if maker.happens(0.6) {
        let way = vector(maker.between(-0.9, 0.9), maker.between(-0.5, 0.5), -1.0);
        maker.sun(way);
        maker.world.sky = maker.between(0.0, 100.0);
    } else {
        // at different heights, since they may overlap
        for number in 0..1 + maker.random.below(3) {
            let [x, y, side] =
                [maker.between(-10.0, 10.0), maker.between(-2.0, 2.0), maker.between(0.1, 0.4)];
            maker.panel_lamp(vector(x, y, 2.8 + 0.01 * number as f64), side, 1000.0);
        }
    }
    let surface = maker.random.below(6);
    maker.ask_anything([[-10.0, -2.5, 0.2], [10.0, 2.5, 2.5]], surface);
}

/// Adds a ground with a lamp, a sun or a sky above it.
fn ground(maker: &mut Maker) {
    let reflectance = maker.between(0.0, 0.7);
    maker.rectangle(vector(-3.0, -3.0, 0.0), vector(6.0, 0.0, 0.0), vector(0.0, 6.0, 0.0), reflectance);
    match maker.random.below(4) {
        0 => {
            let [middle, side] = [maker.within([-1.0, -1.0, 3.0], [1.0, 1.0, 4.0]), maker.direction()];
            maker.panel_lamp(middle, 0.2 + side.x.abs(), 100.0);
        }
        1 => {
            let way = vector(maker.between(-0.9, 0.9), maker.between(-0.9, 0.9), -1.0);
            maker.sun(way);
        }
        2 => {
            let position = maker.within([-1.0, -1.0, 3.0], [1.0, 1.0, 4.0]);
            maker.world.lights.push(Light::Lamp { position, intensity: 500.0 });
        }
        _ => maker.world.sky = 50.0,
    }
}

fn spheres(maker: &mut Maker) {
    ground(maker);
    for place in 0..1 + maker.random.below(3) {
        let radius = maker.between(0.2, 0.7);
        let center =
            vector(1.5 * place as f64 - 1.5, maker.between(-1.0, 1.0), radius + maker.between(0.01, 0.8));
        let reflectance = maker.between(0.0, 0.8);
        // curved mirrors are refused next to point and distant lights
        let is_mirror = maker.happens(0.15) && maker.world.lights.is_empty();
        maker.add(Shape::Sphere { center, radius }, reflectance).is_mirror = is_mirror;
    }
    let last = maker.world.surfaces.len() - 1;
    let surface = if maker.world.surfaces[last].is_mirror { 0 } else { maker.random.of(&[0, last]) };
    maker.ask_anything([[-2.5, -2.5, 2.4], [2.5, 2.5, 2.8]], surface);
}

/// Adds a bumpy ball of triangles.
fn mesh(maker: &mut Maker) {
    ground(maker);
    let [rings, sectors] = [3 + maker.random.below(4), 5 + maker.random.below(6)];
    let [radius, bumps] = [maker.between(0.4, 0.9), maker.between(0.0, 0.3)];
    let place = vector(maker.between(-1.0, 1.0), maker.between(-1.0, 1.0), 1.3);
    let point = |ring: usize, sector: usize| {
        let (theta, phi) =
            (PI * ring as f64 / rings as f64, 2.0 * PI * (sector % sectors) as f64 / sectors as f64);
        let (sin, cos) = if ring == 0 || ring == rings { (0.0, theta.cos()) } else { theta.sin_cos() };
        let bump = 1.0 + bumps * (3.0 * phi).sin() * sin;
        place + (radius * bump) * vector(sin * phi.cos(), sin * phi.sin(), cos)
    };
    let mut triangles = Vec::new();
    for ring in 0..rings {
        for sector in 0..sectors {
            let [a, b] = [point(ring, sector), point(ring, sector + 1)];
            let [c, d] = [point(ring + 1, sector), point(ring + 1, sector + 1)];
            if ring + 1 < rings {
                triangles.push([a, c, d]);
            }
            if ring > 0 {
                triangles.push([a, d, b]);
            }
        }
    }
    let reflectance = maker.between(0.0, 0.8);
    maker.add(Shape::Mesh(triangles), reflectance);
    let surface = maker.random.of(&[0, maker.world.surfaces.len() - 1]);
    maker.ask_anything([[-2.5, -2.5, 2.4], [2.5, 2.5, 2.8]], surface);
}

/// Adds a can with a lid, a bowl that is open above, and a ring that floats askew and may shine.
fn vessels(maker: &mut Maker) {
    ground(maker);
    let [radius, height, low] = [maker.between(0.2, 0.7), maker.between(0.3, 0.7), maker.between(0.4, 0.6)];
    let can = [vector(-1.2, 0.0, low), vector(-1.2, maker.between(-0.15, 0.15), low + height)];
    let top = if maker.happens(0.5) { radius } else { maker.between(0.05, 0.8) };
    let reflectance = maker.between(0.0, 0.8);
    maker.add(Shape::Turned { ends: can, radii: [radius, top], is_inward: false }, reflectance);
    let lid = Shape::Disk { center: can[1], normal: can[1] - can[0], hole: 0.0, radius: top };
    maker.add(lid, reflectance);
    let [bottom, rim, depth] = [maker.between(0.1, 0.5), maker.between(0.4, 0.8), maker.between(0.2, 1.0)];
    let bowl = [vector(0.9, 0.2, 0.1), vector(0.9, 0.2, 0.1 + depth)];
    let reflectance = maker.between(0.0, 0.8);
    maker.add(Shape::Turned { ends: bowl, radii: [bottom, rim], is_inward: true }, reflectance);
    let floor = Shape::Disk { center: bowl[0], normal: UP, hole: 0.0, radius: bottom };
    maker.add(floor, reflectance);
    let [hole, width] = [maker.between(0.0, 0.4), maker.between(0.1, 0.5)];
    let hole = if maker.happens(0.3) { 0.0 } else { hole };
    let normal = vector(maker.between(-0.5, 0.5), maker.between(-0.5, 0.5), -1.0);
    let center = maker.within([-0.5, -0.5, 2.2], [0.5, 0.5, 2.4]);
    let radiance = if maker.happens(0.5) { 50.0 } else { 0.0 };
    let ring = Shape::Disk { center, normal, hole, radius: hole + width };
    maker.add(ring, 0.3).radiance = radiance;
    let surface = maker.random.below(6);
    maker.ask_anything([[-2.5, -2.5, 2.9], [2.5, 2.5, 3.2]], surface);
}

/// Adds a floor, a board, a mirror on a wall, and a lamp that may be very small and face the
/// mirror.
fn mirror(maker: &mut Maker) {
    let reflectance = maker.between(0.0, 0.7);
    maker.rectangle(vector(-2.0, -3.0, 0.0), vector(4.0, 0.0, 0.0), vector(0.0, 3.0, 0.0), reflectance);
    let [left, low] = [maker.between(-2.0, 1.0), maker.between(0.0, 1.0)];
    let [width, height] = [maker.between(0.3, 4.0), maker.between(0.3, 3.0)];
    let silver = maker.between(0.5, 1.0);
    let sides = [vector(width, 0.0, 0.0), vector(0.0, 0.0, height)];
    maker.rectangle(vector(left, 0.0, low), sides[0], sides[1], silver).is_mirror = true;
    let place = maker.within([-1.5, -2.5, 0.5], [1.5, -0.5, 2.5]);
    let side = 10.0_f64.powf(maker.between(-2.0, -0.3));
    let [along, turn] = [maker.direction(), maker.direction()];
    let across = along.cross(turn).cross(along).unit().expect("a direction");
    let is_two_sided = maker.happens(0.5);
    let lamp = maker.rectangle(place, side * along, side * across, 0.0);
    (lamp.radiance, lamp.is_two_sided) = (10.0 / (side * side), is_two_sided);
    if maker.happens(0.5) {
        let corner = maker.within([-1.5, -2.5, 0.3], [1.5, -0.3, 1.2]);
        let [a, b] = [maker.direction(), maker.direction()];
        let reflectance = maker.between(0.0, 0.8);
        maker.rectangle(corner, a, b, reflectance).is_two_sided = true;
    }
    maker.ask_anything([[-1.8, -2.8, 0.1], [1.8, -0.1, 2.8]], 0);
}
