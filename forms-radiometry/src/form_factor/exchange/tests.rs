//! Known view factors, laws, and comparisons between the methods.

use super::*;
use crate::geometry::{Disk, regular};
use forms_kernels::{view_factor_parallel_rectangles, view_factor_perpendicular_rectangles};
use forms_testing::SplitMix;
use std::f64::consts::PI;

fn polygon(points: &[[f64; 3]]) -> Polygon {
    Polygon::new(points.iter().map(|&[x, y, z]| Vector::new(x, y, z)).collect()).expect("a polygon")
}

/// The rectangle a × b in the plane z = 0 that faces up.
fn floor(a: f64, b: f64) -> Polygon {
    polygon(&[[0.0, 0.0, 0.0], [a, 0.0, 0.0], [a, b, 0.0], [0.0, b, 0.0]])
}

/// The same rectangle at this height, facing down.
fn ceiling(a: f64, b: f64, height: f64) -> Polygon {
    polygon(&[[0.0, 0.0, height], [0.0, b, height], [a, b, height], [a, 0.0, height]])
}

/// The wall of width b and height c in the plane x = 0 that faces positive x.
fn wall(b: f64, c: f64) -> Polygon {
    polygon(&[[0.0, 0.0, 0.0], [0.0, b, 0.0], [0.0, b, c], [0.0, 0.0, c]])
}

fn assert_is(found: Exchange, expected: f64, tolerance: f64, name: &str) {
    let error = (found.area - expected).abs();
    assert!(
        error <= tolerance * expected,
        "{name}: {} and {expected}, off by {:e}",
        found.area,
        error / expected
    );
    assert!(error <= found.error, "{name}: off by {error:e}, said {:e}", found.error);
    assert!(found.error <= 1e3 * tolerance * expected, "{name}: said {:e}", found.error);
}

#[test]
fn opposed_rectangles_are_as_in_the_catalogue_near_and_far() {
    for [a, b, c] in [
        [1.0, 1.0, 1.0],
        [1.0, 2.0, 0.5],
        [0.1, 3.0, 1.0],
        [1.0, 1.0, 1e-6],
        [1.0, 1.0, 30.0],
        [1.0, 1.0, 1e4],
        [1.0, 2.0, 1e8],
        [1e-7, 1e-7, 1e-7],
        [1e60, 1e60, 2e60],
    ] {
        let found = view_factor(&floor(a, b), &ceiling(a, b, c), 1e-13);
        assert_is(found, view_factor_parallel_rectangles(a, b, c), 4e-13, &format!("{a} x {b} at {c}"));
    }
}

#[test]
fn rectangles_with_a_common_edge_are_as_in_the_catalogue() {
    for [h, w, l] in [[1.0, 1.0, 1.0], [0.1, 2.0, 1.0], [1e3, 1.0, 1.0], [1e-4, 1.0, 1.0], [1e-3, 1e-3, 1.0]]
    {
        let found = view_factor(&floor(w, l), &wall(l, h), 1e-13);
        assert_is(found, view_factor_perpendicular_rectangles(h, w, l), 4e-13, &format!("{h}, {w}, {l}"));
    }
}

#[test]
fn far_away_only_areas_angles_and_distance_count() {
    for distance in [1e4, 1e6, 1e9] {
        let lamp = polygon(&[
            [distance, 0.0, distance],
            [distance, 1.0, distance],
            [distance + 1.0, 1.0, distance],
            [distance + 1.0, 0.0, distance],
        ]);
        // cos² 45° / (π r²) with r² = 2 d²
        let expected = 0.5 / (PI * 2.0 * distance * distance);
        let found = view_factor(&floor(1.0, 1.0), &lamp, 1e-12);
        assert!((found.area / expected - 1.0).abs() < 4.0 / distance, "{distance}");
        assert!(found.error < 1e-12 * found.area, "{distance}");
    }
}

#[test]
fn the_inside_of_a_box_sends_everything_to_its_walls() {
    let corners = |x: f64, y: f64, z: f64| [0.7 * x, 1.3 * y, 0.2 * z];
    let face = |points: [[f64; 3]; 4]| polygon(&points.map(|[x, y, z]| corners(x, y, z)));
    let faces = [
        face([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]),
        face([[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]]),
        face([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]]),
        face([[1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.0, 0.0]]),
        face([[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, 0.0]]),
        face([[0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0]]),
    ];
    for (place, from) in faces.iter().enumerate() {
        let to_others = faces.iter().enumerate().filter(|(other, _)| *other != place);
        let sum: f64 = to_others.map(|(_, to)| view_factor(from, to, 1e-12).area).sum();
        assert!((sum - 1.0).abs() < 2e-12, "face {place}: {:e}", sum - 1.0);
    }
}

