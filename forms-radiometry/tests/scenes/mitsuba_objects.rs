//! Objects of Mitsuba 3 that other objects contain or refer to: instances, shared emitters, nested
//! integrators; and the normals of meshes.

use crate::{errors, scene, shown};
use forms_radiometry::geometry::Vector;
use forms_radiometry::scene::{MaterialKind, ReceiverKind, Scene, SceneError, Shape, read_with_files};
use forms_radiometry::simulation::plan;

const FILE: &str = "box.xml";
const EYE: &str = "<sensor type=\"perspective\"/>";

fn text(elements: &str) -> String {
    format!("<scene version=\"3.0.0\">{elements}</scene>")
}

fn first_error(elements: &str) -> String {
    errors(&text(elements), FILE)[0].message.clone()
}

#[test]
fn a_camera_without_field_of_view_has_film_of_36_by_24_mm_and_a_focal_length_of_50_mm() {
    let corner = |inside: &str| {
        let scene = scene(&text(&format!("<sensor type=\"perspective\">{inside}</sensor>")), FILE);
        let ReceiverKind::Camera(camera) = &scene.receivers[0].kind else { panic!("a camera") };
        assert_eq!(camera.resolution, [768, 576]);
        let corner = camera.direction(768.0, 0.0);
        corner.x.hypot(corner.y)
    };
    let diagonal = 36_f64.hypot(24.0);
    assert!((corner("") - 0.5 * diagonal / 50.0).abs() < 1e-14);
    let long = "<string name=\"focal_length\" value=\"100mm\"/><float name=\"focus_distance\" value=\"3\"/>";
    assert!((corner(long) - 0.5 * diagonal / 100.0).abs() < 1e-14);
}

#[test]
fn films_and_samplers_can_stand_elsewhere_and_a_whole_window_is_no_window() {
    let elements = r#"<film type="hdrfilm" id="film"><integer name="width" value="8"/><integer name="height" value="4"/>
        <integer name="crop_width" value="8"/><integer name="crop_offset_x" value="0"/></film>
        <sampler type="independent" id="sampler"/>
        <sensor type="perspective"><ref id="film"/><ref id="sampler"/></sensor>"#;
    let scene = scene(&text(elements), FILE);
    let ReceiverKind::Camera(camera) = &scene.receivers[0].kind else { panic!("a camera") };
    assert_eq!(camera.resolution, [8, 4]);
}

#[test]
fn an_emitter_is_shared_by_the_shapes_that_refer_to_it_also_by_another_name() {
    let elements = r#"<emitter type="area" id="glow"><float name="radiance" value="3"/></emitter>
        <alias id="glow" as="light"/>
        <shape type="sphere"><ref id="glow"/></shape>
        <shape type="sphere"><point name="center" x="9"/><ref id="light"/></shape>
        <emitter type="constant"/>"#;
    let scene = scene(&text(elements), FILE);
    let radiances: Vec<_> = scene.surfaces.iter().map(|surface| surface.radiance.clone()).collect();
    assert_eq!(radiances, [[3.0], [3.0]]);
    assert_eq!(scene.ambient.radiance, [1.0]);
}

#[test]
fn each_instance_is_surfaces_where_both_transforms_put_them() {
    let elements = r#"<shape type="shapegroup" id="group">
            <shape type="sphere" id="ball"><transform name="to_world"><translate x="1"/></transform></shape>
            <shape type="rectangle"/>
        </shape>
        <shape type="instance" id="here"><ref id="group"/></shape>
        <shape type="instance" id="there"><ref id="group"/><transform name="to_world">
            <scale value="2"/><translate z="9"/></transform></shape>"#;
    let scene = scene(&text(elements), FILE);
    let names: Vec<_> = scene.surfaces.iter().map(|surface| &*surface.name).collect();
    assert_eq!(names, ["here/ball", "here/shape 2", "there/ball", "there/shape 4"]);
    let balls = scene.surfaces.iter().filter_map(|surface| match surface.shape {
        Shape::Sphere(sphere) => Some((sphere.center, sphere.radius)),
        _ => None,
    });
    let expected = [(Vector::new(1.0, 0.0, 0.0), 1.0), (Vector::new(2.0, 0.0, 9.0), 2.0)];
    assert_eq!(balls.collect::<Vec<_>>(), expected);
    assert_eq!(scene.surfaces[3].shape.as_polygon().unwrap().vertices()[0], Vector::new(-2.0, -2.0, 9.0));
}

