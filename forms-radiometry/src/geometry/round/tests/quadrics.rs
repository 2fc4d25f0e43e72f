//! Quadrics have their areas, lie where their equation says, and lines meet them where a search
//! along the line does.

use super::*;
use forms_testing::SplitMix;

/// A random cylinder, cone, truncated cone or paraboloid.
fn random(random: &mut SplitMix) -> Quadric {
    let mut point = || Vector::new(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5);
    let ends = [point(), 2.0 * point()];
    let [r, end] = [0.1 + random.unit(), 0.1 + random.unit()];
    let (radii, profile) = match random.below(5) {
        0 => ([r, r], Profile::Straight),
        1 => ([r, end], Profile::Straight),
        2 => ([0.0, end], Profile::Straight),
        3 => ([r, 0.0], Profile::Straight),
        _ => ([0.0, end], Profile::Parabolic),
    };
    Quadric { ends, radii, profile, inward: random.below(2) == 0 }
}

/// How far a point is outside, by the definition of the shape: positive outside; `None` beyond the
/// ends.
fn outside(quadric: &Quadric, point: Vector) -> Option<f64> {
    let way = quadric.ends[1] - quadric.ends[0];
    let s = way.dot(point - quadric.ends[0]) / way.dot(way);
    let away = (point - quadric.ends[0] - s * way).length();
    let [r, end] = quadric.radii;
    let radius = match quadric.profile {
        Profile::Straight => r + s * (end - r),
        Profile::Parabolic => (r * r + s * (end * end - r * r)).sqrt(),
    };
    (0.0..=1.0).contains(&s).then_some(away - radius)
}

#[test]
fn areas_are_those_of_the_textbook() {
    let from = Vector::new(0.3, -0.1, 0.2);
    let up = Vector::new(0.0, 0.6, 0.8);
    let of = |radii, length: f64, profile| {
        Quadric { ends: [from, from + length * up], radii, profile, inward: false }.area()
    };
    // a dish of radius R and depth d: π R/6d² ((R² + 4d²)^(3/2) − R³)
    let dish = |r: f64, d: f64| PI * r / (6.0 * d * d) * ((r * r + 4.0 * d * d).powf(1.5) - r.powi(3));
    let cases = [
        ("cylinder", of([0.5, 0.5], 3.0, Profile::Straight), 3.0 * PI),
        ("cone", of([3.0, 0.0], 4.0, Profile::Straight), 15.0 * PI),
        ("truncated cone", of([1.0, 4.0], 4.0, Profile::Straight), 25.0 * PI),
        ("deep dish", of([0.0, 1.0], 2.0, Profile::Parabolic), dish(1.0, 2.0)),
        ("shallow dish", of([0.0, 1.0], 1e-9, Profile::Parabolic), PI),
        ("dish from its rim", of([1.0, 0.0], 2.0, Profile::Parabolic), dish(1.0, 2.0)),
    ];
    for (name, found, expected) in cases {
        assert!((found / expected - 1.0).abs() < 1e-14, "{name}: {found}, {expected}");
    }
}

#[test]
fn sampled_points_lie_on_the_shape_with_equal_density_and_the_normal_of_its_front() {
    let mut numbers = SplitMix(3);
    for _ in 0..200 {
        let quadric = random(&mut numbers);
        let (axis, length) = quadric.axis();
        let mut below = 0;
        let half = Quadric { ends: [quadric.ends[0], quadric.center()], ..quadric };
        let half = Quadric { radii: [quadric.radii[0], radius_at(&quadric, 0.5)], ..half };
        for place in 0..400 {
            let square = [(f64::from(place) + 0.5) / 400.0, numbers.unit()];
            let (point, normal) = quadric.point(square);
            let off = outside(&quadric, point + (1e-15 * length) * axis)
                .or_else(|| outside(&quadric, point - (1e-15 * length) * axis));
            assert!(off.is_some_and(|off| off.abs() < 1e-12), "{quadric:?}: {off:?}");
            below += usize::from(axis.dot(point - quadric.ends[0]) < 0.5 * length);
            // a step along the normal leads to the side of the front
            let side = outside(&quadric, point + 1e-6 * normal);
            assert!(side.is_none_or(|side| (side > 0.0) != quadric.inward), "{quadric:?} at {square:?}");
        }
        let expected = half.area() / quadric.area();
        assert!((below as f64 / 400.0 - expected).abs() < 0.004, "{quadric:?}: {below} of 400, {expected}");
    }
}

/// Largest distance of the shape from the points of it that a search compares.
const STEP: f64 = 2e-3;

