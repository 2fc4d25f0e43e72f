//! Objects: an element with a type. The known properties are taken from its children one by one;
//! remaining children are errors.

use super::{Node, Reader};
use crate::scene::value::one_of;
use std::ops::Range;

/// An element such as `<shape type="sphere">`.
pub(super) struct Object<'a> {
    pub(super) node: Node<'a>,
    /// Its type.
    pub(super) kind: String,
    left: Vec<Node<'a>>,
    /// The names of the requested properties.
    asked: Vec<String>,
}

impl<'a> Object<'a> {
    /// Takes the property with this name.
    pub(super) fn take(&mut self, name: &str) -> Option<Node<'a>> {
        let is_it = |node: &Node<'a>| node.attribute("name") == Some(name);
        self.asked.push(name.to_owned());
        self.left.iter().position(is_it).map(|place| self.left.remove(place))
    }

    /// Whether a property with this name has not been taken yet.
    pub(super) fn has(&self, name: &str) -> bool {
        self.left.iter().any(|node| node.attribute("name") == Some(name))
    }

    /// Returns the children that have not been taken yet.
    pub(super) fn left(&self) -> impl Iterator<Item = Node<'a>> {
        self.left.iter().copied()
    }

    /// Drops the properties with these names, which do not affect the result.
    pub(super) fn ignore(&mut self, names: &[&str]) {
        for name in names {
            self.take(name);
        }
    }
}

impl<'a> Reader<'a, '_, '_> {
    /// Converts an element to an object.
    pub(super) fn object(&mut self, node: Node<'a>) -> Object<'a> {
        self.attributes(node, &["type", "id", "name"]);
        let kind = self.attribute(node, "type").map_or(String::new(), |(kind, _)| kind);
        if kind.is_empty() && !node.has_attribute("type") {
            self.error(node, format!("this {} has no `type`", node.tag_name().name()), "type=\"…\"");
        }
        let left = self.elements(node);
        Object { node, kind, left, asked: Vec::new() }
    }

    /// Returns the type of an element after substitution of parameters; empty if it has no valid one.
    pub(super) fn kind(&self, node: Node<'a>) -> String {
        self.parameters.substitute(node.attribute("type").unwrap_or_default()).unwrap_or_default()
    }

    /// Reports the remaining children of an object. `known` lists all allowed properties. A known
    /// property that was not requested because the object is invalid is not reported.
    pub(super) fn finish(&mut self, object: Object<'a>, known: &[&str]) {
        let Object { node, kind, left, asked } = object;
        let whole = described(node, &kind);
        let is_asked = |name: &str| asked.iter().any(|asked| asked == name);
        let is_in_error = !self.report.is_empty();
        for node in left {
            let Some(node) = self.resolved(node) else { continue };
            let tag = node.tag_name().name();
            if let Some(name) = node.attribute("name").filter(|name| known.contains(name)) {
                if is_asked(name) {
                    self.error(node, format!("`{name}` occurs twice in {whole}"), "one of them");
                    continue;
                }
                if is_in_error {
                    continue;
                }
            }
            let found = match (node.attribute("name"), node.attribute("type")) {
                (Some(name), _) => format!("`{tag}` named `{name}`"),
                (None, Some(kind)) => format!("`{tag}` of type `{kind}`"),
                (None, None) => format!("`{tag}`"),
            };
            let own_name = node.attribute("name").unwrap_or_default();
            let others = known.iter().copied().filter(|known| *known != own_name);
            self.error(node, format!("{found} is not supported in {whole}"), one_of(others));
        }
    }

    /// Reports an unknown type, once for each type. The contents of such an object are not checked.
    pub(super) fn unknown(&mut self, object: &mut Object<'a>, known: &[&str]) {
        object.left.clear();
        if !self.refused.insert(described(object.node, &object.kind)) {
            return;
        }
        let place = object.node.attribute_node("type").map_or(object.node.range(), |kind| kind.range_value());
        let message = format!("{} is not supported", described(object.node, &object.kind));
        self.report.error(place, message, one_of(known.iter().copied()));
    }

    /// Reports a texture that is not supported where it stands.
    pub(super) fn texture(&mut self, node: Node<'a>) {
        let object = self.object(node);
        if self.refused.insert(described(node, &object.kind)) {
            let place = node.attribute_node("type").map_or(node.range(), |kind| kind.range_value());
            let message = format!("{} is not supported", described(node, &object.kind));
            self.report.error(place, message, "an `rgb`, `spectrum` or `float`");
        }
    }

    /// Returns the children that are elements; text between them is an error.
    pub(super) fn elements(&mut self, node: Node<'a>) -> Vec<Node<'a>> {
        for child in node.children().filter(Node::is_text) {
            let text = child.text().unwrap_or_default();
            if !text.trim().is_empty() {
                let start = child.range().start + text.len() - text.trim_start().len();
                self.report.error(start..child.range().end, "unexpected text", "elements");
            }
        }
        node.children().filter(Node::is_element).collect()
    }

    /// Reports attributes other than these. Returns whether there are none.
    pub(super) fn attributes(&mut self, node: Node<'a>, known: &[&str]) -> bool {
        let mut unknown = node.attributes().filter(|attribute| !known.contains(&attribute.name())).peekable();
        let are_known = unknown.peek().is_none();
        for attribute in unknown {
            let message = format!("unknown attribute `{}` of `{}`", attribute.name(), node.tag_name().name());
            self.report.error(attribute.range(), message, one_of(known.iter().copied()));
        }
        are_known
    }

    /// Returns the value of an attribute after substitution of parameters, and its place; `None` if
    /// a parameter is missing.
    pub(super) fn attribute(&mut self, node: Node<'a>, name: &str) -> Option<(String, Range<usize>)> {
        let attribute = node.attribute_node(name)?;
        let value = match self.parameters.substitute(attribute.value()) {
            Ok(value) => value,
            Err((message, expected)) => {
                self.report.error(attribute.range_value(), message, expected);
                return None;
            }
        };
        Some((value, attribute.range_value()))
    }

    /// Returns the object to which a `ref` refers, or the node itself.
    pub(super) fn resolved(&mut self, node: Node<'a>) -> Option<Node<'a>> {
        if !node.has_tag_name("ref") {
            return Some(node);
        }
        self.attributes(node, &["id", "name"]);
        let (id, place) = self.attribute(node, "id")?;
        let target = self.ids.get(&*id).copied();
        if target.is_none() {
            self.report.error(
                place,
                format!("no element has the id `{id}`"),
                "the id of an element of the scene",
            );
        }
        target
    }

    /// Takes the first child that is, or refers to, an element with this tag.
    pub(super) fn take_object(&mut self, object: &mut Object<'a>, tag: &str) -> Option<Node<'a>> {
        let is_it = |reader: &Self, node: &Node<'a>| {
            let target = if node.has_tag_name("ref") {
                node.attribute("id").and_then(|id| reader.ids.get(id).copied())
            } else {
                Some(*node)
            };
            target.is_some_and(|target| target.has_tag_name(tag))
        };
        let place = object.left.iter().position(|node| is_it(self, node))?;
        let node = object.left.remove(place);
        self.resolved(node)
    }
}

fn described(node: Node, kind: &str) -> String {
    let tag = node.tag_name().name();
    let article = if tag.starts_with(['e', 'i']) { "an" } else { "a" };
    format!("{article} {tag} of type `{kind}`")
}
