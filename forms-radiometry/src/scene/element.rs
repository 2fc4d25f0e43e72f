//! Elements: typed access to the keys of a table of the file, with errors for unknown and missing
//! keys.

use super::error::Report;
use super::value::{Domain, Value, direction, number, one_of, spectrum, text, vector};
use crate::geometry::Vector;
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use toml::de::DeTable;

/// A table of the file, such as one `[[surface]]`.
pub(super) struct Element<'a, 't> {
    /// The kind of element, in words: "surface".
    pub(super) kind: &'static str,
    pub(super) table: &'a DeTable<'t>,
    /// The place of its header in the text.
    pub(super) place: Range<usize>,
}

impl<'a, 't> Element<'a, 't> {
    /// Returns the elements of a `[[key]]` list.
    pub(super) fn list(report: &mut Report, root: &'a DeTable<'t>, key: &'static str) -> Vec<Self> {
        let Some(value) = root.get(key) else { return Vec::new() };
        let Some(array) = value.get_ref().as_array() else {
            report.error(value.span(), format!("`{key}` is not a list"), format!("[[{key}]]"));
            return Vec::new();
        };
        let mut elements = Vec::new();
        for item in array.iter() {
            match item.get_ref().as_table() {
                Some(table) => elements.push(Self { kind: key, table, place: item.span() }),
                None => report.error(item.span(), format!("this {key} is not a table"), format!("[[{key}]]")),
            }
        }
        elements
    }

    /// Returns the element of a key whose value is a table.
    pub(super) fn single(
        report: &mut Report,
        value: &'a Value<'t>,
        kind: &'static str,
        what: &str,
        expected: &str,
    ) -> Option<Self> {
        let Some(table) = value.get_ref().as_table() else {
            report.error(value.span(), format!("{what} is not a table"), expected);
            return None;
        };
        Some(Self { kind, table, place: value.span() })
    }

    /// Reports every unknown key.
    pub(super) fn check_keys(&self, report: &mut Report, known: &[&str]) {
        for key in self.table.keys() {
            let name: &str = key.get_ref();
            if !known.contains(&name) {
                let expected = one_of(known.iter().copied());
                report.error(key.span(), format!("unknown key `{name}` in a {}", self.kind), expected);
            }
        }
    }

    pub(super) fn optional(&self, key: &str) -> Option<&'a Value<'t>> {
        self.table.get(key)
    }

    pub(super) fn required(&self, report: &mut Report, key: &str, expected: &str) -> Option<&'a Value<'t>> {
        let value = self.table.get(key);
        if value.is_none() {
            report.error(self.place.clone(), format!("this {} has no `{key}`", self.kind), expected);
        }
        value
    }

    /// Returns the text of a required key, with its place.
    pub(super) fn text(
        &self,
        report: &mut Report,
        key: &str,
        expected: &str,
    ) -> Option<(&'a str, Range<usize>)> {
        let value = self.required(report, key, expected)?;
        Some((text(report, value, &format!("`{key}`"))?, value.span()))
    }

    /// Returns the point of a required key.
    pub(super) fn point(&self, report: &mut Report, key: &str) -> Option<Vector> {
        let value = self.required(report, key, &format!("{key} = [x, y, z]"))?;
        vector(report, value, &format!("`{key}`"))
    }

    /// Returns the direction of a required key, as a unit vector.
    pub(super) fn direction(&self, report: &mut Report, key: &str) -> Option<Vector> {
        let value = self.required(report, key, &format!("{key} = [x, y, z]"))?;
        direction(report, value, &format!("`{key}`"))
    }

    /// Returns the number of a required key.
    pub(super) fn number(&self, report: &mut Report, key: &str, domain: &Domain) -> Option<f64> {
        let value = self.required(report, key, domain.expected)?;
        number(report, value, &format!("`{key}`"), domain)
    }

    /// Returns the optical numbers of a required key, one for each band.
    pub(super) fn spectrum(
        &self,
        report: &mut Report,
        key: &str,
        domain: &Domain,
        bands: Option<usize>,
    ) -> Option<Vec<f64>> {
        let value = self.required(report, key, &format!("{}, or one per band", domain.expected))?;
        spectrum(report, value, &format!("`{key}`"), domain, bands)
    }

