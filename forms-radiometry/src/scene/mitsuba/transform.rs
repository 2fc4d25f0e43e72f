//! Transforms: composes the steps of a `<transform>` into one affine map.

use super::object::Object;
use super::{Node, Reader};
use crate::geometry::Vector;
use crate::scene::value::{ANY, COORDINATE, values};

/// Tolerance of angles and lengths where a map must be a rotation with uniform scaling.
const SIMILARITY: f64 = 1e-6;

/// The affine map x ↦ A x + b, by the columns of A and b.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Transform {
    columns: [Vector; 3],
    shift: Vector,
}

impl Transform {
    pub(super) const IDENTITY: Self = Self {
        columns: [Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 1.0, 0.0), Vector::new(0.0, 0.0, 1.0)],
        shift: Vector::new(0.0, 0.0, 0.0),
    };

    pub(super) fn point(&self, p: Vector) -> Vector {
        self.vector(p) + self.shift
    }

    pub(super) fn vector(&self, v: Vector) -> Vector {
        v.x * self.columns[0] + v.y * self.columns[1] + v.z * self.columns[2]
    }

    /// Returns the composition of this map after another one.
    fn after(&self, first: &Self) -> Self {
        Self { columns: first.columns.map(|column| self.vector(column)), shift: self.point(first.shift) }
    }

    fn determinant(&self) -> f64 {
        self.columns[0].cross(self.columns[1]).dot(self.columns[2])
    }

    /// Whether the map reverses orientation.
    pub(super) fn mirrors(&self) -> bool {
        self.determinant() < 0.0
    }

    /// Returns the scale factor, if the map is a rotation or reflection with uniform scaling. For a
    /// map of the plane z = 0, `axes` is 2.
    pub(super) fn scale(&self, axes: usize) -> Option<f64> {
        let columns = &self.columns[..axes];
        let scale = columns[0].length();
        let fits = |i: usize, j: usize| {
            let expected = if i == j { 1.0 } else { 0.0 };
            let (u, v) = ((1.0 / scale) * columns[i], (1.0 / scale) * columns[j]);
            (u.dot(v) - expected).abs() <= SIMILARITY
        };
        let is_similar = (0..axes).all(|i| (i..axes).all(|j| fits(i, j)));
        (is_similar && scale.is_finite() && scale > 0.0).then_some(scale)
    }

    /// x ↦ x + b.
    fn translation(shift: Vector) -> Self {
        Self { shift, ..Self::IDENTITY }
    }

    /// x ↦ (a x, b y, c z).
    fn scaling(by: Vector) -> Self {
        let [x, y, z] = Self::IDENTITY.columns;
        Self { columns: [by.x * x, by.y * y, by.z * z], ..Self::IDENTITY }
    }

    /// Rodrigues: x ↦ cos θ x + sin θ (k × x) + (1 − cos θ)(k·x) k, θ in degrees.
    fn rotation(axis: Vector, degrees: f64) -> Self {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let turned = |x: Vector| cos * x + sin * axis.cross(x) + ((1.0 - cos) * axis.dot(x)) * axis;
        Self { columns: Self::IDENTITY.columns.map(turned), ..Self::IDENTITY }
    }

    /// Maps z to the direction of the target, y upright, x = y × z.
    fn look_at(origin: Vector, target: Vector, up: Vector) -> Option<Self> {
        let direction = (target - origin).unit()?;
        let left = up.unit()?.cross(direction);
        let left = left.unit().filter(|_| left.length() > 1e-9)?;
        Some(Self { columns: [left, direction.cross(left), direction], shift: origin })
    }
}

impl<'a> Reader<'a, '_, '_> {
    /// Returns the transform of an object; the identity if it has none. A singular transform is an
    /// error.
    pub(super) fn transform(&mut self, object: &mut Object<'a>) -> Transform {
        let Some(node) = object.take("to_world") else { return Transform::IDENTITY };
        if !node.has_tag_name("transform") {
            let message = format!("`to_world` cannot be a `{}`", node.tag_name().name());
            self.error(node, message, "`transform`");
            return Transform::IDENTITY;
        }
        self.attributes(node, &["name"]);
        let mut whole = Transform::IDENTITY;
        for step in self.elements(node) {
            whole = self.step(step).unwrap_or(Transform::IDENTITY).after(&whole);
        }
        if whole.determinant() == 0.0 || !whole.determinant().is_finite() {
            self.error(node, "the transform has no inverse", "an invertible transform");
            return Transform::IDENTITY;
        }
        whole
    }

