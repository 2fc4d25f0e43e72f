//! Scenes of Mitsuba 3 in several files: included elements, and the folders in which files are
//! looked up.

use crate::{PART_OBJ, shown};
use forms_radiometry::scene::{Scene, SceneError, read_with_files};
use std::io;

/// Reads `scenes/box.xml` next to these files, whose paths are relative to its folder. A name
/// without contents is a folder.
fn read(scene: &str, others: &[(&str, Option<&str>)]) -> Result<Scene, Vec<SceneError>> {
    let files = |name: &str| match others.iter().find(|(other, _)| *other == name) {
        Some((_, Some(text))) => Ok(text.as_bytes().to_vec()),
        Some((_, None)) => Err(io::ErrorKind::IsADirectory.into()),
        None => Err(io::ErrorKind::NotFound.into()),
    };
    read_with_files(scene, "scenes/box.xml", &files)
}

fn names(scene: Result<Scene, Vec<SceneError>>) -> Vec<String> {
    let scene = scene.unwrap_or_else(|errors| panic!("{}", shown(&errors)));
    scene.surfaces.into_iter().map(|surface| surface.name).collect()
}

/// Returns the only error, as its file, line, column and message.
fn refused(scene: Result<Scene, Vec<SceneError>>) -> String {
    let errors = scene.map(|_| ()).expect_err("the scene has an error");
    let [error] = &errors[..] else { panic!("{}", shown(&errors)) };
    format!("{}:{}:{}: {}", error.file, error.line, error.column, error.message)
}

fn scene(elements: &str) -> String {
    format!("<scene version=\"3.0.0\">\n{elements}\n</scene>")
}

const MESH: &str = r#"<shape type="obj" id="part"><string name="filename" value="part.obj"/><boolean name="face_normals" value="true"/></shape>"#;

#[test]
fn included_elements_stand_in_the_order_of_the_text_and_share_parameters_and_ids() {
    let main = scene(
        r#"<default name="side" value="2"/><default name="kind" value="lower"/>
        <shape type="sphere" id="first"><ref id="white"/></shape>
        <include filename="parts/$kind.xml"/>
        <shape type="sphere" id="last"><float name="radius" value="$radius"/></shape>"#,
    );
    let lower = r#"<?xml version="1.0"?><!-- parts --><scene version="2.1.0">
        <default name="side" value="9"/><default name="radius" value="4"/>
        <bsdf type="diffuse" id="white"><float name="reflectance" value="0.75"/></bsdf>
        <include filename="parts/nested.xml"/>
    </scene>"#;
    let nested = r#"<scene><shape type="sphere" id="middle"><float name="radius" value="$side"/>
        <point name="center" x="50"/></shape></scene>"#;
    let main = main.replace("id=\"last\">", "id=\"last\"><point name=\"center\" y=\"50\"/>");
    let files = [("parts/lower.xml", Some(lower)), ("parts/nested.xml", Some(nested))];
    let read = || read(&main, &files);
    assert_eq!(names(read()), ["first", "middle", "last"]);
    let radius = |surface: &forms_radiometry::scene::Surface| match surface.shape {
        forms_radiometry::scene::Shape::Sphere(sphere) => sphere.radius,
        _ => f64::NAN,
    };
    assert_eq!(read().unwrap().surfaces.iter().map(radius).collect::<Vec<_>>(), [1.0, 2.0, 4.0]);
}

#[test]
fn an_error_in_an_included_file_is_reported_there_and_later_ones_in_the_scene() {
    let parts = "<scene>\n  <shape type=\"cone\"/>\n</scene>";
    let main = scene("<include filename=\"a.xml\"/>\n<shape type=\"wedge\"/>");
    let errors = read(&main, &[("a.xml", Some(parts))]).map(|_| ()).unwrap_err();
    let found: Vec<_> = errors.iter().map(|error| (&*error.file, error.line, error.column)).collect();
    assert_eq!(found, [("scenes/a.xml", 2, 16), ("scenes/box.xml", 3, 14)]);
}

