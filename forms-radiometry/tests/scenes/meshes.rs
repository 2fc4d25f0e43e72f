//! Meshes: a mesh that is written and read is the same mesh, in every format; and errors of a file
//! are reported with their place in that file.

use crate::{Placed, check_places, shown};
use forms_radiometry::geometry::{Mesh, Vector};
use forms_radiometry::scene::{SceneError, Shape, read_with_files};
use std::fmt::Write;

fn scene_with(name: &str) -> String {
    format!(
        "[[material]]\nname = \"m\"\nkind = \"diffuse\"\nreflectance = 0\n[[surface]]\nname = \"part\"\n\
         material = \"m\"\nmesh = \"{name}\"\n"
    )
}

fn read(name: &str, bytes: &[u8]) -> Result<Mesh, Vec<SceneError>> {
    let scene = read_with_files(&scene_with(name), "rooms/box.toml", &|_| Ok(bytes.to_vec()))?;
    match &scene.surfaces[0].shape {
        Shape::Mesh(mesh) => Ok((**mesh).clone()),
        _ => panic!("the part is a mesh"),
    }
}

fn mesh(name: &str, bytes: &[u8]) -> Mesh {
    read(name, bytes).unwrap_or_else(|errors| panic!("{}", shown(&errors)))
}

/// Returns a cube whose top is four triangles, and whose coordinates have many digits.
fn cube() -> Mesh {
    let (low, high) = (std::f64::consts::PI, 1e5 / 3.0);
    let corner = |i: u32| {
        let at = |axis: u32| if i >> axis & 1 == 1 { high } else { low };
        Vector::new(at(0), at(1), at(2))
    };
    let mut vertices: Vec<Vector> = (0..8).map(corner).collect();
    vertices.push(Vector::new(0.5 * (low + high), 0.5 * (low + high), high));
    let quads = [[0, 2, 3, 1], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mut faces: Vec<Vec<u32>> = quads.iter().map(|face| face.to_vec()).collect();
    faces.extend([[4, 5, 8], [5, 7, 8], [7, 6, 8], [6, 4, 8]].map(|face| face.to_vec()));
    Mesh::new(vertices, &faces).unwrap()
}

fn obj(mesh: &Mesh) -> String {
    let mut text = String::new();
    for v in mesh.vertices() {
        writeln!(text, "v {} {} {}", v.x, v.y, v.z).unwrap();
    }
    for face in mesh.faces() {
        let corners: Vec<String> = face.iter().map(|i| (i + 1).to_string()).collect();
        writeln!(text, "f {}", corners.join(" ")).unwrap();
    }
    text
}

fn ply_head(mesh: &Mesh, format: &str, number: &str) -> String {
    format!(
        "ply\nformat {format} 1.0\ncomment cube\nelement vertex {}\nproperty {number} x\nproperty {number} y\n\
         property {number} z\nelement face {}\nproperty list uchar uint vertex_index\nproperty uchar red\nend_header\n",
        mesh.vertices().len(),
        mesh.faces().len()
    )
}

fn ply_text(mesh: &Mesh) -> String {
    let mut text = ply_head(mesh, "ascii", "double");
    for v in mesh.vertices() {
        writeln!(text, "{} {} {}", v.x, v.y, v.z).unwrap();
    }
    for face in mesh.faces() {
        let corners: Vec<String> = face.iter().map(u32::to_string).collect();
        writeln!(text, "{} {} 255", face.len(), corners.join(" ")).unwrap();
    }
    text
}

fn ply_bytes(mesh: &Mesh, big: bool) -> Vec<u8> {
    let format = if big { "binary_big_endian" } else { "binary_little_endian" };
    let mut file = ply_head(mesh, format, "double").into_bytes();
    let double = |x: f64| if big { x.to_be_bytes() } else { x.to_le_bytes() };
    let whole = |i: u32| if big { i.to_be_bytes() } else { i.to_le_bytes() };
    for v in mesh.vertices() {
        [v.x, v.y, v.z].iter().for_each(|&x| file.extend(double(x)));
    }
    for face in mesh.faces() {
        file.push(face.len() as u8);
        face.iter().for_each(|&i| file.extend(whole(i)));
        file.push(255);
    }
    file
}

#[test]
fn what_is_written_and_read_is_the_same_mesh_to_the_last_bit() {
    let cube = cube();
    assert_eq!(mesh("part.obj", obj(&cube).as_bytes()), cube);
    assert_eq!(mesh("part.ply", ply_text(&cube).as_bytes()), cube);
    assert_eq!(mesh("part.PLY", &ply_bytes(&cube, false)), cube);
    assert_eq!(mesh("part.ply", &ply_bytes(&cube, true)), cube);
}

#[test]
fn lines_may_end_as_they_do_on_other_systems() {
    let cube = cube();
    assert_eq!(mesh("part.obj", obj(&cube).replace('\n', "\r\n").as_bytes()), cube);
    assert_eq!(mesh("part.ply", ply_text(&cube).replace('\n', "\r\n").as_bytes()), cube);
}

#[test]
fn an_obj_may_say_more_than_the_shape() {
    let text = "# a square\nmtllib a.mtl\no part\nv 0 0 0 1 1 1\nv 1 0 0 1\nv 1 1 0 # corner\nv 0 1 0\nvt 0 0\nvn 0 0 1\n\
                g side\nusemtl white\ns off\nf 1/1/1 2//1 3/1 \\\n  -1\n";
    let square = mesh("part.obj", text.as_bytes());
    assert_eq!(square.faces().collect::<Vec<_>>(), [[0, 1, 2, 3]]);
    assert_eq!(square.vertices()[2], Vector::new(1.0, 1.0, 0.0));
}

#[test]
fn a_ply_may_say_more_than_the_shape_in_any_order() {
    let text = "ply\nformat ascii 1.0\nelement camera 1\nproperty list char float view\nelement face 1\n\
                property list uchar int vertex_indices\nproperty list uchar float uv\nelement vertex 3\nproperty float nx\n\
                property float z\nproperty float y\nproperty float x\nend_header\n2 0.5 0.5\n\n3 0 1 2 2 1 1\n9 0 0 0\n9 0 0 1\n9 0 1 0\n";
    let triangle = mesh("part.ply", text.as_bytes());
    assert_eq!(triangle.vertices()[1], Vector::new(1.0, 0.0, 0.0));
    assert_eq!(triangle.faces().collect::<Vec<_>>(), [[0, 1, 2]]);
}

const OBJ: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

/// Errors of the OBJ file.
const OF_OBJ: &[Placed] = &[
    ("v 1 1 0", "v 1 1", (3, 1), "a vertex has 2 values"),
    ("v 1 1 0", "v 1 1 O", (3, 7), "`O` is not a number"),
    ("v 1 1 0", "v 1 1 nan", (3, 7), "a coordinate is not finite"),
    ("v 1 1 0", "v 1 1 1e153", (3, 7), "a coordinate is out of range"),
    ("v 1 1 0", "surf 0 1 0 1 1 2 3 4", (3, 1), "free-form surfaces are not supported"),
    ("v 1 1 0", "w 1", (3, 1), "the statement `w` is not supported"),
    ("f 1 2 3 4", "f 1 2 3 5", (5, 1), "face 1: there is no vertex 5"),
    ("f 1 2 3 4", "f 1 2 3 -5", (5, 9), "there is no vertex -5"),
    ("f 1 2 3 4", "f 0 1 2 3", (5, 3), "there is no vertex 0"),
    ("f 1 2 3 4", "f 1 2 3/x 4", (5, 7), "`3/x` is not a vertex reference"),
    ("f 1 2 3 4", "f 1 2 3/1/1/1 4", (5, 7), "`3/1/1/1` is not a vertex reference"),
    ("f 1 2 3 4", "f 1 3 2 4", (5, 1), "face 1: the polygon encloses no area"),
    (
        "v 0 1 0\nf 1 2 3 4",
        "v 0 2 0\nf 1 3 2 4",
        (5, 1),
        "face 1: the edges from vertex 1 and from vertex 3 cross",
    ),
];

const PLY: &str = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
                   element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

/// Errors of the PLY file.
const OF_PLY: &[Placed] = &[
    ("ply\n", "plx\n", (1, 1), "the file does not begin with `ply`"),
    ("format ascii 1.0", "format ascii 2.0", (2, 1), "this line is not valid in a PLY header"),
    ("format ascii 1.0", "format text 1.0", (2, 8), "`text` is unknown"),
    ("format ascii 1.0", "", (9, 1), "the header has no `format` line"),
    ("element vertex 3", "element vertex three", (3, 16), "`three` is not an integer"),
    ("element vertex 3", "element vertex -3", (3, 16), "the number of rows is negative"),
    ("element vertex 3\n", "", (3, 1), "the property is declared before any element"),
    ("property float z", "property float w", (3, 1), "the vertices have no `z`"),
    ("property float z", "property half z", (6, 10), "`half` is unknown"),
    ("property float z", "property float", (6, 1), "invalid property declaration"),
    ("list uchar int", "list float int", (8, 15), "the length of a list does not have an integer type"),
    ("vertex_indices", "corners", (7, 1), "the faces have no vertices"),
    ("element face 1", "element edge 1\nelement face 1", (7, 1), "the element `edge` has no properties"),
    ("end_header\n", "", (9, 1), "this line is not valid in a PLY header"),
    ("1 0 0", "1 0", (11, 4), "the line has too few numbers"),
    ("1 0 0", "1 0 zero", (11, 5), "`zero` is not a number"),
    ("1 0 0", "1 0 inf", (11, 5), "a coordinate is not finite"),
    ("3 0 1 2", "3 0 1 3", (13, 1), "face 1: there is no vertex 4"),
    ("3 0 1 2", "3 0 1 -2", (13, 7), "there is no vertex -2"),
    ("3 0 1 2", "3 0 1 2.5", (13, 7), "`2.5` is not an integer"),
    ("3 0 1 2", "300 0 1 2", (13, 1), "300 is out of range for its type"),
    ("3 0 1 2\n", "", (13, 1), "the file ends before face 1 of 1"),
];

/// Text that is replaced in the OBJ file, its replacement, and the note on the faces that are read in
/// another way than they are written.
const NOTED: &[(&str, &str, &str)] = &[
    ("f 1 2 3 4", "f 1 2 3 4\nf 1 2", "1 face was dropped for want of an area"),
    ("f 1 2 3 4", "f 1 2 3 4\nf 1 2 2\nf 1 2 1", "2 faces were dropped for want of an area"),
    ("f 1 2 3 4", "f 1 2 3 4\nf 3 4 1 2", "1 face was dropped, being there twice"),
    ("f 1 2 3 4", "f 1 2 3 4\nv 0 0 0\nf 4 5 2 3", "1 face was dropped, being there twice"),
    ("f 1 2 3 4", "f 1 2 2 3", "1 face was read without a repeated vertex"),
    ("v 1 1 0", "v 1 1 0.5", "1 face was divided into triangles, not being planar"),
];

#[test]
fn each_kind_of_face_that_is_changed_is_noted_once() {
    for &(from, to, note) in NOTED {
        let text = OBJ.replacen(from, to, 1);
        let scene = read_with_files(&scene_with("part.obj"), "rooms/box.toml", &|_| Ok(text.clone().into()));
        let scene = scene.unwrap_or_else(|errors| panic!("{}", shown(&errors)));
        assert_eq!(scene.notes, [format!("rooms/part.obj: {note}")]);
    }
}

#[test]
fn a_face_and_its_reverse_are_two_sides() {
    let text = OBJ.replacen("f 1 2 3 4", "f 1 2 3 4\nf 4 3 2 1", 1);
    let scene = read_with_files(&scene_with("part.obj"), "rooms/box.toml", &|_| Ok(text.clone().into()));
    assert!(scene.unwrap_or_else(|errors| panic!("{}", shown(&errors))).notes.is_empty());
}

#[test]
fn a_mesh_without_faces_is_left_out_and_no_receiver_can_name_it() {
    let receiver = "[[receiver]]\nname = \"r\"\nkind = \"surface\"\nsurface = \"part\"\n";
    let read = |text: &str| read_with_files(text, "box.toml", &|_| Ok("v 0 0 0\np 1\n".into()));
    let scene = read(&scene_with("part.obj")).unwrap_or_else(|errors| panic!("{}", shown(&errors)));
    assert!(scene.surfaces.is_empty());
    assert_eq!(scene.notes, ["the surface `part` has no faces, and is left out"]);
    let errors = read(&(scene_with("part.obj") + receiver)).unwrap_err();
    assert_eq!(errors[0].message, "the surface `part` has no faces, and is left out");
}

#[test]
fn each_error_is_reported_at_its_place_in_its_file() {
    for (name, text, cases) in [("part.obj", OBJ, OF_OBJ), ("part.ply", PLY, OF_PLY)] {
        mesh(name, text.as_bytes());
        check_places(text, cases, |damaged| {
            let found = read(name, damaged.as_bytes()).expect_err(damaged);
            assert!(found.len() == 1 && found[0].file == format!("rooms/{name}"), "{}", shown(&found));
            found
        });
    }
}

#[test]
fn an_error_among_bytes_names_the_row_and_the_byte_and_quotes_the_header() {
    let file = ply_bytes(&cube(), false);
    let found = read("part.ply", &file[..file.len() - 1]).unwrap_err();
    let expected = format!(
        "rooms/part.ply:8:1: face 9 (byte {}): the file ends within this row\n  |\n\
         8 | element face 9\n  | ^^^^^^^^^^^^^^\n  = expected as many rows as the header declares",
        file.len() - 14
    );
    assert_eq!(shown(&found), expected);
}

#[test]
fn of_many_errors_the_first_are_told() {
    let found = read("part.obj", "v 0 0\n".repeat(100).as_bytes()).unwrap_err();
    assert_eq!(found.len(), 21);
    assert_eq!(found[20].to_string(), "rooms/part.obj: 80 more errors");
}

#[test]
fn a_file_is_read_once_for_all_surfaces_that_name_it() {
    let text = scene_with("part.obj");
    let (head, surface) = text.split_at(text.find("[[surface]]").unwrap());
    let text = format!("{head}{surface}{}", surface.replace("\"part\"", "\"other\""));
    let count = std::cell::Cell::new(0);
    let found = read_with_files(&text, "box.toml", &|_| {
        count.set(count.get() + 1);
        Ok(OBJ.into())
    });
    // both lie in the same place, and that is the only error
    let found = found.expect_err("an overlap");
    assert!(found.len() == 1 && found[0].message.starts_with("`other` overlaps `part`"), "{}", shown(&found));
    assert_eq!(count.get(), 1);
}
