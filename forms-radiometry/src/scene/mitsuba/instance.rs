//! Instances: the shapes of a group become surfaces at each place where the scene puts the group.

use super::{Node, Reader};
use crate::geometry::Affine;

/// A group of shapes at one place.
pub(super) struct Instance {
    pub(super) name: String,
    pub(super) to_world: Affine,
}

impl<'a> Reader<'a, '_, '_> {
    /// Reads an instance. The surfaces are named after it and the shapes of the group.
    pub(super) fn instance(&mut self, node: Node<'a>) {
        let mut object = self.object(node);
        let count = self.surfaces.len();
        let name = self.name(&object, "instance", count);
        let to_world = self.transform(&mut object);
        let group = self.take_object(&mut object, "shape");
        self.finish(object, &["to_world", "shape"]);
        let Some(group) = group.filter(|&group| self.kind(group) == "shapegroup") else {
            self.error(
                node,
                "this instance refers to no group of shapes",
                "a `ref` to a shape of type `shapegroup`",
            );
            return;
        };
        let mut group = self.object(group);
        self.instance = Some(Instance { name, to_world });
        while let Some(shape) = self.take_object(&mut group, "shape") {
            self.grouped(shape);
        }
        self.instance = None;
        self.finish(group, &["shape"]);
    }

    /// Reads a shape of a group. Like Mitsuba, it excludes groups in groups, emitters and sensors.
    fn grouped(&mut self, node: Node<'a>) {
        let kind = self.kind(node);
        if matches!(&*kind, "instance" | "shapegroup") {
            self.error(node, format!("a shape of type `{kind}` cannot be part of a group"), "other shapes");
            return;
        }
        let mut object = self.object(node);
        for tag in ["emitter", "sensor"] {
            if self.take_object(&mut object, tag).is_some() {
                self.error(
                    node,
                    format!("the shapes of a group cannot have {tag}s"),
                    "a shape outside the group",
                );
                return;
            }
        }
        self.shape(node);
    }
}
