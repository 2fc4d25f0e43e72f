//! Checkerboards, environment maps, serialized meshes, interpolated normals and orthographic cameras
//! of Mitsuba 3: each is read, and gives the light that its definition implies.

use crate::shown;
use exr::prelude::write_rgb_file;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use forms_radiometry::geometry::Vector;
use forms_radiometry::scene::{
    MaterialKind, ReceiverKind, Scene, SceneError, Shape, not_simulated, read_with_files,
};
use forms_radiometry::simulation::{Unwatched, plan, simulate};
use std::f64::consts::PI;
use std::io::Write;

const FILE: &str = "box.xml";
const METER: &str = "<sensor type=\"irradiancemeter\" id=\"meter\"><film type=\"hdrfilm\">\
    <integer name=\"width\" value=\"1\"/><integer name=\"height\" value=\"1\"/></film></sensor>";

fn read(elements: &str, file: &[u8]) -> Result<Scene, Vec<SceneError>> {
    let text = format!("<scene version=\"3.0.0\">{elements}</scene>");
    read_with_files(&text, FILE, &|_| Ok(file.to_vec()))
}

fn scene(elements: &str, file: &[u8]) -> Scene {
    read(elements, file).unwrap_or_else(|errors| panic!("{}", shown(&errors)))
}

fn first_error(elements: &str, file: &[u8]) -> String {
    read(elements, file).map(|_| ()).expect_err("the scene has an error")[0].message.clone()
}

/// Simulates a scene, and checks the first answer of a receiver against a value.
fn check(name: &str, scene: &Scene, expected: f64) {
    assert_eq!(not_simulated(scene), [], "{name}");
    let plan = plan(scene).unwrap_or_else(|errors| panic!("{name}: {}", shown(&errors)));
    let found = simulate(&plan, &Unwatched);
    let answer = &found.answers[0];
    let error = (answer.value - expected).abs();
    assert!(
        error <= 4.0 * answer.error + 1e-4 * expected && answer.error < 0.02 * expected,
        "{name}: {answer:?}"
    );
}

/// An image of three rows: 1 at the upper pole, and 0 from the horizon on.
fn sky() -> Vec<u8> {
    let path = std::env::temp_dir().join(format!("forms_sky_{}.exr", std::process::id()));
    let pixel = |_: usize, y: usize| if y == 0 { (1.0_f32, 1.0_f32, 1.0_f32) } else { (0.0, 0.0, 0.0) };
    write_rgb_file(&path, 4, 3, pixel).unwrap();
    std::fs::read(path).unwrap()
}

/// A file of serialized meshes: of a triangle, and of a square with normals and texture coordinates.
fn serialized(version: u16) -> Vec<u8> {
    let mesh = |vertices: &[[f32; 3]], normal: [f32; 3], triangles: &[[u32; 3]]| {
        let flags: u32 = 0x1001 | if vertices.len() == 4 { 2 } else { 0 };
        let mut bytes = flags.to_le_bytes().to_vec();
        if version == 4 {
            bytes.extend(b"part\0");
        }
        bytes.extend((vertices.len() as u64).to_le_bytes());
        bytes.extend((triangles.len() as u64).to_le_bytes());
        let floats = vertices.iter().flatten().copied().chain(vertices.iter().flat_map(|_| normal));
        let texture = vertices.iter().flat_map(|v| [v[0], v[1]]).take(if flags & 2 == 0 { 0 } else { 8 });
        floats.chain(texture).for_each(|float| bytes.extend(float.to_le_bytes()));
        triangles.iter().flatten().for_each(|index| bytes.extend(index.to_le_bytes()));
        let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(&bytes).unwrap();
        [&[0x1C, 0x04][..], &version.to_le_bytes(), &encoder.finish().unwrap()].concat()
    };
    let triangle = mesh(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [0.0, 0.0, 1.0], &[[0, 1, 2]]);
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let square = mesh(&corners, [0.6, 0.0, 0.8], &[[0, 1, 2], [0, 2, 3]]);
    let second = triangle.len() as u64;
    let mut file = [triangle, square].concat();
    for start in [0, second] {
        file.extend(&start.to_le_bytes()[..if version == 4 { 8 } else { 4 }]);
    }
    file.extend(2_u32.to_le_bytes());
    file
}

fn serialized_shape(index: usize, rest: &str) -> String {
    format!(
        "<shape type=\"serialized\"><string name=\"filename\" value=\"m.serialized\"/>\
         <integer name=\"shape_index\" value=\"{index}\"/>{rest}</shape>"
    )
}

