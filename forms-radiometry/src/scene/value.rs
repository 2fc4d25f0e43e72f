//! Typed values: converts a TOML value to a number, a vector, a spectrum or a text, or reports an
//! error at its place.

use super::error::Report;
use crate::camera::MAXIMAL_RESOLUTION;
use crate::geometry::Vector;
use crate::geometry::scale::{LARGEST_LENGTH, LEAST_LENGTH};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeArray, DeValue};

/// A value with its place in the text.
pub(super) type Value<'t> = Spanned<DeValue<'t>>;

/// Domain of a number: a predicate, and its description.
pub(super) struct Domain {
    /// Completes "expected …", such as "a number from 0 to 1".
    pub(super) expected: &'static str,
    pub(super) contains: fn(f64) -> bool,
}

/// Coordinates whose squares are representable.
pub(super) const COORDINATE: Domain =
    Domain { expected: "a number from -1e152 to 1e152", contains: |x| x.abs() <= LARGEST_LENGTH };
/// Lengths whose squares are representable.
pub(super) const LENGTH: Domain = Domain {
    expected: "a number from 1e-152 to 1e152",
    contains: |x| (LEAST_LENGTH..=LARGEST_LENGTH).contains(&x),
};
pub(super) const FRACTION: Domain =
    Domain { expected: "a number from 0 to 1", contains: |x| (0.0..=1.0).contains(&x) };
pub(super) const NOT_NEGATIVE: Domain = Domain { expected: "a number of at least 0", contains: |x| x >= 0.0 };
/// Coefficients of media: their products with lengths neither overflow nor underflow.
pub(super) const COEFFICIENT: Domain = Domain {
    expected: "0, or a number from 1e-160 to 1e160",
    contains: |x| x == 0.0 || (1e-160..=1e160).contains(&x),
};
pub(super) const POSITIVE: Domain = Domain { expected: "a number above 0", contains: |x| x > 0.0 };
pub(super) const ANY: Domain = Domain { expected: "a number", contains: |_| true };
/// Mean cosines of phase functions.
pub(super) const MEAN_COSINE: Domain =
    Domain { expected: "a number above -1 and below 1", contains: |x| x.abs() < 1.0 };
pub(super) const FIELD_OF_VIEW: Domain =
    Domain { expected: "an angle in degrees, above 0 and below 180", contains: |x| x > 0.0 && x < 180.0 };
pub(super) const PIXELS: Domain = Domain {
    expected: "an integer from 1 to 8192",
    contains: |x| x.fract() == 0.0 && (1.0..=MAXIMAL_RESOLUTION as f64).contains(&x),
};

/// 2⁵³: every integer up to here is an `f64`.
pub(super) const LARGEST_WHOLE: f64 = 9_007_199_254_740_992.0;

fn wrong_kind(report: &mut Report, value: &Value, what: &str, expected: &str) {
    let found = value.get_ref().type_str();
    report.error(value.span(), format!("{what} has the wrong type: found {found}"), expected);
}

pub(super) fn text<'a>(report: &mut Report, value: &'a Value, what: &str) -> Option<&'a str> {
    let found = value.get_ref().as_str();
    if found.is_none() {
        wrong_kind(report, value, what, "a string");
    }
    found
}

pub(super) fn boolean(report: &mut Report, value: &Value, what: &str) -> Option<bool> {
    let found = value.get_ref().as_bool();
    if found.is_none() {
        wrong_kind(report, value, what, "true or false");
    }
    found
}

/// Returns a finite number of the domain.
pub(super) fn number(report: &mut Report, value: &Value, what: &str, domain: &Domain) -> Option<f64> {
    let Some(found) = plain_number(value.get_ref()) else {
        wrong_kind(report, value, what, domain.expected);
        return None;
    };
    within(report, value.span(), what, found, domain)
}

/// Returns the number. A number that is not finite or outside the domain is reported.
pub(super) fn within(
    report: &mut Report,
    place: Range<usize>,
    what: &str,
    found: f64,
    domain: &Domain,
) -> Option<f64> {
    if !found.is_finite() {
        report.error(place, format!("{what} is not finite"), domain.expected);
        return None;
    }
    if !(domain.contains)(found) {
        report.error(place, format!("{what} is out of range"), domain.expected);
        return None;
    }
    Some(found)
}