fn radius_at(quadric: &Quadric, s: f64) -> f64 {
    let [r, end] = quadric.radii;
    match quadric.profile {
        Profile::Straight => r + s * (end - r),
        Profile::Parabolic => (r * r + s * (end * end - r * r)).sqrt(),
    }
}

#[test]
fn lines_meet_a_quadric_where_a_search_along_them_does() {
    let mut numbers = SplitMix(5);
    let mut met = 0;
    for _ in 0..2_000 {
        let quadric = random(&mut numbers);
        let mut point = || {
            let [x, y, z] = [numbers.unit(), numbers.unit(), numbers.unit()];
            3.0 * Vector::new(x - 0.5, y - 0.5, z - 0.5)
        };
        let (from, to) = (point(), point());
        let direction = (to - from).unit().unwrap();
        let found: Vec<Crossing> = quadric.crossings(from, direction).into_iter().flatten().collect();
        let at = |t: f64| outside(&quadric, from + t * direction);
        for &Crossing { distance, enters } in &found {
            let [before, after] = [distance - 1e-7, distance + 1e-7].map(at);
            let [Some(before), Some(after)] = [before, after] else { continue };
            assert!(before > 0.0 && after < 0.0 || !enters, "{quadric:?} at {distance}");
            assert!(before < 0.0 && after > 0.0 || enters, "{quadric:?} at {distance}");
        }
        let steps: Vec<f64> = (-4000..4000).map(|step| 1e-3 * f64::from(step)).collect();
        let changes = steps.windows(2).filter(
            |pair| matches!([at(pair[0]), at(pair[1])], [Some(a), Some(b)] if (a > 0.0) != (b > 0.0)),
        );
        for pair in changes {
            let is_there = |met: &Crossing| met.distance >= pair[0] - 1e-9 && met.distance <= pair[1] + 1e-9;
            assert!(found.iter().any(is_there), "{quadric:?}: missed between {pair:?}, found {found:?}");
            met += 1;
        }
    }
    assert!(met > 500, "{met} crossings");
}

#[test]
fn pieces_face_the_front_and_their_area_comes_nearer_with_the_square_of_their_edges() {
    let mut numbers = SplitMix(7);
    for _ in 0..40 {
        let quadric = random(&mut numbers);
        let mut errors = Vec::new();
        for fineness in 0..4 {
            let pieces: Vec<Polygon> =
                quadric.pieces(fineness).into_iter().map(|piece| Polygon::new(piece).unwrap()).collect();
            let area: f64 = pieces.iter().map(Polygon::area).sum();
            errors.push((area / quadric.area() - 1.0).abs());
            for piece in &pieces {
                let middle = Vector::mean(piece.vertices());
                let (foot, normal) = quadric.foot(middle);
                assert!(piece.normal().dot(normal) > 0.0, "{quadric:?}");
                let along = quadric.axis().0.dot(foot - quadric.ends[0]) * quadric.axis().0;
                let outward = (foot - quadric.ends[0] - along).unit().unwrap();
                let at = |s: f64| {
                    let on_axis = quadric.ends[0] + s * (quadric.ends[1] - quadric.ends[0]);
                    (on_axis + radius_at(&quadric, s) * outward - middle).length()
                };
                // near the vertex of a paraboloid the radius is the root of the height
                let places = (0..=1000).map(|place| (f64::from(place) / 1000.0).powi(2));
                let away = places.map(at).fold(f64::INFINITY, f64::min);
                assert!(away <= quadric.deviation(fineness) + STEP, "{quadric:?}: {away}");
            }
        }
        let order = (errors[1] / errors[3]).log2() / 2.0;
        assert!(errors[3] < 1e-3 && (order > 1.7 || errors[3] < 1e-4), "{quadric:?}: {errors:?}");
    }
}

#[test]
fn no_point_is_nearer_to_a_quadric_than_its_distance_says() {
    let mut numbers = SplitMix(11);
    for _ in 0..200 {
        let quadric = random(&mut numbers);
        let [x, y, z] = [numbers.unit(), numbers.unit(), numbers.unit()];
        let point = 3.0 * Vector::new(x - 0.5, y - 0.5, z - 0.5);
        let distance = quadric.distance(point);
        let places = (0..400).map(|place| (f64::from(place % 20) / 19.0, f64::from(place / 20) / 20.0));
        let nearest = places.map(|(u, v)| (quadric.point([u, v]).0 - point).length());
        assert!(distance <= nearest.fold(f64::INFINITY, f64::min) + 1e-12, "{quadric:?}");
        let (on, _) = quadric.point([numbers.unit(), numbers.unit()]);
        assert!(quadric.distance(on) < 1e-12);
    }
}
