//! Properties of the parts of the solver.

use super::contact::ConvexPiece;
use super::element::Element;
use super::measure::Measure;
use super::operator::{Operator, Row};
use super::reference::MOST_NODES;
use super::solution::{Reflection, orders};
use super::weights;
use super::whole_elements::Whole;
use crate::geometry::{Outline, Vector};
use crate::visibility::Face;
use crate::watch::Unwatched;
use forms_kernels::irradiance_linear_luminaire;

/// Returns the face of a triangle above the origin that faces down.
fn triangle([a, b, c]: [Vector; 3]) -> Face {
    let twice = (b - a).cross(c - a);
    let normal = twice.unit().expect("a triangle");
    Face {
        surface: 0,
        part: 0,
        is_back: false,
        vertices: [a, b, c].into(),
        normal,
        area: 0.5 * twice.length(),
    }
}

#[test]
fn a_linear_element_gives_what_the_linear_luminaire_gives() {
    let up = Vector::new(0.0, 0.0, 1.0);
    let corners =
        |z: f64| [Vector::new(-0.5, -0.3, z), Vector::new(0.1, 0.8, z), Vector::new(0.9, -0.2, 1.5 * z)];
    for height in [3.0, 1.0, 0.2, 0.02] {
        let vertices = corners(height);
        let face = triangle(vertices);
        let [a, b, c] = vertices;
        let elements = Element::of(0, &face, &ConvexPiece::whole(&face));
        let [element] = &elements[..] else { panic!("a triangle is one element") };
        let mut found = [0.0; MOST_NODES];
        weights::add(&vertices, element, Vector::default(), Measure::Plane(up), 1e-9, &mut found);
        // the radiance 2 + x − 3y is linear; over π it is an exitance
        let radiance = |v: Vector| 2.0 + v.x - 3.0 * v.y;
        let sum: f64 = element.nodes().zip(found).map(|(node, weight)| radiance(node) * weight).sum();
        let expected = irradiance_linear_luminaire(
            a.x,
            a.y,
            a.z,
            b.x,
            b.y,
            b.z,
            c.x,
            c.y,
            c.z,
            radiance(a),
            radiance(b),
            radiance(c),
        ) / std::f64::consts::PI;
        assert!((sum - expected).abs() < 1e-8, "{height}: {sum} and {expected}");
    }
}

#[test]
fn the_weights_of_an_element_sum_to_its_measure() {
    let face =
        triangle([Vector::new(-1.0, -1.0, 0.1), Vector::new(0.0, 2.0, 0.1), Vector::new(1.0, -1.0, 0.1)]);
    let elements = Element::of(0, &face, &ConvexPiece::whole(&face));
    for measure in [
        Measure::Plane(Vector::new(0.0, 0.0, 1.0)),
        Measure::Sphere,
        Measure::Flow(Vector::new(1.0, 0.0, 0.0)),
        Measure::Flow(Vector::new(0.0, 0.0, 1.0)),
    ] {
        let mut found = [0.0; MOST_NODES];
        weights::add(&face.vertices, &elements[0], Vector::default(), measure, 1e-2, &mut found);
        let (sum, expected) = (found.iter().sum::<f64>(), measure.of(&face.vertices));
        assert!((sum - expected).abs() < 1e-13, "{measure:?}: {sum} and {expected}");
    }
}

#[test]
fn points_that_share_a_rule_get_what_each_gets_by_its_own() {
    let face =
        triangle([Vector::new(-1.0, -1.0, 0.3), Vector::new(0.0, 2.0, 0.1), Vector::new(1.0, -1.0, 0.3)]);
    let up = Vector::new(0.0, 0.0, 1.0);
    for shift in [Vector::default(), Vector::new(1e6, -1e6, 1e6)] {
        let vertices: Outline = face.vertices.iter().map(|&v| v + shift).collect();
        let face = Face { vertices: vertices.clone(), ..face.clone() };
        let elements = Element::of(0, &face, &ConvexPiece::whole(&face));
        let element = &elements[0];
        let points: Vec<Vector> = (0..25)
            .map(|i| shift + Vector::new(0.4 * f64::from(i % 5) - 0.8, 0.4 * f64::from(i / 5) - 0.8, -0.1))
            .collect();
        let mut count = 0;
        Whole::default().weigh(points.iter().copied(), up, (element, &vertices), 1e-9, |index, weights| {
            let piece: Vec<Vector> = vertices.iter().map(|&v| v - points[index]).collect();
            let mut own = [0.0; MOST_NODES];
            weights::add(&piece, element, points[index], Measure::Plane(up), 1e-9, &mut own);
            for (shared, own) in weights.iter().zip(own) {
                assert!((shared - own).abs() < 1e-8, "{shift:?} {index}: {shared} and {own}");
            }
            let (sum, expected) = (weights.iter().sum::<f64>(), Measure::Plane(up).of(&piece));
            assert!((sum - expected).abs() < 1e-13, "{shift:?} {index}: {sum} and {expected}");
            count += 1;
        });
        assert_eq!(count, points.len());
    }
}