#[test]
fn a_cylinder_keeps_its_shape_wherever_it_is_placed() {
    let elements = r#"<shape type="cylinder" id="pipe"><point name="p0" x="0" y="0" z="1"/><float name="radius" value="0.5"/>
        <point name="p1" x="0" y="0" z="3"/><boolean name="flip_normals" value="true"/>
        <transform name="to_world"><scale value="2"/><rotate x="1" angle="90"/><translate x="7"/></transform></shape>"#;
    let scene = scene(&text(elements), FILE);
    let Shape::Quadric(pipe) = scene.surfaces[0].shape else { panic!("a cylinder") };
    let ends = [Vector::new(7.0, -2.0, 0.0), Vector::new(7.0, -6.0, 0.0)];
    assert!((0..2).all(|end| (pipe.ends[end] - ends[end]).length() < 1e-14), "{:?}", pipe.ends);
    assert_eq!((pipe.radii, pipe.inward), ([1.0; 2], true));
    let uneven = r#"<shape type="cylinder"><transform name="to_world"><scale z="2"/></transform></shape>"#;
    assert_eq!(first_error(uneven), "non-uniform scaling of a cylinder is not supported");
    let flat = r#"<shape type="cylinder"><point name="p1" x="0" y="0" z="0"/></shape>"#;
    assert_eq!(first_error(flat), "both ends of the cylinder are the same point");
}

#[test]
fn groups_contain_neither_groups_nor_emitters_nor_sensors() {
    let group = |inside: &str| {
        format!(
            "<shape type=\"shapegroup\" id=\"g\">{inside}</shape><shape type=\"instance\" id=\"i\"><ref id=\"g\"/></shape>"
        )
    };
    let cases = [
        (
            "<shape type=\"instance\"><ref id=\"g\"/></shape>",
            "a shape of type `instance` cannot be part of a group",
        ),
        ("<ref id=\"i\"/>", "a shape of type `instance` cannot be part of a group"),
        ("<ref id=\"g\"/>", "a shape of type `shapegroup` cannot be part of a group"),
        (
            "<shape type=\"sphere\"><emitter type=\"area\"/></shape>",
            "the shapes of a group cannot have emitters",
        ),
        (
            "<shape type=\"sphere\"><sensor type=\"irradiancemeter\"/></shape>",
            "the shapes of a group cannot have sensors",
        ),
        ("<shape type=\"cone\"/>", "a shape of type `cone` is not supported"),
        (
            "<float name=\"x\" value=\"1\"/>",
            "`float` named `x` is not supported in a shape of type `shapegroup`",
        ),
    ];
    for (inside, message) in cases {
        assert_eq!(first_error(&group(inside)), message, "{inside}");
    }
}

#[test]
fn integrators_of_further_quantities_are_read_as_the_one_they_contain() {
    let nested = |kind: &str| {
        format!(
            "<integrator type=\"{kind}\"><integrator type=\"path\"><integer name=\"max_depth\" value=\"1\"/></integrator></integrator>{EYE}"
        )
    };
    for kind in ["moment", "aov", "stokes"] {
        let scene = scene(&text(&format!("{}<shape type=\"sphere\"/>", nested(kind))), FILE);
        let black = MaterialKind::Diffuse { reflectance: vec![0.0] };
        assert_eq!(scene.materials[0].kind, black, "{kind}");
        assert_eq!(scene.notes, ["`max_depth` = 1 is read as black surfaces: a camera sees emitters only"]);
    }
    let mirror = "<shape type=\"sphere\"><bsdf type=\"conductor\"/></shape>";
    let stokes = "<integrator type=\"stokes\"><integrator type=\"path\"/></integrator>";
    let circle = "<integrator type=\"moment\" id=\"a\"><ref id=\"a\"/></integrator>";
    let named =
        "<default name=\"k\" value=\"moment\"/><integrator type=\"$k\" id=\"a\"><ref id=\"a\"/></integrator>";
    let deep = "integrators are only supported within each other up to three deep";
    let hidden = "<integrator type=\"path\"><boolean name=\"hide_emitters\" value=\"True\"/></integrator>";
    let cases = [
        (
            format!("{stokes}{mirror}"),
            "polarised light is only supported for diffuse surfaces, which depolarise it",
        ),
        ("<integrator type=\"moment\"/>".to_owned(), "this integrator contains no integrator"),
        (circle.to_owned(), deep),
        (named.to_owned(), deep),
        (
            format!("{hidden}<emitter type=\"constant\"/>"),
            "emitters hidden from the camera are not supported",
        ),
    ];
    for (elements, message) in cases {
        assert_eq!(first_error(&elements), message, "{elements}");
    }
    // nothing that shines can be seen
    assert_eq!(scene(&text(hidden), FILE).notes, [""; 0]);
}