    fn step(&mut self, node: Node<'a>) -> Option<Transform> {
        for child in self.elements(node) {
            self.error(child, format!("`{}` is not supported here", child.tag_name().name()), "no elements");
        }
        match node.tag_name().name() {
            "translate" => self.axes(node, 0.0, false).map(Transform::translation),
            "scale" => self.axes(node, 1.0, true).map(Transform::scaling),
            "rotate" => self.rotate(node),
            "lookat" => self.look_at(node),
            "matrix" => self.matrix(node),
            other => {
                let expected = "`translate`, `rotate`, `scale`, `matrix` or `lookat`";
                self.error(node, format!("`{other}` is not supported in a transform"), expected);
                None
            }
        }
    }

    /// Returns three numbers, from `value` or from `x`, `y` and `z`; with `one_for_all`, a single
    /// number applies to all three.
    fn axes(&mut self, node: Node<'a>, default: f64, one_for_all: bool) -> Option<Vector> {
        self.attributes(node, &["value", "x", "y", "z", "angle"]);
        if let Some((text, place)) = self.attribute(node, "value") {
            if one_for_all && let [number] = self.numbers(&text, &place, "`value`", &COORDINATE)[..] {
                return Some(Vector::new(number, number, number));
            }
            return self.triple(&text, &place, "`value`");
        }
        let mut axis = |name: &str| match self.attribute(node, name) {
            None => Some(default),
            Some((text, place)) => {
                self.numbers(&text, &place, &format!("`{name}`"), &COORDINATE).first().copied()
            }
        };
        let (x, y, z) = (axis("x"), axis("y"), axis("z"));
        Some(Vector::new(x?, y?, z?))
    }

    fn rotate(&mut self, node: Node<'a>) -> Option<Transform> {
        let axis = self.axes(node, 0.0, false)?;
        let Some((text, place)) = self.attribute(node, "angle") else {
            self.error(node, "this rotate has no `angle`", "angle=\"…\" in degrees");
            return None;
        };
        let angle = self.numbers(&text, &place, "`angle`", &ANY).first().copied()?;
        let Some(axis) = axis.unit() else {
            self.error(node, "the axis has length zero", "x=\"1\", or another axis");
            return None;
        };
        Some(Transform::rotation(axis, angle))
    }

    fn look_at(&mut self, node: Node<'a>) -> Option<Transform> {
        self.attributes(node, &["origin", "target", "up"]);
        let mut point = |name: &str| {
            let Some((text, place)) = self.attribute(node, name) else {
                self.error(node, format!("this lookat has no `{name}`"), format!("{name}=\"x, y, z\""));
                return None;
            };
            self.triple(&text, &place, &format!("`{name}`"))
        };
        let (origin, target, up) = (point("origin"), point("target"), point("up"));
        let transform = Transform::look_at(origin?, target?, up?);
        if transform.is_none() {
            let expected =
                "a target other than the origin, and an `up` that is not parallel to the viewing direction";
            self.error(node, "the orientation of the lookat is undefined", expected);
        }
        transform
    }

    /// Parses sixteen numbers, row by row, or the nine of A.
    fn matrix(&mut self, node: Node<'a>) -> Option<Transform> {
        self.attributes(node, &["value"]);
        let (text, place) = self.attribute(node, "value").unwrap_or((String::new(), node.range()));
        let m = self.numbers(&text, &place, "`value`", &COORDINATE);
        let column = |width: usize, j: usize| Vector::new(m[j], m[width + j], m[2 * width + j]);
        match m.len() {
            9 => Some(Transform { columns: [0, 1, 2].map(|j| column(3, j)), shift: Vector::default() }),
            16 if m[12..] == [0.0, 0.0, 0.0, 1.0] => {
                Some(Transform { columns: [0, 1, 2].map(|j| column(4, j)), shift: column(4, 3) })
            }
            16 => {
                self.report.error(place, "the matrix is not affine", "0 0 0 1 in the last row");
                None
            }
            0 => None,
            count => {
                self.report.error(place, format!("the matrix has {}", values(count)), "16, row by row");
                None
            }
        }
    }
}