#[test]
fn parts_cover_an_element_and_keep_its_polynomials() {
    let triangle =
        triangle([Vector::new(0.0, 0.0, 1.0), Vector::new(0.3, 2.0, 1.0), Vector::new(1.0, 0.2, 1.0)]);
    let square = Face {
        vertices: vec![
            Vector::new(0.0, 0.0, 1.0),
            Vector::new(0.0, 1.5, 1.0),
            Vector::new(1.0, 2.0, 1.0),
            Vector::new(1.0, 0.5, 1.0),
        ]
        .into(),
        area: 1.5,
        ..triangle.clone()
    };
    for face in [triangle, square] {
        for element in Element::of(0, &face, &ConvexPiece::whole(&face)) {
            // the integral of x² is the same over the parts
            let moment = |element: &Element| -> f64 {
                element.nodes().zip(element.areas()).map(|(node, area)| area * node.x * node.x).sum()
            };
            for is_divided in [[true, false], [false, true], [true, true]] {
                let parts = element.divided(is_divided);
                assert_eq!(parts.len(), element.part_count(is_divided));
                let area: f64 = parts.iter().map(|part| part.area).sum();
                assert!((area - element.area).abs() < 1e-15);
                let of_parts: f64 = parts.iter().map(moment).sum();
                assert!((of_parts - moment(&element)).abs() < 1e-14, "{of_parts}");
            }
        }
    }
}

#[test]
fn parts_shrink_towards_the_sides_that_other_faces_rise_from() {
    let corner = |x, y| Vector::new(x, y, 0.0);
    let outline = vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
    let face = Face {
        vertices: outline.as_slice().into(),
        area: 1.0,
        ..triangle([outline[0], outline[1], outline[2]])
    };
    // the sides are y = 0, x = 1, y = 1, x = 0
    for (creases, expected) in [
        ([false, false, false, false], &[0.5, 0.5][..]),
        ([false, false, false, true], &[0.2, 0.8]),
        ([false, true, false, false], &[0.8, 0.2]),
        ([false, true, false, true], &[0.15, 0.7, 0.15]),
        ([true, false, true, false], &[0.5, 0.5]),
    ] {
        let piece = ConvexPiece { outline: outline.clone(), creases: creases.to_vec() };
        let element = Element::of(0, &face, &piece).swap_remove(0);
        let widths = |element: &Element| -> Vec<f64> {
            element.divided([true, false]).iter().map(|part| part.extent()[0]).collect()
        };
        let found = widths(&element);
        let is_close = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-15;
        assert!(found.len() == expected.len() && found.iter().zip(expected).all(is_close), "{found:?}");
        // the first part has the crease of its first side alone
        let first = &element.divided([true, false])[0];
        let ratio = widths(first)[0] / first.extent()[0];
        assert!((ratio - if creases[3] { 0.2 } else { 0.5 }).abs() < 1e-15, "{ratio}");
    }
}

/// An operator without structure, whose rows sum to less than one.
fn operator(size: usize) -> Operator {
    let weight = |i: usize, j: usize| ((i * 7 + j * 13) % 17) as f64 / (17.0 * size as f64) * 1.9;
    let row = |i: usize| Row {
        elements: (0..size as u32).collect(),
        weights: (0..size).map(|j| weight(i, j)).collect(),
    };
    Operator::new((0..size).map(row).collect(), (0..=size).collect())
}

/// Bands of different reflectances and light, the last of them dark.
fn bands(count: usize, size: usize) -> [Vec<Vec<f64>>; 2] {
    let all = |of: fn(usize, usize) -> f64| -> Vec<Vec<f64>> {
        (0..count).map(|band| (0..size).map(|i| of(band, i)).collect()).collect()
    };
    let mut direct = all(|band, i| ((i + band) % 5) as f64);
    direct[count - 1].fill(0.0);
    [all(|band, i| 0.5 + 0.001 * band as f64 + 0.01 * i as f64), direct]
}

