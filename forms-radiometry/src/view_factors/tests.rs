//! Tests of view factors.

mod coaxial;
mod flat_shapes;

use super::*;
use crate::scene::{Division, read, read_with_files};
use forms_kernels::{view_factor_coaxial_disks, view_factor_sphere_disk, view_factor_spheres};
use forms_testing::SplitMix;
use forms_testing::scene_text::{CUBE, material, polygon, surface};

fn scene(more: &str) -> Scene {
    let faces = CUBE.map(|(name, corners)| surface(name, "grey", &polygon(&corners)));
    let text = material("grey", 0.5) + &faces.concat() + more;
    read(&text, "cube.toml").unwrap_or_else(|errors| panic!("{}", errors[0]))
}

#[test]
fn the_faces_of_a_cube_send_all_to_each_other_and_the_same_both_ways() {
    let found = view_factors(&scene("[solve]\ntolerance = 1e-13\n"));
    for surface in 0..6 {
        assert!((found.sum(surface) - 1.0).abs() < 1e-12, "{}", found.names[surface]);
        assert_eq!(found.rows[surface].factors[surface], ViewFactor::default());
    }
    // Howell C-11 for opposed unit squares at distance 1
    assert!((found.rows[0].factors[1].value - 0.199_824_895_698_387).abs() < 1e-12);
    assert_eq!(found.reciprocity_residual(), 0.0);
}

#[test]
fn a_screen_with_two_sides_takes_what_it_hides() {
    let screen = "[[surface]]\nname = \"screen\"\nmaterial = \"grey\"\ntwo_sided = true
        polygon = [[0.25,0.25,0.5], [0.75,0.25,0.5], [0.75,0.75,0.5], [0.25,0.75,0.5]]\n";
    let found = view_factors(&scene(screen));
    assert!((found.areas[6] - 0.5).abs() < 1e-15, "both sides");
    for surface in 0..7 {
        let error: f64 = found.rows[surface].factors.iter().map(|factor| factor.error).sum();
        let residual = (found.sum(surface) - 1.0).abs();
        assert!(residual <= error && error < 4e-3, "{}: {residual:e}, said {error:e}", found.names[surface]);
    }
    assert!(found.rows[0].factors[1].value < 0.15, "hidden in part");
    assert!(found.reciprocity_residual() < 1e-3);
}

#[test]
fn what_a_ball_in_a_cube_hides_arrives_at_the_ball() {
    let ball = "[[surface]]\nname = \"ball\"\nmaterial = \"grey\"
        sphere = { center = [0.5,0.5,0.5], radius = 0.3 }\n[solve]\ntolerance = 0.01\n";
    let found = view_factors(&scene(ball));
    for surface in 0..7 {
        let error: f64 = found.rows[surface].factors.iter().map(|factor| factor.error).sum();
        let residual = (found.sum(surface) - 1.0).abs();
        assert!(residual <= error && error < 0.05, "{surface}: {residual:e}, said {error:e}");
    }
    // all light of the ball goes to the cube, a sixth to each face
    let ViewFactor { value, error } = found.rows[6].factors[0];
    let off = (value - 1.0 / 6.0).abs();
    assert!(off <= 4.0 * error && found.rows[6].factors[6].value == 0.0, "off by {off:e}, said {error:e}");
    assert!(found.rows[0].factors[1].value < 0.1, "the ball hides half of the opposite face");
}

/// Builds a scene of these surfaces, given as name, shape and sides.
fn only(surfaces: &[(&str, &str, bool)]) -> Scene {
    let of = |(name, shape, two_sided): &(&str, &str, bool)| {
        surface(name, "grey", &format!("{shape}\ntwo_sided = {two_sided}"))
    };
    let text = material("grey", 0.5) + &surfaces.iter().map(of).collect::<String>();
    read(&text, "round.toml").unwrap_or_else(|errors| panic!("{}", errors[0]))
}

#[test]
fn disks_and_spheres_are_as_in_the_catalogue() {
    let disk = |height: f64, up: f64, radius: f64| {
        format!("disk = {{ center = [0.1,0.2,{height:?}], normal = [0,0,{up:?}], radius = {radius:?} }}")
    };
    let ball = |height: f64, radius: f64| {
        format!("sphere = {{ center = [0.1,0.2,{height:?}], radius = {radius:?} }}")
    };
    let cases = [
        (
            "coaxial disks",
            disk(0.0, 1.0, 1.0),
            disk(2.0, -1.0, 0.5),
            view_factor_coaxial_disks(1.0, 0.5, 2.0),
        ),
        ("near disks", disk(0.0, 1.0, 1.0), disk(0.3, -1.0, 1.0), view_factor_coaxial_disks(1.0, 1.0, 0.3)),
        ("sphere to disk", ball(0.0, 0.5), disk(1.5, -1.0, 1.0), view_factor_sphere_disk(1.0, 1.5)),
        ("spheres", ball(0.0, 1.0), ball(3.0, 0.5), view_factor_spheres(1.0, 0.5, 3.0)),
    ];
    for (name, from, to, expected) in cases {
        let found = view_factors(&only(&[("from", &from, false), ("to", &to, false)]));
        let ViewFactor { value, error } = found.rows[0].factors[1];
        let off = (value - expected).abs();
        assert!(off <= error, "{name}: off by {off:e}, said {error:e}");
        assert_eq!(found.rows[0].kind, ErrorKind::Bound, "{name}");
        assert!(found.reciprocity_residual() < 1e-14, "{name}");
    }
}