    /// Returns the optical numbers of an optional key, or its default value.
    pub(super) fn spectrum_or(
        &self,
        report: &mut Report,
        key: &str,
        default: f64,
        domain: &Domain,
        bands: Option<usize>,
    ) -> Option<Vec<f64>> {
        match self.optional(key) {
            None => Some(vec![default; bands.unwrap_or(1)]),
            Some(value) => spectrum(report, value, &format!("`{key}`"), domain, bands),
        }
    }

    /// Returns the index of the element that a required key names.
    pub(super) fn reference(
        &self,
        report: &mut Report,
        key: &str,
        expected: &str,
        what: &str,
        known: &Indices,
    ) -> Option<usize> {
        let (name, place) = self.text(report, key, expected)?;
        known.find(report, place, what, name)
    }
}

/// The indices of the elements of one kind by name. An invalid element keeps its name, so that the
/// error is not repeated wherever the element is used.
#[derive(Default)]
pub(super) struct Indices {
    indices: HashMap<String, usize>,
    /// The elements that are left out of the scene.
    left_out: HashSet<String>,
}

impl Indices {
    /// Returns the name of an element, and registers it with this index.
    pub(super) fn name(
        &mut self,
        report: &mut Report,
        element: &Element,
        names: &mut Names,
        index: usize,
    ) -> Option<String> {
        let name = names.name(report, element)?;
        self.insert(name.clone(), index);
        Some(name)
    }

    /// Registers a name with this index.
    pub(super) fn insert(&mut self, name: String, index: usize) {
        self.indices.insert(name, index);
    }

    /// Registers the name of an element without faces, which is left out of the scene.
    pub(super) fn leave_out(&mut self, name: &str) {
        self.left_out.insert(name.to_owned());
    }

    /// Returns the index of a name. An unknown name is reported.
    pub(super) fn find(
        &self,
        report: &mut Report,
        place: Range<usize>,
        what: &str,
        name: &str,
    ) -> Option<usize> {
        let index = self.indices.get(name).copied();
        if self.left_out.contains(name) {
            report.error(place, format!("the {what} `{name}` has no faces, and is left out"), "");
        } else if index.is_none() {
            let mut known: Vec<&str> = self.indices.keys().map(String::as_str).collect();
            known.sort_unstable();
            let expected = match known[..] {
                [] => format!("the name of a {what} (the scene defines none)"),
                _ => one_of(known.into_iter()),
            };
            report.error(place, format!("no {what} is named `{name}`"), expected);
        }
        index
    }
}

/// The names used so far for one kind of element, each with the byte of its definition.
#[derive(Default)]
pub(super) struct Names {
    given: HashMap<String, usize>,
}

impl Names {
    /// Returns the name of an element. A missing or duplicate name is reported.
    pub(super) fn name(&mut self, report: &mut Report, element: &Element) -> Option<String> {
        let (name, place) = element.text(report, "name", "name = \"…\"")?;
        self.give(report, element.kind, name, place)
    }

    /// Registers a name defined at this place. A duplicate name is reported.
    pub(super) fn give(
        &mut self,
        report: &mut Report,
        kind: &str,
        name: &str,
        place: Range<usize>,
    ) -> Option<String> {
        if let Some(&first) = self.given.get(name) {
            let line = report.line(first, place.start);
            let message = format!("the {kind} `{name}` is already defined in {line}");
            report.error(place, message, "a unique name");
            return None;
        }
        self.given.insert(name.to_owned(), place.start);
        Some(name.to_owned())
    }
}

/// Returns the name, with a number appended if it is taken: one element can become several parts of
/// a scene.
pub(super) fn unique(name: &str, is_taken: impl Fn(&str) -> bool) -> String {
    let numbered = (2..).map(|number| format!("{name} ({number})"));
    let mut candidates = [name.to_owned()].into_iter().chain(numbered);
    candidates.find(|candidate| !is_taken(candidate)).unwrap_or_default()
}
