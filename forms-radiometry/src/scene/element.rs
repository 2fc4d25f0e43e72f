//! Elements: a table of the file becomes an element whose keys are all known.

use super::error::Report;
use super::value::{Value, one_of, text};
use std::collections::HashMap;
use std::ops::Range;
use toml::de::DeTable;

/// A table of the file, such as one `[[surface]]`.
pub(super) struct Element<'a, 't> {
    /// What it is, in words: "surface".
    pub(super) kind: &'static str,
    pub(super) table: &'a DeTable<'t>,
    /// The place of its head in the text.
    pub(super) place: Range<usize>,
}

impl<'a, 't> Element<'a, 't> {
    /// The elements of a `[[key]]` list.
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

    /// Reports every key that is not known. Those in `later` are part of the format, but not simulated.
    pub(super) fn check_keys(&self, report: &mut Report, known: &[&str], later: &[&str]) {
        for key in self.table.keys() {
            let name: &str = key.get_ref();
            if later.contains(&name) {
                report.error(key.span(), format!("`{name}` of a {} is not supported yet", self.kind), "");
            } else if !known.contains(&name) {
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

    /// The text of a required key, with its place.
    pub(super) fn text(
        &self,
        report: &mut Report,
        key: &str,
        expected: &str,
    ) -> Option<(&'a str, Range<usize>)> {
        let value = self.required(report, key, expected)?;
        Some((text(report, value, &format!("`{key}`"))?, value.span()))
    }
}

/// The names given so far to one kind of element, each with the byte where it was given.
#[derive(Default)]
pub(super) struct Names {
    given: HashMap<String, usize>,
}

impl Names {
    /// The name of an element, reported if it is missing or was given before.
    pub(super) fn name(&mut self, report: &mut Report, element: &Element) -> Option<String> {
        let (name, place) = element.text(report, "name", "name = \"…\"")?;
        if let Some(&first) = self.given.get(name) {
            let line = report.line(first);
            let message =
                format!("the {} `{name}` has the name of an earlier one, in line {line}", element.kind);
            report.error(place, message, "a name of its own");
            return None;
        }
        self.given.insert(name.to_owned(), place.start);
        Some(name.to_owned())
    }
}
