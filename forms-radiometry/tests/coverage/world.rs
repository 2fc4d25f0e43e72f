//! A scene in two forms: as a world for path tracing, and as the text of a scene file.

use forms_radiometry::geometry::Vector;
use forms_testing::scene_text;
use std::collections::HashMap;
use std::f64::consts::PI;
use std::fmt::Write;

/// Speed of light in m/s.
pub(crate) const LIGHT: f64 = 299_792_458.0;

/// Shape of a surface.
pub(crate) enum Shape {
    /// Parallelogram given by a corner and two edges; its front is the side from which they turn
    /// counter-clockwise.
    Rectangle([Vector; 3]),
    /// Triangles, counter-clockwise from the front.
    Mesh(Vec<[Vector; 3]>),
    Sphere {
        center: Vector,
        radius: f64,
    },
    /// Disk with a hole, which may be of radius zero.
    Disk {
        center: Vector,
        normal: Vector,
        hole: f64,
        radius: f64,
    },
    /// Side of a cylinder or of a cone, from one centre and radius to others.
    Turned {
        ends: [Vector; 2],
        radii: [f64; 2],
        is_inward: bool,
    },
}

pub(crate) struct Surface {
    pub(crate) name: String,
    pub(crate) shape: Shape,
    pub(crate) reflectance: f64,
    pub(crate) radiance: f64,
    pub(crate) is_two_sided: bool,
    pub(crate) is_mirror: bool,
    /// Whether it is a hole that lets in light from outside. Path tracing samples it like an
    /// emitter, and the scene file has nothing there.
    pub(crate) is_hole: bool,
}

#[derive(Clone, Copy)]
pub(crate) enum Light {
    Sun { direction: Vector, irradiance: f64 },
    Lamp { position: Vector, intensity: f64 },
}

/// Kind of a receiver.
pub(crate) enum Kind {
    Point { position: Vector, normal: Vector },
    Sphere { position: Vector },
    Ray { origin: Vector, direction: Vector },
    Surface { surface: usize, grid: Option<[usize; 2]> },
    Camera { origin: Vector, target: Vector, fov: f64, resolution: [usize; 2] },
}

/// Time bins of one width, starting at the pulse, in seconds.
#[derive(Clone, Copy)]
pub(crate) struct Bins {
    pub(crate) width: f64,
    pub(crate) count: usize,
}

pub(crate) struct Receiver {
    pub(crate) kind: Kind,
    pub(crate) time: Option<Bins>,
}

#[derive(Default)]
pub(crate) struct World {
    pub(crate) surfaces: Vec<Surface>,
    pub(crate) lights: Vec<Light>,
    /// Radiance from outside.
    pub(crate) sky: f64,
    /// Absorption coefficient of the medium that fills the scene.
    pub(crate) absorption: f64,
    pub(crate) receivers: Vec<Receiver>,
}

fn array(Vector { x, y, z }: Vector) -> [f64; 3] {
    [x, y, z]
}

impl Shape {
    /// Returns the corners of a parallelogram.
    pub(crate) fn corners([corner, along, across]: [Vector; 3]) -> [Vector; 4] {
        [corner, corner + along, corner + along + across, corner + across]
    }
}

impl World {
    /// Returns the irradiance of a place that sees nothing but the brightest light; a lamp is at
    /// the distance 1.
    pub(crate) fn brightest(&self) -> f64 {
        let of_lights = self.lights.iter().map(|light| match light {
            Light::Sun { irradiance: brightness, .. } | Light::Lamp { intensity: brightness, .. } => {
                *brightness
            }
        });
        let of_surfaces = self.surfaces.iter().map(|surface| PI * surface.radiance);
        of_lights.chain(of_surfaces).fold(PI * self.sky, f64::max)
    }

    /// Returns the text of the scene file, and the meshes that it names.
    pub(crate) fn text(&self, tolerance: f64) -> (String, HashMap<String, String>) {
        let mut text = String::new();
        let mut files = HashMap::new();
        let solid = self.surfaces.iter().filter(|surface| !surface.is_hole);
        solid.for_each(|surface| text += &surface.text(&mut files));
        for light in &self.lights {
            text += "[[light]]\n";
            text += &match *light {
                Light::Sun { direction, irradiance } => format!(
                    "kind = \"distant\"\ndirection = {:?}\nirradiance = {irradiance:?}\n",
                    array(direction)
                ),
                Light::Lamp { position, intensity } => {
                    format!("kind = \"point\"\nposition = {:?}\nintensity = {intensity:?}\n", array(position))
                }
            };
        }
        if self.absorption > 0.0 {
            writeln!(text, "[[medium]]\nname = \"smoke\"\nsigma_a = {:?}", self.absorption).unwrap();
        }
        for (number, receiver) in self.receivers.iter().enumerate() {
            text += &self.receiver_text(number, receiver);
        }
        writeln!(text, "[ambient]\nradiance = {:?}", self.sky).unwrap();
        if self.absorption > 0.0 {
            text += "medium = \"smoke\"\n";
        }
        (text + &scene_text::tolerance(tolerance), files)
    }