#[test]
fn files_that_cannot_be_included_are_named_where_it_is_wrong() {
    let include = scene("<include filename=\"a.xml\"/>");
    let of_scene = |message: &str| format!("scenes/box.xml:2:20: {message}");
    let of_file = |place: &str, message: &str| format!("scenes/a.xml:{place}: {message}");
    let cases: &[(&str, String)] = &[
        ("<scene><shape></scene>", of_file("1:15", "expected 'shape' tag, not 'scene'")),
        ("<scene>\n<shape/>\n", of_file("2:9", "the root node was opened but never closed")),
        ("<shape type=\"cube\"/>", of_file("1:1", "the root of this included file is `shape`")),
        ("<scene version=\"0.5.0\"/>", of_file("1:17", "scene version `0.5.0` is not supported")),
        ("<scene><include filename=\"a.xml\"/></scene>", of_file("1:27", "the file `a.xml` includes itself")),
        ("<scene><include filename=\"b.xml\"/></scene>", of_file("1:27", "there is no file `b.xml`")),
        (
            "<scene><include file=\"b.xml\"/></scene>",
            of_file("1:17", "unknown attribute `file` of `include`"),
        ),
        ("<scene><include/></scene>", of_file("1:8", "this include has no `filename`")),
        ("<scene><include filename=\"$x\"/></scene>", of_file("1:27", "there is no parameter `x`")),
    ];
    for (text, message) in cases {
        let found = refused(read(&include, &[("a.xml", Some(text))]));
        assert_eq!(found, *message, "{text}");
    }
    assert_eq!(refused(read(&include, &[])), of_scene("there is no file `a.xml`"));
    let folder = refused(read(&include, &[("a.xml", None)]));
    assert!(folder.starts_with(&of_scene("the included file `a.xml` cannot be read: ")), "{folder}");
    let twice = scene("<include filename=\"a.xml\"/>\n<shape type=\"sphere\" id=\"ball\"/>");
    let ball = "<scene>\n<shape type=\"sphere\" id=\"ball\"/></scene>";
    assert_eq!(
        refused(read(&twice, &[("a.xml", Some(ball))])),
        "scenes/box.xml:3:26: the id `ball` is already defined in line 2 of `scenes/a.xml`"
    );
}

#[test]
fn chains_of_included_files_end() {
    let names: Vec<String> = (0..30).map(|number| format!("{number}.xml")).collect();
    let texts: Vec<String> =
        (1..31).map(|next| format!("<scene><include filename=\"{next}.xml\"/></scene>")).collect();
    let files: Vec<(&str, Option<&str>)> =
        names.iter().zip(&texts).map(|(name, text)| (&**name, Some(&**text))).collect();
    let found = refused(read(&scene("<include filename=\"0.xml\"/>"), &files));
    assert_eq!(found, "scenes/14.xml:1:27: the file `15.xml` is included too deeply");
}

#[test]
fn files_are_looked_up_beside_the_scene_and_then_in_each_folder() {
    let with_paths = |paths: &str| scene(&format!("{paths}{MESH}"));
    let other = format!("{PART_OBJ}\n# another file");
    let (here, there) = (with_paths("<path value=\"meshes\"/>"), Some(PART_OBJ));
    assert_eq!(names(read(&with_paths(""), &[("part.obj", there)])), ["part"]);
    assert_eq!(names(read(&here, &[("meshes/part.obj", there)])), ["part"]);
    // the same file twice is no conflict, two different ones are
    assert_eq!(names(read(&here, &[("meshes/part.obj", there), ("part.obj", there)])), ["part"]);
    let found = refused(read(&here, &[("meshes/part.obj", Some(&other)), ("part.obj", there)]));
    assert!(found.ends_with("there are different files `part.obj` and `meshes/part.obj`"), "{found}");
    let found = refused(read(&here, &[]));
    assert!(found.ends_with("there is no file `part.obj`"), "{found}");
    let found = refused(read(&with_paths("<path/>"), &[("part.obj", there)]));
    assert_eq!(found, "scenes/box.xml:2:1: this path has no `value`");
}

#[test]
fn a_folder_of_an_included_file_is_relative_to_that_file_or_else_to_the_scene() {
    let main = scene("<include filename=\"sub/a.xml\"/>");
    let included = format!("<scene><path value=\"../meshes\"/>{MESH}</scene>");
    let file = ("sub/a.xml", Some(&*included));
    let beside = [file, ("sub/../meshes", None), ("sub/../meshes/part.obj", Some(PART_OBJ))];
    assert_eq!(names(read(&main, &beside)), ["part"]);
    let of_scene = [file, ("../meshes", None), ("../meshes/part.obj", Some(PART_OBJ))];
    assert_eq!(names(read(&main, &of_scene)), ["part"]);
}
