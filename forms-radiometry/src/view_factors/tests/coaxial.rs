//! Closed forms of shapes about one axis are what rays find.

use super::*;
use crate::view_factors::closed_forms::ClosedForms;

/// Returns a closed vessel about an axis that is not one of the coordinates: a floor, `rings` inward
/// cylinders, cones and annuli above each other, and a lid.
fn vessel(random: &mut SplitMix, rings: usize) -> Scene {
    let place = |height: f64| {
        let [x, y, z] = [0.6, 0.0, 0.8].map(|along| along * height);
        format!("[{:?}, {:?}, {:?}]", 0.1 + x, 0.2 + y, z)
    };
    let flat = |shape: &str, height: f64, up: f64, radii: &str| {
        format!(
            "{shape} = {{ center = {}, normal = [{:?}, 0, {:?}], {radii} }}",
            place(height),
            0.6 * up,
            0.8 * up
        )
    };
    let mut radius = random.between([0.3, 1.5]);
    let mut height = 0.0;
    let mut shapes = vec![flat("disk", height, 1.0, &format!("radius = {radius:?}"))];
    for _ in 0..rings {
        let (wider, higher) = (random.between([0.3, 1.5]), height + random.between([0.2, 1.5]));
        let ends = format!("from = {}, to = {}", place(height), place(higher));
        // an annulus in the plane of the floor would lie on it
        match random.below(if height > 0.0 { 3 } else { 2 }) {
            0 => shapes.push(format!("cylinder = {{ {ends}, radius = {radius:?}, inward = true }}")),
            1 => {
                shapes.push(format!("cone = {{ {ends}, radii = [{radius:?}, {wider:?}], inward = true }}"));
                radius = wider;
            }
            _ => {
                let [inner, outer] = [radius.min(wider), radius.max(wider)];
                let up = if wider > radius { 1.0 } else { -1.0 };
                shapes.push(flat("annulus", height, up, &format!("radii = [{inner:?}, {outer:?}]")));
                shapes.push(format!("cylinder = {{ {ends}, radius = {wider:?}, inward = true }}"));
                radius = wider;
            }
        }
        height = higher;
    }
    shapes.push(flat("disk", height, -1.0, &format!("radius = {radius:?}")));
    let named: Vec<(String, String)> =
        shapes.into_iter().enumerate().map(|(index, shape)| (format!("s{index}"), shape)).collect();
    only(&named.iter().map(|(name, shape)| (name.as_str(), shape.as_str(), false)).collect::<Vec<_>>())
}

/// Asserts that the closed forms of a scene are what rays find, and returns how many there are.
fn compare(scene: &Scene, name: &str) -> usize {
    let (rows, exact) = (Rows::of(scene), ClosedForms::of(Arc::new(scene.clone())));
    let mut known = 0;
    for surface in 0..scene.surfaces.len() {
        let row = exact.known(surface);
        let mut rays = Rays::pilot(rows.emitters(), surface, vec![None; row.len()], 1);
        rays.reach(Goal { tolerance: 6e-3 }, &Unwatched);
        for (other, (found, exact)) in rays.row().factors.iter().zip(&row).enumerate() {
            let Some((exact, _)) = exact else { continue };
            let off = (found.value - exact.value).abs();
            assert!(off <= 5.0 * found.error, "{name}: {surface} to {other}: {found:?}, {exact:?}");
            known += 1;
        }
    }
    known
}

#[test]
fn view_factors_in_vessels_are_what_rays_find() {
    let mut random = SplitMix(1);
    let mut known = 0;
    for number in 0..12 {
        known += compare(&vessel(&mut random, 1 + number % 3), &format!("vessel {number}"));
    }
    assert!(known > 100, "{known} closed forms");
}

#[test]
fn view_factors_of_dishes_and_rings_are_what_rays_find() {
    let dish = "paraboloid = { from = [0,0,0], to = [0,0,1], radius = 1, inward = true }";
    let ring = "annulus = { center = [0,0,2], normal = [0,0,-1], radii = [0.3, 1.2] }";
    let lid = "disk = { center = [0,0,1], normal = [0,0,-1], radius = 1 }";
    let tip = "cone = { from = [0,0,0], to = [0,0,2], radii = [0, 1], inward = true }";
    let far = "disk = { center = [0,0,5], normal = [0,0,-1], radius = 2 }";
    let aside = "disk = { center = [0,0,5], normal = [0,0,-1], radius = 0.5 }";
    let outside = "cylinder = { from = [0,0,0], to = [0,0,1], radius = 0.5 }";
    let cases: [(&str, &[&str], usize); 6] = [
        ("a dish and a ring", &[dish, ring], 4),
        ("a dish with a lid", &[dish, lid], 4),
        ("a cone and a disk that sees it through its opening", &[tip, aside], 4),
        ("a cone and a disk that sees its outside, too", &[tip, far], 4),
        ("a ring between a dish and a disk", &[dish, ring, far], 7),
        ("a cylinder from outside", &[outside, far], 2),
    ];
    for (name, shapes, expected) in cases {
        let names: Vec<String> = (0..shapes.len()).map(|index| format!("s{index}")).collect();
        let surfaces: Vec<_> =
            names.iter().zip(shapes).map(|(name, shape)| (name.as_str(), *shape, false)).collect();
        assert_eq!(compare(&only(&surfaces), name), expected, "{name}");
    }
}

#[test]
fn a_closed_vessel_keeps_all_light() {
    let mut random = SplitMix(2);
    for _ in 0..20 {
        let found = view_factors(&vessel(&mut random, 1));
        for surface in 0..found.names.len() {
            let row = &found.rows[surface];
            let error: f64 = row.factors.iter().map(|factor| factor.error).sum();
            assert_eq!(row.kind, ErrorKind::Bound);
            assert!(
                (found.sum(surface) - 1.0).abs() <= error + 4.0 * f64::EPSILON && error < 1e-11,
                "{}",
                found.sum(surface)
            );
        }
    }
}

/// The tip of a cone and the vertex of a paraboloid are closed.
#[test]
fn the_insides_of_shapes_tip_to_tip_see_nothing_of_each_other() {
    let kinds = ["cone", "paraboloid"];
    for (lower, upper, gap) in kinds
        .iter()
        .flat_map(|lower| kinds.iter().flat_map(move |upper| [0.0, 0.5].map(|gap| (lower, upper, gap))))
    {
        let shape = |kind: &str, from: f64, to: f64| match kind {
            "cone" => format!(
                "cone = {{ from = [0,0,{from:?}], to = [0,0,{to:?}], radii = [0, 1], inward = true }}"
            ),
            _ => format!(
                "paraboloid = {{ from = [0,0,{from:?}], to = [0,0,{to:?}], radius = 1, inward = true }}"
            ),
        };
        let (below, above) = (shape(lower, -gap, -gap - 1.0), shape(upper, 0.0, 1.0));
        let scene = only(&[("below", &below, false), ("above", &above, false)]);
        let found = view_factors(&scene);
        for (from, to) in [(0, 1), (1, 0)] {
            assert_eq!(found.rows[from][to], ViewFactor::default(), "{lower}, {upper}, {gap}");
        }
    }
}
