//! Round shapes: parses `sphere`, `disk`, `annulus`, `cylinder`, `cone` and `paraboloid`.

use super::element::Element;
use super::error::Report;
use super::model::Shape;
use super::value::{Domain, LENGTH, Value, array, boolean, number};
use crate::geometry::{Disk, Profile, Quadric, Sphere, Vector};
use std::ops::Range;

/// Radii that can be zero.
const RADIUS: Domain = Domain {
    expected: "0, or a number from 1e-152 to 1e152",
    contains: |x| x == 0.0 || (LENGTH.contains)(x),
};

/// Returns the shape of a surface with this key, if it is round.
pub(super) fn read(report: &mut Report, key: &str, value: &Value) -> Option<Shape> {
    match key {
        "sphere" => sphere(report, value).map(Shape::Sphere),
        "disk" => disk(report, value).map(Shape::Disk),
        "annulus" => annulus(report, value).map(Shape::Disk),
        "cylinder" => cylinder(report, value).map(Shape::Quadric),
        "cone" => cone(report, value).map(Shape::Quadric),
        "paraboloid" => paraboloid(report, value).map(Shape::Quadric),
        _ => None,
    }
}

fn sphere(report: &mut Report, value: &Value) -> Option<Sphere> {
    const EXPECTED: &str = "sphere = { center = [x, y, z], radius = … }";
    let element = Element::single(report, value, "`sphere`", "`sphere`", EXPECTED)?;
    element.check_keys(report, &["center", "radius", "inward"]);
    let (center, radius) = (element.point(report, "center"), element.number(report, "radius", &LENGTH));
    let inward = inward(report, &element);
    Some(Sphere { center: center?, radius: radius?, inward: inward? })
}

fn inward(report: &mut Report, element: &Element) -> Option<bool> {
    match element.optional("inward") {
        None => Some(false),
        Some(value) => boolean(report, value, "`inward`"),
    }
}

fn disk(report: &mut Report, value: &Value) -> Option<Disk> {
    const EXPECTED: &str = "disk = { center = [x, y, z], normal = [x, y, z], radius = … }";
    let element = Element::single(report, value, "`disk`", "`disk`", EXPECTED)?;
    element.check_keys(report, &["center", "normal", "radius"]);
    let (center, normal) = (element.point(report, "center"), element.direction(report, "normal"));
    let radius = element.number(report, "radius", &LENGTH);
    Some(Disk { center: center?, normal: normal?, radius: radius?, hole: 0.0 })
}

fn annulus(report: &mut Report, value: &Value) -> Option<Disk> {
    const EXPECTED: &str = "annulus = { center = [x, y, z], normal = [x, y, z], radii = [inner, outer] }";
    let element = Element::single(report, value, "`annulus`", "`annulus`", EXPECTED)?;
    element.check_keys(report, &["center", "normal", "radii"]);
    let (center, normal) = (element.point(report, "center"), element.direction(report, "normal"));
    let radii = radii(report, &element, "radii = [inner, outer]");
    let ([hole, radius], place) = radii?;
    if hole >= radius {
        let message = "the inner radius of the annulus is not smaller than the outer one";
        report.error(place, message, "radii = [inner, outer]");
        return None;
    }
    Some(Disk { center: center?, normal: normal?, radius, hole })
}

fn cylinder(report: &mut Report, value: &Value) -> Option<Quadric> {
    const EXPECTED: &str = "cylinder = { from = [x, y, z], to = [x, y, z], radius = … }";
    let element = Element::single(report, value, "`cylinder`", "`cylinder`", EXPECTED)?;
    element.check_keys(report, &["from", "to", "radius", "inward"]);
    let (ends, inward) = (ends(report, &element), inward(report, &element));
    let radius = element.number(report, "radius", &LENGTH)?;
    Some(Quadric { ends: ends?, radii: [radius; 2], profile: Profile::Straight, inward: inward? })
}

fn cone(report: &mut Report, value: &Value) -> Option<Quadric> {
    const EXPECTED: &str =
        "cone = { from = [x, y, z], to = [x, y, z], radii = [radius at `from`, radius at `to`] }";
    let element = Element::single(report, value, "`cone`", "`cone`", EXPECTED)?;
    element.check_keys(report, &["from", "to", "radii", "inward"]);
    let (ends, inward) = (ends(report, &element), inward(report, &element));
    let (radii, place) = radii(report, &element, "radii = [radius at `from`, radius at `to`]")?;
    if radii == [0.0; 2] {
        report.error(place, "both radii of the cone are zero", "at least one radius above 0");
        return None;
    }
    Some(Quadric { ends: ends?, radii, profile: Profile::Straight, inward: inward? })
}

fn paraboloid(report: &mut Report, value: &Value) -> Option<Quadric> {
    const EXPECTED: &str =
        "paraboloid = { from = [x, y, z] (its vertex), to = [x, y, z] (the centre of its rim), radius = … }";
    let element = Element::single(report, value, "`paraboloid`", "`paraboloid`", EXPECTED)?;
    element.check_keys(report, &["from", "to", "radius", "inward"]);
    let (ends, inward) = (ends(report, &element), inward(report, &element));
    let radius = element.number(report, "radius", &LENGTH)?;
    Some(Quadric { ends: ends?, radii: [0.0, radius], profile: Profile::Parabolic, inward: inward? })
}

/// Returns the ends of the axis, which must differ.
fn ends(report: &mut Report, element: &Element) -> Option<[Vector; 2]> {
    let (from, to) = (element.point(report, "from"), element.point(report, "to"));
    let (from, to) = (from?, to?);
    if from == to {
        let place = element.optional("to").map_or(element.place.clone(), |value| value.span());
        report.error(place, "`from` and `to` are the same point", "the two ends of the axis");
        return None;
    }
    Some([from, to])
}

/// Returns two radii, and their place.
fn radii(report: &mut Report, element: &Element, expected: &str) -> Option<([f64; 2], Range<usize>)> {
    let value = element.required(report, "radii", expected)?;
    let numbers = array(report, value, "`radii`", 2, expected)?;
    let radii: Vec<Option<f64>> =
        numbers.iter().map(|value| number(report, value, "a radius", &RADIUS)).collect();
    Some(([radii[0]?, radii[1]?], value.span()))
}
