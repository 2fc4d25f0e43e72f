//! Shapes of View3D: polygons by the numbers of their vertices (format 3), or in a plane of their own
//! (format 3a).

use super::super::words::{Fault, Word};
use super::element::Element;
use crate::geometry::Vector;
use std::collections::HashMap;

/// How shapes are given.
#[derive(Clone, Copy)]
pub(super) enum Format {
    /// Four numbers of vertices; the last is zero for a triangle.
    Vertices,
    /// A letter for the shape; its plane and its size follow at the end.
    Plane,
}

/// A shape whose beginning was read.
pub(super) enum Outline {
    Vertices(Vec<Vector>),
    Rectangle,
    /// A polygon with this number of corners.
    Corners(usize),
}

impl Format {
    pub(super) fn of(word: Word) -> Result<Self, Fault> {
        match &*word.text.to_ascii_lowercase() {
            "3" => Ok(Self::Vertices),
            "3a" => Ok(Self::Plane),
            other => {
                let message = format!("the geometry format `{other}` is not supported");
                Err(Fault::new(word.range, message, "3 or 3a"))
            }
        }
    }

    /// Reads what follows the number of a surface.
    pub(super) fn begin(
        self,
        element: &mut Element,
        vertices: &HashMap<u32, Vector>,
    ) -> Result<Outline, Fault> {
        match self {
            Self::Plane => {
                let word = element.word("the shape")?;
                match &*word.text.to_ascii_uppercase() {
                    "R" => Ok(Outline::Rectangle),
                    "T" => Ok(Outline::Corners(3)),
                    "Q" => Ok(Outline::Corners(4)),
                    other => {
                        Err(Fault::new(word.range, format!("the shape `{other}` is unknown"), "R, T or Q"))
                    }
                }
            }
            Self::Vertices => {
                let mut outline = Vec::new();
                for place in 0..4 {
                    let word = element.word("the number of a vertex")?;
                    let number = word.whole()?;
                    if place == 3 && number == 0 {
                        break;
                    }
                    let vertex = u32::try_from(number).ok().and_then(|number| vertices.get(&number));
                    let wrong = || {
                        Fault::new(
                            word.range.clone(),
                            format!("there is no vertex {number}"),
                            "the number of a vertex above",
                        )
                    };
                    outline.push(*vertex.ok_or_else(wrong)?);
                }
                Ok(Outline::Vertices(outline))
            }
        }
    }
}

impl Outline {
    /// Returns the vertices; those in a plane of their own are read now.
    pub(super) fn vertices(self, element: &mut Element) -> Result<Vec<Vector>, Fault> {
        let corners = match self {
            Self::Vertices(vertices) => return Ok(vertices),
            Self::Rectangle => None,
            Self::Corners(count) => Some(count),
        };
        let origin = element.point()?;
        let azimuth = element.word("the azimuth")?.float()?;
        let tilt = element.word("the tilt")?.float()?;
        let plane = Plane::new(origin, azimuth, tilt);
        let corners = match corners {
            None => {
                let (width, height) = (element.coordinate()?, element.coordinate()?);
                vec![[0.0, height], [0.0, 0.0], [width, 0.0], [width, height]]
            }
            Some(count) => {
                let corner = |_| Ok([element.coordinate()?, element.coordinate()?]);
                (0..count).map(corner).collect::<Result<_, Fault>>()?
            }
        };
        Ok(corners.into_iter().map(|[x, y]| plane.point(x, y)).collect())
    }
}

/// A plane by its origin and its axes: x to the right and y upwards as seen from its front.
struct Plane {
    origin: Vector,
    right: Vector,
    up: Vector,
}

impl Plane {
    /// The azimuth α of the normal is measured in degrees clockwise from the axis y (north), the tilt
    /// β from facing up: right = (−cos α, sin α, 0), up = (−sin α cos β, −cos α cos β, sin β).
    fn new(origin: Vector, azimuth: f64, tilt: f64) -> Self {
        let [(sin_a, cos_a), (sin_b, cos_b)] = [azimuth, tilt].map(sin_cos);
        let right = Vector::new(-cos_a, sin_a, 0.0);
        let up = Vector::new(-sin_a * cos_b, -cos_a * cos_b, sin_b);
        Self { origin, right, up }
    }

    fn point(&self, x: f64, y: f64) -> Vector {
        self.origin + x * self.right + y * self.up
    }
}

/// Returns sine and cosine of an angle in degrees; exact for right angles.
fn sin_cos(degrees: f64) -> (f64, f64) {
    let turned = degrees.rem_euclid(360.0);
    match turned {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => turned.to_radians().sin_cos(),
    }
}