#[test]
fn closed_forms_of_round_shapes_are_what_rays_find() {
    let ball = |[x, y, z]: [f64; 3], radius: f64, inward: bool| {
        format!("sphere = {{ center = [{x:?},{y:?},{z:?}], radius = {radius:?}, inward = {inward} }}")
    };
    let square = polygon(&[[-1.0, -2.0, 0.0], [3.0, -2.0, 0.0], [3.0, 1.0, 0.0], [-1.0, 1.0, 0.0]]);
    let disk_aside = "disk = { center = [1e3, 1.0, 0.0], normal = [0.1, 0.2, 0.9], radius = 2.0 }".to_owned();
    let cases = [
        ("a ball before a disk aside", ball([1e3 + 0.3, 0.2, 1.0], 0.7, false), disk_aside.clone()),
        ("a ball above a square", ball([0.3, 0.2, 1.0], 0.7, false), square.clone()),
        ("a ball in a hollow one", ball([0.3, 0.2, 0.4], 0.4, false), ball([0.0; 3], 1.0, true)),
        ("a square in a hollow ball", square, ball([0.0; 3], 9.0, true)),
        ("two balls that touch", ball([0.0; 3], 1.0, false), ball([0.0, 0.0, 1.5], 0.5, false)),
    ];
    for (name, one, other) in cases {
        let scene = only(&[("one", &one, false), ("other", &other, false)]);
        let rows = Rows::of(&scene);
        for (surface, exact) in view_factors(&scene).rows.iter().enumerate() {
            assert_eq!(exact.kind, ErrorKind::Bound, "{name}");
            let mut rays = Rays::pilot(rows.emitters(), surface, vec![None; 2], 1);
            rays.reach(Goal { tolerance: 3e-3 }, &Unwatched);
            for (found, exact) in rays.row().factors.iter().zip(exact) {
                let off = (found.value - exact.value).abs();
                assert!(
                    off <= 4.0 * found.error,
                    "{name}: {} ± {}, {}",
                    found.value,
                    found.error,
                    exact.value
                );
            }
        }
    }
}

/// Returns a scene of this many boxes on a plate, in random places, each a mesh.
fn boxes(seed: u64, count: usize, tolerance: f64) -> Scene {
    let mut random = SplitMix(seed);
    let mut text = material("grey", 0.5) + &format!("[solve]\ntolerance = {tolerance:e}\n");
    let square = polygon(&[[-3.0, -3.0, 0.0], [3.0, -3.0, 0.0], [3.0, 3.0, 0.0], [-3.0, 3.0, 0.0]]);
    text += &surface("plate", "grey", &square);
    for number in 0..count {
        let x = -2.5 + 1.8 * number as f64 + random.between([0.0, 0.8]);
        let [y, z, side] = [[-2.5, 2.0], [0.1, 1.0], [0.2, 0.9]].map(|range| random.between(range));
        for (face, mut corners) in CUBE {
            corners.reverse();
            let moved =
                corners.map(|corner| [x + side * corner[0], y + side * corner[1], z + side * corner[2]]);
            text += &surface(&format!("{face} {number}"), "grey", &polygon(&moved));
        }
    }
    read(&text, "boxes.toml").unwrap_or_else(|errors| panic!("{}", errors[0]))
}

#[test]
fn rays_and_pairs_find_the_same_view_factors() {
    let (mut worst, mut squares, mut count): (f64, f64, f64) = (0.0, 0.0, 0.0);
    for seed in 0..2 {
        let scene = boxes(seed, 3, 1e-3);
        let rows = Rows::of(&scene);
        let exact = view_factors(&scene);
        let goal = Goal { tolerance: 1e-2 };
        for surface in 0..rows.names().len() {
            let mut rays = Rays::pilot(rows.emitters(), surface, vec![None; rows.names().len()], 7);
            rays.reach(goal, &Unwatched);
            let row = rays.row();
            assert_eq!(row.kind, ErrorKind::Sigma);
            assert!(goal.excess(&row.factors) <= 1.0);
            for (found, expected) in row.factors.iter().zip(&exact.rows[surface]) {
                let off = ((found.value - expected.value).abs() - expected.error).max(0.0) / found.error;
                worst = worst.max(off);
                squares += off * off;
                count += 1.0;
            }
        }
    }
    // standard errors, a little larger by what no ray has met
    assert!(worst < 5.0 && squares / count < 1.0, "{worst} σ, mean square {}", squares / count);
}