    fn receiver_text(&self, number: usize, Receiver { kind, time }: &Receiver) -> String {
        let mut text = format!("[[receiver]]\nname = \"{number}\"\n");
        text += &match *kind {
            Kind::Point { position, normal } => {
                format!("kind = \"point\"\nposition = {:?}\nnormal = {:?}\n", array(position), array(normal))
            }
            Kind::Sphere { position } => format!("kind = \"sphere\"\nposition = {:?}\n", array(position)),
            Kind::Ray { origin, direction } => {
                format!("kind = \"ray\"\norigin = {:?}\ndirection = {:?}\n", array(origin), array(direction))
            }
            Kind::Surface { surface, grid } => {
                let grid = grid.map_or(String::new(), |grid| format!("grid = {grid:?}\n"));
                format!("kind = \"surface\"\nsurface = \"{}\"\n{grid}", self.surfaces[surface].name)
            }
            Kind::Camera { origin, target, fov, resolution } => format!(
                "kind = \"camera\"\norigin = {:?}\ntarget = {:?}\nup = [0, 0, 1]\nfov = {fov:?}\nresolution = {resolution:?}\n",
                array(origin),
                array(target)
            ),
        };
        if let Some(Bins { width, count }) = time {
            writeln!(text, "time = {{ start = 0, width = {width:?}, bins = {count} }}").unwrap();
        }
        text
    }
}

impl Surface {
    /// Returns a surface that reflects diffusely from its front.
    pub(crate) fn new(name: String, shape: Shape, reflectance: f64) -> Self {
        Self {
            name,
            shape,
            reflectance,
            radiance: 0.0,
            is_two_sided: false,
            is_mirror: false,
            is_hole: false,
        }
    }

    fn text(&self, files: &mut HashMap<String, String>) -> String {
        let name = &self.name;
        let mut shape = match &self.shape {
            Shape::Rectangle(edges) => scene_text::polygon(&Shape::corners(*edges).map(array)),
            Shape::Sphere { center, radius } => {
                format!("sphere = {{ center = {:?}, radius = {radius:?} }}", array(*center))
            }
            Shape::Disk { center, normal, hole, radius } => {
                let [center, normal] = [center, normal].map(|vector| array(*vector));
                let (name, radii) = match hole {
                    0.0 => ("disk", format!("radius = {radius:?}")),
                    _ => ("annulus", format!("radii = [{hole:?}, {radius:?}]")),
                };
                format!("{name} = {{ center = {center:?}, normal = {normal:?}, {radii} }}")
            }
            Shape::Turned { ends, radii: [first, last], is_inward } => {
                let [from, to] = ends.map(array);
                let (name, radii) = match first == last {
                    true => ("cylinder", format!("radius = {first:?}")),
                    false => ("cone", format!("radii = [{first:?}, {last:?}]")),
                };
                format!("{name} = {{ from = {from:?}, to = {to:?}, {radii}, inward = {is_inward} }}")
            }
            Shape::Mesh(triangles) => {
                files.insert(format!("{name}.obj"), obj(triangles));
                format!("mesh = \"{name}.obj\"")
            }
        };
        write!(shape, "\nradiance = {:?}\ntwo_sided = {}", self.radiance, self.is_two_sided).unwrap();
        let material = scene_text::material(name, format!("{:?}", self.reflectance));
        let material = if self.is_mirror { material.replace("diffuse", "mirror") } else { material };
        material + &scene_text::surface(name, name, &shape)
    }
}

fn obj(triangles: &[[Vector; 3]]) -> String {
    let mut text = String::new();
    for (number, triangle) in triangles.iter().enumerate() {
        triangle.iter().for_each(|&Vector { x, y, z }| writeln!(text, "v {x:?} {y:?} {z:?}").unwrap());
        let first = 3 * number + 1;
        writeln!(text, "f {first} {} {}", first + 1, first + 2).unwrap();
    }
    text
}