#[test]
fn an_unsupported_kind_is_reported_once() {
    let texture = "<bsdf type=\"diffuse\"><texture type=\"volume\" name=\"reflectance\"/></bsdf>";
    let shape = format!("<shape type=\"sphere\">{texture}</shape>");
    let found =
        errors(&text(&format!("{shape}{shape}{shape}<shape type=\"cone\"/><shape type=\"cone\"/>")), FILE);
    let messages: Vec<_> = found.iter().map(|error| &*error.message).collect();
    let expected = ["a texture of type `volume` is not supported", "a shape of type `cone` is not supported"];
    assert_eq!(messages, expected);
}

/// Reads a scene with this mesh, whose normals are interpolated.
fn with_mesh(mesh: &str, rest: &str) -> Result<Scene, Vec<SceneError>> {
    let shape = format!("<shape type=\"obj\"><string name=\"filename\" value=\"m.obj\"/>{rest}");
    read_with_files(&text(&shape), FILE, &|_| Ok(mesh.into()))
}

/// Whether light is scattered by interpolated normals.
fn is_smooth(scene: &Scene) -> bool {
    let methods = format!("{:?}", plan(scene).unwrap().receiver_methods());
    methods.contains("has interpolated normals")
}

/// Two triangles that meet at an angle, in a plane but for one vertex at this height.
fn bent(height: f64) -> String {
    format!("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 {height}\nf 1 2 3\nf 1 3 4\n")
}

#[test]
fn interpolated_normals_are_no_normals_of_emission_or_irradiance() {
    let is_read = |rest: &str| {
        let rest = rest.replace("EYE", EYE);
        with_mesh(&bent(0.5), &rest).map_err(|errors| {
            assert!(
                shown(&errors).contains("by interpolated normals are not supported"),
                "{}",
                shown(&errors)
            );
        })
    };
    let black = "<bsdf type=\"diffuse\"><float name=\"reflectance\" value=\"0\"/></bsdf>";
    let glow = "<emitter type=\"area\"><float name=\"radiance\" value=\"1\"/></emitter>";
    let meter = "<sensor type=\"irradiancemeter\"><film type=\"hdrfilm\"><integer name=\"width\" value=\"1\"/>\
                 <integer name=\"height\" value=\"1\"/></film></sensor>";
    let cases = [
        ("</shape>".to_owned(), true),
        ("</shape>EYE".to_owned(), true),
        (format!("{black}</shape>EYE"), true),
        (format!("{black}{glow}</shape>EYE"), false),
        (format!("{black}{meter}</shape>"), false),
        ("<boolean name=\"face_normals\" value=\"true\"/></shape>EYE".to_owned(), true),
    ];
    for (rest, expected) in cases {
        assert_eq!(is_read(&rest).is_ok(), expected, "{rest}");
    }
}

#[test]
fn normals_that_differ_little_from_those_of_the_faces_are_noted_on_diffuse_surfaces() {
    let diffuse = format!("</shape>{EYE}");
    let mirror = format!("<bsdf type=\"conductor\"/></shape>{EYE}");
    let scene = with_mesh(&bent(0.01), &diffuse).unwrap();
    let note =
        "m.obj: the normals of the faces are used, from which interpolated normals differ by up to 0.41°";
    assert_eq!(scene.notes, [note]);
    assert!(!is_smooth(&scene));
    for (height, text) in [(0.01, &mirror), (0.1, &diffuse), (0.0, &mirror)] {
        let scene = with_mesh(&bent(height), text).unwrap();
        assert_eq!(scene.notes, [""; 0]);
        assert_eq!(is_smooth(&scene), text == &diffuse, "{height}");
    }
}

#[test]
fn normals_in_a_file_are_compared_with_those_of_its_faces() {
    let file = |normal: &str, face: &str| format!("v 0 0 0\nv 1 0 0\nv 1 1 0\n{normal}\nf {face}\n");
    let cases = [
        ("vn 0 0 2", "1//1 2//1 3//1", false),
        ("vn 0 0 1", "1//-1 2//-1 3//-1", false),
        ("vn 0 0 -1", "1//1 2//1 3//1", true),
        ("vn 0 0.1 1", "1//1 2//1 3//1", true),
        ("vn 0 0 1", "1 2 3", false),
        ("vn 0 0 1", "1//1 2//1 3//2", false),
        ("vn 0 0", "1//1 2//1 3//1", false),
    ];
    for (normal, face, expected) in cases {
        let read = with_mesh(&file(normal, face), &format!("</shape>{EYE}"));
        assert_eq!(is_smooth(&read.unwrap()), expected, "{normal} {face}");
    }
}
