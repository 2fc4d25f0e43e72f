//! Values: parses a property of an object into a number, a point, a colour or a text.

use super::object::Object;
use super::{Node, Reader};
use crate::geometry::Vector;
use crate::scene::value::{COORDINATE, Domain, one_of, values, within};
use std::ops::Range;

impl<'a> Reader<'a, '_, '_> {
    /// Returns the value of a property with one of these tags, and its place.
    fn property(&mut self, node: Node<'a>, tags: &[&str]) -> Option<(String, Range<usize>)> {
        let tag = node.tag_name().name();
        if !tags.contains(&tag) {
            let name = node.attribute("name").unwrap_or_default();
            let expected = one_of(tags.iter().copied());
            self.error(node, format!("`{name}` cannot be a `{tag}`"), expected);
            return None;
        }
        let known: &[&str] = if matches!(tag, "point" | "vector") {
            &["name", "value", "x", "y", "z"]
        } else {
            &["name", "value"]
        };
        let are_known = self.attributes(node, known);
        for child in self.elements(node) {
            self.error(
                child,
                format!("`{}` is not supported in a `{tag}`", child.tag_name().name()),
                "a value",
            );
        }
        if known.len() > 2 && node.attribute("value").is_none() {
            let mut coordinates =
                ["x", "y", "z"].map(|axis| self.attribute(node, axis).map(|(value, _)| value));
            let text =
                coordinates.each_mut().map(|value| value.take().unwrap_or_else(|| "0".to_owned())).join(",");
            return Some((text, node.range()));
        }
        let value = self.attribute(node, "value");
        if are_known && !node.has_attribute("value") {
            self.error(node, format!("this {tag} has no `value`"), "value=\"…\"");
        }
        value
    }

    /// Parses numbers separated by commas or spaces; returns none if one of the numbers is invalid.
    pub(super) fn numbers(
        &mut self,
        text: &str,
        place: &Range<usize>,
        what: &str,
        domain: &Domain,
    ) -> Vec<f64> {
        let words = text.split(|c: char| c == ',' || c.is_whitespace()).filter(|word| !word.is_empty());
        let mut numbers = Vec::new();
        for word in words {
            let Ok(number) = word.parse() else {
                self.report.error(place.clone(), format!("`{word}` is not a number"), domain.expected);
                return Vec::new();
            };
            let Some(number) = within(self.report, place.clone(), what, number, domain) else {
                return Vec::new();
            };
            numbers.push(number);
        }
        if numbers.is_empty() && text.trim().is_empty() {
            self.report.error(place.clone(), format!("{what} is empty"), domain.expected);
        }
        numbers
    }

    /// Parses the only number of a text.
    fn one(&mut self, text: &str, place: &Range<usize>, what: &str, domain: &Domain) -> Option<f64> {
        match self.numbers(text, place, what, domain)[..] {
            [number] => Some(number),
            [] => None,
            ref numbers => {
                let message = format!("{what} has {}", values(numbers.len()));
                self.report.error(place.clone(), message, domain.expected);
                None
            }
        }
    }

    pub(super) fn float(
        &mut self,
        object: &mut Object<'a>,
        name: &str,
        default: f64,
        domain: &Domain,
    ) -> f64 {
        let Some(node) = object.take(name) else { return default };
        if node.has_tag_name("texture") {
            self.texture(node);
            return default;
        }
        let Some((text, place)) = self.property(node, &["float", "integer"]) else { return default };
        self.one(&text, &place, &format!("`{name}`"), domain).unwrap_or(default)
    }

    /// Whether a property is `true`; `if_wrong` where it is invalid.
    pub(super) fn boolean(
        &mut self,
        object: &mut Object<'a>,
        name: &str,
        default: bool,
        if_wrong: bool,
    ) -> bool {
        let Some(node) = object.take(name) else { return default };
        let Some((text, place)) = self.property(node, &["boolean"]) else { return if_wrong };
        match &*text.to_ascii_lowercase() {
            "true" => true,
            "false" => false,
            _ => {
                self.report.error(place, format!("`{name}` cannot be `{text}`"), "true or false");
                if_wrong
            }
        }
    }

    /// Returns a text and its place.
    pub(super) fn string(&mut self, object: &mut Object<'a>, name: &str) -> Option<(String, Range<usize>)> {
        let node = object.take(name)?;
        self.property(node, &["string"])
    }

    /// Returns a point or vector.
    pub(super) fn vector(&mut self, object: &mut Object<'a>, name: &str) -> Option<Vector> {
        let node = object.take(name)?;
        let (text, place) = self.property(node, &["point", "vector"])?;
        self.triple(&text, &place, &format!("`{name}`"))
    }

    /// Parses three coordinates.
    pub(super) fn triple(&mut self, text: &str, place: &Range<usize>, what: &str) -> Option<Vector> {
        match self.numbers(text, place, &format!("a coordinate of {what}"), &COORDINATE)[..] {
            [x, y, z] => Some(Vector::new(x, y, z)),
            [] => None,
            ref numbers => {
                let message = format!("{what} has {}", values(numbers.len()));
                self.report.error(place.clone(), message, "three coordinates x, y, z");
                None
            }
        }
    }

    /// Returns a colour with one number for each band; `None` if the object has no property with
    /// this name.
    pub(super) fn colour(
        &mut self,
        object: &mut Object<'a>,
        name: &str,
        domain: &Domain,
    ) -> Option<Vec<f64>> {
        let node = object.take(name)?;
        let black = vec![0.0; self.bands];
        let Some(node) = self.resolved(node) else { return Some(black) };
        Some(self.colour_of(node, name, domain).unwrap_or(black))
    }

    /// Returns a colour, or `None` if it is invalid.
    fn colour_of(&mut self, node: Node<'a>, name: &str, domain: &Domain) -> Option<Vec<f64>> {
        let what = format!("`{name}`");
        match node.tag_name().name() {
            "texture" => {
                self.texture(node);
                return None;
            }
            "spectrum" if node.has_attribute("type") => return self.black_body(node, &what, domain),
            _ => {}
        }
        let (text, place) = self.property(node, &["rgb", "spectrum", "float"])?;
        let is_rgb = node.has_tag_name("rgb");
        if !is_rgb && text.contains(':') {
            return self.table(&text, &place, &what, domain);
        }
        let numbers = self.numbers(&text, &place, &what, domain);
        match numbers[..] {
            [value] => Some(vec![value; self.bands]),
            [_, _, _] if is_rgb => Some(numbers),
            [] => None,
            _ => {
                let expected = if is_rgb { "one value, or red, green and blue" } else { "one value" };
                self.report.error(place, format!("{what} has {}", values(numbers.len())), expected);
                None
            }
        }
    }

    /// Returns a required colour.
    pub(super) fn required_colour(
        &mut self,
        object: &mut Object<'a>,
        name: &str,
        domain: &Domain,
    ) -> Vec<f64> {
        self.colour(object, name, domain).unwrap_or_else(|| {
            let expected = format!("an `rgb`, `spectrum` or `float` named `{name}`");
            self.error(
                object.node,
                format!("this {} has no `{name}`", object.node.tag_name().name()),
                expected,
            );
            vec![0.0; self.bands]
        })
    }
}