/// Returns the number in a value, if it is one.
pub(super) fn plain_number(value: &DeValue) -> Option<f64> {
    match value {
        DeValue::Float(float) => float.as_str().parse().ok(),
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
        DeValue::Integer(integer) => {
            u64::from_str_radix(integer.as_str(), integer.radix()).ok().map(|integer| integer as f64)
        }
        _ => None,
    }
}

/// Returns an array of exactly `length` values.
pub(super) fn array<'a, 't>(
    report: &mut Report,
    value: &'a Value<'t>,
    what: &str,
    length: usize,
    expected: &str,
) -> Option<&'a DeArray<'t>> {
    let Some(array) = value.get_ref().as_array() else {
        wrong_kind(report, value, what, expected);
        return None;
    };
    if array.len() != length {
        report.error(value.span(), format!("{what} has {}", values(array.len())), expected);
        return None;
    }
    Some(array)
}

/// Returns a vector of three coordinates.
pub(super) fn vector(report: &mut Report, value: &Value, what: &str) -> Option<Vector> {
    let coordinates = array(report, value, what, 3, "three coordinates [x, y, z]")?;
    let mut numbers = coordinates
        .iter()
        .map(|value| number(report, value, &format!("a coordinate of {what}"), &COORDINATE));
    let (x, y, z) = (numbers.next()?, numbers.next()?, numbers.next()?);
    Some(Vector::new(x?, y?, z?))
}

/// Returns the unit vector in the direction of a vector other than zero.
pub(super) fn direction(report: &mut Report, value: &Value, what: &str) -> Option<Vector> {
    let unit = vector(report, value, what)?.unit();
    if unit.is_none() {
        report.error(value.span(), format!("{what} has length zero"), "a vector with a direction");
    }
    unit
}

/// Returns two integer numbers of pixels or cells.
pub(super) fn pixels(report: &mut Report, value: &Value, what: &str, expected: &str) -> Option<[usize; 2]> {
    let sides = array(report, value, what, 2, expected)?;
    let mut numbers = sides.iter().map(|side| number(report, side, what, &PIXELS));
    let (width, height) = (numbers.next()?, numbers.next()?);
    Some([width? as usize, height? as usize])
}

/// Returns one number for each band, from a list or from one number for all. If the bands
/// themselves are invalid, their number is unknown, and only the numbers of the list are checked.
pub(super) fn spectrum(
    report: &mut Report,
    value: &Value,
    what: &str,
    domain: &Domain,
    bands: Option<usize>,
) -> Option<Vec<f64>> {
    let Some(array) = value.get_ref().as_array() else {
        return number(report, value, what, domain).map(|number| vec![number; bands.unwrap_or(1)]);
    };
    if bands.is_some_and(|bands| bands != array.len()) {
        let expected = match bands {
            Some(bands) if bands > 1 => format!("one number, or {bands} (one per band)"),
            _ => "one number".to_owned(),
        };
        report.error(value.span(), format!("{what} has {}", values(array.len())), expected);
        return None;
    }
    let numbers: Vec<Option<f64>> = array.iter().map(|value| number(report, value, what, domain)).collect();
    numbers.into_iter().collect()
}

/// Returns one of the named choices.
pub(super) fn choice<T: Copy>(
    report: &mut Report,
    place: Range<usize>,
    found: &str,
    what: &str,
    choices: &[(&str, T)],
) -> Option<T> {
    let chosen = choices.iter().find(|(name, _)| *name == found).map(|&(_, choice)| choice);
    if chosen.is_none() {
        report.error(
            place,
            format!("{what} `{found}` is unknown"),
            one_of(choices.iter().map(|(name, _)| *name)),
        );
    }
    chosen
}

/// Formats a count: "1 value", "2 values".
pub(super) fn values(count: usize) -> String {
    let ending = if count == 1 { "" } else { "s" };
    format!("{count} value{ending}")
}

/// Formats a list of alternatives: "`a`, `b` or `c`".
pub(super) fn one_of<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let quoted: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    match quoted.split_last() {
        None => "nothing".to_owned(),
        Some((only, [])) => only.clone(),
        Some((last, rest)) => format!("{} or {last}", rest.join(", ")),
    }
}
