//! Groups of points: the results for many points at once equal the results for each point alone.

use super::*;

#[test]
fn points_of_a_group_see_what_each_of_them_sees_alone() {
    let faces = faces_of(&furnished());
    let screens = Screens::of(&faces);
    let (mut work, mut borders, mut found) = (Workspace::default(), Borders::default(), Vec::new());
    for (origin, [along, across]) in [
        ([0.05, 0.05, 0.0], [[0.9, 0.0, 0.0], [0.0, 0.9, 0.0]]),
        ([0.21, 0.29, 0.0], [[0.0, -0.2, 0.0], [0.0, 0.0, 0.9]]),
        ([0.1, 0.95, 0.9], [[0.6, 0.0, 0.05], [0.0, -0.4, 0.07]]),
    ] {
        let [origin, along, across] = [origin, along, across].map(|[x, y, z]| Vector::new(x, y, z));
        let normal = along.cross(across).unit().unwrap();
        let normal = if normal.z == 0.0 { -normal } else { normal };
        let at = |[s, t]: [f64; 2]| origin + s * along + t * across;
        let outline = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(at);
        let places = |index: u32| [f64::from(index % 9), f64::from(index / 9)].map(|place| place / 8.0);
        let points: Vec<Vector> =
            (0..81).map(|index| at(places(index))).filter(|&point| is_free(point)).collect();
        for face in &faces {
            let luminaire = (face.vertices.as_slice(), face.normal);
            screens.between(&outline, Some(normal), luminaire.0, luminaire.1, &mut found);
            let looking = Looking {
                points: &points,
                outline: &outline,
                horizon: Some(normal),
                luminaire,
                screens: &found,
            };
            let mut together = vec![0.0; points.len()];
            if !screens.face_each_other(&outline, Some(normal), luminaire.0, luminaire.1) {
                continue;
            }
            screens.add_form_factors(looking, (normal, 1.0), (&mut work, &mut borders), &mut together);
            for (&point, together) in points.iter().zip(together) {
                let alone = seen(&screens, face, point, normal);
                assert!((together - alone).abs() < 1e-13, "{point:?}, {face:?}: {together} and {alone}");
            }
        }
    }
}
