//! Scenes of View3D: both formats of geometry, surfaces on others, combined ones and obstructions.

use crate::{Placed, check_places, shown};
use forms_radiometry::geometry::Vector;
use forms_radiometry::scene::{MaterialKind, Scene, Shape, read};
use forms_radiometry::view_factors;

/// A box of 1 × 2 × 3 with a window in its first wall, whose floor is made of two parts.
const BOX: &str = "T A box / with a window\nC encl=1 eps=1.e-5 ! control\nF 3\n! a comment\n\
    V 1 0 0 0\nV 2 1 0 0\nV 3 1 2 0\nV 4 0 2 0\nV 5 0 0 3\nV 6 1 0 3\nV 7 1 2 3\nV 8 0 2 3\n\
    V 9 0.5 0 0\nV 10 0.5 2 0\nV 11 0.25 0 1\nV 12 0.75 0 1\nV 13 0.75 0 2\nV 14 0.25 0 2\n\
    S 1  1 9 10 4   0 0 0.9 floor\nS 2  5 8 7 6   0 0 0.8 ceiling\nS 3  1 5 6 2   0 0 0.5 front\n\
    S 4  4 3 7 8   0 0 0.5 back\nS 5  1 4 8 5   0 0 0.5 left\nS 6  2 6 7 3   0 0 0.5 right\n\
    S 7  11 14 13 12   3 0 1.0 window\nS 8  9 2 3 10   0 1 0.9 floor-b   ! combined\nEnd of data\nS 9 is not read\n";

/// The floor and a wall of the box by their planes.
const PLANES: &str = "F 3a\nS 1 R 0 0 0.9 floor\n 1 0 0 0 0 1 2\nS 2 Q 0 0 0.9 wall\n 1 0 0 0 90\n 0 0 1 0 1 3 0 3\n\
    S 3 T 0 0 0.9 roof\n 0 0 3 90 45\n 0 0 2 0 0 1.5\nO 4 R 0 0 3 180 180 0.5 0.25\nE\n";

fn scene(text: &str) -> Scene {
    read(text, "box.vs3").unwrap_or_else(|errors| panic!("{}", shown(&errors)))
}

fn area(shape: &Shape) -> f64 {
    match shape {
        Shape::Polygon(polygon) => polygon.area(),
        Shape::Mesh(mesh) => mesh.polygons().map(|polygon| polygon.area()).sum(),
        _ => panic!("a flat surface"),
    }
}

#[test]
fn surfaces_have_their_names_areas_and_emissivities() {
    let scene = scene(BOX);
    assert_eq!(scene.name, "A box / with a window");
    let found: Vec<(&str, f64)> = scene.surfaces.iter().map(|s| (&*s.name, area(&s.shape))).collect();
    let expected = [
        ("floor", 2.0),
        ("ceiling", 2.0),
        ("front", 2.5),
        ("back", 3.0),
        ("left", 6.0),
        ("right", 6.0),
        ("window", 0.5),
    ];
    assert_eq!(found, expected);
    let reflectance = |index: usize| match &scene.materials[scene.surfaces[index].material].kind {
        MaterialKind::Diffuse { reflectance } => reflectance[0],
        _ => panic!("a diffuse surface"),
    };
    assert_eq!([reflectance(0), reflectance(1), reflectance(6)], [1.0 - 0.9, 1.0 - 0.8, 0.0]);
}

#[test]
fn the_fronts_of_a_closed_box_see_each_other() {
    let factors = view_factors(&scene(BOX));
    for surface in 0..factors.names.len() {
        assert!(
            (factors.sum(surface) - 1.0).abs() < 1e-6,
            "{}: {}",
            factors.names[surface],
            factors.sum(surface)
        );
    }
    assert!(factors.reciprocity_residual() < 1e-9);
}

#[test]
fn planes_are_turned_by_azimuth_and_tilt() {
    let scene = scene(PLANES);
    let normal = |index: usize| scene.surfaces[index].shape.as_polygon().expect("a polygon").normal();
    let half = 0.5f64.sqrt();
    let expected = [
        ("floor", Vector::new(0.0, 0.0, 1.0)),
        ("wall", Vector::new(0.0, 1.0, 0.0)),
        ("roof", Vector::new(half, 0.0, half)),
        ("surface 4", Vector::new(0.0, 0.0, -1.0)),
    ];
    for (index, (name, expected)) in expected.into_iter().enumerate() {
        assert_eq!(scene.surfaces[index].name, name);
        assert!((normal(index) - expected).length() < 1e-15, "{name}: {:?}", normal(index));
    }
    let areas: Vec<f64> = scene.surfaces.iter().map(|surface| area(&surface.shape)).collect();
    assert_eq!(areas, [2.0, 3.0, 1.5, 0.125]);
    assert_eq!(
        scene.notes,
        ["obstructions and null surfaces are black surfaces here, with rows of their own"]
    );
}

/// Errors of the box.
const ERRORS: &[Placed] = &[
    ("F 3\n", "F 2\n", (3, 3), "the geometry format `2` is not supported"),
    ("F 3\n", "", (18, 1), "a surface before the format"),
    ("V 2 1 0 0", "V 2 1 0 zero", (6, 9), "`zero` is not a number"),
    ("V 2 1 0 0", "V 2 1 0", (6, 1), "the line ends before a coordinate"),
    ("V 2 1 0 0", "V -2 1 0 0", (6, 3), "the number is out of range"),
    ("S 2  5 8 7 6", "S 2  5 8 7 99", (20, 12), "there is no vertex 99"),
    (
        "S 2  5 8 7 6",
        "S 2  5 8 7 1",
        (20, 1),
        "the polygon is not planar: vertex 4 is 4.286e-1 away from its plane (tolerance: 3.0e-6)",
    ),
    ("S 2  5", "S 1  5", (20, 1), "surface 1 is already defined in line 19"),
    (
        "S 2  5",
        "M 2  5",
        (20, 1),
        "masking surfaces are not supported: they face their base without a distance",
    ),
    ("S 2  5", "Q 2  5", (20, 1), "`Q` is no element of a View3D file"),
    ("0 0 0.8", "0 0 1.8", (20, 20), "the emissivity is out of range"),
    ("3 0 1.0 window", "33 0 1.0 window", (25, 1), "there is no surface 33 for surface 7 to lie on"),
    (
        "0 1 0.9 floor-b",
        "0 8 0.9 floor-b",
        (26, 1),
        "surface 8 is combined with surface 8, which is not a first one",
    ),
    (
        "0 1 0.9 floor-b",
        "0 1 0.8 floor-b",
        (26, 1),
        "surface 8 has another emissivity than surface 1, with which it is combined",
    ),
];

#[test]
fn each_error_is_reported_at_its_place() {
    check_places(BOX, ERRORS, |text| read(text, "box.vs3").map(|_| ()).expect_err("an error"));
}