#[test]
fn each_mesh_of_a_serialized_file_is_read_and_others_are_errors() {
    for version in [3, 4] {
        for (index, faces) in [(0, 1), (1, 2)] {
            let scene = scene(&serialized_shape(index, ""), &serialized(version));
            let Shape::Mesh(mesh) = &scene.surfaces[0].shape else { panic!("a mesh") };
            assert_eq!(mesh.faces().len(), faces, "version {version}");
        }
    }
    let file = serialized(4);
    assert_eq!(
        first_error(&serialized_shape(2, ""), &file),
        "there is no mesh 2: `shape_index` counts the 2 meshes from 0"
    );
    assert_eq!(first_error(&serialized_shape(0, ""), b"ply"), "it does not begin like a serialized mesh");
    for length in 0..file.len() {
        let _ = read(&serialized_shape(1, ""), &file[..length]);
    }
}

/// Radiance of a surface of reflectance ρ in parallel light of irradiance E against its normal n:
/// ρ/π E cos θ, where θ is measured from the interpolated normal.
#[test]
fn interpolated_normals_reflect_light_as_if_the_surface_were_tilted() {
    let eye = "<sensor type=\"orthographic\"><transform name=\"to_world\"><scale value=\"0.1\"/>\
        <lookat origin=\"0.5, 0.4, 3\" target=\"0.5, 0.4, 0\" up=\"0, 1, 0\"/></transform><film type=\"hdrfilm\">\
        <integer name=\"width\" value=\"2\"/><integer name=\"height\" value=\"2\"/></film></sensor>";
    let sun = "<emitter type=\"directional\"><vector name=\"direction\" value=\"0, 0, -1\"/>\
        <float name=\"irradiance\" value=\"3\"/></emitter>";
    let flat = "<boolean name=\"face_normals\" value=\"true\"/>";
    for (rest, expected) in [("", 1.5 / PI * 0.8), (flat, 1.5 / PI)] {
        let elements = format!("{}{sun}{eye}", serialized_shape(1, rest));
        check(rest, &scene(&elements, &serialized(4)), expected);
    }
    // all light around the tilted normal comes from outside
    let elements = format!("{}<emitter type=\"constant\"/>{eye}", serialized_shape(1, ""));
    check("constant", &scene(&elements, &serialized(4)), 0.5);
}

/// With y upright, E = 2π ∫ (1 − 2θ/π) sin θ cos θ dθ = π/2 from 0 to π/2.
#[test]
fn an_environment_map_lights_a_surface_by_its_pixels_and_its_orientation() {
    let map = |turn: &str| {
        format!(
            "<emitter type=\"envmap\"><string name=\"filename\" value=\"sky.exr\"/><float name=\"scale\" value=\"2\"/>\
             <transform name=\"to_world\">{turn}</transform></emitter><shape type=\"rectangle\">{METER}</shape>"
        )
    };
    check("upright", &scene(&map("<rotate x=\"1\" angle=\"90\"/>"), &sky()), PI);
    let scene = scene(&map(""), &sky());
    assert_eq!(scene.ambient.radiance, [2.0; 3]);
    assert!(scene.ambient.map.is_some());
    let found = first_error(&map(""), b"no image");
    assert!(found.starts_with("the environment map `sky.exr` cannot be read: "), "{found}");
    assert_eq!(
        first_error(&(map("") + "<emitter type=\"constant\"/>"), &sky()),
        "more than one emitter of type `constant` or `envmap`"
    );
}

fn board(shape: &str) -> String {
    format!(
        "<texture type=\"checkerboard\" id=\"board\"><float name=\"color0\" value=\"0.25\"/>\
         <transform name=\"to_uv\"><scale x=\"1.5\" y=\"1\"/></transform></texture>{shape}"
    )
}

const PAINTED: &str = "<bsdf type=\"diffuse\"><ref name=\"reflectance\" id=\"board\"/></bsdf>";

#[test]
fn the_fields_of_a_checkerboard_are_surfaces_of_two_colours() {
    let shape = format!("<shape type=\"rectangle\" id=\"floor\">{PAINTED}</shape>");
    let scene = scene(&board(&shape), b"");
    let names: Vec<&str> = scene.surfaces.iter().map(|surface| &*surface.name).collect();
    assert_eq!(names, ["floor/color0", "floor/color1"]);
    let reflectance = |index: usize| match &scene.materials[scene.surfaces[index].material].kind {
        MaterialKind::Diffuse { reflectance } => reflectance[0],
        _ => panic!("a diffuse surface"),
    };
    assert_eq!([reflectance(0), reflectance(1)], [0.25, 0.2]);
    // three columns by two rows of fields on a square of side 2
    let middle = |[column, row]: [f64; 2]| Vector::new(-1.0 + (column + 0.5) / 1.5, -0.5 + row, 0.0);
    for (surface, fields) in
        [(0, [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0]]), (1, [[1.0, 0.0], [0.0, 1.0], [2.0, 1.0]])]
    {
        let Shape::Mesh(mesh) = &scene.surfaces[surface].shape else { panic!("a mesh") };
        let area: f64 = mesh.polygons().map(|polygon| polygon.area()).sum();
        assert!((area - 2.0).abs() < 1e-12, "{area}");
        for field in fields {
            let near = |vertex: &&Vector| (**vertex - middle(field)).length() < 0.61;
            assert!(mesh.vertices().iter().filter(near).count() >= 4, "{field:?}");
        }
    }
    let tube = format!("<shape type=\"cylinder\" id=\"tube\">{PAINTED}</shape>");
    let expected = "the shape `tube` has no texture coordinates here, which is not supported";
    assert_eq!(first_error(&board(&tube), b""), expected);
}

