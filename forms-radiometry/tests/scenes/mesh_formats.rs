//! Formats of meshes: one box, written in every format and encoding, is the same box; its lid is a
//! group wherever the format has groups.

use crate::shown;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use forms_radiometry::geometry::{Mesh, Vector};
use forms_radiometry::scene::{Scene, SceneError, Shape, read_with_files};
use std::fmt::Write;

/// The corners of the box, and its faces; the first is the lid.
const SIDES: [f64; 3] = [1.0, 2.0, 0.5];
const FACES: [[usize; 4]; 6] =
    [[4, 5, 7, 6], [0, 2, 3, 1], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
const VOLUME: f64 = 1.0;
const LID: f64 = 2.0;

fn corners() -> Vec<[f64; 3]> {
    (0..8).map(|i| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { SIDES[axis] } else { 0.0 })).collect()
}

/// The faces as triangles; the first two are the lid.
fn triangles() -> Vec<[usize; 3]> {
    FACES.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect()
}

pub(crate) fn read(name: &str, bytes: &[u8], keys: &str) -> Result<Scene, Vec<SceneError>> {
    let text = format!(
        "[[material]]\nname = \"m\"\nkind = \"diffuse\"\nreflectance = 0\n[[surface]]\nname = \"box\"\n\
         material = \"m\"\nmesh = \"{name}\"\n{keys}\n"
    );
    read_with_files(&text, "scene.toml", &|_| Ok(bytes.to_vec()))
}

pub(crate) fn meshes(name: &str, bytes: &[u8], keys: &str) -> Vec<(String, Mesh)> {
    meshes_of(&read(name, bytes, keys).unwrap_or_else(|errors| panic!("{name}: {}", shown(&errors))))
}

pub(crate) fn meshes_of(scene: &Scene) -> Vec<(String, Mesh)> {
    let mesh = |shape: &Shape| match shape {
        Shape::Mesh(mesh) => (**mesh).clone(),
        _ => panic!("a mesh"),
    };
    scene.surfaces.iter().map(|surface| (surface.name.clone(), mesh(&surface.shape))).collect()
}

/// The volume by the divergence theorem: ⅓ Σ A n·x over the faces.
fn volume(mesh: &Mesh) -> f64 {
    mesh.polygons().map(|face| face.area() * face.normal().dot(face.vertices()[0]) / 3.0).sum()
}

fn area(mesh: &Mesh) -> f64 {
    mesh.polygons().map(|face| face.area()).sum()
}

pub(crate) fn stl_text() -> Vec<u8> {
    let corners = corners();
    let mut text = String::new();
    for (name, range) in [("lid", 0..2), ("rest", 2..12)] {
        writeln!(text, "solid {name}").unwrap();
        for triangle in &triangles()[range] {
            text += " facet normal 0 0 0\n  outer loop\n";
            for [x, y, z] in triangle.map(|corner| corners[corner]) {
                writeln!(text, "   vertex {x:e} {y} {z}").unwrap();
            }
            text += "  endloop\n endfacet\n";
        }
        writeln!(text, "endsolid {name}").unwrap();
    }
    text.into()
}

fn stl_bytes() -> Vec<u8> {
    let mut file = b"solid, says this header, but the triangles are binary".to_vec();
    file.resize(80, b' ');
    file.extend(12u32.to_le_bytes());
    let corners = corners();
    for triangle in triangles() {
        file.extend([0; 12]);
        triangle.iter().flat_map(|&i| corners[i]).for_each(|x| file.extend((x as f32).to_le_bytes()));
        file.extend([0; 2]);
    }
    file
}

/// The box in version 2.2 of gmsh, with an edge as an element of another kind.
fn gmsh_2(is_binary: bool) -> Vec<u8> {
    let mut file = format!("$MeshFormat\n2.2 {} 8\n", u8::from(is_binary)).into_bytes();
    let int = |file: &mut Vec<u8>, i: usize| file.extend((i as i32).to_le_bytes());
    let text = |file: &mut Vec<u8>, text: &str| file.extend(text.as_bytes());
    if is_binary {
        int(&mut file, 1);
        text(&mut file, "\n");
    }
    text(&mut file, "$EndMeshFormat\n$PhysicalNames\n1\n2 7 \"lid\"\n$EndPhysicalNames\n$Nodes\n8\n");
    for (number, [x, y, z]) in corners().into_iter().enumerate() {
        if is_binary {
            int(&mut file, number + 10);
            [x, y, z].iter().for_each(|x| file.extend(x.to_le_bytes()));
        } else {
            text(&mut file, &format!("{} {x} {y} {z}\n", number + 10));
        }
    }
    text(&mut file, "$EndNodes\n$Comments\nof the author\n$EndComments\n$Elements\n7\n");
    let mut elements = vec![(1, vec![0, 1], 0)];
    elements.extend(
        FACES.iter().enumerate().map(|(face, corners)| (3, corners.to_vec(), if face == 0 { 7 } else { 0 })),
    );
    for (number, (kind, nodes, group)) in elements.iter().enumerate() {
        let row = [number + 1, *group, 1].into_iter().chain(nodes.iter().map(|node| node + 10));
        if is_binary {
            [*kind, 1, 2].into_iter().chain(row).for_each(|i| int(&mut file, i));
        } else {
            let row: Vec<String> = row.map(|i| i.to_string()).collect();
            text(&mut file, &format!("{} {kind} 2 {}\n", row[0], row[1..].join(" ")));
        }
    }
    text(&mut file, "$EndElements\n");
    file
}