#[test]
fn all_orders_at_once_are_the_limit_of_the_series() {
    for count in [1, 2, 8, 19] {
        let [reflectances, direct] = bands(count, 40);
        let reflection = Reflection::new(operator(40), reflectances);
        let (at_once, residuals) = reflection.all_orders(&direct, 1e-14, &Unwatched);
        let [series, _] = reflection.neumann(&direct, 500, &Unwatched);
        for band in 0..count {
            assert!(residuals[band] < 1e-12, "{:e}", residuals[band]);
            for (a, b) in at_once[band].iter().zip(&series[band]) {
                assert!((a - b).abs() < 1e-11, "{a} and {b}");
            }
        }
        let (_, residuals) = reflection.all_orders(&direct, 1e-3, &Unwatched);
        assert!(residuals.iter().all(|&residual| residual <= 4e-3));
    }
}

#[test]
fn bands_are_summed_together_as_one_by_one() {
    let operator = operator(30);
    for count in [1, 2, 5, 8, 9, 21] {
        let [reflectances, irradiance] = bands(count, 30);
        let pairs: Vec<[&[f64]; 2]> =
            reflectances.iter().zip(&irradiance).map(|(r, e)| [&r[..], e]).collect();
        let together = operator.apply(&pairs);
        for (pair, together) in pairs.iter().zip(&together) {
            let exitance: Vec<f64> = pair[0].iter().zip(pair[1]).map(|(r, e)| r * e).collect();
            assert_eq!(operator.apply(&[*pair])[0], *together);
            // each element has one node: G E of one band by its definition
            let sums = operator.sums(1, |element, weights, sums| sums[0] += weights[0] * exitance[element]);
            assert_eq!(sums[0], *together);
        }
    }
}

#[test]
fn the_transposed_operator_has_the_same_products() {
    let operator = operator(30);
    let [reflectances, vectors] = bands(3, 30);
    let [x, z] = [&vectors[0], &vectors[1]];
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let of_x = operator.apply(&[[&reflectances[0], x]]).swap_remove(0);
    let [one, other] = [dot(&of_x, z), dot(x, &operator.apply_transposed(&reflectances[0], z))];
    assert!((one - other).abs() <= 1e-12 * one.abs(), "{one} and {other}");
}

#[test]
fn light_that_grows_at_first_and_dies_out_is_bounded_by_its_sum() {
    // from the second element to the first, and back: (1 − G)⁻¹ 1 = (1 + a, 1 + b)/(1 − ab)
    for ([a, b], growth) in [
        ([3.0, 0.1], 4.0 / 0.7),
        ([9.0, 0.01], 10.0 / 0.91),
        ([3.0, 1.0], f64::INFINITY),
        ([1.0, 1.0], f64::INFINITY),
    ] {
        let rows =
            [(1, a), (0, b)].map(|(other, weight)| Row { elements: vec![other], weights: vec![weight] });
        let operator = Operator::new(rows.into(), (0..=2).collect());
        let reflection = Reflection::new(operator, vec![vec![1.0; 2]]);
        let found = reflection.growths(&Unwatched)[0];
        let is_bound = found >= growth * (1.0 - 1e-12) && found <= 1.01 * growth;
        assert!(is_bound || found == growth, "{a}, {b}: {found}, {growth}");
    }
}

#[test]
fn an_order_is_the_light_of_one_more_reflection() {
    let reflection = Reflection::new(operator(10), vec![vec![0.5; 10]]);
    let direct = vec![vec![1.0; 10]];
    let [two, one] = reflection.neumann(&direct, 2, &Unwatched);
    let reflected = reflection.operator.apply(&[[&[0.5; 10], &one[0]]]);
    for i in 0..10 {
        assert!((two[0][i] - (direct[0][i] + reflected[0][i])).abs() < 1e-15);
    }
}

#[test]
fn the_orders_to_a_tolerance_are_the_least_that_reach_it() {
    for (contraction, tolerance, expected) in [
        (0.8, 1e-6, Some(62)),
        (0.8, 1e-3, Some(31)),
        (0.5, 1e-3, Some(10)),
        (0.5, 0.125, Some(3)),
        (0.0, 1e-3, Some(0)),
        (1.0, 1e-3, None),
    ] {
        assert_eq!(orders(contraction, tolerance), expected, "{contraction} {tolerance}");
    }
}