#[test]
fn exchange_is_the_same_both_ways_whatever_rows_are_asked_for() {
    let scene = boxes(9, 3, 1e-3);
    let all = view_factors(&scene);
    assert!(all.reciprocity_residual() < 1e-15);
    let mut some = Rows::of(&scene);
    for surface in [17, 4, 0] {
        let row = some.row(surface, &Unwatched).expect("a row");
        assert_eq!(row.factors, all.rows[surface].factors, "{surface}");
    }
}

#[test]
fn the_faces_of_a_mesh_send_together_what_the_mesh_sends() {
    let obj = "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 2 0 1.5\nv 2 1 1.5\n\
               g flat\nf 1 4 3\nf 1 3 2\ng steep\nf 2 3 6 5\n";
    let square = polygon(&[[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]]);
    let text = material("grey", 0.5)
        + &surface("floor", "grey", &square)
        + &surface("roof", "grey", "mesh = \"roof.obj\"")
        + "[solve]\ntolerance = 1e-6\n";
    let scene = read_with_files(&text, "mesh.toml", &|_| Ok(obj.as_bytes().to_vec()))
        .unwrap_or_else(|errors| panic!("{}", errors[0]));
    let whole = view_factors(&scene);
    let of = |division: Division| view_factors(&scene.divided(division));
    let (groups, faces) = (of(Division::Groups), of(Division::Faces));
    assert_eq!(groups.names, ["floor", "roof/flat", "roof/steep"]);
    assert_eq!(faces.names, ["floor", "roof#1", "roof#2", "roof#3"]);
    for parts in [&groups, &faces] {
        let sum: f64 = parts.rows[0].factors[1..].iter().map(|factor| factor.value).sum();
        assert!((sum - whole.rows[0][1].value).abs() < 2e-6, "{sum} and {}", whole.rows[0][1].value);
        assert!((parts.areas[1..].iter().sum::<f64>() - whole.areas[1]).abs() < 1e-14);
    }
}

#[test]
fn a_closed_scene_is_enclosed_and_an_open_one_refused() {
    let ball = "[[surface]]\nname = \"ball\"\nmaterial = \"grey\"
        sphere = { center = [0.5,0.5,0.5], radius = 0.3 }\n[solve]\ntolerance = 0.01\n";
    let mut found = view_factors(&scene(ball));
    let before = found.clone();
    let enclosed = found.enclose().expect("a closed scene");
    assert!(enclosed.change > 0.0 && enclosed.change < 0.02, "{enclosed:?}");
    assert!(found.reciprocity_residual() < 1e-13);
    for (surface, row) in found.rows.iter().enumerate() {
        assert!((row.sum() - 1.0).abs() < 1e-12, "{surface}: {}", row.sum());
        for (own, other) in row.into_iter().zip(&before.rows[surface]) {
            assert!((own.value - other.value).abs() <= enclosed.change);
            assert_eq!(own.value == 0.0, own.value == 0.0 && other.value < 1e-2);
        }
    }
    let square = |z: f64| polygon(&[[0.0, 0.0, z], [1.0, 0.0, z], [1.0, 1.0, z], [0.0, 1.0, z]]);
    let mut open = view_factors(&only(&[("low", &square(0.0), false), ("high", &square(1.0), true)]));
    let error = open.enclose().expect_err("light leaves");
    assert!(matches!(error, NotEnclosed::Open { ref surface, .. } if surface == "low"), "{error}");
}

/// The sum of a row of rays may exceed 1 by a few standard errors.
#[test]
fn rows_by_rays_of_a_closed_can_are_no_contradiction() {
    let can = only(&[
        ("side", "cylinder = { from = [0,0,0], to = [0,0,1], radius = 1, inward = true }", false),
        ("floor", "disk = { center = [0,0,0], normal = [0,0,1], radius = 1 }", false),
        ("lid", "disk = { center = [0,0,1], normal = [0,0,-1], radius = 1 }", false),
        ("plate", "disk = { center = [0,0,0.5], normal = [0,0.1,1], radius = 0.5 }", false),
    ]);
    for seed in 1..20 {
        let mut scene = can.clone();
        (scene.solve.seed, scene.solve.tolerance) = (seed, 1e-2);
        let found = view_factors(&scene);
        assert!(found.rows.iter().any(|row| row.kind == ErrorKind::Sigma));
        assert!(found.contradictions(&scene).is_empty(), "{seed}");
    }
}
