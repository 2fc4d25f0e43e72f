//! Points: the `position`, `points`, `line` or `plane` of a receiver becomes the points at which it
//! measures light, with their normals.
//!
//! ```text
//! line    from + (to − from) i/(n − 1)                    i = 0 … n − 1: both ends are points
//! plane   origin + u (i + ½)/n + v (j + ½)/m              the centres of n × m cells
//! ```

use super::point_file::{self, PointFile};
use crate::geometry::Vector;
use crate::scene::element::Element;
use crate::scene::error::Report;
use crate::scene::mesh_file::MeshFiles;
use crate::scene::model::{Points, ReceiverKind};
use crate::scene::value::{Domain, Value, one_of, pixels, text};

/// Keys of which a receiver has one.
const KEYS: [&str; 4] = ["position", "points", "line", "plane"];
const COUNT: Domain = Domain {
    expected: "an integer from 2 to 1000000",
    contains: |x| x.fract() == 0.0 && (2.0..=1e6).contains(&x),
};

/// Where a receiver measures light.
enum Places {
    One(Vector),
    File(PointFile),
    Line(Vec<Vector>),
    Plane { positions: Vec<Vector>, grid: [usize; 2], normal: Vector },
}

/// Reads a receiver of irradiance at points.
pub(super) fn irradiance(report: &mut Report, element: &Element, files: &MeshFiles) -> Option<ReceiverKind> {
    let places = places(report, element, files, true);
    let normal = normal(report, element, places.as_ref());
    let (places, normal) = (places?, normal?);
    Some(match (places, normal) {
        (Places::One(position), normal) => ReceiverKind::Point { position, normal: normal? },
        (Places::File(PointFile { positions, normals: Some(normals) }), _) => {
            ReceiverKind::Points(Points { positions, normals: Some(normals), grid: None })
        }
        (Places::Line(positions) | Places::File(PointFile { positions, normals: None }), normal) => {
            ReceiverKind::Points(with_normal(positions, normal?, None))
        }
        (Places::Plane { positions, grid, normal: own }, normal) => {
            ReceiverKind::Points(with_normal(positions, normal.unwrap_or(own), Some(grid)))
        }
    })
}

/// Reads the normal of all points, which is required where the points have none of their own.
fn normal(report: &mut Report, element: &Element, places: Option<&Places>) -> Option<Option<Vector>> {
    let value = element.optional("normal");
    let has_own = match places {
        Some(Places::File(PointFile { normals, .. })) => normals.is_some(),
        Some(Places::Plane { .. }) => true,
        Some(Places::One(_) | Places::Line(_)) => false,
        // the columns of an invalid file are not known
        None => element.optional("position").is_none(),
    };
    match (value, places) {
        (Some(value), Some(Places::File(_))) if has_own => {
            let message = "the receiver has a `normal`, and its points have normals in their file";
            report.error(value.span(), message, "one of them");
            None
        }
        (None, _) if has_own => Some(None),
        _ => element.direction(report, "normal").map(Some),
    }
}

/// Reads a receiver of light from all sides at points.
pub(super) fn all_around(report: &mut Report, element: &Element, files: &MeshFiles) -> Option<ReceiverKind> {
    let (positions, grid) = match places(report, element, files, false)? {
        Places::One(position) => return Some(ReceiverKind::Sphere { position }),
        Places::Line(positions) | Places::File(PointFile { positions, .. }) => (positions, None),
        Places::Plane { positions, grid, .. } => (positions, Some(grid)),
    };
    Some(ReceiverKind::Points(Points { positions, normals: None, grid }))
}

fn with_normal(positions: Vec<Vector>, normal: Vector, grid: Option<[usize; 2]>) -> Points {
    Points { normals: Some(vec![normal; positions.len()]), positions, grid }
}

fn places(report: &mut Report, element: &Element, files: &MeshFiles, may_face: bool) -> Option<Places> {
    let given: Vec<&str> = KEYS.into_iter().filter(|key| element.optional(key).is_some()).collect();
    let [key] = given[..] else {
        let Some(&second) = given.get(1) else {
            let expected = "position = [x, y, z], or `points`, `line` or `plane`";
            report.error(element.place.clone(), "this receiver has no `position`", expected);
            return None;
        };
        let place = element.optional(second).map_or(element.place.clone(), |value| value.span());
        let found = one_of(given.into_iter()).replace(" or ", " and ");
        report.error(place, format!("the receiver has {found}"), "one of them");
        return None;
    };
    let value = element.optional(key)?;
    match key {
        "position" => element.point(report, key).map(Places::One),
        "points" => {
            let name = text(report, value, "`points`")?;
            point_file::read(report, files, (value.span(), name), may_face).map(Places::File)
        }
        "line" => line(report, value),
        _ => plane(report, value),
    }
}

fn line(report: &mut Report, value: &Value) -> Option<Places> {
    const EXPECTED: &str = "line = { from = [x, y, z], to = [x, y, z], count = 10 }";
    let line = Element::single(report, value, "`line`", "`line`", EXPECTED)?;
    line.check_keys(report, &["from", "to", "count"]);
    let [from, to] = ["from", "to"].map(|key| line.point(report, key));
    let count = line.number(report, "count", &COUNT);
    let (from, to, count) = (from?, to?, count? as usize);
    let at = |index: usize| {
        let part = index as f64 / (count - 1) as f64;
        (1.0 - part) * from + part * to
    };
    Some(Places::Line((0..count).map(at).collect()))
}

fn plane(report: &mut Report, value: &Value) -> Option<Places> {
    const EXPECTED: &str = "plane = { origin = [x, y, z], u = [x, y, z], v = [x, y, z], count = [10, 10] }";
    let plane = Element::single(report, value, "`plane`", "`plane`", EXPECTED)?;
    plane.check_keys(report, &["origin", "u", "v", "count"]);
    let [origin, u, v] = ["origin", "u", "v"].map(|key| plane.point(report, key));
    let counts = "count = [along u, along v]";
    let count = plane.required(report, "count", counts);
    let count = count.and_then(|value| pixels(report, value, "`count`", counts));
    let (origin, u, v, grid) = (origin?, u?, v?, count?);
    let normal = u.unit().zip(v.unit()).and_then(|(along, across)| along.cross(across).unit());
    let Some(normal) = normal else {
        report.error(value.span(), "the edges `u` and `v` span no plane", "edges that are not parallel");
        return None;
    };
    let [columns, rows] = grid;
    let at = |cell: usize| {
        let part = |index: usize, count: usize| (index as f64 + 0.5) / count as f64;
        origin + part(cell % columns, columns) * u + part(cell / columns, rows) * v
    };
    Some(Places::Plane { positions: (0..columns * rows).map(at).collect(), grid, normal })
}
