//! Transforms: composes the steps of a `<transform>` into one affine map.

use super::object::Object;
use super::{Node, Reader};
use crate::geometry::{Affine, Vector};
use crate::scene::value::{ANY, COORDINATE, values};

impl<'a> Reader<'a, '_, '_> {
    /// Returns the transform of an object; the identity if it has none. A singular transform is an
    /// error.
    pub(super) fn transform(&mut self, object: &mut Object<'a>) -> Affine {
        self.transform_named(object, "to_world")
    }

    /// Returns the transform of this name.
    pub(super) fn transform_named(&mut self, object: &mut Object<'a>, name: &str) -> Affine {
        let Some(node) = object.take(name) else { return Affine::IDENTITY };
        if !node.has_tag_name("transform") {
            let message = format!("`{name}` cannot be a `{}`", node.tag_name().name());
            self.error(node, message, "`transform`");
            return Affine::IDENTITY;
        }
        self.attributes(node, &["name"]);
        let mut whole = Affine::IDENTITY;
        for step in self.elements(node) {
            whole = self.step(step).unwrap_or(Affine::IDENTITY).after(&whole);
        }
        if !whole.is_invertible() {
            self.error(node, "the transform has no inverse", "an invertible transform");
            return Affine::IDENTITY;
        }
        whole
    }

    fn step(&mut self, node: Node<'a>) -> Option<Affine> {
        for child in self.elements(node) {
            self.error(child, format!("`{}` is not supported here", child.tag_name().name()), "no elements");
        }
        match node.tag_name().name() {
            "translate" => self.axes(node, 0.0, false).map(Affine::translation),
            "scale" => self.axes(node, 1.0, true).map(Affine::scaling),
            "rotate" => self.rotate(node),
            "lookat" | "lookAt" => self.look_at(node),
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

    fn rotate(&mut self, node: Node<'a>) -> Option<Affine> {
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
        Some(Affine::rotation(axis, angle))
    }

    fn look_at(&mut self, node: Node<'a>) -> Option<Affine> {
        self.attributes(node, &["origin", "target", "up"]);
        let mut point = |name: &str| {
            let Some((text, place)) = self.attribute(node, name) else {
                self.error(node, format!("this lookat has no `{name}`"), format!("{name}=\"x, y, z\""));
                return None;
            };
            self.triple(&text, &place, &format!("`{name}`"))
        };
        let (origin, target, up) = (point("origin"), point("target"), point("up"));
        let transform = Affine::look_at(origin?, target?, up?);
        if transform.is_none() {
            let expected =
                "a target other than the origin, and an `up` that is not parallel to the viewing direction";
            self.error(node, "the orientation of the lookat is undefined", expected);
        }
        transform
    }

    /// Parses sixteen numbers, row by row, or the nine of A.
    fn matrix(&mut self, node: Node<'a>) -> Option<Affine> {
        self.attributes(node, &["value"]);
        let (text, place) = self.attribute(node, "value").unwrap_or((String::new(), node.range()));
        let m = self.numbers(&text, &place, "`value`", &COORDINATE);
        let column = |width: usize, j: usize| Vector::new(m[j], m[width + j], m[2 * width + j]);
        match m.len() {
            9 => Some(Affine { columns: [0, 1, 2].map(|j| column(3, j)), shift: Vector::default() }),
            16 if m[12..] == [0.0, 0.0, 0.0, 1.0] => {
                Some(Affine { columns: [0, 1, 2].map(|j| column(4, j)), shift: column(4, 3) })
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
