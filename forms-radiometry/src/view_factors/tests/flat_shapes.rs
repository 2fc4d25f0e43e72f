//! View factors of disks, annuli and polygons as sums over their borders are what rays find.

use super::*;
use crate::view_factors::closed_forms::ClosedForms;

/// Returns a cube with a round lamp on its ceiling, and with these other surfaces.
fn lit(more: &str, tolerance: f64) -> Scene {
    let shape = "disk = { center = [0.4,0.5,1], normal = [0,0,-1], radius = 0.2 }\non = \"ceiling\"";
    scene(&(surface("lamp", "grey", shape) + more + &format!("[solve]\ntolerance = {tolerance:?}\n")))
}

/// Returns a table in a cube, and a plate or a ring that hangs askew.
fn furniture(random: &mut SplitMix) -> String {
    let [x, y, z] = [0.2, 0.2, 0.1].map(|low| random.between([low, 0.6]));
    let [a, b] = [0; 2].map(|_| random.between([-0.6, 0.6]));
    let table = polygon(&[[x, y, z], [x + 0.3, y, z], [x + 0.3, y + 0.3, z], [x, y + 0.3, z]]);
    let kind = if random.below(2) == 0 { "disk" } else { "annulus" };
    let size = if kind == "disk" { "radius = 0.1" } else { "radii = [0.03, 0.1]" };
    let plate = format!("{kind} = {{ center = [0.5, 0.5, 0.8], normal = [{a:?}, {b:?}, 1], {size} }}");
    surface("table", "grey", &table) + &surface("plate", "grey", &plate)
}

#[test]
fn rows_of_a_room_with_a_round_lamp_sum_to_one() {
    let found = view_factors(&lit("", 1e-10));
    for (row, name) in found.rows.iter().zip(&found.names) {
        assert_eq!(row.kind, ErrorKind::Estimate, "{name}");
        assert!((row.sum() - 1.0).abs() <= row.sum_error() && row.sum_error() < 1e-9, "{name}: {row:?}");
    }
    assert!(found.reciprocity_residual() < 1e-12, "{}", found.reciprocity_residual());
}

#[test]
fn what_hides_disks_and_polygons_is_seen_and_the_others_are_what_rays_find() {
    let mut random = SplitMix(3);
    let mut known = [0; 2];
    for case in 0..6 {
        let scene = lit(&furniture(&mut random), 1e-3);
        let (rows, exact) = (Rows::of(&scene), ClosedForms::of(Arc::new(scene.clone())));
        for surface in 0..scene.surfaces.len() {
            let row = exact.known(surface);
            let mut rays = Rays::pilot(rows.emitters(), surface, vec![None; row.len()], 1);
            rays.reach(Goal { tolerance: 1e-2 }, &Unwatched);
            for (other, (found, exact)) in rays.row().factors.iter().zip(&row).enumerate() {
                known[usize::from(exact.is_some())] += 1;
                let Some((exact, _)) = exact else { continue };
                let off = (found.value - exact.value).abs();
                assert!(off <= 5.0 * found.error, "{case}: {surface} to {other}: {found:?}, {exact:?}");
            }
        }
    }
    assert!(known.iter().all(|&count| count > 60), "{known:?} hidden and known");
}