/// The box in version 4.1 of gmsh, with a surface of its own for the lid.
fn gmsh_4(is_binary: bool) -> Vec<u8> {
    let mut file = format!("$MeshFormat\n4.1 {} 8\n", u8::from(is_binary)).into_bytes();
    let put = |file: &mut Vec<u8>, ints: &[i32], sizes: &[u64]| {
        if is_binary {
            ints.iter().for_each(|i| file.extend(i.to_le_bytes()));
            sizes.iter().for_each(|i| file.extend(i.to_le_bytes()));
        } else {
            let ints = ints.iter().map(|i| i.to_string()).chain(sizes.iter().map(|i| i.to_string()));
            file.extend((ints.collect::<Vec<_>>().join(" ") + "\n").bytes());
        }
    };
    let reals = |file: &mut Vec<u8>, reals: &[f64]| {
        if is_binary {
            reals.iter().for_each(|x| file.extend(x.to_le_bytes()));
        } else {
            file.extend((reals.iter().map(|x| x.to_string()).collect::<Vec<_>>().join(" ") + "\n").bytes());
        }
    };
    if is_binary {
        file.extend(1i32.to_le_bytes());
        file.push(b'\n');
    }
    file.extend(b"$EndMeshFormat\n$PhysicalNames\n1\n2 7 \"lid\"\n$EndPhysicalNames\n$Entities\n");
    put(&mut file, &[], &[0, 0, 2, 0]);
    for (surface, groups) in [(1, &[7][..]), (2, &[])] {
        put(&mut file, &[surface], &[]);
        reals(&mut file, &[0.0, 0.0, 0.0, 1.0, 2.0, 0.5]);
        put(&mut file, &[], &[groups.len() as u64]);
        put(&mut file, groups, &[]);
        put(&mut file, &[], &[0]);
    }
    file.extend(b"\n$EndEntities\n$Nodes\n");
    put(&mut file, &[], &[1, 8, 10, 17]);
    put(&mut file, &[2, 1, 0], &[8]);
    (10..18).for_each(|tag| put(&mut file, &[], &[tag]));
    corners().iter().for_each(|corner| reals(&mut file, corner));
    file.extend(b"\n$EndNodes\n$Elements\n");
    put(&mut file, &[], &[2, 6, 1, 6]);
    for (surface, faces) in [(1, &FACES[..1]), (2, &FACES[1..])] {
        put(&mut file, &[2, surface, 3], &[faces.len() as u64]);
        for face in faces {
            let nodes = face.map(|corner| corner as u64 + 10);
            put(&mut file, &[], &[1, nodes[0], nodes[1], nodes[2], nodes[3]]);
        }
    }
    file.extend(b"\n$EndElements\n");
    file
}

fn joined<T: ToString>(items: impl IntoIterator<Item = T>) -> String {
    items.into_iter().map(|item| item.to_string()).collect::<Vec<_>>().join(" ")
}

fn vtk_polygons(is_binary: bool) -> Vec<u8> {
    let encoding = if is_binary { "BINARY" } else { "ASCII" };
    let mut file =
        format!("# vtk DataFile Version 3.0\na box\n{encoding}\nDATASET POLYDATA\nPOINTS 8 double\n")
            .into_bytes();
    if is_binary {
        corners().concat().iter().for_each(|x| file.extend(x.to_be_bytes()));
    } else {
        file.extend(joined(corners().concat()).bytes());
    }
    file.extend(b"\nPOLYGONS 6 30\n");
    for face in FACES {
        let row = [4].into_iter().chain(face);
        if is_binary {
            row.for_each(|i| file.extend((i as i32).to_be_bytes()));
        } else {
            file.extend((joined(row) + "\n").bytes());
        }
    }
    file.extend(b"\nCELL_DATA 6\nSCALARS t float 1\n");
    file
}

