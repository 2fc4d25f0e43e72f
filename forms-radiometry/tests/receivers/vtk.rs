//! Files of VTK: what they contain is read back unchanged.

use crate::{INWARD, cube, map, mesh, receiver, scene_with, solved};
use forms_radiometry::output::{scene_vtu, vtu};
use forms_radiometry::scene::Shape;
use forms_radiometry::simulation::Quantity;
use forms_testing::scene_text::{polygon, surface_of_its_own, tolerance};
use vtkio::model::{Attribute, DataSet, Piece, UnstructuredGridPiece, Vtk};

/// Returns the only grid of a file of VTK.
fn grid(bytes: &[u8]) -> UnstructuredGridPiece {
    let vtk = Vtk::parse_xml(bytes).expect("VTK reads the file");
    let DataSet::UnstructuredGrid { mut pieces, .. } = vtk.data else { panic!("it is no grid") };
    match pieces.remove(0) {
        Piece::Inline(piece) => *piece,
        _ => panic!("the grid is in the file"),
    }
}

fn column(attributes: &[Attribute], name: &str) -> Vec<f64> {
    let column = attributes.iter().find_map(|attribute| match attribute {
        Attribute::DataArray(array) if array.name == name => array.data.clone().cast_into(),
        _ => None,
    });
    column.unwrap_or_else(|| panic!("there is no column {name}"))
}

#[test]
fn files_of_vtk_have_the_results_and_the_geometry_unchanged() {
    let text = mesh("room", "room.obj", [0.25, 1.5])
        + &receiver("faces", "faces", "surface = \"room\"")
        + &receiver(
            "points",
            "point",
            "line = { from = [0.5, 1, 0.5], to = [1.5, 1, 0.5], count = 3 }\nnormal = [0, 1, 0]",
        )
        + &surface_of_its_own(
            "shelf",
            &polygon(&[[0.5, 0.5, 1.0], [1.0, 0.5, 1.0], [0.5, 1.0, 1.0]]),
            "0.1",
            "0",
        )
        + &receiver("map", "surface", "surface = \"shelf\"\ngrid = [4, 4]")
        + &tolerance(5e-2);
    let files = [("room.obj", cube(&INWARD, true, [0.0, 2.0]).into_bytes())];
    let files = files.each_ref().map(|(name, bytes)| (*name, &bytes[..]));
    let scene = scene_with(&text, &files);
    let found = solved(&scene);
    let encoded = |index: usize| {
        vtu(&scene, &scene.receivers[index], &found).expect("it has geometry").expect("memory")
    };

    let faces = encoded(0);
    let cells = grid(&faces).data.cell;
    for (quantity, name) in [(Quantity::Irradiance, "irradiance"), (Quantity::NetFlux, "net_flux")] {
        let map = map(&found, "faces", quantity);
        assert_eq!(column(&cells, name), map.values[0]);
        assert_eq!(column(&cells, &format!("{name}_error")), map.errors[0]);
    }
    let again = scene_with(&mesh("again", "again.vtu", [0.5, 0.0]), &[("again.vtu", &faces)]);
    let [Shape::Mesh(one), Shape::Mesh(other)] = [&scene.surfaces[0].shape, &again.surfaces[0].shape] else {
        panic!("both are meshes")
    };
    let outlines = |mesh: &forms_radiometry::geometry::Mesh| {
        mesh.polygons().map(|polygon| polygon.vertices().to_vec()).collect::<Vec<_>>()
    };
    assert_eq!(outlines(one), outlines(other));

    let points = grid(&encoded(1)).data.point;
    assert_eq!(column(&points, "irradiance"), map(&found, "points", Quantity::Irradiance).values[0]);
    let map_of_shelf = map(&found, "map", Quantity::Irradiance);
    let on_shelf: Vec<f64> = map_of_shelf.values[0].iter().copied().filter(|value| !value.is_nan()).collect();
    assert!(on_shelf.len() < 16, "some cells are off the triangle");
    assert_eq!(column(&grid(&encoded(2)).data.cell, "irradiance"), on_shelf);

    let surfaces = grid(&scene_vtu(&scene).expect("memory")).data.cell;
    let (surface, exitance) = (column(&surfaces, "surface"), column(&surfaces, "exitance"));
    assert!(
        surface.iter().zip(exitance).all(|(surface, exitance)| exitance == [1.5, 0.0][*surface as usize])
    );
}