/// Quadrilaterals in general position, the second moved away from the first by `distance` times its
/// size.
fn in_general_position(seed: u32, distance: f64) -> [Polygon; 2] {
    let mut state = u64::from(seed).wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut number = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut square = |away: f64| {
        let mut vector = || Vector::new(number(), number(), number());
        let (u, w) = (vector(), vector());
        let v = u.cross(w).unit().expect("vectors in general position");
        let v = u.length() * v;
        let o = vector() + Vector::new(0.0, 0.0, away);
        let corners = [o, o + u, o + u + v, o + v];
        Polygon::new(corners.to_vec()).expect("a square")
    };
    let (a, b) = (square(0.0), square(distance));
    let turned = |square: Polygon, to: Vector| {
        if square.normal().dot(to - square.vertices()[0]) >= 0.0 {
            return square;
        }
        Polygon::new(square.vertices().iter().rev().copied().collect()).expect("a square")
    };
    let (of_a, of_b) = (a.vertices()[0], b.vertices()[0]);
    [turned(a, of_b), turned(b, of_a)]
}

#[test]
fn areas_and_contours_agree_as_far_as_they_say() {
    let (mut compared, mut apart) = (0, 0);
    for seed in 1..200 {
        for distance in [1.2, 2.0, 5.0, 20.0] {
            let [a, b] = in_general_position(seed, distance);
            let in_front = |a: &Polygon, b: &Polygon| {
                b.vertices().iter().all(|&v| a.normal().dot(v - a.vertices()[0]) > 0.0)
            };
            if !in_front(&a, &b) || !in_front(&b, &a) {
                continue;
            }
            compared += 1;
            let normals = [a.normal(), b.normal()];
            let by_areas = areas::exchange(a.vertices(), b.vertices(), normals, 1e-12);
            let by_contour = contour::exchange::<f64>(a.vertices(), b.vertices(), 1e-12);
            let precisely = contour::exchange::<DoubleDouble>(a.vertices(), b.vertices(), 1e-14);
            let by_apart = apart::exchange(a.vertices(), b.vertices(), normals, 1e-12);
            apart += usize::from(by_apart.is_some());
            let ways = [("areas", Some(by_areas)), ("contour", Some(by_contour)), ("edges apart", by_apart)];
            for (way, found) in ways.into_iter().filter_map(|(way, found)| Some((way, found?))) {
                let error = (found.area - precisely.area).abs();
                assert!(
                    error <= found.error + precisely.error,
                    "{seed} at {distance}, {way}: off by {error:e}, said {:e}",
                    found.error
                );
            }
        }
    }
    assert!(compared > 100 && apart > 100, "{compared}, {apart}");
}

#[test]
fn exchange_is_the_same_both_ways_and_wherever_the_pair_is() {
    for seed in 1..40 {
        let [a, b] = in_general_position(seed, 1.5);
        let there = exchange(&a, &b, 1e-12);
        let back = exchange(&b, &a, 1e-12);
        let scale = there.area.abs().max(1e-300);
        assert!((there.area - back.area).abs() <= there.error + back.error, "{seed}: {there:?} and {back:?}");
        let moved = |polygon: &Polygon| {
            let shift = Vector::new(1024.0, -2048.0, 4096.0);
            Polygon::new(polygon.vertices().iter().map(|&v| v + shift).collect()).expect("a square")
        };
        // moving the vertices rounds them
        let far = exchange(&moved(&a), &moved(&b), 1e-12);
        assert!((far.area - there.area).abs() <= 1e-10 * scale, "{seed}: {} and {}", far.area, there.area);
    }
}

#[test]
fn behind_and_in_one_plane_there_is_no_exchange() {
    let above = ceiling(1.0, 1.0, 1.0);
    let turned = Polygon::new(above.vertices().iter().rev().copied().collect()).expect("a square");
    assert_eq!(exchange(&floor(1.0, 1.0), &turned, 1e-12), Exchange::default());
    let beside = polygon(&[[2.0, 0.0, 0.0], [3.0, 0.0, 0.0], [3.0, 1.0, 0.0], [2.0, 1.0, 0.0]]);
    assert_eq!(exchange(&floor(1.0, 1.0), &beside, 1e-12), Exchange::default());
}

