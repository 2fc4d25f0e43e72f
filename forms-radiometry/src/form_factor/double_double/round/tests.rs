//! A sphere looks like the disk bounded by its tangent circle, a disk looks like a polygon of many
//! edges, and cases without a closed form return none.

use super::*;
use crate::form_factor::double_double::form_factor;

const HERE: Vector = Vector::new(0.3, -0.2, 0.7);
/// Tessellation level of a polygon with 6144 edges: its form factor has an error of about 10⁻¹⁵.
const FINE: usize = 8;
const AXIS: Vector = Vector::new(0.0, 0.0, 1.0);

fn directions() -> [Vector; 5] {
    [[0.0, 0.0, 1.0], [0.48, -0.6, 0.64], [-0.8, 0.0, 0.6], [0.36, 0.48, 0.8], [-0.6, 0.64, -0.48]]
        .map(|[x, y, z]| Vector::new(x, y, z))
}

fn assert_close(what: &str, found: Rounded, expected: f64) {
    let [value, error] = found.nearest();
    let allowed = 1e-13 * expected.abs();
    assert!((value - expected).abs() <= allowed + 1e-15, "{what}: {value} and {expected}");
    assert!(error <= allowed + 1e-14, "{what}: {value} ± {error}");
}

/// Disks around the point, given by the point's height over them and its distance from their axes.
fn disks() -> impl Iterator<Item = Disk> {
    let places = [(1.0, 0.0), (0.3, 0.4), (0.3, 1.3), (2.0, 5.0), (1.0, 1.0), (1e3, 10.0)];
    directions().into_iter().flat_map(move |normal| {
        let [u, v] = across(normal);
        places.map(|(height, away)| {
            let center = HERE + (0.6 * away) * u - (0.8 * away) * v - height * normal;
            Disk { center, normal, radius: 1.0, hole: 0.0 }
        })
    })
}

#[test]
fn a_disk_is_seen_as_a_polygon_of_many_edges_unless_the_horizon_cuts_it() {
    let mut cut = 0;
    for disk in disks() {
        let behind = Disk { normal: -disk.normal, ..disk };
        assert!(disk.shows_front(HERE) && !behind.shows_front(HERE));
        for direction in directions() {
            for has_horizon in [false, true] {
                let what = format!("{disk:?} along {direction:?}, {has_horizon}");
                let [expected, _] = form_factor(HERE, &disk.polygon(FINE), direction, has_horizon).nearest();
                let Some(found) = disk.form_factor(HERE, direction, has_horizon) else {
                    assert!(has_horizon, "{what}");
                    cut += 1;
                    continue;
                };
                assert_close(&what, found, expected);
                let from_behind = behind.form_factor(HERE, direction, has_horizon).expect("as before");
                assert_close(&what, from_behind, expected);
            }
        }
    }
    assert!(cut > 0 && cut < 150, "the horizon cuts {cut} of 150");
}

#[test]
fn a_sphere_is_seen_as_the_disk_whose_rim_its_tangents_touch() {
    for towards in directions() {
        for (distance, radius) in [(1.1, 1.0), (2.0, 1.0), (3.0, 0.1), (1e4, 1.0)] {
            let sphere = Sphere { center: HERE + distance * towards, radius, inward: false };
            assert!(sphere.shows_front(HERE) && !Sphere { inward: true, ..sphere }.shows_front(HERE));
            let squared = (distance - radius) * (distance + radius);
            let center = HERE + (squared / distance) * towards;
            let disk =
                Disk { center, normal: -towards, radius: radius * squared.sqrt() / distance, hole: 0.0 };
            for direction in directions() {
                for has_horizon in [false, true] {
                    let [expected, _] =
                        form_factor(HERE, &disk.polygon(FINE), direction, has_horizon).nearest();
                    let found = sphere.form_factor(HERE, direction, has_horizon).expect("from outside");
                    assert_close(&format!("{sphere:?} along {direction:?}, {has_horizon}"), found, expected);
                }
            }
        }
    }
    let sphere = Sphere { center: HERE + 2.0 * AXIS, radius: 1.0, inward: false };
    let disk = Disk { center: HERE + 1.5 * AXIS, normal: -AXIS, radius: 0.75_f64.sqrt(), hole: 0.0 };
    let on_axis = |shape: &dyn SeenWhole| shape.solid_angle_over_pi(HERE).expect("on the axis");
    assert_close("solid angle", on_axis(&sphere), on_axis(&disk).nearest()[0]);
}

#[test]
fn from_inside_a_sphere_is_all_directions() {
    let sphere = Sphere { center: HERE + 0.5 * AXIS, radius: 1.0, inward: true };
    assert!(sphere.shows_front(HERE) && sphere.outline(HERE).is_none());
    let value = |found: Option<Rounded>| found.expect("inside").nearest()[0];
    assert_eq!(value(sphere.form_factor(HERE, AXIS, true)), 1.0);
    assert_eq!(value(sphere.form_factor(HERE, AXIS, false)), 0.0);
    assert_eq!(value(sphere.solid_angle_over_pi(HERE)), 4.0);
}

#[test]
fn where_rounding_decides_the_side_there_is_no_measure() {
    let sphere = Sphere { center: Vector::default(), radius: 1.0, inward: false };
    assert!(sphere.form_factor(AXIS, AXIS, true).is_none() && sphere.solid_angle_over_pi(AXIS).is_none());
    let disk = Disk { center: Vector::default(), normal: AXIS, radius: 1.0, hole: 0.0 };
    let in_its_plane = disk.form_factor(Vector::new(2.0, 0.0, 0.0), AXIS, true).expect("exactly");
    assert_eq!(in_its_plane.nearest(), [0.0; 2]);
    assert!(disk.solid_angle_over_pi(Vector::new(0.1, 0.0, 1.0)).is_none(), "beside the axis");
    let tilted = Disk { normal: Vector::new(0.6, 0.0, 0.8), ..disk };
    assert!(tilted.form_factor(Vector::new(0.8, 0.0, -0.6), AXIS, false).is_none(), "up to rounding");
}

#[test]
fn outlines_hold_what_is_seen_and_look_to_the_point() {
    let ratio = |shape: &dyn SeenWhole| {
        let (corners, normal) = shape.outline(HERE).expect("beside it");
        let [whole, _] = form_factor(HERE, &corners, -normal, false).nearest();
        let [part, _] = shape.form_factor(HERE, -normal, false).expect("a closed form").nearest();
        whole / part
    };
    for disk in disks() {
        assert!((1.0..4.0).contains(&ratio(&disk)), "{disk:?}: {}", ratio(&disk));
    }
    for distance in [1.01, 2.0, 1e5] {
        let sphere = Sphere { center: HERE + distance * AXIS, radius: 1.0, inward: false };
        assert!((1.0..1.3).contains(&ratio(&sphere)), "{distance}: {}", ratio(&sphere));
    }
}