/// A grid of version 5, with a pixel for the lid.
fn vtk_grid() -> Vec<u8> {
    let mut faces = FACES.map(|face| face.to_vec());
    faces[0] = vec![4, 5, 6, 7];
    let text = format!(
        "# vtk DataFile Version 5.1\na box\nASCII\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\nTIME 1 1 double\n0\n\
         POINTS 8 float\n{}\nMETADATA\nINFORMATION 0\n\nCELLS 7 24\nOFFSETS vtktypeint64\n0 4 8 12 16 20 24\n\
         CONNECTIVITY vtktypeint64\n{}\nCELL_TYPES 6\n8 9 9 9 9 7\n",
        joined(corners().concat()),
        joined(faces.concat())
    );
    text.into()
}

pub(crate) fn vtu() -> Vec<u8> {
    let array = |kind: &str, name: &str, numbers: String| {
        format!("<DataArray type=\"{kind}\" Name=\"{name}\" format=\"ascii\">{numbers}</DataArray>")
    };
    let points = joined(corners().concat());
    let text = format!(
        "<?xml version=\"1.0\"?><VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\
         <UnstructuredGrid><Piece NumberOfPoints=\"8\" NumberOfCells=\"6\"><Points>\
         <DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">{points}</DataArray></Points><Cells>\
         {}{}{}</Cells></Piece></UnstructuredGrid></VTKFile>",
        array("Int64", "connectivity", joined(FACES.concat())),
        array("Int64", "offsets", "4 8 12 16 20 24".to_owned()),
        array("UInt8", "types", "9 9 9 9 9 9".to_owned()),
    );
    text.into()
}

/// The lid and the rest as two nodes; a node above them doubles the coordinates of half a box, and
/// mirrors it.
pub(crate) fn gltf() -> Vec<u8> {
    let mut data: Vec<u8> =
        corners().concat().iter().flat_map(|x| ((-0.5 * x) as f32).to_le_bytes()).collect();
    // the reflection of the coordinates turns fronts to the inside, and this order turns them back
    let turned = triangles().into_iter().flat_map(|[a, b, c]| [a, c, b]);
    turned.for_each(|i| data.extend((i as u16).to_le_bytes()));
    let text = format!(
        "{{\"asset\": {{\"version\": \"2.0\"}}, \"scene\": 0, \"scenes\": [{{\"nodes\": [0]}}],\n\
         \"nodes\": [{{\"scale\": [-2, -2, -2], \"children\": [1, 2]}}, {{\"name\": \"lid\", \"mesh\": 0}}, {{\"name\": \"rest\", \"mesh\": 1}}],\n\
         \"meshes\": [{{\"primitives\": [{{\"attributes\": {{\"POSITION\": 0}}, \"indices\": 1}}]}},\n\
         {{\"primitives\": [{{\"attributes\": {{\"POSITION\": 0}}, \"indices\": 2}}]}}],\n\
         \"accessors\": [{{\"bufferView\": 0, \"componentType\": 5126, \"count\": 8, \"type\": \"VEC3\", \"min\": [-0.5, -1, -0.25], \"max\": [0, 0, 0]}},\n\
         {{\"bufferView\": 1, \"componentType\": 5123, \"count\": 6, \"type\": \"SCALAR\"}},\n\
         {{\"bufferView\": 1, \"byteOffset\": 12, \"componentType\": 5123, \"count\": 30, \"type\": \"SCALAR\"}}],\n\
         \"bufferViews\": [{{\"buffer\": 0, \"byteLength\": 96}}, {{\"buffer\": 0, \"byteOffset\": 96, \"byteLength\": 72}}],\n\
         \"buffers\": [{{\"byteLength\": {}, \"uri\": \"data:application/octet-stream;base64,{}\"}}]}}",
        data.len(),
        STANDARD.encode(&data)
    );
    text.into()
}

#[test]
fn a_box_is_the_same_in_every_format() {
    for (name, bytes) in files() {
        let [(_, mesh)] = &meshes(name, &bytes, "")[..] else { panic!("one surface") };
        assert!((volume(mesh) - VOLUME).abs() < 1e-12, "{name}: {}", volume(mesh));
        assert_eq!(area(mesh), 7.0, "{name}");
        let highest = |a: Vector, &b: &Vector| Vector::new(a.x.max(b.x), a.y.max(b.y), a.z.max(b.z));
        let [x, y, z] = SIDES;
        assert_eq!(mesh.vertices().iter().fold(Vector::default(), highest), Vector::new(x, y, z), "{name}");
    }
}