#[test]
fn a_polygon_across_the_plane_of_the_other_counts_as_far_as_it_is_in_front() {
    let whole = polygon(&[[2.0, 0.0, -1.0], [2.0, 0.0, 1.0], [2.0, 1.0, 1.0], [2.0, 1.0, -1.0]]);
    let upper = polygon(&[[2.0, 0.0, 0.0], [2.0, 0.0, 1.0], [2.0, 1.0, 1.0], [2.0, 1.0, 0.0]]);
    let from = floor(1.0, 1.0);
    let [whole, upper] = [whole, upper].map(|to| exchange(&from, &to, 1e-13).area);
    assert!((whole - upper).abs() <= 1e-12 * upper && upper > 0.01, "{whole} and {upper}");
}

#[test]
fn a_square_between_two_squares_hides_what_its_shadow_covers() {
    // F₁₂ = ∫ (F − F of the shadow): from (x, y, 0) the square [0, ½]² at half the height hides [0,
    // 1 − x] × [0, 1 − y]
    let screen = polygon(&[[0.0, 0.0, 0.5], [0.5, 0.0, 0.5], [0.5, 0.5, 0.5], [0.0, 0.5, 0.5]]);
    let found = visible_exchange(&floor(1.0, 1.0), &ceiling(1.0, 1.0, 1.0), [&screen].into_iter(), 1e-6);
    let expected = 0.149_868_671_773_790_54;
    let error = (found.area - expected).abs();
    assert!(
        error <= found.error && found.error <= 2e-6 * expected,
        "off by {error:e}, said {:e}",
        found.error
    );
}

#[test]
fn what_is_beside_or_behind_does_not_change_an_exchange() {
    let [from, to] = [floor(1.0, 1.0), ceiling(1.0, 1.0, 1.0)];
    let beside = polygon(&[[2.0, 0.0, 0.2], [3.0, 0.0, 0.2], [3.0, 1.0, 0.7], [2.0, 1.0, 0.7]]);
    let below = polygon(&[[0.0, 0.0, -0.2], [1.0, 0.0, -0.2], [1.0, 1.0, -0.2], [0.0, 1.0, -0.2]]);
    let found = visible_exchange(&from, &to, [&from, &to, &beside, &below].into_iter(), 1e-13);
    assert_eq!(found, exchange(&from, &to, 1e-13));
    let all = ceiling(1.0, 1.0, 0.5);
    assert_eq!(visible_exchange(&from, &to, [&all].into_iter(), 1e-6).area, 0.0);
}

/// Returns a random disk, and a convex outline of `count` corners on a circle like it.
fn random_disk(random: &mut SplitMix, count: usize) -> (Disk, Vec<Vector>) {
    let mut vector = |size: f64| {
        let [x, y, z] = [0; 3].map(|_| random.between([-size, size]));
        Vector::new(x, y, z)
    };
    let (center, normal) = (vector(2.0), vector(1.0).unit().expect("a direction"));
    let radius = random.between([0.1, 1.5]);
    let step = 2.0 * PI / count as f64;
    let reach = radius * (step / step.sin()).sqrt();
    (Disk { center, normal, radius, hole: 0.0 }, regular(center, normal, reach, count))
}

/// A disk exchanges as much light as a regular polygon with its area, up to the N-th harmonic.
#[test]
fn a_disk_exchanges_what_a_polygon_of_many_edges_does() {
    let mut random = SplitMix(5);
    let mut seen = 0;
    for case in 0..300 {
        let (disk, outline) = random_disk(&mut random, 96);
        let (other, triangle) = random_disk(&mut random, if case % 2 == 0 { 3 } else { 96 });
        let normals = [disk.normal, other.normal];
        let expected = exchange_of_outlines([&outline, &triangle], normals, [1e-9; 2]);
        let found = match case % 2 {
            0 => exchange_with_disk(&disk, (&triangle, other.normal), 1e-9),
            _ => exchange_of_disks([&disk, &other], 1e-9),
        };
        let Some(found) = found else { continue };
        let off = (found.area - expected.area).abs();
        assert!(
            off <= found.error + expected.error + 3e-4 * expected.area,
            "{case}: {found:?}, {expected:?}"
        );
        seen += usize::from(found.area > 0.0);
    }
    assert!(seen > 60, "{seen} disks exchange light");
}