#[test]
fn the_light_of_a_checkerboard_is_that_of_its_mean_reflectance_from_afar() {
    // a square of side 2, seen as a whole: three fields of each colour
    let shape = format!("<shape type=\"rectangle\">{PAINTED}</shape>");
    let eye = "<sensor type=\"orthographic\"><transform name=\"to_world\">\
        <lookat origin=\"0, 0, 3\" target=\"0, 0, 0\" up=\"0, 1, 0\"/></transform><film type=\"hdrfilm\">\
        <integer name=\"width\" value=\"1\"/><integer name=\"height\" value=\"1\"/></film></sensor>";
    let sun = "<emitter type=\"directional\"><vector name=\"direction\" value=\"0, 0, -1\"/>\
        <float name=\"irradiance\" value=\"1\"/></emitter>";
    check("board", &scene(&(board(&shape) + sun + eye), b""), 0.225 / PI);
}

#[test]
fn an_orthographic_camera_shows_two_units_of_its_own_coordinates() {
    let text = "<sensor type=\"orthographic\"><transform name=\"to_world\"><scale x=\"3\" y=\"3\"/>\
        <lookat origin=\"0, 0, 5\" target=\"0, 0, 0\" up=\"0, 1, 0\"/></transform><film type=\"hdrfilm\">\
        <integer name=\"width\" value=\"4\"/><integer name=\"height\" value=\"2\"/></film></sensor>";
    let ReceiverKind::Camera(camera) = &scene(text, b"").receivers[0].kind else { panic!("a camera") };
    assert!(camera.is_orthographic());
    let [origin, direction] = camera.ray(4.0, 0.0);
    assert!((origin - Vector::new(3.0, 1.5, 5.0)).length() < 1e-12, "{origin:?}");
    assert_eq!(direction, Vector::new(0.0, 0.0, -1.0));
    let message = "non-uniform scaling or reflection of a camera is not supported";
    assert_eq!(first_error(&text.replace("y=\"3\"", "y=\"2\""), b""), message);
}

#[test]
fn a_limit_of_depth_counts_reflections_by_mirrors() {
    let text = |depth: u32| {
        format!(
            "<integrator type=\"path\"><integer name=\"max_depth\" value=\"{depth}\"/></integrator>\
             <shape type=\"disk\"><bsdf type=\"conductor\"/></shape><emitter type=\"constant\"/>\
             <sensor type=\"orthographic\"><transform name=\"to_world\"><scale value=\"0.1\"/>\
             <lookat origin=\"0, 0, 3\" target=\"0, 0, 0\" up=\"0, 1, 0\"/></transform><film type=\"hdrfilm\">\
             <integer name=\"width\" value=\"1\"/><integer name=\"height\" value=\"1\"/></film></sensor>"
        )
    };
    for (depth, expected) in [(1, 0.0), (2, 1.0)] {
        let found = simulate(&plan(&scene(&text(depth), b"")).unwrap(), &Unwatched);
        assert_eq!(found.answers[0].value, expected, "{depth}");
    }
}

/// A plate in light of radiance 1 from all sides reflects F(0) and, with the reflectance ρ of its base,
/// (1 − F(0)) ρ ∫ (1 − F(θ)) cos θ/π dω along its normal.
#[test]
fn plastic_reflects_by_its_coat_and_its_base() {
    let text = "<shape type=\"disk\"><bsdf type=\"plastic\"><float name=\"int_ior\" value=\"1.5\"/>\
        <float name=\"ext_ior\" value=\"1\"/><float name=\"diffuse_reflectance\" value=\"0.25\"/></bsdf></shape>\
        <emitter type=\"constant\"/><sensor type=\"orthographic\"><transform name=\"to_world\">\
        <scale value=\"0.001\"/><lookat origin=\"0, 0, 3\" target=\"0, 0, 0\" up=\"0, 1, 0\"/></transform>\
        <film type=\"hdrfilm\"><integer name=\"width\" value=\"1\"/><integer name=\"height\" value=\"1\"/>\
        </film></sensor>";
    let scene = scene(text, b"");
    let MaterialKind::Plastic { reflectance, index, .. } = &scene.materials[0].kind else {
        panic!("plastic")
    };
    // diffuse reflectances of the boundary of index 1.5: 0.596 from inside, 0.092 from outside
    assert!((reflectance[0] * 2.25 * (1.0 - 0.596) / 0.25 - 1.0).abs() < 5e-3, "{reflectance:?}");
    assert_eq!(*index, 1.5);
    check("plastic", &scene, 0.04 + 0.96 * reflectance[0] * (1.0 - 0.0918));
}