#[test]
fn data_after_what_a_file_declares_is_said() {
    let mut fewer = stl_bytes();
    fewer[80] = 10;
    let ply = |format: &str, rest: &[u8]| {
        let mut file =
            format!("ply\nformat {format} 1.0\nelement vertex 0\nproperty float x\nproperty float y\n")
                .into_bytes();
        file.extend(
            b"property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n",
        );
        file.extend(rest);
        file
    };
    let cases = [
        ("fewer.stl", fewer, "100 bytes after the 10 triangles that the file declares: ignored"),
        (
            "more.ply",
            ply("ascii", b"3 0 1 2\n\n3 0 2 1\n"),
            "2 lines after the rows that the header declares: ignored",
        ),
        (
            "bytes.ply",
            ply("binary_little_endian", &[3, 0, 0, 0, 1]),
            "5 bytes after the rows that the header declares: ignored",
        ),
    ];
    for (name, bytes, note) in cases {
        let scene = read(name, &bytes, "").unwrap_or_else(|errors| panic!("{name}: {}", shown(&errors)));
        assert_eq!(scene.notes[0], format!("{name}: {note}"));
    }
}

/// The box in each format.
pub(crate) fn files() -> [(&'static str, Vec<u8>); 11] {
    [
        ("text.stl", stl_text()),
        ("binary.stl", stl_bytes()),
        ("text2.msh", gmsh_2(false)),
        ("binary2.msh", gmsh_2(true)),
        ("text4.msh", gmsh_4(false)),
        ("binary4.msh", gmsh_4(true)),
        ("text.vtk", vtk_polygons(false)),
        ("binary.vtk", vtk_polygons(true)),
        ("grid.vtk", vtk_grid()),
        ("text.vtu", vtu()),
        ("mirrored.gltf", gltf()),
    ]
}

#[test]
fn a_group_of_faces_is_a_surface_where_this_is_asked_for() {
    let obj = |group: &str, other: &str| {
        let mut text: String = corners().iter().map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect();
        for (face, corners) in FACES.iter().enumerate() {
            let name = if face == 0 { group } else { other };
            text += &format!("{name}\nf {}\n", joined(corners.map(|corner| corner + 1)));
        }
        text.into_bytes()
    };
    let files: [(&str, Vec<u8>); 9] = [
        ("text.stl", stl_text()),
        ("text2.msh", gmsh_2(false)),
        ("binary2.msh", gmsh_2(true)),
        ("text4.msh", gmsh_4(false)),
        ("binary4.msh", gmsh_4(true)),
        ("mirrored.gltf", gltf()),
        ("groups.obj", obj("g lid", "g")),
        ("objects.obj", obj("o lid\nusemtl steel", "o rest\nusemtl steel")),
        ("materials.obj", obj("usemtl lid", "usemtl rest")),
    ];
    for (name, bytes) in files {
        let parts = meshes(name, &bytes, "split = \"group\"");
        let shown: Vec<(&str, f64)> = parts.iter().map(|(name, mesh)| (&**name, area(mesh))).collect();
        assert_eq!(shown, [("box/lid", LID), ("box/rest", 5.0)], "{name}");
    }
}

#[test]
fn a_mesh_can_be_scaled_and_moved_and_keeps_its_fronts() {
    let cases = [
        ("scale = 0.5", VOLUME / 8.0),
        ("transform = [[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0]]", VOLUME),
        ("transform = [[-1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0]]", VOLUME),
        ("scale = 2\ntransform = [[0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 3, 0], [0, 0, 0, 1]]", 24.0 * VOLUME),
    ];
    for (keys, expected) in cases {
        let [(_, mesh)] = &meshes("text.vtk", &vtk_polygons(false), keys)[..] else { panic!("one surface") };
        assert!((volume(mesh) - expected).abs() < 1e-12 * expected, "{keys}: {}", volume(mesh));
    }
}

#[test]
fn wrong_keys_of_a_mesh_are_reported() {
    let cases = [
        ("split = \"material\"", "the split `material` is unknown"),
        ("split = \"group\"", "`text.vtk` names no groups of faces"),
        ("split = \"group\"\non = \"box\"", "`text.vtk` names no groups of faces"),
        ("scale = 0", "`scale` is out of range"),
        ("transform = [[1, 0, 0, 0], [0, 1, 0, 0]]", "`transform` has 2 values"),
        ("transform = [[1, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]", "a row of `transform` has 3 values"),
        ("transform = [[1, 0, 0, 0], [2, 0, 0, 0], [0, 0, 1, 0]]", "the transform has no inverse"),
        (
            "transform = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 1]]",
            "the transform is not affine",
        ),
    ];
    for (keys, message) in cases {
        let errors = read("text.vtk", &vtk_polygons(false), keys).expect_err(message);
        assert_eq!(errors[0].message, message, "{}", shown(&errors));
    }
}
